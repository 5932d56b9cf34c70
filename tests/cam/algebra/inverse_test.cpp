// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/algebra/inverse.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/design/random_cams.hpp"
#include "support/fig_6_14.hpp"

namespace jounce::inverse_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Inverse only_branch(const Cam& cam) {
  const Inversion all = inverted(cam);
  EXPECT_EQ(all.branches.size(), 1U);
  return all.branches.at(0);
}

/// A rise of 50 to 120, a dwell to 200, a return to 360.
Cam rise_dwell_return() {
  CamSpec spec;
  spec.segments = {{Law::modified_sine, {120, 50, {}, {}}, "rise"},
                   {Law::dwell, {200, 50, {}, {}}, "dwell"},
                   {Law::poly345, {360, 0, {}, {}}, "return"}};
  spec.periodic = true;
  return design(spec).cam;
}

TEST(Inverse, OfALineIsALine) {
  const Inverse g = only_branch(Cam({line(8, 1, 5)}, 3));
  EXPECT_EQ(g.start(), 1);
  EXPECT_EQ(g.end(), 5);
  for (const double y : {1.0, 1.3, 2.0, 4.999, 5.0}) {
    const Transfer at = g.at(y);
    EXPECT_DOUBLE_EQ(at.position, 3 + 2 * (y - 1));
    EXPECT_DOUBLE_EQ(at.geo_velocity, 2);
    EXPECT_EQ(at.geo_acceleration, 0);
    EXPECT_EQ(at.geo_jerk, 0);
  }
}

TEST(Inverse, OfAParabolaIsASquareRoot) {
  const Inverse g = only_branch(Cam(scca(0, 1, 0)));  // y = 2 z^2 up to the middle
  for (const double y : {1e-300, 1e-100, 1e-30, 1e-12, 1e-3, 0.1, 0.3, 0.4999}) {
    const double z = std::sqrt(y / 2);
    const Transfer at = g.at(y);
    EXPECT_NEAR(at.position, z, 1e-15 * z) << y;
    EXPECT_NEAR(at.geo_velocity * 4 * z, 1, 1e-14) << y;
    if (y < 1e-90) continue;  // y^-2.5 leaves the doubles
    EXPECT_NEAR(at.geo_acceleration / (-1 / (16 * z * z * z)), 1, 1e-14) << y;
    EXPECT_NEAR(at.geo_jerk / (3 / (64 * std::pow(z, 5))), 1, 1e-14) << y;
  }
}

TEST(Inverse, OfASimpleSineIsAnArcCosine) {
  constexpr double pi = std::numbers::pi;
  const Inverse g = only_branch(Cam(scca(0, 0, 1)));
  for (const double y : {1e-9, 1e-3, 0.1, 0.49, 0.5, 0.77, 0.99, 1 - 1e-6}) {
    const double w = y * (1 - y);
    const double dw = 1 - 2 * y;
    const Transfer at = g.at(y);
    const double tolerance = 1e-14 / std::min(1.0, 1000 * w);  // the cosine's digits at the ends
    EXPECT_NEAR(at.position, 2 / pi * std::asin(std::sqrt(y)), tolerance) << y;
    EXPECT_NEAR(at.geo_velocity * pi * std::sqrt(w), 1, 1e3 * tolerance) << y;
    EXPECT_NEAR(at.geo_acceleration, -dw / (2 * pi * std::pow(w, 1.5)),
                1e3 * tolerance / std::pow(w, 1.5))
        << y;
    EXPECT_NEAR(at.geo_jerk, (0.75 * dw * dw / w + 1) / (pi * std::pow(w, 1.5)),
                1e3 * tolerance / std::pow(w, 2.5))
        << y;
  }
}

TEST(Inverse, IsFoundBesideAFlatRestFarFromZero) {
  // 126 s^5 from 100: near the guess the slave's motion is rounding.
  Segment f = line(1, 100, 101);
  f.degree = 9;
  f.c = {100, 0, 0, 0, 0, 126, -420, 540, -315, 70};
  const Inverse g = only_branch(Cam({f}));
  for (const double travel : {1e-13, 1e-12, 1e-10, 1e-7}) {
    const double y = 100 + travel;
    EXPECT_NEAR(value(f, g.at(y).position), y, 3e-14);
    EXPECT_NEAR(g.at(y).position / std::pow((y - 100) / 126, 0.2), 1, 0.1);
  }
}

