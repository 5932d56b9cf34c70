// SPDX-License-Identifier: Apache-2.0
// Cams that are made from others, against tests/oracle/cam_then.json.
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/design/detail/cam_check.hpp"
#include "jounce/design/input.hpp"
#include "jounce/design/key_figures.hpp"
#include "jounce/design/over_time.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::cam_then_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string folder = JOUNCE_SOURCE_DIR "/examples/cam-algebra/";

Input made(const std::string& name) {
  return read_inputs(folder + name + ".toml").front();
}

const Cam& cam_of(const Input& input) {
  return std::get<Cam>(*input.curve);
}

/// A cam made from last year's, with this [[then]].
Input changed(const std::string& then, const std::string& more = "") {
  const std::string text =
      "jounce = 1\nkind = \"cam\"\nfrom = \"last-year.toml\"\n" + more + "then = [" + then + "]\n";
  return inputs_of(parse_spec(text, folder + "new.toml"), folder + "new.toml").front();
}

std::string error_of(const std::string& then, const std::string& more = "") {
  const std::string error = test::error_of([&] { (void)changed(then, more); }, "no error");
  const auto place = error.find("new.toml:");
  return place == std::string::npos ? error : error.substr(place);
}

/// Compares all derivatives with the oracle, each by its greatest value.
void expect_oracle(const Input& input, const std::string& name, double share) {
  SCOPED_TRACE(name);
  static const auto all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/cam_then.json"));
  const auto& expected = all.at(name);
  const auto& x = expected["x"];
  ASSERT_GT(x.size(), 50U);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto values = expected["f" + std::to_string(k)].get<std::vector<double>>();
    double size = 0;
    for (const double value : values) size = std::max(size, std::abs(value));
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(cam_of(input).jet(x[i])[k], values[i],
                  share * std::pow(10., static_cast<double>(k)) * size)
          << "derivative " << k << " at " << x[i];
  }
}

TEST(CamThen, TheExamplesAreTheCamsOfTheOracle) {
  for (const char* name : {"last-year", "left-hand", "corrected", "longer", "bezier"})
    expect_oracle(made(name), name, 1e-14);
  expect_oracle(made("driven"), "driven", 1e-10);
  expect_oracle(made("shaft-of-pusher"), "shaft-of-pusher", 1e-8);
}

TEST(CamThen, ThreeLinesAreEnough) {
  const Input input = changed("{ operator = \"mirror\", slave = 20 }");
  EXPECT_EQ(input.labels.units.x, "deg");
  EXPECT_EQ(input.labels.units.position, "mm");
  EXPECT_EQ(cam_of(input).outside(), Extrapolation::wrap);
  EXPECT_EQ(cam_of(input).at(30).position, 40 - cam_of(made("last-year")).at(30).position);
  EXPECT_THAT(input.labels.segments, ElementsAre("1 push", "2 hold", "3 return", "4 rest"));
}

TEST(CamThen, SegmentsKeepTheirNamesWhereverTheyMove) {
  const Input phased = changed("{ operator = \"phase\", master = 30 }");
  EXPECT_THAT(phased.labels.segments,
              ElementsAre("4 rest", "1 push", "2 hold", "3 return", "4 rest"));
  const Input mirrored = changed("{ operator = \"mirror\", master = 0 }");
  EXPECT_THAT(mirrored.labels.segments, ElementsAre("4 rest", "3 return", "2 hold", "1 push"));
  const Input longer = made("longer");
  EXPECT_THAT(longer.labels.segments,
              ElementsAre("1 push", "2 hold", "dwell", "2 hold", "3 return", "4 rest"));
}

TEST(CamThen, OperatorsActInTheirOrder) {
  const Input first =
      changed("{ operator = \"scale\", slave = 2 }, { operator = \"shift\", slave = 5 }");
  const Input second =
      changed("{ operator = \"shift\", slave = 5 }, { operator = \"scale\", slave = 2 }");
  EXPECT_EQ(cam_of(first).at(150).position, 85);
  EXPECT_EQ(cam_of(second).at(150).position, 90);
}

