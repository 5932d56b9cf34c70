// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/solver/axis_task.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "profiles/src/solver/even_rest.hpp"
#include "profiles/src/solver/rest_to_rest.hpp"
#include "profiles/src/solver/solver.hpp"
#include "profiles/src/solver/span.hpp"
#include "profiles/src/solver/tolerances.hpp"
#include "profiles/src/solver/travel.hpp"

namespace jounce::profiles_detail {
namespace {

MotionState lowered(const MotionState& s) {
  return {s.velocity, s.acceleration, 0};
}

/// The bounds without position limits, for a change of velocity: the fastest change exceeds the
/// velocity limits no more than necessary.
Bounds lowered(const Bounds& b) {
  Bounds low;
  low.velocity_min = b.acceleration_min;
  low.velocity_max = b.acceleration_max;
  low.acceleration_min = b.jerk_min;
  low.acceleration_max = b.jerk_max;
  return low;
}

MotionState less(const MotionState& s, const MotionState& target) {
  return {s.position - target.position, s.velocity - target.velocity, s.acceleration};
}

/// The phases of a change of velocity, one order higher: as those of a motion.
Profile raised(const Profile& change, const MotionState& from, const MotionState& to) {
  Profile p(from, change.order() + 1);
  for (std::size_t i = 0; i < change.phases(); ++i)
    p.add(change.phase(i).duration, change.phase(i).value);
  const double covered = travelled(p).distance;
  p.finish({from.position + covered, to.velocity, to.acceleration});
  return p;
}

/// Converts a motion from the coordinates of a target that moves at `velocity`.
Profile unmoved(const Profile& relative, const MotionState& from, const MotionState& target) {
  const double t = relative.duration();
  const MotionState end{target.position + t * target.velocity, target.velocity, 0};
  if (relative.order() > 1) return relative.scaled(1, from, end);
  Profile p(from, 1);
  for (std::size_t i = 0; i < relative.phases(); ++i)
    p.add(relative.phase(i).duration, relative.phase(i).value + target.velocity);
  p.finish(end);
  return p;
}

EvenRest even_rest(const AxisMove& axis) {
  return {axis.from, axis.to, axis.bounds};
}

}  // namespace

AxisMove posed(const AxisMove& axis) noexcept {
  AxisMove m = axis;
  if (axis.goal == MoveGoal::velocity) {
    m.from = lowered(axis.from);
    m.to = lowered(axis.to);
    m.bounds = lowered(axis.bounds);
  }
  if (axis.goal == MoveGoal::moving) {
    const double w = axis.to.velocity;
    m.from = less(axis.from, axis.to);
    m.to = {};
    m.bounds.velocity_min -= w;
    m.bounds.velocity_max -= w;
    m.bounds.position_min = -Bounds::none;
    m.bounds.position_max = Bounds::none;
  }
  return m;
}

MoveStatus answered(const AxisMove& axis, const Profile& solved, Profile& out) noexcept {
  out = axis.goal == MoveGoal::velocity ? raised(solved, axis.from, axis.to)
        : axis.goal == MoveGoal::moving ? unmoved(solved, axis.from, axis.to)
                                        : solved;
  if (axis.goal == MoveGoal::state) return MoveStatus::ok;
  const Travel travel = travelled(out);
  const double slack = 0x1p-46 * (std::abs(out.start().position) + std::abs(out.end().position));
  const double lowest = std::min(axis.bounds.position_min, axis.from.position) - slack;
  const double highest = std::max(axis.bounds.position_max, axis.from.position) + slack;
  const bool keeps = axis.from.position + travel.lowest >= lowest &&
                     axis.from.position + travel.highest <= highest;
  return keeps ? MoveStatus::ok : MoveStatus::position_limit;
}

/// True if the goal is a velocity and the velocity may step.
bool AxisTask::steps() const noexcept {
  return axis_.goal == MoveGoal::velocity && order_of(axis_.bounds) == 1;
}

MoveStatus AxisTask::status() const noexcept {
  if (form_ != Form::any) return MoveStatus::ok;
  if (!posed_) return status_of(axis_.from, axis_.to, axis_.bounds);
  const MotionState to{axis_.from.position, axis_.to.velocity,
                       axis_.goal == MoveGoal::moving ? 0 : axis_.to.acceleration};
  const MoveStatus asked = status_of(axis_.from, to, axis_.bounds);
  if (asked != MoveStatus::ok || steps()) return asked;
  const Bounds& b = posed_->bounds;  // a target as fast as the limit cannot be caught up with
  if (axis_.goal == MoveGoal::moving && !(b.velocity_min < 0 && b.velocity_max > 0))
    return MoveStatus::target_outside;
  return status_of(posed_->from, posed_->to, b);
}

Solver AxisTask::solver() const noexcept {
  const AxisMove& m = posed_ ? *posed_ : axis_;
  return {m.from, m.to, m.bounds};
}

/// Converts a solution from the coordinates of the goal.
MoveStatus AxisTask::answer(MoveStatus solved, Profile& out) const noexcept {
  if (!posed_ || solved != MoveStatus::ok) return solved;
  const Profile profile = out;
  return answered(axis_, profile, out);
}

Durations AxisTask::durations() const noexcept {
  if (steps()) return {};
  Durations d = solver().durations();
  if (axis_.under_way) d.minimum = std::min(d.minimum, axis_.under_way->duration());
  return d;
}

MoveStatus AxisTask::shortest(Profile& out) const noexcept {
  if (inside_) {
    ::new (&out) Profile(inside_->shortest(axis_.from, axis_.to));
    return MoveStatus::ok;
  }
  if (profiles_detail::shortest(form_, axis_.from, axis_.to, axis_.bounds, out))
    return MoveStatus::ok;
  if (steps()) return lasting(0, out);
  const MoveStatus status = solver().shortest(out);
  const Profile* kept = axis_.under_way;
  const bool is_kept = kept && (status != MoveStatus::ok ||
                                kept->duration() <= out.duration() * (1 + same_duration));
  if (!is_kept) return answer(status, out);
  out = *kept;
  return MoveStatus::ok;
}

/// Begins a motion between both states, without phases.
void AxisTask::begin(Profile& out) const noexcept {
  ::new (&out) Profile(axis_.from, axis_.to, 3, {}, {});
}

/// Estimates a duration: the times to stop from the start's velocity and to reach the target's
/// velocity, both without jerk limits, plus the duration of a motion from rest to rest in between,
/// with the same limits in both directions.
double AxisTask::about() const noexcept {
  const Bounds& b = axis_.bounds;
  const double per_a = 1 / b.acceleration_max;
  const double v0 = axis_.from.velocity;
  const double vf = axis_.to.velocity;
  const double d =
      axis_.to.position - axis_.from.position - (v0 * std::abs(v0) + vf * std::abs(vf)) * per_a / 2;
  const double ends = std::copysign((v0 + vf) * per_a, (v0 + vf) * d);
  const Rates<double> rates(b.acceleration_max, b.jerk_max);
  return rest_way(rates, std::abs(d), b.velocity_max).duration - ends;
}

bool AxisTask::cruises(double t, Profile& out) const noexcept {
  if (form_ == Form::even_rest) {
    EvenCourse c;
    if (!even_rest(axis_).lasting(t, c) || !(c.cruise > 0x1p-20 * t)) return false;
    ::new (&out) Profile(profile_of(c, axis_.bounds.jerk_max, axis_.from, axis_.to));
    return true;
  }
  if (form_ == Form::rest_to_rest) {
    RestToRest move(axis_.to.position - axis_.from.position, axis_.bounds);
    if (!move.solve_lasting(t) || !(move.cruise() > 0x1p-20 * t)) return false;
    ::new (&out) Profile(move.profile(axis_.from, axis_.to));
    return true;
  }
  begin(out);
  return inside_->cruises(t, out);
}

MoveStatus AxisTask::lasting(double t, Profile& out) const noexcept {
  if (form_ == Form::even_rest) {
    if (EvenCourse c; even_rest(axis_).lasting(t, c)) {
      ::new (&out) Profile(profile_of(c, axis_.bounds.jerk_max, axis_.from, axis_.to));
      return MoveStatus::ok;
    }
  }
  if (form_ == Form::rest_to_rest) {
    RestToRest move(axis_.to.position - axis_.from.position, axis_.bounds);
    if (move.solve_lasting(t)) {
      ::new (&out) Profile(move.profile(axis_.from, axis_.to));
      return MoveStatus::ok;
    }
  }
  if (inside_) {
    begin(out);
    return inside_->lasting(t, out) ? MoveStatus::ok : MoveStatus::blocked;
  }
  if (axis_.under_way && std::abs(axis_.under_way->duration() - t) <= same_duration * t) {
    out = *axis_.under_way;
    return MoveStatus::ok;
  }
  if (!steps()) return answer(solver().lasting(t, out), out);
  out = Profile({axis_.from.position, axis_.to.velocity, 0}, 1);
  out.add(t, axis_.to.velocity);
  out.finish({axis_.from.position + t * axis_.to.velocity, axis_.to.velocity, 0});
  return MoveStatus::ok;
}

}  // namespace jounce::profiles_detail
