// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/axis/live_compensation.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/profiles/curve/jet.hpp"

#include "axis/src/probe/position_history.hpp"

namespace jounce {

/// The coordinate of an axis: its difference from the coordinate of the drive, and the positions of the
/// axis in the last ticks. The difference is the offset (set_position, homing) and the correction
/// of the compensation.
///
///     AxisCoordinate coordinate(config);
///     const double actual = coordinate.actual(drive, disabled);     // once a tick
///     position += coordinate.move_by(5);                            // set_position: no motion
///     coordinate.remember(dt, position, velocity, feedback);
///     correction = coordinate.compensate(references);               // after all axes of the machine
///
/// Always true: drive + offset = actual position + correction. A new coordinate or another correction
/// renames the places of the axis, also those in its histories, and moves nothing. u is the unit of
/// the axis.
class AxisCoordinate {
 public:
  explicit AxisCoordinate(const AxisConfig& config);

  /// Returns the actual position for this position of the drive, u. A disabled axis follows its
  /// drive: its position is the one whose corrected setpoint is the position of the drive.
  double actual(double drive, bool disabled) noexcept;
  /// Adds the positions of this tick to the histories. `dt`: s since the previous tick.
  void remember(double dt, double position, double velocity, const Feedback& feedback) noexcept;

  /// Gives every place another position: `by`, u, is added to each.
  void move_by(double by) noexcept;
  /// Returns the reason to reject a switch of the compensation, or nullopt.
  [[nodiscard]] std::optional<Refusal> against_switch(bool on, bool homed) const noexcept;
  /// Switches the compensation on or off while the axis stands at `position`, u. Returns the change of
  /// this position. Requires that against_switch() returns nullopt.
  double switch_compensation(bool on, double position) noexcept;
  /// Computes the correction from the setpoints of the references. Requires a compensation.
  const Jet& compensate(const References& references) noexcept;

  /// True if the axis has a compensation.
  [[nodiscard]] bool has_compensation() const noexcept { return compensation_.has_value(); }
  /// True if the compensation is active: the coordinate must then stay.
  [[nodiscard]] bool compensates() const noexcept {
    return compensation_ && compensation_->active();
  }
  /// Sum of all changes by move_by(), u. The position of the drive is position + correction - offset.
  [[nodiscard]] double offset() const noexcept { return offset_; }
  /// The correction, u, and its derivatives.
  [[nodiscard]] const Jet& correction() const noexcept { return correction_; }
  /// The actual position minus the position of the drive in this tick, u.
  [[nodiscard]] double from_drive() const noexcept { return offset_ - in_feedback_; }
  /// The setpoints and the actual positions of the last ticks.
  [[nodiscard]] const PositionHistory& commanded() const noexcept { return commanded_; }
  [[nodiscard]] const PositionHistory& actual_history() const noexcept { return actual_; }

 private:
  void rename(double by) noexcept;

  std::optional<LiveCompensation> compensation_;
  double offset_ = 0;       // u
  Jet correction_{};        // u; added to the setpoint of the drive
  double in_feedback_ = 0;  // correction that the feedback of this tick includes, u
  PositionHistory commanded_, actual_;
};

}  // namespace jounce
