// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/shape.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/shape_problems.hpp"
#include "support/random.hpp"

namespace jounce::shape_test {
namespace {

using test::Random;
using test_optimize::rest_to_rest_shape;
using test_optimize::within;
using Status = OptimizeStatus;

/// The k-th derivative on a dense grid, both sides of every break, with nothing of the optimizer's.
template <class Visit>
void sampled(const ShapeOutcome& best, double begin, const LinearQuantity& q, const Visit& visit) {
  double x = begin;
  for (Segment f : best.best) {
    for (int i = 0; i <= 50; ++i) {
      const double s = i / 50.0;
      double sum = q.constant;
      Segment g = f;
      for (const double by : q.by) {
        sum += by * value(g, s);
        g = derivative(g);
      }
      visit(x + s * f.length, sum);
    }
    x += f.length;
  }
}

LinearQuantity torque(Random& random) {
  return {.name = "torque",
          .by = {random.uniform(0, 2), random.uniform(0, 0.5), random.uniform(0.01, 0.1)},
          .constant = random.uniform(-0.5, 0.5)};
}

ShapeProblem random_problem(Random& random) {
  ShapeProblem p;
  p.begin = random.uniform(-10, 10);
  p.end = p.begin + random.log_uniform(0.1, 100);
  const double length = p.end - p.begin;
  p.degree = 3 + random.below(4);
  p.pieces = 8 + static_cast<std::size_t>(random.below(24));
  p.from = {.value = 0.0, .velocity = random.uniform(-1, 1) / length, .acceleration = 0.0};
  p.to = {.value = 1.0,
          .velocity = 0.0,
          .acceleration = random.below(2) ? std::optional(0.0) : std::nullopt};
  const int order = 2 + random.below(2);
  p.minimize = {{PeakOf{derivative_of_shape(order)}}};
  if (random.below(2) == 0) p.minimize.push_back({RmsOf{derivative_of_shape(2)}, 0.5});
  if (random.below(3) == 0) p.minimize = {{PeakOf{torque(random)}}};
  p.corridors = {within(derivative_of_shape(1), random.uniform(1.3, 3) / length, p)};
  if (random.below(2) == 0) {  // a hump to keep below
    const double from = p.begin + 0.3 * length;
    p.corridors.push_back({derivative_of_shape(0), from, from + 0.3 * length, {}, Edge{0.3, 0.7}});
  }
  return p;
}

TEST(Shape, KeepsItsLimitsEverywhere) {
  int usable = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const ShapeProblem p = random_problem(random);
    const ShapeOutcome best = optimize_shape(p);
    EXPECT_NE(best.status, Status::stalled) << best.reason;
    EXPECT_EQ(best.usable(), best.status != Status::infeasible) << best.reason;
    if (!best.usable()) continue;
    ++usable;
    for (const Corridor& c : p.corridors)
      sampled(best, p.begin, c.quantity, [&](double x, double q) {
        if (x < c.from || x > c.to) return;
        const double share = (x - c.from) / (c.to - c.from);
        const double scale = 1e-9 * (std::abs(c.upper->at_from) + std::abs(c.upper->at_to));
        EXPECT_LE(q, c.upper->at_from + share * (c.upper->at_to - c.upper->at_from) + scale) << x;
        if (c.lower) {
          EXPECT_GE(q, c.lower->at_from - scale) << x;
        }
      });
    if (const auto* peak = std::get_if<PeakOf>(&p.minimize[0].figure)) {
      double largest = 0;
      sampled(best, p.begin, peak->quantity,
              [&](double, double q) { largest = std::max(largest, std::abs(q)); });
      EXPECT_LE(largest, best.figures[0].reached * (1 + 1e-9));
      EXPECT_GE(largest, best.figures[0].reached * 0.98);
    }
    EXPECT_TRUE(check_continuity(Trajectory(best.best, p.begin), 2, 1e-7).ok());
  }
  EXPECT_GT(usable, 12);
}

TEST(Shape, IsCertifiedToBeTheBestSpline) {
  for (std::uint64_t seed = 100; seed < 115; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const ShapeProblem p = random_problem(random);
    const ShapeOutcome best = optimize_shape(p);
    if (!best.usable()) continue;
    EXPECT_EQ(best.status, Status::optimal) << best.reason;
    ASSERT_TRUE(best.bound);
    EXPECT_LE(*best.bound, best.value * (1 + 1e-9));
    EXPECT_GE(*best.bound, best.value * (1 - 1e-6));
  }
}

/// For every change by the seed within the ends, the weighted sum of a shape that keeps the limits
/// does not fall below the bound.
TEST(Shape, NoPerturbationIsBetter) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = 20;
  p.minimize = {{PeakOf{derivative_of_shape(3)}}, {RmsOf{derivative_of_shape(2)}, 2}};
  const ShapeOutcome best = optimize_shape(p);
  ASSERT_EQ(best.status, Status::optimal) << best.reason;
  int tried = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    // A bump that keeps position, velocity and acceleration at both ends: (x (1 - x))^3 times a line,
    // or a narrow one.
    const double size = random.log_uniform(1e-7, 1e-1) * (random.below(2) ? 1 : -1);
    const double center = random.uniform(0, 1);
    std::vector<Segment> other;
    double x = 0;
    for (const Segment& f : best.best) {
      Segment bump;
      bump.length = f.length;
      bump.degree = 7;
      // The curve has degree 7: exact from its values.
      const auto at = [&](double s) {
        const double u = x + s * f.length;
        return size * std::pow(u * (1 - u), 3) * (u - center);
      };
      std::array<double, 8> d{};
      for (int i = 0; i < 8; ++i) d[static_cast<std::size_t>(i)] = at(i / 7.0);
      // Newton's divided differences, then expanded.
      for (std::size_t k = 1; k < 8; ++k)
        for (std::size_t i = 7; i >= k; --i)
          d[i] = (d[i] - d[i - 1]) * 7.0 / static_cast<double>(k);
      for (std::size_t k = 8; k-- > 0;) {
        for (std::size_t i = 7; i > 0; --i)
          bump.c[i] = bump.c[i - 1] - bump.c[i] * static_cast<double>(k) / 7.0;
        bump.c[0] = d[k] - bump.c[0] * static_cast<double>(k) / 7.0;
      }
      other.push_back(sum(f, bump).value());
      x += f.length;
    }
    const double peak = std::abs(extrema(Trajectory(other), 3).peak().value);
    double square = 0;
    for (const Segment& f : other) {
      const Segment g = derivative(derivative(f));
      for (std::size_t i = 0; i <= 10; ++i)
        for (std::size_t j = 0; j <= 10; ++j)
          square += f.length * g.c[i] * g.c[j] / static_cast<double>(i + j + 1);
    }
    const double value =
        peak / best.figures[0].given + 2 * std::sqrt(square) / best.figures[1].given;
    EXPECT_GE(value, best.value * (1 - 1e-6)) << size;
    ++tried;
  }
  EXPECT_EQ(tried, 200);
}

