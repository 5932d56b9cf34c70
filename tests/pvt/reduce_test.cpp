// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/pvt/check.hpp"
#include "jounce/pvt/pt.hpp"

#include "cam/design/random_cams.hpp"
#include "pvt/src/sample/interval.hpp"
#include "pvt/src/sample/longest.hpp"
#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::reduce_test {
namespace {

using test::Random;

constexpr Interpolation all_rules[] = {Interpolation::linear, Interpolation::cubic_hermite,
                                       Interpolation::quintic_hermite};

Cam cycloid() {
  return Cam(normalized(Law::inclined_sine));
}

double stroke_of(const Cam& f) {
  const Range travel = extrema(f, 0);
  return travel.max.value - travel.min.value;
}

/// True if a straight segment of the curve ends or begins at x.
bool ends_a_line(const Cam& f, double x) {
  for (std::size_t i = 0; i < f.segments().size(); ++i)
    if (f.segments()[i].sines == 0 && f.segments()[i].degree <= 1 &&
        (f.breaks()[i] == x || f.breaks()[i + 1] == x))
      return true;
  return false;
}

/// The interval of the table that begins at x; its number of knots where none does.
std::size_t interval_from(const Table& table, double x) {
  const auto& all = table.columns().x;
  const auto at = std::find(all.begin(), all.end(), x);
  return static_cast<std::size_t>(at - all.begin());
}

/// One interval of the table, which stands still at p.
void expect_dwell(const Table& table, double from, double to, double p, const std::string& which) {
  const Columns& c = table.columns();
  const std::size_t i = interval_from(table, from);
  ASSERT_LT(i + 1, c.x.size()) << which;
  EXPECT_EQ(c.x[i + 1], to) << which;
  for (const double s : {0.0, 0.3, 0.5, 0.9}) {
    const Jet jet = table.jet(from + s * (to - from));
    EXPECT_EQ(jet[0], p) << which;
    EXPECT_EQ(jet[1], 0) << which;
    EXPECT_EQ(jet[2], 0) << which;
  }
}

/// Up within 12000, a dwell until 20000, down until 30000.
Cam up_and_down(double dwell = 12000, double end_of_dwell = 20000) {
  return Cam({quintic(dwell, 0, 0, 0, 50000, 0, 0), line(end_of_dwell - dwell, 50000, 50000),
              quintic(30000 - end_of_dwell, 50000, 0, 0, 0, 0, 0)},
             0, Extrapolation::wrap);
}

/// Reference magnitude for the rounding of its numbers.
double magnitude_of(const Cam& f) {
  double all = 0;
  for (const Segment& segment : f.segments()) all = std::max(all, magnitude(segment));
  return all;
}

/// max |table - curve| over many points: at most the certified one, and not far below it.
template <class Over>
SampleError seen(const Table& table, const Curve<Over>& f, int points = 20000) {
  SampleError worst;
  for (int i = 0; i < points; ++i) {
    const double x = table.start() + (table.end() - table.start()) * (i + 0.5) / points;
    const Jet is = table.jet(x);
    const Jet wanted = f.jet(x);
    worst.position = std::max(worst.position, std::abs(is[0] - wanted[0]));
    worst.velocity = std::max(worst.velocity, std::abs(is[1] - wanted[1]));
  }
  return worst;
}

/// Number of intervals that a cycloid of stroke 1 needs when every one of them has the greatest
/// error. An interval of length h has an error of at most h^k |f^(k)| / C, so their number is the
/// integral of (|f^(k)| / (C tolerance))^(1/k), with |f^(k)| = (2 pi)^(k-1) |sin 2 pi z| (k even),
/// whose root integrates to a beta function.
double intervals_of_cycloid(double k, double c, double tolerance) {
  const double two_pi = 2 * std::acos(-1.0);
  const double m = 1 / k;
  const double mean = std::tgamma((m + 1) / 2) / (std::sqrt(two_pi / 2) * std::tgamma(m / 2 + 1));
  return std::pow(std::pow(two_pi, k - 1) / (c * tolerance), m) * mean;
}

TEST(Reduced, NeedsAsFewFreeKnotsOnTheCycloidAsTheyCanBe) {
  // Equal intervals to 1e-6 of the stroke: 887, 29, 8 (see sample_test.cpp).
  const double divisor[] = {8, 384, 46080};
  const std::size_t known[] = {677, 25, 7};
  for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-8})
    for (std::size_t i = 0; i < 3; ++i) {
      const Sampled made = reduced(cycloid(), {.rule = all_rules[i], .tolerance = tolerance});
      const double fewest =
          intervals_of_cycloid(2.0 * static_cast<double>(i) + 2, divisor[i], tolerance);
      EXPECT_LE(made.error.position, tolerance);
      if (tolerance <= 1e-6) {  // the range in which the formula, for short intervals, holds
        EXPECT_NEAR(static_cast<double>(made.table.size() - 1), fewest, 1.1 + 1e-4 * fewest)
            << name(all_rules[i]) << " " << tolerance << " " << fewest;
      }
      if (tolerance == 1e-6) {
        EXPECT_EQ(made.table.size() - 1, known[i]);
      }
      EXPECT_EQ(made.binding, Binding::tolerance);
    }
}

