// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/fill.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numeric>
#include <span>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::fill_test {
namespace {

using nlohmann::json;
using test::Random;

const json& oracle() {
  static const json all = json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/fill.json"));
  return all;
}

FillSpec knots_of(const json& table) {
  FillSpec spec;
  for (const json& point : table["points"]) {
    spec.x.push_back(point[0]);
    spec.p.push_back(point[1]);
  }
  return spec;
}

std::vector<double> velocities(const FillSpec& spec) {
  return filled(spec).table.columns().v;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected,
                 double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], tolerance * largest(expected)) << "knot " << i + 1;
}

TEST(Fill, AgreesWithTheDefiningEquations) {
  for (const auto& [name, table] : oracle().items())
    for (const Filling filling : {Filling::natural, Filling::clamped, Filling::periodic,
                                  Filling::not_a_knot, Filling::monotone}) {
      SCOPED_TRACE(name + " " + jounce::name(filling));
      FillSpec spec = knots_of(table);
      spec.filling = filling;
      expect_near(velocities(spec), table[jounce::name(filling)], 2e-14);
    }
}

TEST(Fill, KeepsGivenVelocitiesAndSplinesBetween) {
  for (const auto& [name, table] : oracle().items()) {
    FillSpec spec = knots_of(table);
    spec.v.resize(spec.x.size());
    spec.v[2] = 5;
    const auto v = velocities(spec);
    expect_near(v, table["natural, third given 5"], 2e-14);
    EXPECT_EQ(v[2], 5);
  }
}

TEST(Fill, MinimumJerkIsTheQuinticSpline) {
  for (const auto& [name, table] : oracle().items()) {
    SCOPED_TRACE(name);
    FillSpec spec = knots_of(table);
    spec.rule = Interpolation::quintic_hermite;
    spec.filling = Filling::minimum_jerk;
    // Stiffness of an interval goes with length^-5: what differs five-fold loses nothing, 1 : 65000
    // half of the digits of an acceleration.
    const double tolerance = name == "hmpl" ? 1e-13 : 1e-7;
    const auto expect = [&, &all = table](const char* which) {
      SCOPED_TRACE(which);
      const Columns found = filled(spec).table.columns();
      expect_near(found.v, all[which][0], tolerance);
      expect_near(found.a, all[which][1], tolerance);
    };
    expect("minimum_jerk");
    spec.outside = Extrapolation::advance;
    expect("minimum_jerk periodic");
    spec.outside = Extrapolation::hold;
    spec.v.resize(spec.x.size());
    spec.v.front() = spec.v.back() = 0;
    spec.a = spec.v;
    expect("minimum_jerk at rest");
  }
}

// ---- properties ------------------------------------------------------------------------------

constexpr std::array all_fillings{
    Filling::natural,  Filling::clamped,          Filling::periodic,     Filling::not_a_knot,
    Filling::monotone, Filling::shape_preserving, Filling::minimum_jerk, Filling::within_limits};

FillSpec random_spec(Random& random, int knots, double spread) {
  FillSpec spec;
  double x = random.uniform(-1, 1);
  for (int i = 0; i < knots; ++i, x += random.log_uniform(1 / spread, spread)) {
    spec.x.push_back(x);
    // Repeated values, and neighbours on a line, now and then.
    spec.p.push_back(i > 0 && random.below(4) == 0 ? spec.p.back() : random.uniform(-10, 10));
  }
  spec.limits = {.velocity = 30, .acceleration = 200};
  return spec;
}

std::string printed(const FillSpec& spec) {
  return json{{"x", spec.x}, {"p", spec.p}, {"filling", name(spec.filling)}}.dump();
}

