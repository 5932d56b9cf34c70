// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "axis/src/motion/start_check.hpp"
#include "axis/src/state/axis_impl.hpp"

// The slots of an axis: it arms a movement, accepts its start, and begins it when it is due.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Arm& what) {
  Movement* const movement = what.movement;
  if (!movement) return Refusal{Cause::no_value};
  if (is_group() && movement->parts().empty()) {
    hand_back(movement);
    return Refusal{Cause::single_axis};
  }
  const auto from = expected_end();
  Rejection no;
  if (from || path_.open_ended())
    no = movement->admit(config_, from.value_or(last()));
  else if (movement->course() == Course::path)
    no = Refusal{Cause::in_motion};
  if (no && stands()) no = movement->admit(config_, last());
  // A swap at a master position, or at the end of rows, checks its start state at the swap.
  if (no && on_path() && (path_->synchronized() || path_.open_ended()) &&
      (no->cause == Cause::start_position || no->cause == Cause::start_velocity))
    no.reset();
  if (no) {
    hand_back(movement);
    return no;
  }
  disarm();
  armed_.arm(movement, what.group);
  groups_.join(what.group, now_.tick);
  return std::nullopt;
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Disarm& /*it*/) {
  if (!armed_.waiting()) disarm();
  forget_later();
  return take_back_next();
}

/// The state in which the present motion will come to rest, or in which a pass of it ends; nullopt:
/// not available.
std::optional<MotionState> MotionAxis::Impl::expected_end() const {
  if (!moving()) return MotionState{now_.position, 0, 0};
  const double above = above_.distance();
  if (base_ == Base::move) {
    if (own_.repeats()) return std::nullopt;
    const Goal& goal = own_.goal();
    if (goal.kind == Goal::Kind::velocity && goal.value != 0) return std::nullopt;
    const bool there = goal.kind == Goal::Kind::position;
    return MotionState{(there ? goal.value : own_.player().plan().end().position) + above, 0, 0};
  }
  auto end = active()->end();
  if (end) end->position += above;
  return end;
}

void MotionAxis::Impl::disarm() {
  const ArmedMotion was = std::exchange(armed_, {});
  if (was) hand_back(was.movement());
  groups_.break_armed(was.group(), was.waiting(), now_.tick);
  if (path_.swaps()) path_.forget_boundary();
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Start& what) {
  if (!armed_) return Refusal{Cause::not_armed};
  if (is_group() && on_path())
    return Refusal{Cause::in_motion};  // it holds: a new path is elsewhere
  if (auto no = against_peers()) return no;
  if (what.when == StartAt::end_of_table && moving()) return start_at_end();
  if (what.when == StartAt::end_of_table && armed_.is_live()) return Refusal{Cause::no_movement};
  if (what.when == StartAt::tick && what.tick >= 0 && what.tick < now_.tick)
    return Refusal{Cause::too_late, static_cast<double>(what.tick), static_cast<double>(now_.tick)};
  if (what.when == StartAt::master_position && !std::isfinite(what.position))
    return Refusal{Cause::no_value, what.position};
  const bool swaps = what.when == StartAt::master_position && on_path();
  const bool rests = !moving() || (stands() && !swaps);
  if (!armed_.is_live() && !rests && !swaps) return Refusal{Cause::in_motion};
  if (swaps)
    if (auto no = against_swap()) return no;
  // A coupling that begins later is checked at its beginning: its master will be elsewhere.
  const bool later = what.when == StartAt::master_position || what.tick > now_.tick;
  if (rests && !(later && armed_.is_live())) {
    auto no = armed_->admit(config_, last());
    const Cause cause = armed_->begin(last(), moment());
    if (cause != Cause::none && !no) no = begin_refusal(cause, *armed_, last());
    if (cause != Cause::none) no->cause = cause;
    if (!no) no = against_active_switch();
    if (no) return no;
  }
  const StartAt when = what.when == StartAt::end_of_table ? StartAt::tick : what.when;
  armed_.accept(when, std::max(what.tick, now_.tick), what.position, now_.tick);
  if (swaps) path_.follow(request());
  return std::nullopt;
}

/// True if it is held on its path, or stopped there by an underrun and reset: the armed movement
/// may begin from here.
bool MotionAxis::Impl::stands() const {
  return on_path() && !above_.running() && ending_ == Ending::none && path_.rests(now_.tick) &&
         now_.velocity == 0;
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Couple& what) {
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
  armed_.arm(movement, 0);
  armed_.accept(StartAt::tick, std::max(what.tick, now_.tick), 0, now_.tick);
  return std::nullopt;
}

/// Begins the armed movement in its tick, or when the master passes its position, or when a pass of
/// the active cam ends.
void MotionAxis::Impl::begin_due() {
  if (!armed_.waiting()) return;
  const bool on_cam = on_path() && !armed_.is_live();
  if (armed_.when() == StartAt::master_position && on_cam) return;  // see advance_path()
  if (armed_.when() == StartAt::end_of_table && on_path()) return;  // see advance_path()
  const auto at = begins_at();
  if (!at) return;
  if (!armed_.is_live() && moving() && !stands()) return drop({.cause = Cause::in_motion});
  begin_pending(*at);
}

