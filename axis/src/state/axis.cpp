// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "axis/src/group/group_role.hpp"
#include "axis/src/state/axis_impl.hpp"

// One tick of an axis, from its inputs to its outputs. Read it from step() down. Other files:
// axis_commands.cpp, axis_moves.cpp, axis_buffer.cpp and axis_starts.cpp (commands), axis_path.cpp
// (a path and the next one), axis_ends.cpp (the end of a motion). Each kind of motion is played by
// a class: PathPlayer, LivePlayer, MovePlayer, SuperimposedMove.

namespace jounce {

MotionAxis::Impl::Impl(const AxisConfig& config, const AxisSwitches& switches,
                       const AxisCompare& compare)
    : config_(resolved(config)),
      master_(config_),
      coordinate_(config_),
      path_(config_),
      live_(config_.period),
      own_(config_),
      above_(config_),
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
  if (base_ != Base::live) now_.profile.clear();
  joint_ = false;
  outputs_.begin_tick();
  const bool rested = !moving();
  if (state_ == State::homing && !moving()) state_ = State::standstill;
  for (Movement* const movement : {active(), armed_.movement(), movement_of(command.what)})
    if (movement != nullptr) movement->see(inputs.rows);
  take(inputs);
  inputs_.master = master_.corrected(inputs_.master, inputs_.feedback.triggers, follows_master());
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
  master_.end_tick(inputs_.master, follows_master());
  report();
  return now_;
}

/// Sets the remaining outputs of the tick.
void MotionAxis::Impl::report() {
  now_.in_position =
      windows_.settled(now_.following_error, state_ == State::standstill, dt(), config_);
  now_.state = state_;
  const Movement* const played = active();
  now_.job = played ? played->id() : 0;
  now_.armed = armed_ ? armed_->id() : 0;
  now_.group = played ? group_ : 0;
  now_.broken = groups_.broken();
  now_.next = {};
  if (armed_ && armed_.group() != 0)
    now_.next = {armed_.group(), armed_.waiting(), armed_.tick_or(-1)};
  now_.held = held_;
  now_.ratio = base_ == Base::live ? live_->ratio() : 0;
  now_.compensated = coordinate_.compensates();
  now_.offset = coordinate_.offset();
  now_.correction = coordinate_.correction();
  now_.registration = master_.reading();
  now_.waiting =
      armed_.waiting() || !own_.waiting().empty() || later_.waits() || own_.changes_later();
  now_.later = later_.tick();
  const bool at_master = armed_.waiting() && armed_.when() == StartAt::master_position;
  now_.start_position = at_master ? armed_.position() : std::numeric_limits<double>::quiet_NaN();
  now_.live_master = {inputs_.master[0], inputs_.master[1]};
  now_.progress = played ? played->progress() : moving() ? Progress::running : Progress::done;
  if (on_path() && ending_ == Ending::fault && now_.fault == Cause::underrun)
    now_.progress = Progress::starving;
  now_.override_ = on_path() ? path_.granted(factor_, request().next) : factor_;
  const PathTime time = on_path() ? path_.time(now_.tick) : PathTime{};
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
  live_.shift_second(inputs_.second_offset - before.second_offset);
  const double by = inputs_.master_offset - before.master_offset;
  if (by == 0) return;
  master_.shift(by);
  live_.shift_master(by);
  if (base_ == Base::live) outputs_.rename_master();
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
      state_ == State::error_stop || !(moving() || armed_.waiting() || later_.waits());
  if (wrong == Cause::watchdog && (stops || base_ == Base::group)) wrong = Cause::none;
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
  const bool held = on_path() && now_.velocity == 0 && path_.time(now_.tick).rate == 0;
  if (!held && std::min(now_.skipped, now_.tick - begun_) >= config_.longest_gap)
    return fail(Cause::stalled);
  constexpr int reactions = 3;  // stop on the path, then off it
  for (int i = 0; i < reactions && moving(); ++i) {
    Setpoint next;
    const bool waits = base_ == Base::live && live_->progress() == Progress::waiting;
    Cause wrong = advance(next);
    master_.correct_slave(next.slave, follows_master());
    const MotionState bare = state_of(next);
    if (wrong == Cause::none) {
      above_.add_to(next, now_.tick);
      // Braking after a fault passes without a check.
      const bool brakes = base_ == Base::move && ending_ == Ending::fault;
      if (!brakes) wrong = supervise(state_of(next), supervised(), rules());
    }
    if (wrong == Cause::none) {
      bare_ = {bare, now_.tick};
      give_out(next);
      return conclude();
    }
    if (waits && miss_event(wrong, next)) return;
    fail(wrong, excess(wrong, state_of(next), supervised(), rules()));
  }
}

