// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/between.hpp"

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"

namespace jounce::between_test {
namespace {

Trajectory move() {
  return s_curve({.from = 3, .to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
}

void expect_same(const Trajectory& f, const Trajectory& g, double from, double to) {
  for (int i = 0; i <= 200; ++i) {
    const double t = from + (to - from) * i / 200;
    EXPECT_NEAR(f.at(t).position, g.at(t).position, 1e-13 * 50) << t;
    EXPECT_NEAR(f.at(t).velocity, g.at(t).velocity, 1e-13 * 10) << t;
    EXPECT_NEAR(f.at(t).acceleration, g.at(t).acceleration, 1e-12 * 20) << t;
  }
}

TEST(Between, IsThePartItNames) {
  const Trajectory f = move();
  const Trajectory part = between(f, 0.1, 1.3);
  EXPECT_EQ(part.start(), 0.1);
  EXPECT_NEAR(part.end(), 1.3, 1e-15);
  expect_same(part, f, 0.11, 1.29);
  EXPECT_EQ(between(f, f.start(), f.end()).segments().size(), f.segments().size());
}

TEST(Between, ReachesIntoTheRestOutside) {
  const Trajectory f = move();
  const Trajectory longer = between(f, -1, f.end() + 2);
  EXPECT_EQ(longer.segments().size(), f.segments().size() + 2);
  expect_same(longer, f, -1, f.end() + 2);
}

TEST(Between, ReachesIntoTheTurnsBeforeAndAfter) {
  const Trajectory f = with(concatenated(move(), reversed(move())), Extrapolation::wrap);
  const double turn = f.length();
  const Trajectory far = between(f, -1.5 * turn, 2.25 * turn);
  EXPECT_NEAR(far.length(), 3.75 * turn, 1e-13 * turn);
  expect_same(far, f, -1.5 * turn + 0.01, 2.25 * turn - 0.01);
  EXPECT_EQ(far.outside(), Extrapolation::hold);
}

TEST(Between, CutsAtABreakWithoutDust) {
  const Trajectory f = move();
  for (const double t : f.breaks()) {
    if (t > f.start()) {
      EXPECT_EQ(between(f, f.start(), t * (1 + 1e-16)).segments().size() +
                    (t < f.end() ? between(f, t * (1 - 1e-16), f.end()).segments().size() : 0),
                f.segments().size());
    }
  }
}

TEST(Between, RejectsAnInvalidStretch) {
  EXPECT_THROW(between(move(), 1, 1), InputError);
  EXPECT_THROW(between(with(move(), Extrapolation::refuse), -1, 1), InputError);
}

TEST(Between, RejectsMoreTurnsThanItCanHold) {
  EXPECT_THROW(between(with(move(), Extrapolation::wrap), 0, 1e9 * move().length()), InputError);
}

}  // namespace
}  // namespace jounce::between_test
