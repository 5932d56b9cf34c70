// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/file_check.hpp"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/controllers/table_target.hpp"
#include "jounce/design/convert.hpp"
#include "jounce/design/detail/law_guide.hpp"
#include "jounce/design/files/file_difference.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::file_check_test {
namespace {

using testing::HasSubstr;

const Labels over_time{{"s", "mm"}, false, {}};

/// The key and the rule of the error of an action; "" without one.
std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.key() + ": " + error.rule();
  }
  return "";
}

std::vector<Input> cam() {
  return inputs_of(parse_spec(R"(
jounce = 1
kind = "cam"
start = { master = 0, slave = 0 }
[units]
master = "deg"
position = "mm"
[[segment]]
law = "quintic"
end = { master = 180, slave = 10 }
[[segment]]
law = "quintic"
end = { master = 360, slave = 0 }
)",
                              "cam.toml"),
                   "cam.toml");
}

TEST(FileCheck, SetsLimitsInTheUnitsOfTheMotion) {
  Limits limits;
  set_limits(limits, {"velocity=3 m/s", "position_max=12"}, over_time);
  EXPECT_DOUBLE_EQ(limits.velocity.value(), 3000);
  EXPECT_EQ(limits.position_max, 12);
}

TEST(FileCheck, RejectsALimitByItsName) {
  Limits limits;
  EXPECT_THAT(error_of([&] { set_limits(limits, {"velocty=3"}, over_time); }),
              testing::AllOf(HasSubstr("limit: "), HasSubstr("did you mean velocity?")));
  EXPECT_THAT(error_of([&] { set_limits(limits, {"velocity=3 kg"}, over_time); }),
              HasSubstr("limit velocity: "));
  EXPECT_THAT(error_of([&] {
                set_limits(limits, {"position_min=2", "position_max=1"}, over_time);
              }),
              HasSubstr("limit position_"));
}

TEST(FileCheck, NeedsACouplingForItsStart) {
  const Input input = cam().front();
  EXPECT_FALSE(engage_state(input, {}).slave);
  EXPECT_THAT(error_of([&] { engage_state(input, {.master_velocity = "3"}); }),
              HasSubstr("master_velocity: applies to a spec with [coupling]"));
  Input over_time = cam().front();
  over_time.labels.over_master = false;
  EXPECT_THAT(error_of([&] { engage_state(over_time, {.master_velocity = "3"}); }),
              HasSubstr("master_velocity: applies to a cam, and this motion is over time"));
}

TEST(FileCheck, IsGoodIfEachReportIs) {
  const std::vector<Input> axes = cam();
  const FileCheck good = file_check(axes, {axis_report(axes.front())});
  EXPECT_TRUE(good.ok());
  EXPECT_FALSE(good.ok(true)) << "a spec without limits is a warning";
  EXPECT_FALSE(good.path);
  std::vector<Input> limited = cam();
  set_limits(limited.front().limits, {"geo_velocity=1e-3"}, limited.front().labels);
  const FileCheck broken = file_check(limited, {axis_report(limited.front())});
  EXPECT_FALSE(broken.ok());
  EXPECT_THAT(file_check_json(broken, limited), HasSubstr("\"ok\":false"));
}

TEST(FileDifference, ComparesTheAxesOfTwoFiles) {
  const auto rounding = [](const Labels&) { return Tolerance{}; };
  const FileDifference same = file_difference(cam(), cam(), "a.toml", "b.toml", rounding);
  EXPECT_TRUE(same.equal());
  EXPECT_THAT(to_json(same), HasSubstr("\"equal\":true"));
}