Cause MotionAxis::Impl::advance(Setpoint& next) {
  if (on_path()) return advance_path(next);
  if (base_ == Base::group) return advance_group(next);
  return base_ == Base::live ? advance_live(next) : advance_move(next);
}

Cause MotionAxis::Impl::advance_live(Setpoint& next) {
  // A pass that ends exactly in a tick is found in this tick and in the next one; a master may also
  // rest at the end of a pass.
  const auto before = now_.profile.events();
  const double reported = before.empty() ? std::numeric_limits<double>::quiet_NaN()
                                         : before.back().t - dt();  // from this tick
  now_.profile.clear();
  const bool moved = inputs_.master[0] != master_.last()[0];
  if (const auto end = live_.pass_end(moment(), now_.tick);
      end && moved && !(std::abs(end->t - reported) < dt() / 2))
    live_.add_pass(*end, now_.tick, now_.profile);
  next = live_.at(moment(), now_.tick);
  live_.add_events(now_.tick, now_.profile);
  if (master_.fails(follows_master())) return Cause::marks_lost;
  if (live_->progress() != Progress::broken) return Cause::none;
  return is_fault(live_->cause()) ? live_->cause() : Cause::master_lost;
}

Cause MotionAxis::Impl::advance_move(Setpoint& next) {
  const OwnMove::Step step = own_.advance(conditions());
  if (step.dropped) now_.dropped = step.dropped;
  now_.finished += static_cast<std::uint64_t>(step.passed);
  if (step.passed > 0)
    state_ = own_.goal().kind == Goal::Kind::velocity ? State::continuous_motion
                                                      : State::discrete_motion;
  if (step.fault != Cause::none) return step.fault;
  next = {now_.master, 0, own_.player().at(now_.tick)};
  return Cause::none;
}

/// The present motion, for the check of its next setpoint.
SupervisedMotion MotionAxis::Impl::supervised() const {
  return {.last = last(),
          .dt = dt(),
          .skipped = now_.skipped,
          .path = on_path() ? path_.peaks() : Peaks{},
          .open_ended = path_.open_ended(),
          .joined = joint_,
          .bounded = inside_as_a_whole(),
          .in_step = in_step(),
          .stops_in_fault = ending_ == Ending::fault,
          .searches = home_.running(),
          .positive_switch = inputs_.positive_switch,
          .negative_switch = inputs_.negative_switch};
}

/// True if the axis follows its master in step: the master alone determines its acceleration.
bool MotionAxis::Impl::in_step() const {
  return base_ == Base::live && live_->progress() == Progress::running;
}

/// Returns true if the whole motion was checked against the position range when it was accepted: a
/// path, or a move to a position. Each can stop inside the range: the path on itself, the move with
/// the stop limits, which exceed those of the move.
bool MotionAxis::Impl::inside_as_a_whole() const {
  if (above_.shifts()) return false;
  if (on_path()) return path_->bounded();
  return base_ == Base::move && own_.goal().kind == Goal::Kind::position && requested_rate() > 0;
}

void MotionAxis::Impl::give_out(const Setpoint& next) {
  const auto& [p, v, a, j] = next.slave;
  path_.put_out(now_.tick);
  if (on_path()) outputs_.put_out(*path_.path(), path_.time(now_.tick), dt(), is_group());
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
  now_.switches = outputs_.switches();
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
  const bool refused = armed_.accepted_in(now_.tick);
  (refused ? now_.refused : now_.dropped) = why;
  if (!refused && armed_.is_live() && !moving()) now_.reason = why.cause;
  disarm();
}

/// The played movement; null: none.
Movement* MotionAxis::Impl::active() const {
  return on_path() ? path_.path() : live_.movement();
}

MotionState MotionAxis::Impl::last() const {
  return {now_.position, now_.velocity, now_.acceleration};
}

/// The requested rate of the motion; a path may grant less.
double MotionAxis::Impl::requested_rate() const {
  if (held_ || ending_ != Ending::none) return 0;
  return home_.running() ? std::min(factor_, 1.0) : factor_;  // a homing has its own velocities
}

PathRequest MotionAxis::Impl::request() const {
  return {now_.tick, requested_rate(), above_.peaks(),
          armed_.waiting() ? armed_.movement() : nullptr};
}

}  // namespace jounce
