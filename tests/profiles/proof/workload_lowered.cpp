// SPDX-License-Identifier: Apache-2.0
// Limits lowered in motion: neither past the target nor backwards.
#include <algorithm>
#include <cmath>

#include "profiles/proof/judge.hpp"

namespace jounce::proof {

namespace {

Case negated(Case c) {
  const auto swapped = [](double& min, double& max) {
    std::swap(min, max);
    min = -min;
    max = -max;
  };
  for (MotionState* s : {&c.from, &c.to}) *s = {-s->position, -s->velocity, -s->acceleration};
  swapped(c.bounds.velocity_min, c.bounds.velocity_max);
  swapped(c.bounds.acceleration_min, c.bounds.acceleration_max);
  swapped(c.bounds.jerk_min, c.bounds.jerk_max);
  return c;
}

/// True if the axis moves towards the target and has the distance to stop and to run up to the
/// target's velocity, or has it with its present braking.
bool has_room(const Case& c) {
  const Real d = Real{c.to.position} - c.from.position;
  if (!(c.from.velocity > 0) || !forward(c.to, c.bounds)) return false;
  if (!forward({0, c.from.velocity, -c.from.acceleration}, c.bounds)) return false;  // it reverses
  const Bounds b = in_force(c.from, c.to, c.bounds).bounds;
  return fastest_stop(c.from, b).x + run_up(c.to, b) <= d;
}

/// The least velocity and the largest position, from the phases.
struct Extremes {
  Real v = 0, p = 0;
};

Extremes extremes(const Profile& f) {
  const MotionState& start = f.start();
  Real p = start.position;
  Real v = start.velocity;
  Real a = start.acceleration;
  Extremes e{v, p};
  for (std::size_t i = 0; i < f.phases(); ++i) {
    const auto [length, j] = f.phase(i);
    const auto at = [&, j = j](Real t) {  // clang 14 captures no structured binding by reference
      e.v = std::min(e.v, v + t * (a + t * j / 2));
      e.p = std::max(e.p, p + t * (v + t * (a / 2 + t * j / 6)));
    };
    if (j != 0 && -a / j > 0 && -a / j < length) at(-a / j);
    at(length);
    const Real t = length;
    p += t * (v + t * (a / 2 + t * j / 6));
    v += t * (a + t * j / 2);
    a += t * j;
  }
  return e;
}

}  // namespace

void overshoot(Random& r, Tally& tally) {
  Case c = draw("lowered", r);
  if (c.to.position < c.from.position) c = negated(c);
  ++tally.cases;
  const MoveResult move = move_to(c.from, c.to, c.bounds);
  if (!move) return tally.fail(std::string("refused: ") + explain(move.status), c);
  if (!has_room(c)) return;
  const Extremes e = extremes(move.profile);
  const Real speed = std::max<Real>(c.from.velocity, c.bounds.velocity_max);
  const Real far = std::abs(c.from.position) + std::abs(c.to.position);
  if (e.v < -1e-9L * speed) tally.fail("moves backwards, at " + text(e.v), c);
  if (e.p > c.to.position + 1e-9L * far)
    tally.fail("passes the target by " + text(e.p - c.to.position), c);
}

}  // namespace jounce::proof
