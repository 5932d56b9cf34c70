// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/live_compensation.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/gear/live_registration.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Homing of an axis, with the objects of CiA 402. If the comment of a member states a default for
/// 0, the value 0 stands for this default; resolved() fills in the defaults. u is the unit of the
/// axis.
struct HomingSpec {
  /// Homing method, object 6098h: 1 to 14, 17 to 30, 33, 34, 35 or 37; 37: the present position
  /// becomes the home position.
  int method = 37;
  /// Velocity of the search for a switch, u/s (6099h:1), at most the limit; 0: a tenth of the
  /// limit.
  double search_velocity = 0;
  /// Velocity of the search for the edge and the index, u/s (6099h:2), at most the limit; 0:
  /// search_velocity / 4.
  double index_velocity = 0;
  /// Acceleration, u/s^2 (609Ah), at most the limit; 0: the limit of the axis.
  double acceleration = 0;
  double offset = 0;    ///< position value of the axis at the home position, u (minus 607Ch)
  double timeout = 60;  ///< time limit of the whole homing, s, > 0
  std::optional<double> distance = {};  ///< u, > 0: greatest length of each search; omitted: no
                                        ///< limit
};

/// Configuration of an axis, fixed when the executor starts. A value of 0 switches a function off,
/// unless its comment gives another meaning. u is the unit of the axis.
struct AxisConfig {
  std::int64_t period = 1'000'000;  ///< duration of a tick, ns, > 0
  Limits limits = {};               ///< limits of the axis; velocity and acceleration are required
  /// Deceleration of a stop, u/s^2, at least 1.1 times limits.acceleration; 0: twice the limit.
  double stop_acceleration = 0;
  /// Jerk of a stop, u/s^3, at least 1.1 times limits.jerk; 0: twice the limit. Not used without a
  /// jerk limit.
  double stop_jerk = 0;
  double position = 0;  ///< initial position of the axis, u; within the position limits
  /// Number of successive ticks that, if skipped during a motion, cause the fault `stalled`; >= 1.
  /// A smaller number is no fault.
  std::int64_t longest_gap = 100;

  /// Deceleration of an abort, u/s^2; 0: the setpoint freezes at once.
  double abort_acceleration = 0;
  double limit_acceleration = 0;  ///< deceleration before a soft limit, u/s^2; 0: stop_acceleration
  double modulo = 0;              ///< length of one turn of a modulo axis, u; 0: a linear axis
  /// Limit of the following error, u; 0: none. If the error exceeds it for following_time, the axis
  /// has a fault.
  double following_error = 0;
  double following_time = 0;  ///< s; see following_error
  /// Window of the following error, u; 0: the axis is never in position. The axis is in position if
  /// it is at standstill and the error stays in the window for in_position_time.
  double in_position = 0;
  double in_position_time = 0;  ///< s; see in_position

  HomingSpec homing = {};     ///< homing that the command Home uses
  bool require_home = false;  ///< reject motions to absolute positions until the axis is homed

  /// Registration of every motion that follows the live master, except a plan of cuts; nullopt:
  /// none.
  std::optional<LiveRegistrationSpec> registration = {};
  /// Correction table that the command EnableCompensation switches on; nullopt: none.
  std::optional<AxisCompensation> compensation = {};
};

/// Converts ns to s. Compute the duration of n ticks as seconds(n * period), so that rounding
/// errors do not accumulate.
inline double seconds(std::int64_t ns) noexcept {
  return static_cast<double>(ns) / 1e9;
}

/// Returns the rejection position_limit for a home position outside the position range, because the
/// axis would stand there after its homing; otherwise nullopt. On a limit switch (methods 1, 2, 17
/// and 18), the home position may be beyond the range on the side of this switch.
std::optional<Refusal> misplaced_home(const HomingSpec& spec, const Limits& limits);

/// Returns the configuration with the defaults filled in. Throws InputError for a value out of
/// range.
AxisConfig resolved(AxisConfig config);

}  // namespace jounce
