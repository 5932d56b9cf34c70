// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/io/points.hpp"
#include "jounce/pvt/pt.hpp"
#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::detail {

/// The CSV file that the key `points` names, beside the document, with no other columns than these;
/// nothing where the key is left out. With it `rows`, which it stands for, must be.
std::optional<Points> read_point_file(TomlReader& owner, const char* rows,
                                      const std::vector<std::string>& columns);

/// Which of `words` each point has in its column "type", or the number of it; the first where there is
/// no such column.
std::vector<std::size_t> types_of(const Points& points, std::span<const std::string> words);

/// What `make` makes of the points. A complaint about "knot[3].time", whatever stands before the
/// bracket, is placed in the line of the third point (placed).
/// Points of a PT or follow table, from the table's origin; `increments` are added up. Throws InputError,
/// placed, where x does not ascend.
struct PointQuantity {
  const char* name;
  const std::string& unit;
};
std::vector<PtPoint> pt_points(const Points& points, const PointQuantity& x,
                               const PointQuantity& position, bool increments,
                               std::span<const std::string> types);

InputError placed(const InputError& error, const Points& points);
template <class Make>
auto placed_in(const Points& points, const Make& make) -> decltype(make()) {
  try {
    return make();
  } catch (const InputError& error) {
    throw placed(error, points);
  }
}

}  // namespace jounce::detail
