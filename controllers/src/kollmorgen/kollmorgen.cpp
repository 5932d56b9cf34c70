// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/columns.hpp"
#include "controllers/src/exchange/formats.hpp"

namespace jounce::controllers_detail {
namespace {

std::string kas_text(const TableFile& file) {
  const bool cyclic = repeats(file.table.outside());
  return std::string("CYCLIC;") + (cyclic ? "YES" : "NO") + ";\nTABLE_BEGIN;;\n" +
         rows_text(file, ';', ";SPLINE\n") + "TABLE_END;;\n";
}

}  // namespace

constinit const FormatRow kollmorgen_format{
    .format = {.name = "kollmorgen",
               .maker = "Kollmorgen KAS, cam profile",
               .knot = "a line `X;Y;SPLINE` between TABLE_BEGIN and TABLE_END",
               .source = "KAS, Import Cam Profile",
               .extension = "",
               .join = KnotJoin::spline,
               .readable = false,
               .states_period = true,
               .fewest = 5,
               .limits_from = "KAS imports four segments or more"},
    .detects = [](const std::string& text) { return text.find("TABLE_BEGIN") != text.npos; },
    .read = nullptr,
    .write = kas_text,
    .unreadable = "is a KAS table: Kollmorgen does not document its splines, so it cannot be read"};

}  // namespace jounce::controllers_detail
