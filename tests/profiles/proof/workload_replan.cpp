// SPDX-License-Identifier: Apache-2.0
// The same motion asked for again: on the way, and in other units.
#include <algorithm>
#include <cmath>

#include "profiles/proof/judge.hpp"
#include "support/draw_until.hpp"

namespace jounce::proof {

namespace {

void replan(const Case& c, Random& r, Tally& tally) {
  const Solved s = solve(c, tally);
  if (!s || s.move.profile.phases() == 0) return;
  const double planned = s.move.profile.duration();
  const double now = planned * r.uniform(0, 1);
  const Motion at = s.move.profile.at(now);
  Case rest = c;
  rest.from = {at.position, at.velocity, c.bounds.jerk_max < Bounds::none ? at.acceleration : 0};
  const Solved again = solve(rest, tally);
  if (!again) return;
  const Real longer = (now + again.verdict.duration - planned) / planned;
  if (longer <= same) {
    tally.longer = std::max(tally.longer, static_cast<double>(longer));
    return;
  }
  // The state was rounded; is it that alone which makes it longer?
  const auto excused = [&](Real share) {
    return again.verdict.duration - minimum(reachable(rest, again.verdict, share)) <=
           same * planned;
  };
  if (excused(last_bit) || excused(-rounding))
    ++tally.ties;
  else
    tally.fail("replanned " + text(longer) + " longer", rest);
}

}  // namespace

namespace {

/// Any but those that are almost there from the start.
Case journey(Random& r) {
  return test::draw_until([&r] { return any(r); },
                          [](const Case& c) {
                            return std::abs(c.to.position - c.from.position) >
                                   1e-6 * std::abs(c.to.position);
                          });
}

}  // namespace

void replan_rest(Random& r, Tally& tally) {
  Case c = journey(r);
  c.to.velocity = c.to.acceleration = 0;
  replan(c, r, tally);
}

void replan_moving(Random& r, Tally& tally) {
  replan(journey(r), r, tally);
}

void replan_unequal(Random& r, Tally& tally) {
  replan(far_apart(r), r, tally);
}

namespace {

Case in_units(const Case& c, double length, double time) {
  const double v = length / time;
  const double a = v / time;
  const double j = a / time;
  const auto state = [&](const MotionState& s) {
    return MotionState{s.position * length, s.velocity * v, s.acceleration * a};
  };
  const Bounds& b = c.bounds;
  return {state(c.from),
          state(c.to),
          {b.velocity_min * v, b.velocity_max * v, b.acceleration_min * a, b.acceleration_max * a,
           b.jerk_min * j, b.jerk_max * j, b.position_min * length, b.position_max * length},
          {}};
}

}  // namespace

/// A change of units by a power of two changes no bit; by another factor it rounds the data, which
/// the durations may show as far as the problem's own condition amplifies it.
void invariance(Random& r, Tally& tally) {
  const Case c = any(r);
  const Solved s = solve(c, tally);
  if (!s) return;
  const int power = r.below(41) - 20;
  const Case twos = in_units(c, std::ldexp(1.0, power), 1);
  const MoveResult exact = move_to(twos.from, twos.to, twos.bounds);
  bool equal = bool(exact) && exact.profile.phases() == s.move.profile.phases();
  for (std::size_t i = 0; equal && i < exact.profile.phases(); ++i)
    equal = exact.profile.phase(i).duration == s.move.profile.phase(i).duration;
  if (!equal) tally.fail("not bit-identical in units 2^" + std::to_string(power), c);

  const double factors[] = {1, 1e3, 1e6, 1e-6};
  const double length = factors[r.below(4)];
  const double time = factors[r.below(4)];
  const Case scaled = in_units(c, length, time);
  if (!safe_target(scaled.to, scaled.bounds)) return;
  const Solved other = solve(scaled, tally);
  if (!other) return;
  const Real is = other.verdict.duration / time;
  const Real was = s.verdict.duration;
  if (std::abs(is - was) <= s.verdict.instant) return;
  const auto reference = [&](Real share) { return minimum(reachable(c, s.verdict, share)); };
  const Real lo = reference(rounding) * (1 - 1e-12L);
  const Real hi = reference(-rounding) * (1 + 1e-12L);
  if (is >= lo && is <= hi && was >= lo && was <= hi)
    ++tally.ties;
  else
    tally.fail("another duration in other units, " + text(is / was - 1) + ": length x " +
                   text(length) + ", time x " + text(time),
               c);
}

}  // namespace jounce::proof
