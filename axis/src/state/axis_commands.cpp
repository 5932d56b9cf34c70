// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "jounce/command/detail/command_table.hpp"

#include "axis/src/group/group_role.hpp"
#include "axis/src/state/axis_impl.hpp"

// The commands of an axis, one a tick: the dispatch of all, and those for power, coordinates,
// speed, and the end of a motion.

namespace jounce {

void MotionAxis::Impl::obey(const Command& command) {
  if (std::holds_alternative<command::None>(command.what)) return;
  now_.refused = take_up(command);
  const auto* const start = std::get_if<command::Start>(&command.what);
  if (start != nullptr && now_.refused) slot_.reject_start(start->group, now_.tick);
}

MotionAxis::Impl::Rejection MotionAxis::Impl::take_up(const Command& command) {
  // A new motion may interrupt the stop of a released jog.
  const bool released = motion_.ending() == Ending::release && !home_.running();
  const State state = released ? State::discrete_motion : state_;
  Cause no = against_role(inputs_.peers, command.kind());
  if (no == Cause::none) no = against_compensation(command.kind());
  if (no == Cause::none) no = permitted(state, command.kind());
  if (no == Cause::none && needs_home(command)) no = Cause::not_homed;
  if (no != Cause::none) {
    if (const Movement* const movement = movement_of(command.what)) hand_back(movement);
    return Refusal{no};
  }
  if (command.at >= 0 && command.at != now_.tick) return postpone(command);
  return std::visit([&](const auto& what) { return act(what); }, command.what);
}

/// True if the command moves to a position and the axis is not yet homed.
bool MotionAxis::Impl::needs_home(const Command& command) const {
  if (!config_.require_home || now_.homed) return false;
  const Movement* const movement = movement_of(command.what);
  return std::holds_alternative<command::MoveAbsolute>(command.what) ||
         std::holds_alternative<command::MoveRepetitive>(command.what) ||
         (movement != nullptr && movement->absolute());
}

// ---- power and coordinates ---------------------------------------------------------------------

MotionAxis::Impl::Rejection MotionAxis::Impl::power(bool on) {
  if (on && inputs_.feedback.fault) return Refusal{Cause::drive_fault};
  if (on && inputs_.peers == Peers::failed) return axis_refusal(Cause::axis_not_ready, inputs_);
  if (is_group() && !on && moving()) {
    if (!motion_.path().rests(now_.tick)) return Refusal{Cause::in_motion};
  } else if (!on && moving() && state_ != State::error_stop) {
    fail(Cause::disabled_in_motion);
    return std::nullopt;
  }
  now_.power = on;
  if (on) return std::nullopt;
  if (is_group() && moving() && state_ != State::error_stop) {  // its motion was held
    ++now_.stopped;
    now_.reason = Cause::stopped;
  }
  break_groups();
  forget_next();
  forget_later();
  cut_off();
  state_ = State::disabled;
  return std::nullopt;
}

/// A path that an underrun stopped is still active and at rest: it waits for a resume.
MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Reset& /*it*/) {
  if (state_ == State::error_stop && moving() && !(on_path() && now_.velocity == 0))
    return Refusal{Cause::in_motion};
  if (state_ == State::error_stop)
    if (auto no = against_reset(inputs_, moving())) return no;
  now_.fault = Cause::none;
  if (state_ != State::error_stop) return std::nullopt;
  motion_.go_on_held();
  state_ = moving() ? playing_state() : State::standstill;
  return std::nullopt;
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::SetPosition& what) {
  if (keeps_coordinate()) return Refusal{Cause::compensation_active};
  const double position = what.position + (what.relative ? now_.position : 0);
  const Limits& limits = config_.limits;
  if (limits.position_min && position < *limits.position_min)
    return Refusal{Cause::position_limit, position, *limits.position_min};
  if (limits.position_max && position > *limits.position_max)
    return Refusal{Cause::position_limit, position, *limits.position_max};
  return set_position(position);
}

MotionAxis::Impl::Rejection MotionAxis::Impl::set_position(double position) {
  if (slot_.armed().waiting()) return Refusal{Cause::in_motion};
  if (!std::isfinite(position)) return Refusal{Cause::no_value, position};
  if (!(std::abs(position) <= furthest(config_)))
    return Refusal{Cause::position_limit, position, furthest(config_)};
  coordinate_.move_by(position - now_.position);
  outputs_.rename();
  now_.position = position;
  return std::nullopt;
}

