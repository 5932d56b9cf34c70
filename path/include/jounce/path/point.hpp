// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace jounce {

/// Most axes of a group (HIMC: 9).
inline constexpr std::size_t max_axes = 9;

/// Coordinates of a group, one an axis, in the axes' units; those beyond the group's axes are 0.
using Point = std::array<double, max_axes>;

}  // namespace jounce
