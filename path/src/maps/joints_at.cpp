// SPDX-License-Identifier: Apache-2.0
#include "path/src/maps/joints_at.hpp"

#include <cmath>
#include <span>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::path_detail {

std::string text_of(const Jets& jets, std::size_t n) {
  std::string text = "(";
  for (std::size_t i = 0; i < n; ++i) text += (i > 0 ? ", " : "") + six_digits(jets[i][0]);
  return text + ")";
}

MapState joints_at(const AxisMap& map, const Jets& point, Jets& joint) {
  const MapState state =
      map.jets(std::span(point).first(map.axes()), std::span(joint).first(map.joints()));
  if (state != MapState::ok) return state;
  for (std::size_t j = 0; j < map.joints(); ++j)
    if (!std::isfinite(joint[j][0]))
      throw InputError("map", text_of(point, map.axes()),
                       "is a point at which jets() returns MapState::ok, but joint " +
                           std::to_string(j + 1) + " is not finite: return another state there");
  return state;
}

}  // namespace jounce::path_detail