// ---- speed and end -----------------------------------------------------------------------------

MotionAxis::Impl::Rejection MotionAxis::Impl::end_motion(Ending ending, const MoveDynamics& asked) {
  // A search has no position range: it always ends with the stop of the axis.
  MoveDynamics dynamics;
  if (!home_.running()) dynamics = {.deceleration = asked.deceleration, .jerk = asked.jerk};
  const bool stops = ending != Ending::halt || home_.running();
  if (auto no = stops ? fill_stop(dynamics, config_) : fill(dynamics, config_)) return no;
  if (motion_.in_group()) return std::nullopt;  // the machine stops its group
  break_groups();
  forget_next();
  if (stops) forget_later();
  const bool stopping = motion_.ending() == Ending::stop || (stops && motion_.ending() == ending);
  if (!moving() || stopping) return std::nullopt;
  motion_.path().forget_boundary();
  motion_.end_by(ending);
  // Only the first point of the path was output, at the position of the axis.
  if (ending == Ending::group && motion_.unplayed(now_.velocity)) {
    rest();
    return std::nullopt;
  }
  state_ = stops ? State::stopping : State::discrete_motion;
  if (on_path() && !motion_.above().running() && motion_.path().follow(motion_.request(present())))
    return std::nullopt;
  if (adopt({Goal::Kind::rest, 0, dynamics}, 1))
    now_.reason = Cause::none;
  else
    fail(Cause::jump);
  return std::nullopt;
}

/// The motion ends early, and the armed movement with it.
void MotionAxis::Impl::break_groups() {
  if (motion_.movement()) slot_.break_motion(now_.tick);
  disarm();
}

/// Motions that begin together end together: by a stop, even if a fault ended the other one.
void MotionAxis::Impl::stop_with_group() {
  if (inputs_.peers == Peers::broken && slot_.armed().waiting())
    drop({.cause = Cause::group_stopped});
  // This stop has the dynamics of the axis, so it is never rejected: the answer of the command of
  // this tick stays.
  if (inputs_.group_broken && motion_.movement() && !motion_.ends()) end_motion(Ending::group);
}

MotionAxis::Impl::Rejection MotionAxis::Impl::hold(bool on) {
  if (motion_.is_live()) return Refusal{Cause::not_on_path};
  if (motion_.ends()) return Refusal{Cause::halting};
  if (!on && on_path())
    if (auto no = against_peers()) return no;
  if (motion_.hold(on, present())) return std::nullopt;
  return Refusal{Cause::no_such_move};
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Override& what) {
  const double factor = what.factor;
  if (!(factor >= 0 && factor <= 2)) return Refusal{Cause::no_value, factor, 2};
  // The superimposed move was planned within the limits that the factor left.
  const double most = std::max(1.0, motion_.factor());
  if (motion_.above().running() && factor > most) return Refusal{Cause::in_motion, factor, most};
  // In a fault, after a stop and while held, the factor sets nothing in motion.
  if (on_path() && factor > 0 && !motion_.held() && !motion_.ends())
    if (auto no = against_peers()) return no;
  if (motion_.set_factor(factor + 0.0, present())) return std::nullopt;  // no -0
  return Refusal{Cause::no_such_move};
}

/// Agito StopRep: finishes the stroke; the next one does not begin.
MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Finish& /*it*/) {
  if (!on_path() && !motion_.own().is_stroke()) return Refusal{Cause::not_on_path};
  if (motion_.ends()) return Refusal{Cause::halting};
  if (motion_.own().is_stroke()) {
    motion_.own().finish_strokes();
    return std::nullopt;
  }
  if (!std::isinf(motion_.path()->known()) || motion_.path()->pass() <= 0) return std::nullopt;
  const auto end = motion_.path()->end();
  const double most = *config_.limits.acceleration * seconds(config_.period);
  if (!end) return Refusal{Cause::no_movement};
  if (std::abs(end->velocity) > most) return Refusal{Cause::end_velocity, end->velocity, most};
  disarm();
  motion_.path().finish_pass(now_.tick);
  return std::nullopt;
}

}  // namespace jounce
