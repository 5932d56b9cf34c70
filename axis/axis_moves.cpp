#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/axis/axis.hpp"

// The moves that an axis plans itself (move_plan.hpp), each from the last setpoint that went out.

namespace jounce {

using Kind = Command::Kind;

namespace {

/// A move on top of another one takes what that leaves of the velocity limit, and half of what it
/// leaves of the stop limits: the other half is for a change of the rate below it.
std::optional<Refusal> take_away(AxisConfig& config, const Peaks& below) {
  Limits& limits = config.limits;
  const double most = *limits.velocity;
  *limits.velocity -= below.velocity;
  *limits.acceleration =
      std::min(*limits.acceleration, (config.stop_acceleration - below.acceleration) / 2);
  if (limits.jerk) limits.jerk = std::min(*limits.jerk, (config.stop_jerk - below.jerk) / 2);
  if (!(*limits.velocity > 1e-9 * most))
    return Refusal{Cause::velocity_limit, below.velocity, most, 0};
  if (!(*limits.acceleration > 0) || (limits.jerk && !(*limits.jerk > 0)))
    return Refusal{Cause::acceleration_limit, below.acceleration, config.stop_acceleration, 0};
  return std::nullopt;
}

}  // namespace

void MotionAxis::move(const Command& command) {
  const bool under_way = moving() && ending_ == Ending::none;
  if (command.kind == Kind::move_superimposed && under_way && state_ != State::continuous_motion) {
    if (!std::isfinite(command.position)) return refuse(Cause::no_value, command.position);
    return superimpose(command.position, command.dynamics);
  }
  const bool buffers = command.kind == Kind::move_absolute || command.kind == Kind::move_relative ||
                       command.kind == Kind::move_velocity;
  if (buffers && command.buffer != BufferMode::aborting && moving()) return buffer(command);
  Goal goal;
  if (now_.refused = goal_of(command, last(), goal); now_.refused) return;
  const WaitingMoves waited = std::exchange(next_, {});
  if (go(goal)) return forget(waited);
  next_ = waited;
  refuse(Cause::no_such_move, goal.value);
}

/// The goal of a move that begins in this state.
std::optional<Refusal> MotionAxis::goal_of(const Command& command, const MotionState& from,
                                           Goal& goal) const {
  const double value = command.position;
  if (!std::isfinite(value)) return Refusal{Cause::no_value, value, 0, 0};
  MoveDynamics dynamics = command.dynamics;
  if (const auto no = fill(dynamics, config_)) return no;
  if (command.kind == Kind::move_velocity) {
    const double velocity = std::copysign(dynamics.velocity, value);
    if (value == 0) return Refusal{Cause::no_value, value, 0, 0};
    goal = {Goal::Kind::velocity, velocity, dynamics};
    const bool blocked = velocity > 0 ? inputs_.positive_switch : inputs_.negative_switch;
    return blocked ? std::optional(Refusal{Cause::direction_blocked, velocity, 0, 0})
                   : std::nullopt;
  }
  std::optional<double> target = from.position + value;
  if (command.kind == Kind::move_absolute)
    target = target_of(value, command.direction, from, dynamics, config_);
  const bool aimed = base_ == Base::move && goal_.kind != Goal::Kind::velocity;
  if (command.kind == Kind::move_additive && aimed) target = goal_.value + shift_ + value;
  if (!target) return Refusal{Cause::no_such_move, value, 0, 0};
  goal = {Goal::Kind::position, *target, dynamics};
  return forbidden(*target, from.position);
}

/// Why no move may have this target.
std::optional<Refusal> MotionAxis::forbidden(double target, double from) const {
  const auto& [low, high, v, a, j] = config_.limits;
  if (low && target < *low) return Refusal{Cause::position_limit, target, *low, 0};
  if (high && target > *high) return Refusal{Cause::position_limit, target, *high, 0};
  const bool blocked =
      (inputs_.positive_switch && target > from) || (inputs_.negative_switch && target < from);
  return blocked ? std::optional(Refusal{Cause::direction_blocked, target, from, 0}) : std::nullopt;
}

/// What is under way below a superimposed move, at most.
Peaks MotionAxis::beneath() const {
  if (on_path()) {
    const double r = std::max(1.0, clock_.target());
    const double kinks = peaks_.velocity_step / seconds(1);
    return {peaks_.velocity * r, std::max(peaks_.acceleration, kinks) * r * r,
            peaks_.jerk * r * r * r};
  }
  if (base_ != Base::move) return {std::abs(bare_.velocity), 0, 0};
  const MoveDynamics& d = goal_.dynamics;
  // What it was in the middle of when it was told may take it beyond its own dynamics.
  const auto [low, high] = velocities(plan_);
  return {std::max({high, -low, d.velocity * std::max(1.0, factor_)}),
          std::max({d.acceleration, d.deceleration, std::abs(bare_.acceleration)}), d.jerk};
}

/// Why a distance on top of what is under way would end outside the range.
std::optional<Refusal> MotionAxis::ends_outside(double distance) const {
  const auto end = expected_end();
  if (!end || lifting_) return std::nullopt;
  const double target = end->position + distance;
  const auto& [low, high, v, a, j] = config_.limits;
  if (low && target < *low) return Refusal{Cause::position_limit, target, *low, 0};
  if (high && target > *high) return Refusal{Cause::position_limit, target, *high, 0};
  return std::nullopt;
}

void MotionAxis::superimpose(double distance, MoveDynamics dynamics) {
  if (on_path() && !clock_.steady(now_.tick)) return refuse(Cause::rate_changing);
  if (boundary_ == Boundary::swap || passes()) return refuse(Cause::in_motion);
  AxisConfig left = config_;
  if (now_.refused = take_away(left, beneath()); now_.refused) return;
  if (now_.refused = fill(dynamics, left); now_.refused) return;
  if (now_.refused = ends_outside(distance); now_.refused) return;
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

/// The slave keeps its velocity (PMC600 manual 6.1, 6.2); MC_Stop or another move follows.
void MotionAxis::decouple() {
  if (!active_) return refuse(Cause::not_synchronized);
  leave(Goal::Kind::velocity);
  if (base_ != Base::move) refuse(Cause::no_such_move);
}

// ---- planning ----------------------------------------------------------------------------------

/// A move takes the place of whatever moves the axis, and goes on from its last setpoint.
bool MotionAxis::go(const Goal& goal) {
  const bool was_moving = moving();
  if (!adopt(goal, factor_)) return false;
  held_ = false;
  if (!was_moving) begun_ = emitted_ = now_.tick;  // more may be told in this very tick
  ending_ = Ending::none;
  now_.reason = was_moving ? Cause::replaced : Cause::none;
  state_ = goal.kind == Goal::Kind::velocity ? State::continuous_motion : State::discrete_motion;
  return true;
}

bool MotionAxis::adopt(const Goal& goal, double factor) {
  if (!plan_from(last(), moving() ? emitted_ : now_.tick, goal, factor)) return false;
  if (boundary_ == Boundary::swap) disarm();
  boundary_ = Boundary::none;
  drop_movement();
  lifting_ = false;
  shift_ = 0;
  bare_ = last();
  base_ = Base::move;
  return true;
}

bool MotionAxis::plan_from(const MotionState& from, std::int64_t tick, const Goal& goal,
                           double factor) {
  Goal aim = goal;
  aim.through = through(from, goal, factor);
  const auto profile = plan(from, aim, factor, config_);
  if (!profile) return false;
  plan_ = *profile;
  goal_ = aim;
  origin_ = tick;
  ahead_ = 0;
  return true;
}

/// From the last setpoint that was good, and from the tick in which it went out.
void MotionAxis::brake(double deceleration) {
  const double jerk = config_.limits.jerk ? config_.stop_jerk : Bounds::none;
  const MoveDynamics dynamics{*config_.limits.velocity, deceleration, deceleration, jerk};
  if (!adopt({Goal::Kind::rest, 0, dynamics}, 1)) return freeze();
  ending_ = Ending::fault;
}

/// The coupling ends: the velocity stays, or the axis comes to rest.
void MotionAxis::leave(Goal::Kind kind) {
  const bool rests = kind == Goal::Kind::rest;
  MoveDynamics dynamics;
  fill(dynamics, config_);
  const double most = *config_.limits.velocity;
  const double velocity = rests ? 0 : std::clamp(now_.velocity, -most, most);
  if (!adopt({kind, velocity, dynamics}, 1)) return fail(Cause::jump);
  state_ = rests ? State::discrete_motion : State::continuous_motion;
  ending_ = rests ? Ending::table : Ending::none;
}

}  // namespace jounce
