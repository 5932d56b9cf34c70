// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "jounce/drive/drive.hpp"
#include "jounce/validate/machine_sensors.hpp"

namespace jounce {

/// A switch of a simulated machine, computed cycle by cycle. u is the unit of the axis.
class SimulatedSwitch {
 public:
  /// Throws InputError with the key "position", "width" or "bounce" for an invalid value.
  explicit SimulatedSwitch(const MachineSwitch& spec);

  /// Computes one cycle of `dt` s, in which the machine moves linearly between two positions, u.
  /// Sensor::edge is the exact position of the first change; a change by a bounce is latched at the
  /// end of its cycle.
  Sensor step(double from, double to, double dt) noexcept;

 private:
  [[nodiscard]] bool at(double position) const noexcept;

  MachineSwitch spec_;
  double bouncing_ = 0;   // s left
  bool flipped_ = false;  // inverted by a bounce
};

/// Returns the position of the first index pulse between two positions, u; NaN if there is no
/// pulse.
double index_between(const MachineIndex& index, double from, double to) noexcept;

/// A drive on a simulated machine with switches and an index. It reports them as a real drive does:
/// the states of the switches, and the positions that the encoder latched at their edges.
///
///     DriveOnMachine drive(servo, {.home = MachineSwitch{.position = 0, .width = 12}}, 0.001);
///     drive.feedback().sensors.home.on;
///
/// The switches respond to the position of the motor. The encoder latches without delay or
/// rounding.
class DriveOnMachine final : public AxisDrive {
 public:
  /// `drive`: the drive of the axis. `period`: duration of the cycle, s. Throws InputError with the
  /// key of [drive] for an invalid value: "machine.home_switch.width", ...
  DriveOnMachine(std::shared_ptr<AxisDrive> drive, const MachineSensorsSpec& spec, double period);

  void command(const DriveSetpoint& setpoint) noexcept override { drive_->command(setpoint); }
  [[nodiscard]] Feedback feedback() noexcept override;

 private:
  [[nodiscard]] Sensor latched(std::optional<SimulatedSwitch>& of, double from, double to) noexcept;

  std::shared_ptr<AxisDrive> drive_;
  MachineSensorsSpec spec_;
  double period_;
  std::optional<SimulatedSwitch> home_, negative_, positive_;
  std::optional<double> last_;  // u, of the machine
};

}  // namespace jounce