TEST(Fill, CubicSplinesHaveContinuousAccelerationHoweverUnevenAndLong) {
  Random random(1);
  for (const int knots : {2, 3, 4, 7, 1023, 1027, 1500, 5001})
    for (const double spread : {1.0, 3.0, 1000.0})
      for (const Filling filling :
           {Filling::natural, Filling::clamped, Filling::periodic, Filling::not_a_knot}) {
        FillSpec spec = random_spec(random, knots, spread);
        spec.filling = filling;
        SCOPED_TRACE(knots);
        SCOPED_TRACE(name(filling));
        const auto v = velocities(spec);
        const auto length = [&](std::size_t i) { return spec.x[i + 1] - spec.x[i]; };
        const auto chord = [&](std::size_t i) { return (spec.p[i + 1] - spec.p[i]) / length(i); };
        // Row by row against the size of its own terms.
        const auto row = [&](std::size_t a, std::size_t i, std::size_t b, std::size_t c) {
          const double h0 = length(a), h1 = length(i);
          const double right = 3 * (h1 * chord(a) + h0 * chord(i));
          const double size = h1 * (std::abs(v[a]) + std::abs(chord(a))) +
                              (h0 + h1) * std::abs(v[i]) +
                              h0 * (std::abs(v[c]) + std::abs(chord(i)));
          EXPECT_NEAR(h1 * v[a] + 2 * (h0 + h1) * v[b] + h0 * v[c], right, 1e-14 * size) << i;
        };
        for (std::size_t i = 1; i + 1 < v.size(); ++i) row(i - 1, i, i, i + 1);
        if (filling == Filling::periodic) {
          EXPECT_EQ(v.front(), v.back());
          row(v.size() - 2, 0, 0, 1);
        }
      }
}

double square_jerk(const Table& table) {
  const Trajectory jerk = derivative(derivative(derivative(table.curve<OverTime>())));
  double sum = 0;
  for (const Segment& f : jerk.segments())  // degree 2: Gauss's three points are exact for squares
    for (const auto& [at, weight] : {std::pair{0.5 - std::sqrt(0.15), 5.0 / 18},
                                     {0.5, 8.0 / 18},
                                     {0.5 + std::sqrt(0.15), 5.0 / 18}})
      sum += weight * f.length * std::pow(value(f, at), 2);
  return sum;
}

TEST(Fill, MinimumJerkBeatsEveryPerturbationAndKeepsWhatIsGiven) {
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    FillSpec spec = random_spec(random, 2 + random.below(12), 3);
    spec.rule = Interpolation::quintic_hermite;
    spec.filling = Filling::minimum_jerk;
    const bool around = random.below(3) == 0;
    if (around) spec.outside = Extrapolation::advance;
    const std::size_t size = spec.x.size();
    spec.v.resize(size);
    spec.a.resize(size);
    for (std::size_t i = 0; i + 1 < size; ++i) {
      if (random.below(3) == 0) spec.v[i] = random.uniform(-5, 5);
      if (random.below(3) == 0) spec.a[i] = random.uniform(-5, 5);
    }
    const Filled best = filled(spec);
    const double least = square_jerk(best.table);
    const Columns& found = best.table.columns();
    for (std::size_t i = 0; i < size; ++i) {
      if (spec.v[i]) {
        EXPECT_EQ(found.v[i], *spec.v[i]);
      }
      if (spec.a[i]) {
        EXPECT_EQ(found.a[i], *spec.a[i]);
      }
    }
    for (int trial = 0; trial < 10; ++trial) {
      Columns other = found;
      const auto i = static_cast<std::size_t>(random.below(static_cast<int>(size)));
      const bool velocity = random.below(2) == 0;
      if ((velocity ? spec.v : spec.a)[i]) continue;
      if (around && (velocity ? spec.v : spec.a)[i == size - 1 ? 0 : i]) continue;
      auto& column = velocity ? other.v : other.a;
      column[i] += random.uniform(-1, 1);
      if (around && (i == 0 || i == size - 1)) column.front() = column.back() = column[i];
      EXPECT_GE(square_jerk(Table(Domain::time, spec.rule, spec.outside, other)),
                least * (1 - 1e-12))
          << printed(spec) << " knot " << i;
    }
  }
}