TEST(Reduced, SharesOneErrorAmongItsIntervals) {
  const Sampled made =
      reduced(cycloid(), {.rule = Interpolation::cubic_hermite, .tolerance = 1e-6});
  const auto& x = made.table.columns().x;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double e = pvt_detail::share(cycloid(), Interpolation::cubic_hermite,
                                       pvt_detail::knot_at(cycloid(), x[i], Side::right),
                                       pvt_detail::knot_at(cycloid(), x[i + 1], Side::left),
                                       {made.error.position * (1 + 1e-9), 1e300});
    EXPECT_GT(e, 0.75) << i;
    EXPECT_NEAR(x[i] + x[x.size() - 1 - i], 1, 0.01) << "a symmetric curve: nearly symmetric knots";
  }
}

TEST(Reduced, HasNoKnotThatCanBeLeftOut) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Cam cam = test::random_cam(random, false);
    if (stroke_of(cam) == 0) continue;  // a dwell alone
    const double tolerance = stroke_of(cam) * random.log_uniform(1e-6, 1e-2);
    for (const Interpolation rule : all_rules) {
      const Columns all = reduced(cam, {.rule = rule, .tolerance = tolerance}).table.columns();
      const std::size_t step = 1 + all.x.size() / 50;
      for (std::size_t i = 1; i + 1 < all.x.size(); i += step) {
        if (ends_a_line(cam, all.x[i])) continue;  // a knot that must be
        Columns less = all;
        for (auto* column : {&less.x, &less.p, &less.v, &less.a})
          if (!column->empty()) column->erase(column->begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_GT(certified(cam, rule, less).error.position, tolerance * (1 - 1e-9))
            << name(rule) << " seed " << seed << " knot " << i;
      }
    }
  }
}

TEST(Reduced, KeepsItsToleranceOnRandomCams) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const Cam cam = test::random_cam(random, random.below(2) == 0);
    const double tolerance = stroke_of(cam) * random.log_uniform(1e-7, 1e-2);
    for (const Interpolation rule : all_rules) {
      const std::string which = std::string(name(rule)) + " seed " + std::to_string(seed);
      const Sampled made = reduced(cam, {.rule = rule, .tolerance = tolerance});
      EXPECT_LE(made.error.position, tolerance * (1 + 1e-9)) << which;
      const SampleError points = seen(made.table, cam);
      EXPECT_LE(points.position, made.error.position * (1 + 1e-9) + 1e-15 * magnitude_of(cam))
          << which;
      const std::size_t equal = sample_within(cam, rule, tolerance).table.size();
      EXPECT_LE(made.table.size(), equal) << which;
    }
  }
}

TEST(Reduced, KeepsTheVelocityToo) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const Cam cam = test::random_cam(random, true);
    const double v = extrema(cam, 1).peak().value;
    const double jump = std::abs(largest_jump(cam, 1).step);
    const double allowed = jump + std::abs(v) * random.log_uniform(1e-3, 1e-1);
    for (const Interpolation rule : all_rules) {
      const Sampled made = reduced(cam, {.rule = rule, .velocity_tolerance = allowed});
      EXPECT_LE(made.error.velocity, allowed * (1 + 1e-9)) << name(rule) << " seed " << seed;
      // The two evaluations round to some units in the last place of the peak velocity.
      EXPECT_GE(made.error.velocity * (1 + 1e-9) + 1e-14 * std::abs(v),
                seen(made.table, cam, 5000).velocity * (1 - 1e-9))
          << name(rule) << " seed " << seed;
      if (made.table.size() > 2) {
        EXPECT_EQ(made.binding, Binding::velocity_tolerance);
      }
    }
  }
}

