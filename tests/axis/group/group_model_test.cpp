// SPDX-License-Identifier: Apache-2.0
// Random commands and faults for a group and its axes. The judge has the limits of the axes and
// the contour in closed form, and nothing of the group.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axis/group/group_rig.hpp"
#include "axis/model/limits_of_log.hpp"
#include "support/random.hpp"

namespace jounce::group_model_test {
namespace {

using namespace test;
using namespace test::on_plotter;
using test::Random;

bool enabled(const Tick& tick) {
  return tick.state != State::disabled && tick.state != State::error_stop;
}

/// Judges every tick of the two axes and their group.
class Judge {
 public:
  explicit Judge(const AxisConfig& axis)
      : config_(resolved(axis)), limits_{LimitsOfLog(axis), LimitsOfLog(axis)} {}

  std::string see(const Plotter& rig) {
    const Tick& all = rig.at(group);
    std::string wrong;
    for (const std::size_t i : {x, y}) {
      const Tick& axis = rig.at(i);
      if (const std::string broken = limits_[i].see(axis); !broken.empty())
        wrong = rig.machine.axis(i).name + ": " + broken;
      const bool follows = axis.state == State::synchronized_motion;
      if (follows) {
        const auto [px, py] = contour_at(all.position);
        if (!(std::abs(axis.position - (i == x ? px : py)) <= 1e-12)) wrong = "off the path";
        const bool full = all.rate == 1 && before_.rate == 1;
        if (followed_[i].state == State::synchronized_motion &&
            !keeps_limits(config_, followed_[i], axis, full))
          wrong = "beyond a limit";
      }
      followed_[i] = axis;
      if (follows && !rig.moves()) wrong = "an axis follows a group at rest";
      const bool healthy = axis.fault == Cause::none && axis.state != State::disabled;
      if (rig.moves() && healthy && !follows) wrong = "an axis does not follow its group";
      const bool alone = axis.state == State::discrete_motion ||
                         axis.state == State::continuous_motion || axis.state == State::homing;
      if (enabled(all) && alone) wrong = "an axis of an enabled group moves alone";
      // A fault of the axis is a fault of its group, at the latest one tick later.
      const bool lame = axis.state == State::disabled || axis.state == State::error_stop;
      if (lame && was_lame_[i] && enabled(all)) wrong = "an enabled group has a lame axis";
      was_lame_[i] = lame && enabled(all);
    }
    if (all.job != 0 && before_.job == all.job && all.position < before_.position)
      wrong = "the group moves back";
    if (all.velocity < 0) wrong = "the group has a negative velocity";
    before_ = all;
    return wrong.empty() ? "" : wrong + " in tick " + std::to_string(all.tick);
  }

