// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/ticks.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jounce::ticks_test {
namespace {

using testing::ElementsAre;

TEST(Ticks, StandAtNiceNumbers) {
  const Ticks t = ticks({-3.4, 2.2}, 6);
  EXPECT_THAT(t.at, ElementsAre(-3, -2, -1, 0, 1, 2));
  EXPECT_THAT(t.labels, ElementsAre("−3", "−2", "−1", "0", "1", "2"));
  EXPECT_EQ(t.exponent, 0);
}

TEST(Ticks, ShowNoMoreDecimalsThanTheStepHas) {
  EXPECT_THAT(ticks({-0.16, 0.14}, 6).labels,
              ElementsAre("−0.15", "−0.10", "−0.05", "0", "0.05", "0.10"));
  EXPECT_THAT(ticks({0, 1}, 5).labels, ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1.0"));
}

TEST(Ticks, ShareAPowerOfAThousand) {
  const Ticks large = ticks({0, 2.5e12}, 5);
  EXPECT_EQ(large.exponent, 12);
  EXPECT_THAT(large.labels, ElementsAre("0", "0.5", "1.0", "1.5", "2.0", "2.5"));
  const Ticks small = ticks({-3e-12, 1e-12}, 4);
  EXPECT_EQ(small.exponent, -12);
  EXPECT_THAT(small.labels, ElementsAre("−3", "−2", "−1", "0", "1"));
}

TEST(DecadeTicks, StandAtNumbersOfTheLogarithmsAxis) {
  const Ticks fine = decade_ticks({0, 2.1}, 12);
  EXPECT_THAT(fine.labels, ElementsAre("1", "2", "5", "10", "20", "50", "100"));
  EXPECT_NEAR(fine.at[1], std::log10(2), 1e-15);
  EXPECT_EQ(fine.exponent, 0);
  EXPECT_THAT(decade_ticks({-2.5, 3.2}, 6).labels,
              ElementsAre("0.01", "0.1", "1", "10", "100", "1000"));
  EXPECT_THAT(decade_ticks({-6, 6}, 4).labels,
              ElementsAre("1e-06", "0.001", "1", "1000", "1000000"));
}

TEST(AngleTicks, DivideTheTurn) {
  EXPECT_THAT(angle_ticks({0, 360}, 12).at,
              ElementsAre(0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330, 360));
  EXPECT_THAT(angle_ticks({0, 360}, 8).at, ElementsAre(0, 45, 90, 135, 180, 225, 270, 315, 360));
  EXPECT_THAT(angle_ticks({0, 360}, 6).at, ElementsAre(0, 60, 120, 180, 240, 300, 360));
  EXPECT_THAT(angle_ticks({0, 360}, 4).at, ElementsAre(0, 90, 180, 270, 360));
  EXPECT_THAT(angle_ticks({-90, 90}, 4).at, ElementsAre(-90, -45, 0, 45, 90));
  EXPECT_THAT(angle_ticks({0, 1080}, 3).at, ElementsAre(0, 360, 720, 1080));
  EXPECT_THAT(angle_ticks({0, 3600}, 5).at, ElementsAre(0, 720, 1440, 2160, 2880, 3600));
}

TEST(AngleTicks, AreDecimalOnASmallAngle) {
  EXPECT_THAT(angle_ticks({0, 10}, 5).at, ElementsAre(0, 2, 4, 6, 8, 10));
}

TEST(Ticks, AreFewFiniteAndDistinctOnAnyAxis) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const double size = std::pow(10, -290 + 580 * uniform());
    const double middle = size * (2 * uniform() - 1) * std::pow(10, 6 * uniform());
    const PlotRange axis = axis_extent({middle - size * uniform(), middle + size * uniform()});
    const int most = 1 + static_cast<int>(12 * uniform());
    const Ticks t = i % 2 == 0 ? ticks(axis, most) : angle_ticks(axis, most);
    ASSERT_EQ(t.at.size(), t.labels.size());
    ASSERT_LE(t.at.size(), static_cast<std::size_t>(most) + 1);
    const double rounding = 1e-9 * axis.span();
    for (std::size_t k = 0; k < t.at.size(); ++k) {
      ASSERT_GE(t.at[k], axis.lo - rounding);
      ASSERT_LE(t.at[k], axis.hi + rounding);
      ASSERT_TRUE(k == 0 || t.at[k] > t.at[k - 1]);
    }
    const std::set<std::string> distinct(t.labels.begin(), t.labels.end());
    ASSERT_EQ(distinct.size(), t.labels.size()) << axis.lo << " " << axis.hi;
  }
}

TEST(AxisExtent, IsNeverEmpty) {
  for (const PlotRange data :
       {PlotRange{}, PlotRange{0, 0}, PlotRange{5, 5}, PlotRange{-1e300, -1e300},
        PlotRange{1e-320, 2e-320}, PlotRange{1e12, 1e12 + 1e-4}}) {
    const PlotRange axis = axis_extent(data);
    EXPECT_GT(axis.span(), 0);
    EXPECT_TRUE(std::isfinite(axis.span()));
    if (!data.empty()) {
      EXPECT_LE(axis.lo, data.lo);
      EXPECT_GE(axis.hi, data.hi);
    }
  }
}

TEST(AxisExtent, TakesNoiseForAConstant) {
  EXPECT_EQ(axis_extent({-1e-17, 1e-17}, 1e-15).hi, 1);
  EXPECT_DOUBLE_EQ(axis_extent({2, 2 + 1e-10}, 1e-9).lo, 0.9 * (2 + 0.5e-10));
  EXPECT_EQ(axis_extent({2, 2 + 1e-10}, 1e-11).lo, 2);
}

TEST(PlotRange, IgnoresWhatCannotBeDrawn) {
  PlotRange extent;
  extent.add(std::numeric_limits<double>::quiet_NaN());
  extent.add(std::numeric_limits<double>::infinity());
  extent.add(std::numeric_limits<double>::max());
  EXPECT_TRUE(extent.empty());
  extent.add(-3);
  EXPECT_EQ(extent.lo, -3);
  EXPECT_EQ(extent.hi, -3);
}

}  // namespace
}  // namespace jounce::ticks_test
