// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace jounce::test {

/// The places of the switches of an axis, u of the machine.
struct MachineBounds {
  double start = 0;                                  ///< its place in the first line of the log
  double negative = -HUGE_VAL, positive = HUGE_VAL;  ///< limit switches: on beyond
  double home_low = NAN, home_high = NAN;  ///< the home switch is on between; infinite: to the end
  double index_period = NAN,
         index_offset = 0;  ///< an index at the offset and each period from there
  double tolerance = 0;     ///< that of the home position: a contact that bounces may add this
};

/// Configuration of an axis, as its operator would write it down. u, s.
struct Bounds {
  double velocity = 0;
  double acceleration = 0;
  std::optional<double> jerk{};
  double stop_acceleration = 0;
  double stop_jerk = 0;           ///< for an axis with a jerk limit
  double limit_acceleration = 0;  ///< at a soft limit; 0: that of a stop
  double abort_acceleration = 0;  ///< for an abort; 0: the setpoint freezes
  std::optional<double> lowest{}, highest{};
  double path_stop_time = 0;       ///< s: how long a stop on one of the axis's paths may take
  double period = 1e-3;            ///< s
  std::int64_t longest_gap = 100;  ///< ticks; a cycle that is later freezes the setpoint
  std::optional<MachineBounds> machine{};

  /// The least of the three configured ones; an order that was rejected during a fault changes
  /// nothing.
  [[nodiscard]] double gentlest_brake() const;
  [[nodiscard]] double hardest_brake() const;
};

/// An order that the axis has accepted; it took effect in one of the ticks `sent` to `answered` + 1.
struct Accepted {
  enum class What {
    moves,     ///< the axis may move from now on
    rests,     ///< it must come to rest, by `acceleration` and `jerk`
    stops,     ///< likewise by the limits of a stop, and may not move again before another order
    disables,  ///< it may not move again before another order
    places,    ///< its position gets another value
    homes,     ///< it may search for its home position
    other
  };
  What what = What::other;
  std::int64_t sent = 0;
  std::int64_t answered = 0;
  double acceleration = 0;  ///< that were asked for; 0: the axis's limit
  double jerk = 0;
  /// Ratio of a gear, which multiplies its master's jerk; infinite for a curve over its master.
  double ratio = 0;
  bool aborts = false;  ///< a stop that may freeze the setpoint
  int method = 0;       ///< a homing's, by CiA 402
  double fastest = 0;   ///< a homing's greater velocity, u/s; `acceleration` is its own
  double home = 0;      ///< a homing's: the position that home gets, u
  double timeout = 0;   ///< a homing's, s
  std::string words{};
};

/// Returns the violations in a tick log, as text, each with its tick. Reads the CSV alone, with
/// arithmetic of its own: shares no code with the axis, its planner, or the reader of logs.
///
/// - position: within the range; from outside it (set_position) never farther out;
/// - velocity, acceleration, jerk: within the limits; of a stop, of a coupling and after a fault within those of a
///   stop. A coupling adds its master's jerk, times its ratio, from `leader`, the log of the axis that it follows.
///   Position, velocity and acceleration belong together from tick to tick, also where ticks are left out;
/// - a fault that freezes the setpoint (an abort, a drive that is switched off, a cycle that is too late) leaves it at
///   its last value, at velocity 0;
/// - after a stop, a halt, a hold, a jog of 0 or a fault: at rest in the time that its limits allow; in a fault it
///   stays at rest;
/// - a homing: homing_judge.hpp. The position range does not hold in a search and until it has come to rest;
/// - disabled: nothing moves; at rest: nothing begins to move without an order.
std::vector<std::string> judged(const std::string& csv, const Bounds& bounds,
                                const std::vector<Accepted>& orders,
                                const std::string& leader = {});

}  // namespace jounce::test