// examples/cam-algebra/backwards.toml: the pusher over 360 - x, and a 3-4-5 stroke there and back from 10 to 50 deg.
TEST(CamThen, ReverseAndReplaceAreTheClosedForm) {
  const Input input = made("backwards");
  const Cam& cam = cam_of(input);
  const auto poly_345 = [](double z) { return z * z * z * (10 - 15 * z + 6 * z * z); };
  const auto cycloid = [](double z) { return z - std::sin(2 * M_PI * z) / (2 * M_PI); };
  for (double x = 0.5; x < 360; x += 1) {
    double y = 0;
    if (x > 10 && x < 50) y = 2 * poly_345(x < 30 ? (x - 10) / 20 : (50 - x) / 20);
    if (x > 60)
      y = 40 * (x < 180 ? cycloid((x - 60) / 120) : x < 240 ? 1 : poly_345((360 - x) / 120));
    EXPECT_NEAR(cam.at(x).position, y, 1e-12) << x;
  }
  EXPECT_EQ(cam.outside(), Extrapolation::wrap);
}

TEST(CamThen, UnitsOfTheFileAreThoseOfTheResult) {
  const Input input = changed("{ operator = \"shift\", slave = \"1 mm\" }",
                              "units = { position = \"m\", master = \"rad\" }\n");
  EXPECT_NEAR(cam_of(input).at(2.5).position,
              (cam_of(made("last-year")).at(2.5 * 180 / M_PI).position + 1) / 1000, 1e-15);
  EXPECT_THAT(
      error_of("", "units = { position = \"deg\", master = \"rad\" }\n"),
      HasSubstr("has a slave in mm, which cannot be converted to deg, the unit of this cam"));
  const Input inverse = made("shaft-of-pusher");
  EXPECT_EQ(inverse.labels.units.x, "mm");
  EXPECT_EQ(inverse.labels.units.position, "deg");
}

TEST(CamThen, KnotsOfTheFileTakeOperatorsToo) {
  std::string text = read_file(folder + "last-year.toml");
  text += "[[then]]\noperator = \"reverse\"\n";
  const Input input = inputs_of(parse_spec(text, "own.toml"), "own.toml").front();
  for (const double x : {10., 100., 200., 355.})
    EXPECT_NEAR(cam_of(input).at(x).position, cam_of(made("last-year")).at(360 - x).position,
                1e-13);
}

TEST(CamThen, AFitIsPartOfTheErrorOfTheTable) {
  const Input exact = made("left-hand");
  EXPECT_LE(exact.error->position, 40e-9);
  const Input fitted =
      changed("{ operator = \"compose\", with = \"shaft.toml\", tolerance = 1e-3 }",
              "table = { tolerance = 1e-6 }\n");
  const Input driven = made("driven");
  const Cam& cam = cam_of(driven);
  double worst = 0;
  for (double x = 0; x <= 360; x += 0.05)
    worst = std::max(worst, std::abs(cam_of(fitted).at(x).position - cam.at(x).position));
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst, fitted.error->position);
  EXPECT_LE(fitted.error->position, 1.001e-3);
  EXPECT_TRUE(checked(fitted).ok()) << "the tolerance of the operator is permitted";
  Spec spec = *fitted.spec;
  spec.master = MasterSpec{360, 360, {}};
  const Input slave = over_time(inputs_of(spec, "new.toml").front());
  EXPECT_GE(slave.error->position, fitted.fit) << "over time, too";
  EXPECT_TRUE(checked(slave).ok());
}

TEST(CamThen, ATableIsASourceToo) {
  const test::TemporaryFolder temporary;
  const auto path = temporary / "last-year.csv";
  write_file(path.string(), to_csv(made("last-year").table));
  const std::string text = "jounce = 1\nkind = \"cam\"\nfrom = \"" + path.string() +
                           "\"\nthen = [{ operator = \"shift\", slave = 1 }]\n";
  const Input input = inputs_of(parse_spec(text, "new.toml"), "new.toml").front();
  EXPECT_NEAR(cam_of(input).at(60).position, 21, 1e-7);
  EXPECT_EQ(input.labels.segments.front(), "last-year.csv");
}

TEST(CamThen, TheMasterCountsThePeriodsOfTheResult) {
  const Input input =
      changed("{ operator = \"scale\", master = 2 }", "master = { velocity = \"60 cpm\" }\n");
  EXPECT_EQ(input.spec->master->velocity, 720) << "deg/s: a period has 720 deg";
  EXPECT_EQ(input.spec->master_period(), 720);
}