TEST(Reduced, MakesTheBestOfSoManyKnots) {
  for (const Interpolation rule : all_rules) {
    double before = 1;
    for (const std::size_t most : {5u, 9u, 17u, 33u}) {
      const Sampled made = reduced(cycloid(), {.rule = rule, .most = most});
      EXPECT_LE(made.table.size(), most);
      EXPECT_EQ(made.binding, Binding::most);
      EXPECT_LT(made.error.position, before);
      EXPECT_LE(made.error.position, 1.01 * sample(cycloid(), rule, most - 1).error.position);
      before = made.error.position;
      // A tolerance a hundredth lower takes more.
      const Sampled again = reduced(cycloid(), {.rule = rule, .tolerance = before * 0.97});
      EXPECT_GT(again.table.size(), most) << name(rule);
    }
  }
}

// ---- an oracle that shares no code with the search: all subsets of few places

/// A cubic by its values and slopes at the ends of [0, h], in powers of u.
struct Powers {
  double c[4] = {};
  [[nodiscard]] double at(double u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }
};

Powers hermite(double h, double p, double v, double q, double w) {
  return {{p, v, (3 * (q - p) / h - 2 * v - w) / h, (v + w - 2 * (q - p) / h) / (h * h)}};
}

/// Greatest |f(u)| on [from, to]: at the ends or where the derivative is 0.
double greatest(const Powers& f, double from, double to) {
  double most = std::max(std::abs(f.at(from)), std::abs(f.at(to)));
  const double a = 3 * f.c[3];
  const double b = 2 * f.c[2];
  const double root = std::sqrt(std::max(0.0, b * b - 4 * a * f.c[1]));
  for (const double u : {(-b + root) / (2 * a), (-b - root) / (2 * a), -f.c[1] / b})
    if (u > from && u < to) most = std::max(most, std::abs(f.at(u)));
  return most;
}

/// The same cubic counted from u0 on.
Powers from(const Powers& f, double u0) {
  return {
      {f.at(u0), f.c[1] + u0 * (2 * f.c[2] + u0 * 3 * f.c[3]), f.c[2] + 3 * f.c[3] * u0, f.c[3]}};
}

/// A PVT table, and what straight lines or cubics between places of it err.
struct Pvt {
  std::vector<double> x, p, v;

  [[nodiscard]] Powers piece(std::size_t i) const {
    return hermite(x[i + 1] - x[i], p[i], v[i], p[i + 1], v[i + 1]);
  }
  [[nodiscard]] Jet jet(double t) const {
    std::size_t i = 0;
    while (i + 2 < x.size() && t >= x[i + 1]) ++i;
    const Powers f = from(piece(i), t - x[i]);
    return {f.c[0], f.c[1], 0, 0};
  }
  [[nodiscard]] double error(Interpolation rule, double a, double b) const {
    const Jet at_a = jet(a);
    const Jet at_b = jet(b);
    const double slope = (at_b[0] - at_a[0]) / (b - a);
    const Powers chord = rule == Interpolation::linear
                             ? Powers{{at_a[0], slope, 0, 0}}
                             : hermite(b - a, at_a[0], at_a[1], at_b[0], at_b[1]);
    double most = 0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const double begin = std::max(a, x[i]);
      const double end = std::min(b, x[i + 1]);
      if (!(begin < end)) continue;
      Powers f = from(piece(i), begin - x[i]);
      const Powers g = from(chord, begin - a);
      for (int k = 0; k < 4; ++k) f.c[k] -= g.c[k];
      most = std::max(most, greatest(f, 0, end - begin));
    }
    return most;
  }
};

/// The least error of each number of knots, over all subsets of the places.
std::vector<double> best_of_subsets(const Pvt& pvt, Interpolation rule,
                                    const std::vector<double>& places) {
  const std::size_t n = places.size();
  std::vector<std::vector<double>> e(n, std::vector<double>(n, 0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) e[i][j] = pvt.error(rule, places[i], places[j]);
  std::vector<double> best(n + 1, 1e300);
  for (std::size_t chosen = 0; chosen < std::size_t{1} << (n - 2); ++chosen) {
    std::size_t count = 2;
    std::size_t before = 0;
    double error = 0;
    for (std::size_t i = 1; i < n; ++i) {
      if (i + 1 < n && (chosen >> (i - 1) & 1U) == 0) continue;
      count += i + 1 < n ? 1 : 0;
      error = std::max(error, e[before][i]);
      before = i;
    }
    best[count] = std::min(best[count], error);
  }
  for (std::size_t k = 3; k <= n; ++k) best[k] = std::min(best[k], best[k - 1]);
  return best;
}

Pvt random_pvt(Random& random, std::size_t knots) {
  Pvt pvt;
  double x = 0;
  for (std::size_t i = 0; i < knots; ++i, x += random.uniform(0.3, 1.7)) {
    pvt.x.push_back(x);
    pvt.p.push_back(random.uniform(-10, 10));
    pvt.v.push_back(random.uniform(-20, 20));
  }
  return pvt;
}

Trajectory curve_of(const Pvt& pvt) {
  return Table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
               {pvt.x, pvt.p, pvt.v, {}})
      .curve<OverTime>();
}

