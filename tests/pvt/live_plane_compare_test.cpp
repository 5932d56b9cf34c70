// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/live_plane_compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::live_plane_compare_test {
namespace {

using Edge = std::tuple<double, int, bool>;

/// All edges of two motions, with their times.
std::vector<Edge> played(const PlaneCompare& compare, const Trajectory& x, const Trajectory& y,
                         double dt, double until) {
  LivePlaneCompare live(compare);
  const auto place = [](const Trajectory& f, double t) {
    const Jet at = f.jet(std::min(t, f.end()));
    return LivePlaneCompare::Place{at[0], t < f.end() ? at[1] : 0};
  };
  live.step(place(x, 0), place(y, 0), dt);
  live.arm();
  std::vector<Edge> edges;
  const auto steps = static_cast<int>(std::ceil(until / dt));
  for (int k = 1; k <= steps; ++k)
    for (const PlaneEdge& edge : live.step(place(x, k * dt), place(y, k * dt), dt).edges())
      edges.emplace_back((k - 1) * dt + edge.time, edge.output, edge.on);
  return edges;
}

// A circle about the origin, by two sines: the places of the zones are those of compared(), which
// finds them on the whole motion.
TEST(LivePlaneCompare, FiresWhereTheWholeMotionDoes) {
  Segment sine{.length = 4, .degree = 0, .sines = 1};
  sine.sine[0] = {50, 6.283185307179586, 0};
  Segment cosine = sine;
  cosine.sine[0].phase = 1.5707963267948966;
  const Trajectory x({cosine});
  const Trajectory y({sine});
  for (const bool equal : {false, true}) {
    const PlaneCompare zones{.x_band = 3,
                             .y_band = 2,
                             .equal = equal,
                             .points = {{0, 50, 16}, {-50, 0, 17}, {-30, -40, 16}, {40, -30, 3}},
                             .pulse = 0.05};
    const auto exact = compared(zones, x, y);
    ASSERT_GE(exact.size(), 3U);
    for (const double dt : {1e-3, 3.7e-3}) {
      const auto edges = played(zones, x, y, dt, 4.2);
      ASSERT_EQ(edges.size(), 2 * exact.size()) << dt;
      for (std::size_t i = 0; i < exact.size(); ++i) {
        const auto& [on_time, output, on] = edges[2 * i];
        EXPECT_NEAR(on_time, exact[i].time, 1e-6) << i;  // a cubic for each sine
        EXPECT_EQ(output, zones.points[i].output);
        EXPECT_TRUE(on);
        const auto& [off_time, again, off] = edges[2 * i + 1];
        EXPECT_NEAR(off_time - on_time, 0.05, 1e-12);
        EXPECT_EQ(again, output);
        EXPECT_FALSE(off);
      }
    }
  }
}

// At constant acceleration, the instants are exact: y = x / 2 at 40 u/s^2, from rest.
TEST(LivePlaneCompare, IsExactAtConstantAcceleration) {
  const Trajectory x({{.length = 2, .degree = 2, .c = {0, 0, 80}}});
  const Trajectory y({{.length = 2, .degree = 2, .c = {0, 0, 40}}});
  const auto edges =
      played({.x_band = 2, .y_band = 3, .points = {{20, 10, 1}, {40, 21, 2}}, .pulse = 1}, x, y,
             1e-3, 1.5);
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_NEAR(std::get<0>(edges[0]), std::sqrt(2 * 18 / 40.0), 1e-12);
  EXPECT_NEAR(std::get<0>(edges[1]), std::sqrt(2 * 38 / 40.0), 1e-12);
}

TEST(LivePlaneCompare, PulsesOfOneOutputMergeAndOthersOverlap) {
  const Trajectory x({line(1, 0, 100)});
  const Trajectory y({line(1, 0, 0)});
  const auto edges = played(
      {.x_band = 1, .y_band = 1, .points = {{20, 0, 5}, {25, 0, 6}, {26, 0, 5}}, .pulse = 0.1}, x,
      y, 1e-3, 1);
  ASSERT_EQ(edges.size(), 4U);
  const std::vector<Edge> expected{
      {0.19, 5, true}, {0.24, 6, true}, {0.34, 6, false}, {0.35, 5, false}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(std::get<0>(edges[i]), std::get<0>(expected[i]), 1e-12) << i;
    EXPECT_EQ(std::get<1>(edges[i]), std::get<1>(expected[i])) << i;
    EXPECT_EQ(std::get<2>(edges[i]), std::get<2>(expected[i])) << i;
  }
}

TEST(LivePlaneCompare, APointThatIsMissedBlocksTheRestUntilItIsArmedAgain) {
  LivePlaneCompare live({.x_band = 1, .y_band = 1, .points = {{5, 50, 1}, {10, 0, 2}}, .pulse = 1});
  live.arm();
  for (int k = 0; k <= 20; ++k) live.step({1.0 * k, 1000}, {0, 0}, 1e-3);
  EXPECT_EQ(live.fired(), 0U);
  LivePlaneCompare placed({.x_band = 1, .y_band = 1, .points = {{10, 0, 2}}, .pulse = 1});
  placed.step({0, 0}, {0, 0}, 1e-3);
  placed.arm();
  placed.place();
  placed.step({20, 0}, {0, 0}, 1e-3);
  EXPECT_EQ(placed.fired(), 0U) << "set to its position without a motion";
  placed.step({std::numeric_limits<double>::quiet_NaN(), 0}, {0, 0}, 1e-3);
  placed.step({5, 0}, {0, 0}, 1e-3);
  EXPECT_EQ(placed.fired(), 1U);
}

TEST(LivePlaneCompare, RejectsOutputsThatDoNotExist) {
  EXPECT_EQ(test::key_of([] {
              LivePlaneCompare live({.x_band = 1, .y_band = 1, .points = {{0, 0, 33}}, .pulse = 1});
            }),
            "point[1].output");
  EXPECT_EQ(test::key_of([] { LivePlaneCompare live({.x_band = 0, .y_band = 1}); }), "x_band");
}

}  // namespace
}  // namespace jounce::live_plane_compare_test
