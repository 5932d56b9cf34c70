// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/spec.hpp"

#include "support/temporary_folder.hpp"

namespace jounce::cam_points_test {
namespace {

/// A cam spec whose segment reads the points of a file beside it.
class CamPoints : public test::WithFolder {
 protected:
  Spec spec(const std::string& body, const std::string& points) {
    write_file((folder_ / "points.csv").string(), points);
    write_file(
        (folder_ / "spec.toml").string(),
        "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n" + body);
    return read_spec((folder_ / "spec.toml").string());
  }
  CamSpec cam(const std::string& body, const std::string& points) {
    return std::get<CamSpec>(spec(body, points).subject);
  }
  std::string complaint(const std::string& body, const std::string& points) {
    try {
      (void)design(cam(body, points));
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(text.rfind('/', text.find(": ")) + 1);
    }
    return "";
  }
};

const std::string spline = "[[segment]]\nlaw = \"quintic_spline\"\npoints = \"points.csv\"\n";
const std::string points = "master [deg],slave [mm]\n0,0\n90,5\n180,20\n360,0\n";

TEST_F(CamPoints, GiveStartPointsAndEnd) {
  const CamSpec read = cam(spline, points);
  EXPECT_EQ(read.start.master, 0);
  ASSERT_EQ(read.segments.size(), 1);
  EXPECT_EQ(read.segments[0].end.master, 360);
  ASSERT_EQ(read.segments[0].points.size(), 2);
  EXPECT_EQ(read.segments[0].points[1].master, 180);
  EXPECT_EQ(read.segments[0].points[1].slave, 20);
}

TEST_F(CamPoints, AreInTheUnitsOfTheirHeader) {
  const CamSpec read = cam(spline, "master [rev];slave [um]\n0;0\n0,5;20000\n1;0\n");
  ASSERT_EQ(read.segments[0].points.size(), 1);
  EXPECT_DOUBLE_EQ(read.segments[0].points[0].master, 180);
  EXPECT_DOUBLE_EQ(*read.segments[0].points[0].slave, 20);
}

TEST_F(CamPoints, AreWithinTheToleranceOfTheSegmentOrTheFile) {
  EXPECT_EQ(cam(spline + "tolerance = \"20 um\"\n", points).segments[0].points[0].tolerance, 0.02);
  const std::string file = "master,slave,tolerance [um]\n0,0,1\n90,5,30\n360,0,1\n";
  EXPECT_EQ(cam(spline, file).segments[0].points[0].tolerance, 0.03);
  EXPECT_EQ(complaint(spline + "tolerance = 0.1\n", file),
            "spec.toml:7:13: segment[1].tolerance = 0.1 mm: cannot be combined with the column "
            "tolerance of the file: leave one of the two out");
}

TEST_F(CamPoints, MeetTheKnotsOfTheSpec) {
  const std::string start = "start = { master = 0, slave = 0, geo_velocity = 0 }\n";
  EXPECT_EQ(cam(start + spline, points).start.geo_velocity, 0);
  EXPECT_EQ(
      complaint("start = { master = 0, slave = 1 }\n" + spline, points),
      "points.csv:2:3: slave = 0 mm: must be 1 mm, the knot of the spec at this master position");
  EXPECT_EQ(complaint("start = { master = 10, slave = 0 }\n" + spline, points),
            "points.csv:2:1: master = 0 deg: must lie in its segment, 10 to 360 deg");
}

TEST_F(CamPoints, GiveDerivativesToHermite) {
  const std::string file =
      "master,slave,geo_velocity,geo_acceleration\n0,0,0,0\n90,5,0.1,0\n360,0,0,0\n";
  const CamSpec read = cam("[[segment]]\nlaw = \"hermite\"\npoints = \"points.csv\"\n", file);
  const Cam made = design(read).cam;
  EXPECT_NEAR(made.jet(90)[0], 5, 1e-12);
  EXPECT_NEAR(made.jet(90)[1], 0.1, 1e-12);
}

TEST_F(CamPoints, ThatAreWrongNameTheirLine) {
  EXPECT_EQ(complaint(spline, "master,slave\n0,0\n90,5\n90,6\n360,0\n"),
            "points.csv:4:1: master = 90 deg: must be greater than 90 deg, the previous point: "
            "delete one of the two points");
  const std::string empty = complaint(spline, "");
  EXPECT_THAT(empty, testing::StartsWith("spec.toml:6:10: segment[1].points = "));
  EXPECT_THAT(empty, testing::EndsWith("points.csv: is empty: a header must name the columns, such "
                                       "as time [s],position [mm] or master [deg],slave [mm]"))
      << "the missing end is not another error: it is the last point of the file";
  EXPECT_EQ(complaint(spline, "master,slave,speed\n0,0,1\n360,0,1\n"),
            "points.csv:1: speed: is not a column of this table; possible columns: master, slave, "
            "tolerance: delete the column, or give it one of these names");
}

TEST_F(CamPoints, NeedALawThroughPoints) {
  EXPECT_EQ(complaint("[[segment]]\nlaw = \"modified_sine\"\npoints = \"points.csv\"\n", points),
            "spec.toml:6:10: segment[1].points = points.csv: the law modified_sine takes no "
            "points: leave them out, or use polynomial, cubic_spline, quintic_spline or hermite");
}

TEST_F(CamPoints, CannotBeMovedByAFreeKnot) {
  EXPECT_EQ(complaint(spline + "free = { slave = [0, 1] }\n", points),
            "spec.toml:7:8: segment[1].free: moves the last point of the file: give the segment "
            "its own end");
}

TEST_F(CamPoints, SetTheTravelOfTheMaster) {
  const Spec read =
      spec("periodic = true\n" + spline + "[master]\nvelocity = \"60 1/min\"\n", points);
  EXPECT_DOUBLE_EQ(read.master->velocity, 360);
}

}  // namespace
}  // namespace jounce::cam_points_test
