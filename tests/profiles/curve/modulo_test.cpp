// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/modulo.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/random.hpp"

namespace jounce::modulo_test {
namespace {

const Bounds axis = within(720, 7200, 72000);

ModuloTarget target(double from, double to, Direction direction, double velocity = 0) {
  return modulo_target({from, velocity, 0}, to, direction, 360, axis);
}

TEST(Modulo, ReducesIntoOneTurn) {
  EXPECT_EQ(rolled(-10, 360).position, 350);
  EXPECT_EQ(rolled(-10, 360).turns, -1);
  EXPECT_EQ(rolled(360, 360).position, 0);
  EXPECT_EQ(rolled(360, 360).turns, 1);
  EXPECT_EQ(rolled(-360, 360).position, 0);
  EXPECT_FALSE(std::signbit(rolled(-360, 360).position));
  EXPECT_EQ(rolled(-1e-30, 360).position, 0) << "no double between lies below 360";
  EXPECT_EQ(rolled(-1e-30, 360).turns, 0);
}

TEST(Modulo, DoesNotDriftOverHugeTurnCounts) {
  // 360 k + 90 is a whole number below 2^53: the remainder must be 90 itself.
  for (const double turns : {1.0, 1e6, 1e12, 2.4e13}) {
    const Turned spot = rolled(360 * turns + 90, 360);
    EXPECT_EQ(spot.position, 90);
    EXPECT_EQ(spot.turns, turns);
    EXPECT_EQ(unrolled(spot, 360), 360 * turns + 90);
  }
}

TEST(Modulo, RejectsMoreTurnsThanADoubleCounts) {
  EXPECT_THROW(rolled(1e308, 1e-10), InputError);
}

TEST(Modulo, TurningBackToWhereItIsIsExact) {
  EXPECT_EQ(target(190, 190, Direction::negative, 300).distance, 0);
  EXPECT_EQ(target(190, 190, Direction::positive, -300).distance, 0);
  EXPECT_EQ(target(190, 190, Direction::positive, 300).distance, 360);
}

TEST(Modulo, AnyPositionComesBack) {
  test::Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const double period = random.log_uniform(1e-3, 1e5);
    const double x = random.uniform(-1, 1) * random.log_uniform(1e-6, 1e12);
    const Turned spot = rolled(x, period);
    ASSERT_GE(spot.position, 0) << x << " of " << period;
    ASSERT_LT(spot.position, period) << x << " of " << period;
    ASSERT_NEAR(unrolled(spot, period), x, 2.3e-16 * std::max(std::abs(x), period))
        << x << " of " << period;
  }
}

TEST(Modulo, ShortestIsAtMostHalfATurnAndHalfIsPositive) {
  EXPECT_EQ(target(350, 10, Direction::shortest).distance, 20);
  EXPECT_EQ(target(10, 350, Direction::shortest).distance, -20);
  EXPECT_EQ(target(10, 190, Direction::shortest).distance, 180);
  EXPECT_EQ(target(190, 10, Direction::shortest).distance, 180);
  EXPECT_EQ(target(730, 730 - 3600, Direction::shortest).distance, 0);
  EXPECT_EQ(target(730, 20, Direction::shortest).position, 740);
}

TEST(Modulo, OneWayMovesInOneDirection) {
  EXPECT_EQ(target(10, 350, Direction::positive).distance, 340);
  EXPECT_EQ(target(350, 10, Direction::negative).distance, -340);
  EXPECT_EQ(target(10, 10, Direction::positive).distance, 0);
  EXPECT_EQ(target(10, std::nextafter(10.0, 0), Direction::positive).distance, 0)
      << "no turn for the last digit";
  EXPECT_EQ(target(10, 9.99, Direction::positive).distance, 360 - (10 - 9.99));
}

TEST(Modulo, OneWayNeverTurnsBackAMovingAxis) {
  // At 720 deg/s the stop takes 720 (0.1 + 0.1)/2 = 72 deg: 50 deg ahead is too near.
  const ModuloTarget near = target(0, 50, Direction::positive, 720);
  EXPECT_NEAR(near.distance, 410, 1e-12 * 360);
  EXPECT_NEAR(target(0, 80, Direction::positive, 720).distance, 80, 1e-12 * 360);
  EXPECT_NEAR(target(0, 50, Direction::current, 720).distance, 410, 1e-12 * 360);
  EXPECT_NEAR(target(0, 50, Direction::current, -720).distance, -310, 1e-12 * 360);
  const MoveResult move = move_to({0, 720, 0}, {near.distance, 0, 0}, axis);
  ASSERT_TRUE(move);
  for (int i = 0; i <= 1000; ++i)
    EXPECT_GE(move.profile.at(move.profile.duration() * i / 1000).velocity, -1e-9);
}

TEST(Modulo, FastestAsksTheSolver) {
  EXPECT_EQ(target(350, 10, Direction::fastest).distance, 20);
  EXPECT_EQ(target(10, 190, Direction::fastest).distance, 180) << "a tie: positive";
  // Moving forward fast, 100 deg behind is nearer, but ahead is sooner.
  const MotionState moving{0, 720, 0};
  const ModuloTarget best = modulo_target(moving, 240, Direction::fastest, 360, axis);
  EXPECT_EQ(target(0, 240, Direction::shortest, 720).distance, -120);
  EXPECT_NEAR(best.distance, 240, 1e-9);
  double least = std::numeric_limits<double>::infinity();
  for (int turn = -2; turn <= 2; ++turn)
    least = std::min(least, durations(moving, {240.0 + 360 * turn, 0, 0}, axis).minimum);
  EXPECT_EQ(durations(moving, {best.distance, 0, 0}, axis).minimum, least);
}

TEST(Modulo, FastestIsNeverSlowerThanAnyTurn) {
  test::Random random(12);
  for (int i = 0; i < 2000; ++i) {
    const MotionState from{random.uniform(-1000, 1000), random.uniform(-720, 720),
                           random.uniform(-2000, 2000)};
    const double to = random.uniform(0, 360);
    const ModuloTarget best = modulo_target(from, to, Direction::fastest, 360, axis);
    ASSERT_EQ(best.status, MoveStatus::ok);
    const double spot = rolled(best.position - to + 180, 360).position;
    ASSERT_NEAR(spot, 180, 1e-9);
    const MotionState here{0, from.velocity, from.acceleration};
    const double chosen = durations(here, {best.distance, 0, 0}, axis).minimum;
    for (int turn = -2; turn <= 2; ++turn) {
      const double other = durations(here, {best.distance + 360 * turn, 0, 0}, axis).minimum;
      ASSERT_LE(chosen, other * (1 + 1e-11))
          << from.position << " " << from.velocity << " " << from.acceleration << " to " << to;
    }
  }
}

TEST(Modulo, ReportsWhyThereIsNoStop) {
  const Bounds bad{.velocity_min = 1};
  EXPECT_EQ(modulo_target({}, 10, Direction::positive, 360, bad).status,
            MoveStatus::invalid_bounds);
  EXPECT_THROW(target(0, std::nan(""), Direction::shortest), InputError);
  EXPECT_THROW(modulo_target({}, 10, Direction::shortest, 0, axis), InputError);
}

TEST(Modulo, AgitoSection53) {
  // 10 000 000 counts/s, Jerk 9: M > 312500 and M < 4194304.
  EXPECT_NO_THROW(require_agito_modulo(312501, 9, 1e7));
  EXPECT_THROW(require_agito_modulo(312500, 9, 1e7), InputError);
  EXPECT_NO_THROW(require_agito_modulo(4194303, 9, 1e7));
  EXPECT_THROW(require_agito_modulo(4194304, 9, 1e7), InputError);
  EXPECT_THROW(require_agito_modulo(4194303.5, 9, 1e7), InputError);
  EXPECT_THROW(require_agito_modulo(4194303, 10, 1e7), InputError);
}

}  // namespace
}  // namespace jounce::modulo_test
