// SPDX-License-Identifier: Apache-2.0
// Relations between answers, and motions made by plain integration: neither solves anything.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "jounce/profiles/sequences/synchronize.hpp"

#include "profiles/proof/judge.hpp"
#include "support/draw_until.hpp"

namespace jounce::proof {

namespace {

/// A case of any draw, or one of limits far apart.
Case of_all(Random& r) {
  return r.below(2) == 0 ? any(r) : far_apart(r);
}

bool third(const Bounds& b) {
  return std::isfinite(b.jerk_max);
}

/// The witness gives both durations for data that are off by rounding.
bool is_tie(const Case& c, Real one, Real other) {
  const MoveResult move = move_to(c.from, c.to, c.bounds);
  if (!move) return false;
  const Verdict verdict = check(move.profile, c);
  const Real least = minimum(reachable(c, verdict, rounding)) * (1 - same);
  const Real most = minimum(reachable(c, verdict, -rounding)) * (1 + same);
  return std::min(one, other) >= least && std::max(one, other) <= most;
}

void expect_same(const Case& c, const Case& other, const char* what, Tally& tally) {
  const Durations d = durations(c.from, c.to, c.bounds);
  const Durations e = durations(other.from, other.to, other.bounds);
  ++tally.cases;
  if (d.status != MoveStatus::ok || e.status != d.status)
    return tally.fail(std::string(what) + ": " + explain(d.status) + ", " + explain(e.status), c);
  if (std::abs(d.minimum - e.minimum) <= same * d.minimum) return;
  if (is_tie(c, d.minimum, e.minimum) || is_tie(other, d.minimum, e.minimum))
    ++tally.ties;
  else
    tally.fail(std::string(what) + " lasts " + text(e.minimum) + ", not " + text(d.minimum), c);
}

Bounds swapped(const Bounds& b) {
  return {-b.velocity_max,     -b.velocity_min, -b.acceleration_max,
          -b.acceleration_min, -b.jerk_max,     -b.jerk_min};
}

MotionState negated(const MotionState& s) {
  return {-s.position, -s.velocity, -s.acceleration};
}

/// The motion backwards in time: velocity and jerk change their sign.
Case backwards(const Case& c) {
  const auto turned = [](const MotionState& s) {
    return MotionState{s.position, -s.velocity, s.acceleration};
  };
  const Bounds& b = c.bounds;
  return {turned(c.to),
          turned(c.from),
          {-b.velocity_max, -b.velocity_min, b.acceleration_min, b.acceleration_max, -b.jerk_max,
           -b.jerk_min}};
}

}  // namespace

/// The mirror image and the motion backwards in time last as long. Wider limits take no longer. The direct
/// way takes no longer than one by way of another state.
void relations(Random& r, Tally& tally) {
  const Case c = of_all(r);
  const MoveResult move = move_to(c.from, c.to, c.bounds);
  const Case mirror{negated(c.from), negated(c.to), swapped(c.bounds)};
  const MoveResult mirrored = move_to(mirror.from, mirror.to, mirror.bounds);
  ++tally.cases;
  if (!move || !mirrored) return tally.fail("refused", c);
  const bool equal = std::abs(mirrored.profile.duration() - move.profile.duration()) <=
                     same * move.profile.duration();
  if (!equal && !is_tie(c, move.profile.duration(), mirrored.profile.duration()))
    tally.fail("the mirror image lasts " + text(mirrored.profile.duration()) + ", not " +
                   text(move.profile.duration()),
               c);
  if (!safe_start(c.from, c.bounds)) return;
  const Case turned = backwards(c);
  if (safe_target(turned.to, turned.bounds) && safe_start(turned.from, turned.bounds))
    expect_same(c, turned, "the motion backwards in time", tally);

  const Real is = move.profile.duration();
  Case wider = c;
  double* const limits[] = {&wider.bounds.velocity_min,     &wider.bounds.velocity_max,
                            &wider.bounds.acceleration_min, &wider.bounds.acceleration_max,
                            &wider.bounds.jerk_min,         &wider.bounds.jerk_max};
  *limits[r.below(6)] *= r.log_uniform(1, 1e3);
  const Real with_more = move_to(wider.from, wider.to, wider.bounds).profile.duration();
  ++tally.cases;
  if (with_more > is * (1 + same)) {
    const Verdict verdict = check(move.profile, c);
    if (minimum(reachable(c, verdict, -rounding)) * (1 + same) >= with_more)
      ++tally.ties;
    else
      tally.fail("with wider limits it lasts " + text(with_more) + ", not " + text(is), wider);
  }

  Case first = c;
  first.to = of_all(r).to;
  if (!safe_target(first.to, c.bounds) || !safe_start(first.to, c.bounds) || !third(c.bounds))
    return;
  const Case then{first.to, c.to, c.bounds};
  const MoveResult there = move_to(first.from, first.to, first.bounds);
  const MoveResult on = move_to(then.from, then.to, then.bounds);
  ++tally.cases;
  if (!there || !on) return tally.fail("refused by way of another state", first);
  const Real whole = Real{there.profile.duration()} + on.profile.duration();
  if (is <= whole * (1 + same)) return;
  const Verdict verdict = check(move.profile, c);
  if (minimum(reachable(c, verdict, -rounding)) <= whole * (1 + same))
    ++tally.ties;
  else
    tally.fail("lasts " + text(is) + ", by way of another state " + text(whole), c);
}

namespace {

/// A state on the way of a motion under construction.
struct Driven {
  Real x = 0, v = 0, a = 0;

