// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/live_compare.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "support/random.hpp"

namespace jounce::live_compare_test {
namespace {

constexpr double dt = 1e-3;

/// 0.1 s up, 0.2 s at 100 u/s, 0.1 s down: 30 u, whose phases end in ticks.
Trajectory stroke(double from, double to) {
  return trapezoid({.from = from, .to = to, .velocity = 100, .acceleration = 1000}).curve();
}

/// Every edge of the motion in ticks, times as of its start; `late`: ticks to leave out.
std::vector<OutputEdge> live(const PositionCompare& compare, const Trajectory& motion,
                             const std::vector<int>& late = {}) {
  LiveCompare output(compare);
  std::vector<OutputEdge> edges;
  const int ticks = static_cast<int>(std::lround(motion.length() / dt)) + 5;
  double before = -dt;
  output.step(motion.jet(motion.start())[0], 0, dt);
  output.arm();
  for (int k = 0; k <= ticks; ++k) {
    if (std::find(late.begin(), late.end(), k) != late.end()) continue;
    const double t = k * dt;
    const bool over = t >= motion.length() - 1e-9;
    const Jet f = over ? motion.jet(motion.end(), Side::left) : motion.jet(motion.start() + t);
    const CompareStep& step = output.step(f[0], over ? 0 : f[1], t - before);
    for (const OutputEdge& edge : step.edges())
      edges.push_back({before + edge.time, edge.on, edge.position});
    EXPECT_EQ(step.lost, 0U);
    before = t;
  }
  return edges;
}

void expect_same(const std::vector<OutputEdge>& live, const std::vector<OutputEdge>& exact,
                 double tolerance = 1e-11) {
  ASSERT_EQ(live.size(), exact.size());
  for (std::size_t i = 0; i < live.size(); ++i) {
    EXPECT_NEAR(live[i].time, exact[i].time, tolerance) << i;
    EXPECT_EQ(live[i].on, exact[i].on) << i;
    EXPECT_NEAR(live[i].position, exact[i].position, 1e-9 + 200 * tolerance) << i;
  }
}

// The instants are those of the whole motion, to rounding, in every mode.
TEST(LiveCompare, FiresAtTheInstantsOfTheKnownMotion) {
  const Trajectory there = stroke(0, 30);
  const Trajectory back = concatenated(there, stroke(30, 0));
  using Mode = CompareMode;
  const std::vector<PositionCompare> all{
      {.mode = Mode::linear, .points = evenly(10, 1, 11), .pulse = 2e-3},
      {.mode = Mode::linear, .points = evenly(10.05, 0.5, 11), .pulse = 7e-3},
      {.mode = Mode::fifo_time, .points = {{3}, {17}, {29.5}, {29.5}, {2}}, .pulse = 0.5e-3},
      {.mode = Mode::fifo_level, .points = {{5, true}, {6, false}, {20, true}, {11, false}}},
      {.mode = Mode::equal, .points = {{15}}},
      {.mode = Mode::greater, .points = {{25}}},
      {.mode = Mode::less, .points = {{12}}}};
  for (const PositionCompare& compare : all) {
    expect_same(live(compare, back), compared(compare, back).edges);
    expect_same(live(compare, back, {12, 13, 14, 130, 131}), compared(compare, back).edges);
  }
}

TEST(LiveCompare, BetweenAnyTwoTicksOfASmoothMotion) {
  test::Random random(3);
  for (int run = 0; run < 200; ++run) {
    const Trajectory motion = stroke(random.uniform(-5, 5), random.uniform(35, 60));
    PositionCompare compare{.pulse = random.log_uniform(1e-5, 2e-2)};
    double p = random.uniform(5, 8);
    for (int i = 0; i < 20 && p < 34; ++i, p += random.uniform(0.15, 3))
      compare.points.push_back({p});
    // The phases end anywhere: what a step of the acceleration within a cycle costs is below 1 us.
    expect_same(live(compare, motion), compared(compare, motion).edges, 1e-6);
  }
}

TEST(LiveCompare, StandingOnAPointItFiresWhenItIsArmed) {
  const PositionCompare compare{.points = {{0}}, .pulse = 1e-3};
  const std::vector<OutputEdge> edges = live(compare, stroke(0, 30));
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_NEAR(edges[0].time, 0, 1e-15);
  EXPECT_NEAR(edges[1].time, 1e-3, 1e-15);
  EXPECT_EQ(edges[0].position, 0);
}

TEST(LiveCompare, BeginsAnewWhenItIsArmedAgain) {
  LiveCompare output({.mode = CompareMode::equal, .points = {{1}}});
  output.step(0, 0, dt);
  EXPECT_EQ(output.step(2, 0, dt).count, 0U) << "not armed";
  output.arm();
  EXPECT_EQ(output.step(2, 0, dt).count, 0U);
  EXPECT_TRUE(output.step(0, 0, dt).output);
  EXPECT_EQ(output.fired(), 1U);
  output.arm();
  const CompareStep& step = output.step(0, 0, dt);
  ASSERT_EQ(step.count, 1U);
  EXPECT_FALSE(step.edge[0].on);
  EXPECT_EQ(output.fired(), 0U);
}

TEST(LiveCompare, ANewPlaceIsNotPassedTo) {
  LiveCompare output({.points = {{1}, {10}}, .pulse = 1e-2});
  output.arm();
  output.step(0, 0, dt);
  output.place();
  EXPECT_EQ(output.step(5, 0, dt).count, 0U);
  EXPECT_EQ(output.fired(), 0U);
}

// Time passes while the position is not known; the way is then a straight line.
TEST(LiveCompare, APositionThatIsNoneEndsPulsesAndPassesNothing) {
  LiveCompare output({.points = {{1}, {3}}, .pulse = 1.5e-3});
  output.arm();
  output.step(0, NAN, dt);
  ASSERT_EQ(output.step(2, NAN, dt).count, 1U);  // at 1, in the middle of the cycle
  const CompareStep& unknown = output.step(NAN, 0, dt);
  EXPECT_EQ(unknown.count, 0U);
  const CompareStep& after =
      output.step(6, NAN, dt);  // off at 0 of this cycle; 3 was 0.5 ms before
  EXPECT_EQ(after.lost, 0U);
  EXPECT_EQ(output.fired(), 2U);
}

TEST(LiveCompare, MoreEdgesThanThereIsRoomForAreCountedAndTheOutputIsRight) {
  LiveCompare output(
      {.mode = CompareMode::linear, .points = evenly(0.001, 0.01, 100), .pulse = 1e-6});
  output.arm();
  output.step(0, 1000, dt);
  const CompareStep& step = output.step(1, 1000, dt);
  EXPECT_EQ(step.count, CompareStep::most_edges);
  EXPECT_EQ(step.lost, 200 - CompareStep::most_edges);
  EXPECT_FALSE(step.output);
  EXPECT_EQ(output.fired(), 100U);
}

TEST(LiveCompare, RejectsWhatTheKnownMotionDoes) {
  EXPECT_THROW(LiveCompare({}), InputError);
  EXPECT_THROW(LiveCompare({.points = {{NAN}}, .pulse = 1}), InputError);
  EXPECT_THROW(LiveCompare({.mode = CompareMode::equal, .points = {{1}}, .pulse = 1}), InputError);
}

}  // namespace
}  // namespace jounce::live_compare_test