TEST(Fill, ReproducesPolynomials) {
  Random random(3);
  for (int round = 0; round < 100; ++round) {
    FillSpec spec = random_spec(random, 4 + random.below(8), 3);
    std::array<double, 6> c{};
    for (double& each : c) each = random.uniform(-1, 1);
    const double unit = 1 / std::max(std::abs(spec.x.front()), std::abs(spec.x.back()));
    const auto f = [&](double x, int order, int degree) {
      double sum = 0;
      for (int k = degree; k >= order; --k) {
        double factor = c[static_cast<std::size_t>(k)] * std::pow(unit, order);
        for (int n = 0; n < order; ++n) factor *= k - n;
        sum = sum * unit * x + factor;
      }
      return sum;
    };
    const auto expect = [&](Filling filling, int degree) {
      spec.filling = filling;
      spec.v.assign(spec.x.size(), {});
      for (std::size_t i = 0; i < spec.x.size(); ++i) spec.p[i] = f(spec.x[i], 0, degree);
      if (filling == Filling::natural) {
        spec.v.front() = f(spec.x.front(), 1, degree);
        spec.v.back() = f(spec.x.back(), 1, degree);
      }
      std::vector<double> expected;
      for (const double x : spec.x) expected.push_back(f(x, 1, degree));
      SCOPED_TRACE(printed(spec));
      expect_near(velocities(spec), expected, 1e-11);
    };
    expect(Filling::natural, 3);
    expect(Filling::not_a_knot, 3);
    expect(Filling::minimum_jerk, 2);
    spec.rule = Interpolation::quintic_hermite;  // quintics, with what makes one at the ends
    spec.v.assign(spec.x.size(), {});
    spec.a.assign(spec.x.size(), {});
    std::vector<double> velocities, accelerations;
    for (std::size_t i = 0; i < spec.x.size(); ++i) {
      spec.p[i] = f(spec.x[i], 0, 5);
      velocities.push_back(f(spec.x[i], 1, 5));
      accelerations.push_back(f(spec.x[i], 2, 5));
    }
    for (const std::size_t i : {std::size_t{0}, spec.x.size() - 1}) {
      spec.v[i] = velocities[i];
      spec.a[i] = accelerations[i];
    }
    const Filled made = filled(spec);
    expect_near(made.table.columns().v, velocities, 1e-9);
    expect_near(made.table.columns().a, accelerations, 1e-8);
  }
}

/// By exact extrema: whether each piece runs the way of its chord.
void expect_monotone_pieces(const FillSpec& spec, const Filled& made) {
  const Trajectory f = made.table.curve<OverTime>();
  for (std::size_t i = 0; i + 1 < spec.x.size(); ++i) {
    const Range v = segment_range(f, i, 1);
    const double chord = (spec.p[i + 1] - spec.p[i]) / (spec.x[i + 1] - spec.x[i]);
    const double rounding = 1e-13 * std::abs(chord);
    if (chord >= 0) {
      EXPECT_GE(v.min.value, -rounding) << printed(spec) << " piece " << i + 1;
    }
    if (chord <= 0) {
      EXPECT_LE(v.max.value, rounding) << printed(spec) << " piece " << i + 1;
    }
  }
}

TEST(Fill, MonotoneAndShapePreservingNeverRunAgainstTheirChord) {
  Random random(4);
  for (int round = 0; round < 2000; ++round) {
    FillSpec spec = random_spec(random, 2 + random.below(12), random.below(2) == 0 ? 3 : 1e4);
    if (random.below(2) == 0) std::sort(spec.p.begin(), spec.p.end());
    spec.outside = random.below(2) == 0 ? Extrapolation::hold : Extrapolation::advance;
    for (const Filling filling : {Filling::monotone, Filling::shape_preserving}) {
      spec.filling = filling;
      const Filled made = filled(spec);
      expect_monotone_pieces(spec, made);
      if (repeats(spec.outside)) {
        EXPECT_EQ(made.table.columns().v.front(), made.table.columns().v.back());
      }
    }
  }
}

