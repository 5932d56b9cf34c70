#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/setpoint_check.hpp"

// What an axis does in a tick: the next setpoint, whether it may go out, and what follows from it.

namespace jounce {

// ---- what it sees ------------------------------------------------------------------------------

void MotionAxis::take(const Inputs& inputs) {
  inputs_ = sound(inputs, config_);
  now_.actual_position = inputs_.feedback.position + now_.offset;
  now_.torque = inputs_.feedback.torque;
  // While nothing is commanded the axis is where the drive is: enabling it moves nothing.
  if (state_ == State::disabled && std::isfinite(now_.actual_position))
    now_.position = now_.actual_position;
  now_.following_error = now_.position - now_.actual_position;
}

void MotionAxis::watch() {
  if (!now_.power) return windows_.reset();
  Cause wrong = check_inputs(inputs_);
  if (state_ == State::disabled) {  // the drive is being switched on
    if (wrong == Cause::drive_fault) return fail(wrong);
    if (wrong == Cause::drive_not_ready) return;
    state_ = now_.fault == Cause::none ? State::standstill : State::error_stop;
  }
  // Without a sign of life what moves is stopped; what stands just stands.
  const bool stops = state_ == State::error_stop || !(moving() || waiting_);
  if (wrong == Cause::watchdog && stops) wrong = Cause::none;
  if (windows_.too_far(now_.following_error, dt(), config_) && wrong == Cause::none)
    wrong = Cause::following_error;
  if (wrong != Cause::none) fail(wrong);
}

// ---- the next setpoint -------------------------------------------------------------------------

void MotionAxis::play() {
  // What was left out before the motion began, or while it was held, does not count.
  const bool held = on_path() && now_.velocity == 0 && clock_.at(now_.tick).rate == 0;
  if (!held && std::min(now_.skipped, now_.tick - begun_) >= config_.longest_gap)
    return fail(Cause::stalled);
  constexpr int reactions = 3;  // stop on the path, then off it
  for (int i = 0; i < reactions && moving(); ++i) {
    Setpoint next;
    Cause wrong = advance(next);
    const MotionState bare{next.slave[0], next.slave[1], next.slave[2]};
    if (wrong == Cause::none) {
      lift(next);
      wrong = judge(next);
    }
    if (wrong == Cause::none) {
      bare_ = bare;
      give_out(next);
      return conclude();
    }
    fail(wrong);
  }
}

Cause MotionAxis::advance(Setpoint& next) {
  if (on_path()) return advance_path(next);
  const double t = seconds(now_.tick - origin_);
  if (base_ == Base::movement) {
    next = active_->at(moment(t));
    if (active_->progress() != Progress::broken) return Cause::none;
    return is_fault(active_->cause()) ? active_->cause() : Cause::master_lost;
  }
  const auto [p, v, a, j] = plan_.at(t);
  const double beyond = std::max(t - plan_.duration(), 0.0);  // at its last velocity
  next = {now_.master, 0, {p + v * beyond, v, a, j}};
  return Cause::none;
}

Cause MotionAxis::advance_path(Setpoint& next) {
  PathTime time = clock_.at(now_.tick);
  if (boundary_ != Boundary::none && time.s >= boundary_at_) {
    if (boundary_ == Boundary::finish) {
      joint_ = true;
      next = {now_.master, 0, {active_->end()->position, 0, 0, 0}};
      return Cause::none;
    }
    swap(boundary_at_, *active_->end());
    time = clock_.at(now_.tick);
  }
  govern();
  if (ending_ != Ending::fault && starves()) return Cause::underrun;
  if (active_->growing() && time.s > active_->known()) return Cause::jump;
  next = active_->at(moment(time.s));
  if (const auto s = swaps_at_master() ? passing(time.s) : std::nullopt) {
    swap_at_master(*s);
    time = clock_.at(now_.tick);
    next = active_->at(moment(time.s));
  }
  played_to_ = time.s;
  next = at_rate(next, time);
  joint_ = joint_ || active_->progress() == Progress::done;
  if (active_->progress() != Progress::broken) return Cause::none;
  return is_fault(active_->cause()) ? active_->cause() : Cause::jump;
}

/// Above full speed a growing path runs only while it could come back to full speed on what is
/// known, and then to rest: supply that does not keep up makes it slower, and only at full speed is
/// it an underrun. What was asked for, or half the way to it, or half of that, is granted where half
/// as much again is known, so that it does not tremble.
void MotionAxis::govern() {
  if (factor_ <= 1 || wanted_rate() <= 1) return;
  if (!active_->growing()) {
    change_rate(granted_rate());
    return;
  }
  const double rate = clock_.target();
  if (rate > 1 && !knows(now_.tick + 1, 1, 1)) change_rate(1);
  if (rate < 1 || !clock_.steady(now_.tick)) return;
  constexpr double least = 1.0 / 64;
  for (double more = wanted_rate(); more - rate > least; more = (more + rate) / 2)
    if (knows(now_.tick, more, 1.5)) {
      change_rate(more);
      return;
    }
}

/// Whether so many times the way is known that a run at `rate` takes to rest by way of full speed.
bool MotionAxis::knows(std::int64_t tick, double rate, double times) const {
  const double way = clock_.way_by(tick, rate, slope_to(rate));
  return active_->known() >= clock_.at(tick).s + times * way + 1e-3 * seconds(1);  // rounding
}

/// Less is known of the path than a stop begun in the next tick would need.
bool MotionAxis::starves() const {
  if (wanted_rate() == 0) return false;
  if (active_->progress() == Progress::starving) return true;
  if (!active_->growing()) return false;
  const std::int64_t next = now_.tick + 1;
  const double rest = clock_.at(next).s + clock_.way_to_rest(next, slope_to(0));
  return active_->known() < rest + 1e-3 * seconds(1);  // rounding
}

/// What is armed goes on where the present path, or its pass, ends at path time `boundary`.
void MotionAxis::swap(double boundary, MotionState end) {
  boundary_ = Boundary::none;
  end.position += shift_;
  if (const Cause no = pending_->begin(end, moment(0)); no != Cause::none)
    return drop({.cause = no, .value = end.position});
  hand_back(active_);
  active_ = pending_;
  pending_ = nullptr;
  waiting_ = false;
  ++now_.finished;
  joint_ = true;
  shift_ = 0;
  peaks_ = active_->peaks();
  clock_.shift(boundary);
  change_rate(granted_rate());
  state_ = active_->synchronized() ? State::synchronized_motion : State::discrete_motion;
  has_master_ = active_->synchronized();
  if (switches_of_ == SwitchesOf::master) switches_.place();
}

/// Whether what waits begins where the master of this path passes a position.
bool MotionAxis::swaps_at_master() const {
  return waiting_ && start_at_ == StartAt::master_position && active_->synchronized();
}

/// When the master passes that position on the way to path time `to`, by halving. Where a pass ends on
/// the way the master leaps to its beginning: that passes nothing.
std::optional<double> MotionAxis::passing(double to) const {
  const auto beyond = [&](double s) { return active_->at(moment(s)).master - start_position_; };
  const auto crossing = [&](double low, double high) -> std::optional<double> {
    const double before = beyond(low);
    const double after = beyond(high);
    if (!(before * after <= 0 && before != after)) return std::nullopt;
    if (before == 0) return low;
    for (int i = 0; i < 60; ++i) {
      const double middle = low + (high - low) / 2;
      ((beyond(middle) < 0) == (before < 0) ? low : high) = middle;
    }
    return high;
  };
  const double pass = active_->pass();
  const double leap = pass * std::floor(to / pass);
  if (!std::isinf(active_->known()) || !(leap > played_to_)) return crossing(played_to_, to);
  const auto there = crossing(played_to_, std::nextafter(leap, 0));
  return there ? there : crossing(leap, to);
}

/// The swap there, if both paths meet.
void MotionAxis::swap_at_master(double s) {
  const Jet& there = active_->at(moment(s)).slave;
  const MotionState end{there[0], there[1], there[2]};
  if (const auto no =
          pending_->admit(config_, {end.position + shift_, end.velocity, end.acceleration}))
    return drop(*no);
  swap(s, end);
}

/// Adds what is superimposed.
void MotionAxis::lift(Setpoint& next) {
  next.slave[0] += shift_;
  if (!lifting_) return;
  const double t = seconds(now_.tick - lift_origin_);
  const auto [p, v, a, j] = lift_.at(t);
  next.slave[0] += p;
  next.slave[1] += v;
  next.slave[2] += a;
  next.slave[3] += j;
  if (t < lift_.duration()) return;
  lifting_ = false;
  shift_ += lift_.end().position;
}

/// Whether it may go out; what brings the axis to rest after a fault may.
Cause MotionAxis::judge(const Setpoint& next) const {
  if (base_ == Base::move && ending_ == Ending::fault) return Cause::none;
  const MotionState state{next.slave[0], next.slave[1], next.slave[2]};
  const double kinks = on_path() ? peaks_.velocity_step : 0;
  const double joint = joint_ ? *config_.limits.acceleration * seconds(1) : 0;
  const StepAllowance step{dt(), kinks * static_cast<double>(now_.skipped + 2) + joint};
  if (const Cause no = check_setpoint(last(), state, step, config_); no != Cause::none) return no;
  if (state.velocity > 0 && inputs_.positive_switch) return Cause::positive_switch;
  if (state.velocity < 0 && inputs_.negative_switch) return Cause::negative_switch;
  // What was admitted ends within the range; what goes where a master, a velocity or a slower stop
  // leads may not.
  const bool to_target = base_ == Base::move && goal_.kind == Goal::Kind::position;
  const bool admitted = (on_path() || (to_target && ending_ == Ending::none)) && shift_ == 0;
  if ((admitted && !lifting_) || ending_ == Ending::fault) return Cause::none;
  return check_stopping(state, config_);
}

void MotionAxis::give_out(const Setpoint& next) {
  const auto& [p, v, a, j] = next.slave;
  emitted_ = now_.tick;
  now_.master = next.master;
  now_.master_velocity = next.master_velocity;
  now_.position = p;
  now_.velocity = v;
  now_.acceleration = a;
}

// ---- ends --------------------------------------------------------------------------------------

void MotionAxis::conclude() {
  if (base_ == Base::move) {
    if (seconds(now_.tick - origin_) < plan_.duration()) return;
    if (ending_ != Ending::none) return rest();
    if (goal_.kind == Goal::Kind::position && wanted_rate() > 0) rest();
    return;
  }
  if (!on_path()) {
    if (active_->progress() != Progress::done) return;
    // A coupling that ends at speed leaves the slave at its velocity, as CamOut does.
    const double still = 1e-9 * *config_.limits.velocity;  // rounding
    if (!(std::abs(now_.velocity) > still)) return rest();
    leave();
    origin_ = now_.tick;  // of what was given out just now, not in the tick before
    return;
  }
  const bool passed = boundary_ == Boundary::finish && clock_.at(now_.tick).s >= boundary_at_;
  if (active_->progress() == Progress::done || passed) return rest();
  const bool at_rest = clock_.target() == 0 && clock_.steady(now_.tick);
  const bool resumable = ending_ == Ending::fault && now_.fault == Cause::underrun;
  if (ending_ != Ending::none && at_rest && !resumable) rest();
}

/// The motion is over, in whatever way.
void MotionAxis::rest() {
  const bool stopped = ending_ == Ending::stop || ending_ == Ending::halt;
  if (stopped) ++now_.stopped;
  if (ending_ == Ending::none) ++now_.finished;
  now_.reason = ending_ == Ending::stop         ? Cause::stopped
                : ending_ == Ending::halt       ? Cause::halted
                : ending_ == Ending::fault      ? now_.fault
                : boundary_ == Boundary::finish ? Cause::pass_ended
                                                : Cause::none;
  state_ = ending_ == Ending::fault ? State::error_stop : State::standstill;
  const bool goes_on = lifting_ && ending_ == Ending::none;
  const double more =
      goes_on ? lift_.end().position - lift_.at(seconds(now_.tick - lift_origin_)).position : 0;
  const MotionState from = last();
  const double target = now_.position + more;
  freeze();
  if (!goes_on) return;
  // What was superimposed runs on alone.
  base_ = Base::move;
  now_.velocity = from.velocity;
  now_.acceleration = from.acceleration;
  state_ = State::discrete_motion;
  if (!plan_from(from, now_.tick, {Goal::Kind::position, target, lift_dynamics_}, 1))
    fail(more > 0 ? Cause::positive_soft_limit : Cause::negative_soft_limit);
}

/// The setpoint stays where it is; the state is the caller's affair.
void MotionAxis::freeze() {
  drop_movement();
  base_ = Base::rest;
  ending_ = Ending::none;
  boundary_ = Boundary::none;
  held_ = lifting_ = false;
  shift_ = 0;
  now_.master_velocity = now_.velocity = now_.acceleration = 0;
}

void MotionAxis::fail(Cause cause) {
  // The first fault is the one that stays: what follows is its consequence.
  const bool first = now_.fault == Cause::none;
  if (first) now_.fault = cause;
  if (first && moving()) now_.reason = cause;
  disarm();
  Reaction reaction = reaction_to(cause);
  if (cause == Cause::aborted && config_.abort_acceleration == 0) reaction = Reaction::freeze;
  if (reaction == Reaction::power_off) {
    now_.power = false;
    freeze();
    state_ = State::disabled;
    return;
  }
  if (state_ == State::disabled) return;
  state_ = State::error_stop;
  if (!moving()) return;
  if (reaction == Reaction::freeze) return freeze();
  if (base_ == Base::move && ending_ == Ending::fault && cause != Cause::aborted) return;
  const bool on_it = reaction == Reaction::stop_on_path && on_path() && !lifting_;
  boundary_ = Boundary::none;
  ending_ = Ending::fault;
  if (on_it && change_rate(0)) return;
  const bool limit = cause == Cause::positive_soft_limit || cause == Cause::negative_soft_limit;
  brake(cause == Cause::aborted ? config_.abort_acceleration
        : limit                 ? config_.limit_acceleration
                                : config_.stop_acceleration);
}

/// From the last setpoint that was good, and from the tick in which it went out.
void MotionAxis::brake(double deceleration) {
  const double jerk = config_.limits.jerk ? config_.stop_jerk : Bounds::none;
  const MoveDynamics dynamics{*config_.limits.velocity, deceleration, deceleration, jerk};
  if (!adopt({Goal::Kind::rest, 0, dynamics}, 1)) return freeze();
  ending_ = Ending::fault;
}

/// The coupling ends, the velocity stays.
void MotionAxis::leave() {
  MoveDynamics dynamics;
  fill(dynamics, config_);
  const double most = *config_.limits.velocity;
  const double velocity = std::clamp(now_.velocity, -most, most);
  if (!adopt({Goal::Kind::velocity, velocity, dynamics}, 1)) return fail(Cause::jump);
  state_ = State::continuous_motion;
  ending_ = Ending::none;
}

// ---- moves of its own, and rates ---------------------------------------------------------------

/// A move takes the place of whatever moves the axis, and goes on from its last setpoint.
void MotionAxis::go(const Goal& goal, State state) {
  const bool was_moving = moving();
  if (!adopt(goal, factor_)) return refuse(Cause::no_such_move, goal.value);
  held_ = false;
  if (!was_moving) begun_ = now_.tick;
  ending_ = Ending::none;
  now_.reason = was_moving ? Cause::replaced : Cause::none;
  state_ = state;
}

bool MotionAxis::adopt(const Goal& goal, double factor) {
  if (!plan_from(last(), moving() ? emitted_ : now_.tick, goal, factor)) return false;
  if (boundary_ == Boundary::swap) disarm();
  boundary_ = Boundary::none;
  drop_movement();
  lifting_ = false;
  shift_ = 0;
  base_ = Base::move;
  return true;
}

bool MotionAxis::plan_from(const MotionState& from, std::int64_t tick, const Goal& goal,
                           double factor) {
  const auto profile = plan(from, goal, factor, config_);
  if (!profile) return false;
  plan_ = *profile;
  goal_ = goal;
  origin_ = tick;
  return true;
}

/// The rate has changed: the path runs at another one, a move is planned anew.
void MotionAxis::replan() {
  const bool done =
      on_path() ? change_rate(granted_rate()) : plan_from(bare_, emitted_, goal_, wanted_rate());
  if (!done) refuse(Cause::no_such_move);
}

bool MotionAxis::change_rate(double rate) {
  if (rate == clock_.target()) return true;
  return clock_.change(now_.tick, rate, slope_to(rate));
}

/// How steep a change to that rate would be.
double MotionAxis::slope_to(double rate) const {
  const double highest = std::max({1.0, clock_.highest(now_.tick), rate});
  Peaks above;
  if (lifting_)
    above = {lift_dynamics_.velocity,
             std::max(lift_dynamics_.acceleration, lift_dynamics_.deceleration),
             lift_dynamics_.jerk};
  return rate_slope(peaks_, config_, highest, above);
}

void MotionAxis::drop_movement() {
  if (active_) hand_back(active_);
  active_ = nullptr;
}

// ---- small things ------------------------------------------------------------------------------

void MotionAxis::operate_switches() {
  if (!has_switches_) return;
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();  // changes nothing
  if (switches_of_ == SwitchesOf::position)
    now_.switches = switches_.step(now_.position, now_.velocity, dt());
  else
    now_.switches = switches_.step(has_master_ ? now_.master : nowhere, now_.master_velocity, dt());
}

void MotionAxis::hand_back(const Movement* movement) {
  // At most three in one step: the one played, the one armed, and the one just refused.
  auto free = std::find(now_.handed_back.begin(), now_.handed_back.end(), nullptr);
  assert(free != now_.handed_back.end());
  *free = movement;
}

void MotionAxis::refuse(Cause cause, double value, double limit) {
  now_.refused = Refusal{cause, value, limit, 0};
}

/// What waits does not begin. An answer to the command of this tick only if that asked for it.
void MotionAxis::drop(const Refusal& why) {
  (accepted_ == now_.tick ? now_.refused : now_.dropped) = why;
  disarm();
}

bool MotionAxis::on_path() const {
  return base_ == Base::movement && active_->course() == Course::path;
}

/// The rate that is asked for now; a path may grant less.
double MotionAxis::wanted_rate() const {
  if (held_ || ending_ != Ending::none) return 0;
  return on_path() ? std::min(factor_, highest_rate(peaks_, config_)) : factor_;
}

/// What of it a path takes now: above full speed, one that grows has its rate from govern(), and what
/// is about to be swapped for one comes back to full speed first.
double MotionAxis::granted(double wanted) const {
  if (!on_path() || wanted <= 1) return wanted;
  if (waiting_ && pending_ && pending_->growing()) return 1;
  return active_->growing() ? std::clamp(clock_.target(), 1.0, wanted) : wanted;
}

MotionState MotionAxis::last() const {
  return {now_.position, now_.velocity, now_.acceleration};
}

Moment MotionAxis::moment(double t) const {
  return {t, dt(), inputs_.master};
}

double MotionAxis::seconds(std::int64_t ticks) const {
  return static_cast<double>(ticks * config_.period) / 1e9;
}

}  // namespace jounce
