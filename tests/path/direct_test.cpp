// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/direct.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce::direct_test {
namespace {

const std::vector<Limits> limits{{.velocity = 100, .acceleration = 1000, .jerk = 1e4},
                                 {.velocity = 50, .acceleration = 500, .jerk = 5e3},
                                 {.velocity = 10, .acceleration = 10, .jerk = 10}};

TEST(Direct, FastAxesGoOnTheirOwn) {
  // The first axis alone: 200 / 100 + 100 / 1000 + 1000 / 1e4; the second needs 20 / 50 + 0.1 + 0.1.
  const std::vector<Trajectory> axes = direct({}, {200, 20, 0}, limits);
  ASSERT_EQ(axes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(axes[i].end(), 2.2, 1e-12);
    EXPECT_TRUE(check(axes[i], limits[i]).ok());
  }
  EXPECT_EQ(axes[1].at(axes[1].end(), Side::left).position, 20);
  EXPECT_NEAR(axes[1].at(0.6).position, 20, 1e-12);  // 20 / 50 + 50 / 500 + 500 / 5e3 = 0.6 s
  EXPECT_LT(axes[1].at(0.59).position, 20);
  EXPECT_EQ(axes[2].at(1).position, 0);
}

TEST(Direct, PathInvariantIsAStraightLine) {
  const std::vector<Trajectory> axes =
      direct({1, 2, 3}, {201, -58, 3}, limits, DirectMode::path_invariant);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(check(axes[i], limits[i]).ok());
  for (int k = 0; k <= 100; ++k) {
    const double t = axes[0].end() * k / 100;
    const double share = (axes[0].at(t, Side::left).position - 1) / 200;
    EXPECT_NEAR(axes[1].at(t, Side::left).position, 2 - 60 * share, 1e-11);
  }
}

TEST(Direct, RejectsBadInput) {
  EXPECT_THROW(direct({}, {}, limits), InputError);
  EXPECT_THROW(direct({}, {1}, {}), InputError);
  EXPECT_THROW(direct({}, {std::nan("")}, limits), InputError);
  EXPECT_THROW(direct({}, {5}, {{.position_max = 4, .velocity = 1}}), InputError);
}

}  // namespace
}  // namespace jounce::direct_test
