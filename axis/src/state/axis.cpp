// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "axis/src/group/group_role.hpp"
#include "axis/src/state/axis_impl.hpp"

// One tick of an axis, from its inputs to its outputs. Read it from step() down. Other files:
// axis_commands.cpp, axis_moves.cpp, axis_buffer.cpp and axis_starts.cpp (commands), axis_path.cpp
// (a path and the next one), axis_ends.cpp (the end of a motion).

namespace jounce {

MotionAxis::Impl::Impl(const AxisConfig& config, const AxisSwitches& switches,
                       const AxisCompare& compare)
    : config_(resolved(config)),
      master_(config_),
      coordinate_(config_),
      motion_(config_),
      home_(config_),
      outputs_(switches, compare) {
  now_.position = config_.position;
}

Tick MotionAxis::Impl::step(std::int64_t tick, const Command& command, const Inputs& inputs) {
  assert(tick > last_tick_);
  now_.skipped = tick - last_tick_ - 1;
  now_.tick = tick;
  now_.time = seconds(tick * config_.period);
  now_.refused.reset();
  now_.dropped.reset();
  now_.handed_back = {};
  now_.frozen = false;
  if (!motion_.is_live()) now_.profile.clear();
  motion_.begin_tick();
  outputs_.begin_tick();
  const bool rested = !moving();
  if (state_ == State::homing && !moving()) state_ = State::standstill;
  for (Movement* const movement :
       {motion_.movement(), slot_.armed().movement(), movement_of(command.what)})
    if (movement != nullptr) movement->see(inputs.rows);
  take(inputs);
  inputs_.master =
      master_.corrected(inputs_.master, inputs_.feedback.triggers, motion_.follows_master());
  obey_due();
  obey(command);
  watch();
  follow_group();
  begin_due();
  if (state_ == State::homing && moving()) seek();
  if (rested && moving()) outputs_.begin();
  if (moving()) play();
  operate_outputs();
  probe();
  last_tick_ = tick;
  master_.end_tick(inputs_.master, motion_.follows_master());
  report();
  return now_;
}

/// Sets the remaining outputs of the tick.
void MotionAxis::Impl::report() {
  now_.in_position =
      windows_.settled(now_.following_error, state_ == State::standstill, dt(), config_);
  now_.state = state_;
  const Movement* const played = motion_.movement();
  now_.job = played ? played->id() : 0;
  now_.armed = slot_.armed() ? slot_.armed()->id() : 0;
  now_.group = played ? slot_.group() : 0;
  now_.broken = slot_.broken();
  now_.next = slot_.next();
  now_.held = motion_.held();
  now_.ratio = motion_.is_live() ? motion_.live()->ratio() : 0;
  now_.compensated = coordinate_.compensates();
  now_.offset = coordinate_.offset();
  now_.correction = coordinate_.correction();
  now_.registration = master_.reading();
  now_.waiting = slot_.armed().waiting() || !motion_.own().waiting().empty() || later_.waits() ||
                 motion_.own().changes_later();
  now_.later = later_.tick();
  const bool at_master =
      slot_.armed().waiting() && slot_.armed().when() == StartAt::master_position;
  now_.start_position =
      at_master ? slot_.armed().position() : std::numeric_limits<double>::quiet_NaN();
  now_.live_master = {inputs_.master[0], inputs_.master[1]};
  now_.progress = played ? played->progress() : moving() ? Progress::running : Progress::done;
  if (on_path() && motion_.ending() == Ending::fault && now_.fault == Cause::underrun)
    now_.progress = Progress::starving;
  now_.override_ =
      on_path() ? motion_.path().granted(motion_.factor(), slot_.waiting()) : motion_.factor();
  const PathTime time = on_path() ? motion_.path().time(now_.tick) : PathTime{};
  now_.rate = time.rate;
  now_.path_time = time.s;
}

// ---- inputs ------------------------------------------------------------------------------------

void MotionAxis::Impl::take(const Inputs& inputs) {
  const Inputs before = inputs_;
  inputs_ = sound(inputs, config_);
  inputs_.positive_switch |= inputs_.feedback.sensors.positive.on;
  inputs_.negative_switch |= inputs_.feedback.sensors.negative.on;
  see_renamed(before);
  master_.see(dt(), inputs_.master);
  see_feedback();
  now_.torque = inputs_.feedback.torque;
  // A disabled axis takes the position of its drive: enabling causes no motion.
  if (state_ == State::disabled && std::isfinite(now_.actual_position))
    now_.position = now_.actual_position;
  now_.following_error = now_.position - now_.actual_position;
}

/// A new coordinate of the master passes no position and causes no motion.
void MotionAxis::Impl::see_renamed(const Inputs& before) {
  motion_.live().shift_second(inputs_.second_offset - before.second_offset);
  const double by = inputs_.master_offset - before.master_offset;
  if (by == 0) return;
  master_.shift(by);
  motion_.live().shift_master(by);
  if (motion_.is_live()) outputs_.rename_master();
}

void MotionAxis::Impl::watch() {
  if (inputs_.feedback.fault) now_.homed = false;  // the drive may have lost its position count
  if (!now_.power) return windows_.reset();
  Cause wrong = check_inputs(inputs_);
  if (state_ == State::disabled) {  // the drive is being switched on
    if (wrong == Cause::drive_fault) return fail(wrong);
    if (wrong == Cause::drive_not_ready) return;
    state_ = now_.fault == Cause::none ? State::standstill : State::error_stop;
  }
  // Without a heartbeat, an axis in motion stops; an axis at rest stays at rest. A group stops with
  // its axes on its path.
  const bool stops =
      state_ == State::error_stop || !(moving() || slot_.armed().waiting() || later_.waits());
  if (wrong == Cause::watchdog && (stops || motion_.in_group())) wrong = Cause::none;
  if (windows_.too_far(now_.following_error, dt(), config_) && wrong == Cause::none)
    wrong = Cause::following_error;
  const bool broken = inputs_.peers == Peers::failed && state_ != State::error_stop;
  if (broken && wrong == Cause::none) {
    wrong = Cause::axis_fault;
    now_.failed_axis = axis_refusal(Cause::axis_not_ready, inputs_);
  }
  if (wrong == Cause::following_error) return fail(wrong, now_.following_error);
  if (wrong != Cause::none) return fail(wrong);
  stop_with_group();
}

// ---- the next setpoint -------------------------------------------------------------------------

void MotionAxis::Impl::play() {
  // Ticks skipped before the motion began, or during a hold, do not count.
  const bool held = on_path() && now_.velocity == 0 && motion_.path().time(now_.tick).rate == 0;
  if (!held && std::min(now_.skipped, now_.tick - motion_.begun()) >= config_.longest_gap)
    return fail(Cause::stalled);
  constexpr int reactions = 3;  // stop on the path, then off it
  for (int i = 0; i < reactions && moving(); ++i) {
    Setpoint next;
    const MotionNow now = present();
    const bool waits = motion_.is_live() && motion_.live()->progress() == Progress::waiting;
    Cause wrong = advance(next, now);
    master_.correct_slave(next.slave, motion_.follows_master());
    const MotionState bare = state_of(next);
    if (wrong == Cause::none) {
      motion_.above().add_to(next, now_.tick);
      // Braking after a fault passes without a check.
      if (!motion_.brakes_in_fault())
        wrong = supervise(state_of(next), motion_.supervised(now_.skipped, now), home_.rules());
    }
    if (wrong == Cause::none) {
      motion_.put_out(bare, now_.tick);
      give_out(next);
      return conclude();
    }
    if (waits && miss_event(wrong, next)) return;
    fail(wrong,
         excess(wrong, state_of(next), motion_.supervised(now_.skipped, now), home_.rules()));
  }
}

Cause MotionAxis::Impl::advance(Setpoint& next, const MotionNow& now) {
  if (on_path()) return advance_path(next);
  if (motion_.in_group()) return advance_group(next);
  return motion_.is_live() ? advance_live(next, now) : advance_move(next, now);
}

Cause MotionAxis::Impl::advance_live(Setpoint& next, const MotionNow& now) {
  const bool moved = inputs_.master[0] != master_.last()[0];
  const Cause no = motion_.advance_live(next, now_.profile, moved, now);
  return master_.fails(motion_.follows_master()) ? Cause::marks_lost : no;
}

Cause MotionAxis::Impl::advance_move(Setpoint& next, const MotionNow& now) {
  const OwnMove::Step step = motion_.own().advance(motion_.conditions(now));
  if (step.dropped) now_.dropped = step.dropped;
  now_.finished += static_cast<std::uint64_t>(step.passed);
  if (step.passed > 0)
    state_ = motion_.own().goal().kind == Goal::Kind::velocity ? State::continuous_motion
                                                               : State::discrete_motion;
  if (step.fault != Cause::none) return step.fault;
  next = {now_.master, 0, motion_.own().player().at(now_.tick)};
  return Cause::none;
}

void MotionAxis::Impl::give_out(const Setpoint& next) {
  const auto& [p, v, a, j] = next.slave;
  if (on_path())
    outputs_.put_out(*motion_.path().path(), motion_.path().time(now_.tick), dt(), is_group());
  now_.master = next.master;
  now_.master_velocity = next.master_velocity;
  now_.position = p;
  now_.velocity = v;
  now_.acceleration = a;
}

void MotionAxis::Impl::operate_outputs() {
  outputs_.step({.commanded = {now_.position, now_.velocity},
                 .actual = {now_.actual_position, inputs_.feedback.velocity},
                 .master = {now_.master, now_.master_velocity},
                 .is_group = is_group(),
                 .on_path = on_path(),
                 .disabled = state_ == State::disabled},
                dt());
  outputs_.get_switches(now_.switches);
  now_.compare = outputs_.compare();
}

// ---- helpers -----------------------------------------------------------------------------------

bool in_motion(const Tick& tick) {
  const bool left = tick.state == State::error_stop && tick.job != 0 && tick.rate == 0;
  return tick.waiting || (!left && (tick.job != 0 || tick.progress != Progress::done));
}

void MotionAxis::Impl::hand_back(const Movement* movement) {
  // At most three in one step: the active one, the armed one, and the one just rejected.
  auto free = std::find(now_.handed_back.begin(), now_.handed_back.end(), nullptr);
  assert(free != now_.handed_back.end());
  *free = movement;
}

/// Drops the waiting start. This answers the command of this tick only if that command requested
/// it.
void MotionAxis::Impl::drop(const Refusal& why) {
  const bool refused = slot_.armed().accepted_in(now_.tick);
  (refused ? now_.refused : now_.dropped) = why;
  if (!refused && slot_.armed().is_live() && !moving()) now_.reason = why.cause;
  disarm();
}

MotionState MotionAxis::Impl::last() const {
  return {now_.position, now_.velocity, now_.acceleration};
}

/// The axis in this tick, as its motion reads it.
MotionNow MotionAxis::Impl::present() const {
  return {.tick = now_.tick,
          .last_tick = last_tick_,
          .last = last(),
          .moment = moment(),
          .rules = home_.rules(),
          .searches = home_.running(),
          .positive_switch = inputs_.positive_switch,
          .negative_switch = inputs_.negative_switch,
          .next = slot_.waiting()};
}

}  // namespace jounce
