// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/io/table_file.hpp"

namespace jounce {

/// Cam tables in the text formats of other makers' tools.
///
///     TableFile cam = parse_exchange(read_file("cam.xyva"), "cam.xyva");
///     write_file("cam.st", exchange_text(Format::codesys, cam));
///     const auto format = format_of_path("cam.st");      // Format::codesys
///     cam.units = {"deg", "mm"};                         // if the file has none
///
/// | format | file | a knot is | rule | read |
/// |---|---|---|---|---|
/// | `xyva` | .xyva | a line X Y V A: the columns of the cam editors of CODESYS and PMC600 | quintic_hermite | yes |
/// | `codesys` | .st | an SMC_CAMXYVA in Structured Text, also "Display generated code" | quintic_hermite | yes |
/// | `pairs` | .txt | a line X Y: CODESYS "Cam Data from ASCII Table", Lenze, ISG | linear | yes |
/// | `sew` | | a line X;Y after a line with their number: SEW MOVI-C curve point table | linear | yes |
/// | `kollmorgen` | | a line X;Y;SPLINE between TABLE_BEGIN and TABLE_END: KAS | linear | no |
///
/// V is dY/dX and A is d2Y/dX2, as in a Table. Numbers are written in the shortest form that reads
/// back the same, so the format keeps every value to the last bit.
///
/// **Data outside a format** (units, the policy outside, the number of knots, the hash) is written
/// as comments and read again: a file of Jounce is restored exactly, and a truncated or changed one
/// is refused. Formats without comments (`pairs`, `sew`, `kollmorgen`) lose it. A foreign file
/// without such comments has empty units and holds outside: whether a cam is periodic is defined at
/// its selection (MC_CamTableSelect), not in its table.
enum class Format { xyva, codesys, pairs, sew, kollmorgen };

/// "xyva", "codesys", ...: the words of the command line; and back, or nothing.
const char* name(Format format);
std::optional<Format> format_named(const std::string& word);
std::vector<std::string> format_names();

/// By the end of the path: .xyva, .st, .txt; nothing for any other.
std::optional<Format> format_of_path(const std::string& path);

/// Content of the knots of the format: the rule that a table needs to be written in it.
Interpolation rule_of(Format format);

/// By the content, or nothing for other text, such as a spec or a table of Jounce in CSV or JSON
/// (see is_table).
std::optional<Format> format_of_text(const std::string& text);

/// The table in another maker's format. Throws InputError for a table over time, for another rule
/// than the format's, and for too few knots (KAS needs five).
std::string exchange_text(Format format, const TableFile& file);

/// Reads each format marked as read. Throws InputError with file, line, key, value and rule: a
/// wrong number of columns, text that is not a finite number (a decimal comma is named as such),
/// knots that do not ascend, a number of knots or a hash that does not match, a format that cannot
/// be read. `decimal_comma` reads 0,5 as 0.5 in columns that are not separated by commas. A
/// declaration may hold several cams: all of them, in the order of their references.
struct ExchangeCam {
  std::string name;  ///< name of its MC_CAM_REF, or of its array; empty in the other formats
  TableFile file;
  std::vector<std::string> unread = {};  ///< other content of the file: a phrase for each
};
std::vector<ExchangeCam> parse_exchange_cams(const std::string& text, const std::string& name,
                                             bool decimal_comma = false);

/// The only cam of the file. Also throws InputError if there are several.
TableFile parse_exchange(const std::string& text, const std::string& name,
                         bool decimal_comma = false);

}  // namespace jounce
