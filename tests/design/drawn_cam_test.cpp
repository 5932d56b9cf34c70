// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/drawn_cam.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/cam/disc/plate_motion.hpp"
#include "jounce/design/detail/fit.hpp"
#include "jounce/design/disc.hpp"
#include "jounce/io/drawing.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::drawn_cam_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";
const std::string plate = examples + "cam-plate/plate.dxf#PLATE";
const std::string keys = "roller_radius = 7, offset = -4, origin = [100, 80], turn = \"-30 deg\"";

// The motion of tests/oracle/plate.py: rise by 3-4-5, dwell, return by the cycloid.
double lift(double master) {
  const double rise = std::clamp((master - 20) / 100, 0.0, 1.0);
  const double fall = std::clamp((master - 180) / 120, 0.0, 1.0);
  return 12 * (rise * rise * rise * (10 + rise * (-15 + 6 * rise)) -
               (fall - std::sin(2 * std::numbers::pi * fall) / (2 * std::numbers::pi)));
}

TEST(DrawnCam, TheMotionOfAnIndependentPlateIsFound) {
  const DrawnCam drawn = read_drawn_cam(plate, keys + ", intervals = 100000", {});
  ASSERT_TRUE(drawn.disc);
  EXPECT_NEAR(drawn.disc->geometry.base_radius, 25, 1e-5);
  const auto masters = drawn.points.in_unit("master", "deg");
  const auto slaves = drawn.points.in_unit("slave", "mm");
  ASSERT_EQ(masters.size(), 100'001U);
  double greatest = 0;
  for (std::size_t i = 0; i < masters.size(); ++i)
    greatest = std::max(greatest, std::abs(slaves[i] - lift(masters[i])));
  EXPECT_LT(greatest, 2e-5) << "the arcs of one degree";
  EXPECT_EQ(slaves.back(), slaves.front());
}

std::vector<std::string> laws_of(const CamSpec& spec) {
  std::vector<std::string> laws;
  for (const CamSegment& segment : spec.segments) laws.emplace_back(name(segment.law));
  return laws;
}

TEST(DrawnCam, FitFindsTheLawsOfAPlate) {
  const FittedCam made = fitted_cam(plate, {.tolerance = "5 um", .drawing = keys});
  EXPECT_TRUE(made.ok());
  EXPECT_THAT(laws_of(made.fit.spec),
              ElementsAre("dwell", "345", "dwell", "inclined_sine", "dwell"));
  EXPECT_NEAR(made.fit.spec.segments[1].end.master, 120, 0.05);
  EXPECT_NEAR(made.fit.spec.segments[2].end.master, 180, 0.05);
  EXPECT_NEAR(made.fit.spec.segments[1].end.slave, 12, 1e-3);
  const Spec spec = parse_spec(made.text, "fit.toml");
  ASSERT_TRUE(spec.disc) << made.text;
  EXPECT_NEAR(spec.disc->geometry.base_radius, 25, 1e-4);
  EXPECT_EQ(spec.disc->geometry.roller_radius, 7);
  EXPECT_EQ(spec.disc->geometry.offset, -4);
}

/// Jounce's own drawings, in both formats: out and back.
class OwnDrawing : public ::testing::TestWithParam<const char*> {};

TEST_P(OwnDrawing, GivesBackTheCam) {
  const Spec spec = read_spec(examples + "valve-cam/valve.toml");
  const Cam cam = std::get<Cam>(*inputs_of(spec, "").front().curve);
  const Disc disc = make_disc(spec, cam);
  const test::TemporaryFolder folder;
  const std::string path = folder / (std::string("own") + GetParam());
  const std::string file = path.substr(0, path.find('#'));
  write_file(file, contour_file(file, spec, disc));
  const DrawnCam drawn = read_drawn_cam(path, "roller_radius = 8, offset = 3", {"deg", "mm"});
  ASSERT_TRUE(drawn.disc);
  EXPECT_NEAR(drawn.disc->geometry.base_radius, 18, 1e-3);
  const auto slaves = drawn.points.in_unit("slave", "mm");
  const auto masters = drawn.points.in_unit("master", "deg");
  // The drawing is within 0.001 mm of the plate; the follower moves at most 30 deg beside its normal.
  for (std::size_t i = 0; i < masters.size(); ++i)
    EXPECT_NEAR(slaves[i], cam.jet(masters[i])[0], 0.001 / std::cos(std::numbers::pi / 6) + 1e-6);
}
INSTANTIATE_TEST_SUITE_P(DrawnCam, OwnDrawing, ::testing::Values(".dxf#CAM", ".svg#cam"),
                         [](const auto& each) { return std::string(each.param).substr(1, 3); });

TEST(DrawnCam, AnArmTurnsByAngles) {
  // The eccentric circle of tests/cam/disc/plate_motion_test.cpp, in inches.
  const test::TemporaryFolder folder;
  const std::string path = folder / "eccentric.svg";
  write_file(
      path,
      "<svg width='10in' height='10in' viewBox='0 0 10 10'><circle cx='5' cy='4.8' r='1'/></svg>");
  const std::string arm =
      "follower = \"oscillating\", roller_radius = \"0.25 in\", arm_length = \"2 in\", "
      "center_distance = \"2.5 in\", origin = [\"5 in\", \"-5 in\"]";
  const DrawnCam drawn = read_drawn_cam(path, arm, {"rev", "deg"});
  const auto slaves = drawn.points.in_unit("slave", "deg");
  const auto masters = drawn.points.in_unit("master", "rev");
  const auto psi = [&](double master) {
    const double angle = std::numbers::pi * (0.5 + 2 * master);
    const double x = 2.5 - 0.2 * std::cos(angle), y = 0.2 * std::sin(angle), d = std::hypot(x, y);
    return (std::atan2(y, x) + std::acos((4 + d * d - 1.25 * 1.25) / (4 * d))) * 180 /
           std::numbers::pi;
  };
  double least = 1e9;
  for (const double master : masters) least = std::min(least, psi(master));
  for (std::size_t i = 0; i < masters.size(); ++i)
    EXPECT_NEAR(slaves[i], psi(masters[i]) - least, 1e-9);
}

std::string cam_with(const std::string& segment) {
  return "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" "
         "}\n[[segment]]\n"
         "law = \"quintic_spline\"\n" +
         segment;
}
std::string complaint(const std::string& segment) {
  const std::string name = examples + "cam-plate/test.toml";
  const std::string error = test::error_of([&] { (void)parse_spec(cam_with(segment), name); });
  return error.starts_with(name) ? error.substr(name.size()) : error;
}

TEST(DrawnCam, ASegmentReadsAGraph) {
  const Spec spec = parse_spec(
      cam_with(
          "points = \"graph.svg#pusher\"\ndrawing = { origin = [0, -50], master_scale = \"2 deg\", "
          "slave_scale = 1.5, intervals = 90 }\n"),
      examples + "cam-plate/test.toml");
  const CamSpec& cam = std::get<CamSpec>(spec.subject);
  EXPECT_EQ(cam.start.master, 0);
  EXPECT_NEAR(cam.start.slave, 0, 1e-12);
  EXPECT_NEAR(cam.segments[0].end.master, 360, 1e-9);
  const auto at_top = [](const CamPoint& p) { return p.master >= 100 && p.master <= 160; };
  std::size_t top = 0;
  for (const CamPoint& p : cam.segments[0].points)
    if (at_top(p)) {
      ++top;
      EXPECT_NEAR(*p.slave, 60, 1e-9) << p.master;
    }
  EXPECT_GE(top, 2U) << "the ends of the straight line";
  // The rise is a Bezier curve: x = 60 t - 30 t^2 + 20 t^3 ..., y by the same t.
  for (const CamPoint& p : cam.segments[0].points) {
    if (!(p.master < 100)) continue;
    double from = 0, to = 1;
    for (int i = 0; i < 60; ++i) {
      const double t = (from + to) / 2, s = 1 - t;
      (3 * s * s * t * 20 + 3 * s * t * t * 30 + t * t * t * 50 < p.master / 2 ? from : to) = t;
    }
    EXPECT_NEAR(*p.slave, 1.5 * 40 * from * from * (3 - 2 * from), 1e-4);
  }
}

TEST(DrawnCam, NamesWhatIsWrong) {
  EXPECT_THAT(complaint("points = \"graph.svg#pusher\"\n"),
              HasSubstr("segment[1].drawing.master_scale: is missing"));
  EXPECT_THAT(complaint("points = \"graph.svg\"\n"),
              HasSubstr("layer: is missing: name one after #"));
  EXPECT_THAT(
      complaint(
          "points = \"graph.svg#pusher\"\ndrawing = { roller_radius = 5, master_scale = 2 }\n"),
      HasSubstr("roller_radius = 5: is not a key of the drawing of a graph, an open curve"));
  EXPECT_THAT(
      complaint(
          "points = \"plate.dxf#PLATE\"\ndrawing = { master_scale = 2, origin = [100, 80] }\n"),
      HasSubstr("master_scale = 2: is not a key of the drawing of a plate, a closed curve"));
  EXPECT_THAT(complaint("points = \"plate.dxf#PLATE\"\ndrawing = { unit = \"in\" }\n"),
              HasSubstr("unit = \"in\": is not the unit in the file, mm"));
  EXPECT_THAT(complaint("points = \"plate.dxf#PLATE\"\n"), HasSubstr("is not met by the follower"));
  EXPECT_THAT(
      complaint("points = \"plate.dxf#PLATE\"\ndrawing = { origin = [100, 80], intervals = 3 }\n"),
      HasSubstr("intervals = 3: must be at least 8"));
  EXPECT_THAT(complaint("points = \"missing.dxf\"\n"), HasSubstr("segment[1].points"));
  EXPECT_THAT(complaint("points = \"../points-file/points.csv\"\ndrawing = {}\n"),
              HasSubstr("drawing: applies to points from a drawing"));
  EXPECT_EQ(test::key_of([&] {
              (void)fitted_cam(examples + "measured-cam/measured.csv",
                               {.tolerance = "1 mm", .drawing = keys});
            }),
            "drawing");
  EXPECT_EQ(test::error_of(
                [&] { (void)read_drawn_cam(plate, "roller_radius = -7, origin = [100, 80]", {}); }),
            "drawing roller_radius = -7 mm: must not be negative");
  EXPECT_EQ(test::key_of([&] { (void)read_drawn_cam(plate, "roller_radius 7", {}); }), "drawing");
  EXPECT_EQ(test::key_of([&] { (void)read_drawn_cam(plate, "roler_radius = 7", {}); }),
            "drawing roler_radius");
}

}  // namespace
}  // namespace jounce::drawn_cam_test