/// A second way to the same optimum: the peak under a ceiling of the rms (a multiplier found by secants,
/// no fixed point), and the best of those by golden section.
TEST(Shape, AWeightedRmsIsANormAndNotItsSquare) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = 16;
  p.options.tolerance = 1e-8;
  p.minimize = {{PeakOf{derivative_of_shape(3)}}, {RmsOf{derivative_of_shape(2)}, 2}};
  const ShapeOutcome best = optimize_shape(p);
  const auto sum_with = [&](double ceiling) {
    ShapeProblem q = p;
    q.minimize.pop_back();
    q.ceilings = {{RmsOf{derivative_of_shape(2)}, ceiling}};
    const ShapeOutcome other = optimize_shape(q);
    EXPECT_TRUE(other.usable()) << other.reason;
    return other.value + 2 * ceiling / best.figures[1].given;
  };
  double low = best.figures[1].reached * 0.97;
  double high = best.figures[1].reached * 1.02;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double least = std::min(sum_with(low), sum_with(high));
  EXPECT_GT(least, best.value * (1 + 1e-5)) << "the ends of the search are worse";
  for (int i = 0; i < 12; ++i) {
    const double a = high - golden * (high - low);
    const double b = low + golden * (high - low);
    const double at_a = sum_with(a), at_b = sum_with(b);
    least = std::min({least, at_a, at_b});
    (at_a < at_b ? high : low) = at_a < at_b ? b : a;
  }
  EXPECT_NEAR(least, best.value, 1e-6 * best.value);
}

