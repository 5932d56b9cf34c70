// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Homing of an axis, after CiA 402. A value of 0 means the default, which resolved() fills in.
struct HomingSpec {
  int method = 37;             ///< 6098h; 35, 37: the present position
  double search_velocity = 0;  ///< u/s, 6099h:1; 0: a tenth of the axis's limit
  double index_velocity = 0;   ///< u/s, 6099h:2, of edge and index; 0: a quarter of search_velocity
  double acceleration = 0;     ///< u/s^2, 609Ah; 0: the limit of the axis
  double offset = 0;           ///< u, 607Ch: the new position of the home position
  double timeout = 60;         ///< s, of the whole homing, > 0
  std::optional<double> distance = {};  ///< u, > 0: limit of each search
};

/// Configuration of an axis, fixed when the executor starts. A value of 0 means off, unless noted
/// otherwise.
struct AxisConfig {
  std::int64_t period = 1'000'000;  ///< period of the tick, ns, > 0
  Limits limits = {};               ///< velocity and acceleration are required
  double stop_acceleration = 0;     ///< u/s^2, > limits.acceleration; 0: twice that
  double stop_jerk = 0;             ///< u/s^3, > limits.jerk; 0: twice that; unused without one
  double position = 0;              ///< u; initial position of the axis
  std::int64_t longest_gap = 100;   ///< ticks; a fault if a cycle in motion is later than this

  double abort_acceleration = 0;  ///< u/s^2 of an abort; 0: the setpoint freezes at once
  double limit_acceleration = 0;  ///< u/s^2 before a soft limit; 0: stop_acceleration
  double modulo = 0;              ///< u of a turn; 0: a linear axis
  double following_error = 0;     ///< u; more than this for following_time: a fault
  double following_time = 0;      ///< s
  double in_position = 0;         ///< u; within this for in_position_time: in position
  double in_position_time = 0;    ///< s

  HomingSpec homing = {};
  bool require_home = false;  ///< reject motions to absolute positions before homing
};

/// A duration in ns, in s. The duration of n ticks is seconds(n * period): nothing accumulates.
inline double seconds(std::int64_t ns) noexcept {
  return static_cast<double>(ns) / 1e9;
}

/// Returns the configuration with the defaults filled in. Throws InputError for a value out of
/// range.
AxisConfig resolved(AxisConfig config);

}  // namespace jounce
