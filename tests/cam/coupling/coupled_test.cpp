// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/coupled.hpp"

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/fig_6_14.hpp"

namespace jounce::coupled_test {
namespace {

Trajectory travel(double to) {
  return s_curve({.to = to, .velocity = 200, .acceleration = 1000, .jerk = 20000}).curve();
}

void expect_same(const Coupling& coupling, const MotionState& slave, const Trajectory& master) {
  const Engagement in = engage(coupling, slave, master.jet(0), 0);
  ASSERT_TRUE(in);
  const Coupled motion(coupling, in.engaged, master);
  for (int n = 0; n <= 1000; ++n) {
    const double t = motion.end() * n / 1000;
    const Jet x = with(master, Extrapolation::hold).jet(t);
    const Jet expected = point(coupling, in.engaged, x, t);
    const Jet got = motion.jet(t);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(got[k], expected[k], 1e-7) << k << " " << t;
  }
}

TEST(Coupled, IsThePointsOfItsCoupling) {
  const Cam closed = design(test::fig_6_14()).cam;
  CamSpec rise;
  rise.segments = {{Law::quintic, {360, 90, 0, 0}, ""}};
  const Cam indexing = with(design(rise).cam, Extrapolation::wrap);
  const CouplingSpec ramp{.master_scaling = 2,
                          .master_offset = 40,
                          .slave_scaling = 0.5,
                          .slave_offset = 3,
                          .start = StartMode::ramp_in,
                          .velocity_diff = 50,
                          .acceleration = 400,
                          .jerk = 8000};
  expect_same(Coupling(closed, ramp), {.position = -20}, travel(1000));
  CouplingSpec relative = ramp;
  relative.slave_absolute = false;
  relative.master_absolute = false;
  expect_same(Coupling(indexing, relative), {.position = -20}, travel(1000));
  expect_same(Coupling(indexing, relative), {.position = -20}, reversed(travel(1000)));
  expect_same(Coupling(closed, {.start = StartMode::ramp_in_distance, .distance = 150}),
              {.position = 9}, travel(1000));
}

TEST(Coupled, LastsUntilTheCorrectionIsOver) {
  const Coupling coupling(design(test::fig_6_14()).cam,
                          {.start = StartMode::ramp_in, .velocity_diff = 1, .acceleration = 10});
  const Trajectory master = travel(100);
  const Engagement in = engage(coupling, {.position = 5}, master.jet(0), 0);
  const Coupled motion(coupling, in.engaged, master);
  EXPECT_DOUBLE_EQ(motion.end(), 5.1);
  EXPECT_DOUBLE_EQ(*motion.in_sync(), 5.1);
  EXPECT_NEAR(motion.at(5.1).position, coupling.cam().at(100).position, 1e-12);
  EXPECT_NEAR(motion.at(5, Side::left).acceleration, 0, 1e-12);
  EXPECT_NEAR(motion.at(5.05, Side::left).acceleration, 10, 1e-9) << "both limits of a step";
  EXPECT_NEAR(motion.at(0.1, Side::left).acceleration - motion.at(0.1, Side::right).acceleration,
              -10, 1e-9);
}

TEST(Coupled, AMasterThatComesBackBringsNoCorrectionBack) {
  const Coupling coupling(design(test::fig_6_14()).cam,
                          {.start = StartMode::ramp_in_distance, .distance = 50});
  const Trajectory master = concatenated(travel(100), reversed(travel(100)));
  const Engagement in = engage(coupling, {.position = 5}, master.jet(0), 0);
  const Coupled motion(coupling, in.engaged, master);
  EXPECT_EQ(motion.at(0).position, 5);
  EXPECT_EQ(motion.at(motion.end()).position, 0);
  EXPECT_NEAR(*motion.in_sync(), 0.375, 0.01);
}

}  // namespace
}  // namespace jounce::coupled_test
