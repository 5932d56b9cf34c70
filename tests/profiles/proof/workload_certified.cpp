// SPDX-License-Identifier: Apache-2.0
// Durations that are impossible, certified by weak duality.
#include <algorithm>
#include <cmath>

#include "profiles/proof/certificate.hpp"
#include "profiles/proof/judge.hpp"

namespace jounce::proof {

namespace {

/// Required distances of the certificate from an edge, finest first.
constexpr Real gaps[] = {1e-3L, 1e-2L, 1e-1L};

/// No motion takes a time in (from, to), but for a share of `to` at its ends. A tie is one where that
/// share is more than 1e-3; a failure, where it is more than 0.1.
void certify(const Question& q, Real from, Real to, const Case& c, Tally& tally) {
  ++tally.cases;
  for (const Real gap : gaps) {
    const Real lo = from > 0 ? from + gap * to : 0;
    const Real hi = to - gap * (to - q.start.time);
    if (lo < hi && impossible_from(q, lo, hi) > lo) continue;
    tally.longer = std::max(tally.longer, static_cast<double>(gap));
    if (gap > 1e-3L) ++tally.ties;
    return;
  }
  tally.fail("not certified: nothing between " + text(from) + " and " + text(to), c);
}

}  // namespace

/// The minimum of a move, and the intervals that durations() calls blocked.
void certified(Random& r, Tally& tally) {
  const char* const kinds[] = {"outside", "outside", "lowered", "directional", "test", "ties"};
  const Case c = draw(kinds[r.below(6)], r);
  if (c.from == c.to) return;
  const Durations d = durations(c.from, c.to, c.bounds);
  const MoveResult move = move_to(c.from, c.to, c.bounds);
  if (d.status != MoveStatus::ok || !move) return tally.fail("refused", c);
  certify(question(c.from, c.to, c.bounds), 0, move.profile.duration(), c, tally);
  for (std::size_t i = 0; i < d.count; ++i)
    certify(question_of_longer(c.from, c.to, c.bounds), d.blocked[i].from, d.blocked[i].to, c,
            tally);
}

/// The fastest change of velocity.
void certified_velocity(Random& r, Tally& tally) {
  const char* const kinds[] = {"outside", "lowered", "directional", "ties"};
  Case c = draw(kinds[r.below(4)], r);
  const MoveResult move = move_velocity(c.from, c.to.velocity, c.bounds, c.to.acceleration);
  if (!move) return tally.fail(std::string("move_velocity refused: ") + explain(move.status), c);
  c.to.position = move.profile.end().position;
  if (move.profile.phases() > 0)
    certify(question_of_velocity(c.from, c.to, c.bounds), 0, move.profile.duration(), c, tally);
}

}  // namespace jounce::proof
