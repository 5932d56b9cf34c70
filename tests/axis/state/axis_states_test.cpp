// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"

namespace jounce::axis_states_test {
namespace {

using namespace test;

const AxisConfig wide{.limits = limits(1e3, 1e5)};

/// An axis that has just come into a state, with what it plays there.
struct InState : Bench {
  explicit InState(State wanted) : Bench(wide) {
    if (wanted == State::disabled) return;
    send(Kind::enable);
    if (wanted == State::standstill) return;
    if (wanted == State::error_stop) {
      send(Kind::abort);
    } else if (wanted == State::synchronized_motion) {
      step({command::Couple{.movement = &gear}}, at_master(0));
    } else if (wanted == State::homing) {
      Inputs index = at_master(0);
      index.feedback.sensors.index.wired = true;
      step({command::Home{.method = 34}}, index);
    } else {
      step({command::MoveVelocity{.velocity = 1e3}});
      run(20);
      if (wanted == State::discrete_motion)
        step({command::MoveRelative{.distance = 500}});
      else if (wanted == State::stopping)
        send(Kind::stop);
    }
  }
  static Inputs at_master(double m) {
    Inputs inputs;
    inputs.master = {m, 0, 0, 0};
    return inputs;
  }
  Gear gear{1, 1};
};

// Every command in every state: what the table forbids is refused for that reason and changes
// nothing; what it permits is not refused for a reason of the state.
TEST(AxisStates, EveryCommandInEveryStateIsAnsweredByTheTable) {
  for (std::size_t s = 0; s < states; ++s)
    for (const Kind kind : axis_kinds()) {
      const auto state = static_cast<State>(s);
      InState axis(state);
      ASSERT_EQ(axis.axis.state(), state) << name(state);
      Job job(7, trapezoid_table(50, 10, 20, 20));
      Gear gear(8, 1);
      AnyCommand command{.kind = kind, .position = 1};
      if (kind == Kind::arm) command.movement = &job;
      if (kind == Kind::gear_in) command.movement = &gear;
      const Tick now = axis.step(command, InState::at_master(0));
      const bool compensates =
          kind == Kind::enable_compensation || kind == Kind::disable_compensation;
      const Cause expected =
          compensates ? Cause::no_compensation : permitted(state, kind);  // the axis has none
      const std::string told = std::string(name(kind)) + " in " + name(state);
      if (expected != Cause::none) {
        EXPECT_EQ(refusal(now), expected) << told;
        if (command.movement) {
          EXPECT_EQ(now.handed_back[0], command.movement) << told;
        }
      } else {
        for (const Cause of_state : {Cause::not_enabled, Cause::in_error, Cause::stopping,
                                     Cause::synchronized, Cause::not_synchronized})
          EXPECT_NE(refusal(now), of_state) << told;
      }
    }
}

/// The words of a table of Markdown that begins with this heading.
std::vector<std::vector<std::string>> table_in(const std::string& file, const std::string& first) {
  std::ifstream page(std::string(JOUNCE_SOURCE_DIR) + "/" + file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(page, line);) {
    if (rows.empty() ? line.rfind(first, 0) != 0 : line.rfind('|', 0) != 0) {
      if (!rows.empty()) break;
      continue;
    }
    rows.emplace_back();
    std::istringstream cells(line.substr(1));
    for (std::string cell; std::getline(cells, cell, '|');) {
      const auto from = cell.find_first_not_of(' ');
      if (from == std::string::npos) continue;
      rows.back().push_back(cell.substr(from, cell.find_last_not_of(' ') - from + 1));
    }
  }
  return rows;
}

TEST(AxisStates, TheTableInTheDocumentationIsThatOfTheAxis) {
  const auto rows = table_in("docs/executor/axis.md", "| command \\ state");
  const std::vector<Kind> kinds = axis_kinds();
  ASSERT_EQ(rows.size(), kinds.size() + 1);  // heading, rule, and all but `none`
  for (std::size_t k = 1; k < kinds.size(); ++k) {
    const auto& row = rows[k + 1];
    ASSERT_EQ(row.size(), states + 1) << k;
    const Kind kind = kinds[k];
    EXPECT_EQ(row[0], name(kind));
    for (std::size_t s = 0; s < states; ++s) {
      const Cause answer = permitted(static_cast<State>(s), kind);
      EXPECT_EQ(row[s + 1], answer == Cause::none ? "+" : name(answer)) << name(kind) << ' ' << s;
    }
  }
}

TEST(AxisStates, HomingIsOneStepThatSetsThePosition) {
  Bench bench(wide);
  bench.send(Kind::enable);
  const Tick homing = bench.step({command::Home{.offset = 12}});
  EXPECT_EQ(homing.state, State::homing);
  EXPECT_EQ(homing.position, 12);
  EXPECT_EQ(homing.offset, 12);
  EXPECT_EQ(bench.step().state, State::standstill);
}

TEST(AxisStates, SetPositionMovesTheCountNotTheDrive) {
  Bench bench(wide);
  bench.send(Kind::enable);
  Inputs drive;
  drive.feedback.position = 0;
  Tick tick = bench.step({command::SetPosition{.position = 40}}, drive);
  tick = bench.step({command::SetPosition{.position = 2, .relative = true}}, drive);
  tick = bench.step({}, drive);
  EXPECT_EQ(tick.position, 42);
  EXPECT_EQ(tick.offset, 42);
  EXPECT_EQ(tick.actual_position, 42);
  EXPECT_EQ(tick.following_error, 0);
}

TEST(AxisStates, CamOutAndGearOutKeepTheVelocity) {
  for (const Kind out : {Kind::gear_out, Kind::cam_out}) {
    Bench bench(wide);
    bench.send(Kind::enable);
    Gear gear(1, 2);
    const auto master = [](double v, double m) {
      Inputs inputs;
      inputs.master = {m, v, 0, 0};
      return inputs;
    };
    bench.step({command::Couple{.movement = &gear}}, master(0, 0));
    Tick tick;
    double m = 0;
    for (int k = 1; k <= 100; ++k) tick = bench.step({}, master(k, m += k * 1e-3 - 0.5e-3));
    EXPECT_EQ(tick.state, State::synchronized_motion);
    EXPECT_EQ(tick.velocity, 200);
    tick = bench.step(any({.kind = out}), master(100, m += 0.1));
    EXPECT_EQ(tick.state, State::continuous_motion);
    EXPECT_EQ(tick.handed_back[0], &gear);
    const double from = tick.position;
    EXPECT_EQ(bench.run(1000).velocity, 200);
    EXPECT_NEAR(bench.step().position - from, 200.2, 1e-9);
    bench.send(Kind::stop);
    bench.run(10);
    EXPECT_EQ(bench.axis.state(), State::standstill);
  }
}

}  // namespace
}  // namespace jounce::axis_states_test
