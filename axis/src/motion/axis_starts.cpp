// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "axis/src/motion/motion_rules.hpp"
#include "axis/src/motion/start_check.hpp"
#include "axis/src/state/axis_impl.hpp"

// The slots of an axis: it arms a movement, accepts its start, and begins it when it is due.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::arm(const command::Arm& what) {
  Movement* const movement = what.movement;
  if (!movement) return Refusal{Cause::no_value};
  if (is_group() && movement->parts().empty()) {
    hand_back(movement);
    return Refusal{Cause::single_axis};
  }
  const auto no = against_arming(*movement, motion_, present(), config_);
  if (no) {
    hand_back(movement);
    return no;
  }
  disarm();
  slot_.arm(*movement, what.group, now_.tick);
  return std::nullopt;
}

void MotionAxis::Impl::disarm() {
  if (const Movement* const left = slot_.empty(now_.tick)) hand_back(left);
  if (motion_.path().swaps()) motion_.path().forget_boundary();
}

MotionAxis::Impl::Rejection MotionAxis::Impl::start(const command::Start& what) {
  if (!slot_.armed()) return Refusal{Cause::not_armed};
  if (is_group() && on_path())
    return Refusal{Cause::in_motion};  // it holds: a new path is elsewhere
  if (auto no = against_peers()) return no;
  if (what.when == StartAt::end_of_table && moving()) return start_at_end();
  if (auto no = against_start(what, slot_.armed(), motion_, present())) return no;
  const bool swaps = what.when == StartAt::master_position && on_path();
  const bool rests = !moving() || (motion_.stands(now_.tick, now_.velocity) && !swaps);
  // A coupling that begins later is checked at its beginning: its master will be elsewhere.
  const bool later = what.when == StartAt::master_position || what.tick > now_.tick;
  if (rests && !(later && slot_.armed().is_live())) {
    auto no = slot_.armed()->admit(config_, last());
    const Cause cause = slot_.armed()->begin(last(), moment());
    if (cause != Cause::none && !no) no = begin_refusal(cause, *slot_.armed(), last());
    if (cause != Cause::none) no->cause = cause;
    if (!no) no = against_active_switch();
    if (no) return no;
  }
  const StartAt when = what.when == StartAt::end_of_table ? StartAt::tick : what.when;
  slot_.accept(when, std::max(what.tick, now_.tick), what.position, now_.tick);
  if (swaps) motion_.path().follow(request());
  return std::nullopt;
}

MotionAxis::Impl::Rejection MotionAxis::Impl::couple(const command::Couple& what) {
  Movement* const movement = what.movement;
  if (!movement) return Refusal{Cause::no_value};
  if (movement->course() != Course::live) {
    hand_back(movement);
    return Refusal{Cause::bad_table};
  }
  auto no = movement->admit(config_, last());
  if (what.tick >= 0 && what.tick < now_.tick)
    no = Refusal{Cause::too_late, static_cast<double>(what.tick), static_cast<double>(now_.tick)};
  if (no) {
    hand_back(movement);
    return no;
  }
  disarm();
  slot_.arm(*movement, 0, now_.tick);
  slot_.accept(StartAt::tick, std::max(what.tick, now_.tick), 0, now_.tick);
  return std::nullopt;
}

/// Begins the armed movement in its tick, or when the master passes its position, or when a pass of
/// the active cam ends.
void MotionAxis::Impl::begin_due() {
  if (!slot_.armed().waiting()) return;
  const bool on_cam = on_path() && !slot_.armed().is_live();
  if (slot_.armed().when() == StartAt::master_position && on_cam) return;  // see advance_path()
  if (slot_.armed().when() == StartAt::end_of_table && on_path()) return;  // see advance_path()
  const auto at = begins_at();
  if (!at) return;
  if (!slot_.armed().is_live() && moving() && !motion_.stands(now_.tick, now_.velocity))
    return drop({.cause = Cause::in_motion});
  begin_pending(*at);
}

/// The instant at which it begins, `t` s after this tick (0 or less); nullopt: it is not due.
std::optional<Moment> MotionAxis::Impl::begins_at() {
  if (slot_.armed().when() == StartAt::tick) {
    const std::int64_t late = now_.tick - slot_.armed().tick_or(now_.tick);
    if (late < 0) return std::nullopt;
    return Moment{-seconds(late * config_.period), dt(), inputs_.master};
  }
  if (slot_.armed().when() == StartAt::master_position)
    return crossing(slot_.armed().position(), master_.last(), inputs_.master, dt());
  if (motion_.is_live()) return motion_.live().pass_end(moment(), now_.tick);
  drop({.cause = Cause::no_movement});  // that movement has ended
  return std::nullopt;
}

