// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/live_combination.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/axis/machine.hpp"

#include "axis/tables.hpp"

namespace jounce::live_combination_test {
namespace {

using namespace test;

/// A line, a corrector, and a label that follows both.
struct Rig {
  Rig()
      : machine({{.name = "label",
                  .config = {.limits = limits(1e4, 1e6)},
                  .follow = {.what = Follow::What::setpoint, .index = 1},
                  .second = {.what = Follow::What::setpoint, .index = 2}},
                 {.name = "line", .config = {.limits = limits(1e3, 1e4)}},
                 {.name = "corrector", .config = {.limits = limits(1e3, 1e4)}}}),
        images(3) {
    for (AxisImage& image : images) image.command = {command::Enable{}};
    step();
  }
  void step(int ticks = 1) {
    for (int k = 0; k < ticks; ++k) {
      machine.step(++tick, images);
      for (AxisImage& image : images) image.command = {};
    }
  }
  const Tick& label() const { return images[0].tick; }
  double line() const { return images[1].tick.position; }
  double corrector() const { return images[2].tick.position; }

  Machine machine;
  std::vector<AxisImage> images;
  std::int64_t tick = -1;
};

TEST(LiveCombination, AddsTheMotionsOfItsMasters) {
  Rig rig;
  LiveCombination both(1, {.first = 1.5, .second = -0.25}, {.acceleration = 1e5});
  rig.images[0].command = {command::Couple{.movement = &both}};
  rig.images[1].command = {command::MoveVelocity{.velocity = 300}};
  rig.step(500);
  const double offset = rig.label().position - 1.5 * rig.line() + 0.25 * rig.corrector();
  rig.images[2].command = {command::MoveAbsolute{.position = -200, .dynamics = {.velocity = 500}}};
  for (int k = 0; k < 2000; ++k) {
    rig.step();
    // In the same tick, although both leaders are declared after the label.
    ASSERT_NEAR(rig.label().position, offset + 1.5 * rig.line() - 0.25 * rig.corrector(), 1e-9)
        << k;
  }
  EXPECT_NEAR(rig.corrector(), -200, 1e-9);
  // Another coordinate of a leader moves nothing.
  const double before = rig.label().position;
  rig.images[2].command = {command::SetPosition{.position = 1000}};
  rig.step();
  EXPECT_NEAR(rig.label().position, before + 1.5 * 0.3, 1e-9);
}

TEST(LiveCombination, StopsIfOneOfItsMastersIsLost) {
  Rig rig;
  LiveCombination both(1, {.first = 1, .second = 1}, {.acceleration = 1e5});
  rig.images[0].command = {command::Couple{.movement = &both}};
  rig.images[1].command = {command::MoveVelocity{.velocity = 300}};
  rig.step(500);
  EXPECT_EQ(rig.label().fault, Cause::none);
  rig.images[2].command = {command::Disable{}};
  rig.step(2);
  EXPECT_EQ(rig.label().fault, Cause::master_lost);
  rig.step(500);
  EXPECT_EQ(rig.label().velocity, 0);
}

TEST(LiveCombination, IsRejectedBeyondTheVelocityLimit) {
  Rig rig;
  rig.images[1].command = {command::MoveVelocity{.velocity = 900}};
  rig.images[2].command = {command::MoveVelocity{.velocity = 900}};
  rig.step(500);
  LiveCombination both(1, {.first = 6, .second = 6}, {.acceleration = 1e5});
  rig.images[0].command = {command::Couple{.movement = &both}};
  rig.step();
  EXPECT_EQ(refusal(rig.label()), Cause::velocity_limit);
  EXPECT_DOUBLE_EQ(rig.label().refused->value, 10800);
  LiveCombination difference(2, {.first = 6, .second = -6}, {.acceleration = 1e5});
  rig.images[0].command = {command::Couple{.movement = &difference}};
  rig.step();
  EXPECT_EQ(refusal(rig.label()), Cause::none);
}

TEST(LiveCombination, NeedsBothMasters) {
  Bench bench({.limits = limits(1000, 1e4)});
  bench.send(Kind::enable);
  LiveCombination both(1, {}, {.acceleration = 1e3});
  const Tick now = bench.step({command::Couple{.movement = &both}}, at_master(0, 1));
  EXPECT_EQ(refusal(now), Cause::no_master_input) << "the second one is missing";
}

}  // namespace
}  // namespace jounce::live_combination_test
