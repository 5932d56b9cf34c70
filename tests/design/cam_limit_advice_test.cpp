// SPDX-License-Identifier: Apache-2.0
// The remedies for broken limits of a cam: each number of an advice is put into the spec, and checked again.
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "jounce/design/detail/file_check.hpp"

namespace jounce::cam_limit_advice_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A rise and a return of 50 mm with dwells, in 360 deg.
struct Shape {
  std::string law = "345";
  double rise = 120;  // deg
  double back = 150;  // deg
};

Report report_of(const Shape& shape, const std::string& limits) {
  std::string text = fmt::format(
      "jounce = 1\nkind = \"cam\"\nperiodic = true\nunits = {{ master = \"deg\", position = \"mm\" "
      "}}\nstart = {{ master = 0, slave = 0 }}\n[[segment]]\nname = \"rise\"\nlaw = \"{}\"\n"
      "end = {{ master = {}, slave = 50 }}\n",
      shape.law, shape.rise);
  if (shape.rise + shape.back < 360)
    text += fmt::format("[[segment]]\nlaw = \"dwell\"\nend = {{ master = {}, slave = 50 }}\n",
                        360 - shape.back);
  text += fmt::format(
      "[[segment]]\nname = \"return\"\nlaw = \"{}\"\nend = {{ master = 360, slave = 0 "
      "}}\n[limits]\n{}",
      shape.law, limits);
  return axis_report(inputs_of(parse_spec(text, "cam.toml"), "cam.toml").front());
}

std::vector<Finding> broken(const Shape& shape, const std::string& limits) {
  std::vector<Finding> all;
  for (const Finding& f : report_of(shape, limits).findings)
    if (f.broken) all.push_back(f);
  return all;
}

/// The number after this text.
double number_after(const std::string& text, const std::string& what) {
  const auto at = text.find(what);
  return at == std::string::npos ? 0 : std::stod(text.substr(at + what.size()));
}

TEST(CamLimitAdvice, ALengthKeepsAllLimitsOfItsSegment) {
  const std::string limits = "geo_velocity = 0.75\ngeo_acceleration = 0.018\n";
  const std::vector<Finding> found = broken({}, limits);
  ASSERT_EQ(found.size(), 3U) << "velocity, acceleration up and down";
  for (const Finding& f : found) {
    EXPECT_EQ(number_after(f.advice, "lengthen the segment to at least "),
              number_after(found.front().advice, "to at least "));
    EXPECT_THAT(f.advice, Not(HasSubstr("law"))) << "no law keeps both";
  }
  const double length = number_after(found.front().advice, "to at least ");
  EXPECT_EQ(broken({.rise = length}, limits).size(), 0U) << length;
  EXPECT_NE(broken({.rise = length - 0.2}, limits).size(), 0U) << "it is the least";
}

TEST(CamLimitAdvice, ALawKeepsTheLimits) {
  const std::string limits = "geo_velocity = 0.7\n";
  const std::vector<Finding> found = broken({}, limits);
  ASSERT_EQ(found.size(), 1U);
  const std::string& advice = found.front().advice;
  EXPECT_THAT(advice, HasSubstr(" instead of 1.875)"));
  EXPECT_EQ(number_after(advice, "(Cv ") <= 0.7 * 120 / 50, true) << advice;
  const auto from = advice.find('"') + 1;
  const std::string law = advice.substr(from, advice.find('"', from) - from);
  EXPECT_EQ(broken({.law = law}, limits).size(), 0U) << law;
}

TEST(CamLimitAdvice, SegmentsThatDoNotFitTogetherGetTheLeastLimit) {
  const std::vector<Finding> found = broken({}, "geo_velocity = 0.5\n");
  ASSERT_EQ(found.size(), 2U);
  for (const Finding& f : found)
    EXPECT_THAT(
        f.advice,
        HasSubstr("together, the segments 1 rise, 3 return need 375 deg, but the cam has only "
                  "360 deg for them, dwells included: raise the limit to at least "));
  const double now = number_after(found.front().advice, "raise the limit to at least ");
  EXPECT_EQ(broken({}, fmt::format("geo_velocity = {}\n", now)).size(), 0U);
  const double least = number_after(found.front().advice, ", or to ");
  EXPECT_NEAR(least, 1.875 * 100 / 360, 1e-4);
  EXPECT_EQ(broken({.rise = 180, .back = 180}, fmt::format("geo_velocity = {}\n", least)).size(),
            0U);
}

TEST(CamLimitAdvice, AMeanAboveTheLimitGetsALengthForItsLaw) {
  const std::vector<Finding> found = broken({.rise = 60}, "geo_velocity = 0.7\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found.front().advice, HasSubstr("its mean geo_velocity is 0.8333 mm/deg"));
  const double length = number_after(found.front().advice, "Lengthen the segment to at least ");
  EXPECT_EQ(broken({.rise = length}, "geo_velocity = 0.7\n").size(), 0U) << length;
}

}  // namespace
}  // namespace jounce::cam_limit_advice_test