TEST(Shape, ScalesWithItsUnitsAndWithNothingElse) {
  for (const double x : {1e-6, 1.0, 1e6})
    for (const double u : {1e-6, 1e6}) {
      SCOPED_TRACE(x);
      SCOPED_TRACE(u);
      const auto problem = [](double lx, double lu) {
        ShapeProblem p;
        p.begin = 3 * lx;
        p.end = 5 * lx;
        p.pieces = 30;
        p.from = {.value = 7 * lu, .velocity = 0.2 * lu / lx, .acceleration = 0.0};
        p.to = {.value = 9 * lu, .velocity = 0.0, .acceleration = 0.0};
        p.minimize = {{PeakOf{derivative_of_shape(3)}}, {RmsOf{derivative_of_shape(2)}}};
        p.corridors = {within(derivative_of_shape(1), 1.5 * lu / lx, p)};
        return p;
      };
      const ShapeOutcome one = optimize_shape(problem(1, 1));
      const ShapeOutcome other = optimize_shape(problem(x, u));
      EXPECT_EQ(other.status, one.status) << other.reason;
      EXPECT_NEAR(other.value, one.value, 1e-6 * one.value);
      ASSERT_EQ(other.best.size(), one.best.size());
      for (std::size_t i = 0; i < one.best.size(); ++i)
        EXPECT_NEAR(value(other.best[i], 0.5) / u, value(one.best[i], 0.5), 1e-4) << i;
    }
}

TEST(Shape, AStretchInStepIsKeptToTheBit) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = 50;
  p.minimize = {{PeakOf{derivative_of_shape(3)}}};
  p.corridors = {{derivative_of_shape(0), 0.41, 0.62, Edge{0.3, 0.72}, Edge{0.3, 0.72}}};
  const ShapeOutcome best = optimize_shape(p);
  ASSERT_EQ(best.status, Status::optimal) << best.reason;
  const Trajectory shape(best.best);
  for (const double x : {0.41, 0.5, 0.6199}) {
    EXPECT_NEAR(shape.at(x).position, 0.3 + (x - 0.41) * 2, 1e-15);
    EXPECT_EQ(shape.at(x).acceleration, 0) << "a line has none";
  }
  EXPECT_TRUE(check_continuity(shape, 2, 1e-9).ok());
}

TEST(Shape, RestStaysRest) {
  ShapeProblem p = rest_to_rest_shape(4);
  p.pieces = 50;
  p.minimize = {{PeakOf{derivative_of_shape(2)}}};
  const ShapeOutcome best = optimize_shape(p);
  const Trajectory shape(best.best);
  EXPECT_EQ(shape.at(0).position, 0);
  EXPECT_EQ(shape.at(0).velocity, 0);
  EXPECT_EQ(shape.at(0).acceleration, 0);
  EXPECT_NEAR(shape.at(1, Side::left).position, 1, 1e-14);
  EXPECT_NEAR(shape.at(1, Side::left).velocity, 0, 1e-11);
  EXPECT_NEAR(shape.at(1, Side::left).acceleration, 0, 1e-9);
}

TEST(Shape, APeriodicShapeMeetsItself) {
  ShapeProblem p;
  p.end = 360;
  p.pieces = 72;
  p.periodic = true;
  p.from.value = p.to.value = 0.0;
  p.minimize = {{PeakOf{derivative_of_shape(2)}}};
  p.corridors = {{derivative_of_shape(0), 160, 200, Edge{10, 10}, {}}};
  const ShapeOutcome best = optimize_shape(p);
  ASSERT_EQ(best.status, Status::optimal) << best.reason;
  const Cam cam(best.best, 0, Extrapolation::wrap);
  EXPECT_TRUE(check_continuity(cam, 2, 1e-7).ok());
  EXPECT_GE(segment_extrema(cam, 36)[0].min.value, 10);
}

