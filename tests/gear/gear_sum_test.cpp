// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear_sum.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/random.hpp"

namespace jounce::gear_sum_test {
namespace {

__extension__ using Wide = __int128;

std::int64_t floor_of(Wide a, Wide b) {
  return static_cast<std::int64_t>(a >= 0 ? a / b : -((-a + b - 1) / b));
}

TEST(GearSum, IsTheSumRoundedOnceNotTheSumOfTheRounded) {
  const std::array gears{Gear::ratio(1, 2), Gear::ratio(1, 2)};
  const GearSum sum = GearSum::of(gears);
  EXPECT_EQ(sum.slave(std::array<std::int64_t, 2>{1, 1}), 1);
  EXPECT_EQ(gears[0].slave(1) + gears[1].slave(1), 0);
  EXPECT_EQ(sum.slave(std::array<std::int64_t, 2>{-1, 0}), -1) << "towards minus infinity";
}

TEST(GearSum, DoesNotDriftOverABillionCountsThousandfoldOfEachForwardAndBack) {
  const std::array gears{Gear::ratio(4000, 3072), Gear::ratio(-7, 3), Gear::ratio(1, 65536)};
  const GearSum sum = GearSum::of(gears);
  const Wide d = Wide{96} * 65536;  // a common denominator of 96, 3, 65536
  test::Random random(5);
  std::array<std::int64_t, 3> masters{};
  Gear::State state;
  std::int64_t slave = 0;
  const auto move = [&](int sign) {
    std::array<std::int64_t, 3> step{};
    for (std::size_t i = 0; i < 3; ++i) {
      step[i] = sign * (1 + random.below(500'000'000));
      masters[i] += step[i];
    }
    slave += sum.advance(state, step);
    const Wide exact = Wide{masters[0]} * 125 * (d / 96) - Wide{masters[1]} * 7 * (d / 3) +
                       Wide{masters[2]} * (d / 65536);
    ASSERT_EQ(slave, floor_of(exact, d)) << masters[0] << " " << masters[1] << " " << masters[2];
    ASSERT_EQ(slave, sum.slave(masters));
  };
  while (masters[0] < 1'000'000'000'000) move(1);
  while (masters[0] > -1'000'000'000'000) move(-1);
  const std::array<std::int64_t, 3> home{-masters[0], -masters[1], -masters[2]};
  slave += sum.advance(state, home);
  EXPECT_EQ(slave, 0);
  EXPECT_EQ(state.remainder, 0);
}

TEST(GearSum, LosesNothingWhereModuloMastersWrap) {
  const std::array gears{Gear::ratio(125, 96), Gear::ratio(-1, 7)};
  const GearSum sum = GearSum::of(gears);
  const std::array<std::int64_t, 2> period{360'000, 4'294'967'296};
  test::Random random(7);
  std::array<std::int64_t, 2> masters{}, reading{};
  Gear::State state;
  std::int64_t slave = 0;
  for (int i = 0; i < 200'000; ++i) {
    std::array<std::int64_t, 2> step{};
    for (std::size_t k = 0; k < 2; ++k) {
      const int reach = static_cast<int>(std::min<std::int64_t>(period[k] / 2, 2'000'000'000));
      const std::int64_t way = random.below(reach) - (i < 150'000 ? reach / 5 : reach / 2);
      masters[k] += way;
      const std::int64_t now = ((masters[k] % period[k]) + period[k]) % period[k];
      step[k] = counter_increment(reading[k], now, period[k]);
      ASSERT_EQ(step[k], way);
      reading[k] = now;
    }
    slave += sum.advance(state, step);
  }
  EXPECT_GT(masters[0], 1'000'000'000) << "thousands of turns";
  EXPECT_EQ(slave, sum.slave(masters));
}

TEST(GearSum, CountsHalfAPeriodForwards) {
  EXPECT_EQ(counter_increment(0, 5, 10), 5);
  EXPECT_EQ(counter_increment(5, 0, 10), 5);
  EXPECT_EQ(counter_increment(0, 6, 10), -4);
  EXPECT_EQ(counter_increment(8, 0, 9), 1);
  EXPECT_EQ(counter_increment(0, 5, 9), -4);
  EXPECT_EQ(counter_increment(5, 0, 9), 4);
  EXPECT_EQ(counter_increment(0, 0, 1), 0);
}

TEST(GearSum, RejectsWhatHasNoCommonDenominator) {
  EXPECT_THROW(GearSum::of(std::vector<Gear>{}), InputError);
  const std::vector<Gear> primes{Gear::ratio(1, 4'294'967'291), Gear::ratio(1, 4'294'967'279)};
  EXPECT_THROW(GearSum::of(primes), InputError);
  const std::vector<Gear> large{Gear::ratio(INT64_MAX, 1), Gear::ratio(1, 1)};
  EXPECT_THROW(GearSum::of(large), InputError);
}

TEST(GearSum, RejectsAWrongNumberOfMasters) {
  const std::array gears{Gear::ratio(1, 2), Gear::ratio(1, 2)};
  const GearSum sum = GearSum::of(gears);
  Gear::State state;
  EXPECT_THROW((void)sum.slave(std::array<std::int64_t, 1>{1}), InputError);
  EXPECT_THROW((void)sum.advance(state, std::array<std::int64_t, 3>{1, 1, 1}), InputError);
}

}  // namespace
}  // namespace jounce::gear_sum_test
