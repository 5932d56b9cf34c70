// SPDX-License-Identifier: Apache-2.0
// Position limits.
#include <algorithm>
#include <cmath>

#include "profiles/proof/judge.hpp"

namespace jounce::proof {

namespace {

/// True if a motion keeps its position limits, with a margin.
bool clearly_inside(const Profile& f, Case c) {
  const double spare = 1e-9 * static_cast<double>(check(f, c).scale.position);
  c.bounds.position_min += spare;
  c.bounds.position_max -= spare;
  return check(f, c).ok() && f.start().position >= c.bounds.position_min &&
         f.start().position <= c.bounds.position_max;
}

/// True if a stop from a state stays inside.
bool stops_inside(const MotionState& s, const Bounds& b) {
  Bounds open = b;
  open.position_max = Bounds::none;
  open.position_min = -Bounds::none;
  const MoveResult halt = stop(s, open);
  return halt && clearly_inside(halt.profile, {s, halt.profile.end(), b, {}});
}

/// Time reversed: velocities and jerks change their sign.
bool starts_inside(const MotionState& s, Bounds b) {
  const auto swap = [](double& min, double& max) {
    std::swap(min, max);
    min = -min;
    max = -max;
  };
  swap(b.velocity_min, b.velocity_max);
  swap(b.jerk_min, b.jerk_max);
  return stops_inside({s.position, -s.velocity, s.acceleration}, b);
}

}  // namespace

void walls(Random& r, Tally& tally) {
  Case c = any(r);
  const MoveResult open = move_to(c.from, c.to, c.bounds);
  const double lo = std::min(c.from.position, c.to.position);
  const double hi = std::max(c.from.position, c.to.position);
  const double room = hi - lo + std::abs(c.from.velocity) + std::abs(c.to.velocity);
  c.bounds.position_min = lo - room * r.uniform(0, 0.5) * r.below(2);
  c.bounds.position_max = hi + room * r.uniform(0, 0.5) * r.below(2);
  if (!(c.bounds.position_min < c.bounds.position_max)) return;
  const MoveResult move = move_to(c.from, c.to, c.bounds);
  ++tally.cases;
  const bool free = open && clearly_inside(open.profile, c);
  if (move) {
    const Verdict verdict = check(move.profile, c);
    tally.note(verdict, c);
    if (verdict.ok() && free && verdict.duration > open.profile.duration() * (1 + same))
      tally.fail("limits that do not bind make it longer", c);
  } else if (move.status != MoveStatus::position_limit) {
    tally.fail(std::string("refused: ") + explain(move.status), c);
  } else if (free || (stops_inside(c.from, c.bounds) && starts_inside(c.to, c.bounds))) {
    tally.fail("refused, though it could stop, go, and run up inside", c);
  }
}

}  // namespace jounce::proof