TEST(Inverse, AnswersRestWithTheInfinityThatIsApproached) {
  const Inverse rise = only_branch(Cam({quintic(1, 0, 0, 0, 1, 0, 0)}));
  EXPECT_EQ(rise.jet(0), (Jet{0, infinite, -infinite, infinite}));
  EXPECT_EQ(rise.jet(0, Side::left), rise.jet(0)) << "only one side exists";
  EXPECT_EQ(rise.jet(1), (Jet{1, infinite, infinite, infinite}));
  const Inverse fall = only_branch(Cam({quintic(1, 1, 0, 0, 0, 0, 0)}));
  EXPECT_EQ(fall.jet(1), (Jet{0, -infinite, -infinite, -infinite}));
  EXPECT_EQ(fall.jet(0), (Jet{1, -infinite, infinite, -infinite}));

  // y = x^3 about the middle of [-1, 1]: at rest there without standing.
  Segment cube;
  cube.length = 2;
  cube.degree = 3;
  cube.c = {-1, 6, -12, 8};
  const Inverse root = only_branch(Cam({cube}, -1));
  EXPECT_NEAR(root.at(0.001).position, 0.1, 1e-13);
  const double rest = root.breaks()[1];
  EXPECT_NEAR(rest, 0, 1e-15);
  EXPECT_NEAR(root.at(rest).position, 0, 1e-5);
  EXPECT_EQ(root.jet(rest)[2], -infinite) << "leaving";
  EXPECT_EQ(root.jet(rest, Side::left)[2], infinite) << "arriving";
}

TEST(Inverse, ReportsWhatStandsStillAndWhatRunsBack) {
  const Inversion all = inverted(rise_dwell_return());
  ASSERT_EQ(all.runs.size(), 3U);
  EXPECT_EQ(all.runs[0].kind, CamRun::Kind::rise);
  EXPECT_EQ(all.runs[1].kind, CamRun::Kind::dwell);
  EXPECT_EQ(all.runs[2].kind, CamRun::Kind::fall);
  ASSERT_EQ(all.report.findings.size(), 2U);
  EXPECT_FALSE(all.report.ok());
  const Finding& dwell = all.report.findings[0];
  EXPECT_EQ(dwell.rule, "inverse/dwell");
  EXPECT_EQ(dwell.where, 120);
  EXPECT_NEAR(dwell.value, 50, 1e-13);
  EXPECT_EQ(dwell.advice, "the slave stands still from 120 to 200: the master jumps");
  const Finding& back = all.report.findings[1];
  EXPECT_EQ(back.rule, "inverse/reversal");
  EXPECT_EQ(back.where, 200);
  EXPECT_NEAR(back.value, 0, 1e-13);
  EXPECT_EQ(back.advice, "the slave runs back from 200 to 360: choose a branch");

  ASSERT_EQ(all.branches.size(), 2U);
  EXPECT_NEAR(all.branches[0].at(25).position, 60, 1e-12);
  EXPECT_NEAR(all.branches[1].at(25).position, 280, 1e-12);
  EXPECT_FALSE(all.branches[1].rises());
  EXPECT_LT(all.branches[1].at(25).geo_velocity, 0);
  EXPECT_EQ(all.branch_at(60), &all.branches[0]);
  EXPECT_EQ(all.branch_at(160), nullptr);
  EXPECT_EQ(all.branch_at(300), &all.branches[1]);
}

