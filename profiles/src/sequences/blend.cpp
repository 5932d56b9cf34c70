// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/sequences/blend.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "profiles/src/solver/brake.hpp"

// D(e, w) is the distance over which the velocity changes from e to w as fast as possible, with
// zero acceleration at both ends. The ramp is point-symmetric about its middle. With its duration
// T(dv) and dv = |e - w|,
//
//   (1)  D(e, w) = (e + w)/2 T(dv)
//
// For w <= e it grows with e:      a move over L that must end at w may begin at up to the e with
//
//   (2)  D(e, w) = L.
//
// For w >= e it grows with w:      a move over L that begins at e may end at up to the w of (2).
// For w <= e it does *not* fall with w everywhere: without a plateau, T = 2 sqrt(dv/j),
//
//   (3)  dD/dw = (e - 3 w) / (2 sqrt(j (e - w)))
//
// So stopping takes less distance than slowing to e/3. The code below relies only on the two
// monotonies before (3), and tests whether a velocity is reachable.
//
// If the start has an acceleration (only the first move of a batch), the axis first goes to
//
//   (4)  n = v + a |a| / (2 j)
//
// (natural_velocity() in solver/brake.hpp). From there it behaves like e = n, a constant distance
// later.
//
// A reversal changes the sign of the direction, and so exchanges acceleration and deceleration. If
// they are equal, the same bounds hold in both directions and the reversal is one move. If they
// differ, the axis stops with its deceleration and moves back from rest, as with_target()
// (dynamics.hpp) does.

