// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "jounce/io/points.hpp"

/// Headers of points: the names of columns and their units, as spreadsheets and measuring devices
/// write them.
namespace jounce::io_detail {

std::string_view trimmed(std::string_view text);
/// Returns a cell without the quotes around it.
std::string_view unquoted(std::string_view cell);

/// Returns a cell of a header as a column: "Position [mm]", "Zeit (ms)", "Weg / mm", "time in s".
/// Text in brackets must be a unit; text in parentheses, after " / " and after " in " is part of
/// the name if it is not a unit. Throws InputError without a place if the cell is not a name.
PointColumn column_of(std::string_view cell);

/// True if the column has words, such as "normal", and not numbers.
bool has_words(const PointColumn& column);

/// Returns the unit as units.hpp writes it: "µm" is um, "°/s" is deg/s, "mm/s²" is mm/s^2. Signs in
/// Windows-1252 are accepted, too. Returns "" if the text is not a unit.
std::string unit_of(std::string_view text);

/// True if the cells are units or empty, at least one of them a unit: the second line of a header.
template <class Cells>
bool are_units(const Cells& cells) {
  bool any = false;
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;
    if (unit_of(cell).empty()) return false;
    any = true;
  }
  return any;
}

}  // namespace jounce::io_detail
