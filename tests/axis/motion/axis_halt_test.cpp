// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"

namespace jounce::axis_halt_test {
namespace {

using namespace test;

const AxisConfig wide{.limits = limits(1e3, 1e4)};

/// An axis geared to a master of 10 m/s: it runs with 10 u/s.
struct Geared : Bench {
  Geared() : Bench(wide) {
    send(Kind::enable);
    step({command::Couple{.movement = &gear}}, at_master(0, 10));
    for (int i = 1; i < 50; ++i) step({}, at_master(i * 1e-2, 10));
  }
  Gear gear{1, 1};
};

// PLCopen: MC_Halt takes the axis to DiscreteMotion, and to Standstill when it is at rest.
TEST(AxisHalt, OutOfACouplingGoesByDiscreteMotionToStandstill) {
  Geared axis;
  ASSERT_EQ(axis.axis.state(), State::synchronized_motion);
  Tick tick = axis.step({command::Halt{.dynamics = {.deceleration = 1000}}});
  EXPECT_EQ(tick.state, State::discrete_motion);
  EXPECT_EQ(tick.job, 0U);
  EXPECT_EQ(refusal(axis.send(Kind::gear_out)), Cause::not_synchronized);
  tick = axis.run(20);
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_EQ(tick.reason, Cause::halted);
}

TEST(AxisHalt, OfAVelocityAndOfACamOverAVirtualMasterIsDiscreteMotionToo) {
  Bench jog(wide);
  jog.send(Kind::enable);
  jog.step({command::MoveVelocity{.velocity = 100}});
  EXPECT_EQ(jog.run(50).state, State::continuous_motion);
  EXPECT_EQ(jog.send(Kind::halt).state, State::discrete_motion);

  Job job(1, constant_master(360, 100), pmc600_cam());
  Bench cam({.limits = limits(1e3, 1e5)});
  cam.play(job);
  EXPECT_EQ(cam.run(500).state, State::synchronized_motion);
  EXPECT_EQ(cam.send(Kind::halt).state, State::discrete_motion);
  EXPECT_EQ(cam.run(500).state, State::standstill);
}

// A halt ends the motion: there is nothing to hold, to resume or to finish, and the answer states
// this.
TEST(AxisHalt, HoldResumeAndFinishAreRejectedInWords) {
  for (const Kind kind : {Kind::hold, Kind::resume, Kind::finish}) {
    Job job(1, there_and_back(0, 10, 1, Extrapolation::wrap));
    Bench axis({.limits = limits(40, 300)});
    axis.play(job, 250);
    axis.send(Kind::halt);
    const Tick tick = axis.send(kind);
    ASSERT_EQ(refusal(tick), Cause::halting) << name(kind);
    EXPECT_EQ(axis.run(3000).state, State::standstill) << "the halt goes on";
  }
}

TEST(AxisHalt, IsEndedByAnyOtherMotion) {
  Geared axis;
  axis.step({command::Halt{.dynamics = {.deceleration = 100}}});
  EXPECT_EQ(refusal(axis.send(Kind::hold)), Cause::halting);
  const Tick tick = axis.step({command::MoveVelocity{.velocity = 1}});
  EXPECT_FALSE(tick.refused);
  EXPECT_EQ(tick.state, State::continuous_motion);
}

}  // namespace
}  // namespace jounce::axis_halt_test
