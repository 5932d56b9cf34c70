// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/cause.hpp"
#include "jounce/axis/inputs.hpp"

namespace jounce {

/// One of CiA 402's homing methods (object 6098h) as what it searches for.
struct HomingMethod {
  Sensor Sensors::*sensor = nullptr;  ///< whose edge; null: the index alone, or nothing
  int search = 0;       ///< -1, 1: the direction in which the search for the switch begins
  bool leaves = false;  ///< home is where the switch goes off; otherwise where it goes on
  int last = 0;         ///< the direction in which home is passed; 0: home is where the axis stands
  bool index = false;   ///< home is the first index from the edge on, in that direction
};

/// The method of a number; nothing where CiA 402 has none. 1 to 14: with the index, 17 to 30: the same
/// without it, 33 and 34: the next index, 35 and 37: where the axis stands.
std::optional<HomingMethod> homing_method(int number) noexcept;

/// True if the machine has the switch and the index that the method needs.
bool has_sensors(const HomingMethod& method, const Sensors& sensors) noexcept;

/// The search for a machine's home position: which velocity an axis shall have next, from what its
/// drive reports in each cycle. Positions are in u, as the drive counts.
///
///     Homing homing(*homing_method(23), spec, sensors);
///     homing.step({sensors, position, at_rest, dt});        // each cycle
///     go(homing.velocity());                                // within the axis's limits; 0: to rest
///     if (homing.done()) rename(homing.home());
///
/// 1. It searches for the switch with search_velocity, and turns round once at a limit switch.
/// 2. It goes to the side of the edge from which the method passes it: with index_velocity onto the
///    switch, with search_velocity off it.
/// 3. It passes the edge, and then the index, with index_velocity, and comes to rest.
///
/// It turns round only at rest, when the switch has not changed for `settle`: contacts may bounce.
class Homing {
 public:
  static constexpr double settle = 0.01;  ///< s

  /// Inputs of one cycle.
  struct Seen {
    Sensors sensors = {};
    double position = 0;   ///< actual, u
    bool at_rest = false;  ///< the setpoint stands, as velocity() = 0 demands
    double dt = 0;         ///< s since the cycle before
  };

  /// A method that moves; `spec` as resolved() leaves it.
  Homing(const HomingMethod& method, const HomingSpec& spec, const Seen& now) noexcept;

  void step(const Seen& now) noexcept;

  [[nodiscard]] double velocity() const noexcept { return velocity_; }  ///< u/s, signed
  [[nodiscard]] bool done() const noexcept { return phase_ == Phase::done; }
  [[nodiscard]] double home() const noexcept { return home_; }  ///< u; once the edge was passed
  /// The fault that ends the search: home_timeout, home_not_found, index_not_found, both_switches,
  /// positive_switch, negative_switch; none: it goes on.
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
  double from_ = 0;               // u: where the present motion began
  double position_ = 0;           // u: of the cycle before
  int heading_ = 0;               // the direction of the last way
  bool on_ = false;               // the switch, in the cycle before
  std::optional<double> change_;  // u: where the switch changed in this cycle
  std::optional<int> side_;  // side of the switch: -1 below, 0 on it, 1 above; nothing: not known
  bool turned_ = false;      // round, at a limit switch
};

}  // namespace jounce
