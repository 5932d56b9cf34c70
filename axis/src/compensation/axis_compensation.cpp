// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <cmath>

#include "axis/src/state/axis_impl.hpp"

// The compensation of an axis. The drive receives the setpoint plus the correction; so feedback minus
// the correction of the previous tick is the actual position. A disabled axis follows its drive: its
// position is the one whose corrected setpoint is the position of the drive.

namespace jounce {

/// Rejects a switch of a compensation that the axis does not have, in every state: disabling the
/// axis first would not help.
Cause MotionAxis::Impl::against_compensation(CommandKind kind) const {
  const bool switches =
      kind == CommandKind::enable_compensation || kind == CommandKind::disable_compensation;
  return switches && !compensation_ ? Cause::no_compensation : Cause::none;
}

/// Switches the compensation on or off at the present place of the drive: only the position of the
/// axis changes.
MotionAxis::Impl::Rejection MotionAxis::Impl::set_compensation(bool on) {
  if (compensation_->active() == on)
    return Refusal{on ? Cause::compensation_active : Cause::compensation_inactive};
  if (on && !now_.homed) return Refusal{Cause::not_homed};
  const double output = now_.position + in_feedback_;
  compensation_->set(on);
  const double position = compensation_->position_of(output);
  rename(position - now_.position);
  now_.correction = {output - position, 0, 0, 0};
  see_feedback();
  return std::nullopt;
}

/// Feedback in the coordinate of the axis.
void MotionAxis::Impl::see_feedback() {
  const double drive = inputs_.feedback.position + now_.offset;
  in_feedback_ = now_.correction[0];
  if (compensation_ && state_ == State::disabled && std::isfinite(drive))
    in_feedback_ = drive - compensation_->position_of(drive);
  now_.actual_position = drive - in_feedback_;
}

/// True while a compensation depends on the coordinate of the axis.
bool MotionAxis::Impl::keeps_coordinate() const {
  return (compensation_ && compensation_->active()) || inputs_.referenced;
}

/// Gives the place of the axis another position, without motion.
void MotionAxis::Impl::rename(double by) {
  commanded_seen_.shift(by);
  actual_seen_.shift(by);
  now_.position += by;
  outputs_.place(SwitchesOf::position);
}

Jet MotionAxis::Impl::compensate(const References& references) {
  assert(compensation_);
  compensation_->see(references);
  now_.correction = compensation_->correction();
  return now_.correction;
}

}  // namespace jounce
