// SPDX-License-Identifier: Apache-2.0
// The limits of a spec hold for the table that a controller plays, or a finding reports the excess. The witness
// computes the motion of a table from its knots, by Hermite's formulas, at many places.
#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/design/convert.hpp"
#include "jounce/design/detail/cam_check.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::table_limits_test {
namespace {

using ::testing::HasSubstr;

constexpr double speed = 900;  // deg/s

std::string spec_text(const std::string& limits, const std::string& master,
                      const std::string& table) {
  return "jounce = 1\nkind = \"cam\"\nname = \"small\"\nperiodic = true\n"
         "units = { master = \"deg\", position = \"mm\" }\nstart = { master = 0, slave = 0 }\n"
         "[[segment]]\nlaw = \"modified_sine\"\nend = { master = 120, slave = 50 }\n"
         "[[segment]]\nlaw = \"dwell\"\nend = { master = 200, slave = 50 }\n"
         "[[segment]]\nlaw = \"modified_sine\"\nend = { master = 360, slave = 0 }\n"
         "[limits.slave]\n" +
         limits + "\n[master]\nvelocity = 900\n" + master + "\n[table]\n" + table + "\n";
}

Input made(const std::string& limits, const std::string& master, const std::string& table) {
  return inputs_of(parse_spec(spec_text(limits, master, table), "small.toml"), "small.toml")
      .front();
}

/// Magnitudes of velocity, acceleration and jerk of the slave, in mm and s.
struct SlavePeaks {
  double velocity = 0, acceleration = 0, jerk = 0;

