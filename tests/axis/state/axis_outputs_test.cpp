// SPDX-License-Identifier: Apache-2.0
#include "axis/src/state/axis_outputs.hpp"

#include <gtest/gtest.h>

#include "axis/tables.hpp"

namespace jounce::axis_outputs_test {
namespace {

using namespace test;

/// Two axes: x = t, y = 2 t. Length and velocity along the path are 5 t and 5 u/s. Output 3 goes on at
/// 0.5 s.
class Line final : public Movement {
 public:
  Line() : Movement(1, Course::path) {}

  Cause begin(const MotionState&, const Moment&) noexcept override { return Cause::none; }
  Setpoint at(const Moment&) noexcept override { return {}; }
  [[nodiscard]] Progress progress() const noexcept override { return Progress::running; }
  [[nodiscard]] std::span<const Jet> parts() const noexcept override { return parts_; }
  [[nodiscard]] PathPlace along(double time) const noexcept override { return {5 * time, 5}; }
  [[nodiscard]] std::span<const PathSwitch> switches(double from,
                                                     double to) const noexcept override {
    const bool inside = from <= on_.time && on_.time < to;
    return {&on_, inside ? std::size_t{1} : std::size_t{0}};
  }

 private:
  std::array<Jet, 2> parts_{{{1, 1, 0, 0}, {2, 2, 0, 0}}};
  PathSwitch on_{0.5, 3, true};
};

AxisOutputs comparing() {
  const PositionCompare list{
      .mode = CompareMode::linear, .points = evenly(1, 1, 20), .pulse = 2e-4};
  return AxisOutputs({}, {.list = list});
}

AxisOutputs::Places at(double position, double velocity) {
  return {.commanded = {position, velocity}};
}

TEST(AxisOutputs, OnlyASetpointPassesAPoint) {
  AxisOutputs outputs = comparing();
  outputs.begin();
  outputs.step(at(0.5, 600), 1e-3);
  outputs.step(at(1.1, 600), 1e-3);
  EXPECT_GT(outputs.compare().count, 0U) << "it passes 1";
  for (int i = 0; i < 5; ++i) outputs.step(at(1.1, 0), 1e-3);
  outputs.rename();
  outputs.step(at(7.5, 0), 1e-3);
  EXPECT_EQ(outputs.compare().count, 0U) << "set_position passes nothing";
}

TEST(AxisOutputs, AGroupComparesTheLengthAlongItsPath) {
  AxisOutputs outputs = comparing();
  const Line line;
  outputs.begin_path();
  outputs.begin();
  std::uint32_t edges = 0;
  for (int i = 0; i <= 250; ++i) {
    outputs.begin_tick();
    outputs.put_out(line, {.s = i * 1e-3}, 1e-3, true);
    outputs.step({.is_group = true, .on_path = true}, 1e-3);
    edges += outputs.compare().count;
  }
  EXPECT_EQ(edges, 2U) << "a pulse at 1 u, of 1.25 u";
}

TEST(AxisOutputs, KeepsTheSetpointsOfTheAxesAtTheRateOfTheTick) {
  AxisOutputs outputs({}, {});
  EXPECT_TRUE(outputs.parts().empty());
  const Line line;
  outputs.put_out(line, {.s = 0.1, .rate = 0.5}, 1e-3, true);
  ASSERT_EQ(outputs.parts().size(), 2U);
  EXPECT_EQ(outputs.parts()[1][0], 2);
  EXPECT_EQ(outputs.parts()[1][1], 1) << "half of the velocity";
}

TEST(AxisOutputs, AnOutputOfThePathStaysUntilTheGroupIsDisabled) {
  AxisOutputs outputs({}, {});
  const Line line;
  SwitchStep now;
  const auto step = [&](double s, bool disabled) {
    outputs.begin_tick();
    if (!disabled) outputs.put_out(line, {.s = s}, 0.1, true);
    outputs.step({.is_group = true, .on_path = !disabled, .disabled = disabled}, 0.1);
    outputs.get_switches(now);
    return now.outputs;
  };
  EXPECT_EQ(step(0.4, false), 0U);
  EXPECT_EQ(step(0.6, false), 4U);
  EXPECT_EQ(now.count, 1U);
  EXPECT_EQ(step(0.7, false), 4U);
  EXPECT_EQ(now.count, 0U);
  EXPECT_EQ(step(0, true), 0U);
}

}  // namespace
}  // namespace jounce::axis_outputs_test