TEST(Reduced, IsAsGoodAsTheBestSubsetOfTheKnotsOfASmallTable) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Pvt pvt = random_pvt(random, 13);
    for (const Interpolation rule : {Interpolation::linear, Interpolation::cubic_hermite}) {
      const std::vector<double> best = best_of_subsets(pvt, rule, pvt.x);
      for (const std::size_t most : {4u, 7u, 10u, 12u}) {
        const std::string which =
            name(rule) + (" seed " + std::to_string(seed)) + " most " + std::to_string(most);
        const Sampled made = reduced(curve_of(pvt), {.rule = rule, .most = most});
        EXPECT_LE(made.table.size(), most) << which;
        EXPECT_LE(made.error.position, best[most] * 1.011) << which;
        const double tolerance = best[most] * (1 + 1e-9);
        const Sampled fewest = reduced(curve_of(pvt), {.rule = rule, .tolerance = tolerance});
        EXPECT_LE(fewest.table.size(), most) << which;
        EXPECT_LE(fewest.error.position, tolerance * (1 + 1e-9)) << which;
      }
    }
  }
}

TEST(Reduced, IsTheBestOfAllTablesOnFewWholeSteps) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Pvt pvt = random_pvt(random, 8);
    const double scale = 12 / pvt.x.back();
    for (double& x : pvt.x) x *= scale;
    pvt.x.back() = 12;
    std::vector<double> places;
    for (int i = 0; i <= 12; ++i) places.push_back(i);
    for (const Interpolation rule : {Interpolation::linear, Interpolation::cubic_hermite}) {
      const std::vector<double> best = best_of_subsets(pvt, rule, places);
      for (const std::size_t most : {3u, 5u, 8u, 11u}) {
        const std::string which =
            name(rule) + (" seed " + std::to_string(seed)) + " most " + std::to_string(most);
        const Sampled made = reduced(curve_of(pvt), {.rule = rule, .most = most, .x_step = 1});
        EXPECT_LE(made.error.position, best[most] * 1.011) << which;
        EXPECT_GE(made.error.position, best[most] * (1 - 1e-9)) << which;
      }
    }
  }
}

TEST(Reduced, HoldsWhatTheRuleHoldsExactlyInItsKnots) {
  const Trajectory move =
      s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  const Sampled made = reduced(move, {.rule = Interpolation::cubic_hermite, .tolerance = 1e-12});
  EXPECT_EQ(made.table.size(), move.breaks().size());
  EXPECT_LT(made.error.position, 1e-13);
}

