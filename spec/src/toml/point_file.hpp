// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/io/points.hpp"
#include "jounce/pvt/pt.hpp"
#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::spec_detail {

/// Reads the CSV file that the key `points` names, relative to the document, with these columns
/// only. Returns nullopt if the key is left out. Throws InputError if `rows`, which the file
/// replaces, is given too.
std::optional<Points> read_point_file(TomlReader& owner, const char* rows,
                                      const std::vector<std::string>& columns);

/// The index in `words` of the column "type" of each point, given as a word or as a number; 0
/// without such a column.
std::vector<std::size_t> types_of(const Points& points, std::span<const std::string> words);

/// A column, and the unit of its numbers in the spec.
struct PointQuantity {
  const char* name;
  const std::string& unit;
};

/// Throws InputError with the place and the numbers of the file if x does not ascend.
void require_ascending(const Points& points, const PointQuantity& x);

/// Points of a PT or follow table count from the origin of the table; `increments` are summed.
/// Throws InputError with the place if x does not ascend.
std::vector<PtPoint> pt_points(const Points& points, const PointQuantity& x,
                               const PointQuantity& position, bool increments,
                               std::span<const std::string> types);

/// Unit of the numbers of each column.
using ColumnUnits = std::map<std::string, std::string>;

/// Returns the error for "knot[3].time", with any word before the bracket, with the line of the
/// third point and the units of its numbers.
InputError placed(const InputError& error, const Points& points, const ColumnUnits& units);

/// Returns the result of `make`. Its errors are placed().
template <class Make>
auto placed_in(const Points& points, const ColumnUnits& units, const Make& make)
    -> decltype(make()) {
  try {
    return make();
  } catch (const InputError& error) {
    throw placed(error, points, units);
  }
}

}  // namespace jounce::spec_detail
