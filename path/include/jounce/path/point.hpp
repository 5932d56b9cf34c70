// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace jounce {

/// Greatest number of axes of a group (as in HIMC).
inline constexpr std::size_t max_axes = 9;

/// Coordinates of a group, one for each axis, in the units of the axes; entries beyond the group's
/// axes are 0.
using Point = std::array<double, max_axes>;

}  // namespace jounce
