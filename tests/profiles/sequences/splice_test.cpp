// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/splice.hpp"

#include <array>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"

namespace jounce::splice_test {
namespace {

Trajectory running() {
  return shifted(s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve(), 1);
}

TEST(Until, KeepsWhatCameBefore) {
  const Trajectory f = running();
  for (const double t : {1.05, 1.3, 3.3, 6.7}) {
    const Trajectory head = until(f, t);
    EXPECT_EQ(head.start(), 1);
    EXPECT_DOUBLE_EQ(head.end(), t);
    for (int n = 0; n < 100; ++n) {
      const double x = 1 + (t - 1) * n / 100;
      EXPECT_NEAR(head.at(x).position, f.at(x).position, 1e-13);
      EXPECT_NEAR(head.at(x).jerk, f.at(x).jerk, 1e-9);
    }
  }
}

TEST(Until, ABreakAddsNoSliver) {
  const Trajectory f = running();
  for (std::size_t i = 1; i < f.breaks().size(); ++i)
    for (const double t :
         {f.breaks()[i], std::nextafter(f.breaks()[i], 0), std::nextafter(f.breaks()[i], 99)})
      EXPECT_EQ(until(f, t).segments().size(), i);
}

TEST(Until, BeyondTheEndARestStandsAndAVelocityIsKept) {
  const Trajectory rest = until(running(), 9);
  EXPECT_DOUBLE_EQ(rest.end(), 9);
  EXPECT_DOUBLE_EQ(state_at(rest, 8).position, 51 - 1.0);
  const Trajectory jog({cubic(2, 0, 0, 3, 4)});
  const Trajectory longer = until(jog, 5);
  EXPECT_DOUBLE_EQ(longer.at(4).position, 3 + 4 * 2);
  EXPECT_EQ(state_at(jog, 4), (MotionState{11, 4, 0}));
}

TEST(Until, ARestIsARestWhateverRoundingLeaves) {
  const Trajectory rest = running();
  for (const double t : {rest.end(), std::nextafter(rest.end(), 0), 1e9}) {
    EXPECT_EQ(state_at(rest, t).velocity, 0);
    EXPECT_EQ(state_at(rest, t).acceleration, 0);
  }
  // A trapezoid's deceleration ends with it.
  const Trajectory stopped = trapezoid({.to = 5, .velocity = 1, .acceleration = 3}).curve();
  EXPECT_EQ(state_at(stopped, stopped.end()).acceleration, 0);
}

TEST(Until, RejectsTimesBeforeTheMotion) {
  EXPECT_THROW(until(running(), 0.5), InputError);
  EXPECT_THROW(until(running(), 1), InputError);
  EXPECT_THROW(state_at(running(), 0.5), InputError);
  EXPECT_THROW(until(running(), std::nan("")), InputError);
}

double taken_over(const Trajectory& f, double t, double jerk = 1) {
  return state_for(f, t, jerk).acceleration;
}

TEST(StateFor, TakesOverWhatWasBuiltUpAndNoStep) {
  const Trajectory soft = running();                               // acceleration 20, 1.2 to 1.5
  const Trajectory step({cubic(1, 0, 0, 5, 10), line(1, 5, 15)});  // 10 for 1 s
  EXPECT_NEAR(taken_over(soft, 1.1), 10, 1e-12);
  EXPECT_DOUBLE_EQ(taken_over(soft, 1.3), 20);
  EXPECT_EQ(taken_over(soft, 1.3, 0), 0);
  for (const double t : {0.0, 0.5, std::nextafter(1.0, 0)}) EXPECT_EQ(taken_over(step, t), 0);
  EXPECT_EQ(state_at(step, 0.5).acceleration, 10);
  // Out of the step and into it, several commands and cuts deep.
  const Trajectory twice = spliced(step, 0.3, Trajectory({cubic(1, 1.35, 3, 9.35, 13)}));
  EXPECT_EQ(taken_over(twice, 0.2), 0);
  EXPECT_EQ(taken_over(twice, 0.8), 0);
  const Trajectory built = spliced(soft, 1.3, step);
  EXPECT_DOUBLE_EQ(taken_over(built, 1.25), 20);
  EXPECT_EQ(taken_over(built, 1.8), 0);
  // One that a motion begins with and leads to zero is a state.
  const Trajectory given({quintic(1, 0, 1, 7, 3, 2, 0)});
  EXPECT_DOUBLE_EQ(taken_over(given, 0), 7);
}

TEST(Spliced, ContinuesWithTheNextMotionWhateverItsTime) {
  const Trajectory f = running();
  const Profile back =
      s_curve({.from = 50, .to = 0, .velocity = 5, .acceleration = 20, .jerk = 100});
  const Trajectory both = spliced(f, 8, back);
  EXPECT_DOUBLE_EQ(both.end(), 8 + back.duration());
  EXPECT_NEAR(both.at(both.end()).position, 0, 1e-14);
  test::expect_invariants(both, 2);
  EXPECT_EQ(spliced(f, 8, shifted(back.curve(), 77)).breaks().size(), both.breaks().size());
}

TEST(Spliced, AtTheStartOnlyTheNextMotionIsLeft) {
  const Profile next = s_curve({.to = 5, .velocity = 5, .acceleration = 20, .jerk = 100});
  const Trajectory f = spliced(running(), 1, next);
  EXPECT_EQ(f.start(), 1);
  EXPECT_EQ(f.segments().size(), next.phases());
  EXPECT_EQ(spliced(running(), 1, next.curve()).start(), 1);
  EXPECT_THROW(spliced(running(), 1, Profile({}, 3)), InputError);
  EXPECT_EQ(spliced(running(), 2, Profile({}, 3)).end(), 2);  // nothing follows
}

TEST(Superimposed, StandsBeforeAndAfter) {
  const Trajectory f = running();
  const Trajectory g = shifted(f, 3);
  const Trajectory sum = superimposed(f, g);
  EXPECT_EQ(sum.start(), 1);
  EXPECT_DOUBLE_EQ(sum.end(), g.end());
  EXPECT_DOUBLE_EQ(sum.at(2).position, f.at(2).position);
  EXPECT_DOUBLE_EQ(sum.at(5).position, f.at(5).position + g.at(5).position);
  EXPECT_DOUBLE_EQ(sum.at(9.5).position, 50 + g.at(9.5).position);
  EXPECT_DOUBLE_EQ(superimposed(g, f).at(5).position, sum.at(5).position);
  test::expect_invariants(sum, 2);
}

}  // namespace
}  // namespace jounce::splice_test
