// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/controllers/exchange/cam_format.hpp"
#include "jounce/io/table_file.hpp"

namespace jounce {

/// Cam tables in the text formats of other makers' tools.
///
///     TableFile cam = parse_exchange(read_file("cam.xyva"), "cam.xyva");
///     write_file("cam.st", exchange_text(*cam_format_named("codesys"), cam));
///     cam.units = {"deg", "mm"};                         // if the file has none
///
/// V is dY/dX and A is d2Y/dX2, as in a Table. Numbers are written in the shortest form that reads
/// back the same, so a format keeps every value to the last bit (a REAL: to its 24 bits).
///
/// **Data outside a format** (units, the policy outside, the number of knots, the hash) is written
/// as comments and read again if the format has comments (`keeps_notes`): a file of Jounce is
/// restored exactly, and a truncated or changed one is rejected. A foreign file without such
/// comments has empty units and holds outside: whether a cam is periodic is defined at its
/// selection (MC_CamTableSelect), not in its table.

/// Throws InputError for a table over time: the formats are for cams.
void require_cam(const CamFormat& format, const Table& table);

/// The table in another maker's format. Throws InputError for a table over time, for another rule
/// than the format's, and for too few or too many knots.
std::string exchange_text(const CamFormat& format, const TableFile& file);

struct ExchangeCam {
  std::string name;  ///< name of its reference, its array or its tag; empty in the other formats
  TableFile file;
  std::vector<std::string> unread = {};  ///< other content of the file: a phrase for each
};

/// Reads each format that is readable. Throws InputError with file, line, key, value and rule: a
/// wrong number of columns, text that is not a finite number (a decimal comma is named as such),
/// knots that do not ascend, a number of knots or a hash that does not match, a format that cannot
/// be read. `decimal_comma` reads 0,5 as 0.5 in columns that are not separated by commas. A
/// declaration may hold several cams: all of them, in the order of their references.
std::vector<ExchangeCam> parse_exchange_cams(const std::string& text, const std::string& name,
                                             bool decimal_comma = false);

/// The only cam of the file. Also throws InputError if there are several.
TableFile parse_exchange(const std::string& text, const std::string& name,
                         bool decimal_comma = false);

}  // namespace jounce
