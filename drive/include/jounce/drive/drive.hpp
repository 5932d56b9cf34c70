// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "jounce/axis/command.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/axis/tick.hpp"

namespace jounce {

/// The request of an axis to its drive in one cycle. Unit u: the unit of the axis.
struct DriveSetpoint {
  std::int64_t tick = 0;    ///< number of the tick
  double time = 0;          ///< time of the tick, s
  double position = 0;      ///< commanded position, u, in the coordinate of the drive
  double velocity = 0;      ///< commanded velocity, u/s, for a feed-forward
  double acceleration = 0;  ///< commanded acceleration, u/s^2, for a feed-forward
  /// True: follow the setpoints. False: stop with the drive's own quick stop, then disable.
  bool enable = false;
  bool reset = false;  ///< true for one tick: clear the fault
  /// Position of the live master of the axis, in the unit of the master, without the changes of its
  /// coordinate by set_position: a place on the material. NaN: no master. Only for the sensors of a
  /// simulated machine.
  double master = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the request of a tick to the drive. `command` is the command that the axis accepted in
/// this tick. A change of the axis's coordinate (set_position, home) does not affect the drive,
/// because Tick::offset is subtracted from the position.
DriveSetpoint drive_setpoint(const Tick& tick, const Command& command);

/// The drive of an axis: a servo drive on a bus, a simulated one, or none. In each cycle, the
/// machine reads the drive, steps the axis, and writes to the drive:
///
///     inputs.feedback = drive.feedback();
///     const Tick tick = axis.step(k, command, inputs);
///     drive.command(drive_setpoint(tick, command));
///
/// So the feedback in cycle k + 1 is the answer to the setpoint of cycle k: an ideal drive then has
/// the position of this setpoint. Units are the units of the axis. Positions are in the coordinate
/// of the drive: position of the axis minus Tick::offset.
///
/// The cyclic thread calls both functions, once in each cycle. The functions must not allocate,
/// free, lock, log, throw or wait. A bus driver should only access memory in these functions, and
/// transfer the data over the bus in another thread (docs/executor/drives.md).
class AxisDrive {
 public:
  AxisDrive() = default;
  virtual ~AxisDrive() = default;
  AxisDrive(const AxisDrive&) = delete;
  AxisDrive& operator=(const AxisDrive&) = delete;

  /// Announces the tick of the next feedback. After a late cycle, it is more than one after the
  /// tick of the last setpoint. Default: no effect.
  virtual void begin(std::int64_t /*tick*/) noexcept {}
  /// Receives the setpoint of this cycle.
  virtual void command(const DriveSetpoint& setpoint) noexcept = 0;
  /// Returns the feedback of this cycle.
  [[nodiscard]] virtual Feedback feedback() noexcept = 0;
};

/// An ideal drive: it reaches each setpoint exactly by the next cycle. It is always ready, never in
/// a fault, and reports no torque.
class NullDrive final : public AxisDrive {
 public:
  /// `position`: initial position, u.
  explicit NullDrive(double position = 0) : position_(position) {}

  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override;

 private:
  double position_;
  double velocity_ = 0;
};

}  // namespace jounce