TEST(Inverse, JumpsOverADwellOnTheWay) {
  CamSpec spec;
  spec.segments = {{Law::modified_sine, {100, 50, {}, {}}, ""},
                   {Law::dwell, {200, 50, {}, {}}, ""},
                   {Law::modified_trapezoid, {300, 80, {}, {}}, ""}};
  const Inversion all = inverted(design(spec).cam);
  ASSERT_EQ(all.branches.size(), 1U);
  ASSERT_EQ(all.report.findings.size(), 1U);
  const Inverse& g = all.branches[0];
  const double level = *std::lower_bound(g.breaks().begin(), g.breaks().end(), 50 - 1e-12);
  EXPECT_NEAR(level, 50, 1e-13);
  EXPECT_EQ(g.at(level, Side::left).position, 100);
  EXPECT_EQ(g.at(level).position, 200);
  EXPECT_EQ(g.jet(level, Side::left)[2], infinite);
  EXPECT_EQ(g.jet(level)[2], -infinite);
}

TEST(Inverse, SplitsWhereTheSlaveJumps) {
  const Inversion all = inverted(Cam({line(1, 0, 1), line(1, 2, 3)}));
  ASSERT_EQ(all.branches.size(), 2U);
  ASSERT_EQ(all.report.findings.size(), 1U);
  EXPECT_EQ(all.report.findings[0].rule, "inverse/jump");
  EXPECT_EQ(all.report.findings[0].value, 2);
  EXPECT_EQ(all.report.findings[0].limit, 1);
}

#ifdef NDEBUG
TEST(Inverse, HoldsOutsideInAReleaseBuild) {
  const Inverse g = only_branch(Cam({line(2, 0, 4)}));
  EXPECT_EQ(g.jet(-1), (Jet{0, 0, 0, 0}));
  EXPECT_EQ(g.jet(5), (Jet{2, 0, 0, 0}));
}
#endif

TEST(Inverse, OfACamThatNeverMovesHasNoBranch) {
  const Inversion all = inverted(Cam({line(3, 7, 7)}, 1));
  EXPECT_TRUE(all.branches.empty());
  EXPECT_EQ(all.report.findings.at(0).rule, "inverse/dwell");
}

TEST(Inverse, OfAStrictlyMonotoneCamIsTheInverse) {
  const Inversion all = inverted(Cam({quintic(1, 0, 0, 0, 1, 0, 0), line(1e-3, 1, 1.5)}));
  EXPECT_TRUE(all.report.ok());
  EXPECT_EQ(all.branches.size(), 1U);
}

TEST(Inverse, Fig614RisesASecondTimeAroundItsSlopeAt280) {
  const Inversion all = inverted(design(test::fig_6_14()).cam);
  ASSERT_EQ(all.runs.size(), 4U);
  EXPECT_EQ(all.runs[2].kind, CamRun::Kind::rise) << "the printed slope there is + 0.017";
  EXPECT_LT(all.runs[2].from, 280);
  EXPECT_GT(all.runs[2].to, 280);
  const Inverse* sync = all.branch_at(100);  // slave = master + 25 from 75 to 200
  ASSERT_NE(sync, nullptr);
  EXPECT_NEAR(sync->at(150).position, 125, 1e-12);
  EXPECT_NEAR(sync->at(150).geo_velocity, 1, 1e-12);
}

/// f(g(y)) = y with all its derivatives: value within 1e-12 of the stroke; g' f' = 1 and so on where
/// the slave is not about to rest.
void expect_inverse(const Cam& cam, const Inverse& g, test::Random& random) {
  const Range range = extrema(cam, 0);
  const double stroke = range.max.value - range.min.value;
  // Beyond 100 strokes from zero the digits of the position are fewer than those of the stroke.
  const double tolerance = std::max(1e-12 * stroke, 1e-14 * std::abs(range.peak().value));
  double before = g.rises() ? g.master_from() : g.master_to();
  double slope_before = infinite;
  std::vector<double> slaves(g.breaks().begin(), g.breaks().end());
  const double travel = g.end() - g.start();
  for (int i = 0; i < 12; ++i) slaves.push_back(random.uniform(g.start(), g.end()));
  for (int i = 0; i < 6; ++i) {  // near the flat ends
    slaves.push_back(std::min(g.end(), g.start() + random.log_uniform(1e-18, 1) * travel));
    slaves.push_back(std::max(g.start(), g.end() - random.log_uniform(1e-18, 1) * travel));
  }
  std::sort(slaves.begin(), slaves.end());
  for (const double y : slaves)
    for (const Side side : {Side::left, Side::right}) {
      const Jet x = g.jet(y, side);
      EXPECT_NEAR(cam.jet(x[0], Side::left)[0], y, tolerance) << y;
      EXPECT_GE(x[0], g.master_from());
      EXPECT_LE(x[0], g.master_to());
      const double noise =  // shift of the master by rounding of the slave; greater beside a rest
          1e-12 * cam.length() + 1e-13 * stroke * std::max(std::abs(x[1]), slope_before);
      EXPECT_TRUE(g.rises() ? x[0] >= before - noise : x[0] <= before + noise) << "monotone";
      before = x[0];
      slope_before = std::abs(x[1]);
      for (const double d : x) EXPECT_FALSE(std::isnan(d));
      EXPECT_TRUE(g.rises() ? x[1] > 0 : x[1] < 0);
    }
}