TEST(Fill, ShapePreservingKeepsConvexDataConvexWhereCubicsCan) {
  Random random(5);
  int named = 0;
  for (int round = 0; round < 1000; ++round) {
    FillSpec spec = random_spec(random, 3 + random.below(10), 4);
    // Convex cubics exist by construction: first velocities, then chords between their thirds.
    double v = random.uniform(0.1, 1);
    for (std::size_t i = 0; i + 1 < spec.x.size(); ++i) {
      const double next = v + random.log_uniform(1e-3, 3);
      const double chord = v + (next - v) * random.uniform(0.34, 0.66);
      spec.p[i + 1] = spec.p[i] + chord * (spec.x[i + 1] - spec.x[i]);
      v = next;
    }
    spec.filling = Filling::shape_preserving;
    const Filled made = filled(spec);
    const Range a = extrema(made.table.curve<OverTime>(), 2);
    EXPECT_TRUE(made.report.findings.empty()) << printed(spec);
    EXPECT_GE(a.min.value, -1e-9 * std::abs(a.peak().value)) << printed(spec);
    // Other convex data: what is not named is convex.
    for (std::size_t i = 1; i < spec.x.size(); ++i)
      spec.p[i] = spec.p[i - 1] + (spec.x[i] - spec.x[i - 1]) *
                                      std::exp(static_cast<double>(i) * random.uniform(0.5, 2));
    const Filled other = filled(spec);
    const Trajectory f = other.table.curve<OverTime>();
    const auto chord = [&](std::size_t i) {
      return (spec.p[i + 1] - spec.p[i]) / (spec.x[i + 1] - spec.x[i]);
    };
    for (std::size_t i = 0; i + 1 < spec.x.size(); ++i) {
      const bool left = i == 0 || chord(i) >= chord(i - 1);
      const bool right = i + 2 == spec.x.size() || chord(i + 1) >= chord(i);
      const bool is_named =
          std::any_of(other.report.findings.begin(), other.report.findings.end(),
                      [&](const Finding& finding) { return finding.segment == i; });
      named += is_named ? 1 : 0;
      const Range bend = segment_range(f, i, 2);
      if (left && right && !is_named && spec.x.size() > 2) {
        // a h is 6 d less velocities: six roundings of the chord, and two to evaluate.
        const double h = spec.x[i + 1] - spec.x[i];
        const double chord_rounding =
            4 * std::numeric_limits<double>::epsilon() *
            ((std::abs(spec.p[i]) + std::abs(spec.p[i + 1])) / h + 2 * std::abs(chord(i)));
        EXPECT_GE(bend.min.value * h, -8 * chord_rounding) << printed(spec) << i;
      }
    }
  }
  EXPECT_GT(named, 0) << "steep data must show the naming";
}

TEST(Fill, WhereNoConvexCubicExistsThePieceIsNamed) {
  // Flat, flat, steep, steep: the flat piece forces velocity 0, then 1.5 chords at least.
  FillSpec spec{.x = {0, 1, 2, 3, 4}, .p = {0, 0, 0, 10, 20}};
  spec.filling = Filling::shape_preserving;
  const Filled made = filled(spec);
  ASSERT_EQ(made.report.findings.size(), 1u);
  EXPECT_EQ(made.report.findings[0].rule, "fill/convex");
  EXPECT_EQ(made.report.findings[0].segment, 3u) << "which cannot be straight then";
  EXPECT_TRUE(made.report.ok()) << "a warning";
  expect_monotone_pieces(spec, made);
}

TEST(Fill, NamesPiecesThatGivenVelocitiesTurnBack) {
  for (const Filling filling : {Filling::monotone, Filling::shape_preserving}) {
    FillSpec spec{.x = {0, 1, 2, 3}, .p = {0, 1, 2, 3}};
    spec.v = {{}, -1, {}, {}};
    spec.filling = filling;
    const Filled made = filled(spec);
    EXPECT_EQ(made.table.columns().v[1], -1);
    for (const std::size_t piece : {0u, 1u})
      EXPECT_TRUE(std::any_of(
          made.report.findings.begin(), made.report.findings.end(),
          [&](const Finding& f) { return f.rule == "fill/monotone" && f.segment == piece; }));
  }
}

TEST(Fill, WithinLimitsFindsAWayWhereverThereIsOneAndNoLimitIsExceeded) {
  Random random(6);
  for (int round = 0; round < 1000; ++round) {
    FillSpec spec = random_spec(random, 2 + random.below(20), 4);
    // A motion that keeps its own limits, from rest to rest, and then a margin of 3 %.
    Columns known{spec.x, spec.p, std::vector<double>(spec.x.size(), 0.0), {}};
    for (std::size_t i = 1; i + 1 < spec.x.size(); ++i) known.v[i] = random.uniform(-5, 5);
    const Ranges peaks =
        extrema(Table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold, known)
                    .curve<OverTime>());
    if (peaks[1].peak().value == 0) continue;
    const int which = 1 + random.below(7);
    const auto limit = [&](int bit, std::size_t order) {
      return (which & bit) != 0 ? std::optional(1.03 * std::abs(peaks[order].peak().value))
                                : std::nullopt;
    };
    spec.limits = {.velocity = limit(1, 1), .acceleration = limit(2, 2), .jerk = limit(4, 3)};
    spec.filling = Filling::within_limits;
    const Filled made = filled(spec);
    EXPECT_TRUE(made.report.findings.empty()) << printed(spec) << which;
    EXPECT_TRUE(check(made.table.curve<OverTime>(), spec.limits).ok()) << printed(spec) << which;
    EXPECT_EQ(made.table.columns().v.front(), 0);
    EXPECT_EQ(made.table.columns().v.back(), 0);
  }
}

