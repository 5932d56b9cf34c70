// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/fit.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/design/convert.hpp"
#include "jounce/design/detail/cam_check.hpp"

#include "support/temporary_folder.hpp"

namespace jounce::design_fit_test {
namespace {

using ::testing::HasSubstr;

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

/// A file that the test removes.
class FitFile : public ::testing::Test {
 protected:
  FittedCam fit(const std::string& content, const FitOptions& options) {
    write_file(path_, content);
    return fitted_cam(path_, options);
  }
  std::string complaint(const std::string& content, const FitOptions& options) {
    try {
      (void)fit(content, options);
    } catch (const InputError& error) {
      const std::string text = error.what();
      const auto at = text.find(path_);
      return at == std::string::npos ? text : text.substr(at + path_.size());
    }
    return "";
  }

 private:
  test::TemporaryFolder folder_;
  std::string path_ = folder_ / "fit.csv";
};

/// A table of straight lines, as a controller without other rules has it.
std::string lines_of(const std::string& spec, std::size_t intervals) {
  const Input input = read_inputs(examples + spec).front();
  return to_csv(converted(input, {.rule = Interpolation::linear, .intervals = intervals}).file);
}

std::vector<std::string> laws_of(const CamSpec& spec) {
  std::vector<std::string> laws;
  for (const CamSegment& segment : spec.segments) laws.emplace_back(name(segment.law));
  return laws;
}

/// The greatest distance of a spec from the lines of a table at places between its knots.
double greatest_distance(const FittedCam& made, const Table& table) {
  const Cam cam = std::get<Cam>(*inputs_of(parse_spec(made.text, "fit.toml"), "").front().curve);
  double greatest = 0;
  for (int i = 0; i < 5000; ++i) {
    const double x = table.start() + table.length() * (i + 0.5) / 5000;
    greatest = std::max(greatest, std::abs(cam.jet(x)[0] - table.jet(x)[0]));
  }
  return greatest;
}

class Seeds : public FitFile,
              public ::testing::WithParamInterface<std::pair<const char*, double>> {};

/// Cams and follow tables of the manuals and of the vendors' examples.
TEST_P(Seeds, AreFittedWithinTheTolerance) {
  const auto& [spec, tolerance] = GetParam();
  const std::string table = lines_of(spec, 720);
  const FittedCam made = fit(table, {.tolerance = number(tolerance)});
  const Input input = inputs_of(parse_spec(made.text, "fit.toml"), "").front();
  EXPECT_LE(made.fit.gap, tolerance);
  EXPECT_LE(made.fit.spec.segments.size(), 9);
  const Table points = parse_table(table, "t").table;
  double gap = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Side side = i > 0 ? Side::left : Side::right;
    const Cam& cam = std::get<Cam>(*input.curve);
    const double x = std::min(points.columns().x[i], cam.end());
    gap = std::max(gap, std::abs(cam.jet(x, side)[0] - points.columns().p[i]));
  }
  EXPECT_NEAR(made.fit.gap, gap, 1e-9 * tolerance);
  EXPECT_GE(made.between.position, greatest_distance(made, points) * (1 - 1e-9));
  EXPECT_LE(made.between.position, 2 * tolerance);  // no oscillation between the points
  EXPECT_TRUE(checked(input).ok()) << full_text(checked(input), input.labels);
}

INSTANTIATE_TEST_SUITE_P(Tables, Seeds,
                         ::testing::Values(std::pair{"pmc600-cam/cam.toml", 0.1},
                                           std::pair{"pmc600-gear-in-pos/gear.toml", 1.0},
                                           std::pair{"googol-clutch/gear.toml", 100.0},
                                           std::pair{"googol-follow/7-6.toml", 4.0},
                                           std::pair{"googol-follow/7-8.toml", 40.0},
                                           std::pair{"rotary-knife/knife.toml", 0.1},
                                           std::pair{"press-pusher/pusher.toml", 0.01},
                                           std::pair{"packaging-pusher/cam.toml", 0.05},
                                           std::pair{"printing-register/cam.toml", 0.1},
                                           std::pair{"spring-coiler/cam.toml", 0.1},
                                           std::pair{"valve-cam/valve.toml", 0.002}));

TEST_F(FitFile, FindsTheLawsOfAPusher) {
  const FittedCam made = fit(lines_of("press-pusher/pusher.toml", 360), {.tolerance = "12 um"});
  EXPECT_THAT(made.text, ::testing::HasSubstr("\ntolerance = 0.0012\n"))
      << "a tenth of 0.012 mm, without the rounding of the product";
  EXPECT_THAT(laws_of(made.fit.spec),
              ::testing::ElementsAre("modified_sine", "dwell", "modified_sine", "dwell"));
  EXPECT_EQ(made.fit.spec.segments[0].end.master, 90);
  EXPECT_LT(made.fit.gap, 1e-9);
}

/// Fig. 6.14 of the manual: two quintics from rest, a line, and a return that no law describes.
TEST_F(FitFile, KeepsTheLineOfThePmc600Cam) {
  const FittedCam made = fit(lines_of("pmc600-cam/cam.toml", 720), {.tolerance = "0.5"});
  EXPECT_THAT(laws_of(made.fit.spec),
              ::testing::ElementsAre("345", "line", "quintic_spline", "dwell", "345"));
}

TEST_F(FitFile, ATableWithVelocitiesIsFittedBetweenItsKnots) {
  const FittedCam made = fitted_cam(
      examples + "codesys-default/cam.xyva",
      {.tolerance = "0.01deg", .period = "", .master_unit = "deg", .position_unit = "deg"});
  EXPECT_TRUE(made.curved);
  EXPECT_TRUE(made.ok());
  EXPECT_LT(made.between.position, 1e-9);
  EXPECT_THAT(laws_of(made.fit.spec), ::testing::ElementsAre("345", "line", "345"));
}

TEST_F(FitFile, APeriodMayCloseTheFile) {
  std::string points = "master [deg];slave [mm]\n";
  for (int i = 0; i < 360; i += 5)
    points += std::to_string(i) + ";" + number(10 - 10 * std::cos(i * std::acos(-1) / 180)) + "\n";
  const FittedCam made = fit(points, {.tolerance = "1um", .period = "1 rev"});
  EXPECT_TRUE(made.fit.spec.periodic);
  EXPECT_EQ(made.fit.spec.segments.back().end.master, 360);
  EXPECT_THAT(laws_of(made.fit.spec), ::testing::ElementsAre("simple_sine", "simple_sine"));
}

TEST_F(FitFile, APeriodOfAnAdvancingSlaveNeedsItsLastPoint) {
  std::string points = "master [deg];slave [mm]\n";
  for (int i = 0; i < 360; i += 5)
    points += std::to_string(i) + ";" + number(0.3 * i + std::sin(i * std::acos(-1) / 180)) + "\n";
  EXPECT_THAT(complaint(points, {.tolerance = "1um", .period = "1 rev"}),
              HasSubstr("period = 1 rev: needs a point at 360 deg, the end of the period"));
  const FittedCam made = fit(points + "360;108\n", {.tolerance = "10um", .period = "1 rev"});
  EXPECT_TRUE(made.fit.spec.periodic);
  EXPECT_NEAR(made.fit.spec.segments.back().end.slave, 108, 1e-9);
}

TEST_F(FitFile, ACamBeyondTheToleranceOfAPointIsBroken) {
  const std::string zigzag =
      "master [deg],slave [mm]\n0,0\n60,0.1\n120,0\n180,0.1\n240,0\n300,0.1\n360,0.01\n";
  const FittedCam broken = fit(zigzag, {.tolerance = "0.02", .period = "360"});
  EXPECT_FALSE(broken.ok());
  EXPECT_GT(broken.fit.gap, 0.02);
  EXPECT_NEAR(broken.fit.excess, broken.fit.gap - 0.02, 1e-15);
  EXPECT_THAT(fit_text(broken), HasSubstr("BROKEN"));
  EXPECT_TRUE(fit(zigzag, {.tolerance = "0.06", .period = "360"}).ok());
}

TEST_F(FitFile, RejectsWithTheLineOfTheFile) {
  EXPECT_THAT(
      complaint("master,slave\n0,0\n1,1\n1,2\n2,2\n3,3\n", {.tolerance = "1"}),
      HasSubstr("master_unit: is missing, and --position-unit, too: the file names no units"));
  EXPECT_THAT(complaint("time [s],position [mm]\n0,0\n1,1\n2,2\n3,3\n4,4\n", {.tolerance = "1"}),
              HasSubstr(":1: time: is a column of a motion over time"));
  const std::string head = "master [deg],slave [mm]\n";
  EXPECT_EQ(complaint(head + "0,0\n1,1\n1,2\n2,2\n3,3\n", {.tolerance = "1"}),
            ":4:1: master = 1 deg: must be greater than 1 deg, the previous point");
  EXPECT_EQ(complaint(head + "0,0\n1,1\n", {.tolerance = "1"}), ": points = 2: must be at least 5");
  EXPECT_THAT(complaint(head + "0,0\n1,1\n", {.tolerance = "1", .master_unit = "rad"}),
              HasSubstr("master_unit = rad: is not the unit in the file, deg: leave it out"));
  EXPECT_THAT(complaint(head + "0,0\n1,1\n", {}), HasSubstr("tolerance: is missing"));
  EXPECT_EQ(complaint(head + "0,0\n1,1\n", {.tolerance = "0"}),
            "tolerance = 0: must be greater than 0");
  EXPECT_EQ(complaint(head + "0,0\n1,1\n2,2\n3,3\n4,4\n", {.tolerance = "20"}),
            "tolerance = 20 mm: must be at most the travel of the slave, 4 mm: with more, a dwell "
            "fits all points");
  EXPECT_EQ(complaint(head + "0,0\n1,1\n2,2\n3,3\n4,4\n", {.tolerance = "1", .period = "3"}),
            "period = 3: must be at least 4 deg, the travel of the master in the file");
  EXPECT_THAT(complaint("jounce = 1\nkind = \"cam\"\n", {.tolerance = "1"}),
              HasSubstr("is a spec: fit reads points or a table"));
  EXPECT_THAT(complaint("master [deg],slave [mm],tolerance\n0,0,1\n1,0,0\n", {}),
              HasSubstr(":3:5: tolerance = 0 mm: must be greater than 0"));
}

}  // namespace
}  // namespace jounce::design_fit_test