TEST(FileDifference, ALimitOfAnySectionIsADifference) {
  const auto rounding = [](const Labels&) { return Tolerance{}; };
  const std::string head =
      "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n"
      "start = { master = 0, slave = 0 }\n[[segment]]\nlaw = \"345\"\n";
  const std::string rise = "end = { master = 60, slave = 50 }\n";
  const auto difference = [&](const std::string& before, const std::string& after) {
    return file_difference(inputs_of(parse_spec(head + before, "a.toml"), "a.toml"),
                           inputs_of(parse_spec(head + after, "b.toml"), "b.toml"), "a.toml",
                           "b.toml", rounding);
  };
  const std::string slave = rise + "[limits.slave]\nacceleration = ";
  const FileDifference limit = difference(slave + "\"16 m/s^2\"\n", slave + "\"160 m/s^2\"\n");
  EXPECT_FALSE(limit.equal());
  EXPECT_THAT(to_text(limit), testing::AllOf(HasSubstr("they differ"),
                                             HasSubstr("  ! limit slave.acceleration: 16 m/s^2 -> "
                                                       "160 m/s^2\n")));
  EXPECT_FALSE(difference(slave + "16\n", rise).equal()) << "a removed limit";
  const std::string disc = "[disc]\nroller_radius = 12\nbase_radius = ";
  const FileDifference plate = difference(rise + disc + "60\n", rise + disc + "50\n");
  EXPECT_TRUE(plate.equal()) << "the motion is the same";
  EXPECT_THAT(to_text(plate),
              HasSubstr("  ~ differs outside the curve: disc.base_radius 60 mm -> 50 mm\n"));
  EXPECT_THAT(to_text(plate),
              HasSubstr("equal except for rounding, but disc.base_radius differs\n"));
  EXPECT_THAT(to_text(difference(rise + disc + "60\n", rise)),
              HasSubstr("equal except for rounding, but 2 keys outside the curve differ\n"));
  EXPECT_THAT(to_text(difference(rise, rise)), HasSubstr("equal except for rounding\n"));
  EXPECT_THAT(to_json(plate), HasSubstr("\"keys\":[{\"key\":\"disc.base_radius\""));
  const FileDifference higher =
      difference(rise, "end = { master = 60, slave = 51 }\n" + disc + "60\n");
  EXPECT_THAT(to_text(higher),
              HasSubstr("outside the curve: disc.roller_radius none -> 12 mm; disc."
                        "base_radius none -> 60 mm\n"))
      << "the comparison of the curves covers the segment";
  const std::string limits = "[limits]\ngeo_velocity = ";
  EXPECT_THAT(to_text(difference(rise + limits + "2\n", rise + limits + "3\n")),
              testing::AllOf(HasSubstr("! limit geo_velocity: 2 mm/deg -> 3 mm/deg"),
                             testing::Not(HasSubstr("limits.geo"))))
      << "reported once";
}

TEST(TargetTexts, AreReadInTheUnitsOfTheTable) {
  const TargetTexts texts{.tolerance = "10 um", .most = 50, .x_step = "1 ms"};
  EXPECT_TRUE(texts.any());
  EXPECT_FALSE(TargetTexts{}.any());
  const Target target = target_of(texts, Domain::time, Interpolation::cubic_hermite, {"s", "mm"});
  EXPECT_DOUBLE_EQ(target.tolerance.value(), 0.01);
  EXPECT_DOUBLE_EQ(target.x_step, 1e-3);
  EXPECT_EQ(target.most, 50U);
  const auto dashed = [](const std::string& member) { return "--" + member; };
  EXPECT_THAT(
      error_of([&] {
        target_of({.tolerance = "1 kg"}, Domain::time, Interpolation::linear, {"s", "mm"}, dashed);
      }),
      HasSubstr("--tolerance: "));
  EXPECT_THAT(error_of([&] {
                target_of({.controller = "googel"}, Domain::time, Interpolation::linear,
                          {"s", "mm"}, dashed);
              }),
              HasSubstr("--controller: must be one of "));
}

TEST(Laws, AreFoundByTheirNames) {
  EXPECT_EQ(law_of("quintic"), Law::quintic);
  EXPECT_THAT(error_of([] { law_of("quintc"); }),
              HasSubstr("law: is not a law: did you mean quintic?"));
}

TEST(Conversion, ReadsItsFileEndings) {
  EXPECT_TRUE(has_known_ending("cam.csv"));
  EXPECT_TRUE(has_known_ending("-"));
  EXPECT_FALSE(has_known_ending("cam.pdf"));
  EXPECT_EQ(test::error_of([] { require_known_ending("cam.toml", "cam.csv"); }),
            "path = cam.toml: would be a spec, but convert writes tables: to make the spec of a "
            "cam, use `jounce fit cam.csv -o cam.toml`");
  EXPECT_EQ(test::error_of([] { require_known_ending("b.toml", "a.toml"); }),
            "path = b.toml: would be a spec, but convert writes tables: choose another ending, "
            "such as .csv");
  EXPECT_THAT(known_endings(), HasSubstr(".csv, .json, ."));
}

}  // namespace
}  // namespace jounce::file_check_test
