// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/check.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/lazy_curve.hpp"
#include "jounce/pvt/warnings.hpp"

#include "pvt/src/table/hull_kernel.hpp"
#include "support/random.hpp"

namespace jounce::check_test {
namespace {

using test::Random;

constexpr std::array rules{Interpolation::linear, Interpolation::cubic_hermite,
                           Interpolation::quintic_hermite};

/// Shapes of tables: wild values, smooth motion, dwells, exact cruises and cruises that rounding
/// makes rough, the same piece again and again.
enum class Shape { wild, smooth, dwells, cruise, rough_cruise, repeated };
constexpr std::array shapes{Shape::wild,   Shape::smooth,       Shape::dwells,
                            Shape::cruise, Shape::rough_cruise, Shape::repeated};

Jet value_of(Shape shape, Random& random, int i, double x, double unit) {
  const auto wild = [&] { return unit * random.uniform(-1, 1); };
  switch (shape) {
    case Shape::wild:
      return {wild(), wild(), wild(), 0};
    case Shape::smooth:
      return {unit * std::sin(x), unit * std::cos(x), -unit * std::sin(x), 0};
    case Shape::dwells:
      return i / 7 % 2 == 0 ? Jet{unit, 0, 0, 0} : Jet{wild(), wild(), wild(), 0};
    case Shape::cruise:
      return {unit * x, unit, 0, 0};
    case Shape::rough_cruise:
      return {unit * (1000.1 + x / 3), unit / 3, 0, 0};
    case Shape::repeated:
      break;
  }
  return {unit * (i % 3), unit * (i % 2), -unit * (i % 4), 0};
}

Table random_table(Random& random, Interpolation rule, Shape shape, int most = 900) {
  const int n = 2 + random.below(random.below(3) == 0 ? 20 : most);
  const double unit = std::ldexp(1, random.below(20) - 10);
  const bool even = random.below(2) == 0;
  constexpr std::array policies{Extrapolation::hold, Extrapolation::wrap, Extrapolation::advance,
                                Extrapolation::refuse};
  Columns columns;
  double x = even ? 0 : random.uniform(-10, 10);
  for (int i = 0; i < n; ++i, x += even ? 0.25 : random.log_uniform(0.01, 1)) {
    const Jet f = value_of(shape, random, i, x, unit);
    columns.x.push_back(x);
    columns.p.push_back(f[0]);
    if (rule != Interpolation::linear) columns.v.push_back(f[1]);
    if (rule == Interpolation::quintic_hermite) columns.a.push_back(f[2]);
  }
  return {Domain::time, rule, policies[static_cast<std::size_t>(random.below(4))],
          std::move(columns)};
}

/// Limits that some tables keep, that most break in places, that are met exactly, one end alone.
Limits random_limits(Random& random, const Ranges& ranges) {
  const auto limit = [&](std::size_t order) -> std::optional<double> {
    const double peak = std::abs(ranges[order].peak().value);
    if (random.below(3) == 0 || peak == 0) return std::nullopt;
    constexpr std::array shares{0.7, 0.99, 1.0, 1.5, 1e6};
    return peak * shares[static_cast<std::size_t>(random.below(5))];
  };
  Limits limits{.velocity = limit(1), .acceleration = limit(2), .jerk = limit(3)};
  const double stroke = ranges[0].max.value - ranges[0].min.value;
  if (random.below(2) == 0)
    limits.position_min = ranges[0].min.value + stroke * random.uniform(-0.3, 0.1);
  if (random.below(2) == 0) limits.position_max = ranges[0].max.value;
  return limits;
}

/// A table keeps where its knots are, a curve adds up lengths.
double place_rounding(const Table& table) {
  return 4e-15 * std::max({table.length(), std::abs(table.start()), std::abs(table.end())});
}

void expect_same(const Report& got, const Report& wanted, double places) {
  ASSERT_EQ(got.findings.size(), wanted.findings.size());
  for (std::size_t i = 0; i < got.findings.size(); ++i) {
    const Finding& a = got.findings[i];
    const Finding& b = wanted.findings[i];
    ASSERT_EQ(a.rule, b.rule) << i;
    ASSERT_EQ(a.quantity, b.quantity) << a.rule;
    ASSERT_EQ(a.value, b.value) << a.rule << " at " << a.where << " and " << b.where;
    ASSERT_EQ(a.limit, b.limit) << a.rule;
    ASSERT_EQ(a.margin, b.margin) << a.rule;
    ASSERT_EQ(a.broken, b.broken) << a.rule;
    ASSERT_EQ(a.severity, b.severity) << a.rule;
    ASSERT_EQ(a.segment, b.segment) << a.rule << " at " << a.where << " and " << b.where;
    ASSERT_EQ(a.advice, b.advice) << a.rule;
    ASSERT_NEAR(a.where, b.where, places) << a.rule;
  }
}

void expect_same(const Ranges& got, const Ranges& wanted, double places) {
  for (std::size_t k = 0; k < 4; ++k)
    for (const auto& [a, b] : {std::pair(got[k].min, wanted[k].min), {got[k].max, wanted[k].max}}) {
      ASSERT_EQ(a.value, b.value) << "order " << k << " at " << a.where << " and " << b.where;
      ASSERT_NEAR(a.where, b.where, places) << "order " << k;
      ASSERT_EQ(a.side, b.side) << "order " << k;
    }
}

template <class Body>
void for_tables(std::uint64_t seed, Body body) {
  Random random(seed);
  for (int trial = 0; trial < 40; ++trial)
    for (const Interpolation rule : rules)
      for (const Shape shape : shapes) {
        const Table table = random_table(random, rule, shape);
        SCOPED_TRACE(std::string(name(rule)) + ", shape " +
                     std::to_string(static_cast<int>(shape)) + ", trial " + std::to_string(trial));
        body(table, random);
        if (::testing::Test::HasFatalFailure()) return;
      }
}

TEST(CheckTable, FindsTheExtremaOfItsCurve) {
  for_tables(1, [](const Table& table, Random&) {
    expect_same(extrema(table), extrema(table.curve<OverTime>()), place_rounding(table));
  });
}

TEST(CheckTable, FindsTheExtremaOfAnyPartOfItsCurve) {
  for_tables(4, [](const Table& table, Random& random) {
    const int count = static_cast<int>(table.size()) - 1;
    const auto first = static_cast<std::size_t>(random.below(count));
    const auto last =
        first + static_cast<std::size_t>(random.below(count - static_cast<int>(first)));
    expect_same(segment_extrema(table, first, last),
                segment_extrema(table.curve<OverTime>(), first, last), place_rounding(table));
  });
}

TEST(CheckTable, WarnsOfTheOvershootOfItsCurve) {
  std::size_t found = 0;
  for_tables(5, [&](const Table& table, Random&) {
    const Report report = overshoot(table);
    found += report.findings.size();
    expect_same(report, overshoot(table.curve<OverTime>()), place_rounding(table));
  });
  EXPECT_GT(found, 10000U);
}

TEST(CheckTable, WarnsOfTheStepsOfVelocityOfItsCurve) {
  std::size_t found = 0;
  for_tables(6, [&](const Table& table, Random&) {
    const Report report = velocity_steps(table);
    found += report.findings.size();
    expect_same(report, velocity_steps(table.curve<OverTime>()), place_rounding(table));
  });
  EXPECT_GT(found, 1000U);
}

TEST(CheckTable, ReportsWhatTheCheckOfItsCurveDoes) {
  for_tables(2, [](const Table& table, Random& random) {
    const Trajectory curve = table.curve<OverTime>();
    const Limits limits = random_limits(random, extrema(curve));
    expect_same(check(table, limits), check(curve, limits), place_rounding(table));
  });
}

TEST(CheckTable, FindsTheStepsOfItsCurve) {
  for_tables(3, [](const Table& table, Random&) {
    for (int order = 0; order <= 3; ++order)
      expect_same(check_continuity(table, order), check_continuity(table.curve<OverTime>(), order),
                  place_rounding(table));
  });
}

TEST(CheckTable, NamesDerivativesOverTheMaster) {
  const Table table(Domain::master, Interpolation::cubic_hermite, Extrapolation::wrap,
                    {{0, 1, 2}, {0, 1, 0}, {0, 0, 0}, {}});
  const Report report = check(table, {.velocity = 1});
  ASSERT_EQ(report.findings.size(), 2U);
  EXPECT_EQ(report.findings[0].quantity, "geo_velocity");
  EXPECT_EQ(report.findings[0].value, 1.5);
  EXPECT_EQ(report.findings[0].where, 0.5);
  EXPECT_TRUE(check(table, {}).findings.empty());
}

TEST(CheckTable, CatchesTheOvershootBetweenTheKnotsOfHmpl) {
  // HMPL 5.2.8, PVT in s: positions within 0 ... 177, and far beyond between them.
  const Table table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                    {{0, 2, 3, 4, 6, 11},
                     {0, 153.333, 42.123, 161.21, 177, 83.333},
                     {0, 1000, 800, 1660, 450, 0},
                     {}});
  const Report report = check(table, {.position_min = 0, .position_max = 200});
  EXPECT_EQ(report.broken(), 6U);
  EXPECT_NEAR(extrema(table)[0].max.value, 596.1, 0.05);
}

TEST(CheckTable, RejectsWhatItsCurveRejects) {
  const Table steep(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                    {{0, 1, 1 + 1e-15}, {0, 1, 1e300}, {0, 0, 0}, {}});
  EXPECT_THROW((void)steep.curve<OverTime>(), InputError);
  EXPECT_THROW((void)check(steep, {.velocity = 1}), InputError);
  EXPECT_THROW((void)extrema(steep), InputError);
  EXPECT_THROW(require_curve(steep), InputError);
  EXPECT_THROW(LazyCurve{steep}, InputError);
  EXPECT_THROW((void)check(steep, {.velocity = -1}), InputError);
}

TEST(LazyCurve, IsTheCurveOfItsTable) {
  for_tables(7, [](const Table& table, Random&) {
    require_curve(table);
    const LazyCurve lazy(table);
    const LazyCurve copy = lazy;
    const Trajectory wanted = table.curve<OverTime>();
    const Trajectory& curve = std::get<Trajectory>(*lazy);
    ASSERT_EQ(&curve, &std::get<Trajectory>(*copy)) << "copies share it";
    ASSERT_EQ(curve.outside(), wanted.outside());
    ASSERT_TRUE(std::equal(curve.breaks().begin(), curve.breaks().end(), wanted.breaks().begin(),
                           wanted.breaks().end()));
    for (std::size_t i = 0; i + 1 < table.size(); ++i)
      ASSERT_EQ(curve.segments()[i].c, wanted.segments()[i].c) << i;
  });
  const Table cam(Domain::master, Interpolation::linear, Extrapolation::wrap,
                  {{0, 1, 2}, {0, 1, 0}, {}, {}});
  EXPECT_EQ(std::get<Cam>(*LazyCurve(cam)).at(0.5).position, 0.5);
}

// ---- the bounds ------------------------------------------------------------------------------------

void expect_hulls(pvt_detail::HullKernel kernel, const Table& table) {
  const pvt_detail::KnotColumns knots = pvt_detail::knots_of(table.columns());
  pvt_detail::Hulls here, reference;
  for (std::size_t first = 0; first + 1 < table.size(); first += pvt_detail::Hulls::size) {
    const std::size_t n = std::min(pvt_detail::Hulls::size, table.size() - 1 - first);
    kernel(knots, table.rule(), first, n, here);
    pvt_detail::hulls_anywhere(knots, table.rule(), first, n, reference);
    for (std::size_t order = 0; order < 4; ++order)
      for (std::size_t side = 0; side < 2; ++side) {
        ASSERT_EQ(here.greatest[order][side], reference.greatest[order][side])
            << order << " " << side;
        ASSERT_EQ(here.taken[order][side], reference.taken[order][side]) << order << " " << side;
        for (std::size_t k = 0; k < n; ++k)
          ASSERT_EQ(here.bound[order][side][k], reference.bound[order][side][k]) << first + k;
      }
  }
}

TEST(Hulls, HoldWhatTheSearchFinds) {
  for_tables(4, [](const Table& table, Random&) {
    const pvt_detail::KnotColumns knots = pvt_detail::knots_of(table.columns());
    const Trajectory curve = table.curve<OverTime>();
    pvt_detail::Hulls hulls;
    const std::size_t n = std::min(pvt_detail::Hulls::size, table.size() - 1);
    pvt_detail::hull_kernel()(knots, table.rule(), 0, n, hulls);
    const Ranges all = segment_extrema(curve, 0, n - 1);
    for (std::size_t order = 0; order < 4; ++order) {
      ASSERT_GE(all[order].max.value, hulls.taken[order][0]) << order;
      ASSERT_GE(-all[order].min.value, hulls.taken[order][1]) << order;
      for (std::size_t k = 0; k < n; ++k) {
        const Range range = segment_range(curve, k, static_cast<int>(order));
        ASSERT_LE(range.max.value, hulls.bound[order][0][k]) << "order " << order << ", " << k;
        ASSERT_LE(-range.min.value, hulls.bound[order][1][k]) << "order " << order << ", " << k;
      }
    }
  });
}

TEST(Hulls, AreTheSameToTheBitWithEachVectorWidthOfThisProcessor) {
  const auto compare = [](std::uint64_t seed, pvt_detail::HullKernel kernel) {
    for_tables(seed, [&](const Table& table, Random&) { expect_hulls(kernel, table); });
  };
  compare(4, pvt_detail::hull_kernel());
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) compare(5, pvt_detail::hulls_avx2);
  if (__builtin_cpu_supports("avx512f")) compare(6, pvt_detail::hulls_avx512);
#endif
}

}  // namespace
}  // namespace jounce::check_test
