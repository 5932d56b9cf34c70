// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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

/// The sensor of marks, computed cycle by cycle.
class SimulatedMarks {
 public:
  /// Throws InputError with the key of the field for an invalid value.
  explicit SimulatedMarks(const MachineMarks& spec);

  /// Computes one cycle of `dt` s, in which the position moves linearly from `from` to `to` and
  /// which ended `ago` s before the present cycle. Adds the changes of the input, as long as there
  /// is space; a change beyond the space is lost.
  void step(double from, double to, double dt, double ago, Triggers& triggers) const noexcept;
  /// True if a mark is at the sensor.
  [[nodiscard]] bool at(double position) const noexcept;
  /// The spec.
  [[nodiscard]] const MachineMarks& spec() const noexcept { return spec_; }

 private:
  [[nodiscard]] double place(double mark) const noexcept;
  [[nodiscard]] bool exists(double mark) const noexcept;
  template <class F>
  void each_near(double low, double high, F f) const;

  MachineMarks spec_;
};

/// A drive on a simulated machine with switches and an index. Like a real drive, it reports the
/// states of the switches, and the positions that the encoder latched at their edges.
///
///     DriveOnMachine drive(servo, {.home = MachineSwitch{.position = 0, .width = 12}}, 0.001);
///     drive.feedback().sensors.home.on;
///
/// The switches respond to the position of the motor. The encoder latches without delay or
/// rounding. Marks on the master are detected with the position of the master that the axis used in
/// the previous cycle. So the drive reports a mark one cycle after it passes, with the time since
/// the edge.
class DriveOnMachine final : public AxisDrive {
 public:
  /// `drive`: the drive of the axis. `period`: duration of the cycle, s. Throws InputError with the
  /// key of [drive] for an invalid value: "machine.home_switch.width", ...
  DriveOnMachine(std::shared_ptr<AxisDrive> drive, const MachineSensorsSpec& spec, double period);

  void begin(std::int64_t tick) noexcept override;
  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override;

 private:
  void detect(double from, double to, Triggers& triggers) noexcept;
  [[nodiscard]] Sensor latched(std::optional<SimulatedSwitch>& of, double from, double to) noexcept;

  std::shared_ptr<AxisDrive> drive_;
  MachineSensorsSpec spec_;
  double period_;
  std::optional<SimulatedSwitch> home_, negative_, positive_;
  std::vector<SimulatedMarks> marks_;
  std::optional<double> last_;  // u, of the machine
  // Ticks of the next feedback and of the last two setpoints.
  std::int64_t tick_ = 0, commanded_ = -1, before_ = -2;
  // Master in the last two cycles.
  double master_ = std::numeric_limits<double>::quiet_NaN();
  double last_master_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace jounce
