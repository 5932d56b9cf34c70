// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "jounce/path/axis_map.hpp"
#include "jounce/path/point.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Reason why a straight line ends.
enum class LineEnd : std::uint8_t {
  length,        ///< the line has the requested length
  joint_limit,   ///< a joint reaches the end of its position range
  out_of_reach,  ///< no position of the joints moves the tool farther
  singular,      ///< the joints permit too small a velocity of the tool
};

/// The part of a straight line that a machine can pass.
struct Reach {
  double length = 0;  ///< distance from its start, u
  LineEnd end = LineEnd::length;
  std::size_t joint = 0;  ///< for joint_limit and singular: index of the joint that determines the
                          ///< end
  double limit = 0;       ///< for joint_limit: end of the position range of this joint
};

/// A line ends with LineEnd::singular where a joint limits the velocity of the tool to this share
/// of the velocity of the motion.
inline constexpr double singular_margin = 0.01;

/// Returns how far the tool can move along the straight line from `from` in the direction
/// `direction` (one component for each axis of the map, a vector of length 1), at most `length`.
/// `joints`: limits of the joints, with their position ranges. `from` must be a place that the
/// joints can reach. `velocity`: velocity of the motion along the line, u/s; infinite: the velocity
/// that the joints permit at the start. If a joint limits the velocity to less than this already at
/// the start, the line may still lead away from the singular position.
///
/// If the map proves bounds (AxisMap::bounds()), no joint leaves its range anywhere on this part.
/// Otherwise, samples are checked.
Reach reach(const AxisMap& map, std::span<const Limits> joints, const Point& from,
            const Point& direction, double length, double velocity);

}  // namespace jounce
