// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/spline.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <span>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/design/least_energy.hpp"
#include "spline_oracle.hpp"
#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::spline_test {
namespace {

using test::points_of;
using test::Random;
using test::spline_oracle;
using test::within;
using Maker = std::function<std::vector<Segment>(const SplineSpec&)>;

Cam cam_of(const std::vector<Segment>& segments, const SplineSpec& spec) {
  return Cam(segments, spec.points.front().master,
             spec.ends == SplineEnds::periodic ? Extrapolation::wrap : Extrapolation::refuse);
}

void expect_oracle(const char* name, const Maker& make, SplineSpec spec) {
  SCOPED_TRACE(name);
  spec.points = points_of(spline_oracle("points"));
  const Cam cam = cam_of(make(spec), spec);
  const Ranges ranges = extrema(cam);
  for (const auto& sample : spline_oracle("interpolating")[name]) {
    const Jet jet = cam.jet(within(cam, sample["x"].get<double>()));
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(jet[k], sample["jet"][k].get<double>(), 1e-13 * std::abs(ranges[k].peak().value))
          << "derivative " << k << " at " << sample["x"];
  }
}

TEST(Spline, AgreesWithAnIndependentSolution) {
  expect_oracle("cubic natural", cubic_spline, {});
  expect_oracle("cubic clamped", cubic_spline,
                {.points = {}, .start = {2, {}}, .end = {-0.75, {}}});
  expect_oracle("cubic periodic", cubic_spline, {.points = {}, .ends = SplineEnds::periodic});
  expect_oracle("cubic not_a_knot", cubic_spline, {.points = {}, .ends = SplineEnds::not_a_knot});
  expect_oracle("quintic natural", quintic_spline, {});
  expect_oracle("quintic clamped", quintic_spline,
                {.points = {}, .start = {2, -1}, .end = {-0.75, 0.5}});
  expect_oracle("quintic half clamped", quintic_spline,
                {.points = {}, .start = {2, {}}, .end = {{}, 0.5}});
  expect_oracle("quintic periodic", quintic_spline, {.points = {}, .ends = SplineEnds::periodic});
  expect_oracle("quintic not_a_knot", quintic_spline,
                {.points = {}, .ends = SplineEnds::not_a_knot});
}

/// sum of c[k] (x - 1)^k and its derivatives.
double polynomial(const std::vector<double>& c, double x, int order) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > static_cast<std::size_t>(order);) {
    double factor = c[k];
    for (int i = 0; i < order; ++i) factor *= static_cast<double>(k) - i;
    sum = sum * (x - 1) + factor;
  }
  return sum;
}

SplineSpec table(Random& random, int points, const std::function<double(double)>& f) {
  SplineSpec spec;
  double x = random.uniform(-1, 1);
  for (int i = 0; i < points; ++i, x += random.log_uniform(0.1, 1))
    spec.points.push_back({x, f(x)});
  return spec;
}

/// Largest difference from f between the points.
double error_of(const Cam& cam, const std::function<double(double)>& f) {
  double worst = 0;
  for (std::size_t i = 0; i < cam.segments().size(); ++i)
    for (int n = 0; n <= 32; ++n) {
      const double x = cam.breaks()[i] + cam.segments()[i].length * n / 32;
      worst = std::max(worst, std::abs(value(cam.segments()[i], n / 32.0) - f(x)));
    }
  return worst;
}

