// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/boundaries.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"

#include "support/fig_6_14.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::boundaries_test {
namespace {

using test::Random;

/// The integral of the squared jerk over the quintics, from the sampled jerk. The jerk of a quintic
/// is a parabola, its square has degree 4: three Gauss-Legendre nodes (-sqrt(3/5), 0, sqrt(3/5) with
/// the weights 5/9, 8/9, 5/9; Abramowitz and Stegun, table 25.4) integrate it exactly.
double square_jerk(const CamSpec& spec) {
  const CamDesign made = design(spec);
  double sum = 0;
  for (std::size_t i = 0; i < made.origin.size(); ++i) {
    if (spec.segments[made.origin[i]].law != Law::quintic) continue;
    const double from = made.cam.breaks()[i];
    const double half = (made.cam.breaks()[i + 1] - from) / 2;
    for (const auto& [node, weight] :
         {std::pair{-std::sqrt(0.6), 5.0 / 9}, {0.0, 8.0 / 9}, {std::sqrt(0.6), 5.0 / 9}}) {
      const double jerk = made.cam.at(from + half * (1 + node)).geo_jerk;
      sum += half * weight * jerk * jerk;
    }
  }
  return sum;
}

CamKnot& knot_of(CamSpec& spec, std::size_t i) {
  return i == 0 ? spec.start : spec.segments[i - 1].end;
}

/// Mostly quintics with most derivatives left out; some lines, dwells and modified sines.
CamSpec random_cam(Random& random) {
  CamSpec spec;
  spec.start = {random.uniform(-5, 5), random.uniform(-1, 1), {}, {}};
  spec.periodic = random.below(2) == 0;
  double master = spec.start.master;
  double slave = spec.start.slave;
  bool ruled = false;  // two laws that rule their ends may contradict each other
  const int n = 1 + random.below(10);
  for (int i = 0; i < n; ++i) {
    master += random.log_uniform(0.1, 10);
    CamSegment segment{Law::quintic, {master, random.uniform(-1, 1), {}, {}}, ""};
    if (!ruled && i > 0 && random.below(4) == 0) {
      segment.law = std::array{Law::line, Law::dwell,
                               Law::modified_sine}[static_cast<std::size_t>(random.below(3))];
      spec.segments.back().end.geo_velocity.reset();
      spec.segments.back().end.geo_acceleration.reset();
      if (segment.law == Law::dwell) segment.end.slave = slave;
    }
    ruled = segment.law != Law::quintic;
    if (!ruled && random.below(5) == 0) segment.end.geo_velocity = random.uniform(-1, 1);
    if (!ruled && random.below(5) == 0) segment.end.geo_acceleration = random.uniform(-1, 1);
    slave = segment.end.slave;
    spec.segments.push_back(segment);
  }
  return spec;
}

TEST(Boundaries, NoOtherChoiceHasLessJerk) {
  int tried = 0;
  for (int round = 0; round < 500; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    const CamSpec spec = random_cam(random);
    const auto free = free_derivatives(spec);
    const CamSpec chosen = filled(spec, Fill::minimum_jerk);
    const double least = square_jerk(chosen);
    for (std::size_t i = 0; i < free.size(); ++i)
      for (const double step : {-1e-3, 1e-3, -1.0, 1.0})
        for (int derivative = 0; derivative < 2; ++derivative) {
          if (!(derivative == 0 ? free[i].geo_velocity : free[i].geo_acceleration)) continue;
          CamSpec other = chosen;
          const auto move = [&](std::size_t knot) {
            (derivative == 0 ? knot_of(other, knot).geo_velocity
                             : knot_of(other, knot).geo_acceleration)
                .value() += step;
          };
          move(i);
          const std::size_t last = free.size() - 1;
          if (spec.periodic && (i == 0 || i == last)) move(last - i);
          EXPECT_GE(square_jerk(other), least * (1 - 1e-11)) << "knot " << i << ", step " << step;
          ++tried;
        }
  }
  EXPECT_GT(tried, 1000);
}

TEST(Boundaries, WhatIsGivenOrDemandedStays) {
  for (int round = 0; round < 500; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    CamSpec spec = random_cam(random);
    const auto resolved = resolved_knots(spec);
    const auto free = free_derivatives(spec);
    CamSpec chosen = filled(spec, Fill::minimum_jerk);
    const auto expect_kept = [&](std::size_t i, bool is_free, auto derivative) {
      const auto given = knot_of(spec, i).*derivative;
      const bool seam = spec.periodic && (i == 0 || i + 1 == free.size());
      if (given || (!is_free && !seam)) {
        EXPECT_EQ(knot_of(chosen, i).*derivative, resolved[i].*derivative) << "knot " << i;
      }
      if (seam && is_free) {
        EXPECT_EQ(chosen.start.*derivative, chosen.segments.back().end.*derivative);
      }
    };
    for (std::size_t i = 0; i < free.size(); ++i) {
      EXPECT_EQ(knot_of(chosen, i).slave, knot_of(spec, i).slave);
      expect_kept(i, free[i].geo_velocity, &CamKnot::geo_velocity);
      expect_kept(i, free[i].geo_acceleration, &CamKnot::geo_acceleration);
    }
  }
}

TEST(Boundaries, FreeKnotsAreJoinedUpToTheFourthDerivative) {
  CamSpec spec;
  spec.start = {0, 0, {}, {}};
  spec.periodic = true;
  for (const auto& [master, slave] :
       {std::pair{60.0, 12.0}, {150.0, 40.0}, {240.0, 25.0}, {360.0, 0.0}})
    spec.segments.push_back({Law::quintic, {master, slave, {}, {}}, ""});
  test::expect_invariants(design(filled(spec, Fill::minimum_jerk)).cam, 3);
}

TEST(Boundaries, RestIsWhatDesignDoes) {
  CamSpec spec = test::fig_6_14();
  spec.segments[0].end.geo_velocity.reset();
  CamSpec rest = filled(spec, Fill::rest);
  const auto resolved = resolved_knots(spec);
  for (std::size_t i = 0; i < resolved.size(); ++i) {
    EXPECT_EQ(knot_of(rest, i).geo_velocity, resolved[i].geo_velocity);
    EXPECT_EQ(knot_of(rest, i).geo_acceleration, resolved[i].geo_acceleration);
  }
}

TEST(Boundaries, BetweenDwells345AndItsMiddleFallOut) {
  CamSpec spec;
  spec.segments = {{Law::dwell, {1, 0, {}, {}}, ""},
                   {Law::quintic, {1.5, 0.5, {}, {}}, ""},
                   {Law::quintic, {2, 1, {}, {}}, ""},
                   {Law::dwell, {3, 1, {}, {}}, ""}};
  const CamSpec chosen = filled(spec, Fill::minimum_jerk);
  EXPECT_NEAR(*chosen.segments[1].end.geo_velocity, 15.0 / 8, 1e-14);
  EXPECT_NEAR(*chosen.segments[1].end.geo_acceleration, 0, 1e-13);
  EXPECT_NEAR(square_jerk(chosen), 720, 1e-10);
}

TEST(Boundaries, BesideALineItsSlopeAndBetweenLinesA345OfTheDifference) {
  CamSpec spec;
  spec.segments = {{Law::line, {1, 1, {}, {}}, ""},
                   {Law::quintic, {1.5, 1.7, {}, {}}, ""},
                   {Law::quintic, {2, 2, {}, {}}, ""},
                   {Law::line, {3, 3, {}, {}}, ""}};
  const CamSpec chosen = filled(spec, Fill::minimum_jerk);
  EXPECT_EQ(*chosen.segments[0].end.geo_velocity, 1);
  EXPECT_EQ(*chosen.segments[2].end.geo_velocity, 1);
  EXPECT_NEAR(*chosen.segments[1].end.geo_velocity, 1, 1e-14) << "symmetric about the line";
}

TEST(Boundaries, OneQuinticWithNothingGivenIsTheLine) {
  CamSpec spec;
  spec.segments = {{Law::quintic, {2, 3, {}, {}}, ""}};
  const CamSpec chosen = filled(spec, Fill::minimum_jerk);
  EXPECT_DOUBLE_EQ(*chosen.start.geo_velocity, 1.5);
  EXPECT_DOUBLE_EQ(*chosen.segments[0].end.geo_velocity, 1.5);
  EXPECT_DOUBLE_EQ(*chosen.segments[0].end.geo_acceleration, 0);
  spec.periodic = true;
  EXPECT_NEAR(*filled(spec, Fill::minimum_jerk).start.geo_velocity, 1.5, 1e-15)
      << "a slave that advances";
}

TEST(Boundaries, OneEndOfAPeriodicCamSpeaksForTheOther) {
  CamSpec spec;
  spec.start = {0, 0, 0.25, {}};
  spec.segments = {{Law::quintic, {1, 1, {}, {}}, ""}, {Law::quintic, {2, 0, {}, 0.5}, ""}};
  spec.periodic = true;
  const CamSpec chosen = filled(spec, Fill::minimum_jerk);
  EXPECT_EQ(*chosen.segments[1].end.geo_velocity, 0.25);
  EXPECT_EQ(*chosen.start.geo_acceleration, 0.5);

  spec.start = {0, 0, {}, {}};
  spec.segments = {{Law::dwell, {1, 0, {}, {}}, ""},
                   {Law::quintic, {2, 1, {}, {}}, ""},
                   {Law::quintic, {3, 0, {}, {}}, ""}};
  EXPECT_EQ(*filled(spec, Fill::minimum_jerk).segments[2].end.geo_velocity, 0)
      << "the dwell at the start";
}

TEST(Boundaries, ChangesWithItsUnitsAndWithNothingElse) {
  for (int round = 0; round < 50; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    const CamSpec spec = random_cam(random);
    CamSpec scaled = spec;
    for (std::size_t i = 0; i <= spec.segments.size(); ++i) {
      CamKnot& k = knot_of(scaled, i);
      k.master *= 0x1p20;
      k.slave *= 0x1p-30;
      if (k.geo_velocity) *k.geo_velocity *= 0x1p-50;
      if (k.geo_acceleration) *k.geo_acceleration *= 0x1p-70;
    }
    const auto small = resolved_knots(filled(spec, Fill::minimum_jerk));
    const auto large = resolved_knots(filled(scaled, Fill::minimum_jerk));
    for (std::size_t i = 0; i < small.size(); ++i) {
      EXPECT_EQ(*large[i].geo_velocity, *small[i].geo_velocity * 0x1p-50);
      EXPECT_EQ(*large[i].geo_acceleration, *small[i].geo_acceleration * 0x1p-70);
    }
  }
}

TEST(Boundaries, RejectsWhatDesignRejects) {
  CamSpec spec;
  spec.segments = {{Law::dwell, {1, 1, {}, {}}, ""}};
  EXPECT_THROW((void)filled(spec, Fill::minimum_jerk), InputError);
}

}  // namespace
}  // namespace jounce::boundaries_test
