// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/controllers/exchange/exchange_format.hpp"
#include "jounce/io/table_file.hpp"

namespace jounce {

/// Tables of cams and of motions over time, in the text formats of other makers' tools.
///
///     TableFile cam = parse_exchange(read_file("cam.xyva"), "cam.xyva");
///     write_file("cam.st", exchange_text(*exchange_format_named("codesys"), cam));
///     cam.units = {"deg", "mm"};                         // if the file has none
///
/// V is dY/dX and A is d2Y/dX2, as in a Table. Numbers are written in their shortest exact form, so
/// reading the file restores every value exactly (a REAL: to its 24 bits).
///
/// **Comments.** Most formats have no place for the units, the policy outside, the number of knots
/// and the hash. If a format permits comments (`keeps_notes`), these data are written as comments.
/// The reader restores the table exactly from these comments, and rejects a truncated or changed
/// file. A file from another tool has no such comments: its units are empty, and its policy outside
/// is `hold`. Such a file does not state whether the cam is periodic, because a controller defines
/// this when it selects the table (MC_CamTableSelect).

/// Throws InputError for a table over time if the format is for cams, and for a cam if the format
/// is for motions over time.
void require_axis(const ExchangeFormat& format, const Table& table);

/// Returns the text of the table in the format. Throws InputError like require_axis(); for an
/// interpolation rule that the format does not have; for too few or too many knots; and, if the
/// format is only for motions that begin and end at rest, for any other motion. For a format in
/// counts, the numbers of the table must already be in counts.
std::string exchange_text(const ExchangeFormat& format, const TableFile& file);

/// One table of a file.
struct ExchangeTable {
  std::string name = {};  ///< name of its reference, array, tag, joint or axis; "" if it has none
  TableFile file;         ///< the table, with its units and provenance
  std::vector<std::string> unread = {};  ///< one phrase for each part of the file that was not read
};

/// Reads a text in any readable format. The text may contain several tables. They are returned in
/// the order in which the file declares them (CODESYS: in the order of the MC_CAM_REF, then the
/// arrays without an MC_CAM_REF). `name` is the name of the file for errors; its ending may select
/// the format. If `decimal_comma` is true, 0,5 is read as 0.5, unless commas separate the columns.
///
/// Throws InputError with file, line, key, value and rule for a wrong number of columns; for text
/// that is not a finite number (if the cause is a decimal comma, the error states this); for knots
/// that do not ascend; for a number of knots or a hash that does not match; and for a format that
/// cannot be read.
std::vector<ExchangeTable> parse_exchange_tables(const std::string& text, const std::string& name,
                                                 bool decimal_comma = false);

/// Reads a file that contains exactly one table. Throws like parse_exchange_tables(), and if the
/// file contains several tables.
TableFile parse_exchange(const std::string& text, const std::string& name,
                         bool decimal_comma = false);

}  // namespace jounce