  void advance(Real t, Real j) {
    x += t * (v + t * (a / 2 + t * j / 6));
    v += t * (a + t * j / 2);
    a += t * j;
  }
};

/// Keeps `share` of the bounds, also after the acceleration has returned to zero.
bool has_room(const Driven& s, const Bounds& b, Real share) {
  const auto within = [share](Real x, double min, double max) {
    return x >= min * share && x <= max * share;
  };
  const Real natural = s.v - s.a * s.a / (2 * Real{s.a > 0 ? b.jerk_min : b.jerk_max});
  return within(s.a, b.acceleration_min, b.acceleration_max) &&
         within(s.v, b.velocity_min, b.velocity_max) &&
         within(natural, b.velocity_min, b.velocity_max);
}

/// Goes on for t with jerk j, if that keeps the bounds. The velocity is extreme where a passes zero.
bool drive(Driven& s, const Bounds& b, Real t, Real j, Real share) {
  Driven next = s;
  next.advance(t, j);
  if (!has_room(next, b, share)) return false;
  if (j != 0 && -s.a / j > 0 && -s.a / j < t) {
    Driven top = s;
    top.advance(-s.a / j, j);
    top.a = 0;
    if (!has_room(top, b, share)) return false;
  }
  s = next;
  return true;
}

/// An axis' own measure of time.
Real pace(const Bounds& b) {
  return std::min(
      std::max(b.acceleration_max / b.jerk_max, b.acceleration_min / b.jerk_min),
      std::max(b.velocity_max / b.acceleration_max, b.velocity_min / b.acceleration_min));
}

struct Journey {
  Case c;
  Real duration = 0;
};

/// A motion of random jerks that keeps 0.999 of its bounds. It lasts T; any time where T is 0. None if
/// no such jerks were drawn.
std::optional<Journey> driven(Random& r, const Bounds& b, Real T) {
  constexpr Real share = 0.999L;
  Journey j;
  j.c.bounds = b;
  const auto part = [&r](double min, double max) {
    const double of = r.below(2) == 0 ? min : max;
    return r.below(3) == 0 ? 0.0 : of * 0.998 * (r.below(4) == 0 ? 1 : r.uniform(0, 1));
  };
  Driven s;
  for (int i = 0;; ++i) {
    j.c.from = {r.uniform(-1, 1) * r.log_uniform(1e-3, 1e3), part(b.velocity_min, b.velocity_max),
                part(b.acceleration_min, b.acceleration_max)};
    s = {j.c.from.position, j.c.from.velocity, j.c.from.acceleration};
    if (has_room(s, b, share)) break;
    if (i == 20) return {};
  }
  const int n = 1 + r.below(8);
  for (int i = 0; i < n; ++i) {
    bool found = false;
    for (int k = 0; k < 30 && !found; ++k) {
      const Real t = T > 0 ? T / n : pace(b) * r.log_uniform(1e-4, 3);
      const Real jerk = r.below(4) == 0
                            ? 0
                            : Real{r.below(2) == 0 ? b.jerk_min : b.jerk_max} *
                                  (r.below(2) == 0 ? 0.999 : r.log_uniform(1e-6, 0.999));
      found = drive(s, b, t, jerk, share);
      if (found) j.duration += t;
    }
    if (!found) return {};
  }
  j.c.to = {static_cast<double>(s.x), static_cast<double>(s.v), static_cast<double>(s.a)};
  if (!safe_target(j.c.to, b)) return {};
  return j;
}

Bounds any_bounds(Random& r) {
  return test::draw_until([&r] { return of_all(r).bounds; },
                          [](const Bounds& b) {
                            return third(b) && std::isfinite(b.velocity_max) &&
                                   std::isfinite(b.acceleration_max);
                          });
}

/// The witness excludes the duration for data that are a little harder: its end was rounded.
bool is_excused(const Journey& j) {
  const MoveResult move = move_to(j.c.from, j.c.to, j.c.bounds);
  return move && !contains(reachable(j.c, check(move.profile, j.c), -rounding), j.duration);
}

}  // namespace

/// The duration of a motion that exists is possible, and not below the minimum.
void driven_one(Random& r, Tally& tally) {
  const std::optional<Journey> j = driven(r, any_bounds(r), 0);
  if (!j) return;
  ++tally.cases;
  Case c = j->c;
  const double T = static_cast<double>(j->duration);
  const Durations d = durations(c.from, c.to, c.bounds);
  if (d.status != MoveStatus::ok)
    return tally.fail(std::string("refused: ") + explain(d.status), c);
  c.duration = T;
  const MoveResult move = move_to(c.from, c.to, c.bounds, T);
  if (move) tally.note(check(move.profile, c), c);
  if (move && d.allows(T) && d.minimum <= T * (1 + same)) return;
  if (is_excused(*j))
    ++tally.ties;
  else
    tally.fail("a motion of " + text(T) + " exists; the minimum is " + text(d.minimum) +
                   ", allows() returns " + (d.allows(T) ? "true" : "false") + ", move_to " +
                   explain(move.status),
               c);
}

/// Axes that all have a motion of T: together they last no longer, and T where that is the least.
void driven_together(Random& r, Tally& tally) {
  std::array<AxisMove, 3> axes;
  std::array<Profile, 3> out;
  std::vector<Journey> all;
  for (AxisMove& axis : axes) {
    std::optional<Journey> j;
    for (int i = 0; i < 40 && !j; ++i)
      j = driven(r, any_bounds(r), all.empty() ? 0 : all[0].duration);
    if (!j) return;
    axis = {j->c.from, j->c.to, j->c.bounds};
    all.push_back(*j);
  }
  const double T = static_cast<double>(all[0].duration);
  const Synchronized soonest = synchronize(axes, Sync::time, out);
  const Synchronized s = synchronize(axes, Sync::time, out, T);
  tally.cases += 2;
  const bool ok = s.status == MoveStatus::ok && soonest.status == MoveStatus::ok &&
                  soonest.duration <= T * (1 + same) && std::abs(s.duration - T) <= same * T;
  if (!ok) {
    if (std::any_of(all.begin(), all.end(), is_excused)) {
      ++tally.ties;
    } else {
      std::string asked;
      for (const Journey& j : all) asked += "\n    " + reproducer(j.c);
      tally.fail("all can in " + text(T) + ", together " + text(soonest.duration) + " and " +
                     text(s.duration) + ", " + explain(s.status),
                 asked);
    }
    return;
  }
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Case c = all[i].c;
    c.duration = s.duration;
    tally.note(check(out[i], c), c);
  }
}

}  // namespace jounce::proof