TEST(Fill, WithinLimitsIsTheSplineWhereThatKeepsThem) {
  FillSpec spec = knots_of(oracle()["hmpl"]);
  spec.filling = Filling::clamped;
  const auto v = velocities(spec);
  spec.filling = Filling::within_limits;
  spec.limits = {.velocity = 1e4, .acceleration = 1e4, .jerk = 1e5};
  EXPECT_EQ(velocities(spec), v);
}

TEST(Fill, WithinLimitsReportsTheTimeThatAPieceNeeds) {
  // From rest to rest a cubic's peak velocity is 1.5 d / h, its acceleration 6 d / h^2, its jerk
  // 12 d / h^3.
  const auto needed = [](Limits limits) {
    FillSpec spec{.x = {0, 1}, .p = {0, 60}};
    spec.filling = Filling::within_limits;
    spec.limits = limits;
    const Report report = filled(spec).report;
    EXPECT_EQ(report.broken(), 1u);
    EXPECT_EQ(report.findings[0].rule, "fill/limits");
    EXPECT_EQ(report.findings[0].segment, 0u);
    EXPECT_EQ(report.findings[0].value, 1);
    return report.findings[0].limit;
  };
  EXPECT_NEAR(needed({.velocity = 30}), 1.5 * 60 / 30, 1e-8);
  EXPECT_NEAR(needed({.acceleration = 10}), std::sqrt(6 * 60 / 10.0), 1e-8);
  EXPECT_NEAR(needed({.jerk = 10}), std::cbrt(12 * 60 / 10.0), 1e-8);
}

TEST(Fill, NoTimeIsEnoughForAGivenVelocityAboveTheLimit) {
  FillSpec spec{.x = {0, 1, 2}, .p = {0, 1, 2}};
  spec.v = {{}, 11, {}};
  spec.filling = Filling::within_limits;
  spec.limits = {.velocity = 10};
  const Report report = filled(spec).report;
  EXPECT_EQ(report.broken(), 2u);
  EXPECT_TRUE(std::isinf(report.findings[0].limit));
}

TEST(Fill, ScalesWithItsUnits) {
  Random random(7);
  for (const Filling filling : all_fillings)
    for (const Interpolation rule :
         {Interpolation::cubic_hermite, Interpolation::quintic_hermite}) {
      const bool of_shape = filling == Filling::monotone || filling == Filling::shape_preserving;
      if (of_shape && rule == Interpolation::quintic_hermite) continue;
      FillSpec spec = random_spec(random, 9, 5);
      spec.filling = filling;
      spec.rule = rule;
      const Columns one = filled(spec).table.columns();
      FillSpec other = spec;
      constexpr double time = 0x1p-60, length = 0x1p90;  // exact
      for (double& x : other.x) x *= time;
      for (double& p : other.p) p *= length;
      other.limits = {.velocity = 30 * length / time, .acceleration = 200 * length / time / time};
      const Columns two = filled(other).table.columns();
      for (std::size_t i = 0; i < one.v.size(); ++i) {
        EXPECT_NEAR(two.v[i], one.v[i] * length / time, 1e-9 * largest(two.v)) << name(filling);
        if (!one.a.empty()) {
          EXPECT_NEAR(two.a[i], one.a[i] * length / time / time, 1e-9 * largest(two.a));
        }
      }
    }
}

TEST(Fill, TwoAndThreeKnotsAndRepeatedValuesHaveAnAnswer) {
  for (const Filling filling : all_fillings) {
    SCOPED_TRACE(name(filling));
    const bool at_rest = filling == Filling::clamped || filling == Filling::within_limits;
    FillSpec spec{.x = {1, 3}, .p = {2, 8}, .filling = filling, .limits = {.velocity = 10}};
    for (const double v : velocities(spec)) EXPECT_NEAR(v, at_rest ? 0 : 3, 1e-14);
    spec.x = {0, 1, 3};
    spec.p = {0, 1, 3};
    if (!at_rest) {
      for (const double v : velocities(spec)) EXPECT_NEAR(v, 1, 1e-14);
    }
    spec.p = {4, 4, 4};
    for (const double v : velocities(spec)) EXPECT_EQ(v, 0);
  }
  FillSpec parabola{.x = {0, 1, 3}, .p = {0, 1, 9}, .filling = Filling::not_a_knot};
  expect_near(velocities(parabola), {0, 2, 6}, 1e-15);
}