/// The state of the axis at that instant: the start of a coupling.
std::optional<MotionState> MotionAxis::Impl::state_at(const Moment& at, Cause& no) {
  if (!moving() || !slot_.armed().is_live()) return last();
  Setpoint next;
  if (slot_.armed().when() != StartAt::tick && motion_.is_live()) {
    next = motion_.live().at(at, now_.tick);
    if (motion_.live()->progress() == Progress::broken) no = motion_.live()->cause();
  } else {
    no = advance(next, present());
  }
  if (no != Cause::none) return std::nullopt;
  motion_.above().add_to(next, now_.tick);
  return state_of(next);
}

/// The refusal of an armed path that leads outwards from an active limit switch.
MotionAxis::Impl::Rejection MotionAxis::Impl::against_active_switch() const {
  return against_switch(*slot_.armed(), inputs_.positive_switch, inputs_.negative_switch,
                        now_.position);
}

/// A movement that waited for an event of its master begins with a setpoint that would be a fault. The
/// start is dropped, and the axis stays at rest. Returns false if it is no such start.
bool MotionAxis::Impl::miss_event(Cause wrong, const Setpoint& next) {
  const bool begins = motion_.is_live() && motion_.live()->progress() >= Progress::running;
  if (!begins || motion_.above().running() || now_.velocity != 0) return false;
  const auto why = against_first(wrong, state_of(next), now_.velocity, config_);
  if (!why) return false;
  now_.profile.clear();
  note(replaced(motion_.own().take_all()));
  freeze();
  state_ = State::standstill;
  now_.dropped = why;
  now_.reason = why->cause;
  return true;
}

void MotionAxis::Impl::begin_pending(const Moment& at) {
  if (inputs_.peers == Peers::missing) return drop({.cause = Cause::group_stopped});
  if (const auto refusal = against_peers()) return drop(*refusal);
  if (is_group()) {  // the length along its path
    now_.position = 0;
    outputs_.begin_path();
  }
  const bool live = slot_.armed().is_live();
  Cause no = Cause::none;
  const auto state = state_at(at, no);
  if (!state) return drop({.cause = no});
  if (const auto refusal = live ? slot_.armed()->admit(config_, *state) : std::nullopt)
    return drop(*refusal);
  if (const auto refusal = against_active_switch()) return drop(*refusal);
  // The positions of the next cam do not include the phase shift of this one.
  if (slot_.armed()->passes() && motion_.live().phase().moves(now_.tick))
    return drop({.cause = Cause::in_motion});
  Moment begin = live && slot_.armed().when() != StartAt::tick ? at : moment();
  begin.ratio = motion_.in_step() ? motion_.live()->ratio() : 0;
  no = slot_.armed()->begin(*state, begin);
  if (no != Cause::none) return drop(begin_refusal(no, *slot_.armed(), *state));
  if (const auto refusal =
          live ? against_jump(*slot_.armed(), moment(), last(), home_.rules()) : std::nullopt)
    return drop(*refusal);
  if (const auto refusal = against_demand(*slot_.armed(), begin, config_)) return drop(*refusal);
  const ArmedMotion begun = slot_.take();
  const bool was_registered = master_.registers(motion_.follows_master());
  drop_movement();
  note(replaced(motion_.own().take_all()));
  if (live) {
    motion_.begin_live(begun, present());
    if (motion_.follows_master() && !was_registered) master_.begin(inputs_.master[0]);
  } else {
    // At full speed, path time is bit for bit ticks * period since the tick of the start.
    const double ahead = begun.when() == StartAt::tick ? 0 : -at.t;
    motion_.begin_path(begun, ahead, present());
  }
  now_.reason = Cause::none;
  enter(begun);
}

/// The movement is now the played one.
void MotionAxis::Impl::enter(const ArmedMotion& begun) {
  motion_.join();
  state_ = playing_state();
  outputs_.enter(begun->synchronized());
}

State MotionAxis::Impl::playing_state() const {
  return motion_.movement()->synchronized() ? State::synchronized_motion : State::discrete_motion;
}

}  // namespace jounce