/// The instant at which it begins, `t` s after this tick (0 or less); nullopt: it is not due.
std::optional<Moment> MotionAxis::Impl::begins_at() {
  if (armed_.when() == StartAt::tick) {
    const std::int64_t late = now_.tick - armed_.tick_or(now_.tick);
    if (late < 0) return std::nullopt;
    return Moment{-seconds(late * config_.period), dt(), inputs_.master};
  }
  if (armed_.when() == StartAt::master_position)
    return crossing(armed_.position(), master_.last(), inputs_.master, dt());
  if (base_ == Base::live) return live_.pass_end(moment(), now_.tick);
  drop({.cause = Cause::no_movement});  // that movement has ended
  return std::nullopt;
}

/// The state of the axis at that instant: the start of a coupling.
std::optional<MotionState> MotionAxis::Impl::state_at(const Moment& at, Cause& no) {
  if (!moving() || !armed_.is_live()) return last();
  Setpoint next;
  if (armed_.when() != StartAt::tick && base_ == Base::live) {
    next = live_.at(at, now_.tick);
    if (live_->progress() == Progress::broken) no = live_->cause();
  } else {
    no = advance(next);
  }
  if (no != Cause::none) return std::nullopt;
  above_.add_to(next, now_.tick);
  return state_of(next);
}

/// The refusal of an armed path that leads outwards from an active limit switch.
MotionAxis::Impl::Rejection MotionAxis::Impl::against_active_switch() const {
  return against_switch(*armed_, inputs_.positive_switch, inputs_.negative_switch, now_.position);
}

/// A movement that waited for an event of its master begins with a setpoint that would be a fault. The
/// start is dropped, and the axis stays at rest. Returns false if it is no such start.
bool MotionAxis::Impl::miss_event(Cause wrong, const Setpoint& next) {
  const bool begins = base_ == Base::live && live_->progress() >= Progress::running;
  if (!begins || above_.running() || now_.velocity != 0) return false;
  const auto why = against_first(wrong, state_of(next), now_.velocity, config_);
  if (!why) return false;
  now_.profile.clear();
  forget_next();
  freeze();
  state_ = State::standstill;
  now_.dropped = why;
  now_.reason = why->cause;
  return true;
}

/// The ratio at which the axis follows its master in step, u/m; 0: it does not.
double MotionAxis::Impl::followed_ratio() const {
  return base_ == Base::live && live_->progress() == Progress::running ? live_->ratio() : 0;
}

void MotionAxis::Impl::begin_pending(const Moment& at) {
  if (inputs_.peers == Peers::missing) return drop({.cause = Cause::group_stopped});
  if (const auto refusal = against_peers()) return drop(*refusal);
  if (is_group()) {  // the length along its path
    now_.position = 0;
    outputs_.begin_path();
  }
  const bool live = armed_.is_live();
  Cause no = Cause::none;
  const auto state = state_at(at, no);
  if (!state) return drop({.cause = no});
  if (const auto refusal = live ? armed_->admit(config_, *state) : std::nullopt)
    return drop(*refusal);
  if (const auto refusal = against_active_switch()) return drop(*refusal);
  // The positions of the next cam do not include the phase shift of this one.
  if (armed_->passes() && live_.phase().moves(now_.tick)) return drop({.cause = Cause::in_motion});
  Moment begin = live && armed_.when() != StartAt::tick ? at : moment();
  begin.ratio = followed_ratio();
  no = armed_->begin(*state, begin);
  if (no != Cause::none) return drop(begin_refusal(no, *armed_, *state));
  if (const auto refusal = live ? against_jump(*armed_, moment(), last(), rules()) : std::nullopt)
    return drop(*refusal);
  if (const auto refusal = against_demand(*armed_, begin, config_)) return drop(*refusal);
  const ArmedMotion begun = std::exchange(armed_, {});
  const bool was_moving = moving();
  const bool was_registered = master_.registers(follows_master());
  drop_movement();
  forget_next();
  held_ = false;
  ending_ = Ending::none;
  above_.clear();
  if (!was_moving) begun_ = begun.tick_or(now_.tick);
  if (live) {
    base_ = Base::live;
    live_.begin(*begun.movement(), now_.tick);
    if (follows_master() && !was_registered) master_.begin(inputs_.master[0]);
  } else {
    // At full speed, path time is bit for bit ticks * period since the tick of the start.
    const double ahead = begun.when() == StartAt::tick ? 0 : -at.t;
    base_ = Base::path;
    path_.begin(*begun.movement(), begun.tick_or(now_.tick), requested_rate(), ahead);
  }
  now_.reason = Cause::none;
  enter(begun);
}

/// The movement is now the played one.
void MotionAxis::Impl::enter(const ArmedMotion& begun) {
  group_ = begun.group();
  joint_ = true;
  state_ = playing_state();
  outputs_.enter(begun->synchronized());
}

State MotionAxis::Impl::playing_state() const {
  return active()->synchronized() ? State::synchronized_motion : State::discrete_motion;
}

}  // namespace jounce