TEST(Fill, AccelerationsMakeTheJerkLeastUnderTheVelocities) {
  FillSpec spec = knots_of(oracle()["hmpl"]);
  const double cubic = square_jerk(filled(spec).table);
  spec.rule = Interpolation::quintic_hermite;
  const Filled made = filled(spec);
  EXPECT_LT(square_jerk(made.table), cubic) << "the cubic is one of the quintics";
  Columns other = made.table.columns();
  for (const double by : {-1.0, 1.0}) {
    other.a[2] = made.table.columns().a[2] + by;
    EXPECT_GT(square_jerk(Table(Domain::time, spec.rule, Extrapolation::hold, other)),
              square_jerk(made.table));
  }
}

TEST(Fill, PeriodicIsCutOpenWhereAVelocityIsGiven) {
  FillSpec spec = knots_of(oracle()["uneven"]);
  spec.filling = Filling::periodic;
  const auto free = velocities(spec);
  spec.v.resize(spec.x.size());
  spec.v[3] = free[3];  // the same as the free value
  expect_near(velocities(spec), free, 1e-13);
  spec.v[3].reset();
  spec.v.back() = free.back();
  expect_near(velocities(spec), free, 1e-13);
}

std::string complaint(const FillSpec& spec) {
  return test::error_of([&] { (void)filled(spec); });
}

TEST(Fill, NamesTheRejectedValue) {
  const FillSpec good{.x = {0, 1, 2}, .p = {0, 1, 0}};
  FillSpec spec = good;
  spec.x[2] = 1;
  EXPECT_EQ(complaint(spec), "knot[3].time = 1: must be greater than 1, the previous knot");
  spec = good;
  spec.v = {1};
  EXPECT_EQ(complaint(spec), "v = 1 values: must be one for each knot, or none: there are 3 knots");
  spec = good;
  spec.v = {{}, std::nan(""), {}};
  EXPECT_EQ(complaint(spec), "knot[2].velocity = nan: must be a finite number");
  spec = good;
  spec.a = {1, {}, {}};
  EXPECT_EQ(complaint(spec),
            "knot[1].acceleration = 1: only a quintic_hermite table has accelerations");
  spec = good;
  spec.rule = Interpolation::linear;
  EXPECT_EQ(complaint(spec), "rule = linear: has no velocities");
  spec = good;
  spec.filling = Filling::monotone;
  spec.rule = Interpolation::quintic_hermite;
  EXPECT_EQ(complaint(spec), "rule = quintic_hermite: monotone velocities need cubic_hermite");
  spec = good;
  spec.filling = Filling::within_limits;
  EXPECT_NE(complaint(spec).find("are missing: within_limits needs a limit"), std::string::npos);
  spec = good;
  spec.filling = Filling::periodic;
  spec.v = {1, {}, 2};
  EXPECT_EQ(
      complaint(spec),
      "knot[3].velocity = 2: must equal that of the first knot, 1, where the table continues");
  spec.v.clear();
  spec.p[2] = 1;
  spec.outside = Extrapolation::wrap;
  EXPECT_NE(complaint(spec).find("a table that wraps is closed"), std::string::npos);
  for (const Filling filling : all_fillings) EXPECT_EQ(filling_named(name(filling)), filling);
  EXPECT_EQ(filling_named("smooth"), std::nullopt);
}

TEST(SplineVelocities, RejectSpansOfDifferentSizes) {
  const std::vector<double> x{0, 1, 2};
  const std::vector<double> p{0, 1};
  std::vector<double> v(3);
  EXPECT_THROW(spline_velocities(x, p, Filling::natural, v), InputError);
  EXPECT_THROW(spline_velocities(x, x, Filling::natural, std::span(v).first(2)), InputError);
  EXPECT_THROW(spline_velocities(std::span(x).first(1), std::span(x).first(1), Filling::natural,
                                 std::span(v).first(1)),
               InputError);
}

}  // namespace
}  // namespace jounce::fill_test