TEST(Inverse, UndoesRandomCamsOfEveryLawAndScale) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const bool one_way = random.below(2) == 0;
    const Cam cam = test::random_cam(random, one_way);
    const Inversion all = inverted(cam);
    EXPECT_TRUE(!one_way || all.branches.size() == 1);
    for (const Inverse& g : all.branches) expect_inverse(cam, g, random);
    if (HasFailure()) break;
  }
}

TEST(Inverse, DerivativesUndoTheCamsDerivatives) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Cam cam = test::random_cam(random, false);
    for (const Inverse& g : inverted(cam).branches) {
      const double y = random.uniform(g.start() + 0.05 * (g.end() - g.start()),
                                      g.end() - 0.05 * (g.end() - g.start()));
      const Jet x = g.jet(y);
      const Jet f = cam.jet(x[0]);
      // The chain rule of f(g(y)) = y; terms that cancel are compared with their size.
      EXPECT_NEAR(f[1] * x[1], 1, 1e-9);
      const double a = f[2] * x[1] * x[1];
      EXPECT_NEAR(a + f[1] * x[2], 0, 1e-8 * (std::abs(a) + std::abs(f[1] * x[2]))) << y;
      const double b = f[3] * x[1] * x[1] * x[1];
      const double c = 3 * f[2] * x[1] * x[2];
      EXPECT_NEAR(b + c + f[1] * x[3], 0, 1e-7 * (std::abs(b) + std::abs(c))) << y;
    }
    if (HasFailure()) break;
  }
}

TEST(Inverse, IsTheSameInEveryUnit) {
  const Cam cam = rise_dwell_return();
  const Inverse g = inverted(cam).branches[0];
  for (const double u : {1e-9, 1e9})
    for (const double m : {1e-9, 1e9}) {
      const Inverse h = inverted(scaled(cam, u, m)).branches[0];
      for (const double y : {0.01, 0.1, 10.0, 49.9}) {
        const Jet a = g.jet(y);
        const Jet b = h.jet(y * u);
        double unit = m;
        for (std::size_t k = 0; k < 4; ++k, unit /= u)
          EXPECT_NEAR(b[k] / unit / a[k], 1, 1e-9) << y << " " << u << " " << m << " " << k;
      }
    }
}

TEST(InverseWithin, IsACurveWithACertifiedError) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Cam cam = test::random_cam(random, false);
    for (const Inverse& g : inverted(cam).branches) {
      const std::size_t k =
          static_cast<std::size_t>(random.below(static_cast<int>(g.breaks().size()) - 1));
      const double low = g.breaks()[k];
      const double travel = g.breaks()[k + 1] - low;
      const double from = low + random.uniform(0.01, 0.5) * travel;
      const double to = low + random.uniform(0.51, 0.99) * travel;
      const double unit = cam.length() + std::abs(cam.start());
      const double tolerance = random.log_uniform(1e-11, 1e-3) * unit;
      const auto fitted = inverse_within(g, from, to, tolerance);
      EXPECT_LE(fitted.error[0], tolerance);
      EXPECT_EQ(fitted.curve.start(), from);
      EXPECT_NEAR(fitted.curve.end(), to, 1e-14 * std::max(std::abs(from), std::abs(to)));
      for (int n = 0; n < 20; ++n) {
        const double y = random.uniform(from, fitted.curve.end());
        const Jet wanted = g.jet(y);
        const Jet got = fitted.curve.jet(y);
        const double rounding =  // the slave's digits, where its offset is many strokes
            1e-13 * unit + 1e-14 * magnitude(cam.segments()[0]) * std::abs(wanted[1]);
        EXPECT_NEAR(got[0], wanted[0], fitted.error[0] + rounding) << y;
        EXPECT_NEAR(got[1], wanted[1],
                    fitted.error[1] + 1e4 * rounding / travel + 1e-6 * std::abs(wanted[1]))
            << y;
      }
    }
    if (HasFailure()) break;
  }
}