TEST(Spline, ReproducesThePolynomialsOfItsDegree) {
  for (int round = 0; round < 200; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    std::vector<double> c;
    for (int k = 0; k < 6; ++k) c.push_back(random.uniform(-1, 1));
    const std::vector<double> cubic(c.begin(), c.begin() + 4);
    const auto of = [](const std::vector<double>& p) {
      return [p](double x) { return polynomial(p, x, 0); };
    };
    const int points = 2 + random.below(12);

    SplineSpec spec = table(random, points, of(cubic));
    const double from = spec.points.front().master;
    const double to = spec.points.back().master;
    spec.start.geo_velocity = polynomial(cubic, from, 1);
    spec.end.geo_velocity = polynomial(cubic, to, 1);
    const Cam clamped = cam_of(cubic_spline(spec), spec);
    const double scale = std::abs(extrema(clamped, 0).peak().value) + 1;
    EXPECT_LT(error_of(clamped, of(cubic)), 1e-12 * scale);

    spec.start = spec.end = {};
    spec.ends = SplineEnds::not_a_knot;
    if (points >= 4) {
      EXPECT_LT(error_of(cam_of(cubic_spline(spec), spec), of(cubic)), 1e-12 * scale);
    }

    spec = table(random, points, of(c));
    const double a = spec.points.front().master;
    const double b = spec.points.back().master;
    spec.start = {polynomial(c, a, 1), polynomial(c, a, 2)};
    spec.end = {polynomial(c, b, 1), polynomial(c, b, 2)};
    const Cam quintic = cam_of(quintic_spline(spec), spec);
    const double range = std::abs(extrema(quintic, 0).peak().value) + 1;
    EXPECT_LT(error_of(quintic, of(c)), 1e-12 * range);

    spec.start = spec.end = {};
    spec.ends = SplineEnds::not_a_knot;
    if (points >= 6) {
      EXPECT_LT(error_of(cam_of(quintic_spline(spec), spec), of(c)), 1e-11 * range);
    }
  }
}

TEST(Spline, NaturalOnesReproduceWhatHasNoEnergy) {
  Random random(5);
  SplineSpec line = table(random, 7, [](double x) { return 3 - 2 * x; });
  EXPECT_LT(error_of(cam_of(cubic_spline(line), line), [](double x) { return 3 - 2 * x; }), 1e-14);
  const auto parabola = [](double x) { return 3 - 2 * x + x * x; };
  SplineSpec bent = table(random, 7, parabola);
  EXPECT_LT(error_of(cam_of(quintic_spline(bent), bent), parabola), 1e-12);
}

TEST(Spline, ThroughTwoPointsWithNothingGivenIsTheLine) {
  const SplineSpec spec{.points = {{1, 2}, {3, 8}}};
  for (const Maker& make : {Maker(cubic_spline), Maker(quintic_spline)}) {
    const Cam cam = cam_of(make(spec), spec);
    EXPECT_DOUBLE_EQ(cam.at(1.5).position, 3.5);
    EXPECT_DOUBLE_EQ(cam.at(1.5).geo_velocity, 3);
    EXPECT_NEAR(cam.at(1.5).geo_acceleration, 0, 1e-14);
  }
  for (const SplineEnds ends : {SplineEnds::not_a_knot, SplineEnds::periodic}) {
    SplineSpec other = spec;
    other.ends = ends;
    EXPECT_NEAR(cam_of(quintic_spline(other), other).at(1.5).position, 3.5, 1e-14)
        << "a periodic slave that advances by 6 each turn runs straight";
  }
}

