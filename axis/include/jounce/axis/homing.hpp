// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/command/cause.hpp"

namespace jounce {

/// Search criteria of one of CiA 402's homing methods (object 6098h).
struct HomingMethod {
  Sensor Sensors::*sensor = nullptr;  ///< switch to search for; null: the index alone, or none
  int search = 0;                     ///< -1, 1: first direction of the search for the switch
  bool leaves = false;  ///< home is where the switch goes off; otherwise where it goes on
  int last = 0;         ///< direction in which home is passed; 0: home is the present position
  bool index = false;   ///< home is the first index after the edge, in that direction
};

/// Returns the method with this number; nullopt if CiA 402 defines none. 1 to 14: with the index,
/// 17 to 30: the same without it, 33 and 34: the next index, 35 and 37: the present position.
std::optional<HomingMethod> homing_method(int number) noexcept;

/// True if the machine has the switch and the index that the method needs.
bool has_sensors(const HomingMethod& method, const Sensors& sensors) noexcept;

/// The search for a machine's home position: computes the next velocity of an axis from the inputs
/// of its drive in each cycle. Positions are in u, in the drive's coordinate.
///
///     Homing homing(*homing_method(23), spec, sensors);
///     homing.step({sensors, position, at_rest, dt});       // each cycle
///     go(homing.velocity());                               // within the axis's limits; 0: to rest
///     if (homing.done()) rename(homing.home());
///
/// 1. It searches for the switch with search_velocity, and reverses once at a limit switch.
/// 2. It goes to the side of the edge from which the method passes it: with index_velocity onto the
///    switch, with search_velocity off it.
/// 3. It passes the edge, and then the index, with index_velocity, and comes to rest.
///
/// It reverses only at rest, after the switch was stable for `settle`: contacts may bounce.
class Homing {
 public:
  static constexpr double settle = 0.01;  ///< s

  /// Inputs of one cycle.
  struct Seen {
    Sensors sensors = {};
    double position = 0;   ///< actual, u
    bool at_rest = false;  ///< the setpoint is at rest, as velocity() = 0 demands
    double dt = 0;         ///< s since the cycle before
  };

  /// `method` must be one that moves; `spec` must come from resolved().
  Homing(const HomingMethod& method, const HomingSpec& spec, const Seen& now) noexcept;

  void step(const Seen& now) noexcept;

  [[nodiscard]] double velocity() const noexcept { return velocity_; }  ///< u/s, signed
  [[nodiscard]] bool done() const noexcept { return phase_ == Phase::done; }
  [[nodiscard]] double home() const noexcept { return home_; }  ///< u; valid after the edge
  [[nodiscard]] double offset() const noexcept { return spec_.offset; }  ///< u: position of home
  /// The fault that ended the search: home_timeout, home_not_found, index_not_found, both_switches,
  /// positive_switch, negative_switch; none: it continues.
  [[nodiscard]] Cause cause() const noexcept { return cause_; }

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
  double quiet_ = settle;         // s since the switch changed
  double from_ = 0;               // u: start of the present motion
  double position_ = 0;           // u: of the previous cycle
  int heading_ = 0;               // direction of the last motion
  bool on_ = false;               // state of the switch in the previous cycle
  std::optional<double> change_;  // u: position of the switch's change in this cycle
  std::optional<int> side_;  // side of the switch: -1 below, 0 on it, 1 above; nullopt: unknown
  bool turned_ = false;      // it has reversed at a limit switch
};

}  // namespace jounce
