// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "jounce/command/detail/command_table.hpp"

#include "axis/src/group/group_role.hpp"
#include "axis/src/motion/motion_rules.hpp"
#include "axis/src/state/axis_impl.hpp"

// The commands of an axis, one a tick: the dispatch of all, and those for power, coordinates,
// speed, and the end of a motion.

namespace jounce {
namespace {

/// A visitor with a function for each kind of command.
template <class... F>
struct Cases : F... {
  using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

}  // namespace

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
  return execute(command.what);
}

MotionAxis::Impl::Rejection MotionAxis::Impl::execute(const AxisCommand& command) {
  namespace c = jounce::command;
  const auto done = [] { return Rejection(); };
  return std::visit(
      Cases{
          [&](const c::None&) { return done(); },
          [&](const c::Enable&) { return power(true); },
          [&](const c::Disable&) { return power(false); },
          [&](const c::Arm& what) { return arm(what); },
          [&](const c::Disarm&) {
            if (!slot_.armed().waiting()) disarm();
            note(later_.forget());
            return take_back_next();
          },
          [&](const c::Start& what) { return start(what); },
          [&](const c::Stop& what) { return end_motion(Ending::stop, what.dynamics); },
          [&](const c::Abort&) { return fail(Cause::aborted), done(); },
          [&](const c::Reset&) { return reset(); },
          [&](const c::SetPosition& what) { return set_position(what); },
          [&](const c::Home& what) { return home(what); },
          [&](const c::Hold&) { return hold(true); },
          [&](const c::Resume&) { return hold(false); },
          [&](const c::Override& what) { return override_by(what.factor); },
          [&](const c::Finish&) { return finish(); },
          [&](const c::MoveAbsolute& what) { return move_or_buffer(what); },
          [&](const c::MoveRelative& what) { return move_or_buffer(what); },
          [&](const c::MoveAdditive& what) { return move_on(what); },
          [&](const c::MoveSuperimposed& what) { return superimpose(what); },
          [&](const c::MoveVelocity& what) { return move_or_buffer(what); },
          [&](const c::MoveRepetitive& what) { return repeat(what); },
          [&](const c::ChangeVelocity& what) { return motion_.change(what, present()); },
          [&](const c::Halt& what) { return end_motion(Ending::halt, what.dynamics); },
          [&](const c::Couple& what) { return couple(what); },
          [&](const c::GearOut&) { return decouple(); },
          [&](const c::CamOut&) { return decouple(); },
          [&](const c::PhasingAbsolute& what) {
            return motion_.shift_phase(what.shift, what.dynamics, present());
          },
          [&](const c::PhasingRelative& what) {
            const double from = motion_.live().phase().at(now_.tick)[0];
            return motion_.shift_phase(from + what.shift, what.dynamics, present());
          },
          [&](const c::TouchProbe& what) { return probes_.start(what, inputs_.feedback, config_); },
          [&](const c::AbortTrigger& what) { return probes_.abort(what.input); },
          [&](const c::EnableCompensation&) { return set_compensation(true); },
          [&](const c::DisableCompensation&) { return set_compensation(false); },
          [&](const c::Cut& what) { return motion_.cut(what); },
          [&](const c::Park&) { return motion_.park(); },
          [&](const c::Release&) { return end_motion(Ending::release); },
          [&](const c::Extend& what) { return extend(what); },
      },
      command);
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
  note(replaced(motion_.own().take_all()));
  note(later_.forget());
  cut_off();
  state_ = State::disabled;
  return std::nullopt;
}

/// A path that an underrun stopped is still active and at rest: it waits for a resume.
MotionAxis::Impl::Rejection MotionAxis::Impl::reset() {
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

MotionAxis::Impl::Rejection MotionAxis::Impl::set_position(const command::SetPosition& what) {
  if (keeps_coordinate()) return Refusal{Cause::compensation_active};
  const double position = what.position + (what.relative ? now_.position : 0);
  const Limits& limits = config_.limits;
  if (limits.position_min && position < *limits.position_min)
    return Refusal{Cause::position_limit, position, *limits.position_min};
  if (limits.position_max && position > *limits.position_max)
    return Refusal{Cause::position_limit, position, *limits.position_max};
  return rename_to(position);
}

MotionAxis::Impl::Rejection MotionAxis::Impl::rename_to(double position) {
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
  note(replaced(motion_.own().take_all()));
  if (stops) note(later_.forget());
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
  if (on_path() && !motion_.above().running() && motion_.path().follow(request()))
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

MotionAxis::Impl::Rejection MotionAxis::Impl::override_by(double factor) {
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
MotionAxis::Impl::Rejection MotionAxis::Impl::finish() {
  if (auto no = against_finish(motion_, config_)) return no;
  if (motion_.own().is_stroke()) {
    motion_.own().finish_strokes();
  } else if (motion_.path().repeats()) {
    disarm();
    motion_.path().finish_pass(now_.tick);
  }
  return std::nullopt;
}

}  // namespace jounce
