// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/inputs.hpp"

namespace jounce {

/// The request of an axis to its drive in one cycle.
struct DriveSetpoint {
  std::int64_t tick = 0;
  double time = 0;          ///< time of the tick, s
  double position = 0;      ///< commanded, u, in the drive's coordinate
  double velocity = 0;      ///< u/s: for a feed-forward
  double acceleration = 0;  ///< u/s^2: for a feed-forward
  bool enable = false;      ///< request to follow; false: stop by its own means and disable
  bool reset = false;       ///< request to clear its fault; one tick long
};

/// Returns the request of a tick to the drive; `command` is the accepted command. A new coordinate
/// of the axis (set position, home) does not affect the drive: Tick::offset is subtracted.
DriveSetpoint drive_setpoint(const Tick& tick, const Command& command);

/// The drive of an axis: a servo drive on a bus, a simulated one, or none. In each cycle the
/// machine reads it first, then steps the axis, then writes it:
///
///     inputs.feedback = drive.feedback();
///     const Tick tick = axis.step(k, command, inputs);
///     drive.command(drive_setpoint(tick, command));
///
/// feedback() in cycle k + 1 is therefore the answer to the setpoint of cycle k: a drive without
/// any error then has that position. Units are those of the axis, positions those of the drive: the
/// axis's minus Tick::offset.
///
/// The cyclic thread calls both: they do not allocate, free, lock, log, throw or wait. A bus driver
/// only accesses memory here, and the bus in another thread: docs/executor/drives.md.
class AxisDrive {
 public:
  AxisDrive() = default;
  virtual ~AxisDrive() = default;
  AxisDrive(const AxisDrive&) = delete;
  AxisDrive& operator=(const AxisDrive&) = delete;

  virtual void command(const DriveSetpoint& setpoint) noexcept = 0;
  [[nodiscard]] virtual Feedback feedback() noexcept = 0;
};

/// No drive: it reaches the setpoint exactly, by the next cycle. Always ready, never in a fault; it
/// reports no torque.
class NullDrive final : public AxisDrive {
 public:
  /// Starts at `position`, u.
  explicit NullDrive(double position = 0) : position_(position) {}

  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override;

 private:
  double position_;
  double velocity_ = 0;
};

}  // namespace jounce