TEST(Shape, ReportsItsBindingLimitsAndMargins) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = 60;
  p.minimize = {{PeakOf{derivative_of_shape(2)}}};
  p.corridors = {within(derivative_of_shape(3), 60, p), within(derivative_of_shape(1), 5, p)};
  const ShapeOutcome best = optimize_shape(p);
  ASSERT_EQ(best.status, Status::optimal) << best.reason;
  bool jerk = false, objective = false;
  for (const Finding& f : best.active) {
    jerk = jerk || (f.rule == "limit/geo_jerk" && f.value > 0 && f.where < 0.05);
    objective = objective || f.rule == "objective/peak geo_acceleration";
    EXPECT_NE(f.rule, "limit/geo_velocity");
  }
  EXPECT_TRUE(jerk);
  EXPECT_TRUE(objective);
  ASSERT_EQ(best.limits.findings.size(), 2U);
  EXPECT_EQ(best.limits.findings[1].rule, "limit/geo_velocity");
  EXPECT_NEAR(best.limits.findings[1].margin, 1 - 2.0 / 5, 0.02) << "velocity peaks near 2";
}

TEST(Shape, WhatCannotBeIsInfeasibleAndNamesIt) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = 40;
  p.minimize = {{PeakOf{derivative_of_shape(2)}}};
  p.corridors = {within(derivative_of_shape(3), 31, p)};
  const ShapeOutcome jerk = optimize_shape(p);
  EXPECT_EQ(jerk.status, Status::infeasible);
  EXPECT_FALSE(jerk.usable());
  EXPECT_NE(jerk.reason.find("limit/geo_jerk"), std::string::npos) << jerk.reason;

  p.corridors = {within(derivative_of_shape(1), 0.9, p)};
  EXPECT_EQ(optimize_shape(p).status, Status::infeasible) << "a mean of 1 is needed";

  p.corridors = {{derivative_of_shape(0), 0.2, 0.4, Edge{0.9, 0.9}, {}},
                 within(derivative_of_shape(2), 10, p)};
  EXPECT_EQ(optimize_shape(p).status, Status::infeasible);

  p.corridors = {{derivative_of_shape(0), 0.5, 0.5, Edge{0.2, 0}, Edge{0.2, 0}},
                 {derivative_of_shape(0), 0.5, 0.5, Edge{0.3, 0}, Edge{0.3, 0}}};
  EXPECT_EQ(optimize_shape(p).status, Status::infeasible) << "two values at one place";

  p.corridors.clear();
  p.ceilings = {{RmsOf{derivative_of_shape(2)}, 3.4}};  // sqrt(12) = 3.464 is the least
  EXPECT_EQ(optimize_shape(p).status, Status::infeasible);
  p.ceilings = {{PeakOf{derivative_of_shape(3)}, 31.9}};
  EXPECT_EQ(optimize_shape(p).status, Status::infeasible);
}

// A limit in a wrong unit was "stalled", and the shape that exceeds it least was the given one.
TEST(Shape, FarBeyondALimitTheLeastExcessIsFound) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = 40;
  p.refine = false;
  p.minimize = {{PeakOf{derivative_of_shape(3)}}};
  const double least = optimize_shape(p).figures.at(0).reached;  // 32 for any function
  EXPECT_NEAR(least, 32, 0.1);
  p.minimize = {{RmsOf{derivative_of_shape(2)}}};
  for (const double most : {1.0, 1e-3, 1e-6}) {
    p.ceilings = {{PeakOf{derivative_of_shape(3)}, most}};
    const ShapeOutcome best = optimize_shape(p);
    EXPECT_EQ(best.status, Status::infeasible) << most << ": " << best.reason;
    EXPECT_NEAR(std::abs(best.limits.findings.at(0).value), least, 1e-6 * least) << most;
  }
}

TEST(Shape, PassesAPointWithinATolerance) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = 40;
  p.minimize = {{RmsOf{derivative_of_shape(3)}}};
  p.corridors = {{derivative_of_shape(0), 0.3, 0.3, Edge{0.39, 0}, Edge{0.41, 0}}};
  const ShapeOutcome best = optimize_shape(p);
  ASSERT_EQ(best.status, Status::optimal) << best.reason;
  EXPECT_NEAR(Trajectory(best.best).at(0.3).position, 0.39, 1e-8) << "the near side";
}

