// SPDX-License-Identifier: Apache-2.0
// A stream that is about to run dry, and a cycle that comes too late to stop it in the ordinary
// way: after any command in that cycle, the axis stays on the path, and on its known part.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"

namespace jounce::late_stop_test {
namespace {

using namespace test;

constexpr double reach = 40;  // u: half of the way there
constexpr double w = 5;       // 1/s: there in 628 ms

/// Result of an axis on a stream of which `known` s are known, in the cycle that is `late` ticks
/// late.
struct Outcome {
  Tick end;
  bool left = false;  ///< the path was given up for a move
};

double path(double s) {
  return reach * (1 - std::cos(w * s));
}

Outcome play(double known, std::int64_t when, std::int64_t late, const Command& command,
             bool watchdog, double jerk) {
  AxisConfig config{.limits = limits(500, 2000)};
  if (jerk > 0) config.limits.jerk = jerk;
  MotionAxis axis(config);
  Feed feed(1, 0, reach, w);
  feed.prefill(known);
  axis.step(0, {command::Enable{}});
  axis.step(1, {command::Arm{.movement = &feed}});
  Tick tick = axis.step(2, {command::Start{}});
  while (tick.tick < when && tick.fault == Cause::none) tick = axis.step(tick.tick + 1);
  Inputs inputs;
  inputs.watchdog = watchdog;
  tick = axis.step(tick.tick + 1 + late, command, inputs);
  Outcome outcome;
  for (int i = 0; i < 3000; ++i) {
    outcome.left |= tick.job == 0 && tick.velocity != 0;
    tick = axis.step(tick.tick + 1);
  }
  outcome.end = tick;
  return outcome;
}

TEST(LateStop, StaysOnTheKnownPathForAnyCommandInThatCycle) {
  const AnyCommand told[] = {{},
                             {.kind = Kind::stop},
                             {.kind = Kind::halt},
                             {.kind = Kind::hold},
                             {.kind = Kind::override_, .factor = 0},
                             {.kind = Kind::override_, .factor = 0.5},
                             {.kind = Kind::override_, .factor = 0.95},
                             {.kind = Kind::override_, .factor = 1.5}};
  constexpr double known = 0.3;  // s
  int moved = 0;
  for (const double jerk : {0.0, 1e5})
    for (const AnyCommand& command : told)
      for (const bool watchdog : {false, true})
        for (const std::int64_t late : {0, 1, 3, 10, 40, 90})
          for (std::int64_t when = 120; when < 300; when += 7) {
            const Outcome outcome = play(known, when, late, command, watchdog, jerk);
            const std::string what = std::string(name(command.kind)) + " " +
                                     std::to_string(command.factor) + ", late by " +
                                     std::to_string(late) + " after " + std::to_string(when) +
                                     (watchdog ? ", watchdog" : "") + (jerk > 0 ? ", jerk" : "");
            ASSERT_FALSE(outcome.left) << what;
            ASSERT_EQ(outcome.end.velocity, 0) << what;
            ASSERT_LE(outcome.end.position, path(known) + 1e-9) << what;
            ++moved;
          }
  EXPECT_GT(moved, 1000);
}

// Nothing is lost: after more has come it goes on from there, to where the path leads.
TEST(LateStop, ContinuesFromThereWhenMoreHasArrived) {
  MotionAxis axis({.limits = limits(500, 2000)});
  Feed feed(1, 0, reach, w);
  feed.prefill(0.3);
  axis.step(0, {command::Enable{}});
  axis.step(1, {command::Arm{.movement = &feed}});
  Tick tick = axis.step(2, {command::Start{}});
  while (tick.tick < 150) tick = axis.step(tick.tick + 1);
  tick = axis.step(tick.tick + 80, {command::Hold{}});
  for (int i = 0; i < 500; ++i) tick = axis.step(tick.tick + 1);
  ASSERT_EQ(tick.velocity, 0);
  ASSERT_EQ(tick.fault, Cause::none) << "a hold is no underrun";
  const double stood = tick.position;
  feed.prefill(10);
  tick = axis.step(tick.tick + 1, {command::Resume{}});
  double most = stood;
  for (int i = 0; i < 1500; ++i) {
    tick = axis.step(tick.tick + 1);
    ASSERT_EQ(tick.fault, Cause::none);
    most = std::max(most, tick.position);
  }
  EXPECT_NEAR(most, 2 * reach, 1e-3) << "the whole way there";
}

}  // namespace
}  // namespace jounce::late_stop_test
