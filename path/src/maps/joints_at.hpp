// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "jounce/path/axis_map.hpp"

namespace jounce::path_detail {

using Jets = std::array<Jet, max_axes>;

/// Returns the values of the first n jets as a text: "(10, 20)".
std::string text_of(const Jets& jets, std::size_t n);

/// Calls map.jets(). Throws InputError("map", ...) if the result is MapState::ok but the position of
/// a joint is not finite. Near a singular position, derivatives may overflow.
MapState joints_at(const AxisMap& map, const Jets& point, Jets& joint);

}  // namespace jounce::path_detail
