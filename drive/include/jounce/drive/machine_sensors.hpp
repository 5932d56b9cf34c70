// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "jounce/drive/drive.hpp"
#include "jounce/validate/machine_sensors.hpp"

namespace jounce {

/// A switch, cycle by cycle.
class SimulatedSwitch {
 public:
  /// Throws InputError("position", "width" or "bounce").
  explicit SimulatedSwitch(const MachineSwitch& spec);

  /// One cycle of a straight motion from one position to another, u, within dt s. The edge is the
  /// exact position of the first one on the way; a bounce is latched at the end of its cycle.
  Sensor step(double from, double to, double dt) noexcept;

 private:
  [[nodiscard]] bool at(double position) const noexcept;

  MachineSwitch spec_;
  double bouncing_ = 0;   // s left
  bool flipped_ = false;  // inverted by a bounce
};

/// The first index on the way from one position to another, u; NaN: none.
double index_between(const MachineIndex& index, double from, double to) noexcept;

/// A drive on a machine with switches and an index, which it reports like a real one: levels, and
/// the positions of its encoder latched at their edges.
///
///     DriveOnMachine drive(servo, {.home = MachineSwitch{.position = 0, .width = 12}}, 0.001);
///     drive.feedback().sensors.home.on;
///
/// The switches see the position of the motor, and the encoder latches without delay or rounding.
class DriveOnMachine final : public AxisDrive {
 public:
  /// `period`: of the cycle, s. Throws InputError with the key of [drive]:
  /// "machine.home_switch.width", ...
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
