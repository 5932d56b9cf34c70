// SPDX-License-Identifier: Apache-2.0
// A cam whose speed and limits are given over time: the press pusher of the examples.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/design/detail/cam_check.hpp"
#include "jounce/design/detail/diagnostics.hpp"
#include "jounce/design/over_time.hpp"

#include "design/src/check/check_text.hpp"

namespace jounce::slave_units_test {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

const std::string pusher_file = JOUNCE_SOURCE_DIR "/examples/press-pusher/pusher.toml";

/// The pusher with other text in place of all `what`.
Input pusher(const std::string& what = "", const std::string& with = "") {
  std::string text = read_file(pusher_file);
  for (std::size_t at = 0; !what.empty() && (at = text.find(what, at)) != std::string::npos;
       at += with.size())
    text.replace(at, what.size(), with);
  return inputs_of(parse_spec(text, "pusher.toml"), "pusher.toml").front();
}

Finding finding(const Report& report, const char* rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return f;
  ADD_FAILURE() << rule;
  return {};
}

// The modified sine: Cv = 4 pi / (4 + pi), Ca = 4 pi^2 / (4 + pi). A rise of 40 mm takes 0.125 s.
TEST(SlaveUnits, ALimitIsCheckedAndReportedInItsUnit) {
  const Report report = checked(pusher());
  EXPECT_TRUE(report.ok());
  const Finding v = finding(report, "limit/velocity");
  EXPECT_EQ(v.unit, "m/s");
  EXPECT_NEAR(v.value, 4 * pi / (4 + pi) * 0.04 / 0.125, 1e-12);
  EXPECT_NEAR(v.limit, 1, 1e-15);
  const Finding a = finding(report, "limit/acceleration");
  EXPECT_EQ(a.unit, "m/s^2");
  EXPECT_NEAR(std::abs(a.value), 4 * pi * pi / (4 + pi) * 0.04 / (0.125 * 0.125), 1e-11);
  EXPECT_NEAR(std::abs(a.limit), 15, 1e-13);
}

TEST(SlaveUnits, ABrokenLimitNamesTheSlaveAndTheSpeedThatKeepsIt) {
  const Input input = pusher("modified_sine", "inclined_sine");
  const Report report = checked(input);
  EXPECT_FALSE(report.ok());
  const double peak = 2 * pi * 0.04 / (0.125 * 0.125);
  const Finding& worst = report.findings.front();
  EXPECT_EQ(worst.rule, "limit/acceleration");
  EXPECT_NEAR(std::abs(worst.value), peak, 1e-11);
  EXPECT_EQ(worst.segment, 0U);
  const std::string text = check_text(report, input);
  EXPECT_THAT(text, HasSubstr("acceleration 16.085 m/s^2 at 22.5 deg (segment 1 rise) exceeds the "
                              "limit 15 m/s^2 by 7.23 %"));
  // 120 sqrt(15 / 16.085)
  EXPECT_THAT(text, HasSubstr("slow the master down to 115.882 cpm"));
  EXPECT_THAT(text, HasSubstr("fastest master 115.882 cpm"));
  const Finding master = finding(report, "limit/master_velocity");
  EXPECT_NEAR(master.value, 120, 1e-12);
  EXPECT_NEAR(master.limit, 120 * std::sqrt(15 / peak), 1e-9);
  EXPECT_EQ(master.unit, "cpm");
  const auto all = diagnostics_of(report, input, "pusher.toml");
  EXPECT_EQ(all.front().key, "segment[1]");
  EXPECT_GT(all.front().limit_place.line, 0) << "of limits.slave.acceleration";
}

TEST(SlaveUnits, TheMasterIsReportedAsItIsGiven) {
  for (const auto& [given, unit, value] : {std::tuple{"\"120 rpm\"", "rpm", 120.0},
                                           {"\"2 rev/s\"", "rev/s", 2.0},
                                           {"\"120 1/min\"", "1/min", 120.0},
                                           {"\"2 Hz\"", "Hz", 2.0},
                                           {"720", "deg/s", 720.0}}) {
    const Finding f = finding(checked(pusher("\"120 cpm\"", given)), "limit/master_velocity");
    EXPECT_EQ(f.unit, unit);
    EXPECT_NEAR(f.value, value, 1e-12 * value) << given;
  }
}

TEST(SlaveUnits, APlainNumberStaysInTheUnitOfTheSpec) {
  const Report report = checked(pusher("\"15 m/s^2\"", "14000"));
  const Finding& worst = report.findings.front();
  EXPECT_EQ(worst.unit, "mm/s^2");
  EXPECT_DOUBLE_EQ(std::abs(worst.limit), 14000);
}

TEST(SlaveUnits, APictureOverTimeHasTheseUnits) {
  const Input slave = over_time(pusher());
  EXPECT_EQ(slave.rate_units, (std::array<std::string, 3>{"m/s", "m/s^2", "mm/s^3"}));
}

}  // namespace
}  // namespace jounce::slave_units_test