TEST(Reduced, MergesTheKnotsOfATable) {
  const Table fine = sample(cycloid(), Interpolation::cubic_hermite, std::size_t{100'000}).table;
  const Cam exact = fine.curve<OverMaster>();
  EXPECT_EQ(reduced(exact, {.rule = Interpolation::cubic_hermite, .tolerance = 1e-6}).table.size(),
            26u);
  EXPECT_EQ(reduced(exact, {.rule = Interpolation::linear, .tolerance = 1e-6}).table.size(), 678u);
  EXPECT_EQ(
      reduced(exact, {.rule = Interpolation::quintic_hermite, .tolerance = 1e-6}).table.size(), 8u);
}

TEST(Reduced, KeepsStraightLinesOfATableAsTheyAre) {
  const Cam zigzag(
      {line(1, 0, 1), line(1, 1, 2), line(1, 2, 0), line(0.5, 0, -1), line(0.5, -1, -2)});
  const Sampled made = reduced(zigzag, {.rule = Interpolation::linear, .tolerance = 1e-9});
  EXPECT_EQ(made.table.columns().x, (std::vector<double>{0, 2, 4}));
  EXPECT_EQ(made.table.columns().p, (std::vector<double>{0, 2, -2}));
}

TEST(Reduced, PutsKnotsOnWholeStepsAndClosesThePeriod) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const Extrapolation outside =
        random.below(2) == 0 ? Extrapolation::advance : Extrapolation::wrap;
    const double period = 1000 + random.below(5000);
    const double travel = outside == Extrapolation::wrap ? 0 : 500 + random.below(4000);
    const double middle = random.uniform(-3000, 3000);
    std::vector<Segment> segments;
    const double first = std::floor(period * random.uniform(0.2, 0.8)) + 0.25;  // off the steps
    for (Segment f : test::random_rise(random, false, first, 0.3, middle)) segments.push_back(f);
    for (Segment f : test::random_rise(random, false, period - first, middle, 0.3 + travel))
      segments.push_back(f);
    const Cam cam(segments, 0, outside);
    for (const Interpolation rule : all_rules) {
      const std::string which = std::string(name(rule)) + " seed " + std::to_string(seed);
      const Sampled made =
          reduced(cam, {.rule = rule, .tolerance = 20, .spacing = 3, .x_step = 1, .p_step = 1});
      const Columns& c = made.table.columns();
      double sum = 0;
      for (std::size_t i = 0; i < c.x.size(); ++i) {
        EXPECT_EQ(c.x[i], std::round(c.x[i])) << which;
        EXPECT_EQ(c.p[i], std::round(c.p[i])) << which;
        if (i == 0) continue;
        EXPECT_GE(c.x[i] - c.x[i - 1], 3) << which;
        sum += c.p[i] - c.p[i - 1];
      }
      EXPECT_EQ(sum, travel) << which;
      EXPECT_EQ(c.x.back(), period) << which;
      EXPECT_LE(made.error.position, 20) << which;
      EXPECT_GE(made.error.position * (1 + 1e-9), seen(made.table, cam, 5000).position) << which;
    }
  }
}

TEST(Reduced, ClosesAPeriodThatBeginsBetweenTwoCounts) {
  const double first = 0.5;  // rounds up, and what is a hair less rounds down
  const double last = std::nextafter(first, 0);
  const Cam cam({quintic(50, first, 0, 0, 40, 0, 0), quintic(50, 40, 0, 0, last, 0, 0)}, 0,
                Extrapolation::wrap);
  const Columns c = reduced(cam, {.tolerance = 1, .x_step = 1, .p_step = 1}).table.columns();
  EXPECT_EQ(c.p.front(), 1);
  EXPECT_EQ(c.p.back(), 1);
}

TEST(Reduced, WritesMillisecondsAsTheyAreRead) {
  const Trajectory move = trapezoid({.to = 50, .velocity = 10, .acceleration = 21}).curve();
  ASSERT_EQ(move.outside(), Extrapolation::hold);
  const Sampled made =
      reduced(move, {.tolerance = 1e-3, .x_step = 1e-3, .p_step = 0.01, .v_step = 0.1});
  const Columns& c = made.table.columns();
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    EXPECT_EQ(c.x[i], std::round(c.x[i] * 1000) / 1000);
    EXPECT_EQ(c.p[i], std::round(c.p[i] * 100) / 100);
    EXPECT_EQ(c.v[i], std::round(c.v[i] * 10) / 10);
  }
  EXPECT_GT(c.x.back(), move.end()) << "it holds until the next millisecond";
  EXPECT_LT(c.x.back(), move.end() + 1e-3);
  EXPECT_LE(made.error.position, 1e-3);
}

TEST(Reduced, TakesTheErrorOfAFitOffItsTolerance) {
  Fitted<OverMaster> fit{cycloid(), {2e-4, 1e-3}};
  const Sampled made = reduced(fit, {.tolerance = 1e-3});
  EXPECT_LE(made.error.position, 1e-3);
  EXPECT_GT(made.error.position, 2e-4);
  EXPECT_GE(made.error.velocity, 1e-3);
  EXPECT_THROW(reduced(fit, {.tolerance = 2e-4}), InputError);
}

/// Text of the error.
template <class Over>
std::string refusal(const Curve<Over>& f, const Target& target) {
  return test::error_of([&] { (void)reduced(f, target); });
}

