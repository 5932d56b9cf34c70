// SPDX-License-Identifier: Apache-2.0
// The least peak of a segment between dwells, against the closed forms of a motion from rest to rest.
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "jounce/design/detail/file_check.hpp"

namespace jounce::slave_advice_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double stroke = 80;             // mm
constexpr double duration = 110.0 / 900;  // s

/// A rise of 80 mm over 110 deg between dwells, at 900 deg/s unless `speed` differs.
Report report_of(const std::string& limits, const std::string& more = "", double speed = 900) {
  const std::string text = fmt::format(
      "jounce = 1\nkind = \"cam\"\nperiodic = true\nunits = {{ master = \"deg\", position = \"mm\" "
      "}}\n"
      "start = {{ master = 0, slave = 0 }}\n"
      "[[segment]]\nlaw = \"dwell\"\nend = {{ master = 60, slave = 0 }}\n"
      "[[segment]]\nlaw = \"345\"\nend = {{ master = 170, slave = 80 }}\n"
      "[[segment]]\nlaw = \"dwell\"\nend = {{ master = 200, slave = 80 }}\n"
      "[[segment]]\nlaw = \"345\"\nend = {{ master = 360, slave = 0 }}\n{}"
      "[limits.slave]\n{}\n[master]\nvelocity = {}\n",
      more, limits, speed);
  return axis_report(inputs_of(parse_spec(text, "rise.toml"), "rise.toml").front());
}

std::string advice_of(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.broken && f.rule.text() == rule && f.segment && !f.advice.empty()) return f.advice;
  return "";
}

/// The number before this text, such as " mm/s^3 (law".
double number_before(const std::string& text, const std::string& what) {
  const auto end = text.find(what);
  if (end == std::string::npos) return 0;
  return std::stod(text.substr(text.rfind(' ', end - 1) + 1, end));
}

TEST(SlaveAdvice, TheLeastJerkFromRestToRestIsThatOfMinimumPeakJerk) {
  const double least = 32 * stroke / std::pow(duration, 3);
  const std::string above =
      advice_of(report_of(fmt::format("jerk = {}", 0.9 * least)), "limit/jerk");
  EXPECT_NEAR(number_before(above, " mm/s^3 (law = \"minimum_peak_jerk\" has it), above the limit"),
              least, 1e-5 * least)
      << above;
  const double slower = number_before(above, " deg/s, lengthen");
  EXPECT_NEAR(slower, 900 * std::cbrt(0.9), 0.01) << above;
  const std::string below =
      advice_of(report_of(fmt::format("jerk = {}", 1.1 * least)), "limit/jerk");
  EXPECT_NEAR(number_before(below, " mm/s^3 (law = \"minimum_peak_jerk\" has it)"), least,
              1e-5 * least);
  EXPECT_THAT(below, Not(HasSubstr("above the limit")));
}

TEST(SlaveAdvice, TheLeastJerkIsWithinTheLimitOfTheAcceleration) {
  // Acceleration rises, is constant, falls; then the same negatively: with ramps of A / J,
  // stroke = A (duration / 2 - A / J) duration / 2.
  const double a = 4.5 * stroke / (duration * duration);
  const double least = a / (duration / 2 - 2 * stroke / (a * duration));
  const std::string limits = fmt::format("acceleration = {}\njerk = {}", a, 0.3 * least);
  const std::string advice = advice_of(report_of(limits), "limit/jerk");
  EXPECT_NEAR(number_before(advice, " mm/s^3 (free = { shape = 60 }"), least, 1e-5 * least)
      << advice;
}

TEST(SlaveAdvice, ALimitBelowTheParabolaHasNoMotion) {
  const double parabola = 4 * stroke / (duration * duration);
  const std::string limits = fmt::format("acceleration = {}", 0.95 * parabola);
  const std::string advice = advice_of(report_of(limits), "limit/acceleration");
  EXPECT_NEAR(number_before(advice, " mm/s^2 (free"), parabola, 1e-5 * parabola) << advice;
  EXPECT_NEAR(number_before(advice, " deg/s, lengthen"), 900 * std::sqrt(0.95), 0.01) << advice;
}

TEST(SlaveAdvice, ASegmentHasOneRemedy) {
  const Report report = report_of("acceleration = 10000\njerk = 100000");
  int remedies = 0;
  for (const Finding& f : report.findings)
    if (f.broken && f.advice.find("the segment moves 80 mm in 110 deg") != std::string::npos)
      ++remedies;
  EXPECT_EQ(remedies, 1);
}

}  // namespace
}  // namespace jounce::slave_advice_test
