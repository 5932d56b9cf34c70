// SPDX-License-Identifier: Apache-2.0
// Changes while an axis moves: another target, a halt, one motion on top of another, no stop between.
#include <array>
#include <cstdio>

#include "jounce/controllers/pmc600/pmc600.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/sequences/splice.hpp"

using namespace jounce;

int main() {
  // PMC600 5.2.4, LS_MoveAbsChangePosVel: to 50000; at 2 s to 100000, faster.
  const Trajectory running =
      point_to_point(0, 50000, {.velocity = 10000, .acceleration = 100000}).curve();
  const Trajectory changed =
      with_target(running, 2, 100000, {.velocity = 20000, .acceleration = 200000});
  std::printf("at %.6g when changed, at %.6g after %.6g s\n", state_at(running, 2).position,
              changed.at(changed.end()).position, changed.end());

  // A jerk limit also keeps the acceleration continuous. MC_MoveAdditive: 4000 more.
  const Dynamics axis{.velocity = 2000, .acceleration = 4000, .jerk = 40000};
  const Trajectory first = point_to_point(0, 6000, axis).curve();
  const Trajectory added = pmc600::move_additive(first, 3, 4000, axis);
  std::printf("additive: %.6g, %s\n", added.at(added.end()).position,
              check_continuity(added, 2).ok() ? "smooth" : "with a step");

  // MC_MoveSuperImposed, aborted at 3 s: both velocities add up.
  const Trajectory top =
      pmc600::move_superimposed(first, 1, 2000, {.velocity = 500, .acceleration = 1000}, 3);
  std::printf("superimposed: %.6g at 2 s, ends at %.6g\n", top.at(2).velocity,
              top.at(top.end()).position);

  // LS_PositionToVelocity: past 10000 at 5000.
  const Trajectory two = pmc600::position_to_velocity({.end_pos = {10000, 50000},
                                                       .velocity = {5000, 20000},
                                                       .acceleration = {10000, 20000},
                                                       .deceleration = {10000, 20000},
                                                       .mode = pmc600::VelocityMode::trapezoid});
  std::printf("two in one: past %.6g at %.6g, %.6g s\n", two.at(2.25).position,
              two.at(2.25).velocity, two.end());

  // MC_Jog: forward, both inputs, backward, none.
  const std::array inputs{pmc600::JogInput{0, true, false}, pmc600::JogInput{2, true, true},
                          pmc600::JogInput{3, false, true}, pmc600::JogInput{4, false, false}};
  const Trajectory jog = pmc600::jog(0, inputs, axis);
  std::printf("jog: back to %.6g after %.6g s\n", state_at(jog, jog.end()).position, jog.end());
}

// > at 19500 when changed, at 100000 after 6.0875 s
// > additive: 10000, smooth
// > superimposed: 2500 at 2 s, ends at 7000
// > two in one: past 10000 at 5000, 5.03125 s
// > jog: back to 2000 after 4.6 s
