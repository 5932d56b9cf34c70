// How long moves last, or may last, against the witness.
#include <algorithm>
#include <cmath>

#include "profiles/proof/judge.hpp"

namespace jounce::proof {

void optimality(Random& r, Tally& tally) {
  const Case c = any(r);
  const Solved s = solve(c, tally);
  if (!s) return;
  compare(
      s.verdict.duration, [&](Real share) { return minimum(reachable(c, s.verdict.scale, share)); },
      c, tally);
}

namespace {

/// move_to of duration T succeeds exactly if it is possible, and Durations knows it.
void ask(Case c, double T, const Durations& known, Tally& tally) {
  c.duration = T;
  ++tally.cases;
  const Move move = move_to(c.from, c.to, c.bounds, T);
  if (bool(move) != known.allows(T))
    tally.fail(std::string("move_to says ") + explain(move.status) + ", allows() says " +
                   (known.allows(T) ? "yes" : "no"),
               c);
  Verdict verdict;
  if (move) tally.note(verdict = check(move.profile, c), c);
  Case free = c;
  free.duration.reset();
  const Scale scale = check(move_to(c.from, c.to, c.bounds).profile, free).scale;
  const bool easily = contains(reachable(c, scale, rounding), T);
  const bool hardly = contains(reachable(c, scale, -rounding), T);
  if (easily != hardly)
    ++tally.ties;
  else if (easily != bool(move))
    tally.fail(std::string("this duration is ") + (easily ? "possible" : "impossible") +
                   ", move_to says " + explain(move.status),
               c);
}

}  // namespace

void exact(Random& r, Tally& tally) {
  const Case c = any(r);
  const Durations d = durations(c.from, c.to, c.bounds);
  if (d.status != MoveStatus::ok) return tally.fail("durations() refuses", c);
  const double base = d.minimum > 0 ? d.minimum : 1;
  ask(c, base * (r.below(2) == 0 ? r.uniform(0, 3) : 1 + r.log_uniform(1e-6, 1e3)), d, tally);
  for (std::size_t i = 0; i < d.count; ++i) {
    const auto& [from, to] = d.blocked[i];
    ask(c, r.uniform(from, to), d, tally);
    for (const double T : {from, to})
      if (!move_to(c.from, c.to, c.bounds, T))
        tally.fail("the edge " + text(T) + " of a blocked interval is refused", c);
  }
  if (!move_to(c.from, c.to, c.bounds, d.minimum)) tally.fail("the minimum itself is refused", c);
}

void blocks(Random& r, Tally& tally) {
  const Case c = any(r);
  ++tally.cases;
  const Durations d = durations(c.from, c.to, c.bounds);
  const Move move = move_to(c.from, c.to, c.bounds);
  if (d.status != MoveStatus::ok || !move) return tally.fail("refused", c);
  const Scale scale = check(move.profile, c).scale;
  // The set that is known lies between the sets that slightly harder and easier data give.
  const std::vector<Span> hard = reachable(c, scale, -rounding);
  const std::vector<Span> easy = reachable(c, scale, rounding);
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

void velocity(Random& r, Tally& tally) {
  Case c = any(r);
  if (!std::isfinite(c.bounds.acceleration_max)) return;
  const Move move = move_velocity(c.from, c.to.velocity, c.bounds, c.to.acceleration);
  ++tally.cases;
  if (!move) return tally.fail(std::string("move_velocity refused: ") + explain(move.status), c);
  c.to.position = move.profile.end().position;
  const Verdict verdict = check(move.profile, c);
  tally.note(verdict, c);
  if (!verdict.ok() || !safe_start(c.from, c.bounds)) return;
  compare(
      verdict.duration,
      [&](Real share) {
        return minimum(reachable_velocity(c.from, c.to.velocity, c.to.acceleration, c.bounds,
                                          slack_of(verdict.scale, share)));
      },
      c, tally);
}

}  // namespace jounce::proof
