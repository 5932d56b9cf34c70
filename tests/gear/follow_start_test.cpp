// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/follow_start.hpp"

#include <gtest/gtest.h>

#include "jounce/controllers/googol/googol.hpp"
#include "jounce/gear/follow.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "gear/follow_tables.hpp"
#include "support/random.hpp"

namespace jounce::follow_start_test {
namespace {

constexpr FollowStart pass(double position, int direction = 1) {
  return {FollowEvent::pass, position, direction};
}

/// Example 7-7's master: jog to 50 at 1.
Trajectory jog_master(double until_ms) {
  const std::array velocities{googol::JogVelocity{0, 50}};
  return until(googol::jog(0, velocities, {.acc = 1}), until_ms);
}

TEST(FollowStart, Example77BeginsAtAThousandAndTwentyFive) {
  const Trajectory master = jog_master(5000);
  const auto t = begin_of(pass(50000), master, 0);
  ASSERT_TRUE(t);
  EXPECT_NEAR(*t, 1025, 1e-9);
  const Followed slave = followed_from(follow({{test::example_7_7()}}).cam, master, *t, 0);
  EXPECT_NEAR(slave.jet(*t)[0], 0, 1e-9);
  EXPECT_NEAR(slave.jet(*t + 400)[1], 50, 1e-9) << "the peak";
  EXPECT_NEAR(slave.jet(*t + 1200)[0], 40000, 1e-6) << "after a cycle";
  EXPECT_NEAR(slave.jet(*t + 2400)[0], 80000, 1e-6);
  EXPECT_NEAR(slave.jet(*t + 600)[1], 50, 1e-9);
}

TEST(FollowStart, AtOnceIsWhenItIsArmed) {
  EXPECT_EQ(begin_of({}, jog_master(5000), 300), 300);
  const Followed slave =
      followed_from(follow({{test::example_7_7()}}).cam, jog_master(5000), 300, 77);
  EXPECT_EQ(slave.start(), 300);
  EXPECT_NEAR(slave.jet(300)[0], 77, 1e-9) << "from where the slave stands";
}

TEST(FollowStart, AMasterBeyondThePlaceMustComeBackAndPassAgain) {
  const Trajectory master = jog_master(5000);
  EXPECT_FALSE(begin_of(pass(50000), master, 1100));
  EXPECT_FALSE(begin_of(pass(50000, -1), master, 0)) << "it passes the other way";
  EXPECT_FALSE(begin_of(pass(-1), master, 0));
  const Trajectory there = trapezoid({.to = 100, .velocity = 10, .acceleration = 10}).curve();
  const Trajectory both = concatenated(concatenated(there, reversed(there)), there);
  const double period = there.end();
  EXPECT_NEAR(begin_of(pass(50), both, 0).value_or(-1), period / 2, 1e-12);
  EXPECT_NEAR(begin_of(pass(50), both, period / 2 + 1).value_or(-1), 2.5 * period, 1e-12);
  EXPECT_NEAR(begin_of(pass(50, -1), both, 0).value_or(-1), 1.5 * period, 1e-12);
}

TEST(FollowStart, TouchingThePlaceIsNotPassingIt) {
  const Trajectory there = trapezoid({.to = 100, .velocity = 10, .acceleration = 10}).curve();
  const Trajectory touch = concatenated(there, reversed(there));
  EXPECT_FALSE(begin_of(pass(100), touch, 0));
  EXPECT_FALSE(begin_of(pass(0, -1), touch, 0));
}

TEST(FollowStart, AMasterThatStandsOnThePlacePassesItWhereItLeaves) {
  const Trajectory there = trapezoid({.to = 100, .velocity = 10, .acceleration = 10}).curve();
  EXPECT_EQ(begin_of(pass(0), there, 0), 0) << "from the very start";
  const Trajectory wait({line(5, 100, 100)});
  const Trajectory on = shifted(there, 0, 100);
  const Trajectory master = concatenated(concatenated(there, wait), on);
  EXPECT_NEAR(begin_of(pass(100), master, 0).value_or(-1), there.end() + 5, 1e-12);
}

TEST(FollowStart, StepsFindTheSameInstantAsTheWholeMotion) {
  test::Random random(99);
  for (int n = 0; n < 300; ++n) {
    const Trajectory master = s_curve({.from = random.uniform(-50, 50),
                                       .to = random.uniform(60, 200),
                                       .velocity = 10,
                                       .acceleration = 20,
                                       .jerk = 100})
                                  .curve();
    const FollowStart start = pass(random.uniform(50, 60));
    const double cycle = random.uniform(1e-3, 0.3);
    const auto exact = begin_of(start, master, 0);
    ASSERT_TRUE(exact) << n;
    const auto at = [&](double t) { return Sample{t, master.jet(std::min(t, master.end()))}; };
    std::optional<Sample> found;
    for (int k = 0; !found && k * cycle < master.end(); ++k)
      found = begin_of(start, at(k * cycle), at((k + 1) * cycle));
    ASSERT_TRUE(found) << n;
    EXPECT_EQ(found->master[0], start.position);
    EXPECT_NEAR(found->t, *exact, 2e-2 * cycle) << n << ", cycle " << number(cycle);
  }
}

TEST(FollowStart, StepsNeedTheRightDirectionAndStartWhereTheMasterStood) {
  const auto at = [](double t, double x, double v) { return Sample{t, {x, v, 0, 0}}; };
  EXPECT_FALSE(begin_of(pass(10), at(0, 11, -1), at(1, 9, -1)));
  EXPECT_TRUE(begin_of(pass(10, -1), at(0, 11, -2), at(1, 9, -2)));
  EXPECT_FALSE(begin_of(pass(10), at(0, 9, 1), at(1, 10, 0))) << "not yet beyond";
  const auto found = begin_of(pass(10), at(1, 10, 0), at(2, 10.5, 1));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->t, 1);
  EXPECT_FALSE(begin_of(pass(10), at(0, 11, 1), at(1, 12, 1))) << "beyond already";
}

TEST(FollowStart, RejectsDirectionsThatAreNone) {
  EXPECT_THROW(require_valid(pass(0, 0)), InputError);
  EXPECT_THROW(require_valid(pass(NAN)), InputError);
  EXPECT_THROW((void)followed_from(follow({{test::example_7_7()}}).cam, jog_master(100), 100, 0),
               InputError);
}

}  // namespace
}  // namespace jounce::follow_start_test
