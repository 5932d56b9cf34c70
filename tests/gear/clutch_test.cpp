// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/clutch.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/controllers/gears.hpp"
#include "jounce/profiles/error.hpp"

#include "support/random.hpp"

namespace jounce::clutch_test {
namespace {

TEST(Clutch, OfGoogol75CoversAQuarterOfItsDistance) {
  const Clutch clutch = googol::set_gear_ratio(Gear::ratio(0, 1), {2, 1, 100000});
  Clutch::State state;
  std::int64_t master = 0;
  std::int64_t slave = 0;
  // Master: jog to 100 pulse/ms with 1 pulse/ms^2, sampled each ms: 100 t - 5000 after the ramp.
  int engaged_at = 0;
  std::int64_t last = 0;
  for (int t = 1; t <= 2000; ++t) {
    const std::int64_t to = t <= 100 ? t * t / 2 : 100 * t - 5000;
    last = clutch.advance(state, to - master);
    slave += last;
    master = to;
    if (state.engaged && engaged_at == 0) {
      engaged_at = t;
      EXPECT_EQ(slave, 25000);
    }
  }
  EXPECT_EQ(engaged_at, 1050);
  EXPECT_EQ(last, 50) << "pulse/ms";
  EXPECT_EQ(slave, 25000 + (master - 100000) / 2);
}

TEST(Clutch, IsExactWhateverTheIncrements) {
  test::Random random(11);
  for (int n = 0; n < 200; ++n) {
    const Gear from = Gear::ratio(random.below(2001) - 1000, 1 + random.below(300));
    const Gear to = Gear::ratio(random.below(2001) - 1000, 1 + random.below(300));
    const std::int64_t d = random.below(100'000);
    const Clutch clutch(from, to, d);
    const int sign = n % 2 == 0 ? 1 : -1;
    // In one stride, in many, and in many that also go back: the same in the end.
    Clutch::State one;
    Clutch::State many;
    const std::int64_t end = sign * (2 * d + 12345);
    const std::int64_t whole = clutch.advance(one, end);
    std::int64_t sum = 0;
    std::int64_t way = 0;
    while (way != end) {
      std::int64_t step =
          sign * std::min<std::int64_t>(1 + random.below(5000), std::abs(end - way));
      if (!many.engaged && random.below(3) == 0) step = -way / 3;
      sum += clutch.advance(many, step);
      way += step;
    }
    EXPECT_EQ(sum, whole) << n;
    // d (r0 + r1) / 2, then r1: in long double, whose 64 bits hold it.
    const auto r = [](const Gear& g) {
      return static_cast<long double>(g.numerator()) / static_cast<long double>(g.denominator());
    };
    const long double exact = sign * (static_cast<long double>(d) * (r(from) + r(to)) / 2 +
                                      static_cast<long double>(d + 12345) * r(to));
    EXPECT_LE(std::abs(static_cast<long double>(whole) - exact), 1 + 1e-9L) << n;
  }
}

TEST(Clutch, RetracesWhereTheMasterReversesInsideIt) {
  const Clutch clutch(Gear::ratio(0, 1), Gear::ratio(3, 1), 1000);
  Clutch::State state;
  std::int64_t slave = 0;
  std::int64_t before = 0;
  const auto go = [&](int step, int times) {
    for (int i = 0; i < times; ++i) {
      const std::int64_t now = clutch.advance(state, step);
      EXPECT_LE(std::abs(now - before), 2) << "no step, at " << state.way;
      before = now;
      slave += now;
    }
  };
  go(1, 600);
  EXPECT_EQ(slave, 3 * 600 * 600 / 2000);
  EXPECT_EQ(clutch.ratio(state).numerator(), 9);
  EXPECT_EQ(clutch.ratio(state).denominator(), 5);
  before = 0;  // the master turns round: its increment, and so the slave's, changes sign
  go(-1, 600);
  EXPECT_EQ(slave, 0);
  EXPECT_FALSE(state.engaged);
  go(-1, 999);
  EXPECT_EQ(slave, -(3 * 999 * 999 + 1999) / 2000) << "and on the other side likewise";
  EXPECT_FALSE(state.engaged);
  go(-1, 1);
  EXPECT_TRUE(state.engaged);
  EXPECT_EQ(slave, -1500);
  before = 0;
  slave += clutch.advance(state, 500);
  EXPECT_EQ(slave, 0) << "once engaged, the new ratio holds backwards, too";
}

TEST(Clutch, TakesOverFromAnotherOneAnywhere) {
  // Fig. 7-10: 4:3 with a clutch, later 2:1 by a second one. Master : slave.
  const Clutch first = googol::set_gear_ratio(Gear::ratio(0, 1), {4, 3, 1000});
  Clutch::State state;
  std::int64_t slave = first.advance(state, 3000);
  EXPECT_EQ(slave, 375 + 1500);
  const Clutch second = googol::set_gear_ratio(first.ratio(state), {2, 1, 500});
  state = second.after(first, state);
  slave += second.advance(state, 500);
  EXPECT_EQ(slave, 1875 + 312) << "500 (3/4 + 1/2) / 2 = 312.5";
  slave += second.advance(state, 1000);
  EXPECT_EQ(slave, 1875 + 812) << "the half is carried on";
  slave += second.advance(state, 1);
  EXPECT_EQ(slave, 1875 + 813);

  const Clutch third(first.ratio({.way = 500}), Gear::ratio(0, 1), 800);
  EXPECT_EQ(third.ratio({}).numerator(), 3);
  EXPECT_EQ(third.ratio({}).denominator(), 8);
}

TEST(Clutch, TakesOverTenThousandTimes) {
  test::Random random(5);
  const auto r = [](const Gear& g) {
    return static_cast<long double>(g.numerator()) / static_cast<long double>(g.denominator());
  };
  Clutch clutch(Gear::ratio(0, 1), Gear::ratio(1, 2), 100'000);
  Clutch::State state;
  std::int64_t slave = 0;
  long double exact = 0;  // sum with the ratio never rounded
  long double ratio = 0;
  long double target = 0.5L;
  double d = 100'000;
  for (int n = 0; n < 10'000; ++n) {
    const std::int64_t way = 1 + random.below(90'000);  // inside the clutch: d is 100000 or more
    slave += clutch.advance(state, way);
    const auto u = static_cast<long double>(way);
    exact += ratio * u + (target - ratio) * u * u / (2 * d);
    ratio += (target - ratio) * u / d;
    ASSERT_FALSE(state.engaged);
    ASSERT_NEAR(static_cast<double>(r(clutch.ratio(state)) - ratio), 0, 1e-11) << n;
    ASSERT_NEAR(static_cast<double>(exact - static_cast<long double>(slave)), 0.5, 0.51) << n;
    const Gear to = Gear::ratio(random.below(2001) - 1000, 1 + random.below(1000));
    d = 100'000 + random.below(100'000);
    const Clutch next(clutch.ratio(state), to, static_cast<std::int64_t>(d));
    state = next.after(clutch, state);
    clutch = next;
    target = r(to);
  }
}

TEST(Clutch, OfNoDistanceChangesAtOnce) {
  const Clutch clutch = googol::set_gear_ratio(Gear::ratio(1, 3), {1, -2, 0});
  Clutch::State state;
  EXPECT_EQ(clutch.ratio(state).numerator(), -2);
  EXPECT_EQ(clutch.advance(state, 7), -14);
  EXPECT_TRUE(state.engaged);
}

TEST(Clutch, RejectsAsTheManual) {
  const Gear stands = Gear::ratio(0, 1);
  for (const auto& [ratio, words] :
       {std::pair{googol::GearRatio{2, 1, 1}, "masterSlope = 1: must not be 1 (manual I-140)"},
        {googol::GearRatio{2, 1, -5}, "masterSlope = -5: must not be negative"},
        {googol::GearRatio{0, 1, 0}, "masterEven = 0: must be greater than 0"}})
    try {
      googol::set_gear_ratio(stands, ratio);
      FAIL() << words;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(words)) << error.what();
    }
  EXPECT_THROW(Clutch(stands, Gear::ratio(1, 3), INT64_MAX), InputError);
  EXPECT_THROW(googol::prf_gear(2), InputError);
}

TEST(Gear, OfAgitoCounts65536ForOne) {
  EXPECT_EQ(agito::gear(65536).slave(12345), 12345);
  EXPECT_EQ(agito::gear(131072).slave(-7), -14);
  EXPECT_EQ(agito::gear(196608).slave(5), 15);
  EXPECT_EQ(agito::gear(1).slave(65535), 0);
  EXPECT_EQ(agito::gear(1).slave(65536), 1);
}

// ---- direction -------------------------------------------------------------------------------

/// Slave positions behind a mask, for a master at the whole part of a sine.
std::vector<std::int64_t> followed(const DirectionMask& mask, std::vector<std::int64_t>& master) {
  DirectionMask::State state;
  std::vector<std::int64_t> slave{0};
  master = {0};
  for (int i = 1; i <= 2000; ++i) {
    master.push_back(static_cast<std::int64_t>(std::floor(1e5 * std::sin(i * 6.2831853 / 1000))));
    slave.push_back(slave.back() + mask.advance(state, master.back() - master[master.size() - 2]));
  }
  return slave;
}

TEST(DirectionMask, HoldsWithoutAStepWhereTheMasterReverses) {
  for (const int dir : {1, -1}) {
    std::vector<std::int64_t> master;
    const auto slave = followed(googol::prf_gear(dir), master);
    std::int64_t velocity = slave[1];
    std::int64_t up = 0;
    for (std::size_t i = 1; i < slave.size(); ++i) {
      const std::int64_t v = slave[i] - slave[i - 1];
      EXPECT_GE(dir * v, 0);
      EXPECT_LE(std::abs(v - velocity), 6) << "the velocity steps at " << i;
      velocity = v;
      const std::int64_t m = master[i] - master[i - 1];
      if (dir * m > 0) up += m;
    }
    EXPECT_EQ(slave.back(), up);
  }
}

TEST(DirectionMask, RecoversTheFurthestPosition) {
  std::vector<std::int64_t> master;
  const auto slave = followed({FollowDirection::positive, Reversal::recover}, master);
  std::int64_t furthest = 0;
  for (std::size_t i = 0; i < slave.size(); ++i) {
    furthest = std::max(furthest, master[i]);
    ASSERT_EQ(slave[i], furthest) << i;
  }
  const auto back = followed({FollowDirection::negative, Reversal::recover}, master);
  EXPECT_EQ(back.back(), *std::min_element(master.begin(), master.end()));
}

TEST(DirectionMask, TremblingCreepsOnlyWhereItHolds) {
  DirectionMask::State a, b;
  std::int64_t holds = 0, recovers = 0;
  for (int i = 0; i < 1000; ++i) {
    const int step = i % 2 == 0 ? 1 : -1;
    holds += DirectionMask{FollowDirection::positive}.advance(a, step);
    recovers += DirectionMask{FollowDirection::positive, Reversal::recover}.advance(b, step);
  }
  EXPECT_EQ(holds, 500);
  EXPECT_EQ(recovers, 1);
}

TEST(DirectionMask, OfBothLetsEverythingThrough) {
  DirectionMask::State state;
  EXPECT_EQ(googol::prf_gear(0).advance(state, -5), -5);
  EXPECT_EQ(googol::prf_gear(0).advance(state, 5), 5);
}

}  // namespace
}  // namespace jounce::clutch_test