TEST(Reduced, KeepsADwell) {
  const Target targets[] = {{.most = 32},
                            {.tolerance = 500},
                            {.tolerance = 0.7, .x_step = 1, .p_step = 1},
                            {.most = 32, .x_step = 1, .p_step = 1},
                            {.most = 32, .x_step = 1, .p_step = 1, .v_step = 1e-3},
                            {.most = 32, .spacing = 500},
                            {.velocity_tolerance = 0.5}};
  for (const Interpolation rule : all_rules)
    for (std::size_t i = 0; i < std::size(targets); ++i) {
      Target target = targets[i];
      target.rule = rule;
      const Sampled made = reduced(up_and_down(), target);
      expect_dwell(made.table, 12000, 20000, 50000,
                   std::string(name(rule)) + " target " + std::to_string(i));
    }
}

TEST(Reduced, MovesTheEndsOfADwellInwardsToTheGrid) {
  for (const Interpolation rule : all_rules) {
    const Sampled made = reduced(up_and_down(12000.4, 19999.7),
                                 {.rule = rule, .most = 32, .x_step = 1, .p_step = 1});
    expect_dwell(made.table, 12001, 19999, 50000, name(rule));
  }
}

TEST(Reduced, KeepsTheDwellsOfRandomCamsThatEnterThemWithSteps) {
  const auto stands = [](const Segment& f) { return f.sines == 0 && f.degree <= 1 && f.c[1] == 0; };
  int dwells = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const Cam cam = test::random_cam(random, true);
    const double tolerance = stroke_of(cam) * random.log_uniform(1e-6, 1e-2);
    for (const Interpolation rule : all_rules) {
      const Sampled made = reduced(cam, {.rule = rule, .tolerance = tolerance});
      EXPECT_LE(made.error.position, tolerance * (1 + 1e-9)) << seed;
      for (std::size_t i = 0; i < cam.segments().size(); ++i) {
        const Segment& segment = cam.segments()[i];
        if (!stands(segment)) continue;
        if (i > 0 && stands(cam.segments()[i - 1])) continue;
        std::size_t last = i;  // dwells in a row are one
        while (last + 1 < cam.segments().size() && stands(cam.segments()[last + 1])) ++last;
        ++dwells;
        expect_dwell(made.table, cam.breaks()[i], cam.breaks()[last + 1], segment.c[0],
                     std::string(name(rule)) + " seed " + std::to_string(seed));
      }
    }
  }
  EXPECT_GT(dwells, 60);
}

TEST(Reduced, KeepsAnAxisInSync) {
  const Cam cam(
      {quintic(100, 0, 0, 0, 100, 2, 0), line(200, 100, 500), quintic(100, 500, 2, 0, 600, 0, 0)});
  for (const Interpolation rule : all_rules)
    for (const double step : {0.0, 1.0}) {
      const Sampled made =
          reduced(cam, {.rule = rule, .tolerance = 2, .x_step = step, .p_step = step});
      const std::size_t i = interval_from(made.table, 100);
      ASSERT_LT(i + 1, made.table.size()) << name(rule);
      EXPECT_EQ(made.table.columns().x[i + 1], 300) << name(rule);
      for (const double x : {101.0, 150.0, 222.0, 299.0}) {
        EXPECT_NEAR(made.table.jet(x)[0], 100 + 2 * (x - 100), 1e-10) << name(rule);
        EXPECT_NEAR(made.table.jet(x)[1], 2, 1e-12) << name(rule);
      }
    }
}

TEST(Reduced, ReportsHowManyKnotsItsDwellsNeed) {
  const std::string text =
      refusal(up_and_down(), {.rule = Interpolation::linear, .most = 3, .x_step = 1, .p_step = 1});
  EXPECT_NE(text.find("must be at least 4 for a linear table: both ends of "), std::string::npos)
      << text;
  const std::string both = refusal(up_and_down(), {.tolerance = 1, .most = 3});
  EXPECT_NE(both.find("table within the tolerance: both ends of the dwell or straight line of the "
                      "motion need a knot"),
            std::string::npos)
      << both;
  for (const std::size_t few : {std::size_t{0}, std::size_t{1}})
    EXPECT_THAT(refusal(up_and_down(), {.rule = Interpolation::linear, .most = few}),
                testing::StartsWith("most = " + std::to_string(few) +
                                    ": must be at least 4 for a linear table"));
  EXPECT_EQ(
      refusal(up_and_down(), {.rule = Interpolation::linear, .most = 4, .x_step = 1, .p_step = 1}),
      "");
}

