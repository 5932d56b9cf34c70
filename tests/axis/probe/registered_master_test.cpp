// SPDX-License-Identifier: Apache-2.0
#include "axis/src/probe/registered_master.hpp"

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::registered_master_test {
namespace {

using namespace test;

constexpr double dt = 1e-3;

/// Marks every 100 m, with the mark 2 m early; corrected within the next product.
AxisConfig registered(CorrectionOf side) {
  AxisConfig config{.limits = limits(1e3, 1e5)};
  LiveRegistrationSpec spec{.period = 100, .mark = 20, .window = 10, .search = 40};
  spec.correction = {.window_from = 50, .window_length = 40, .most = 5};
  spec.add_to = side;
  spec.on_loss = MarkLoss::hold;
  config.registration = spec;
  return resolved(config);
}

/// Moves the master by `length` at 1 m a tick; a mark is 18 m after each multiple of 100 m.
struct Web {
  explicit Web(CorrectionOf side) : master(registered(side)) { master.begin(0); }

  void run(int length, bool follows = true) {
    for (int i = 0; i < length; ++i) {
      x += 1;
      raw = {x, 1000, 0, 0};
      master.see(dt, raw);
      Triggers triggers{.wired = 1, .count = 1};
      triggers.change[0] = {.input = 1, .age = 0};
      if (static_cast<int>(x) % 100 != 18) triggers.count = 0;
      corrected = master.corrected(raw, triggers, follows);
      master.end_tick(corrected, follows);
    }
  }

  RegisteredMaster master;
  double x = 0;
  Jet raw{}, corrected{};
};

TEST(RegisteredMaster, CorrectsTheMasterThatFollowsTheMarks) {
  Web web(CorrectionOf::master);
  web.run(250);
  EXPECT_EQ(web.master.reading().marks, 3);
  EXPECT_NE(web.corrected[0], web.raw[0]);
  EXPECT_EQ(web.corrected[0] - web.raw[0], web.master.reading().correction);
  EXPECT_EQ(web.master.last(), web.corrected);
  Jet slave{};
  web.master.correct_slave(slave, true);
  EXPECT_EQ(slave, Jet{}) << "the master has the correction";
}

TEST(RegisteredMaster, CorrectsTheSlaveInstead) {
  Web web(CorrectionOf::slave);
  web.run(250);
  EXPECT_EQ(web.corrected, web.raw);
  Jet slave{};
  web.master.correct_slave(slave, true);
  EXPECT_EQ(slave[0], web.master.reading().correction);
  EXPECT_NE(slave[0], 0);
  Jet other{};
  web.master.correct_slave(other, false);
  EXPECT_EQ(other, Jet{}) << "no motion follows";
}

TEST(RegisteredMaster, TheEndOfACorrectionIsNoMotion) {
  Web web(CorrectionOf::master);
  web.run(250);
  const double correction = web.corrected[0] - web.raw[0];
  ASSERT_NE(correction, 0);
  web.master.end_tick(web.corrected, false);  // the motion ended within the tick
  EXPECT_DOUBLE_EQ(web.master.last()[0], web.raw[0]);
}

TEST(RegisteredMaster, ANewCoordinateIsNoMotion) {
  Web web(CorrectionOf::master);
  web.run(250, false);
  const double before = web.master.last()[0];
  const double seen = web.master.history().before(0);
  web.master.shift(7);
  EXPECT_EQ(web.master.last()[0], before + 7);
  EXPECT_EQ(web.master.history().before(0), seen + 7);
}

TEST(RegisteredMaster, WithoutARegistrationNothingIsCorrected) {
  RegisteredMaster master(resolved({.limits = limits(1e3, 1e5)}));
  const Jet raw{3, 4, 5, 6};
  EXPECT_FALSE(master.registers(true));
  EXPECT_EQ(master.corrected(raw, {}, true), raw);
  EXPECT_FALSE(master.fails(true));
}

}  // namespace
}  // namespace jounce::registered_master_test
