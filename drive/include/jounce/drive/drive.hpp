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
  double position = 0;      ///< commanded, u, as the drive counts
  double velocity = 0;      ///< u/s: for a feed-forward
  double acceleration = 0;  ///< u/s^2: for a feed-forward
  bool enable = false;      ///< it is to follow; otherwise to stop by its own means and let go
  bool reset = false;       ///< its fault is to be cleared; one tick long
};

/// The request of a tick to the drive; `command` is the accepted command. A new name of the axis's
/// position (set position, home) is none of the drive's business: Tick::offset is taken off.
DriveSetpoint drive_setpoint(const Tick& tick, const Command& command);

/// The drive of an axis: a servo drive on a bus, a simulated one, or none. In each cycle the
/// machine reads it first, then steps the axis, then writes it:
///
///     inputs.feedback = drive.feedback();
///     const Tick tick = axis.step(k, command, inputs);
///     drive.command(drive_setpoint(tick, command));
///
/// So feedback() in cycle k + 1 is the answer to the setpoint of cycle k: a drive without
/// any error has its actual position there. Units are those of the axis, positions those of the drive:
/// Tick::offset less than the axis's.
///
/// Both are called by the cyclic thread: they neither allocate nor free, lock, log, throw nor wait.
/// A bus driver uses memory here and the wire elsewhere. docs/executor/drives.md.
class AxisDrive {
 public:
  AxisDrive() = default;
  virtual ~AxisDrive() = default;
  AxisDrive(const AxisDrive&) = delete;
  AxisDrive& operator=(const AxisDrive&) = delete;

  virtual void command(const DriveSetpoint& setpoint) noexcept = 0;
  [[nodiscard]] virtual Feedback feedback() noexcept = 0;
};

/// No drive: the setpoint is reached exactly, by the next cycle. Always ready, never in a fault; it
/// reports no torque.
class NullDrive final : public AxisDrive {
 public:
  /// It stands at `position`, u.
  explicit NullDrive(double position = 0) : position_(position) {}

  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override;

 private:
  double position_;
  double velocity_ = 0;
};

}  // namespace jounce