 private:
  AxisConfig config_;
  std::array<LimitsOfLog, 2> limits_;
  std::array<Tick, 2> followed_{};
  std::array<bool, 2> was_lame_{};
  Tick before_{};
};

/// One random command or event for the machine.
void stir(Plotter& rig, Random& random, GroupPath& path) {
  const auto axis = random.below(std::size_t{2});
  const auto send = [&](std::size_t i, const AxisCommand& command) {
    rig.images[i].command = {command};
  };
  switch (random.below(18)) {
    case 0:
      return send(group, command::Hold{});
    case 1:
    case 2:
      return send(group, command::Resume{});
    case 3:
      return send(group, command::Override{random.uniform(0, 2)});
    case 4:
      return send(group, command::Override{random.below(2) == 0 ? 0.0 : 1.0});
    case 5:
      return send(group, command::Halt{});
    case 6:
      return send(group, command::Stop{});
    case 7:
      return random.below(4) == 0 ? send(group, command::Disable{}) : send(group, command::Reset{});
    case 8:
      return random.below(10) == 0 ? send(group, command::Abort{}) : send(group, command::Reset{});
    case 9:
      return send(axis, command::MoveAbsolute{.position = random.uniform(-50, 100)});
    case 10:
      return random.below(4) == 0 ? send(axis, command::Stop{}) : send(axis, command::Halt{});
    case 11:
      return random.below(10) == 0 ? send(axis, command::Abort{}) : send(axis, command::Reset{});
    case 12:
      return random.below(10) == 0 ? send(axis, command::Disable{}) : send(axis, command::Enable{});
    case 13:
      rig.images[axis].inputs.feedback.fault = random.below(10) == 0;
      return;
    case 14:
      for (AxisImage& image : rig.images) image.inputs.watchdog = random.below(10) == 0;
      return;
    case 15:
      return send(group, command::Arm{&path});
    default:
      return send(group, command::Start{});
  }
}

/// Brings both axes to where the path begins or continues, and the group back into motion.
void tidy(Plotter& rig, std::vector<std::unique_ptr<GroupPath>>& paths) {
  paths.push_back(std::make_unique<GroupPath>(paths.size() + 1, rig.program));
  for (AxisImage& image : rig.images) {
    image.inputs.feedback.fault = false;
    image.inputs.watchdog = false;
  }
  for (const std::size_t i : {group, x, y}) rig.send(i, command::Stop{});
  for (int i = 0; i < 2000; ++i) rig.step();
  for (const std::size_t i : {group, x, y}) rig.send(i, command::Disable{});
  for (const std::size_t i : {x, y}) {
    rig.send(i, command::Reset{});
    rig.send(i, command::Enable{});
    rig.send(i, command::MoveAbsolute{.position = 0});
  }
  for (int i = 0; i < 3000; ++i) rig.step();
  for (const AxisCommand& command :
       {AxisCommand{command::Reset{}}, AxisCommand{command::Enable{}},
        AxisCommand{command::Override{1}}, AxisCommand{command::Arm{paths.back().get()}},
        AxisCommand{command::Start{}}}) {
    const Cause refused = rig.send(group, command);
    ASSERT_EQ(refused, Cause::none) << name(refused) << " in tick " << rig.tick;
  }
}

/// JOUNCE_GROUP_STEPS sets the number of ticks; scripts/nightly uses more.
std::int64_t steps_wanted() {
  const char* const steps = std::getenv("JOUNCE_GROUP_STEPS");
  return steps == nullptr ? 1'000'000 : std::atoll(steps);
}

TEST(GroupModel, RandomCommandsKeepThePathTheLimitsAndTheStates) {
  const Limits axis = limits(200, 2000, 1e5);
  Plotter rig(axis);
  Judge judge(Plotter::config(axis));
  Random random(20261126);
  std::array<int, states> seen{};
  std::int64_t left = steps_wanted();
  std::int64_t moving = 0;
  int started = 0;
  std::vector<std::unique_ptr<GroupPath>> paths;
  tidy(rig, paths);
  while (left > 0) {
    for (int i = 0; i < 4000 && left > 0; ++i, --left) {
      if (random.below(61) == 0) stir(rig, random, *paths.back());
      rig.step();
      ++seen[static_cast<std::size_t>(rig.at(group).state)];
      moving += rig.moves() ? 1 : 0;
      const std::string wrong = judge.see(rig);
      ASSERT_EQ(wrong, "");
    }
    tidy(rig, paths);
    started += rig.moves() ? 1 : 0;
    judge = Judge(Plotter::config(axis));
  }
  EXPECT_GT(started, steps_wanted() / 4000 / 2) << "the group is used";
  EXPECT_GT(moving, steps_wanted() / 10);
  for (const State state : {State::disabled, State::standstill, State::discrete_motion,
                            State::stopping, State::error_stop})
    EXPECT_GT(seen[static_cast<std::size_t>(state)], 0) << name(state);
}

TEST(GroupModel, TheJudgeFindsAMotionBeyondTheLimits) {
  const Limits axis = limits(200, 2000, 1e5);
  for (const Limits& lower :
       {limits(100, 2000, 1e5), limits(200, 1000, 1e5), limits(200, 2000, 5e4)}) {
    Plotter rig(axis);
    Judge judge(Plotter::config(lower));
    rig.start();
    std::string wrong;
    for (int i = 0; i < 2000 && wrong.empty(); ++i, rig.step()) wrong = judge.see(rig);
    EXPECT_THAT(wrong, testing::StartsWith("beyond a limit"));
  }
}

}  // namespace
}  // namespace jounce::group_model_test
