// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear.hpp"

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/oracle.hpp"
#include "support/random.hpp"

namespace jounce::gear_test {
namespace {

using test::oracle;

TEST(Gear, IsExactAtEveryCountOfTheOracle) {
  const auto& n = oracle("gear")["n"];
  int compared = 0;
  for (const auto& ratio : oracle("gear")["ratios"]) {
    const std::int64_t q = std::stoll(ratio["q"].get<std::string>());
    const std::int64_t sign = q < 0 ? -1 : 1;
    const Gear gear = Gear::ratio(sign * std::stoll(ratio["p"].get<std::string>()), sign * q);
    for (std::size_t i = 0; i < n.size(); ++i) {
      std::int64_t expected = 0;
      std::int64_t master = 0;
      try {
        expected = std::stoll(ratio["floor"][i].get<std::string>());
        master = std::stoll(n[i].get<std::string>());
      } catch (const std::out_of_range&) {
        continue;  // beyond 64 bits: outside what the gear promises
      }
      EXPECT_EQ(gear.slave(master), expected)
          << gear.numerator() << "/" << gear.denominator() << " * " << master;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(Gear, CarriesTheRemainderWithoutDriftForwardAndBack) {
  const Gear gear = Gear::ratio(4000, 3072);
  Gear::State state;
  test::Random random(1);
  std::int64_t master = 0;
  std::int64_t slave = 0;
  const auto move = [&](std::int64_t increment) {
    master += increment;
    slave += gear.advance(state, increment);
    ASSERT_EQ(slave, gear.slave(master)) << "at " << master;
  };
  // A thousand billion counts in uneven steps, and back through zero to as many below.
  while (master < 1'000'000'000'000) move(1 + random.below(100'000'000));
  while (master > -1'000'000'000'000) move(-1 - random.below(100'000'000));
  move(-master);
  EXPECT_EQ(slave, 0);
  EXPECT_EQ(state.remainder, 0);
}

TEST(Gear, SingleCountsAddUp) {
  for (const auto& [p, q] : {std::pair{1, 3}, {-7, 3}, {65536, 65535}, {5, 1}}) {
    const Gear gear = Gear::ratio(p, q);
    Gear::State state;
    std::int64_t slave = 0;
    for (int i = 0; i < 10'000; ++i) slave += gear.advance(state, 1);
    EXPECT_EQ(slave, gear.slave(10'000));
    for (int i = 0; i < 20'000; ++i) slave += gear.advance(state, -1);
    EXPECT_EQ(slave, gear.slave(-10'000));
  }
}

TEST(Gear, IsReducedAndRejectsWhatIsNoRatio) {
  EXPECT_EQ(Gear::ratio(4000, 3072).numerator(), 125);
  EXPECT_EQ(Gear::ratio(4000, 3072).denominator(), 96);
  EXPECT_THROW(Gear::ratio(1, 0), InputError);
  EXPECT_THROW(Gear::ratio(1, -2), InputError);
  EXPECT_EQ(Gear::ratio(0, 2).slave(12345), 0) << "a ratio of 0 holds the slave";
  EXPECT_THROW(Gear::ratio(INT64_MIN, 2), InputError);
}

}  // namespace
}  // namespace jounce::gear_test
