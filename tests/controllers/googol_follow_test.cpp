// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/googol/googol_follow.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "gear/follow_tables.hpp"
#include "support/random.hpp"

namespace jounce::googol {
namespace {

using State = SegmentFifos::State;

/// An axis whose master begins at 0 and moves to the positions that the test gives.
struct Axis {
  FollowFifos fifos;
  Sample now{0, {0, 0, 0, 0}};

  explicit Axis(int dir = 0) {
    EXPECT_EQ(fifos.prf_follow(dir), Refusal::none);
    EXPECT_EQ(fifos.set_follow_master(1), Refusal::none);
  }
  Jet to(double master) {
    const Sample next{now.t + 1, {master, master - now.master[0], 0, 0}};
    const Jet slave = fifos.step(std::exchange(now, next), next);
    return slave;
  }
  void fill(const FollowTable& table, int fifo) {
    for (const PtPoint& p : table.segments) EXPECT_EQ(fifos.follow_data(p, fifo), Refusal::none);
  }
};

TEST(GoogolFollow, Example79SwitchesAtTheEndsOfPasses) {
  Axis axis;
  axis.fill(test::old_7_9(), 0);
  axis.fifos.set_follow_loop(0);
  ASSERT_EQ(axis.fifos.follow_start(0, 0, 0), Refusal::none);
  EXPECT_EQ(axis.to(70000)[0], 42500);  // 10000 into the second pass
  EXPECT_EQ(axis.fifos.follow_loop(), 1);
  EXPECT_EQ(axis.fifos.follow_switch(1), Refusal::empty);
  axis.fill(test::bridge_7_9(), 1);
  EXPECT_EQ(axis.fifos.follow_clear(0), Refusal::in_use);
  ASSERT_EQ(axis.fifos.follow_switch(1), Refusal::none);
  EXPECT_EQ(axis.fifos.follow_clear(1), Refusal::in_use) << "it is what comes next";
  EXPECT_EQ(axis.to(119999)[0], 80000 - 0.5 / 20000) << "the endless table ends with its pass";
  EXPECT_EQ(axis.fifos.follow_space(0), 13U);
  EXPECT_NEAR(axis.to(120000 + 55000)[1], 1 - 0.4 * 0.75, 1e-14) << "the bridge falls to 0.6";
  EXPECT_EQ(axis.fifos.follow_space(0), 16U) << "so users see that it has switched";
  EXPECT_EQ(axis.fifos.follow_loop(), 0) << "counted anew";
  axis.fill(test::new_7_9(), 0);
  ASSERT_EQ(axis.fifos.follow_switch(0), Refusal::none);
  EXPECT_NEAR(axis.to(180000)[1], 0.6, 1e-14) << "CONTINUE takes the bridge's end ratio";
  EXPECT_EQ(axis.to(180000)[0], 80000 + 46000);
  const double later = 180000 + 7 * 60000.0;
  EXPECT_NEAR(axis.to(later)[1], 0.6, 1e-13) << "and its own from pass to pass";
  EXPECT_EQ(axis.to(later)[0], 126000 + 7 * 52000.0);
}

TEST(GoogolFollow, Example78NeedsDynamicMemory) {
  Axis axis;
  const FollowTable table = test::example_7_8();
  EXPECT_EQ(axis.fifos.follow_space(0), 16U);
  EXPECT_EQ(axis.fifos.set_follow_memory(2), Refusal::bad_argument) << "how many, first";
  ASSERT_EQ(axis.fifos.set_follow_max_segment(1000), Refusal::none);
  ASSERT_EQ(axis.fifos.set_follow_memory(2), Refusal::none);
  axis.fill(table, 0);
  EXPECT_EQ(axis.fifos.follow_space(0), 198U);
  EXPECT_EQ(axis.fifos.follow_space(1), 198U) << "both together";
  ASSERT_EQ(axis.fifos.follow_start(0, 0, 0), Refusal::none);
  const Cam whole = follow({{table}}).cam;
  for (double m = 0; m < 120000; m += 37) ASSERT_EQ(axis.to(m), whole.jet(m)) << m;
  EXPECT_EQ(axis.to(120000)[0], 100000);
  EXPECT_EQ(axis.fifos.state(), State::ended);
  EXPECT_EQ(axis.fifos.set_follow_memory(1), Refusal::none);
  EXPECT_EQ(axis.fifos.follow_space(1), 512U);
}

TEST(GoogolFollow, WaitsForItsMasterToPass) {
  Axis axis;
  axis.fill(test::example_7_7(), 0);
  axis.fifos.set_follow_loop(0);
  ASSERT_EQ(axis.fifos.set_follow_event({FollowEvent::pass, 50000, 1}), Refusal::none);
  ASSERT_EQ(axis.fifos.follow_start(0, 0, 500), Refusal::none);
  EXPECT_TRUE(axis.fifos.waiting());
  EXPECT_EQ(axis.fifos.follow_start(0, 0, 500), Refusal::moving);
  EXPECT_EQ(axis.fifos.follow_clear(0), Refusal::in_use);
  EXPECT_EQ(axis.fifos.follow_switch(1), Refusal::not_moving);
  EXPECT_EQ(axis.to(49990)[0], 500);
  EXPECT_NEAR(axis.to(50040)[0], 500 + 40.0 * 40 / 40000, 1e-9)
      << "the origin is the crossing, not the cycle";
  EXPECT_FALSE(axis.fifos.waiting());
  EXPECT_NEAR(axis.to(50000 + 60000 * 3.0)[0], 500 + 120000, 1e-6);
}

TEST(GoogolFollow, OneDirectionAloneWaitsUntilTheMasterIsBack) {
  Axis axis(1);
  axis.fill(test::example_7_7(), 0);
  ASSERT_EQ(axis.fifos.follow_start(0, 0, 0), Refusal::none);
  const Jet there = axis.to(30000);
  EXPECT_EQ(there[0], 20000);
  EXPECT_EQ(axis.to(25000)[0], 20000) << "the slave stands while the master backs off";
  EXPECT_EQ(axis.to(31000)[0], 21000) << "and is still in step with it";

  Axis back(-1);
  back.fill(test::example_7_7(), 0);
  ASSERT_EQ(back.fifos.follow_start(0, 0, 0), Refusal::none);
  EXPECT_EQ(back.to(-30000)[0], 20000);
  EXPECT_EQ(back.to(-31000)[1], -1) << "per master unit, of which there are fewer";

  Axis both(0);
  both.fill(test::example_7_7(), 0);
  ASSERT_EQ(both.fifos.follow_start(0, 0, 0), Refusal::none);
  both.to(30000);
  EXPECT_EQ(both.to(10000)[0], 2500) << "back on its path";
  EXPECT_EQ(both.to(-5)[0], 0) << "to the origin of the pass";
}

TEST(GoogolFollow, StandsWithoutARateWhileTheMasterRunsTheOtherWay) {
  for (const int dir : {1, -1}) {
    Axis axis(dir);
    axis.fill({{{1000, 1000, PtType::even}}, 1}, 0);
    ASSERT_EQ(axis.fifos.follow_start(0, 0, 0), Refusal::none);
    EXPECT_EQ(axis.to(dir * 500)[1], dir);
    for (const double master : {400.0, 300.0, -5.0, 499.0}) {
      const Jet slave = axis.to(dir * master);
      EXPECT_EQ(slave, (Jet{500, 0, 0, 0})) << dir << " at " << master;
    }
    EXPECT_EQ(axis.to(dir * 600.0), (Jet{600, static_cast<double>(dir), 0, 0}));
  }
}

TEST(GoogolFollow, AMasterThatIsLostLeavesItStanding) {
  for (const int dir : {0, 1, -1}) {
    const double inf = std::numeric_limits<double>::infinity();
    for (const double nowhere : {std::nan(""), inf, -inf, dir < 0 ? -1e300 : 1e300}) {
      Axis axis(dir);
      axis.fifos.set_follow_loop(0);
      axis.fill({{{100, 50, PtType::even}}, 1}, 0);
      ASSERT_EQ(axis.fifos.follow_start(0, 0, 7), Refusal::none);
      const Jet last = axis.to(dir < 0 ? -250 : 250);
      EXPECT_EQ(last[0], 7 + 125);
      EXPECT_EQ(axis.to(nowhere), (Jet{last[0], 0, 0, 0})) << dir << ", " << nowhere;
      EXPECT_EQ(axis.fifos.state(), State::lost);
      EXPECT_EQ(axis.to(10), (Jet{last[0], 0, 0, 0})) << "until it is started again";
      EXPECT_EQ(axis.fifos.follow_start(0, nowhere, 0),
                std::isfinite(nowhere) ? Refusal::none : Refusal::bad_argument);
    }
  }
}

TEST(GoogolFollow, TakesWholePassesAtOnce) {
  using enum PtType;
  const std::vector<FollowTable> tables{
      {{{1, 3, even}}, 0},                                       // a rate of its own
      {{{1, 2, continued}}, 0},                                  // another every second pass
      {{{1, 2, continued}, {3, 5, normal}, {4, 5, normal}}, 0},  //
      {{{1, 2, continued}, {3, 2.5, normal}}, 0},                // it grows from pass to pass
      {{{1, 2, normal}, {3, 5, normal}}, 0},                     // from rest
      {{{1, 2, continued}, {2, 2.5, even}, {4, 3, normal}}, 0}};
  for (std::size_t i = 0; i < tables.size(); ++i) {
    Axis far, near;
    for (Axis* axis : {&far, &near}) {
      axis->fifos.set_follow_loop(0);
      axis->fill(tables[i], 0);
      ASSERT_EQ(axis->fifos.follow_start(0, 0, 0), Refusal::none);
    }
    Jet stepped{};
    for (int k = 0; k <= 4001; ++k) stepped = near.to(k + 0.25);
    const Jet jumped = far.to(4001.25);
    for (std::size_t k = 0; k < jumped.size(); ++k)
      EXPECT_NEAR(jumped[k], stepped[k], 1e-9 * (1 + std::abs(stepped[k]))) << i << ", " << k;
    EXPECT_EQ(far.fifos.follow_loop(), near.fifos.follow_loop());
  }
  Axis axis;
  axis.fifos.set_follow_loop(1'000'000'000'000);
  axis.fill(tables[0], 0);
  ASSERT_EQ(axis.fifos.follow_start(0, 0, 0), Refusal::none);
  EXPECT_EQ(axis.to(900'000'000'000.5)[0], 3 * 900'000'000'000.5);
  EXPECT_EQ(axis.fifos.follow_loop(), 900'000'000'000);
  EXPECT_EQ(axis.to(1e300)[0], 3e12);
  EXPECT_EQ(axis.fifos.follow_loop(), 1'000'000'000'000);
  EXPECT_FALSE(axis.fifos.state() == State::moving);
}

TEST(GoogolFollow, RejectsWithTheDocumentedReasons) {
  FollowFifos none;
  EXPECT_EQ(none.follow_data({1, 1}, 0), Refusal::wrong_mode);
  EXPECT_EQ(none.follow_clear(0), Refusal::wrong_mode);
  EXPECT_EQ(none.follow_start(0, 0, 0), Refusal::wrong_mode);
  EXPECT_EQ(none.follow_switch(0), Refusal::wrong_mode);
  EXPECT_EQ(none.set_follow_event({}), Refusal::wrong_mode);
  EXPECT_EQ(none.set_follow_memory(0), Refusal::wrong_mode);
  none.prf_follow(0);
  EXPECT_EQ(none.follow_start(0, 0, 0), Refusal::no_master);
  EXPECT_EQ(none.set_follow_master(0), Refusal::bad_argument);
  none.set_follow_master(2);
  EXPECT_EQ(none.follow_start(0, 0, 0), Refusal::empty);
  EXPECT_EQ(none.follow_switch(1), Refusal::not_moving);
  EXPECT_EQ(none.prf_follow(2), Refusal::bad_argument);
  EXPECT_EQ(none.set_follow_event({FollowEvent::pass, 0, 0}), Refusal::bad_argument);
  EXPECT_EQ(none.set_follow_max_segment(1'000'000), Refusal::bad_argument);
  for (int i = 1; i <= 16; ++i) ASSERT_EQ(none.follow_data({1.0 * i, 0}, 0), Refusal::none);
  EXPECT_EQ(none.follow_data({17, 0}, 0), Refusal::full);
  none.follow_start(0, 0, 0);
  EXPECT_EQ(none.set_follow_master(1), Refusal::moving);
  EXPECT_EQ(none.set_follow_memory(1), Refusal::moving);
  EXPECT_EQ(none.prf_follow(1), Refusal::moving);
  EXPECT_EQ(none.follow_switch(0), Refusal::in_use);
  EXPECT_EQ(none.follow_clear(1), Refusal::none) << "the idle one, while moving";
}

/// Two tables as lists, without FIFOs: where the slave is after any master travel.
struct Naive {
  std::array<std::vector<PtPoint>, 2> tables;
  std::int64_t loops = 1;
  int active = 0;
  std::int64_t passes = 0;
  bool queued = false;
  bool moving = false;
  double x = 0;  // origin of the pass
  double s = 0;
  double entry = 0;

  [[nodiscard]] const std::vector<PtPoint>& table() const {
    return tables[static_cast<std::size_t>(active)];
  }
  double play(double master) {
    while (moving && master - x >= table().back().x) {
      entry = pt_rates<OverMaster>(table(), entry).back().end;
      x += table().back().x;
      s += table().back().position;
      ++passes;
      if (queued) {
        tables[static_cast<std::size_t>(active)].clear();
        active = 1 - active;
        queued = false;
        passes = 0;
      } else if (loops >= 1 && passes >= loops) {
        moving = false;
      }
    }
    return moving ? s + pt<OverMaster>(table(), entry).jet(master - x)[0] : s;
  }
};

TEST(GoogolFollow, RandomOperationsMatchANaiveModel) {
  for (std::uint64_t seed = 1; seed <= 300 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    Axis axis;
    Naive model;
    double master = 0;
    for (int step = 0; step < 300 && !::testing::Test::HasFailure(); ++step) {
      const int fifo = random.below(2);
      auto& table = model.tables[static_cast<std::size_t>(fifo)];
      const bool used = model.moving && (fifo == model.active || model.queued);
      switch (random.below(6)) {
        case 0: {
          if (model.moving && fifo == model.active) break;
          const PtPoint p{(table.empty() ? 0 : table.back().x) + 1 + random.below(50),
                          1.0 * random.below(100), static_cast<PtType>(random.below(4))};
          const bool room = table.size() < 16;
          ASSERT_EQ(axis.fifos.follow_data(p, fifo), room ? Refusal::none : Refusal::full);
          if (room) table.push_back(p);
          break;
        }
        case 1:
          if (random.below(5) > 0) break;
          ASSERT_EQ(axis.fifos.follow_clear(fifo), used ? Refusal::in_use : Refusal::none);
          if (!used) table.clear();
          break;
        case 2: {
          const Refusal expected = model.moving    ? Refusal::moving
                                   : table.empty() ? Refusal::empty
                                                   : Refusal::none;
          if (!model.moving) {
            model.loops = random.below(4);
            axis.fifos.set_follow_loop(model.loops);
          }
          const double slave = model.s;
          ASSERT_EQ(axis.fifos.follow_start(fifo, master, slave), expected);
          if (expected != Refusal::none) break;
          model.active = fifo;
          model.passes = 0;
          model.x = master;
          model.entry = 0;
          model.moving = true;
          break;
        }
        case 3: {
          const Refusal expected = !model.moving          ? Refusal::not_moving
                                   : fifo == model.active ? Refusal::in_use
                                   : table.empty()        ? Refusal::empty
                                                          : Refusal::none;
          ASSERT_EQ(axis.fifos.follow_switch(fifo), expected);
          if (expected == Refusal::none) model.queued = true;
          break;
        }
        default: {
          master += random.below(400);
          const Jet slave = axis.to(master);
          const bool was = model.moving;
          const double expected = model.play(master);
          if (was) {
            ASSERT_NEAR(slave[0], expected, 1e-9) << "step " << step;
          }
        }
      }
      ASSERT_EQ(axis.fifos.state() == State::moving, model.moving) << "step " << step;
      for (int i = 0; i < 2; ++i)
        ASSERT_EQ(axis.fifos.follow_space(i),
                  16 - model.tables[static_cast<std::size_t>(i)].size());
      if (model.moving) {
        ASSERT_EQ(axis.fifos.follow_loop(), model.passes);
      }
    }
  }
}

}  // namespace
}  // namespace jounce::googol
