#include "jounce/axis/axis.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

// What an axis is told. What it does about it, tick by tick, is in axis_motion.cpp.

namespace jounce {

using Kind = Command::Kind;

MotionAxis::MotionAxis(const AxisConfig& config, const AxisSwitches& switches)
    : config_(resolved(config)),
      clock_(config_.period),
      has_switches_(!switches.table.switches.empty()),
      switches_of_(switches.of),
      switches_(switches.table) {
  now_.position = config_.position;
}

bool in_motion(const Tick& tick) {
  const bool left = tick.state == State::error_stop && tick.job != 0 && tick.rate == 0;
  return tick.waiting || (!left && (tick.job != 0 || tick.progress != Progress::done));
}

Tick MotionAxis::step(std::int64_t tick, const Command& command, const Inputs& inputs) {
  assert(tick > last_tick_);
  now_.skipped = tick - last_tick_ - 1;
  now_.tick = tick;
  now_.time = seconds(tick);
  now_.refused.reset();
  now_.dropped.reset();
  now_.handed_back = {};
  joint_ = false;
  if (state_ == State::homing) state_ = State::standstill;
  for (Movement* const movement : {active_, pending_, command.movement})
    if (movement != nullptr) movement->see(inputs.rows);
  take(inputs);
  obey(command);
  watch();
  begin_due();
  if (moving()) play();
  operate_switches();
  last_tick_ = tick;
  last_master_ = inputs_.master[0];
  now_.in_position =
      windows_.settled(now_.following_error, state_ == State::standstill, dt(), config_);
  now_.state = state_;
  now_.job = active_ ? active_->id() : 0;
  now_.armed = pending_ ? pending_->id() : 0;
  now_.waiting = waiting_;
  now_.progress = active_ ? active_->progress() : moving() ? Progress::running : Progress::done;
  if (on_path() && ending_ == Ending::fault && now_.fault == Cause::underrun)
    now_.progress = Progress::starving;
  now_.override_ = on_path() ? granted(std::min(factor_, highest_rate(peaks_, config_))) : factor_;
  now_.rate = on_path() ? clock_.at(tick).rate : 1;
  return now_;
}

void MotionAxis::obey(const Command& command) {
  if (command.kind == Kind::none) return;
  if (const Cause no = permitted(state_, command.kind); no != Cause::none) {
    if (command.movement) hand_back(command.movement);
    return refuse(no);
  }
  switch (command.kind) {
    case Kind::none:
      return;
    case Kind::enable:
      return power(true);
    case Kind::disable:
      return power(false);
    case Kind::arm:
      return arm(command.movement);
    case Kind::disarm:
      if (!waiting_) disarm();
      return;
    case Kind::start:
      return start(command);
    case Kind::stop:
      return end_motion(Ending::stop, command);
    case Kind::halt:
      return end_motion(Ending::halt, command);
    case Kind::abort:
      return fail(Cause::aborted);
    case Kind::reset:
      return reset();
    case Kind::set_position:
      return set_position(command.position + (command.relative ? now_.position : 0));
    case Kind::home:
      set_position(command.position);
      if (!now_.refused) state_ = State::homing;
      return;
    case Kind::hold:
    case Kind::resume:
      return hold(command.kind == Kind::hold);
    case Kind::override_:
      return set_override(command.factor);
    case Kind::finish:
      return finish();
    case Kind::move_absolute:
    case Kind::move_relative:
    case Kind::move_additive:
    case Kind::move_superimposed:
    case Kind::move_velocity:
      return move(command);
    case Kind::gear_in:
      return gear_in(command.movement);
    case Kind::gear_out:
    case Kind::cam_out:
      return decouple();
  }
}

// ---- power and faults --------------------------------------------------------------------------

void MotionAxis::power(bool on) {
  if (on && inputs_.feedback.fault) return refuse(Cause::drive_fault);
  if (!on && moving() && state_ != State::error_stop) return fail(Cause::disabled_in_motion);
  now_.power = on;
  if (on) return;
  disarm();
  freeze();
  state_ = State::disabled;
}

/// A path that an underrun stopped is still there, and at rest: it waits for a resume.
void MotionAxis::reset() {
  if (state_ == State::error_stop && moving() && !(on_path() && now_.velocity == 0))
    return refuse(Cause::in_motion);
  now_.fault = Cause::none;
  if (state_ != State::error_stop) return;
  ending_ = Ending::none;
  held_ = moving();
  state_ = !moving()                 ? State::standstill
           : active_->synchronized() ? State::synchronized_motion
                                     : State::discrete_motion;
}

// ---- movements ---------------------------------------------------------------------------------

/// Where what is under way will come to rest, or where a pass of it ends; nothing: nobody knows.
std::optional<MotionState> MotionAxis::expected_end() const {
  if (!moving()) return MotionState{now_.position, 0, 0};
  const double above = shift_ + (lifting_ ? lift_.end().position : 0);
  if (base_ == Base::move) {
    if (goal_.kind == Goal::Kind::velocity) return std::nullopt;
    const bool there = goal_.kind == Goal::Kind::position;
    return MotionState{(there ? goal_.value : plan_.end().position) + above, 0, 0};
  }
  auto end = active_->end();
  if (end) end->position += above;
  return end;
}

void MotionAxis::arm(Movement* movement) {
  if (!movement) return refuse(Cause::no_value);
  const auto from = expected_end();
  if (from)
    now_.refused = movement->admit(config_, *from);
  else if (movement->course() == Course::path)
    refuse(Cause::in_motion);
  // For a swap where the master passes a position: where the cam begins is looked at there.
  if (now_.refused && on_path() && active_->synchronized() &&
      (now_.refused->cause == Cause::start_position ||
       now_.refused->cause == Cause::start_velocity))
    now_.refused.reset();
  if (now_.refused) return hand_back(movement);
  disarm();
  pending_ = movement;
}

void MotionAxis::disarm() {
  if (pending_) hand_back(pending_);
  pending_ = nullptr;
  waiting_ = false;
  if (boundary_ == Boundary::swap) boundary_ = Boundary::none;
}

void MotionAxis::start(const Command& command) {
  if (!pending_) return refuse(Cause::not_armed);
  if (command.start_at == StartAt::end_of_table && moving()) return start_at_end();
  if (command.start_at == StartAt::tick && command.at >= 0 && command.at < now_.tick)
    return refuse(Cause::too_late, static_cast<double>(command.at), static_cast<double>(now_.tick));
  if (command.start_at == StartAt::master_position && !std::isfinite(command.position))
    return refuse(Cause::no_value, command.position);
  const bool swaps = command.start_at == StartAt::master_position && on_path();
  if (pending_->course() == Course::path && moving() && !swaps) return refuse(Cause::in_motion);
  if (swaps && !ready_to_swap()) return;
  if (!moving()) {
    now_.refused = pending_->admit(config_, last());
    const Cause no = pending_->begin(last(), moment(0));
    if (no != Cause::none) now_.refused = now_.refused.value_or(Refusal{});
    if (no != Cause::none) now_.refused->cause = no;
    if (now_.refused) return;
  }
  waiting_ = true;
  accepted_ = now_.tick;
  start_at_ = command.start_at == StartAt::end_of_table ? StartAt::tick : command.start_at;
  start_tick_ = std::max(command.at, now_.tick);
  start_position_ = command.position;
}

/// Until the swap the rate may only be what both paths take.
bool MotionAxis::ready_to_swap() {
  if (!clock_.steady(now_.tick)) refuse(Cause::rate_changing);
  if (lifting_ || pending_->course() == Course::live) refuse(Cause::in_motion);
  if (now_.refused) return false;
  const Peaks next = pending_->peaks();
  peaks_ = {std::max(peaks_.velocity, next.velocity),
            std::max(peaks_.acceleration, next.acceleration), std::max(peaks_.jerk, next.jerk),
            std::max(peaks_.velocity_step, next.velocity_step)};
  change_rate(pending_->growing() ? std::min(granted_rate(), 1.0) : granted_rate());
  return true;
}

/// A swap where the path, or its present pass, ends.
void MotionAxis::start_at_end() {
  const auto end = expected_end();
  if (!on_path() || active_->pass() <= 0 || !end) return refuse(Cause::not_on_path);
  if (now_.refused = pending_->admit(config_, *end); now_.refused) return;
  if (!ready_to_swap()) return;
  const double s = clock_.at(now_.tick).s;
  const bool repeats = std::isinf(active_->known());
  boundary_ = Boundary::swap;
  boundary_at_ = active_->pass() * (repeats ? std::floor(s / active_->pass()) + 1 : 1);
  waiting_ = true;
  accepted_ = now_.tick;
  start_at_ = StartAt::end_of_table;
}

/// Begins what waits, if this is its tick, or the master passes its position.
void MotionAxis::begin_due() {
  if (!waiting_ || start_at_ == StartAt::end_of_table) return;
  const bool on_cam = on_path() && pending_->course() == Course::path;
  if (start_at_ == StartAt::master_position && on_cam) return;  // swap_at_master()
  double ahead = 0;
  if (start_at_ == StartAt::tick) {
    if (start_tick_ > now_.tick) return;
    ahead = seconds(now_.tick - start_tick_);
  } else {
    const double before = last_master_ - start_position_;
    const double after = inputs_.master[0] - start_position_;
    if (!(before * after <= 0 && before != after)) return;
    ahead = dt() * after / (after - before);
  }
  if (pending_->course() == Course::path && moving()) return drop({.cause = Cause::in_motion});
  begin_pending(last(), ahead);
}

void MotionAxis::begin_pending(const MotionState& from, double ahead) {
  const bool live = pending_->course() == Course::live;
  MotionState state = from;
  if (live && moving()) {  // where it would be by now
    Setpoint next;
    if (advance(next) != Cause::none) return disarm();
    lift(next);
    state = {next.slave[0], next.slave[1], next.slave[2]};
  }
  if (const Cause no = pending_->begin(state, moment(0)); no != Cause::none)
    return drop({.cause = no, .value = state.position});
  Movement* const next = pending_;
  pending_ = nullptr;
  waiting_ = false;
  const bool was_moving = moving();
  drop_movement();
  active_ = next;
  base_ = Base::movement;
  ending_ = Ending::none;
  held_ = lifting_ = false;
  shift_ = 0;
  joint_ = true;
  peaks_ = active_->peaks();
  origin_ = now_.tick;
  if (!was_moving) begun_ = start_at_ == StartAt::tick ? start_tick_ : now_.tick;
  if (!live) {
    const double rate = active_->growing() ? std::min(wanted_rate(), 1.0) : wanted_rate();
    played_to_ = 0;
    // At full speed path time is bit for bit ticks * period since the tick of the start.
    if (start_at_ == StartAt::tick)
      clock_.start(start_tick_, 0, rate);
    else
      clock_.start(now_.tick, ahead * rate, rate);
  }
  now_.reason = Cause::none;
  state_ = active_->synchronized() ? State::synchronized_motion : State::discrete_motion;
  has_master_ = active_->synchronized();
  if (switches_of_ == SwitchesOf::master) switches_.place();
}

void MotionAxis::gear_in(Movement* movement) {
  if (!movement) return refuse(Cause::no_value);
  if (movement->course() != Course::live) {
    refuse(Cause::bad_table);
    return hand_back(movement);
  }
  if (now_.refused = movement->admit(config_, last()); now_.refused) return hand_back(movement);
  disarm();
  pending_ = movement;
  waiting_ = true;
  accepted_ = now_.tick;
  start_at_ = StartAt::tick;
  start_tick_ = now_.tick;
}

/// The slave keeps its velocity (PMC600 manual 6.1, 6.2); MC_Stop or another move follows.
void MotionAxis::decouple() {
  if (!active_) return refuse(Cause::not_synchronized);
  leave();
  if (base_ != Base::move) refuse(Cause::no_such_move);
}

// ---- holds, stops and rates --------------------------------------------------------------------

void MotionAxis::end_motion(Ending ending, const Command& command) {
  MoveDynamics dynamics = command.dynamics;
  now_.refused = ending == Ending::stop ? fill_stop(dynamics, config_) : fill(dynamics, config_);
  if (now_.refused) return;
  disarm();
  if (!moving() || state_ == State::stopping) return;
  boundary_ = Boundary::none;
  ending_ = ending;
  state_ = ending == Ending::stop ? State::stopping : State::discrete_motion;
  if (on_path() && !lifting_ && change_rate(0)) return;
  if (!adopt({Goal::Kind::rest, 0, dynamics}, 1)) return fail(Cause::jump);
  now_.reason = Cause::none;
}

void MotionAxis::hold(bool on) {
  if (base_ == Base::movement && !on_path()) return refuse(Cause::not_on_path);
  if (ending_ != Ending::none) return refuse(Cause::halting);
  held_ = on;
  replan();
}

void MotionAxis::set_override(double factor) {
  if (!(factor >= 0 && factor <= 2)) return refuse(Cause::no_value, factor, 2);
  factor_ = factor;
  if (moving() && ending_ == Ending::none && (base_ == Base::move || on_path())) replan();
}

/// Agito StopRep: the stroke is finished, the next one does not begin.
void MotionAxis::finish() {
  if (!on_path()) return refuse(Cause::not_on_path);
  if (ending_ != Ending::none) return refuse(Cause::halting);
  if (!std::isinf(active_->known()) || active_->pass() <= 0) return;
  const auto end = active_->end();
  const double most = *config_.limits.acceleration * seconds(1);
  if (!end) return refuse(Cause::no_movement);
  if (std::abs(end->velocity) > most) return refuse(Cause::end_velocity, end->velocity, most);
  disarm();
  boundary_ = Boundary::finish;
  boundary_at_ = active_->pass() * (std::floor(clock_.at(now_.tick).s / active_->pass()) + 1);
}

// ---- moves -------------------------------------------------------------------------------------

void MotionAxis::set_position(double position) {
  if (waiting_) return refuse(Cause::in_motion);
  if (!std::isfinite(position)) return refuse(Cause::no_value, position);
  if (!(std::abs(position) <= furthest(config_)))
    return refuse(Cause::position_limit, position, furthest(config_));
  now_.offset += position - now_.position;
  now_.position = position;
  if (switches_of_ == SwitchesOf::position) switches_.place();
}

void MotionAxis::move(const Command& command) {
  MoveDynamics dynamics = command.dynamics;
  const double value = command.position;
  if (!std::isfinite(value)) return refuse(Cause::no_value, value);
  const bool alone = !moving() || goal_.kind == Goal::Kind::velocity || base_ != Base::move;
  const bool under_way = moving() && ending_ == Ending::none;
  if (command.kind == Kind::move_superimposed && under_way && state_ != State::continuous_motion)
    return superimpose(value, dynamics);
  if (now_.refused = fill(dynamics, config_); now_.refused) return;
  switch (command.kind) {
    case Kind::move_absolute: {
      const auto target = target_of(value, command.direction, last(), dynamics, config_);
      return target ? move_to(*target, dynamics) : refuse(Cause::no_such_move, value);
    }
    case Kind::move_additive:
      return move_to((alone ? now_.position : goal_.value + shift_) + value, dynamics);
    case Kind::move_velocity: {
      const double velocity = std::copysign(dynamics.velocity, value);
      if (value == 0) return refuse(Cause::no_value, value);
      if (velocity > 0 ? inputs_.positive_switch : inputs_.negative_switch)
        return refuse(Cause::direction_blocked, velocity);
      return go({Goal::Kind::velocity, velocity, dynamics}, State::continuous_motion);
    }
    default:
      return move_to(now_.position + value, dynamics);
  }
}

void MotionAxis::move_to(double position, const MoveDynamics& dynamics) {
  const auto& [low, high, v, a, j] = config_.limits;
  if (low && position < *low) return refuse(Cause::position_limit, position, *low);
  if (high && position > *high) return refuse(Cause::position_limit, position, *high);
  if ((inputs_.positive_switch && position > now_.position) ||
      (inputs_.negative_switch && position < now_.position))
    return refuse(Cause::direction_blocked, position, now_.position);
  go({Goal::Kind::position, position, dynamics}, State::discrete_motion);
}

/// A move on top of another one takes what that leaves of the velocity limit, and half of what it
/// leaves of the stop limits: the other half is for a change of the rate below it.
void MotionAxis::superimpose(double distance, MoveDynamics dynamics) {
  if (on_path() && !clock_.steady(now_.tick)) return refuse(Cause::rate_changing);
  if (boundary_ == Boundary::swap) return refuse(Cause::in_motion);
  Peaks below{std::abs(bare_.velocity), 0, 0};
  if (on_path()) {
    const double r = std::max(1.0, clock_.target());
    const double kinks = peaks_.velocity_step / seconds(1);
    below = {peaks_.velocity * r, std::max(peaks_.acceleration, kinks) * r * r,
             peaks_.jerk * r * r * r};
  } else if (base_ == Base::move) {
    const MoveDynamics& d = goal_.dynamics;
    below = {std::max(below.velocity, d.velocity * std::max(1.0, factor_)),
             std::max(d.acceleration, d.deceleration), d.jerk};
  }
  AxisConfig left = config_;
  *left.limits.velocity -= below.velocity;
  *left.limits.acceleration =
      std::min(*left.limits.acceleration, (config_.stop_acceleration - below.acceleration) / 2);
  if (left.limits.jerk)
    left.limits.jerk = std::min(*left.limits.jerk, (config_.stop_jerk - below.jerk) / 2);
  if (!(*left.limits.velocity > 1e-9 * *config_.limits.velocity))
    return refuse(Cause::velocity_limit, below.velocity, *config_.limits.velocity);
  if (!(*left.limits.acceleration > 0) || (left.limits.jerk && !(*left.limits.jerk > 0)))
    return refuse(Cause::acceleration_limit, below.acceleration, config_.stop_acceleration);
  if (now_.refused = fill(dynamics, left); now_.refused) return;
  if (const auto end = expected_end(); end && !lifting_) {
    const double target = end->position + distance;
    const auto& [low, high, v, a, j] = config_.limits;
    if (low && target < *low) return refuse(Cause::position_limit, target, *low);
    if (high && target > *high) return refuse(Cause::position_limit, target, *high);
  }
  const Motion up = lifting_ ? lift_.at(seconds(now_.tick - lift_origin_)) : Motion{};
  left.limits.position_min = left.limits.position_max = std::nullopt;
  const auto profile = plan({up.position, up.velocity, up.acceleration},
                            {Goal::Kind::position, up.position + distance, dynamics}, 1, left);
  if (!profile) return refuse(Cause::no_such_move, distance);
  lifting_ = true;
  lift_ = *profile;
  lift_dynamics_ = dynamics;
  lift_origin_ = now_.tick;
}

}  // namespace jounce
