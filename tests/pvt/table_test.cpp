// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/table.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/signal.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "support/errors.hpp"
#include "support/oracle.hpp"

namespace jounce::table_test {
namespace {

using test::oracle;

static_assert(Signal<Table>);

/// HIMC HMPL manual 5.2.8, in s.
Table hmpl() {
  return Table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
               {{0, 2, 3, 4, 6, 11},
                {0, 153.333, 42.123, 161.21, 177, 83.333},
                {0, 1000, 800, 1660, 450, 0},
                {}});
}

TEST(Table, HmplExampleSwingsAsDerived) {
  const Trajectory f = hmpl().curve<OverTime>();
  EXPECT_NEAR(f.at(1).position, -173.3335, 1e-10);
  EXPECT_NEAR(f.at(1).velocity, -135.00025, 1e-10);
  const Ranges r = extrema(f);
  EXPECT_NEAR(r[0].min.value, -188.7, 0.05);
  EXPECT_NEAR(r[0].max.value, 596.1, 0.05);
  EXPECT_NEAR(std::abs(r[2].peak().value), 7525.5, 0.05);
  const auto& segments = oracle("hmpl_5_2_8")["segments"];
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Ranges here = segment_extrema(f, i);
    EXPECT_NEAR(here[0].min.value, segments[i]["min_position"].get<double>(), 1e-10);
    EXPECT_NEAR(here[0].max.value, segments[i]["max_position"].get<double>(), 1e-10);
  }
}

TEST(Table, HmplExampleLeavesItsTravelInSixStretches) {
  const Report report = check(hmpl().curve<OverTime>(), {.position_min = 0, .position_max = 200});
  const auto& expected = oracle("hmpl_5_2_8")["outside_bounds"];
  ASSERT_EQ(report.broken(), expected.size());
  for (const auto& stretch : expected) {
    const double where = stretch["t_of_worst"].get<double>() / 1000;
    const double worst = stretch["worst"];
    const auto found =
        std::find_if(report.findings.begin(), report.findings.end(), [&](const Finding& f) {
          return std::abs(f.where - where) < 1e-7 && std::abs(f.value - worst) < 1e-9;
        });
    EXPECT_NE(found, report.findings.end()) << where << " s, " << worst;
  }
}

TEST(Table, EvaluatesLikeItsCurveToRounding) {
  const Table table = hmpl();
  const Trajectory f = table.curve<OverTime>();
  const Ranges ranges = extrema(f);
  const auto expect_same = [&](double t, Side side) {
    const Jet a = table.jet(t, side);
    const Jet b = f.jet(t, side);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(a[k], b[k], 1e-15 * std::abs(ranges[k].peak().value)) << t << ", order " << k;
  };
  for (double t = -1; t < 13; t += 0.01) expect_same(t, Side::right);
  for (const double t : table.columns().x) expect_same(t, Side::left);
}

TEST(Table, GivesEachKnotAsItWasGiven) {
  const Table table = hmpl();
  for (std::size_t i = 0; i + 1 < table.size(); ++i) {
    const Jet f = table.jet(table.columns().x[i]);
    EXPECT_EQ(f[0], table.columns().p[i]);
    EXPECT_EQ(f[1], table.columns().v[i]);
  }
}

TEST(Table, WrapsAndMeetsItsKnots) {
  const Table table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                    {{0, 1, 3}, {0, 2, 0}, {0, 1, 0}, {0, -1, 0}});
  EXPECT_EQ(table.jet(3)[0], 0);
  EXPECT_NEAR(table.jet(4)[0], 2, 1e-15);
  EXPECT_NEAR(table.jet(4)[1], 1, 1e-15);
  EXPECT_NEAR(table.jet(4)[2], -1, 1e-14);
  EXPECT_NEAR(table.jet(-2)[0], 2, 1e-15);
}

TEST(Table, ALinearTableIsWhatPmc600Example44Implies) {
  // (0,0) (5000,5000) (10000,7000): slope 1, then 0.4.
  const Table table(Domain::master, Interpolation::linear, Extrapolation::hold,
                    {{0, 5000, 10000}, {0, 5000, 7000}, {}, {}});
  EXPECT_DOUBLE_EQ(table.jet(2500)[1] * 10000, 10000);
  EXPECT_DOUBLE_EQ(table.jet(7500)[1] * 10000, 4000);
  EXPECT_DOUBLE_EQ(table.jet(5000, Side::left)[1], 1);
}

std::string complaint(Interpolation rule, Columns columns) {
  return test::error_of(
      [&] { const Table table(Domain::time, rule, Extrapolation::hold, std::move(columns)); });
}

TEST(Table, NamesKnotColumnAndRuleOfWhatItRejects) {
  EXPECT_EQ(complaint(Interpolation::linear, {{0}, {0}, {}, {}}), "knots = 1: must be at least 2");
  EXPECT_EQ(complaint(Interpolation::linear, {{}, {}, {}, {}}), "knots = 0: must be at least 2");
  EXPECT_EQ(complaint(Interpolation::linear, {{0, 1, 1}, {0, 1, 2}, {}, {}}),
            "knot[3].time = 1: must be greater than 1, the previous knot");
  EXPECT_EQ(complaint(Interpolation::linear, {{0, 1, 0.5}, {0, 1, 2}, {}, {}}),
            "knot[3].time = 0.5: must be greater than 1, the previous knot");
  EXPECT_EQ(complaint(Interpolation::linear, {{-0.0, 0.0}, {0, 1}, {}, {}}),
            "knot[2].time = 0: must be greater than -0, the previous knot");
  EXPECT_EQ(complaint(Interpolation::linear, {{0.0, -0.0}, {0, 1}, {}, {}}),
            "knot[2].time = -0: must be greater than 0, the previous knot");
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(complaint(Interpolation::linear,
                      {{-most, -least, 0, least, most}, {0, 1, most, -most, 0}, {}, {}}),
            "");
  EXPECT_EQ(complaint(Interpolation::linear, {{0, std::nan("")}, {0, 1}, {}, {}}),
            "knot[2].time = nan: must be a finite number");
  EXPECT_EQ(complaint(Interpolation::cubic_hermite,
                      {{0, 1}, {0, 1}, {0, std::numeric_limits<double>::infinity()}, {}}),
            "knot[2].velocity = inf: must be a finite number");
  EXPECT_EQ(complaint(Interpolation::cubic_hermite, {{0, 1}, {0, 1}, {}, {}}),
            "column velocity = 0 values: a cubic_hermite table of 2 knots needs 2");
  EXPECT_EQ(complaint(Interpolation::linear, {{0, 1}, {0, 1}, {0, 0}, {}}),
            "column velocity = 2 values: a linear table of 2 knots needs 0");
  EXPECT_THROW((void)hmpl().curve<OverMaster>(), InputError) << "time cannot be played as master";
}

}  // namespace
}  // namespace jounce::table_test
