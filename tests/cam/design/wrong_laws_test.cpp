// SPDX-License-Identifier: Apache-2.0
// Laws that a public "VDI 2143" library ships and that its own tests let pass, as tables of 360
// intervals with the columns position, velocity, acceleration as the library's formulas give them.

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "jounce/cam/design/certificate.hpp"
#include "jounce/cam/design/characteristics.hpp"
#include "jounce/cam/design/warnings.hpp"
#include "jounce/pvt/table.hpp"

#include "cam/laws/laws.hpp"

namespace jounce::wrong_laws_test {
namespace {

constexpr double pi = std::numbers::pi;

struct Row {
  double p, v, a;
};

/// Starts with f'' = 1.14; f jumps from 0.455 to 1.004 at 7/8.
Row modified_sine(double z) {
  const double m = (4 + pi) / (2 * pi);
  const double n = (8 + pi) / (2 * pi);
  const auto ramp = [&](double x) {
    return Row{m * x * x / 2 - std::sin(4 * pi * x) / (8 * pi * pi),
               m * x + (1 - std::cos(4 * pi * x)) / (2 * pi), m + 2 * std::sin(4 * pi * x)};
  };
  if (z <= 0.125) return ramp(z);
  if (z > 0.875) {
    const double x = 1 - z;
    return {1 - m * x * x / 2 + std::sin(4 * pi * x) / (8 * pi * pi),
            m * x - (1 - std::cos(4 * pi * x)) / (2 * pi), -m + 2 * std::sin(4 * pi * x)};
  }
  const double u = z - 0.125;
  const double q = 4 * pi * u / 3;
  const double v1 = m / 8 + 1 / pi;
  return {m / 128 + v1 * u + n * 9 / (32 * pi * pi) * (1 - std::cos(q)), v1 + n / pi * std::sin(q),
          n * std::cos(q)};
}

/// f'' steps from 2.44 to 4.89 at 1/8; f(1/2) = 0.3125.
Row modified_trapezoid(double z) {
  if (z > 0.625) {
    const Row mirrored = modified_trapezoid(1 - z);
    return {1 - mirrored.p, mirrored.v, -mirrored.a};
  }
  const double k = 4 * pi / (2 + pi);
  const double t = 4 * pi * z;
  if (z <= 0.125)
    return {k / (4 * pi) * (2 * pi * z * z - (1 - std::cos(t)) / (4 * pi)),
            k / (4 * pi) * (t - std::sin(t)), k * (1 - std::cos(t))};
  if (z <= 0.375) {
    const double u = z - 0.125;
    return {k / 128 + k * u / 8 + k * u * u, k / 8 + 2 * k * u, 2 * k};
  }
  return {z / 2 + z * z / 4, 1 + k / (8 * pi * pi) * std::cos(8 * pi * (z - 0.375)),
          2 * k * std::cos(pi * (z - 0.5))};
}

/// Starts with f'' = -pi^2 / 2 instead of 0.
Row double_harmonic(double z) {
  return {(1 - std::cos(pi * z)) / 2 - (1 - std::cos(2 * pi * z)) / 4,
          pi / 2 * (std::sin(pi * z) - std::sin(2 * pi * z)),
          pi * pi / 2 * std::cos(pi * z) - pi * pi * std::cos(2 * pi * z)};
}

constexpr int intervals = 360;

Cam as_table(const std::function<Row(double)>& law) {
  Columns columns;
  for (int i = 0; i <= intervals; ++i) {
    const double z = static_cast<double>(i) / intervals;
    const Row row = law(z);
    columns.x.push_back(z);
    columns.p.push_back(row.p);
    columns.v.push_back(row.v);
    columns.a.push_back(row.a);
  }
  return Table(Domain::master, Interpolation::quintic_hermite, Extrapolation::hold, columns)
      .curve<OverMaster>();
}

std::size_t count(const Report& report, const std::string& rule) {
  std::size_t n = 0;
  for (const Finding& f : report.findings) n += f.rule == rule ? 1 : 0;
  return n;
}

TEST(WrongLaws, TheModifiedSineThatJumps) {
  const Report odd = warnings(as_table(modified_sine));
  EXPECT_GE(count(odd, "warning/ripple"), 1U) << "columns that are not each other's derivatives";
  EXPECT_GE(count(odd, "joint/geo_acceleration"), 2U) << "f'' is not 0 at the ends";
  double at_ends = 0;
  for (const Finding& f : odd.findings)
    if (f.rule == "joint/geo_acceleration") at_ends = f.value;
  EXPECT_NEAR(at_ends, (4 + pi) / (2 * pi), 1e-9);
  const Characteristics c = characteristics(as_table(modified_sine));
  EXPECT_GT(c.cv.value, 100) << "half the stroke within one interval";
}

TEST(WrongLaws, TheModifiedTrapezoidThatSteps) {
  const Report odd = warnings(as_table(modified_trapezoid));
  EXPECT_GE(count(odd, "warning/ripple"), 10U);
  const Characteristics c = characteristics(as_table(modified_trapezoid));
  EXPECT_GT(c.peak_acceleration(), 10 * 4.888124);
}

TEST(WrongLaws, TheDoubleHarmonicThatStartsWithAKick) {
  const Report odd = warnings(as_table(double_harmonic));
  ASSERT_GE(count(odd, "joint/geo_acceleration"), 2U);
  bool kick = false;
  for (const Finding& f : odd.findings)
    kick = kick || (f.rule == "joint/geo_acceleration" && f.where == 0 &&
                    std::abs(f.value - pi * pi / 2) < 1e-9);
  EXPECT_TRUE(kick);
}

TEST(WrongLaws, TheRightOnesPassAsTables) {
  for (const char* name : {"modified_sine", "modified_trapezoid", "inclined_sine", "poly_345",
                           "poly_4567", "gutman_13"}) {
    const Cam law = test::laws().at(name);
    const Cam table = as_table([&](double z) {
      const Jet jet = law.jet(z, z < 1 ? Side::right : Side::left);
      return Row{jet[0], jet[1], std::abs(jet[2]) < 1e-12 ? 0 : jet[2]};
    });
    const Report report = warnings(table);
    EXPECT_EQ(report.warnings(), 0U)
        << name << ": " << report.findings.front().rule << " at " << report.findings.front().where;
    EXPECT_TRUE(certificates(table).ok()) << name;
  }
}

}  // namespace
}  // namespace jounce::wrong_laws_test
