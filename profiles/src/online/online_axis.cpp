// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/online/online_axis.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

#include "profiles/src/solver/axis_task.hpp"
#include "profiles/src/solver/solver.hpp"
#include "profiles/src/solver/travel.hpp"

namespace jounce::profiles_detail {
namespace {

/// Shares of a travel that are no detour.
constexpr double strict_detour = 1e-13;
constexpr double loose_detour = 1e-10;
/// The relative rounding error of a number after the computations of a user's program and of a
/// plan.
constexpr double digits = 0x1p-46;
/// The rounding error of the sum of cycles, as a share of the distance that a moving target covers.
constexpr double drift = 0x1p-40;
/// In a forbidden direction, a velocity below this share of the other one counts as zero.
constexpr double at_rest = 1e-12;
/// Instants that differ by less than this share of a cycle are the same.
constexpr double same_instant = 1e-9;

bool agree(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance + digits * (std::abs(a) + std::abs(b));
}

/// The bounds, with each zero replaced by the value of `others`.
Bounds where_zero(Bounds b, const Bounds& others) {
  const auto fill = [](double& x, double other) {
    if (x == 0) x = other;
  };
  fill(b.velocity_min, others.velocity_min);
  fill(b.velocity_max, others.velocity_max);
  fill(b.acceleration_min, others.acceleration_min);
  fill(b.acceleration_max, others.acceleration_max);
  fill(b.jerk_min, others.jerk_min);
  fill(b.jerk_max, others.jerk_max);
  return b;
}

/// The bounds of the opposite direction, as magnitudes of this one.
Bounds mirrored(const Bounds& b) {
  return {-b.velocity_max, -b.velocity_min, -b.acceleration_max, -b.acceleration_min,
          -b.jerk_max,     -b.jerk_min,     b.position_min,      b.position_max};
}

bool lies_in(const Bounds& inner, const Bounds& outer) {
  return inner.velocity_min >= outer.velocity_min && inner.velocity_max <= outer.velocity_max &&
         inner.acceleration_min >= outer.acceleration_min &&
         inner.acceleration_max <= outer.acceleration_max && inner.jerk_min >= outer.jerk_min &&
         inner.jerk_max <= outer.jerk_max && inner.position_min >= outer.position_min &&
         inner.position_max <= outer.position_max;
}

/// True if neither velocity nor acceleration can change, or if no direction is permitted.
bool holds_still(const Bounds& b) {
  return b.acceleration_min == 0 || b.acceleration_max == 0 || b.jerk_min == 0 || b.jerk_max == 0 ||
         (b.velocity_min == 0 && b.velocity_max == 0);
}

}  // namespace

bool detours(const AxisMove& move, const Profile& plan, Judged judged) noexcept {
  const double share = judged == Judged::strictly ? strict_detour : loose_detour;
  if (move.goal == MoveGoal::velocity) {
    const double scale = std::abs(plan.start().velocity) + std::abs(plan.end().velocity);
    return turns_round(travelled_in_velocity(plan), share, digits * scale);
  }
  const double scale = std::abs(plan.start().position) + std::abs(plan.end().position);
  const double velocity = move.goal == MoveGoal::moving ? move.to.velocity : 0;
  return turns_round(travelled(plan, velocity), share, digits * scale);
}

MoveStatus OnlineAxis::set_state(const MotionState& state) noexcept {
  const MoveStatus status = status_of(state, state, within(1e50));
  if (status == MoveStatus::not_finite) return status;
  plan_ = Profile(state, 3);
  duration_ = elapsed_ = 0;
  now_ = {state.position, state.velocity, state.acceleration, 0};
  passed_ = false;
  purpose_ = Purpose::stop;
  changed_ = true;
  return MoveStatus::ok;
}

MoveStatus OnlineAxis::set_target(MoveGoal goal, const MotionState& target) noexcept {
  const MoveStatus status = status_of(target, target, within(1e50));
  if (status == MoveStatus::not_finite) return status;
  const bool same = goal == goal_ && target == target_ && goal != MoveGoal::moving;
  goal_ = goal;
  target_ = target;
  if (goal == MoveGoal::moving) target_.acceleration = 0;
  age_ = 0;
  changed_ = changed_ || !same;
  return MoveStatus::ok;
}

MoveStatus OnlineAxis::set_bounds(const Bounds& bounds) noexcept {
  if (bounded_ && bounds == bounds_) return MoveStatus::ok;
  const MoveStatus status = status_of({}, {}, where_zero(bounds, within(1, 1, 1)));
  if (status != MoveStatus::ok) return status;
  bounds_ = bounds;
  if (!bounded_) in_force_ = where_zero(bounds, mirrored(bounds));
  bounded_ = changed_ = true;
  return MoveStatus::ok;
}

void OnlineAxis::set_enabled(bool enabled) noexcept {
  changed_ = changed_ || enabled != enabled_;
  enabled_ = enabled;
}

void OnlineAxis::set_tolerance(double position, double velocity) noexcept {
  position_tolerance_ = std::max(0.0, position);
  velocity_tolerance_ = std::max(0.0, velocity);
  changed_ = true;
}

bool OnlineAxis::must_stop() const noexcept {
  if (!enabled_ || holds_still(bounds_)) return true;
  const double v = now_.velocity;
  return (bounds_.velocity_max == 0 && v > -at_rest * in_force_.velocity_min) ||
         (bounds_.velocity_min == 0 && v < -at_rest * in_force_.velocity_max);
}

bool OnlineAxis::arrived() const noexcept {
  const bool there = ended() || (passed_ && aim_goal_ == MoveGoal::state);
  return !enabled_ || (purpose_ == Purpose::goal && status_ == MoveStatus::ok && there) ||
         (!bounded_ && !has_goal());
}

MotionState OnlineAxis::target_now() const noexcept {
  MotionState t = target_;
  if (goal_ == MoveGoal::moving) t.position += age_ * t.velocity;
  return t;
}

/// True if the plan leads to the target, within the tolerance.
bool OnlineAxis::is_aimed() const noexcept {
  if (goal_ != aim_goal_) return false;
  const MotionState t = target_now();
  if (!agree(t.velocity, aim_.velocity, velocity_tolerance_)) return false;
  if (!agree(t.acceleration, aim_.acceleration, 0)) return false;
  if (goal_ == MoveGoal::velocity) return true;
  const double moved = goal_ == MoveGoal::moving ? elapsed_ * aim_.velocity : 0;
  const double rounding = digits * std::abs(plan_.start().position) + drift * std::abs(moved);
  return agree(t.position, aim_.position + moved, position_tolerance_ + rounding);
}

/// A plan that also keeps narrower bounds remains the best one, because they only exclude other
/// plans.
bool OnlineAxis::fits_bounds() noexcept {
  if (bounds_ == asked_) return true;
  if (!lies_in(bounds_, in_force_) || !keeps(rest_of_plan(), bounds_)) return false;
  asked_ = in_force_ = bounds_;
  return true;
}

/// True if the target no longer needs the wider limits that were kept for it.
bool OnlineAxis::may_narrow() const noexcept {
  if (wider(bounds_) == bounds_ || ended() || must_stop()) return false;
  const double v = now_.velocity;
  const double released = order_of(bounds_) == 3 ? natural_velocity(state(), bounds_) : v;
  if (std::max(v, released) > bounds_.velocity_max || std::min(v, released) < bounds_.velocity_min)
    return false;
  const AxisMove narrow = towards_goal(bounds_);
  Profile plan;
  return AxisTask(narrow).status() == MoveStatus::ok &&
         AxisTask(narrow).shortest(plan) == MoveStatus::ok &&
         !detours(narrow, plan, Judged::strictly);
}

bool OnlineAxis::is_stale() noexcept {
  if (!bounded_) return false;
  if (changed_) status_ = MoveStatus::ok;
  if (must_stop()) return changed_ || purpose_ != Purpose::stop;
  if (purpose_ == Purpose::stop && again_ && ended()) {
    again_ = false;
    status_ = MoveStatus::ok;
  }
  if (purpose_ == Purpose::stop) return changed_ || (ended() && status_ == MoveStatus::ok);
  if (changed_) {
    if (!is_aimed() || !fits_bounds()) return true;
    changed_ = false;
  }
  return may_narrow();
}

/// The wider of both bounds: acceleration and jerk are those of the present motion if these are
/// greater.
Bounds OnlineAxis::wider(const Bounds& bounds) const noexcept {
  Bounds b = bounds;
  b.acceleration_min = std::min(b.acceleration_min, in_force_.acceleration_min);
  b.acceleration_max = std::max(b.acceleration_max, in_force_.acceleration_max);
  b.jerk_min = std::min(b.jerk_min, in_force_.jerk_min);
  b.jerk_max = std::max(b.jerk_max, in_force_.jerk_max);
  return b;
}

bool OnlineAxis::can_widen() const noexcept {
  return !ended() && wider(bounds_) != bounds_ && order_of(wider(bounds_)) == order_of(bounds_);
}

AxisMove OnlineAxis::towards_goal(const Bounds& bounds) const noexcept {
  AxisMove m{state(), target_now(), where_zero(bounds, mirrored(bounds)), goal_};
  if (goal_ == MoveGoal::state && passed_ && is_aimed()) m.goal = MoveGoal::velocity;
  if (m.goal == MoveGoal::velocity)
    m.to.velocity = std::clamp(m.to.velocity, bounds.velocity_min, bounds.velocity_max);
  return m;
}

AxisMove OnlineAxis::move(bool widened) const noexcept {
  const AxisMove narrow = towards_goal(bounds_);
  if (!can_widen()) return narrow;
  const AxisMove wide = towards_goal(wider(bounds_));
  if (widened) return wide;
  Profile plan;
  if (AxisTask(narrow).status() != MoveStatus::ok ||
      AxisTask(narrow).shortest(plan) != MoveStatus::ok || !detours(narrow, plan, Judged::strictly))
    return narrow;
  const bool helps =
      AxisTask(wide).shortest(plan) == MoveStatus::ok && !detours(wide, plan, Judged::mildly);
  return helps ? wide : narrow;
}

AxisMove OnlineAxis::stopping(bool widened) const noexcept {
  const Bounds bounds = where_zero(bounds_, in_force_);
  AxisMove m{state(), {}, bounds, MoveGoal::velocity};
  m.bounds.position_min = -Bounds::none;
  m.bounds.position_max = Bounds::none;
  if (wider(bounds) == bounds) return m;
  AxisMove wide = m;
  wide.bounds = wider(m.bounds);
  if (widened) return wide;
  Profile plan;
  const auto turns = [&](const AxisMove& move, Judged judged) {
    return AxisTask(move).shortest(plan) != MoveStatus::ok || detours(move, plan, judged);
  };
  return turns(m, Judged::strictly) && !turns(wide, Judged::mildly) ? wide : m;
}

bool OnlineAxis::permits(const Profile& plan) const noexcept {
  if (bounds_.velocity_min != 0 && bounds_.velocity_max != 0) return true;
  const double v = plan.order() > 1 ? plan.start().velocity : 0;
  const Travel speed = travelled_in_velocity(plan);
  const double rounding = rounded_sum * (std::abs(speed.lowest) + std::abs(speed.highest));
  return (bounds_.velocity_max != 0 || v + speed.highest <= rounding) &&
         (bounds_.velocity_min != 0 || v + speed.lowest >= -rounding);
}

void OnlineAxis::follow(const AxisMove& move, const Profile& plan, Purpose purpose) noexcept {
  plan_ = plan;
  duration_ = plan.duration();
  elapsed_ = 0;
  asked_ = bounds_;
  in_force_ = move.bounds;
  purpose_ = purpose;
  changed_ = bent_ = false;
}

void OnlineAxis::go(const AxisMove& move, const Profile& plan) noexcept {
  passed_ = passed_ && move.goal != goal_;
  aim_ = target_now();
  aim_goal_ = goal_;
  status_ = MoveStatus::ok;
  follow(move, plan, Purpose::goal);
}

void OnlineAxis::refuse(MoveStatus why) noexcept {
  status_ = why;
  changed_ = stale_ = false;
  halts_ = purpose_ == Purpose::goal && !keeps(rest_of_plan(), bounds_);
}

void OnlineAxis::halt(MoveStatus why) noexcept {
  status_ = why;
  stale_ = false;
  halts_ = true;
}

void OnlineAxis::reconsider() noexcept {
  if (status_ == MoveStatus::ok) return;
  status_ = MoveStatus::ok;
  stale_ = !must_stop();
}

void OnlineAxis::stop(const AxisMove& move, const Profile& plan) noexcept {
  halts_ = passed_ = false;
  again_ = status_ == MoveStatus::not_straight;
  follow(move, plan, Purpose::stop);
}

Motion OnlineAxis::at(double elapsed) const noexcept {
  if (elapsed < duration_) return plan_.at(elapsed);
  const MotionState& end = plan_.end();
  return {end.position + (elapsed - duration_) * end.velocity, end.velocity, 0, 0};
}

bool OnlineAxis::runs_out(double dt) const noexcept {
  if (!bounded_ || purpose_ == Purpose::stop || plan_.end().velocity == 0 ||
      !limits_position(bounds_))
    return false;
  const Motion next = at(elapsed_ + dt);
  const MotionState start = state_of(next);
  AxisMove m{start, {}, in_force_, MoveGoal::velocity};
  Profile plan;
  return AxisTask(m).shortest(plan) == MoveStatus::position_limit;
}

void OnlineAxis::advance(double dt) noexcept {
  age_ += dt;
  elapsed_ += dt;
  if (std::abs(elapsed_ - duration_) <= same_instant * dt) elapsed_ = duration_;
  if (ended() && purpose_ == Purpose::goal && aim_goal_ == MoveGoal::state)
    passed_ = passed_ || aim_.velocity != 0 || aim_.acceleration != 0;
  if (ended() && plan_.end().acceleration != 0) {  // released: continues at its velocity
    const double late = elapsed_ - duration_;
    const AxisMove m{plan_.end(), {0, plan_.end().velocity, 0}, in_force_, MoveGoal::velocity};
    Profile on;
    (void)AxisTask(m).shortest(on);
    plan_ = on;
    duration_ = on.duration();
    elapsed_ = late;
  }
  now_ = at(elapsed_);
}

}  // namespace jounce::profiles_detail