namespace jounce::profiles_detail {
namespace {

constexpr double rounded_length = 0x1p-48;  ///< relative error of a length
/// A ramp that exceeds a length by a smaller share almost fits it.
constexpr double little = 0x1p-10;

/// The last v from `holds` towards `fails` that satisfies the condition, to 2^-64 of their
/// distance. The number of bisections is fixed, so the result is the same in every unit.
template <class Predicate>
double last_that_holds(double holds, double fails, const Predicate& predicate) {
  for (int i = 0; i < 64; ++i) {
    const double middle = holds + (fails - holds) / 2;
    if (middle == holds || middle == fails) break;
    (predicate(middle) ? holds : fails) = middle;
  }
  return holds;
}

Profile solved_command(const MoveResult& move) {
  if (!move) throw InputError("commands", "", explain(move.status));
  return move.profile;
}

double ramp_length(const MotionState& from, double velocity, const Bounds& bounds) {
  return ramp({0, from.velocity, from.acceleration}, velocity, bounds).end().position;
}

double ramp_length(double from, double velocity, const Bounds& bounds) {
  return ramp_length({0, from, 0}, velocity, bounds);
}

/// Ends the profile exactly at its target, without rounding.
Profile finished(Profile profile, double target, double velocity) {
  profile.finish({target, velocity, 0});
  return profile;
}

/// A ramp to u, a cruise at u, and a ramp to the exit velocity. u is the given velocity or, if that
/// is not possible, the nearest possible one. From a start without acceleration this is the
/// shortest motion. It exists if one ramp to the exit velocity is possible.
///
///   (5)  D(from, u) + D(u, exit) <= L
std::vector<Profile> by_ramps(const MotionState& from, double target, double exit, double velocity,
                              const Bounds& bounds) {
  const double length = target - from.position;
  const auto rest = [&](double u) {  // (5)
    return length - ramp_length(from, u, bounds) - ramp_length(u, exit, bounds);
  };
  const auto fits = [&](double u) { return rest(u) >= 0; };
  const double settled = std::max(natural_velocity(from, bounds), 0.0);
  const double u =
      fits(velocity) ? velocity : last_that_holds(fits(settled) ? settled : exit, velocity, fits);
  const MotionState end{target - ramp_length(u, exit, bounds), u, 0};
  const MotionState begin{end.position - rest(u), u, 0};
  Profile cruise(begin, 3);
  if (u > 0 && rest(u) > rounded_length * length) cruise.add(rest(u) / u, 0);
  return {finished(ramp(from, u, bounds), begin.position, u), finished(cruise, end.position, u),
          finished(ramp(end, exit, bounds), target, exit)};
}

}  // namespace

namespace {

double jerk_limit(const Dynamics& d) {
  return d.jerk == 0 ? Bounds::none : d.jerk;
}

Bounds with_swapped_acceleration(Bounds b) {
  b.acceleration_min = -std::exchange(b.acceleration_max, -b.acceleration_min);
  return b;
}

/// The error of a distance by rounding of the positions at its ends.
double position_rounding(const MotionState& from, double target) {
  return rounded_length * std::max(std::abs(from.position), std::abs(target));
}

}  // namespace

Bounds forward(const Dynamics& d) {
  Bounds bounds = within(d.velocity, d.acceleration, jerk_limit(d));
  if (d.deceleration != 0) bounds.acceleration_min = -d.deceleration;
  return bounds;
}

bool runs_backwards(const MotionState& from, const Dynamics& dynamics) {
  return std::min(from.velocity, natural_velocity(from, forward(dynamics))) < 0;  // (4)
}

bool stops_to_turn(const Dynamics& d) {
  return d.deceleration != 0 && d.deceleration != d.acceleration;
}

Profile ramp(const MotionState& from, double velocity, const Bounds& bounds) {
  Bounds free = bounds;
  free.velocity_min = -Bounds::none;
  free.velocity_max = Bounds::none;
  return solved_command(move_velocity(from, velocity, free));
}

Profile halt(const MotionState& from, const Dynamics& dynamics) {
  const Bounds bounds = forward(dynamics);
  const bool backwards = natural_velocity(from, bounds) < 0;
  return ramp(from, 0, backwards ? with_swapped_acceleration(bounds) : bounds);
}

double highest_entry(double length, double exit, double cap, const Bounds& bounds) {
  const auto fits = [&](double v) { return ramp_length(v, exit, bounds) <= length; };
  if (cap <= exit || fits(cap)) return cap;
  return last_that_holds(exit, cap, fits);  // (2)
}

Exit reachable_exit(const MotionState& from, double target, double wanted, double cap,
                    const Dynamics& dynamics) {
  const double length = target - from.position;
  const bool backwards = runs_backwards(from, dynamics);
  if (backwards && stops_to_turn(dynamics)) return {0, true};
  const Bounds bounds = forward(dynamics);
  const auto fits = [&](double v) { return ramp_length(from, v, bounds) <= length; };
  if (fits(wanted)) return {wanted, backwards};
  const double settled = std::max(natural_velocity(from, bounds), 0.0);
  // Too short for speeding up: (2). Too short for slowing down: passes faster if the next moves
  // permit that; otherwise stops there if (3) permits, or returns.
  const double nearest = settled < wanted ? settled : std::min(settled, cap);
  if (fits(nearest)) return {last_that_holds(nearest, wanted, fits), backwards};
  return {0, ramp_length(from, 0, bounds) > length + position_rounding(from, target)};
}

std::vector<Profile> between(const MotionState& from, double target, const Exit& exit,
                             const Dynamics& dynamics) {
  const Bounds bounds = forward(dynamics);
  const double length = target - from.position;
  const double spare = length - ramp_length(from, exit.velocity, bounds);
  if (spare <= rounded_length * length && spare >= -position_rounding(from, target))
    return {finished(ramp(from, exit.velocity, bounds), target, exit.velocity)};
  const double fastest = std::max({from.velocity, natural_velocity(from, bounds), exit.velocity});
  const bool fits = spare > 0 && fastest > 0;
  if (fits && (fastest > dynamics.velocity || spare < little * length))
    return by_ramps(from, target, exit.velocity, dynamics.velocity, bounds);
  return {solved_command(move_to(from, {target, exit.velocity, 0}, bounds))};
}

}  // namespace jounce::profiles_detail
