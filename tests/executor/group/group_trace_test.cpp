// SPDX-License-Identifier: Apache-2.0
// The planned path of a group in the trace, for the picture of the live page.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/executor/detail/trace.hpp"

#include "executor/group/plotter_site.hpp"

namespace jounce::group_trace_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

struct GroupTraced : ::testing::Test {
  void SetUp() override {
    site.advance(10ms);
    ASSERT_TRUE(order(command::Enable{}).ok());
  }
  CallOutcome order(const ClientCommand& command) {
    Client client(site.link, "plotter", {}, site.clock);
    const CallOutcome outcome = client.command(command);
    static_cast<void>(client.release());
    return outcome;
  }
  void line(double x, double y) {
    command::MoveLinearAbsolute to{
        .path = {.along = {.velocity = 50}, .buffer = PathBuffer::look_ahead}};
    to.to[0] = x;
    to.to[1] = y;
    ASSERT_TRUE(order(to).ok());
  }
  [[nodiscard]] std::unique_ptr<TracePath> path() const { return trace.path(Plotter::group); }

  std::vector<ExecutorOptions> traced() {
    std::vector<ExecutorOptions> axes = plotter(limits(200, 2000, 1e5));
    for (ExecutorOptions& axis : axes) axis.trace = &trace;
    axes[Plotter::group].group->unit = "mm";
    return axes;
  }
  Trace trace = Trace::of(std::vector<std::int64_t>(3, 1'000'000));
  Site site{traced(), {.masters = {}, .recorded = false, .said = {}}};
};

std::array<double, 2> place_at(const TracePath& path, double length) {
  const auto* const end = path.at.begin() + path.points;
  const auto* const above = std::upper_bound(path.at.begin(), end, length);
  const auto high = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
      above - path.at.begin(), 1, static_cast<std::ptrdiff_t>(path.points) - 1));
  const double width = path.at[high] - path.at[high - 1];
  const double share = (length - path.at[high - 1]) / width;
  std::array<double, 2> place{};
  for (std::size_t k = 0; k < 2; ++k)
    place[k] = std::lerp(path.places[k][high - 1], path.places[k][high], share);
  return place;
}

/// Greatest distance of the axes from the planned path at the position of the group, over all ticks
/// in which the group is on this path.
double farthest_from(const TracePath& path, const Trace& trace) {
  constexpr std::int64_t all = 1 << 20;
  std::map<std::int64_t, std::array<double, 2>> places;
  for (const std::size_t axis : {Plotter::x, Plotter::y})
    for (const TraceTick& tick : trace.ticks(axis, 0, all))
      places[tick.tick][axis == Plotter::x ? 0 : 1] = tick.values[0];
  double most = 0;
  int compared = 0;
  for (const TraceTick& tick : trace.ticks(Plotter::group, 0, all)) {
    const double length = tick.values[0] - path.origin;
    if (tick.state != State::discrete_motion || length < 0 || length > path.at[path.points - 1])
      continue;
    const auto [x, y] = place_at(path, length);
    most = std::max(most, std::hypot(places[tick.tick][0] - x, places[tick.tick][1] - y));
    ++compared;
  }
  EXPECT_GT(compared, 500);
  return most;
}

TEST_F(GroupTraced, AGroupAtRestHasNone) {
  EXPECT_EQ(trace.path_number(Plotter::group), 0U);
  EXPECT_EQ(path(), nullptr);
}

TEST_F(GroupTraced, LinesAreExactAndEachCommandExtendsThePath) {
  line(100, 0);
  site.advance(200ms);
  const auto one = path();
  ASSERT_TRUE(one);
  EXPECT_EQ(one->points, 2U);
  EXPECT_EQ(one->coordinates, 2U);
  EXPECT_STREQ(one->names[0].data(), "x");
  EXPECT_STREQ(one->names[1].data(), "y");
  EXPECT_STREQ(one->unit.data(), "mm");
  line(100, 50);
  line(20, 50);
  site.advance(200ms);
  const auto all = path();
  ASSERT_TRUE(all);
  EXPECT_GT(all->number, one->number);
  ASSERT_EQ(all->points, 4U);
  const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {100, 0}, {100, 50}, {20, 50}}};
  const std::array<double, 4> lengths{0, 100, 150, 230};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(all->at[i], lengths[i], 1e-9);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(all->places[k][i], corners[i][k], 1e-9);
  }
  site.advance(10s);
  EXPECT_NEAR(farthest_from(*path(), trace), 0, 1e-9);
}

TEST_F(GroupTraced, ASecondProgramBeginsWhereTheGroupIs) {
  line(30, 0);
  site.advance(3s);
  ASSERT_EQ(site.last(Plotter::group).state, State::standstill);
  line(30, 60);
  site.advance(200ms);
  const auto second = path();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->places[0][0], 30);
  EXPECT_EQ(second->places[1][0], 0);
  const double position = site.last(Plotter::group).position;
  const double y = site.last(Plotter::y).position;
  ASSERT_GT(y, 0.1);
  EXPECT_NEAR(place_at(*second, position - second->origin)[1], y, 1e-9);
}

/// The half circle has 64 chords, each with an angle of pi / 64.
TEST_F(GroupTraced, CurvesAreCloseToTheirChords) {
  ASSERT_TRUE(order(command::StartTable{}).ok());
  site.advance(20s);
  const auto whole = path();
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->points, 4 + 64 + 1U);
  for (std::size_t i = 0; i < whole->points; ++i) {
    const auto [x, y] = contour_at(whole->at[i]);
    EXPECT_NEAR(whole->places[0][i], x, 1e-9);
    EXPECT_NEAR(whole->places[1][i], y, 1e-9);
  }
  const double radius = 40;
  EXPECT_LT(farthest_from(*whole, trace), 1.01 * radius * (1 - std::cos(std::numbers::pi / 128)));
}

}  // namespace
}  // namespace jounce::group_trace_test