TEST(InverseWithin, RejectsARest) {
  const Inverse g = only_branch(Cam({quintic(1, 0, 0, 0, 1, 0, 0)}));
  EXPECT_THROW(inverse_within(g, 0, 0.5, 1e-6), InputError);
  EXPECT_THROW(inverse_within(g, 0.5, 1, 1e-6), InputError);
  EXPECT_THROW(inverse_within(g, 0.5, 2, 1e-6), InputError);
  EXPECT_NO_THROW(inverse_within(g, 1e-6, 1 - 1e-6, 1e-6));
  const auto line_only = inverse_within(only_branch(Cam({line(8, 1, 5)}, 3)), 1, 5, 1e-6);
  EXPECT_EQ(line_only.curve.segments().size(), 1U);
  EXPECT_EQ(line_only.error, Jet{});
}

TEST(Runs, MeetAtTurningPointsInsideASegment) {
  // x^3 - x over [-1.5, 1.5] turns at +-1/sqrt(3).
  Segment f;
  f.length = 3;
  f.degree = 3;
  f.c = {-1.875, 17.25, -40.5, 27};
  const Cam cam({f}, -1.5);
  const auto found = runs(cam);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[1].kind, CamRun::Kind::fall);
  EXPECT_NEAR(found[1].from, -1 / std::sqrt(3), 1e-14);
  EXPECT_NEAR(found[1].to, 1 / std::sqrt(3), 1e-14);
  EXPECT_NEAR(found[1].slave_from, 2 / std::sqrt(27), 1e-14);
  EXPECT_EQ(positions_for(cam, 0).size(), 3U);
  EXPECT_EQ(positions_for(cam, 0.5).size(), 1U);
}

TEST(Positions, AreAllThereAre) {
  const Cam cam = rise_dwell_return();
  const auto at_25 = positions_for(cam, 25);
  ASSERT_EQ(at_25.size(), 2U);
  EXPECT_NEAR(at_25[0].from, 60, 1e-12);
  EXPECT_EQ(at_25[0].from, at_25[0].to);
  EXPECT_NEAR(at_25[1].from, 280, 1e-12);

  const auto at_50 = positions_for(cam, 50);
  ASSERT_EQ(at_50.size(), 1U);
  EXPECT_EQ(at_50[0].from, 120);
  EXPECT_EQ(at_50[0].to, 200);

  const auto at_0 = positions_for(cam, 0);
  ASSERT_EQ(at_0.size(), 1U) << "the end is the start of the next turn";
  EXPECT_EQ(at_0[0].from, 0);
  EXPECT_EQ(positions_for(with(cam, Extrapolation::hold), 0).size(), 2U);

  EXPECT_TRUE(positions_for(cam, 50.001).empty());
  EXPECT_THROW(positions_for(cam, std::nan("")), InputError);
}

TEST(Positions, HoldTheInverseOfEveryBranch) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Cam cam = test::random_cam(random, false);
    for (const Inverse& g : inverted(cam).branches) {
      const double y = random.uniform(g.start(), g.end());
      const double x = g.at(y).position;
      const auto spans = positions_for(cam, y);
      EXPECT_TRUE(std::any_of(spans.begin(), spans.end(), [&](const MasterSpan& at) {
        return std::abs(at.from - x) <= 1e-6 * cam.length();
      })) << y;
    }
    if (HasFailure()) break;
  }
}

}  // namespace
}  // namespace jounce::inverse_test
