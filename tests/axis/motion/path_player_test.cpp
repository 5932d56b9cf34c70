// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/path_player.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"
#include "support/loop_limit.hpp"

namespace jounce::path_player_test {
namespace {

using namespace test;

const AxisConfig config = resolved({.limits = limits(200, 2000, 1e5)});

Job stroke(double T = 2, Extrapolation outside = Extrapolation::hold) {
  return {7, there_and_back(0, 50, T, outside)};
}

/// The setpoint of this tick; it goes out.
Jet play(PathPlayer& player, std::int64_t tick) {
  const Jet next = player.play(player.time(tick), {}).slave;
  player.put_out(tick);
  return next;
}

TEST(PathPlayer, IsEmptyUntilAPathBegins) {
  Job job = stroke();
  PathPlayer player(config);
  EXPECT_FALSE(player);
  player.begin(job, 100, 1, 0);
  ASSERT_TRUE(player);
  EXPECT_EQ(player.path(), &job);
  EXPECT_TRUE(player.unplayed());
  player.finish_pass(100);
  player.end();
  EXPECT_FALSE(player);
  EXPECT_FALSE(player.finishes());
}

TEST(PathPlayer, AtFullSpeedPlaysThePathBitForBit) {
  Job job = stroke();
  PathPlayer player(config);
  player.begin(job, 100, 1, 0);
  for (std::int64_t k = 0; k <= 2000; ++k)
    ASSERT_EQ(play(player, 100 + k), job.at(static_cast<double>(k) / 1e3).slave) << k;
  EXPECT_FALSE(player.unplayed());
}

TEST(PathPlayer, BeginsBeforeItsTickByWhatIsOver) {
  Job job = stroke();
  PathPlayer player(config);
  player.begin(job, 100, 0.5, 0.0004);
  EXPECT_DOUBLE_EQ(player.time(100).s, 0.0002);
  EXPECT_EQ(player.time(100).rate, 0.5);
}

TEST(PathPlayer, RestsOnThePathAndGoesOnToItsEnd) {
  Job job = stroke();
  PathPlayer player(config);
  player.begin(job, 0, 1, 0);
  play(player, 0);
  PathTime last = player.time(0);
  for (std::int64_t tick = 1; tick < 5000; ++tick) {
    if (tick == 300) {
      ASSERT_TRUE(player.follow({.tick = tick, .rate = 0}));
    }
    if (tick == 2000) {
      EXPECT_TRUE(player.rests(tick));
      ASSERT_TRUE(player.follow({.tick = tick, .rate = 1}));
    }
    const PathTime time = player.time(tick);
    ASSERT_GE(time.s, last.s);
    const Jet next = play(player, tick);
    ASSERT_EQ(next[0], job.at(time.s).slave[0]) << "it left the path at " << tick;
    ASSERT_LE(std::abs(next[2]), config.stop_acceleration);
    last = time;
  }
  EXPECT_GT(last.s, 2);
}

TEST(PathPlayer, GrantsWhatTheLimitsLeaveOnThisPathAndOnTheNext) {
  Job fast = stroke(2);
  Job faster = stroke(1.1);
  PathPlayer player(config);
  player.begin(fast, 0, 2, 0);
  const double own = highest_rate(fast.peaks(), config);
  const double both = highest_rate(faster.peaks(), config);
  ASSERT_LT(both, own);
  ASSERT_GT(both, 1);
  EXPECT_EQ(player.granted(2, nullptr), own);
  EXPECT_EQ(player.granted(2, &faster), both);
  EXPECT_EQ(player.granted(0.7, &faster), 0.7);
  EXPECT_EQ(player.time(0).rate, own);
  Feed feed(8, 0, 10, 2);
  EXPECT_EQ(player.granted(2, &feed), 1) << "a growing path begins at full speed";
}

TEST(PathPlayer, ReportsTheLastTickInWhichAGrowingPathCanStop) {
  Feed feed(7, 0, 10, 5);
  feed.prefill(1);
  PathPlayer player(config);
  player.begin(feed, 0, 1.5, 0);
  EXPECT_EQ(player.time(0).rate, 1) << "it begins at full speed";
  std::int64_t tick = 0;
  for (test::LoopLimit loop; !player.starves({.tick = tick}) && loop.goes_on();) {
    ASSERT_LT(tick, 1000);
    play(player, tick++);
  }
  EXPECT_FALSE(player.starves({.tick = tick, .rate = 0})) << "it stops already";
  PathPlayer later = player;
  ASSERT_TRUE(player.stop({.tick = tick}));
  EXPECT_LE(player.time(tick + 5000).s, 1);
  // A tick later, the stop still begins after the last setpoint that went out.
  ASSERT_TRUE(later.stop({.tick = tick + 3}));
  EXPECT_LE(later.time(tick + 5000).s, 1);
  EXPECT_GT(later.time(tick + 5000).s, 1 - 0.01);
  EXPECT_TRUE(later.rests(tick + 5000));
}

TEST(PathPlayer, GovernsARateAboveOneByTheSupply) {
  Feed feed(7, 0, 10, 2);
  feed.prefill(4);
  PathPlayer player(config);
  player.begin(feed, 0, 1, 0);
  double most = 0;
  std::int64_t tick = 0;
  for (; !player.starves({.tick = tick, .rate = 1.8}); ++tick) {
    ASSERT_LT(tick, 4000);
    player.govern({.tick = tick, .rate = 1.8});
    most = std::max(most, player.time(tick).rate);
    play(player, tick);
  }
  EXPECT_GT(most, 1.5);
  EXPECT_NEAR(player.time(tick).rate, 1, 1e-9) << "it is an underrun only at full speed";
}

TEST(PathPlayer, FinishesAtTheEndOfThePass) {
  Job job = stroke(2, Extrapolation::wrap);
  PathPlayer player(config);
  player.begin(job, 0, 1, 0);
  play(player, 2500);
  player.finish_pass(2500);
  EXPECT_TRUE(player.finishes());
  EXPECT_EQ(player.boundary(), 4);
  EXPECT_FALSE(player.reaches_boundary(3999));
  EXPECT_TRUE(player.reaches_boundary(4000));
  player.begin(job, 3000, 1, 0);
  EXPECT_FALSE(player.finishes()) << "that boundary was on another path";
}

TEST(PathPlayer, SwapsAtTheEndOfAPathOrOfAPass) {
  Job once = stroke(2);
  Job wraps = stroke(2, Extrapolation::wrap);
  PathPlayer player(config);
  player.begin(once, 0, 1, 0);
  player.swap_at_end(500);
  EXPECT_TRUE(player.swaps());
  EXPECT_EQ(player.boundary(), 2);
  player.begin(wraps, 0, 1, 0);
  player.swap_at_end(2500);
  EXPECT_EQ(player.boundary(), 4);
  ASSERT_TRUE(player.reaches_boundary(4000));
  player.take_over(once, 4000, player.boundary());
  EXPECT_FALSE(player.swaps());
  EXPECT_EQ(player.path(), &once);
  EXPECT_NEAR(player.time(4100).s, 0.1, 1e-12);
  EXPECT_NEAR(play(player, 4100)[0], once.at(0.1).slave[0], 1e-9);
}

TEST(PathPlayer, TheEndOfAnOpenPathIsTheBoundaryAsSoonAsItIsAvailable) {
  Feed feed(7, 0, 10, 2);
  feed.prefill(1.5);
  PathPlayer player(config);
  player.begin(feed, 0, 1, 0);
  EXPECT_TRUE(player.open_ended());
  player.swap_at_end(0);
  EXPECT_EQ(player.boundary(), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(player.reaches_boundary(1600));
  feed.complete = true;
  EXPECT_EQ(player.boundary(), 1.5);
  EXPECT_TRUE(player.reaches_boundary(1500));
}

TEST(PathPlayer, FindsWhereItsMasterPassesAPosition) {
  Job job(7, constant_master(100, 50), pmc600_cam(), 1e-3);
  PathPlayer player(config);
  player.begin(job, 0, 1, 0);
  play(player, 1000);
  const auto s = player.passing(50.02, player.time(1001).s, {});
  ASSERT_TRUE(s);
  EXPECT_NEAR(*s, 1.0004, 1e-12);
  EXPECT_FALSE(player.passing(50.06, player.time(1001).s, {}));
  EXPECT_FALSE(player.passing(49.99, player.time(1001).s, {}));
}

TEST(PathPlayer, ItsPeaksGrowWithTheRate) {
  Job job = stroke();
  PathPlayer player(config);
  player.begin(job, 0, 0.5, 0);
  const Peaks whole = job.peaks();
  EXPECT_EQ(player.peaks_at_rate().velocity, whole.velocity) << "a resume may follow";
  const double rate = player.granted(2, nullptr);
  ASSERT_TRUE(player.follow({.tick = 0, .rate = 2}));
  EXPECT_DOUBLE_EQ(player.peaks_at_rate().velocity, whole.velocity * rate);
  EXPECT_DOUBLE_EQ(player.peaks_at_rate().acceleration, whole.acceleration * rate * rate);
  EXPECT_DOUBLE_EQ(player.peaks_at_rate().jerk, whole.jerk * rate * rate * rate);
}

}  // namespace
}  // namespace jounce::path_player_test