TEST(Reduced, TakesTheStepsOfARecordingForNoDwells) {
  Columns recorded;  // a motion of 200 counts, every count for some samples
  for (int i = 0; i <= 2000; ++i) {
    recorded.x.push_back(i);
    recorded.p.push_back(std::round(200 * cycloid().jet(i / 2000.0)[0]));
  }
  const Table table(Domain::master, Interpolation::linear, Extrapolation::hold, recorded);
  const Sampled made =
      reduced(table.curve<OverMaster>(), {.rule = Interpolation::linear, .tolerance = 2});
  EXPECT_LT(made.table.size(), 25u);
}

/// The number behind "tolerance = " in a refusal.
double offered(const std::string& text) {
  const std::string key = "tolerance = ";
  const auto at = text.rfind(key);
  return at == std::string::npos ? 0 : std::stod(text.substr(at + key.size()));
}

TEST(Reduced, ReportsASufficientTolerance) {
  const Target few{.rule = Interpolation::cubic_hermite, .tolerance = 1e-6, .most = 16};
  const std::string text = refusal(cycloid(), few);
  EXPECT_NE(text.find("must be at least 26 for "), std::string::npos) << text;
  const double enough = offered(text);
  EXPECT_LE(reduced(cycloid(), {.tolerance = enough, .most = 16}).table.size(), 16u) << text;
  EXPECT_NE(refusal(cycloid(), {.tolerance = enough * 0.97, .most = 16}), "");

  const Target coarse{.rule = Interpolation::linear, .tolerance = 1e-3, .spacing = 0.1};
  const std::string spaced = refusal(cycloid(), coarse);
  EXPECT_EQ(refusal(cycloid(),
                    {.rule = Interpolation::linear, .tolerance = offered(spaced), .spacing = 0.1}),
            "")
      << spaced;
}

TEST(Reduced, RejectsWhatCannotBe) {
  const Cam sawtooth({line(1, 0, 1), line(1, 0, 1)});
  EXPECT_NE(refusal(sawtooth, {.tolerance = 1e-3}).find("at master 1"), std::string::npos);
  EXPECT_NE(refusal(cycloid(), {}), "");
  EXPECT_NE(refusal(cycloid(), {.tolerance = 0.0}), "");
  EXPECT_NE(refusal(cycloid(), {.most = 1}), "");
  EXPECT_NE(refusal(cycloid(), {.tolerance = 1, .spacing = -1}), "");
  EXPECT_NE(refusal(cycloid(), {.tolerance = 1, .x_step = 0.3}), "") << "1 is not a multiple";
  const Cam drifting({line(10, 0, 2.5)}, 0, Extrapolation::advance);
  EXPECT_NE(refusal(drifting, {.tolerance = 1, .p_step = 1}).find("drift"), std::string::npos);
}

// ---- quadratic pieces ----------------------------------------------------------------------------

/// Googol manual, example 7-4: v = 50 sin(2 pi t) pulse/ms over two periods of a second, in ms.
Trajectory example_7_4() {
  const double stroke = 50 * 1000 / std::numbers::pi;
  std::vector<Segment> segments;
  for (int period = 0; period < 2; ++period)
    for (const double way : {stroke, -stroke})
      for (const Segment& part : normalized(Law::simple_sine)) {
        segments.push_back(scaled(part, way, way < 0 ? stroke : 0));
        segments.back().length *= 500;
      }
  return Trajectory(std::move(segments));
}

/// The table's knots as normal segments.
std::vector<PtPoint> normal_points(const Table& table) {
  std::vector<PtPoint> points;
  const Columns& c = table.columns();
  for (std::size_t i = 1; i < table.size(); ++i)
    points.push_back({c.x[i] - c.x[0], c.p[i] - c.p[0], PtType::normal});
  return points;
}

