// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/spline_times.hpp"

#include <cmath>
#include <fstream>
#include <numeric>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::spline_times_test {
namespace {

using nlohmann::json;

const json& oracle() {
  static const json all =
      json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/spline_times.json"));
  return all;
}

/// The six joints of Lin, Chang and Luh's class.
SplineTimesSpec six_joints(const char* set = nullptr) {
  SplineTimesSpec spec;
  for (std::size_t i = 0; i < 4; ++i) {
    spec.points.emplace_back();
    for (const json& joint : oracle()["knots"]) spec.points.back().push_back(joint[i]);
  }
  if (set == nullptr) return spec;
  const json& limits = oracle()["sets"][set];
  for (std::size_t j = 0; j < 6; ++j)
    spec.limits.push_back({.velocity = limits["velocity"][j].get<double>(),
                           .acceleration = limits["acceleration"][j].get<double>(),
                           .jerk = limits["jerk"][j].get<double>()});
  return spec;
}

std::string six_digits(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void expect_rest_to_rest_through(const SplineTimesSpec& spec, const SplineTimes& best) {
  for (std::size_t j = 0; j < best.joints.size(); ++j) {
    const Trajectory& f = best.joints[j];
    EXPECT_TRUE(check_continuity(f, 2).ok()) << "at rest outside, so the ends count";
    EXPECT_EQ(f.at(0).position, spec.points.front()[j]);
    for (std::size_t i = 1; i + 1 < spec.points.size(); ++i)
      EXPECT_NEAR(f.at(f.breaks()[i + 1]).position, spec.points[i][j], 1e-12 * 150);
    EXPECT_NEAR(f.at(f.end()).position, spec.points.back()[j], 1e-12 * 150);
  }
}

TEST(SplineTimes, TheShortestOfBothSetsAreTheKnownOnes) {
  for (const char* set : {"A", "B"}) {
    SCOPED_TRACE(set);
    const SplineTimesSpec spec = six_joints(set);
    const SplineTimesOutcome outcome = spline_times(spec);
    const SplineTimes& best = outcome.best;
    const double known = oracle()["sets"][set]["duration"];
    EXPECT_NEAR(best.duration, known, 1e-8 * known);
    EXPECT_TRUE(outcome.limits.ok());
    EXPECT_EQ(outcome.status, OptimizeStatus::converged);
    EXPECT_GE(outcome.agreeing, 12) << outcome.reason;
    EXPECT_LT(outcome.spread, 1e-9);
    expect_rest_to_rest_through(spec, best);
  }
}

TEST(SplineTimes, SetAIsWhatIsPrintedOfIt) {
  const SplineTimesOutcome outcome = spline_times(six_joints("A"));
  const SplineTimes& best = outcome.best;
  EXPECT_NEAR(best.duration, 9.573623, 5e-7);
  const std::vector<double> h{0.92775, 2.14330, 3.05418, 2.81057, 0.63782};
  for (std::size_t i = 0; i < h.size(); ++i) EXPECT_NEAR(best.intervals[i], h[i], 1e-4);
  const std::vector<std::string> words{"joint 2 acceleration -40 at 6.12524 s",
                                       "joint 2 jerk -60 at 8.93581 s", "joint 3 jerk 55 at 0 s",
                                       "joint 3 jerk -55 at 0.927753 s"};
  std::vector<std::string> active;
  for (const Finding& f : outcome.active)
    active.push_back(f.axis + " " + f.quantity + " " + six_digits(f.value) + " at " +
                     six_digits(f.where) + " s");
  EXPECT_EQ(active, words);
}

TEST(SplineTimes, LeastPeakJerkInGivenTime) {
  SplineTimesSpec spec = six_joints();
  spec.objective = TimeObjective::least_peak_jerk;
  spec.duration = oracle()["least_peak_jerk"]["duration"];
  const SplineTimesOutcome outcome = spline_times(spec);
  const SplineTimes& best = outcome.best;
  const double known = oracle()["least_peak_jerk"]["value"];
  EXPECT_NEAR(outcome.value, known, 1e-7 * known);
  EXPECT_NEAR(best.duration, 9.1, 1e-13);
  double peak = 0;
  for (const Trajectory& f : best.joints)
    peak = std::max(peak, std::abs(extrema(f, 3).peak().value));
  EXPECT_NEAR(peak, outcome.value, 1e-11 * peak);
}

TEST(SplineTimes, LeastSquareJerkInGivenTime) {
  SplineTimesSpec spec = six_joints();
  spec.objective = TimeObjective::least_square_jerk;
  spec.duration = 9.1;
  const SplineTimesOutcome outcome = spline_times(spec);
  const SplineTimes& best = outcome.best;
  EXPECT_NEAR(outcome.value, 54409.2374, 5e-5);
  EXPECT_NEAR(outcome.value, oracle()["least_square_jerk"]["value"].get<double>(),
              1e-8 * outcome.value);
  const std::vector<double> h{0.785503, 2.521944, 2.652113, 2.388866, 0.751574};
  for (std::size_t i = 0; i < h.size(); ++i) EXPECT_NEAR(best.intervals[i], h[i], 2e-6);
  double sum = 0;
  for (const Trajectory& f : best.joints)
    for (const Segment& s : f.segments()) sum += std::pow(evaluate(s, 0.5)[3], 2) * s.length;
  EXPECT_NEAR(sum, outcome.value, 1e-12 * sum);
}

TEST(SplineTimes, NoNeighbourIsBetter) {
  const SplineTimesSpec spec = six_joints("B");
  const SplineTimesOutcome outcome = spline_times(spec);
  const SplineTimes& best = outcome.best;
  const auto duration = [&](std::vector<double> h) {
    double scale = 0;
    const auto joints = spline_through(spec.points, h);
    for (std::size_t j = 0; j < 6; ++j) {
      const Ranges r = extrema(joints[j]);
      const Limits& l = spec.limits[j];
      scale = std::max({scale, std::abs(r[1].peak().value) / *l.velocity,
                        std::sqrt(std::abs(r[2].peak().value) / *l.acceleration),
                        std::cbrt(std::abs(r[3].peak().value) / *l.jerk)});
    }
    return scale * std::accumulate(h.begin(), h.end(), 0.0);
  };
  EXPECT_NEAR(duration(best.intervals), best.duration, 1e-11);
  for (std::size_t i = 0; i < best.intervals.size(); ++i)
    for (const double by : {0.999, 1.001}) {
      auto h = best.intervals;
      h[i] *= by;
      EXPECT_GT(duration(h), best.duration) << i << " times " << by;
    }
}

TEST(SplineTimes, ScalesWithUnitsAndTime) {
  SplineTimesSpec spec = six_joints("A");
  const double before = spline_times(spec).best.duration;
  for (auto& point : spec.points)
    for (double& p : point) p *= 1e6;
  for (Limits& l : spec.limits)
    l = {.velocity = *l.velocity * 1e9,
         .acceleration = *l.acceleration * 1e12,
         .jerk = *l.jerk * 1e15};
  EXPECT_NEAR(spline_times(spec).best.duration, before * 1e-3, 1e-10 * before);
}

TEST(SplineTimes, OneJointTwoPointsIsSymmetric) {
  // From rest to rest in three intervals under a jerk limit: jerk J, -J', J by symmetry.
  SplineTimesSpec spec;
  spec.points = {{0}, {1}};
  spec.limits = {{.jerk = 32}};
  const SplineTimesOutcome outcome = spline_times(spec);
  const SplineTimes& best = outcome.best;
  // A jerk of +J, -J, +J over T/4, T/2, T/4 gives a stroke of J T^3 / 32: T = 1.
  EXPECT_NEAR(best.duration, 1, 1e-9);
  EXPECT_NEAR(best.intervals[0], 0.25, 1e-6);
  EXPECT_NEAR(best.intervals[1], 0.5, 1e-6);
}

TEST(SplineTimes, TheSameSeedGivesTheSameTimes) {
  SplineTimesSpec spec = six_joints("A");
  spec.options.starts = 3;
  EXPECT_EQ(spline_times(spec).best.intervals, spline_times(spec).best.intervals);
}

std::string complaint(const SplineTimesSpec& spec) {
  return test::error_of([&] { (void)spline_times(spec); });
}

TEST(SplineTimes, NamesTheRejectedValue) {
  const SplineTimesSpec good = six_joints("A");
  SplineTimesSpec spec = good;
  spec.points.resize(1);
  EXPECT_EQ(complaint(spec), "points = 1 points: must be at least two");
  spec = good;
  spec.points[2].pop_back();
  EXPECT_EQ(complaint(spec), "points[3] = 5 positions: must be one for each joint in each point");
  spec = good;
  spec.points[1][2] = std::nan("");
  EXPECT_EQ(complaint(spec), "points[2][3] = nan: must be a finite number");
  spec = good;
  spec.limits[4] = {.position_max = 1000};
  EXPECT_NE(complaint(spec).find("limits[5]"), std::string::npos);
  spec = good;
  spec.duration = 3;
  EXPECT_EQ(complaint(spec), "duration = 3: is computed by times = \"shortest\": leave it out");
  spec = good;
  spec.objective = TimeObjective::least_peak_jerk;
  EXPECT_NE(complaint(spec).find("duration = 0"), std::string::npos);
  spec = good;
  spec.points = {{1, 2}, {1, 2}};
  spec.limits.resize(2);
  EXPECT_NE(complaint(spec).find("there is no motion"), std::string::npos);
  EXPECT_THROW((void)spline_through(good.points, {1, 2, 3}), InputError);
}

}  // namespace
}  // namespace jounce::spline_times_test
