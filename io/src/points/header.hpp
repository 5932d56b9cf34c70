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
/// Windows-1252 are accepted, too, and so are brackets around the unit. Returns "" if the text is not a unit.
std::string unit_of(std::string_view text);

/// The rule of an unknown unit in a line of units.
inline constexpr const char* unknown_unit =
    "is not a known unit: write one such as mm, deg, s or mm/s, or delete the column if the table "
    "does not need it";

/// True if a cell begins with a digit, a sign or a separator of decimals.
inline bool may_be_number(std::string_view cell) {
  return !cell.empty() && std::string_view("0123456789+-.,").find(cell.front()) != cell.npos;
}

/// True if no cell is a number and at least one is a unit: the second line of a header. Other cells
/// may be unknown units.
template <class Cells>
bool are_units(const Cells& cells) {
  bool any = false;
  for (const std::string_view cell : cells) {
    if (may_be_number(cell)) return false;
    any = any || !unit_of(cell).empty();
  }
  return any;
}

}  // namespace jounce::io_detail