TEST(CamThen, TheNumbersOfOperatorsAreParameters) {
  const Spec spec = read_spec(folder + "longer.toml");
  ASSERT_TRUE(spec.parameters);
  EXPECT_EQ(spec.parameters->parameters.front().key, "then[3].slave");
  EXPECT_NEAR(*assess(spec, {"stroke"}).value("stroke"), 50, 1e-12);
}

TEST(CamThen, ErrorsNameTheOperatorAndWhatToDo) {
  EXPECT_THAT(error_of("{ operator = \"phase\", master = 30 }", "periodic = false\n"), "no error")
      << "periodic holds for the result";
  EXPECT_THAT(error_of("{ operator = \"part\", from = 0, to = 90 }, "
                       "{ operator = \"phase\", master = 30 }"),
              HasSubstr("new.toml:4:64: then[2].operator = \"phase\": needs a cam that repeats: "
                        "give periodic = true, or use operator = \"shift\""));
  EXPECT_THAT(error_of("{ operator = \"scale\", master = -1 }"),
              HasSubstr("then[1].master = -1: must be greater than 0"));
  EXPECT_THAT(error_of("{ operator = \"scale\" }"), HasSubstr("then[1].slave: is missing"));
  EXPECT_THAT(error_of("{ operator = \"insert\", at = 60, dwell = 10 }"),
              HasSubstr("then[1].at = 60 deg: must be a place where the slave rests"));
  EXPECT_THAT(error_of("{ operator = \"insert\", at = 60 }"), HasSubstr("or dwell = NUMBER"));
  EXPECT_THAT(error_of("{ operator = \"mirror\", slave = 1, master = 2 }"),
              HasSubstr("cannot be combined with master"));
  EXPECT_THAT(error_of("{ operator = \"mirrors\" }"), HasSubstr("did you mean"));
  EXPECT_THAT(error_of("{ operator = \"inverse\" }"),
              HasSubstr("the slave passes its positions 2 times. Give a master position inside the "
                        "rise or fall that you need, such as 60"));
  EXPECT_THAT(error_of("{ operator = \"inverse\", at = 60, from = 0 }"), HasSubstr("at rest"));
  EXPECT_THAT(error_of("{ operator = \"superpose\", with = \"none.toml\" }"),
              HasSubstr("then[1].with"));
  EXPECT_THAT(error_of("{ operator = \"superpose\", with = \"../googol-move/move.toml\" }"),
              HasSubstr("is a spec over time: give a cam"));
  EXPECT_THAT(error_of("{ operator = \"superpose\", with = \"../rotary-knife/knife.toml\" }"),
              HasSubstr("has a master in in, which cannot be converted to deg"));
  EXPECT_THAT(error_of("{ operator = \"superpose\", with = \"new.toml\" }"),
              HasSubstr("refers back to this file"));
  EXPECT_THAT(error_of("", "start = { master = 0, slave = 0 }\n"),
              HasSubstr("cannot be combined with from"));
}

TEST(CamThen, FilesThatReferToEachOtherAreRejected) {
  const test::TemporaryFolder path;
  const auto spec = [](const std::string& from) {
    return "jounce = 1\nkind = \"cam\"\nfrom = \"" + from + "\"\n";
  };
  write_file((path / "a.toml").string(), spec("b.toml"));
  write_file((path / "b.toml").string(), spec("c.toml"));
  write_file((path / "c.toml").string(), spec("a.toml"));
  EXPECT_THAT(test::error_of([&] { (void)read_spec((path / "a.toml").string()); }, "no error"),
              HasSubstr("c.toml:3:8: from = \"a.toml\": refers back to this file"));
}

TEST(CamThen, FreeKnotsBelongToTheirOwnFile) {
  std::string text = read_file(folder + "last-year.toml");
  text +=
      "[[segment]]\nlaw = \"dwell\"\nend = { master = 400, slave = 0 }\nfree = { master = [380, "
      "410] }\n[[then]]\noperator = \"reverse\"\n";
  EXPECT_THAT(test::error_of([&] { (void)parse_spec(text, "own.toml"); }, "no error"),
              HasSubstr("then: cannot be combined with `free`"));
}

}  // namespace
}  // namespace jounce::cam_then_test
