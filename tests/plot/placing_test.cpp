// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/placing.hpp"

#include <array>

#include <gtest/gtest.h>

namespace jounce::placing_test {
namespace {

constexpr Rectangle box{10, 10, 20, 20};

TEST(Crosses, SeesEveryWayThroughABox) {
  EXPECT_TRUE(crosses(box, {0, 15}, {30, 15}));
  EXPECT_TRUE(crosses(box, {15, 0}, {15, 30}));
  EXPECT_TRUE(crosses(box, {12, 12}, {13, 13}));
  EXPECT_TRUE(crosses(box, {0, 5}, {25, 30}));
  EXPECT_FALSE(crosses(box, {0, 15}, {9, 15}));
  EXPECT_FALSE(crosses(box, {0, 25}, {30, 25}));
  EXPECT_FALSE(crosses(box, {0, 15}, {15, 35}));
}

TEST(Overlap, LeavesTouchingBoxesAlone) {
  EXPECT_TRUE(overlap(box, {19, 19, 30, 30}));
  EXPECT_FALSE(overlap(box, {20, 10, 30, 20}));
  EXPECT_FALSE(overlap(box, {10, 21, 20, 30}));
}

TEST(Place, PrefersTheFirstThatIsClear) {
  const Surroundings around{{0, 0, 100, 100}, {{0, 0, 30, 30}}, {{{0, 50}, {100, 50}}}};
  const std::array candidates{Rectangle{20, 20, 40, 40}, Rectangle{40, 45, 60, 55},
                              Rectangle{40, 60, 60, 70}, Rectangle{40, 80, 60, 90}};
  EXPECT_EQ(place(around, candidates), 2U);  // not on what is taken, not on the line
}

TEST(Place, CrossesALineIfItMust) {
  const Surroundings around{{0, 0, 100, 60}, {}, {{{0, 50}, {100, 50}}}};
  const std::array candidates{Rectangle{40, 45, 60, 75}, Rectangle{40, 45, 60, 55}};
  EXPECT_EQ(place(around, candidates), 1U);  // the first leaves the frame
}

TEST(Place, ReportsAFullPicture) {
  const Surroundings around{{0, 0, 100, 100}, {{0, 0, 100, 100}}, {}};
  EXPECT_FALSE(place(around, std::array{Rectangle{40, 40, 60, 60}}).has_value());
  EXPECT_FALSE(place(around, {}).has_value());
}

}  // namespace
}  // namespace jounce::placing_test
