// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/encoder_follow.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::encoder_follow_test {
namespace {

TEST(EncoderFollow, LosesNoCountWhateverTheFilter) {
  for (const int filter : {1, 2, 7, 100}) {
    const EncoderFollow follow({.numerator = 125, .denominator = 96, .filter = filter});
    const Gear gear = Gear::ratio(125, 96);
    EncoderFollow::State state;
    test::Random random(static_cast<std::uint64_t>(filter));
    std::int64_t encoder = 0;
    std::int64_t slave = 0;
    for (int round = 0; round < 50; ++round) {
      for (int i = 0; i < 1000; ++i) {
        const int step = random.below(2'000'000'001) - (round < 30 ? 0 : 1'500'000'000);
        encoder += step;
        slave += follow.step(state, step);
      }
      for (int i = 1; i < filter; ++i) slave += follow.step(state, 0);
      ASSERT_EQ(slave, gear.slave(encoder)) << filter << ", round " << round;
    }
    EXPECT_EQ(follow.step(state, 0), 0) << "at rest";
  }
}

TEST(EncoderFollow, AveragesOverTheCycles) {
  const EncoderFollow follow({.filter = 4});
  EncoderFollow::State state;
  const int encoder[] = {40, 40, 40, 40, 0, 0, 0, 0};
  const int slave[] = {10, 20, 30, 40, 30, 20, 10, 0};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(follow.step(state, encoder[i]), slave[i]) << i;
}

TEST(EncoderFollow, SpreadsAnAdditionThatTheRatioDoesNotTouch) {
  const EncoderFollow follow({.numerator = 3, .denominator = 7, .filter = 1});
  EncoderFollow::State state;
  EncoderFollow::add(state, -1003, 100);
  std::int64_t slave = 0;
  for (int i = 0; i < 100; ++i) {
    const std::int64_t now = follow.step(state, 0);
    EXPECT_TRUE(now == -10 || now == -11) << now;
    slave += now;
  }
  EXPECT_EQ(slave, -1003);
  EXPECT_EQ(follow.step(state, 0), 0);
  EncoderFollow::add(state, 100, 10);
  for (int i = 0; i < 5; ++i) slave += follow.step(state, 700);
  EncoderFollow::add(state, 7, 3);  // 50 are left
  for (int i = 0; i < 3; ++i) slave += follow.step(state, 0);
  EXPECT_EQ(slave, -1003 + 107 + 5 * 300);
  EXPECT_THROW(EncoderFollow::add(state, 1, 0), InputError);
}

TEST(EncoderFollow, KeepsAnAdditionWithinAPulseOfTheLine) {
  const EncoderFollow follow({.filter = 1});
  for (const std::int64_t pulses : {500, 1500, 150, 1, -1, -500, -1499}) {
    for (const std::int64_t cycles : {1, 100, 999, 1000}) {
      EncoderFollow::State state;
      EncoderFollow::add(state, pulses, cycles);
      std::int64_t slave = 0;
      for (std::int64_t k = 1; k <= cycles; ++k) {
        slave += follow.step(state, 0);
        const double line = static_cast<double>(k * pulses) / static_cast<double>(cycles);
        ASSERT_LT(std::abs(static_cast<double>(slave) - line), 1) << pulses << " in " << cycles;
      }
      EXPECT_EQ(slave, pulses);
      EXPECT_EQ(state.additive, 0);
    }
  }
}

TEST(EncoderFollow, RejectsInTheControllersNumbers) {
  const auto words = [](const EncoderFollowSpec& spec) -> std::string {
    return test::error_of([&] { (void)EncoderFollow(spec); });
  };
  EXPECT_EQ(words({.denominator = 0}),
            "denominator = 0: must be between 1 and 10000 (PMC600 error 5000)");
  EXPECT_EQ(words({.filter = 101}), "filter = 101: must be between 1 and 100 (PMC600 error 5002)");
  EXPECT_EQ(words({.numerator = 10001}), "numerator = 10001: must be between 1 and 10000");
}

}  // namespace
}  // namespace jounce::encoder_follow_test
