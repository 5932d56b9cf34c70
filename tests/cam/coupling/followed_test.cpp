// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/followed.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/fig_6_14.hpp"
#include "support/oracle.hpp"

namespace jounce::followed_test {
namespace {

using test::fig_6_14;
using test::oracle;

Followed three_laps() {
  return {design(fig_6_14()).cam,
          trapezoid({.to = 1080, .velocity = 200, .acceleration = 1000}).curve()};
}

TEST(Followed, HasTheFullChainRule) {
  const Followed slave = three_laps();
  const auto& expected = oracle("chain_rule");
  for (std::size_t i = 0; i < expected["t"].size(); ++i) {
    const double t = expected["t"][i];
    const Motion now = slave.at(t);
    EXPECT_NEAR(now.position, expected["position"][i].get<double>(), 1e-11) << t;
    EXPECT_NEAR(now.velocity, expected["velocity"][i].get<double>(), 1e-9) << t;
    EXPECT_NEAR(now.acceleration, expected["acceleration"][i].get<double>(), 1e-7) << t;
    EXPECT_NEAR(now.jerk, expected["jerk"][i].get<double>(), 1e-5) << t;
  }
}

TEST(Followed, BreaksWhereTheMasterPassesAKnotWithBothLimits) {
  const Followed slave = three_laps();
  const auto& expected = oracle("chain_rule")["breaks"];
  ASSERT_EQ(slave.breaks().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double t = slave.breaks()[i];
    EXPECT_NEAR(t, expected[i]["t"].get<double>(), 1e-13);
    for (const auto& [side, key] : {std::pair{Side::left, "left"}, {Side::right, "right"}}) {
      if (expected[i][key].is_null() || i + 1 == expected.size()) continue;
      const Motion now = slave.at(t, side);
      EXPECT_NEAR(now.acceleration, expected[i][key]["acceleration"].get<double>(), 1e-7)
          << t << " " << key;
      EXPECT_NEAR(now.jerk, expected[i][key]["jerk"].get<double>(), 1e-5) << t << " " << key;
    }
  }
}

TEST(Followed, RunsInStepFrom75To200) {
  // PMC600 manual 6.2, example 4.3: at master 200 pulse/s the slave runs at 200 pulse/s there.
  const Cam cam = design(fig_6_14()).cam;
  const Followed slave(cam, Trajectory({line(5.4, 0, 1080)}, 0, Extrapolation::hold));
  for (int lap = 0; lap < 3; ++lap)
    for (const double master : {75.0, 100.0, 137.5, 199.9}) {
      const double t = (360 * lap + master) / 200;
      EXPECT_NEAR(slave.at(t).velocity, 200, 1e-9);
      EXPECT_NEAR(slave.at(t).position, 25 + master, 1e-9);
    }
}

TEST(Followed, AMasterThatReversesMeetsTheLeftLimits) {
  // A kinked cam: slope 1 below 1, slope 3 above. The master goes to 1.5 and back.
  const Cam cam({line(1, 0, 1), line(1, 1, 4)}, 0, Extrapolation::hold);
  const Trajectory out_and_back({line(1, 0.5, 1.5), line(1, 1.5, 0.5)});
  const Followed slave(cam, out_and_back);
  EXPECT_DOUBLE_EQ(slave.at(0.5, Side::left).velocity, 1);
  EXPECT_DOUBLE_EQ(slave.at(0.5).velocity, 3);
  EXPECT_DOUBLE_EQ(slave.at(1.5, Side::left).velocity, -3);
  EXPECT_DOUBLE_EQ(slave.at(1.5).velocity, -1);
}

TEST(Followed, RejectsAMasterThatLeavesTheCam) {
  const Cam cam({line(1, 0, 1)});
  EXPECT_THROW(Followed(cam, Trajectory({line(1, 0, 2)})), InputError);
}

}  // namespace
}  // namespace jounce::followed_test
