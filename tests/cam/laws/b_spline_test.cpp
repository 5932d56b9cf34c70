// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/b_spline.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "spline_oracle.hpp"
#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::b_spline_test {
namespace {

using test::points_of;
using test::spline_oracle;
using test::within;

void expect_samples(const std::vector<Segment>& segments, double start,
                    const nlohmann::json& samples, double precision) {
  const Cam cam(segments, start, Extrapolation::hold);
  const double scale = std::abs(extrema(cam, 0).peak().value);
  for (const auto& s : samples)
    EXPECT_NEAR(cam.at(s["x"].get<double>()).position, s["value"].get<double>(), precision * scale)
        << s["x"];
}

TEST(BSpline, AgreesWithCoxAndDeBoor) {
  for (const auto& c : spline_oracle("b_spline")) {
    SCOPED_TRACE(c["degree"]);
    const BSplineSpec spec{c["degree"], c["knots"], c["control"]};
    expect_samples(b_spline(spec), spec.knots[static_cast<std::size_t>(spec.degree)], c["samples"],
                   1e-13);
  }
}

TEST(BSpline, ThroughPointsAgreesWithAnIndependentSolution) {
  const auto points = points_of(spline_oracle("points"));
  for (const auto& c : spline_oracle("interpolating_b_spline")) {
    SCOPED_TRACE(c["degree"]);
    expect_samples(b_spline(interpolating_b_spline(points, c["degree"])), points.front().master,
                   c["samples"], 1e-12);
  }
}

TEST(BSpline, ThroughPointsReproducesPolynomialsOfItsDegree) {
  for (int degree = 1; degree <= 7; ++degree)
    for (int round = 0; round < 50; ++round) {
      test::Random random(static_cast<std::uint64_t>(100 * degree + round));
      SCOPED_TRACE(::testing::Message() << degree << ", " << round);
      std::vector<double> c;
      for (int k = 0; k <= degree; ++k) c.push_back(random.uniform(-1, 1));
      const auto f = [&](double x) {
        double y = 0;
        for (std::size_t k = c.size(); k-- > 0;) y = y * x + c[k];
        return y;
      };
      std::vector<SplinePoint> points;
      const int n = degree + 1 + random.below(12);
      for (int i = 0; i < n; ++i) points.push_back({(i + random.uniform(-0.2, 0.2)) / n, 0});
      for (SplinePoint& p : points) p.slave = f(p.master);
      const Cam cam(b_spline(interpolating_b_spline(points, degree)), points.front().master);
      test::expect_invariants(cam, std::min(degree - 1, 3));
      for (int k = 0; k <= 100; ++k) {
        const double x = cam.start() + cam.length() * k / 100;
        EXPECT_NEAR(cam.at(within(cam, x)).position, f(x), 1e-11);
      }
    }
}

TEST(BSpline, LosesADerivativeForEachRepetitionOfAKnot) {
  BSplineSpec spec{3, {0, 0, 0, 0, 1, 1, 2, 2, 2, 2}, {0, 1, 3, -1, 2, 0}};
  const Cam cam(b_spline(spec), 0, Extrapolation::hold);
  EXPECT_EQ(cam.segments().size(), 2U);
  EXPECT_NEAR(cam.jet(1)[1], cam.jet(1, Side::left)[1], 1e-14);
  EXPECT_GT(std::abs(cam.jet(1)[2] - cam.jet(1, Side::left)[2]), 1);
  EXPECT_DOUBLE_EQ(cam.at(0).position, 0);
  EXPECT_NEAR(cam.at(2, Side::left).position, 0, 1e-15);
}

TEST(BSpline, StaysWithinItsControlValues) {
  for (int round = 0; round < 200; ++round) {
    test::Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    BSplineSpec spec{1 + random.below(11), {}, {}};
    const int n = spec.degree + 1 + random.below(8);
    double least = 1, most = -1, t = 0;
    for (int i = 0; i < n; ++i) {
      spec.control.push_back(random.uniform(-1, 1));
      least = std::min(least, spec.control.back());
      most = std::max(most, spec.control.back());
    }
    for (int i = 0; i < n + spec.degree + 1; ++i, t += random.log_uniform(0.01, 1))
      spec.knots.push_back(t);
    const Range r = extrema(Cam(b_spline(spec)), 0);
    EXPECT_GE(r.min.value, least - 1e-12);
    EXPECT_LE(r.max.value, most + 1e-12);
  }
}

TEST(Bezier, AgreesWithDeCasteljau) {
  for (const auto& c : spline_oracle("bezier")) {
    SCOPED_TRACE(c["control"].dump());
    const auto control = c["control"].get<std::vector<double>>();
    const Segment f = bezier(120, control);
    EXPECT_EQ(f.length, 120);
    for (std::size_t k = 0; k <= 8; ++k)
      EXPECT_NEAR(value(f, static_cast<double>(k) / 8), c["samples"][k].get<double>(),
                  1e-13 * magnitude(f));
  }
}

TEST(Bezier, SixValuesInTwoThreesAre345) {
  const Cam cam({bezier(1, std::vector<double>{0, 0, 0, 1, 1, 1})});
  EXPECT_NEAR(extrema(cam, 1).max.value, 15.0 / 8, 1e-14);
  EXPECT_NEAR(extrema(cam, 2).max.value, 10 / std::sqrt(3.0), 1e-13);
}

TEST(Bezier, ChainIsContinuousAndAsSmoothAsItsControlValues) {
  const std::vector<double> breaks{0, 60, 120};
  const Cam smooth(bezier_chain(breaks, std::vector<double>{0, 0, 10, 20, 30, 40, 40}, 3), 0,
                   Extrapolation::hold);
  EXPECT_TRUE(check_continuity(smooth, 1).ok());
  const Cam kinked(bezier_chain(breaks, std::vector<double>{0, 0, 10, 20, 20, 40, 40}, 3), 0,
                   Extrapolation::hold);
  EXPECT_TRUE(check_continuity(kinked, 0).ok());
  EXPECT_FALSE(check_continuity(kinked, 1).ok());
}

template <class Make>
std::string complaint(Make make) {
  return test::error_of([&] { (void)make(); });
}

TEST(BSpline, NamesTheRejectedValue) {
  const auto of = [](BSplineSpec spec) { return complaint([&] { return b_spline(spec); }); };
  EXPECT_EQ(of({0, {0, 1}, {0}}), "degree = 0: must be 1 to 11");
  EXPECT_EQ(of({2, {0, 0, 1, 1}, {0, 1}}),
            "control = 2 values: must be at least 3, one more than the degree");
  EXPECT_EQ(of({1, {0, 0, 1}, {0, 1}}), "knots = 3 values: must be 4");
  EXPECT_EQ(of({1, {0, 0, 2, 1}, {0, 1}}),
            "knots[4] = 1: must not be less than 2, the previous knot");
  EXPECT_EQ(of({1, {0, 0, 1, 1, 2, 2}, {0, 1, 2, 3}}),
            "knots[3] = 1: occurs more than 1 times: the curve would break");
  EXPECT_EQ(of({1, {0, 1, 1, 2}, {0, 1}}),
            "knots[2] = 1: must be less than knots[3], where the curve ends");
  EXPECT_EQ(complaint([] {
              return interpolating_b_spline({{0, 0}, {1, 1}}, 2);
            }),
            "points = 2: must be at least 3");
  EXPECT_EQ(complaint([] {
              return interpolating_b_spline({{0, 0}, {1, 1}}, 8);
            }),
            "degree = 8: must be 1 to 7");
  EXPECT_EQ(complaint([] { return bezier(0, std::vector<double>{1}); }),
            "length = 0: must be greater than 0");
  EXPECT_EQ(complaint([] { return bezier(1, {}); }), "control = 0 values: must be 1 to 12");
  const std::vector<double> breaks{0, 1, 1};
  EXPECT_EQ(complaint([&] {
              return bezier_chain(breaks, std::vector<double>{0, 1, 2, 3}, 1);
            }),
            "control = 4 values: must be 3");
  EXPECT_EQ(complaint([&] {
              return bezier_chain(breaks, std::vector<double>{0, 1, 2}, 1);
            }),
            "breaks[3] = 1: must be greater than 1, the previous break");
}

}  // namespace
}  // namespace jounce::b_spline_test
