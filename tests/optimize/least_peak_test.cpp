// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/least_peak.hpp"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/optimize/problem.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/random.hpp"

namespace jounce::least_peak_test {
namespace {

using test::Random;

CamKnot& knot_of(CamSpec& spec, std::size_t i) {
  return i == 0 ? spec.start : spec.segments[i - 1].end;
}

double peak_of(const CamSpec& spec) {
  return value_of(Objective::peak_acceleration, design(spec).cam);
}

CamSpec random_cam(Random& random, int most) {
  CamSpec spec;
  spec.periodic = random.below(2) == 0;
  double master = 0;
  for (int i = 1 + random.below(most); i > 0; --i) {
    master += random.log_uniform(0.1, 10);
    spec.segments.push_back({Law::quintic, {master, random.uniform(-1, 1), {}, {}}, ""});
    if (random.below(4) == 0) spec.segments.back().end.geo_velocity = random.uniform(-0.1, 0.1);
    if (random.below(4) == 0) spec.segments.back().end.geo_acceleration = random.uniform(-0.1, 0.1);
  }
  return spec;
}

TEST(LeastPeak, AgreesWithALinearProgramOnAGrid) {
  const auto cases =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/least_peak.json"));
  ASSERT_EQ(cases.size(), 4U);
  for (const auto& c : cases) {
    SCOPED_TRACE(c["name"]);
    CamSpec spec;
    spec.periodic = c["periodic"];
    const auto& knots = c["knots"];
    spec.segments.resize(knots.size() - 1);
    for (std::size_t i = 0; i < knots.size(); ++i) {
      CamKnot& knot = knot_of(spec, i);
      knot = {knots[i][0], knots[i][1], {}, {}};
      if (!knots[i][2].is_null()) knot.geo_velocity = knots[i][2].get<double>();
      if (!knots[i][3].is_null()) knot.geo_acceleration = knots[i][3].get<double>();
    }
    const LeastPeak least = filled_for_least_peak(spec);
    const double grid = c["peak"];
    EXPECT_GE(least.peak, grid * (1 - 1e-7));
    EXPECT_LE(least.peak, grid * (1 + 2e-6)) << "1e-6 is given for less jerk";
    EXPECT_LE(least.bound, least.peak);
    EXPECT_GE(least.bound, least.peak * (1 - 1.1e-6));
  }
}

TEST(LeastPeak, IsCertifiedAndNoOtherChoiceIsBelow) {
  for (int round = 0; round < 60; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    const CamSpec spec = random_cam(random, 8);
    const auto free = free_derivatives(spec);
    const LeastPeak least = filled_for_least_peak(spec);
    EXPECT_EQ(least.peak, peak_of(least.cam));
    EXPECT_LE(least.bound, least.peak);
    if (least.peak < 1e-13) continue;  // a straight line
    EXPECT_GE(least.bound, least.peak * (1 - 1.1e-6)) << "converged";
    EXPECT_LE(least.peak, peak_of(filled(spec, Fill::minimum_jerk)) * (1 + 2e-6));
    for (int k = 0; k < 200; ++k) {
      CamSpec other = least.cam;
      const double step = random.log_uniform(1e-4, 1);
      for (std::size_t i = 0; i < free.size(); ++i) {
        CamKnot& knot = knot_of(other, i);
        if (free[i].geo_velocity) *knot.geo_velocity += step * random.uniform(-1, 1);
        if (free[i].geo_acceleration) *knot.geo_acceleration += step * random.uniform(-1, 1);
      }
      if (spec.periodic) {
        if (free[0].geo_velocity) other.segments.back().end.geo_velocity = other.start.geo_velocity;
        if (free[0].geo_acceleration)
          other.segments.back().end.geo_acceleration = other.start.geo_acceleration;
      }
      EXPECT_GE(peak_of(other), least.bound * (1 - 1e-12)) << "step " << step;
    }
  }
}

TEST(LeastPeak, WhatIsGivenOrDemandedStays) {
  CamSpec spec;
  spec.segments = {{Law::dwell, {1, 0, {}, {}}, ""},
                   {Law::quintic, {2, 1, {}, {}}, ""},
                   {Law::quintic, {3, 3, 1.5, {}}, ""},
                   {Law::quintic, {4, 4, {}, {}}, ""},
                   {Law::line, {5, 5, {}, {}}, ""}};
  const LeastPeak least = filled_for_least_peak(spec);
  EXPECT_EQ(*least.cam.segments[0].end.geo_velocity, 0);
  EXPECT_EQ(*least.cam.segments[2].end.geo_velocity, 1.5);
  EXPECT_EQ(*least.cam.segments[3].end.geo_velocity, 1);
  EXPECT_NE(*least.cam.segments[2].end.geo_acceleration, 0);
}

TEST(LeastPeak, ASegmentThatCannotChangeIsTheFloor) {
  CamSpec spec;
  spec.segments = {{Law::modified_sine, {1, 10, {}, {}}, "hard"},
                   {Law::quintic, {3, 10.1, {}, {}}, ""},
                   {Law::quintic, {5, 10.2, {}, {}}, ""},
                   {Law::dwell, {6, 10.2, {}, {}}, ""}};
  const LeastPeak least = filled_for_least_peak(spec);
  EXPECT_DOUBLE_EQ(least.peak, least.bound);
  EXPECT_NEAR(least.peak, 55.27957, 1e-4);
  EXPECT_NEAR(*least.cam.segments[1].end.geo_velocity, 0.2 / 4 * 15 / 8, 1e-6)
      << "what the floor leaves free has the least jerk: 3-4-5";
}

TEST(LeastPeak, WhereNothingIsFreeOrNothingBendsIsWhatItIs) {
  CamSpec spec;
  spec.segments = {{Law::quintic, {1, 1, 0, 0}, ""}};
  spec.start = {0, 0, 0, 0};
  const LeastPeak fixed = filled_for_least_peak(spec);
  EXPECT_EQ(fixed.peak, fixed.bound);
  EXPECT_NEAR(fixed.peak, 10 / std::sqrt(3.0), 1e-13);

  CamSpec straight;
  for (int i = 1; i < 5; ++i)
    straight.segments.push_back({Law::quintic, {i * 0.7, i * 0.3, {}, {}}, ""});
  const LeastPeak line = filled_for_least_peak(straight);
  EXPECT_LT(line.peak, 1e-13);
  EXPECT_NEAR(*line.cam.start.geo_velocity, 0.3 / 0.7, 1e-14);
}

TEST(LeastPeak, ChangesWithItsUnitsAndWithNothingElse) {
  Random random(2);
  const CamSpec spec = random_cam(random, 6);
  CamSpec other = spec;
  for (std::size_t i = 0; i <= spec.segments.size(); ++i) {
    CamKnot& k = knot_of(other, i);
    k.master *= 0x1p20;
    k.slave *= 0x1p-30;
    if (k.geo_velocity) *k.geo_velocity *= 0x1p-50;
    if (k.geo_acceleration) *k.geo_acceleration *= 0x1p-70;
  }
  EXPECT_EQ(filled_for_least_peak(other).peak * 0x1p70, filled_for_least_peak(spec).peak);
}

}  // namespace
}  // namespace jounce::least_peak_test
