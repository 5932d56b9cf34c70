// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/convert.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace jounce::convert_test {
namespace {

using testing::HasSubstr;

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

Input cam() {
  return read_inputs(examples + "pmc600-cam/cam.toml").front();
}

/// The table of the cam, without its spec and its curve.
Input cam_table() {
  return input_of(cam().table, "cam.csv");
}

TEST(Convert, ATableOfTheSameRuleIsUnchanged) {
  const Input table = cam_table();
  const Converted made = converted(table, {.rule = table.table.table.rule()});
  EXPECT_FALSE(made.error);
  EXPECT_EQ(made.file.table.columns().p, table.table.table.columns().p);
  EXPECT_EQ(error_text(made, table.labels), "the numbers are unchanged");
}

TEST(Convert, NewKnotsKeepTheirTolerance) {
  const Input input = cam();
  for (const double tolerance : {1.0, 0.1}) {
    const Converted made =
        converted(input, {.rule = Interpolation::linear,
                          .target = Target{.rule = Interpolation::linear, .tolerance = tolerance}});
    ASSERT_TRUE(made.error);
    EXPECT_LE(made.error->position, tolerance);
    EXPECT_GT(made.error->position, tolerance / 2) << "fewer knots would do";
  }
}

TEST(Convert, UnitsScaleBothColumns) {
  const Input input = read_inputs(examples + "rotary-knife/knife.toml").front();
  ASSERT_EQ(input.table.units.position, "deg");
  const Table& before = input.table.table;
  const Converted made =
      converted(input, {.rule = before.rule(), .units = {"mm", "rev"}, .periodic = true});
  EXPECT_EQ(made.file.units.x, "mm");
  EXPECT_NEAR(made.file.table.end(), 25.4 * before.end(), 1e-12 * made.file.table.end());
  EXPECT_NEAR(made.file.table.columns().p.back(), before.columns().p.back() / 360, 1e-12);
  EXPECT_EQ(made.file.table.outside(), Extrapolation::advance) << "a turn further each time";
}

TEST(Convert, NamesTheUnitThatIsWrong) {
  const Input input = read_inputs(examples + "rotary-knife/knife.toml").front();
  const auto key = [&](const Units& units) {
    return test::key_of(
        [&] { converted(input, {.rule = input.table.table.rule(), .units = units}); });
  };
  EXPECT_EQ(key({"furlong", ""}), "master_unit");
  EXPECT_EQ(key({"", "mm"}), "position_unit") << "an angle is no length";
  EXPECT_EQ(key({"m", "rad"}), "");
}

TEST(Convert, LossesNameTheRestOfTheSpec) {
  const Input input = cam();
  EXPECT_THAT(losses(input, std::nullopt, input.table.table),
              ::testing::ElementsAre(::testing::HasSubstr("stay in the spec")));
  EXPECT_EQ(losses(cam_table(), Format::xyva, input.table.table).size(), 0U);
  EXPECT_EQ(losses(cam_table(), Format::pairs, input.table.table).size(), 3U)
      << "positions only, no units, no period";
}

TEST(Convert, TheNameOrTheEndOfThePathIsTheForm) {
  EXPECT_EQ(table_form("", "cam.json").name, "json");
  EXPECT_EQ(table_form("", "-").name, "csv");
  EXPECT_EQ(table_form("", "cam.st").format, Format::codesys);
  EXPECT_EQ(table_form("points", "cam.st").name, "points") << "the name counts more";
  const TableFile table = cam_table().table;
  EXPECT_EQ(form_text({"csv"}, table), to_csv(table));
  EXPECT_EQ(form_text({"xyva", Format::xyva}, table), exchange_text(Format::xyva, table));
}

TEST(Convert, TheAnswerStatesTheErrorAndTheLosses) {
  const Input input = cam();
  const Converted made =
      converted(input, {.rule = Interpolation::linear,
                        .target = Target{.rule = Interpolation::linear, .tolerance = 1.0}});
  const std::string text = conversion_text(input, made, {"csv"}, {"laws stay in the spec"});
  EXPECT_THAT(text,
              HasSubstr("-> csv: " + std::to_string(made.file.table.size()) + " knots, linear\n"));
  EXPECT_THAT(text, HasSubstr("\nlaws stay in the spec\n"));
  EXPECT_THAT(conversion_json(made, {"csv"}, "cam.csv", {}), HasSubstr("\"lossless\":false"));
}

}  // namespace
}  // namespace jounce::convert_test
