// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/jog.hpp"

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

namespace jounce::jog_test {
namespace {

using path_tests::Random;
using path_tests::usual;

/// By hand: 0.2 s and 10 mm to 100 mm/s, 0.8 s at it, 0.2 s and 10 mm to rest.
TEST(Jog, EndsAfterItsRelease) {
  const Plan jog = jogged({}, {2}, 100, 1, usual(1));
  EXPECT_NEAR(jog.duration(), 1.2, 1e-9);
  std::vector<Motion> end(1);
  jog.at(jog.duration(), end);
  EXPECT_NEAR(end[0].position, 100, 1e-9);
}

TEST(Jog, StaysOnItsLineWithinTheLimits) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    GroupLimits limits = usual(3, random.log_between(1e3, 1e6));
    for (Limits& axis : limits.axes) axis.velocity = random.log_between(20, 500);
    Point direction{};
    for (std::size_t i = 0; i < 3; ++i) direction[i] = random.between(-1, 1);
    const Point from{1, 2, 3};
    const double released = random.log_between(1e-3, 3);
    const Plan jog = jogged(from, direction, random.log_between(1, 500), released, limits);
    const PlanAxes axes = to_axes(jog);
    EXPECT_LE(path_tests::excess(axes, limits), 1e-12);
    EXPECT_GE(jog.duration(), released);
    std::vector<Motion> now(3);
    jog.at(jog.duration() * 0.6, now);
    const double share = (now[0].position - from[0]) / direction[0];
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(now[i].position, from[i] + share * direction[i], 1e-8);
  }
}

TEST(Jog, RejectsBadInput) {
  EXPECT_THROW(jogged({}, {}, 1, 1, usual(1)), InputError);
  EXPECT_THROW(jogged({}, {1}, 0, 1, usual(1)), InputError);
  EXPECT_THROW(jogged({}, {1}, 1, -1, usual(1)), InputError);
  EXPECT_THROW(jogged({}, {1}, 1, 1, {.axes = std::vector<Limits>(1)}), InputError);
}

}  // namespace
}  // namespace jounce::jog_test
