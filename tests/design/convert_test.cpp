// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/convert.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/io/detail/samples_csv.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::convert_test {
namespace {

using testing::Contains;
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

// The controller lays a spline through the points; Jounce reads straight lines.
TEST(Convert, NamesTheSplineThatItDoesNotRead) {
  const Converted made =
      converted(cam_table(), {.rule = Interpolation::linear,
                              .intervals = 90,
                              .format = exchange_format_named("siemens-points")});
  const TableForm points = table_form("siemens-points", "");
  const test::TemporaryFolder folder;
  const std::string file = folder / "cam.sp";
  write_file(file, form_text(points, made.file));
  const Input read = read_inputs(file).front();
  EXPECT_THAT(all_losses(read, table_form("", "cam.csv"), read.table.table),
              Contains(HasSubstr("straight lines between them")));
}

// CODESYS: with an absolute slave, a cam that advances would jump back at the end of each period.
TEST(Convert, TheSlaveOfACamThatAdvancesIsRelative) {
  const auto text = [](double end, Extrapolation outside) {
    const TableFile file{Table(Domain::master, Interpolation::quintic_hermite, outside,
                               {{0, 360}, {0, end}, {0, 0}, {0, 0}}),
                         {"deg", "deg"},
                         {}};
    return form_text(table_form("codesys", ""), file);
  };
  EXPECT_THAT(text(45, Extrapolation::advance), HasSubstr("SlaveAbsolute := FALSE"));
  EXPECT_THAT(text(0, Extrapolation::advance), HasSubstr("SlaveAbsolute := TRUE"));
  EXPECT_THAT(text(45, Extrapolation::hold), HasSubstr("SlaveAbsolute := TRUE"));
}

TEST(Convert, AChangeOfUnitsIsNamed) {
  const Input knife = read_inputs(examples + "rotary-knife/knife.toml").front();
  const Input input = input_of(knife.table, "knife.csv");
  const auto text = [&](const Units& units) {
    return error_text(converted(input, {.rule = input.table.table.rule(), .units = units}),
                      input.labels);
  };
  ASSERT_EQ(input.table.units.x, "in");
  EXPECT_EQ(text({"", "rev"}),
            "the numbers are converted from deg to rev, without any other change");
  EXPECT_EQ(
      text({"mm", "rev"}),
      "the numbers are converted from in to mm and from deg to rev, without any other change");
}

TEST(Convert, ATableOverTimeHasNoFormatOfAController) {
  const Input input = read_inputs(examples + "hmpl-pvt/pvt.toml").front();
  ASSERT_EQ(input.table.table.axis(), Domain::time);
  for (const char* word : {"rockwell", "siemens-points", "kollmorgen"}) {
    const ExchangeFormat* to = exchange_format_named(word);
    const auto make = [&] { converted(input, {.rule = rule_of(*to), .format = to}); };
    EXPECT_EQ(test::key_of(make), "format");
    EXPECT_EQ(
        test::rule_of(make),
        "is for cams, over a master; this table is over time: choose the format ros, xps, zaber, "
        "galil-pvt, googol-pt, googol-pt-st or hmpl");
  }
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

TEST(Convert, AnotherRuleHasTheDefaultTolerance) {
  const Input input = cam_table();
  const Converted coarse = converted(input, {.rule = Interpolation::linear});
  ASSERT_TRUE(coarse.limit);
  const Range travel = extrema(std::get<Cam>(*input.curve), 0);
  EXPECT_DOUBLE_EQ(*coarse.limit, 1e-4 * (travel.max.value - travel.min.value));
  EXPECT_FALSE(coarse.within_limit());
  EXPECT_THAT(conversion_text(input, coarse, {}, {}), HasSubstr("the error exceeds the tolerance"));
  const Converted chosen = converted(input, {.rule = Interpolation::linear, .intervals = 5});
  EXPECT_EQ(chosen.limit, coarse.limit);
  EXPECT_EQ(test::key_of([&] {
              converted(input, {.rule = Interpolation::linear,
                                .target = Target{.rule = Interpolation::linear, .tolerance = 1.0},
                                .intervals = 5});
            }),
            "intervals");
}

TEST(Convert, ANumPyArrayHasTheColumns) {
  const TableFile table = cam_table().table;
  const std::string bytes = form_text(table_form("", "cam.npy"), table);
  EXPECT_EQ(bytes.substr(1, 5), "NUMPY");
  EXPECT_THAT(bytes, HasSubstr("[('master', '<f8'), ('position', '<f8'), ('geo_velocity', '<f8'), "
                               "('geo_acceleration', '<f8')]"));
  EXPECT_THAT(bytes, HasSubstr("'shape': (" + std::to_string(table.table.size()) + ",)"));
  const std::size_t data = bytes.find('\n') + 1;
  EXPECT_EQ(data % 64, 0U);
  ASSERT_EQ(bytes.size() - data, table.table.size() * 4 * sizeof(double));
  const auto number = [&](std::size_t row, std::size_t column) {
    double value = 0;
    std::memcpy(&value, bytes.data() + data + (4 * row + column) * sizeof value, sizeof value);
    return value;
  };
  const Columns& c = table.table.columns();
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    EXPECT_EQ(number(i, 0), c.x[i]);
    EXPECT_EQ(number(i, 1), c.p[i]);
    EXPECT_EQ(number(i, 3), c.a[i]);
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
  EXPECT_EQ(key({"", "s"}), "position_unit") << "a time is no position";
  EXPECT_EQ(key({"m", "rad"}), "");
}

TEST(Convert, LossesNameTheRestOfTheSpec) {
  const Input input = cam();
  EXPECT_THAT(losses(input, nullptr, input.table.table),
              ::testing::ElementsAre(::testing::HasSubstr("stay in the spec")));
  EXPECT_EQ(losses(cam_table(), exchange_format_named("xyva"), input.table.table).size(), 0U);
  EXPECT_EQ(losses(cam_table(), exchange_format_named("pairs"), input.table.table).size(), 3U)
      << "positions only, no units, no period";
}

TEST(Convert, TheNameOrTheEndOfThePathIsTheForm) {
  EXPECT_EQ(table_form("", "cam.json").name, "json");
  EXPECT_EQ(table_form("", "-").name, "csv");
  EXPECT_EQ(table_form("", "cam.st").format, exchange_format_named("codesys"));
  EXPECT_EQ(table_form("points", "cam.st").name, "points") << "the name counts more";
  const TableFile table = cam_table().table;
  EXPECT_EQ(form_text({}, table), to_csv(table));
  EXPECT_EQ(form_text(table_form("xyva", ""), table),
            exchange_text(*exchange_format_named("xyva"), table));
}

TEST(Convert, TheAnswerStatesTheErrorAndTheLosses) {
  const Input input = cam();
  const Converted made =
      converted(input, {.rule = Interpolation::linear,
                        .target = Target{.rule = Interpolation::linear, .tolerance = 1.0}});
  const std::string text = conversion_text(input, made, {}, {"laws stay in the spec"});
  EXPECT_THAT(text,
              HasSubstr("-> csv: " + std::to_string(made.file.table.size()) + " knots, linear\n"));
  EXPECT_THAT(text, HasSubstr("\nlaws stay in the spec\n"));
  EXPECT_THAT(conversion_json(made, {}, "cam.csv", {}), HasSubstr("\"lossless\":false"));
}

/// 40 mm by 3-4-5 over 0 to 120 deg, a dwell to 180, back until 300, a dwell to 360.
Input cam_e() {
  return input_of(
      {Table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
             {{0, 120, 180, 300, 360}, {0, 40, 40, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}),
       {"deg", "mm"},
       {}},
      "e.csv");
}

Converted exported(const Input& input, const char* format, std::size_t intervals) {
  const ExchangeFormat* to = exchange_format_named(format);
  return converted(input, {.rule = rule_of(*to), .intervals = intervals, .format = to});
}

TEST(Convert, StatesTheErrorOfEachControllersCurve) {
  // The notes on formats give the losses at one point a degree: 2.0 um by lines, 0.32 nm by a spline.
  EXPECT_NEAR(exported(cam_e(), "pairs", 360).error->position, 2.0e-3, 0.05e-3);
  EXPECT_NEAR(exported(cam_e(), "siemens-points", 360).error->position, 0.32e-6, 0.01e-6);
  EXPECT_FALSE(exported(cam_e(), "twincat", 0).error) << "the five knots are exact";
  EXPECT_FALSE(exported(cam_e(), "siemens", 0).error);
}

TEST(Convert, TheSplineOfALogixControllerIsTheTable) {
  const Input input = cam_e();
  const Converted made = exported(input, "rockwell", 360);
  const Columns& c = made.file.table.columns();
  for (const double value : c.p) EXPECT_EQ(value, static_cast<double>(static_cast<float>(value)));
  EXPECT_EQ(c.v.front(), 0);
  EXPECT_EQ(c.v.back(), 0);
  const Cam spline = made.file.table.curve<OverMaster>();
  const Cam& given = std::get<Cam>(*input.curve);
  double greatest = 0;
  for (int i = 0; i <= 36000; ++i)
    greatest =
        std::max(greatest, std::abs(spline.at(0.01 * i).position - given.at(0.01 * i).position));
  EXPECT_LE(greatest, made.error->position);
  EXPECT_GT(greatest, 0.9 * made.error->position);
  EXPECT_LT(made.error->position, 3e-6) << "half a unit of a REAL at 40 is 1.9e-6";
  for (std::size_t i = 1; i + 1 < c.x.size();
       ++i)  // C2: both cubics have one acceleration at a knot
    EXPECT_NEAR(spline.at(c.x[i], Side::left).geo_acceleration,
                spline.at(c.x[i], Side::right).geo_acceleration, 1e-12);
}

TEST(Convert, AToleranceHoldsForTheSpline) {
  const Input input = cam_e();
  for (const char* word : {"rockwell", "siemens-points", "kollmorgen"}) {
    SCOPED_TRACE(word);
    const ExchangeFormat* to = exchange_format_named(word);
    const Converted made =
        converted(input, {.rule = rule_of(*to),
                          .target = Target{.rule = rule_of(*to), .tolerance = 0.01},
                          .format = to});
    EXPECT_LE(made.error->position, 0.01);
  }
}

TEST(Convert, NamesAMissingUnitAndAnInterpolation) {
  TableFile table = cam_table().table;
  EXPECT_EQ(test::key_of([&] { require_units(table); }), "");
  EXPECT_EQ(samples_csv(table, "0.5 " + table.units.x), samples_csv(table, 0.5));
  EXPECT_EQ(test::error_of([&] { samples_csv(table, "1 furlong"); }).substr(0, 5), "every");
  EXPECT_EQ(test::key_of([&] { samples_csv(table, "-1"); }), "every");
  table.units.position = "";
  EXPECT_EQ(test::key_of([&] { require_units(table); }), "position_unit");
  table.units.x = "";
  EXPECT_THAT(test::error_of([&] { require_units(table); }),
              HasSubstr("master_unit: is missing, and --position-unit, too: "));
  EXPECT_EQ(interpolation_named("quintic_hermite"), Interpolation::quintic_hermite);
  EXPECT_EQ(interpolation_named(""), std::nullopt);
}

}  // namespace
}  // namespace jounce::convert_test
