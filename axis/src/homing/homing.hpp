// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/detail/homing_method.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/command/cause.hpp"

namespace jounce {

/// The search for the home position of a machine. Call step() once in each cycle: it computes the
/// next velocity of the axis from the inputs of the drive. Positions are in u, the unit of the
/// axis, in the coordinate of the drive.
///
///     Homing homing(*homing_method(23), spec, sensors);
///     homing.step({sensors, position, at_rest, dt});       // each cycle
///     go(homing.velocity());                               // within the axis's limits; 0: to rest
///     if (homing.done()) rename(homing.home());
///
/// 1. The axis searches for the switch with search_velocity. At a limit switch it reverses, once
///    only.
/// 2. The axis moves to the side of the edge from which the method passes home: with index_velocity
///    onto the switch, or with search_velocity off the switch.
/// 3. The axis passes the edge with index_velocity, then the index if the method uses one, and
///    comes to rest.
///
/// The axis reverses only at rest, and only when the switch has been stable for the time `settle`,
/// because contacts may bounce.
class Homing {
 public:
  static constexpr double settle = 0.01;  ///< s; see above

  /// Inputs of one cycle.
  struct Seen {
    Sensors sensors = {};  ///< states of the sensors
    double position = 0;   ///< actual position, u
    bool at_rest = false;  ///< true if the setpoint has come to rest, as velocity() = 0 requests
    double dt = 0;         ///< time since the previous cycle, s
  };

  /// Requires a method with a motion (last != 0), and a spec from resolved(). `now` has the inputs
  /// of the present cycle.
  Homing(const HomingMethod& method, const HomingSpec& spec, const Seen& now) noexcept;

  /// Computes one cycle. Call once in each cycle.
  void step(const Seen& now) noexcept;

  /// Requested velocity, u/s, signed.
  [[nodiscard]] double velocity() const noexcept { return velocity_; }
  /// True if the search has ended with success.
  [[nodiscard]] bool done() const noexcept { return phase_ == Phase::done; }
  /// Home position, u, in the coordinate of the drive; NaN before the edge.
  [[nodiscard]] double home() const noexcept { return home_; }
  /// HomingSpec::offset, u: the position value of the axis at home.
  [[nodiscard]] double offset() const noexcept { return spec_.offset; }
  /// The fault that ended the search: home_timeout, home_not_found, search_distance,
  /// index_not_found, both_switches, positive_switch or negative_switch. none: no fault.
  [[nodiscard]] Cause cause() const noexcept { return cause_; }
  /// The limit that the search exceeded: the timeout, s, or the distance, u; NaN: another fault.
  [[nodiscard]] double exceeded() const noexcept;

 private:
  enum class Phase : std::uint8_t { seek, place, edge, index, last, done };

  void observe(const Seen& now) noexcept;
  [[nodiscard]] Cause check(const Seen& now) const noexcept;
  [[nodiscard]] Cause limit_ahead(const Sensors& sensors, double velocity) const noexcept;
  void proceed(const Seen& now) noexcept;
  void move(const Seen& now) noexcept;
  void begin(Phase phase, double velocity, const Seen& now) noexcept;
  void turn_round() noexcept;
  void find(double position) noexcept;
  [[nodiscard]] int wanted_side() const noexcept { return method_.leaves ? 0 : -method_.last; }

  HomingMethod method_;
  HomingSpec spec_;
  Phase phase_ = Phase::seek;
  Cause cause_ = Cause::none;
  double velocity_ = 0;
  double home_ = std::numeric_limits<double>::quiet_NaN();
  double elapsed_ = 0;            // s
  double quiet_ = settle;         // time since the last change of the switch, s
  double from_ = 0;               // start of the present motion, u
  double position_ = 0;           // position in the previous cycle, u
  int heading_ = 0;               // direction of the last motion
  bool on_ = false;               // state of the switch in the previous cycle
  std::optional<double> change_;  // position of a change of the switch in this cycle, u
  std::optional<int> side_;  // side of the switch: -1 below, 0 on it, 1 above; nullopt: unknown
  bool turned_ = false;      // true after a reversal at a limit switch
};

}  // namespace jounce
