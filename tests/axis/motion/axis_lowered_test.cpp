// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/bench.hpp"
#include "support/loop_limit.hpp"
#include "support/random.hpp"

// An override, or the velocity of another command, that is lower than the axis goes: it neither passes
// its target nor moves back, because the move under way did not either.

namespace jounce::axis_lowered_test {
namespace {

using namespace test;
using test::Random;

struct Seen {
  double passes = 0;    ///< u, beyond the target
  double returns = 0;   ///< u/s, backwards
  double position = 0;  ///< u, at the end
  bool finished = false;
};

/// Steps until the move is done, or for so many ticks.
Seen watched(Bench& bench, double target, int ticks) {
  Seen seen;
  for (int i = 0; i < ticks && !seen.finished; ++i) {
    const Tick now = bench.step();
    seen.passes = std::max(seen.passes, now.position - target);
    seen.returns = std::max(seen.returns, -now.velocity);
    seen.position = now.position;
    seen.finished = now.state == State::standstill;
  }
  return seen;
}

TEST(AxisLowered, AnOverrideInFrontOfTheTargetDoesNotPassIt) {
  Bench bench({.limits = limits(926, 6000, 12000)});
  bench.send(Kind::enable);
  bench.step({command::MoveAbsolute{.position = 2000}});
  for (test::LoopLimit loop; bench.step().position < 2000 - 265.4 && loop.goes_on();) continue;
  bench.step({command::Override{.factor = 385.0 / 926}});
  const Seen seen = watched(bench, 2000, 10'000);
  EXPECT_TRUE(seen.finished);
  EXPECT_EQ(seen.position, 2000);
  EXPECT_LE(seen.passes, 1e-9);
  EXPECT_LE(seen.returns, 1e-9);
}

struct Kinds {
  bool jerk, deceleration;
};

/// A random move, lowered at a random tick of it.
void lowered(Random& random, const Kinds& kinds, bool by_command) {
  const double velocity = random.uniform(50, 500);
  const double acceleration = random.uniform(500, 5000);
  AxisConfig config{.limits = limits(velocity, acceleration)};
  if (kinds.jerk) config.limits = limits(velocity, acceleration, random.uniform(5000, 100'000));
  MoveDynamics d{.velocity = velocity * random.uniform(0.3, 1), .acceleration = acceleration};
  d.deceleration = kinds.deceleration ? acceleration * random.uniform(0.3, 1) : acceleration;
  if (kinds.deceleration && random.uniform(0, 1) < 0.5) std::swap(d.acceleration, d.deceleration);
  const double target = random.uniform(1, 100);
  Bench bench(config);
  bench.send(Kind::enable);
  bench.step({command::MoveAbsolute{.position = target, .dynamics = d}});
  const double way = target * random.uniform(0.02, 0.999);
  for (test::LoopLimit loop; bench.step().position < way && loop.goes_on();) continue;
  const double factor = random.uniform(0.1, 0.95);
  if (by_command) {
    d.velocity *= factor;
    bench.step({command::MoveAbsolute{.position = target, .dynamics = d}});
  } else {
    bench.step({command::Override{.factor = factor}});
  }
  const Seen seen = watched(bench, target, 3000);
  EXPECT_LE(seen.passes, 1e-9 * target);
  EXPECT_LE(seen.returns, 1e-9 * velocity);
}

TEST(AxisLowered, NoOverrideAndNoCommandMakesAMovePassItsTarget) {
  constexpr int seed = 61;
  Random random(seed);
  for (int i = 0; i < 20'000 && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(i));
    lowered(random, {i % 3 != 0, i % 2 == 0}, i % 5 == 0);
  }
}

}  // namespace
}  // namespace jounce::axis_lowered_test
