// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/columns.hpp"
#include "controllers/src/exchange/formats.hpp"

namespace jounce::controllers_detail {

constinit const FormatRow sew_format{
    .format = {.name = "sew",
               .maker = "SEW MOVI-C, curve point table",
               .knot = "a line `X;Y`, after a line with their number",
               .source = "SEW MOVI-C, curve point table",
               .extension = "",
               .join = KnotJoin::lines,
               .most = 16383,
               .limits_from = "an SEW curve point table holds no more"},
    .detects = [](const std::string& text) { return first_cells(text).size() == 1; },
    .read = [](const std::string& text,
               const Place& place) { return read_columns(text, place, 2, true); },
    .write =
        [](const TableFile& file) {
          return std::to_string(file.table.size()) + "\n" + rows_text(file, ';', "\n");
        }};

}  // namespace jounce::controllers_detail