TEST(Shape, AResponseIsThePeakAtItsPlaces) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = 30;
  p.minimize = {{ResponseOf{"torque", [](const Trajectory& shape) {
                              std::vector<double> y;
                              for (int i = 0; i <= 300; ++i) {
                                const auto now = shape.at(i / 300.0);
                                y.push_back(0.1 * now.acceleration + now.velocity + 0.5);
                              }
                              return y;
                            }}}};
  const ShapeOutcome best = optimize_shape(p);
  ASSERT_TRUE(best.usable()) << best.reason;
  ASSERT_TRUE(best.bound);
  EXPECT_GE(*best.bound, best.value * 0.999);
  ShapeProblem exact = p;
  exact.minimize = {{PeakOf{{"torque", {0, 1, 0.1}, 0.5}}}};
  const ShapeOutcome peak = optimize_shape(exact);
  ASSERT_EQ(peak.status, Status::optimal) << peak.reason;
  EXPECT_NEAR(best.figures[0].reached, peak.figures[0].reached, 1e-3 * peak.figures[0].reached);
  EXPECT_LE(best.figures[0].reached, peak.figures[0].reached * (1 + 1e-6)) << "fewer places";
}

TEST(Shape, StopsOnRequestAndAtItsTimeLimit) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.minimize = {{PeakOf{derivative_of_shape(2)}}};
  const ShapeOutcome cancelled =
      optimize_shape(p, [](const OptimizeProgress& progress) { return progress.round < 1; });
  EXPECT_EQ(cancelled.status, Status::cancelled);
  EXPECT_TRUE(cancelled.usable()) << "the best so far";
  EXPECT_EQ(cancelled.rounds, 1);
  p.options.budget.seconds = 1e-9;
  EXPECT_EQ(optimize_shape(p).status, Status::stalled);
}

TEST(Shape, TheSameProblemGivesTheSameShape) {
  Random random(5);
  const ShapeProblem p = random_problem(random);
  const ShapeOutcome a = optimize_shape(p);
  const ShapeOutcome b = optimize_shape(p);
  EXPECT_EQ(a.value, b.value);
  for (std::size_t i = 0; i < a.best.size(); ++i) EXPECT_EQ(a.best[i].c, b.best[i].c);
}

TEST(Shape, RejectsWhatItCannotMean) {
  const auto rule = [](auto change) {
    ShapeProblem p = rest_to_rest_shape(3);
    p.minimize = {{PeakOf{derivative_of_shape(2)}}};
    change(p);
    try {
      require_valid(p);
    } catch (const InputError& e) {
      return e.key();
    }
    return std::string();
  };
  EXPECT_EQ(rule([](ShapeProblem&) {}), "");
  EXPECT_EQ(rule([](ShapeProblem& p) { p.end = 0; }), "end");
  EXPECT_EQ(rule([](ShapeProblem& p) { p.begin = NAN; }), "begin");
  EXPECT_EQ(rule([](ShapeProblem& p) { p.degree = 8; }), "degree");
  EXPECT_EQ(rule([](ShapeProblem& p) { p.pieces = 0; }), "pieces");
  EXPECT_EQ(rule([](ShapeProblem& p) { p.minimize.clear(); }), "minimize");
  EXPECT_EQ(rule([](ShapeProblem& p) { p.minimize[0].weight = 0; }), "minimize[1].weight");
  EXPECT_EQ(rule([](ShapeProblem& p) { p.degree = 2, p.from.acceleration = 1; }),
            "from.geo_acceleration");
  EXPECT_EQ(rule([](ShapeProblem& p) {
              p.minimize = {{PeakOf{{"nothing", {}}}}};
            }),
            "minimize[1].figure.by");
  EXPECT_EQ(rule([](ShapeProblem& p) {
              p.corridors = {{derivative_of_shape(1), 0.5, 0.2, {}, {}}};
            }),
            "corridors[1].to");
  EXPECT_EQ(rule([](ShapeProblem& p) {
              p.corridors = {{derivative_of_shape(1), 0, 1, Edge{2, 2}, Edge{1, 1}}};
            }),
            "corridors[1].lower.at_from");
  EXPECT_EQ(rule([](ShapeProblem& p) { p.given = {line(0.5, 0, 1)}; }), "given");
}

}  // namespace
}  // namespace jounce::shape_test
