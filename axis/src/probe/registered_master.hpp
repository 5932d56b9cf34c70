// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/gear/live_registration.hpp"
#include "jounce/profiles/curve/jet.hpp"

#include "axis/src/probe/position_history.hpp"

namespace jounce {

/// The live master of an axis: its positions in the last ticks, and the registration that corrects it
/// or its slave.
///
///     RegisteredMaster master(config);
///     master.see(dt, inputs.master);                                    // once a tick
///     inputs.master = master.corrected(inputs.master, triggers, follows);
///     master.correct_slave(next.slave, follows);
///     master.end_tick(inputs.master, follows);
///
/// Always true: last() differs from the present master only by the motion of the master. It has the
/// present coordinate, and it includes the correction only if a registered motion goes on. So neither a
/// new coordinate nor the end of a correction looks like a motion.
///
/// `follows` is true if the axis plays a motion that the registration may correct: one that follows the
/// live master and is no plan of cuts, whose cutter must stay in step with the web. Unit m: the unit of
/// the master.
class RegisteredMaster {
 public:
  explicit RegisteredMaster(const AxisConfig& config);

  /// The coordinate of the master has changed by this distance, m.
  void shift(double by) noexcept;
  /// Adds the master of this tick to the history. `dt`: s since the previous tick.
  void see(double dt, const Jet& master) noexcept;
  /// Steps the registration with the marks of this tick. Returns the master, with the correction if
  /// the registration corrects the master.
  Jet corrected(const Jet& master, const Triggers& triggers, bool follows) noexcept;
  /// A registered motion begins: the correction begins at 0, at this position of the master, m.
  void begin(double master) noexcept;
  /// Ends the tick. `master`: as corrected() has returned it.
  void end_tick(const Jet& master, bool follows) noexcept;

  /// True if the registration corrects the motion.
  [[nodiscard]] bool registers(bool follows) const noexcept { return follows && registration_; }
  /// Adds the correction to the setpoint of the slave, if the registration corrects the slave.
  void correct_slave(Jet& slave, bool follows) const noexcept;
  /// True if the marks are lost, and the loss is a fault.
  [[nodiscard]] bool fails(bool follows) const noexcept;
  /// The master of the previous tick.
  [[nodiscard]] const Jet& last() const noexcept { return last_; }
  /// The positions of the last ticks, without the correction.
  [[nodiscard]] const PositionHistory& history() const noexcept { return history_; }
  /// State of the registration in the last tick in which it corrected a motion.
  [[nodiscard]] const RegistrationReading& reading() const noexcept { return reading_; }

 private:
  std::int64_t period_;  // ns
  PositionHistory history_;
  std::optional<LiveRegistration> registration_;
  RegistrationReading reading_;
  Jet phase_{};                 // correction that the master of this tick includes
  Jet last_ = Inputs{}.master;  // m
};

}  // namespace jounce
