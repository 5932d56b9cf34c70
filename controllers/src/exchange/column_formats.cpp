// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/columns.hpp"
#include "controllers/src/exchange/formats.hpp"

namespace jounce::controllers_detail {
namespace {

std::string xyva_text(const TableFile& file) {
  return "# a cam as X Y V A, by " + made_by() + "\n" + notes_text(file, "#") + "X\tY\tV\tA\n" +
         rows_text(file, '\t', "\n");
}

}  // namespace

constinit const FormatRow xyva_format{
    .format = {.name = "xyva",
               .maker = "cam editors of CODESYS and PMC600",
               .knot = "a line `X Y V A`",
               .source = "PMC600 manual 6.2 (Fig. 6.14); CODESYS SoftMotion, cam editor",
               .extension = ".xyva",
               .join = KnotJoin::quintic,
               .keeps_notes = true},
    .detects = [](const std::string& text) { return first_cells(text).size() >= 4; },
    .read = [](const std::string& text,
               const Place& place) { return read_columns(text, place, 4); },
    .write = xyva_text};

constinit const FormatRow pairs_format{
    .format = {.name = "pairs",
               .maker = "CODESYS \"Cam Data from ASCII Table\", Lenze Cam Loader",
               .knot = "a line `X Y`",
               .source = "CODESYS \"Read Cam Data from ASCII Table\"; Lenze Cam Loader 4.2.1",
               .extension = ".txt",
               .join = KnotJoin::lines},
    .detects =
        [](const std::string& text) {
          const std::size_t cells = first_cells(text).size();
          return cells == 2 || cells == 3;
        },
    .read = [](const std::string& text,
               const Place& place) { return read_columns(text, place, 2); },
    .write = [](const TableFile& file) { return rows_text(file, '\t', "\n"); }};

}  // namespace jounce::controllers_detail
