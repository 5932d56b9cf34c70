#include <algorithm>
#include <cmath>

#include "jounce/axis/axis.hpp"

// The moves that an axis plans itself (move_plan.hpp), each from the last setpoint that went out.

namespace jounce {

using Kind = Command::Kind;

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

/// The slave keeps its velocity (PMC600 manual 6.1, 6.2); MC_Stop or another move follows.
void MotionAxis::decouple() {
  if (!active_) return refuse(Cause::not_synchronized);
  leave();
  if (base_ != Base::move) refuse(Cause::no_such_move);
}

// ---- planning ----------------------------------------------------------------------------------

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

}  // namespace jounce
