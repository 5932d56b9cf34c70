// SPDX-License-Identifier: Apache-2.0
#include "axis/src/state/axis_impl.hpp"

// The coordinate of an axis (axis_coordinate.hpp) in its states, and the touch probes.

namespace jounce {

/// Rejects a switch of a compensation that the axis does not have, in every state: disabling the
/// axis first would not help.
Cause MotionAxis::Impl::against_compensation(CommandKind kind) const {
  const bool switches =
      kind == CommandKind::enable_compensation || kind == CommandKind::disable_compensation;
  return switches && !coordinate_.has_compensation() ? Cause::no_compensation : Cause::none;
}

/// Switches the compensation on or off at the present place of the drive: only the position of the
/// axis changes.
MotionAxis::Impl::Rejection MotionAxis::Impl::set_compensation(bool on) {
  if (auto no = coordinate_.against_switch(on, now_.homed)) return no;
  now_.position += coordinate_.switch_compensation(on, now_.position);
  outputs_.rename();
  see_feedback();
  return std::nullopt;
}

/// Feedback in the coordinate of the axis.
void MotionAxis::Impl::see_feedback() {
  now_.actual_position = coordinate_.actual(inputs_.feedback.position, state_ == State::disabled);
}

/// True while a compensation depends on the coordinate of the axis.
bool MotionAxis::Impl::keeps_coordinate() const {
  return coordinate_.compensates() || inputs_.referenced;
}

/// After the setpoint of this tick: a capture may need its position.
void MotionAxis::Impl::probe() {
  coordinate_.remember(dt(), now_.position, now_.velocity, inputs_.feedback);
  probes_.step(inputs_.feedback,
               {coordinate_.commanded(), coordinate_.actual_history(), master_.history(),
                coordinate_.from_drive()},
               dt(), config_);
  now_.probe = probes_.now();
}

Jet MotionAxis::Impl::compensate(const References& references) {
  now_.correction = coordinate_.compensate(references);
  return now_.correction;
}

}  // namespace jounce