  /// f1, f2, f3: derivatives of the cam; ramp: acceleration of the master, deg/s^2.
  void take(double f1, double f2, double f3, double ramp) {
    const double w = speed;
    velocity = std::max(velocity, std::abs(f1) * w);
    acceleration = std::max(acceleration, std::abs(f2) * w * w + std::abs(f1) * ramp);
    jerk = std::max(jerk, std::abs(f3) * w * w * w + 3 * std::abs(f2) * w * ramp);
  }
};

/// The peaks of a quintic or cubic table. The Hermite polynomial p + v h s + a h^2 s^2 / 2 + c3 s^3 + c4 s^4 + c5 s^5
/// of an interval of length h follows from the values at its end.
SlavePeaks peaks_of(const Table& table, double ramp) {
  const Columns columns = table.columns();
  SlavePeaks peaks;
  for (std::size_t i = 0; i + 1 < columns.x.size(); ++i) {
    const double h = columns.x[i + 1] - columns.x[i];
    const double dp = columns.p[i + 1] - columns.p[i];
    const double v0 = columns.v[i] * h, v1 = columns.v[i + 1] * h;
    double c2 = 3 * dp - 2 * v0 - v1, c3 = v0 + v1 - 2 * dp, c4 = 0, c5 = 0;
    if (!columns.a.empty()) {
      const double a0 = columns.a[i] * h * h, a1 = columns.a[i + 1] * h * h;
      c2 = a0 / 2;
      c3 = 10 * dp - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1;
      c4 = -15 * dp + 8 * v0 + 7 * v1 + 1.5 * a0 - a1;
      c5 = 6 * dp - 3 * v0 - 3 * v1 - 0.5 * a0 + 0.5 * a1;
    }
    constexpr int parts = 2000;
    for (int k = 0; k <= parts; ++k) {
      const double s = static_cast<double>(k) / parts;
      peaks.take((v0 + s * (2 * c2 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h,
                 (2 * c2 + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / (h * h),
                 (6 * c3 + s * (24 * c4 + s * 60 * c5)) / (h * h * h), ramp);
    }
  }
  return peaks;
}

SlavePeaks peaks_of(const Cam& cam, double ramp) {
  SlavePeaks peaks;
  constexpr int parts = 360000;
  for (int k = 0; k < parts; ++k) {
    const Jet jet = cam.jet(360.0 * k / parts);
    peaks.take(jet[1], jet[2], jet[3], ramp);
  }
  return peaks;
}

struct Limited {
  std::string text;  ///< [limits.slave]
  SlavePeaks of;     ///< the limits
};

/// Limits that the cam keeps by a ten-thousandth of a percent.
Limited just_kept(const std::string& master, double ramp) {
  const Input input = made("", master, "");
  SlavePeaks limits = peaks_of(std::get<Cam>(*input.curve), ramp);
  for (double* limit : {&limits.velocity, &limits.acceleration, &limits.jerk}) *limit *= 1 + 1e-6;
  return {"velocity = " + number(limits.velocity) +
              "\nacceleration = " + number(limits.acceleration) + "\njerk = " + number(limits.jerk),
          limits};
}

void expect_within(const SlavePeaks& table, const SlavePeaks& limits, const std::string& what) {
  EXPECT_LE(table.velocity, limits.velocity * (1 + 1e-9)) << what;
  EXPECT_LE(table.acceleration, limits.acceleration * (1 + 1e-9)) << what;
  EXPECT_LE(table.jerk, limits.jerk * (1 + 1e-6)) << what;
}

TEST(TableLimits, IntervalsThatExceedALimitOfTheSlaveAreDivided) {
  for (const double ramp : {0.0, 2000.0}) {
    const std::string master = ramp > 0 ? "acceleration = " + number(ramp) : "";
    const Limited limits = just_kept(master, ramp);
    for (const std::string table :
         {"", "knots = \"fewest\"", "tolerance = \"0.3 mm\"",
          "knots = \"fewest\"\ntolerance = \"0.3 mm\"", "tolerance = \"0.01 mm\""}) {
      const std::string what = master + " [table] " + table;
      const Input input = made(limits.text, master, table);
      const Report report = checked(input, 1, {});
      EXPECT_TRUE(report.ok()) << what << "\n" << full_text(report, input.labels);
      expect_within(peaks_of(input.table.table, ramp), limits.of, what);
    }
    // Without limits, this table would exceed them.
    const Input coarse = made("", master, "tolerance = \"0.3 mm\"");
    EXPECT_GT(peaks_of(coarse.table.table, ramp).acceleration, limits.of.acceleration * 1.0001);
  }
}

/// The broken finding of the table for this rule; a finding without a rule if there is none.
Finding of_table(const Report& report, const char* rule) {
  for (const Finding& f : report.findings)
    if (f.broken && f.axis == "table" && f.rule == rule) return f;
  return {};
}

TEST(TableLimits, AnExcessThatNoKnotMayRemoveIsAFinding) {
  const Limited limits = just_kept("", 0);
  for (const std::string table :
       {"intervals = 9", "most = 12", "tolerance = \"0.1 mm\"\nposition_resolution = \"0.01 mm\"",
        "tolerance = \"0.3 mm\"\nmaster_resolution = \"1 deg\""}) {
    const Input input = made(limits.text, "", table);
    const SlavePeaks peaks = peaks_of(input.table.table, 0);
    const Report report = check_all(input);
    EXPECT_FALSE(report.ok()) << table;
    for (const auto& [rule, peak, limit] :
         {std::tuple{"limit/acceleration", peaks.acceleration, limits.of.acceleration},
          std::tuple{"limit/jerk", peaks.jerk, limits.of.jerk}}) {
      const Finding f = of_table(report, rule);
      EXPECT_EQ(f.broken, peak > limit) << table << " " << rule;
      if (!f.broken) continue;
      EXPECT_NEAR(std::abs(f.value), peak, 1e-5 * peak) << table;
      EXPECT_NEAR(std::abs(f.limit), limit, 1e-9 * limit) << table;
    }
  }
}

TEST(TableLimits, AConvertedTableIsComparedWithTheLimitsOfItsSpec) {
  const Limited limits = just_kept("", 0);
  const Input input = made(limits.text, "", "");
  const ExchangeFormat& twincat = *exchange_format_named("twincat");
  // The knots stay, or more are added where a limit requires them.
  const Converted same = converted(input, {.rule = rule_of(twincat), .format = &twincat});
  EXPECT_TRUE(same.exceeded.findings.empty());
  expect_within(peaks_of(same.file.table, 0), limits.of, "twincat");
  const Converted few = converted(
      input, {.rule = Interpolation::quintic_hermite, .target = Target{.tolerance = 0.3}});
  EXPECT_TRUE(few.keeps());
  expect_within(peaks_of(few.file.table, 0), limits.of, "fewest");
  // Knots at whole steps are not divided.
  const Converted rounded_positions = converted(
      input,
      {.rule = Interpolation::quintic_hermite, .target = Target{.tolerance = 0.3, .p_step = 0.1}});
  EXPECT_TRUE(rounded_positions.within_limit());
  EXPECT_FALSE(rounded_positions.keeps());
  const SlavePeaks peaks = peaks_of(rounded_positions.file.table, 0);
  const Finding f = of_table(rounded_positions.exceeded, "limit/acceleration");
  EXPECT_NEAR(std::abs(f.value), peaks.acceleration, 1e-5 * peaks.acceleration);
  EXPECT_THAT(conversion_text(input, rounded_positions, {}, {}),
              HasSubstr("the table exceeds a limit that the motion keeps: "));
}

}  // namespace
}  // namespace jounce::table_limits_test
