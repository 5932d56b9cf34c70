// SPDX-License-Identifier: Apache-2.0
// How long moves last, or may last, against the witness.
#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/extrema.hpp"

#include "profiles/proof/judge.hpp"

namespace jounce::proof {

namespace {

void expect_shortest(const Case& c, Tally& tally) {
  const Solved s = solve(c, tally);
  if (!s) return;
  compare(
      s.verdict.duration, [&](Real share) { return minimum(reachable(c, s.verdict, share)); }, c,
      tally);
}

}  // namespace

void optimality(Random& r, Tally& tally) {
  const char* const own[] = {"lowered", "leaving"};
  const int kind = r.below(16);
  expect_shortest(kind < 2 ? draw(own[kind], r) : any(r), tally);
}

void optimality_unequal(Random& r, Tally& tally) {
  expect_shortest(far_apart(r), tally);
}

namespace {

/// The witness's verdict on a duration, for data that are a little easier or harder.
struct Possible {
  bool easily = false, hardly = false;
};

Possible possible(const Case& c, const Verdict& shortest, double T) {
  return {contains(reachable(c, shortest, rounding), T),
          contains(reachable(c, shortest, -rounding), T)};
}

/// move_to of duration T succeeds exactly if it is possible, and Durations agrees. Where rounding
/// of the data decides, each of the two may answer either way: they use different formulas.
void ask(Case c, double T, const Durations& known, const Verdict& shortest, Tally& tally) {
  c.duration = T;
  ++tally.cases;
  const MoveResult move = move_to(c.from, c.to, c.bounds, T);
  if (move) tally.note(check(move.profile, c), c);
  const Possible is = possible(c, shortest, T);
  if (is.easily != is.hardly) {
    ++tally.ties;
    return;
  }
  const std::string truth = std::string("this duration is ") + (is.easily ? "" : "im") + "possible";
  if (is.easily != bool(move)) tally.fail(truth + ", move_to returns " + explain(move.status), c);
  if (is.easily != known.allows(T))
    tally.fail(truth + ", allows() returns " + (known.allows(T) ? "yes" : "no"), c);
}

/// An edge of Durations is itself possible if the durations beside it surely are.
void ask_edge(Case c, double T, int side, const Verdict& shortest, Tally& tally) {
  c.duration = T;
  ++tally.cases;
  const MoveResult move = move_to(c.from, c.to, c.bounds, T);
  if (move) tally.note(check(move.profile, c), c);
  if (!possible(c, shortest, T * (1 + side * same)).hardly)
    ++tally.ties;
  else if (!move)
    tally.fail(std::string("an edge is refused: ") + explain(move.status), c);
}

void ask_durations(const Case& c, Random& r, Tally& tally) {
  const Durations d = durations(c.from, c.to, c.bounds);
  const MoveResult move = move_to(c.from, c.to, c.bounds);
  if (d.status != MoveStatus::ok || !move) return tally.fail("refused", c);
  const Verdict shortest = check(move.profile, c);
  const double base = d.minimum > 0 ? d.minimum : 1;
  ask(c, base * (r.below(2) == 0 ? r.uniform(0, 3) : 1 + r.log_uniform(1e-6, 1e3)), d, shortest,
      tally);
  ask_edge(c, d.minimum, 1, shortest, tally);
  for (std::size_t i = 0; i < d.count; ++i) {
    const auto& [from, to] = d.blocked[i];
    ask(c, r.uniform(from, to), d, shortest, tally);
    ask_edge(c, from, -1, shortest, tally);
    ask_edge(c, to, 1, shortest, tally);
  }
}

}  // namespace

void exact(Random& r, Tally& tally) {
  ask_durations(any(r), r, tally);
}

void exact_unequal(Random& r, Tally& tally) {
  ask_durations(far_apart(r), r, tally);
}

namespace {

void expect_blocked(const Case& c, Tally& tally) {
  ++tally.cases;
  const Durations d = durations(c.from, c.to, c.bounds);
  const MoveResult move = move_to(c.from, c.to, c.bounds);
  if (d.status != MoveStatus::ok || !move) return tally.fail("refused", c);
  const Verdict shortest = check(move.profile, c);
  // The set that is known lies between the sets that slightly harder and easier data give.
  const std::vector<Span> hard = reachable(c, shortest, -rounding);
  const std::vector<Span> easy = reachable(c, shortest, rounding);
  const auto near = [](Real x, int side) { return x * (1 + side * Real{same}); };
  for (const Span& s : hard)
    for (const Real T : {near(s.from, 1), near(s.to, -1)})
      if (std::isfinite(T) && T >= near(s.from, 1) && T <= near(s.to, -1) &&
          !d.allows(static_cast<double>(T)))
        tally.fail("possible, but not allowed: " + text(T), c);
  for (std::size_t i = 0; i < easy.size(); ++i) {
    const Real before = i == 0 ? 0 : easy[i - 1].to;
    for (const Real T : {near(before, 1), near(easy[i].from, -1)})
      if (T > near(before, 1) * (1 - 1e-15L) && T < easy[i].from * (1 - same / 2) &&
          d.allows(static_cast<double>(T)))
        tally.fail("impossible, but allowed: " + text(T), c);
  }
}

}  // namespace

void blocks(Random& r, Tally& tally) {
  expect_blocked(any(r), tally);
}

void blocks_unequal(Random& r, Tally& tally) {
  expect_blocked(far_apart(r), tally);
}

namespace {

/// The velocity at which a state has the acceleration zero, before it or after it.
double natural(double v, double a, double rise, double fall) {
  return a > 0 ? v + a * a / (2 * fall) : v - a * a / (2 * rise);
}

/// Between the velocities of its ends, and what their accelerations make unavoidable.
void expect_monotone(const Case& c, const Profile& f, const Verdict& verdict, Tally& tally) {
  const Bounds& b = c.bounds;
  const auto& [p0, v0, a0] = c.from;
  const auto& [p1, v1, a1] = c.to;
  const double n0 = natural(v0, a0, b.jerk_max, -b.jerk_min);
  const double n1 = natural(v1, -a1, b.jerk_max, -b.jerk_min);  // against time
  const auto [lo, hi] = std::minmax({v0, v1, n0, n1});
  const double slack = tolerance * static_cast<double>(verdict.scale.velocity);
  if (f.phases() == 0) return;
  const Range range = extrema(f.curve(), 1);
  if (range.min.value < lo - slack || range.max.value > hi + slack)
    tally.fail("the velocity goes from " + text(range.min.value) + " to " + text(range.max.value) +
                   ", not monotone",
               c);
}

}  // namespace

void velocity(Random& r, Tally& tally) {
  Case c = r.below(8) == 0 ? draw("leaving", r) : any(r);
  if (!std::isfinite(c.bounds.acceleration_max)) return;

  const MoveResult move = move_velocity(c.from, c.to.velocity, c.bounds, c.to.acceleration);
  ++tally.cases;
  if (!move) return tally.fail(std::string("move_velocity refused: ") + explain(move.status), c);
  c.to.position = move.profile.end().position;
  c.by_velocity = true;
  const Verdict verdict = check(move.profile, c);
  tally.note(verdict, c);
  if (!verdict.ok()) return;
  if (std::isfinite(c.bounds.jerk_max)) expect_monotone(c, move.profile, verdict, tally);
  compare(
      verdict.duration,
      [&](Real share) {
        return minimum(reachable_velocity(c.from, c.to.velocity, c.to.acceleration, c.bounds,
                                          slack_of(verdict, share)));
      },
      c, tally);
}

/// Duration and distance, against a stop that is integrated.
void stops(Random& r, Tally& tally) {
  const char* const kinds[] = {"extremes", "outside", "lowered", "directional"};
  const int kind = r.below(4);
  Case c = draw(kinds[kind], r);
  const MoveResult halt = stop(c.from, c.bounds);
  ++tally.cases;
  if (!halt) return tally.fail(std::string("stop refused: ") + explain(halt.status), c);
  c.to = {halt.profile.end().position, 0, 0};
  c.by_velocity = true;
  const Verdict verdict = check(halt.profile, c);
  if (kind > 0) {  // the digits of `extremes` are measured by that workload
    tally.note(verdict, c);
    if (!verdict.ok()) return;
  }
  compare(
      verdict.duration,
      [&](Real share) {
        return minimum(reachable_velocity(c.from, 0, 0, c.bounds, slack_of(verdict, share)));
      },
      c, tally);
  const Freedom wanted = fastest_stop(c.from, c.bounds);
  const Real x = Real{c.to.position} - c.from.position;
  // Rounding of the duration changes the distance at the greatest velocity.
  const Range v = halt.profile.phases() > 0 ? extrema(halt.profile.curve(), 1) : Range{};
  const Real fastest = std::max(std::abs(v.min.value), std::abs(v.max.value));
  if (!(std::abs(x - wanted.x) <=
        same * verdict.scale.position + std::abs(verdict.duration - wanted.time) * fastest))
    tally.fail("stops after " + text(x) + ", the fastest stop after " + text(wanted.x), c);
}

}  // namespace jounce::proof
