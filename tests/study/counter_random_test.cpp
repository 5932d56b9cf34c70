// SPDX-License-Identifier: Apache-2.0
#include "study/src/sweep/counter_random.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jounce::counter_random_test {
namespace {

using ::testing::ElementsAre;

// The known answers of the authors' Random123 (kat_vectors, philox4x32 with 10 rounds).
TEST(CounterRandom, GivesTheKnownAnswers) {
  EXPECT_THAT(philox({0, 0, 0, 0}, {0, 0}),
              ElementsAre(0x6627e8d5U, 0xe169c58dU, 0xbc57ac4cU, 0x9b00dbd8U));
  EXPECT_THAT(
      philox({0x243f6a88U, 0x85a308d3U, 0x13198a2eU, 0x03707344U}, {0xa4093822U, 0x299f31d0U}),
      ElementsAre(0xd16cfe09U, 0x94fdccebU, 0x5001e420U, 0x24126ea1U));
}

TEST(CounterRandom, HasTheMomentsOfItsDistributions) {
  constexpr int n = 100'000;
  double u = 0, u2 = 0, g = 0, g2 = 0, g4 = 0, both = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = uniform({3, stream_of("a"), i}) - 0.5;
    const double y = normal({3, stream_of("b"), i});
    EXPECT_LT(std::abs(x), 0.5);
    u += x, u2 += x * x, g += y, g2 += y * y, g4 += y * y * y * y, both += x * y;
  }
  // Five standard deviations of each estimate.
  EXPECT_NEAR(u / n, 0, 5 / std::sqrt(12.0 * n));
  EXPECT_NEAR(u2 / n, 1.0 / 12, 5 / std::sqrt(180.0 * n));
  EXPECT_NEAR(g / n, 0, 5 / std::sqrt(1.0 * n));
  EXPECT_NEAR(g2 / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(g4 / n, 3, 5 * std::sqrt(96.0 / n));
  EXPECT_NEAR(both / n, 0, 5 / std::sqrt(12.0 * n));
}

TEST(CounterRandom, DependsOnItsAddressAlone) {
  const Draw draw{1, stream_of("master.velocity"), 17};
  EXPECT_EQ(uniform(draw), uniform(draw));
  EXPECT_NE(uniform(draw), uniform({2, draw.stream, 17}));
  EXPECT_NE(uniform(draw), uniform({1, stream_of("master.distance"), 17}));
  EXPECT_NE(uniform(draw), uniform({1, draw.stream, 18}));
}

}  // namespace
}  // namespace jounce::counter_random_test