// Played by its positions alone, as a controller does, each segment beginning at the velocity that the one
// before has ended with: the same motion, to rounding, without a step.
TEST(ReducedToQuadraticPieces, IsWhatNormalSegmentsPlay) {
  const Trajectory f = example_7_4();
  for (const double x_step : {0.0, 1.0, 4.0}) {
    const Sampled made = reduced(f, {.quadratic = true, .most = 127, .x_step = x_step});
    ASSERT_LE(made.table.size(), 127U);
    const std::vector<PtPoint> points = normal_points(made.table);
    const Trajectory played = pt<OverTime>(points);
    double worst = 0;
    for (double t = 0; t <= 2000; t += 0.37) {
      ASSERT_NEAR(played.at(t).position, made.table.jet(t)[0], 1e-7) << t;
      worst = std::max(worst, std::abs(played.at(t).position - f.at(t).position));
    }
    EXPECT_LE(worst, made.error.position * (1 + 1e-9));
    EXPECT_GE(worst, made.error.position * 0.9) << "certified, and no more than it is";
    EXPECT_TRUE(check_pt<OverTime>(points).ok());
    for (const Finding& each : check_pt<OverTime>(points).findings)
      EXPECT_EQ(each.rule, "pt/oscillation") << each.value;
    const auto on_steps = [&](double x) {
      return x_step == 0 || x == x_step * std::round(x / x_step);
    };
    EXPECT_TRUE(std::ranges::all_of(made.table.columns().x, on_steps));
    const Sampled even = reduced(f, {.rule = Interpolation::linear, .most = 127, .x_step = x_step});
    EXPECT_LT(8 * made.error.position, even.error.position);
    EXPECT_LE(made.error.position, 0.52) << "what normal segments in whole ms are known to reach";
  }
}

// A trapezoid is quadratic itself, and a dwell one piece: no knot more than the motion has.
TEST(ReducedToQuadraticPieces, TakesOnePieceWhereTheCurveIsOne) {
  const Trajectory f = trapezoid({.to = 4096, .velocity = 2, .acceleration = 2.0 / 1024}).curve();
  const Sampled made = reduced(f, {.quadratic = true, .tolerance = 1e-6, .x_step = 1});
  EXPECT_EQ(made.table.columns().x, (std::vector<double>{0, 1024, 2048, 3072}));
  EXPECT_LE(made.error.position, 1e-9);
}

TEST(ReducedToQuadraticPieces, KeepsItsTolerancesOrReportsWhichItCan) {
  const Cam f = Cam(normalized(Law::inclined_sine));
  for (const double tolerance : {1e-3, 1e-5}) {
    const Sampled made =
        reduced(f, {.quadratic = true, .tolerance = tolerance, .velocity_tolerance = 0.01});
    EXPECT_LE(made.error.position, tolerance);
    EXPECT_LE(made.error.velocity, 0.01);
  }
  const auto key = [&](const Target& target) {
    return test::key_of([&] { (void)reduced(f, target); });
  };
  EXPECT_EQ(key({.quadratic = true, .tolerance = 1e-6, .most = 9}), "most");
  EXPECT_EQ(key({.quadratic = true, .tolerance = 1e-3, .p_step = 0.01}), "p_step");
  EXPECT_EQ(key({.rule = Interpolation::linear, .quadratic = true, .most = 9}), "rule");
  EXPECT_EQ(key({.quadratic = true, .most = 9, .spacing = 0.4}), "");
}

TEST(Reduce, KeepsTheLimitsThatTheCurveKeeps) {
  // The curve reaches 10 u/s and 20 u/s^2 exactly, so most tables near it exceed them.
  const Trajectory curve =
      s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  const Limits limits{.velocity = 10, .acceleration = 20};
  ASSERT_TRUE(check(curve, limits).ok());
  const Target target{.rule = Interpolation::quintic_hermite, .tolerance = 0.01};
  const Sampled coarse = reduced(curve, target);
  EXPECT_FALSE(check(coarse.table, limits).ok());
  const Sampled within = reduced(curve, target, limits);
  EXPECT_TRUE(check(within.table, limits).ok());
  EXPECT_LE(within.error.position, 0.01);
  EXPECT_GT(within.table.size(), coarse.table.size());
  EXPECT_LE(within.table.size(), coarse.table.size() + 12);
  // A target that permits no more knots, or only at whole steps, gets the same table as before.
  Target full = target;
  full.most = coarse.table.size();
  EXPECT_EQ(reduced(curve, full, limits).table.size(), coarse.table.size());
  Target stepped = target;
  stepped.p_step = 1e-4;
  EXPECT_EQ(reduced(curve, stepped, limits).table.columns().x,
            reduced(curve, stepped).table.columns().x);
  // Knots keep their distance.
  Target spaced = target;
  spaced.spacing = 0.05;
  const Sampled apart = reduced(curve, spaced, limits);
  const auto& x = apart.table.columns().x;
  for (std::size_t i = 1; i < x.size(); ++i) EXPECT_GE(x[i] - x[i - 1], 0.05 * (1 - 1e-12));
}

}  // namespace
}  // namespace jounce::reduce_test
