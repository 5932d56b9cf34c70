// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/smoothing_spline.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/design/least_energy.hpp"
#include "spline_oracle.hpp"
#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::smoothing_spline_test {
namespace {

using test::Random;

/// Its value at every point of the table.
std::vector<double> at_points(const SmoothingSpline& s, const SplineSpec& spec) {
  const Cam cam(s.segments, spec.points.front().master, Extrapolation::hold);
  std::vector<double> y;
  for (const SplinePoint& p : spec.points) y.push_back(cam.at(p.master).position);
  return y;
}

void expect_within_tolerances(const SmoothingSpline& s, const SplineSpec& spec) {
  const auto y = at_points(s, spec);
  const double size = std::abs(extrema(Cam(s.segments), 0).peak().value);
  for (std::size_t i = 0; i < y.size(); ++i)
    EXPECT_LE(std::abs(y[i] - spec.points[i].slave),
              spec.points[i].tolerance * (1 + 1e-9) + 1e-13 * size)
        << "point " << i;
}

/// The least integral of geo_jerk^2 of any curve through these values.
double energy_through(SplineSpec spec, const std::vector<double>& y) {
  for (std::size_t i = 0; i < y.size(); ++i) spec.points[i] = {spec.points[i].master, y[i], 0};
  return cam_detail::square_jerk(quintic_spline(spec));
}

SplineSpec noisy(Random& random, int n) {
  SplineSpec spec;
  spec.ends = random.below(2) == 0 ? SplineEnds::natural : SplineEnds::periodic;
  if (spec.ends == SplineEnds::natural && random.below(2) == 0) spec.start = {0.0, {}};
  if (spec.ends == SplineEnds::natural && random.below(2) == 0) spec.end = {{}, 0.5};
  const double tolerance = random.log_uniform(1e-4, 10);
  double x = random.uniform(-1, 1);
  for (int i = 0; i < n; ++i, x += random.log_uniform(0.1, 10))
    spec.points.push_back(
        {x, random.uniform(-1, 1), random.below(4) == 0 ? 0 : random.uniform(0, tolerance)});
  if (spec.ends == SplineEnds::periodic)
    spec.points.back().tolerance = spec.points.front().tolerance;
  return spec;
}

TEST(SmoothingSpline, FindsWhatTryingEveryChoiceOfBoundsFinds) {
  const auto& all = test::spline_oracle("tolerance");
  for (const char* ends : {"natural", "clamped"}) {
    SCOPED_TRACE(ends);
    SplineSpec spec{.points = test::points_of(all["points"])};
    if (ends == std::string("clamped")) spec.start = spec.end = {0.0, 0.0};
    const SmoothingSpline s = smoothing_spline(spec);
    const auto& wanted = all[ends];
    EXPECT_NEAR(s.square_jerk, wanted["square_jerk"].get<double>(), 1e-12 * s.square_jerk);
    EXPECT_EQ(s.gap, 0);
    const auto y = at_points(s, spec);
    std::vector<std::size_t> touched;
    for (std::size_t i = 0; i < y.size(); ++i) {
      EXPECT_NEAR(y[i], wanted["slave"][i].get<double>(), 1e-13);
      if (wanted["side"][i] != 0) touched.push_back(i);
    }
    EXPECT_EQ(s.touched, touched);
  }
}

TEST(SmoothingSpline, NothingWithinTheTolerancesIsSmoother) {
  for (int round = 0; round < 400; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    const SplineSpec spec = noisy(random, 4 + random.below(40));
    const SmoothingSpline s = smoothing_spline(spec);
    expect_within_tolerances(s, spec);
    const auto y = at_points(s, spec);
    const double least = s.square_jerk - s.gap;
    EXPECT_LE(s.gap, s.square_jerk);
    if (s.square_jerk > 1e-12) {
      EXPECT_EQ(s.gap, 0);
    }
    // Steps of all sizes towards random points within the tolerances.
    for (int k = 0; k < 20; ++k) {
      std::vector<double> z = y;
      const double step = random.log_uniform(1e-6, 1);
      for (std::size_t i = 0; i < z.size(); ++i) {
        const SplinePoint& p = spec.points[i];
        z[i] += step * (p.slave + random.uniform(-1, 1) * p.tolerance - z[i]);
      }
      if (spec.ends == SplineEnds::periodic)
        z.back() = z.front() + spec.points.back().slave - spec.points.front().slave;
      EXPECT_GE(energy_through(spec, z), least * (1 - 1e-9)) << "step " << step;
    }
  }
}

TEST(SmoothingSpline, IsAQuinticSplineThroughThePointsItTouches) {
  for (int round = 0; round < 100; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    const SplineSpec spec = noisy(random, 8 + random.below(40));
    const SmoothingSpline s = smoothing_spline(spec);
    if (s.touched.size() < 4) continue;
    const Cam cam(s.segments, spec.points.front().master,
                  spec.ends == SplineEnds::periodic ? Extrapolation::wrap : Extrapolation::refuse);
    if (spec.ends == SplineEnds::natural) test::expect_invariants(cam, 3);
    EXPECT_LE(s.segments.size(), s.touched.size() + 1);
    EXPECT_NEAR(energy_through(spec, at_points(s, spec)), s.square_jerk, 1e-9 * s.square_jerk);
  }
}

TEST(SmoothingSpline, WithoutTolerancesItInterpolates) {
  SplineSpec spec{.points = test::points_of(test::spline_oracle("points"))};
  const SmoothingSpline s = smoothing_spline(spec);
  const auto through = quintic_spline(spec);
  ASSERT_EQ(s.segments.size(), through.size());
  for (std::size_t i = 0; i < through.size(); ++i) EXPECT_EQ(s.segments[i].c, through[i].c);
  EXPECT_EQ(s.solutions, 1);
  EXPECT_EQ(s.gap, 0);
}

TEST(SmoothingSpline, TakesAParabolaWhereOneKeepsAllTolerances) {
  Random random(1);
  SplineSpec spec;
  for (int i = 0; i < 50; ++i)
    spec.points.push_back({i * 0.1, 2 - i * 0.1 + i * i * 0.01 + random.uniform(-0.1, 0.1), 0.3});
  const SmoothingSpline s = smoothing_spline(spec);
  expect_within_tolerances(s, spec);
  EXPECT_LT(s.square_jerk, 1e-20);
  spec.points[20].slave += 3;
  const SmoothingSpline bumped = smoothing_spline(spec);
  expect_within_tolerances(bumped, spec);
  EXPECT_GT(bumped.square_jerk, 1);
  EXPECT_EQ(bumped.gap, 0);
}

TEST(SmoothingSpline, TakesTheNoiseOutOfAMeasuredCam) {
  Random random(2);
  SplineSpec spec;
  spec.start = spec.end = {0.0, 0.0};
  const int n = 360;
  for (int i = 0; i <= n; ++i) {
    const double z = static_cast<double>(i) / n;
    const double rise = z * z * z * (10 - 15 * z + 6 * z * z);
    const bool end = i == 0 || i == n;
    spec.points.push_back({z, rise + (end ? 0 : random.uniform(-1e-3, 1e-3)), end ? 0 : 1e-3});
  }
  const SmoothingSpline s = smoothing_spline(spec);
  expect_within_tolerances(s, spec);
  EXPECT_LE(s.square_jerk, 720) << "3-4-5 is within the tolerances and has 720";
  EXPECT_GT(s.square_jerk, 600);
  EXPECT_LT(s.segments.size(), 20U);
}

TEST(SmoothingSpline, ChangesWithItsUnitsAndWithNothingElse) {
  Random random(4);
  SplineSpec spec = noisy(random, 20);
  const SmoothingSpline s = smoothing_spline(spec);
  SplineSpec other = spec;
  const auto scale = [](SplineEnd& end) {
    if (end.geo_velocity) *end.geo_velocity *= 0x1p-50;
    if (end.geo_acceleration) *end.geo_acceleration *= 0x1p-70;
  };
  for (SplinePoint& p : other.points)
    p = {p.master * 0x1p20, p.slave * 0x1p-30, p.tolerance * 0x1p-30};
  scale(other.start);
  scale(other.end);
  const SmoothingSpline large = smoothing_spline(other);
  EXPECT_EQ(large.touched, s.touched);
  EXPECT_EQ(large.square_jerk, s.square_jerk * 0x1p-160);
}

std::string complaint(const SplineSpec& spec) {
  return test::error_of([&] { (void)smoothing_spline(spec); });
}

TEST(SmoothingSpline, NamesTheRejectedValue) {
  EXPECT_EQ(complaint({.points = {{0, 0}, {1, 1}}}), "points = 2: must be at least 3");
  EXPECT_EQ(complaint({.points = {{0, 0}, {1, 1, -1}, {2, 0}}}),
            "points[2].tolerance = -1: must not be negative");
  EXPECT_EQ(complaint({.points = {{0, 0}, {1, 1}, {2, 0}}, .ends = SplineEnds::not_a_knot}),
            "ends = not_a_knot: a smoothing spline needs natural or periodic ends");
  EXPECT_EQ(complaint({.points = {{0, 0, 1}, {1, 1}, {2, 0, 0.5}}, .ends = SplineEnds::periodic}),
            "points[3].tolerance = 0.5: must be 1: the first and the last point of a periodic "
            "table are one");
}

}  // namespace
}  // namespace jounce::smoothing_spline_test
