// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "jounce/cam/switches/cam_switches.hpp"
#include "jounce/pvt/live_plane_compare.hpp"
#include "jounce/pvt/position_compare.hpp"

namespace jounce {

/// The position compare of an axis: one list of positions. The list starts again with each motion
/// that begins from rest.
struct AxisCompare {
  /// The compared position: `position` (of the setpoint) or `actual`.
  SwitchesOf of = SwitchesOf::position;
  std::optional<PositionCompare> list = {};  ///< the list; nullopt: no position compare
  /// For a group: position compare of two of its axes; nullopt: none. Its outputs are in
  /// Tick::switches, so such a group has no cam switches.
  std::optional<PlaneCompare> plane = {};
  /// Places of these two axes in the group, from 0.
  std::array<std::size_t, 2> plane_axes = {0, 1};
};

}  // namespace jounce