TEST(Spline, RestToRestThroughTwoPointsIs345) {
  SplineSpec spec{.points = {{0, 0}, {1, 1}}};
  spec.start = spec.end = {0.0, 0.0};
  const Cam cam = cam_of(quintic_spline(spec), spec);
  EXPECT_NEAR(extrema(cam, 1).max.value, 15.0 / 8, 1e-14);
  EXPECT_NEAR(extrema(cam, 2).max.value, 10 / std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(cam_detail::square_jerk({cam.segments().begin(), cam.segments().end()}), 720, 1e-10);
}

/// The fourth derivative at the ends of a segment.
double fourth(const Segment& f, double s) {
  return (24 * f.c[4] + 120 * f.c[5] * s) / std::pow(f.length, 4);
}

TEST(Spline, JoinsWithItsStatedContinuity) {
  for (int round = 0; round < 300; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    SplineSpec spec =
        table(random, 4 + random.below(20), [&](double) { return random.uniform(-1, 1); });
    spec.ends = static_cast<SplineEnds>(round % 3);
    if (spec.ends == SplineEnds::periodic) spec.points.back().slave = spec.points.front().slave;
    test::expect_invariants(cam_of(cubic_spline(spec), spec), 2);
    const Cam cam = cam_of(quintic_spline(spec), spec);
    test::expect_invariants(cam, 3);
    double scale = 0;
    double jump = 0;
    for (std::size_t i = 0; i + 1 < cam.segments().size(); ++i) {
      scale = std::max(scale, std::abs(fourth(cam.segments()[i], 1)));
      jump =
          std::max(jump, std::abs(fourth(cam.segments()[i], 1) - fourth(cam.segments()[i + 1], 0)));
    }
    EXPECT_LE(jump, 1e-9 * scale);
    for (const SplinePoint& p : spec.points)
      EXPECT_NEAR(cam.at(within(cam, p.master)).position, p.slave,
                  1e-12 * std::abs(extrema(cam, 0).peak().value));
  }
}

TEST(Spline, IsTheSmoothestThroughItsPoints) {
  for (int round = 0; round < 100; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(round);
    const int n = 3 + random.below(8);
    const SplineSpec spec = table(random, n, [&](double) { return random.uniform(-1, 1); });
    const auto energy = [](const std::vector<Segment>& f) { return cam_detail::square_jerk(f); };
    const double least = energy(quintic_spline(spec));
    // Any other piecewise quintic through the points, with velocity and acceleration joined.
    const Cam cam = cam_of(quintic_spline(spec), spec);
    std::vector<cam_detail::EnergyKnot> knots;
    for (const SplinePoint& p : spec.points) {
      const Jet jet = cam.jet(within(cam, p.master));
      knots.push_back(
          {p.master,
           {p.slave, jet[1] + random.uniform(-1e-3, 1e-3), jet[2] + random.uniform(-1e-3, 1e-3)},
           {}});
    }
    EXPECT_GT(energy(cam_detail::segments_between(knots, cam_detail::Energy::jerk)), least);
  }
}

double cycloid(double z) {
  return z - std::sin(2 * std::numbers::pi * z) / (2 * std::numbers::pi);
}

/// Largest error of `make` through n equal intervals.
double error_at(int n, const Maker& make, SplineSpec spec, double (*f)(double)) {
  for (int i = 0; i <= n; ++i) {
    const double z = static_cast<double>(i) / n;
    spec.points.push_back({z, f(z)});
  }
  return error_of(cam_of(make(spec), spec), f);
}

double observed_order(const Maker& make, const SplineSpec& spec, double (*f)(double) = cycloid,
                      int n = 40) {
  return std::log2(error_at(n, make, spec, f) / error_at(2 * n, make, spec, f));
}

TEST(Spline, ErrorFallsWithTheOrderThatTheoryGives) {
  const SplineSpec rest{.points = {}, .start = {0.0, {}}, .end = {0.0, {}}};
  const SplineSpec still{.points = {}, .start = {0.0, 0.0}, .end = {0.0, 0.0}};
  const SplineSpec periodic{.points = {}, .ends = SplineEnds::periodic};
  const SplineSpec not_a_knot{.points = {}, .ends = SplineEnds::not_a_knot};
  EXPECT_NEAR(observed_order(cubic_spline, rest), 4, 0.1);
  EXPECT_NEAR(observed_order(cubic_spline, periodic), 4, 0.1);
  const auto wave = [](double z) { return std::sin(3 * z + 1); };
  EXPECT_NEAR(observed_order(cubic_spline, not_a_knot, wave), 4, 0.1);
  EXPECT_NEAR(observed_order(quintic_spline, not_a_knot, wave), 6, 0.1);
  EXPECT_NEAR(observed_order(quintic_spline, still), 6, 0.1);
  EXPECT_NEAR(observed_order(quintic_spline, periodic), 6, 0.1);
  EXPECT_NEAR(observed_order(quintic_spline, {}), 3, 0.1) << "natural ends: f''' is not 0 there";
}

/// Smallest number of intervals of the cycloid for an error of 1e-6 (cams.md 1.5), Hermite
/// interpolation of the given degree.
int intervals_needed(int degree) {
  const double w = 2 * std::numbers::pi;
  for (int n = 1;; ++n) {
    double worst = 0;
    for (int i = 0; i < n; ++i) {
      const double h = 1.0 / n, a = i * h, b = a + h;
      const auto v = [&](double z) { return 1 - std::cos(w * z); };
      const auto acc = [&](double z) { return w * std::sin(w * z); };
      const Segment f = degree == 1 ? line(h, cycloid(a), cycloid(b))
                        : degree == 3
                            ? cubic(h, cycloid(a), v(a), cycloid(b), v(b))
                            : quintic(h, cycloid(a), v(a), acc(a), cycloid(b), v(b), acc(b));
      for (int k = 0; k <= 64; ++k)
        worst = std::max(worst, std::abs(value(f, k / 64.0) - cycloid(a + h * k / 64)));
    }
    if (worst <= 1e-6) return n;
  }
}

TEST(Spline, CycloidNeeds887LinesOr29CubicsOr8Quintics) {
  EXPECT_EQ(intervals_needed(1), 887);
  EXPECT_EQ(intervals_needed(3), 29);
  EXPECT_EQ(intervals_needed(5), 8);
}

TEST(Spline, ChangesWithItsUnitsAndWithNothingElse) {
  Random random(11);
  for (const Maker& make : {Maker(cubic_spline), Maker(quintic_spline)}) {
    SplineSpec spec = table(random, 9, [&](double) { return random.uniform(-1, 1); });
    spec.start.geo_velocity = 0.5;
    const Cam cam = cam_of(make(spec), spec);
    for (const double m : {0x1p-60, 0x1p-20, 0x1p30}) {
      const double u = 0x1p17 / m;
      SplineSpec other = spec;
      for (SplinePoint& p : other.points) p = {p.master * m, p.slave * u, 0};
      other.start.geo_velocity = 0.5 * u / m;
      const Cam large = cam_of(make(other), other);
      for (std::size_t i = 0; i < cam.segments().size(); ++i)
        for (std::size_t k = 0; k < 6; ++k)
          EXPECT_EQ(large.segments()[i].c[k], cam.segments()[i].c[k] * u);
    }
  }
}

TEST(Spline, TenThousandPointsArePassedExactly) {
  Random random(3);
  SplineSpec spec = table(random, 10000, [&](double) { return random.uniform(-1, 1); });
  for (const SplineEnds ends :
       {SplineEnds::natural, SplineEnds::periodic, SplineEnds::not_a_knot}) {
    spec.ends = ends;
    const Cam cam = cam_of(quintic_spline(spec), spec);
    double off = 0;
    for (const SplinePoint& p : std::span(spec.points).first(spec.points.size() - 1))
      off = std::max(off, std::abs(cam.at(within(cam, p.master)).position - p.slave));
    EXPECT_LT(off, 1e-11) << static_cast<int>(ends);
  }
}

std::string complaint(const Maker& make, const SplineSpec& spec) {
  return test::error_of([&] { (void)make(spec); });
}

TEST(Spline, NamesTheRejectedValue) {
  EXPECT_EQ(complaint(cubic_spline, {.points = {{0, 0}}}), "points = 1: must be at least 2");
  EXPECT_EQ(complaint(cubic_spline, {.points = {{0, 0}, {1, 1}, {1, 2}}}),
            "points[3].master = 1: must be greater than 1, the previous point");
  EXPECT_EQ(complaint(quintic_spline, {.points = {{0, 0}, {1, NAN}}}),
            "points[2].slave = nan: must be a finite number");
  EXPECT_EQ(complaint(quintic_spline, {.points = {{0, 0}, {1, 1, 0.5}}}),
            "points[2].tolerance = 0.5: a spline through points has none: use a smoothing spline");
  EXPECT_EQ(
      complaint(cubic_spline, {.points = {{0, 0}, {1, 1}}, .start = {{}, 1}}),
      "start.geo_acceleration = 1: a cubic spline takes geo_velocity only: use a quintic spline");
  EXPECT_EQ(complaint(quintic_spline,
                      {.points = {{0, 0}, {1, 1}}, .ends = SplineEnds::periodic, .end = {1, {}}}),
            "end.geo_velocity = 1: only natural ends take a derivative: leave it out");
}

}  // namespace
}  // namespace jounce::spline_test
