// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/solver/solver.hpp"

#include <algorithm>

#include "profiles/src/solver/brake.hpp"
#include "profiles/src/solver/rest_to_rest.hpp"
#include "profiles/src/solver/second_order.hpp"
#include "profiles/src/solver/velocity_change.hpp"

namespace jounce::profiles_detail {
namespace {

/// In the first two orders the state has no acceleration, in the first also no velocity.
MotionState of_order(const MotionState& s, int order) {
  return {s.position, order > 1 ? s.velocity : 0, order > 2 ? s.acceleration : 0};
}

/// True if no reversal is outside the position limits.
bool keeps_positions(const Profile& profile, const Bounds& b) {
  if (!limits_position(b)) return true;
  const double start = profile.start().position;
  const double end = profile.end().position;
  const double slack = 0x1p-46 * (std::abs(start) + std::abs(end));
  const double min = b.position_min - slack;
  const double max = b.position_max + slack;
  const auto ok = [&](double p) { return p >= min && p <= max; };
  if (!ok(end)) return false;
  // A start outside may only return; this does not count as a violation.
  double t = 0;
  for (std::size_t i = 0; i < profile.phases(); ++i) {
    const auto [length, value] = profile.phase(i);
    const Motion m = profile.at(t);
    if (i > 0 && !ok(m.position)) return false;
    const double j = profile.order() == 3 ? value : 0;
    const double a = profile.order() == 2 ? value : m.acceleration;
    // v + a u + j u^2/2 = 0
    const double w = a * a - 2 * m.velocity * j;
    if (w >= 0) {
      const double q = -(a + std::copysign(std::sqrt(w), a));
      for (const double u : {j != 0 ? q / j : -1, q != 0 ? 2 * m.velocity / q : -1})
        if (u > 0 && u < length && !ok(profile.at(t + u).position)) return false;
    }
    t += length;
  }
  return true;
}

}  // namespace

Solver::Solver(const MotionState& from, const MotionState& to, const Bounds& bounds,
               bool keeps_braking) noexcept
    : order_(order_of(bounds)),
      bounds_(bounds),
      start_(of_order(from, order_)),
      to_(of_order(to, order_)),
      asked_(to),
      inside_(start_) {
  if (order_ == 1 || start_ == to_ || (order_ == 3 && is_inside(start_, bounds_, 0))) return;
  if (order_ == 3 && keeps_braking) {
    const Braking braking = braking_under_way(start_, to_, bounds_);
    extended_ = braking.limit != 0;
    if (extended_) bounds_ = extended(bounds_, braking.limit);
    hold_ = braking.hold;
  }
  Profile p(start_, order_);
  inside_ = begin(p);
  before_ = p.duration();
  if (order_ == 3) look_on_the_way_out();
}

/// The velocity is monotone up to a target that leaves the limits as the start does, so it stays
/// inside.
void Solver::look_on_the_way_out() noexcept {
  const int side = runs_out(to_, bounds_);
  if (side == 0 || side * to_.acceleration <= 0) return;
  Profile p(start_, order_);
  leaving_ = acceleration_inside(start_, bounds_, p);
  const double limit = side > 0 ? bounds_.velocity_max : -bounds_.velocity_min;
  meets_ = side * leaving_.acceleration > 0 && side * leaving_.velocity <= limit &&
           runs_out(leaving_, bounds_) == side && on_the_way_out().has_early();
}

/// The beginning of a motion that reaches the target before it leaves the limits.
Profile Solver::led_out() const noexcept {
  Profile p(start_, order_);
  (void)acceleration_inside(start_, bounds_, p);
  p.finish(asked_);
  return p;
}

MotionState Solver::begin(Profile& profile) const noexcept {
  if (order_ == 2) {
    const Slowed s = slowed(start_, bounds_);
    profile.add(s.time, s.acceleration);
    return s.state;
  }
  const double t = hold_;
  profile.add(t, 0);
  const auto [p, v, a] = start_;
  const MotionState held{p + t * (v + t * (a / 2)), v + t * a, a};
  return begin_inside(held, bounds_, profile);
}

/// The common beginning, to which phases can be appended.
Profile Solver::begun() const noexcept {
  Profile p(start_, order_);
  if (before_ > 0) (void)begin(p);
  p.finish(asked_);
  return p;
}

/// A motion that lasts longer than the shortest may need all of the present braking in order not to
/// reverse.
Solver Solver::with_all_braking() const noexcept {
  return {start_, asked_, extended(bounds_, start_.acceleration)};
}

double Solver::minimum() const noexcept {
  return meets_ ? led_out().duration() + on_the_way_out().minimum() : minimum_inside();
}

/// True if this is a task of RestToRest.
bool Solver::rests() const noexcept {
  const auto at_rest = [](const MotionState& s) { return s.velocity == 0 && s.acceleration == 0; };
  return order_ == 3 && at_rest(start_) && at_rest(to_) && start_.position != to_.position;
}

double Solver::minimum_inside() const noexcept {
  if (rests()) {
    RestToRest move(to_.position - start_.position, bounds_);
    if (move.solve_shortest()) return move.profile(start_, asked_).duration();
  }
  if (order_ == 3 && before_ == 0) return PointToPoint(inside_, to_, bounds_).minimum();
  if (order_ == 3) {  // added up like the phases of the motion itself
    Profile motion = begun();
    PointToPoint(inside_, to_, bounds_).append_shortest(motion);
    return motion.duration();
  }
  if (order_ == 2) return before_ + SecondOrder(inside_, to_, bounds_).minimum();
  const double distance = to_.position - inside_.position;
  return distance / (distance > 0 ? bounds_.velocity_max : bounds_.velocity_min);
}

Durations Solver::durations() const noexcept {
  if (rests()) return {.minimum = minimum()};
  const Durations inside = durations_inside();
  if (!meets_) return inside;
  const double before = led_out().duration();
  Durations d = on_the_way_out().early_durations();
  d.minimum += before;
  for (std::size_t i = 0; i < d.count; ++i)
    d.blocked[i] = {d.blocked[i].from + before, d.blocked[i].to + before};
  d.blocked[d.count - 1].to = inside.minimum;
  for (std::size_t i = 0; i < inside.count; ++i) block(inside.blocked[i], d);
  return d;
}

/// The durations of the motions that first return inside the bounds.
Durations Solver::durations_inside() const noexcept {
  Durations d;
  if (extended_) {
    d = with_all_braking().durations();
    const double shortest = minimum_inside();
    // For a target at rest, no other durations are blocked.
    if (d.minimum > shortest && d.count == 0) d.blocked[d.count++] = {shortest, d.minimum};
    d.minimum = shortest;
    return d;
  }
  if (order_ == 3) d = PointToPoint(inside_, to_, bounds_).durations();
  if (order_ == 2) d = SecondOrder(inside_, to_, bounds_).durations();
  d.minimum = order_ == 2 ? d.minimum + before_ : minimum_inside();
  for (auto& interval : d.blocked) interval = {interval.from + before_, interval.to + before_};
  return d;
}

void Solver::straight(double t, Profile& out) const noexcept {
  if (t > 0) out.add(t, (to_.position - inside_.position) / t);
}

MoveStatus Solver::shortest(Profile& out) const noexcept {
  if (rests()) {
    RestToRest move(to_.position - start_.position, bounds_);
    if (move.solve_shortest()) {
      out = move.profile(start_, asked_);
      return checked(out);
    }
  }
  if (meets_) {
    out = led_out();
    if (!(leaving_ == to_)) on_the_way_out().append_shortest(out);
  } else if (order_ == 3 && before_ == 0 && !(inside_ == to_)) {
    out = PointToPoint(inside_, to_, bounds_).shortest(start_, asked_);
  } else {
    out = begun();
    if (inside_ == to_) return MoveStatus::ok;
    if (order_ == 3) PointToPoint(inside_, to_, bounds_).append_shortest(out);
    if (order_ == 2) SecondOrder(inside_, to_, bounds_).shortest(out);
    if (order_ == 1) straight(minimum(), out);
  }
  if (keeps_positions(out, bounds_) || by_way_of_rest(out)) return MoveStatus::ok;
  return MoveStatus::position_limit;
}

MoveStatus Solver::checked(Profile& out) const noexcept {
  return keeps_positions(out, bounds_) ? MoveStatus::ok : MoveStatus::position_limit;
}

MoveStatus Solver::lasting(double t, Profile& out) const noexcept {
  if (rests()) {
    RestToRest move(to_.position - start_.position, bounds_);
    if (move.solve_lasting(t)) {
      out = move.profile(start_, asked_);
      return checked(out);
    }
  }
  if (extended_) return with_all_braking().lasting(t, out);
  if (meets_) {
    out = led_out();
    const double before = out.duration();
    const PointToPoint way = on_the_way_out();
    if (way.early_durations().allows(t - before) && way.lasting(t - before, out))
      return checked(out);
  }
  out = begun();
  bool possible = true;
  if (order_ == 3) possible = PointToPoint(inside_, to_, bounds_).lasting(t - before_, out);
  if (order_ == 2) possible = SecondOrder(inside_, to_, bounds_).lasting(t - before_, out);
  if (order_ == 1) straight(t, out);
  return possible ? checked(out) : MoveStatus::blocked;
}

namespace {

/// Appends the phases of a part; returns false if there is no space for them.
bool append(const Profile& part, Profile& whole) {
  if (whole.phases() + part.phases() > Profile::capacity) return false;
  for (std::size_t i = 0; i < part.phases(); ++i)
    whole.add(part.phase(i).duration, part.phase(i).value);
  return true;
}

/// The bounds of the same motion backwards in time.
Bounds backwards(const Bounds& b) {
  return {-b.velocity_max, -b.velocity_min, b.acceleration_min, b.acceleration_max,
          -b.jerk_max,     -b.jerk_min,     -Bounds::none,      Bounds::none};
}

/// Bounds with a velocity so low that neither acceleration limit is reached on the way to it.
Bounds gentle(Bounds b) {
  const double a = std::min(b.acceleration_max, -b.acceleration_min);
  const double v = a * a * (1 / b.jerk_max - 1 / b.jerk_min) / 2;
  b.velocity_max = std::min(b.velocity_max, v);
  b.velocity_min = std::max(b.velocity_min, -v);
  return b;
}

}  // namespace

/// Used if position limits forbid the shortest motion. The farther back a point of rest is, the
/// harder the axis brakes on its way to it (or accelerates away from it). The function searches for
/// the nearest such point that keeps the limits, first on the start's side, then on the target's
/// side.
bool Solver::by_way_of_rest(Profile& out) const noexcept {
  Bounds free = bounds_;
  free.position_min = -Bounds::none;
  free.position_max = Bounds::none;
  const auto assembled = [&](const MotionState& rest, const Bounds& second, Profile& whole) {
    Profile there;
    Profile on;
    (void)Solver(start_, rest, free, false).shortest(there);
    (void)Solver(rest, to_, second).shortest(on);
    whole = Profile(start_, order_);
    whole.finish(asked_);
    return append(there, whole) && append(on, whole) && keeps_positions(whole, bounds_);
  };
  const auto by_way_of = [&](double position) {
    const MotionState rest{position, 0, 0};
    Profile whole;
    const bool fits =
        assembled(rest, free, whole) || (order_ == 3 && assembled(rest, gentle(free), whole));
    if (fits) out = whole;
    return fits;
  };
  Profile stop;
  (void)to_velocity(start_, 0, 0, free, stop);
  Profile run_up;  // a stop backwards in time
  (void)to_velocity({to_.position, -to_.velocity, to_.acceleration}, 0, 0, backwards(free), run_up);
  for (const Profile* side : {&stop, &run_up}) {
    const double nearest = side->end().position;
    const double back = side->start().position - nearest;
    double good = 0x1p-20;
    while (good < 8 && !by_way_of(nearest + good * back)) good *= 2;
    if (good >= 8 || back == 0) continue;
    for (double bad = good / 2, i = 0; i < 40; ++i) {
      const double share = (good + bad) / 2;
      (by_way_of(nearest + share * back) ? good : bad) = share;
    }
    return true;  // `out` contains the last valid motion, which is the nearest
  }
  return false;
}

MoveStatus to_velocity(const MotionState& from, double velocity, double acceleration,
                       const Bounds& bounds, Profile& out) noexcept {
  const int order = order_of(bounds);
  out = Profile(of_order(from, order), order);
  MotionState s = out.start();
  if (order == 3) {
    s = acceleration_inside(s, bounds, out);
    s = change_velocity(s, velocity, acceleration, bounds, out);
  }
  if (order == 2) {
    const double dv = velocity - s.velocity;
    const double a = dv > 0 ? bounds.acceleration_max : bounds.acceleration_min;
    out.add(dv / a, a);
    s = {s.position + dv / a * (s.velocity + velocity) / 2, velocity, 0};
  }
  out.finish({s.position, velocity, acceleration});
  return keeps_positions(out, bounds) ? MoveStatus::ok : MoveStatus::position_limit;
}

}  // namespace jounce::profiles_detail
