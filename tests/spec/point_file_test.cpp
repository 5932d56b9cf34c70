// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"

#include "support/temporary_folder.hpp"

namespace jounce::point_file_test {
namespace {

using ::testing::ElementsAre;

/// A folder with a spec and the points beside it.
class PointFile : public test::WithFolder {
 protected:
  Spec spec(const std::string& head, const std::string& points) {
    write_file((folder_ / "points.csv").string(), points);
    write_file((folder_ / "spec.toml").string(), "jounce = 1\n" + head);
    return read_spec((folder_ / "spec.toml").string());
  }

  std::string complaint(const std::string& head, const std::string& points) {
    try {
      (void)make(spec(head, points));
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(text.rfind('/', text.find(": ")) + 1);
    }
    return "none";
  }
};

const std::string pvt =
    "kind = \"pvt\"\nunits = { position = \"mm\", time = \"s\" }\npoints = \"points.csv\"\n";

TEST_F(PointFile, HoldsTheKnotsOfAPvtTable) {
  const Spec made =
      spec(pvt, "time [ms];position [mm];velocity [m/s]\n0;0;0\n500;2,5;0,01\n1000;5;0\n");
  const Columns& columns = std::get<Table>(made.subject).columns();
  EXPECT_THAT(columns.x, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(columns.p, ElementsAre(0, 2.5, 5));
  EXPECT_THAT(columns.v, ElementsAre(0, 10, 0));
}

TEST_F(PointFile, MayLeaveOutWhatIsFilledIn) {
  const Spec made =
      spec(pvt + "velocities = \"monotone\"\n", "time [s],position [mm]\n0,0\n1,2\n2,3\n");
  const Columns& columns = std::get<Table>(made.subject).columns();
  ASSERT_EQ(columns.v.size(), 3U);
  EXPECT_GT(columns.v[1], 0);
  EXPECT_THAT(complaint(pvt, "time [s],position [mm]\n0,0\n1,2\n"),
              "points.csv:1: velocity: is missing: add the column, or a rule in the spec, such as "
              "velocities = \"clamped\"");
}

TEST_F(PointFile, IsNamedWithTheLineOfAMistake) {
  EXPECT_THAT(complaint(pvt, "time [s],position,velocity\n0,0,0\n\n2,1,0\n1,2,0\n"),
              ::testing::StartsWith("points.csv:5:1: time = 1 s: must be greater than 2 s"));
  EXPECT_THAT(complaint(pvt, "time [s],position,speed\n0,0,0\n"),
              "points.csv:1: speed: is not a column of this table; possible columns: time, "
              "position, velocity: delete the column, or give it one of these names");
  EXPECT_THAT(complaint(pvt + "knot = []\n", "time,position,velocity\n0,0,0\n"),
              "spec.toml:4:10: points = \"points.csv\": cannot be combined with [[knot]]: give one "
              "of the two");
  EXPECT_EQ(complaint(pvt, "time [s],position,velocity\n\n0,0,0\n"),
            "points.csv:3: is the only point of the file: a table needs at least two");
  EXPECT_THAT(complaint(pvt, "time [mm],position,velocity\n0,0,0\n1,1,0\n"),
              ::testing::StartsWith("points.csv:1: time = mm:"));
}

TEST_F(PointFile, NamesTheCauseOfAMistakeInItsOwnUnits) {
  EXPECT_EQ(complaint(pvt, "time [ms],position [mm],velocity\n0,0,0\n100,1,0\n100,2,0\n"),
            "points.csv:4:1: time = 100 ms: must be greater than 100 ms, the previous point: "
            "delete one of the two points");
  for (const char* header : {"Weg (furlong)", "position / furlong"})
    EXPECT_EQ(complaint(pvt, std::string("time (s);") + header + ";velocity\n0;0;0\n"),
              "points.csv:1: position = furlong: is not a known unit: write one such as mm, deg, s "
              "or mm/s");
  EXPECT_EQ(complaint(pvt, "time (s),position (inch),velocity (inch/s)\n0,0,0\n1,1,0\n"), "none");
  EXPECT_EQ(complaint(pvt, "Nr;time;position;velocity\n1;0;0;0\n"),
            "points.csv:1: nr: is not a column of this table; possible columns: time, position, "
            "velocity: delete the column, or give it one of these names");
}

const std::string pt =
    "kind = \"pt\"\nunits = { position = \"pulse\", time = \"ms\" }\npoints = \"points.csv\"\n";

TEST_F(PointFile, HoldsThePointsOfAPtTableWithTheirTypes) {
  const std::string keys = pt + "[pt]\nincrements = true\n";
  const Made made =
      make(spec(keys, "time,position,type\n1024,1024,normal\n1024,2048,0\n1024,1024,stop\n"));
  const auto& curve = std::get<Trajectory>(*made.curve);
  EXPECT_EQ(curve.end(), 3072);
  EXPECT_EQ(curve.jet(1024)[1], 2);
  EXPECT_EQ(curve.jet(3072, Side::left)[0], 4096);
  EXPECT_EQ(complaint(keys, "time,position,type\n1024,1024,sideways\n"),
            "points.csv:2:11: type = sideways: must be one of normal, even, stop, continue, or its "
            "number, counted from 0");
  EXPECT_EQ(complaint(pt + "[pt]\n", "time,position\n5,1\n4,2\n"),
            "points.csv:3:1: time = 4 ms: must be greater than 5 ms, the previous point: sort "
            "the points by time");
}

TEST_F(PointFile, HoldsTheSegmentsOfAFollowTable) {
  const Spec made = spec(
      "kind = \"follow\"\nunits = { position = \"pulse\", master = \"pulse\" }\n"
      "points = \"points.csv\"\n",
      "master,slave,type\n20000,10000,normal\n40000,30000,normal\n60000,40000,normal\n");
  const Cam cam = sync_cam_of(std::get<SyncSpec>(made.subject)).cam;
  EXPECT_EQ(cam.jet(20000)[1], 1);
  EXPECT_EQ(cam.jet(60000, Side::left)[0], 40000);
}

TEST_F(PointFile, APtTableThatTheControllerRejectsIsNamedWithItsOwnLine) {
  const std::string googol = pt + "[pt]\ncontroller = \"googol\"\n";
  EXPECT_THAT(
      complaint(googol, "time,position\n16,1\n\n32.5,2\n"),
      ::testing::StartsWith("points.csv:4:1: time = 32.5 ms: must be a whole number of ms"));
  EXPECT_THAT(
      complaint(googol, "time,position\n16,1\n2147483648,2\n"),
      ::testing::StartsWith("points.csv:3:1: time = 2147483648 ms: must be at most 2147483647"));
  EXPECT_THAT(
      complaint(pt + "[pt]\n", "time,position\n1,1e308\n2,-1e308\n"),
      ::testing::StartsWith("points.csv:2:3: position = 1e308 pulse: is too far from 0, the "
                            "previous point"));
  EXPECT_THAT(complaint(pvt, "time,position,velocity\n0,0,0\n1,1e308,0\n2,-1e308,0\n"),
              ::testing::StartsWith("points.csv:3: knot[2]: is the end of a segment whose value"));
  const std::string follow =
      "kind = \"follow\"\nunits = { position = \"pulse\", master = \"pulse\" }\npoints = "
      "\"points.csv\"\n";
  EXPECT_THAT(complaint(follow, "master,slave\n100,1\n200,-1e308\n"),
              ::testing::StartsWith("points.csv:3:5: slave = -1e308 pulse: is too far"));
}

TEST_F(PointFile, HoldsTheStagesOfAPmc600Table) {
  const std::string head =
      "kind = \"pt\"\nunits = { position = \"mm\", time = \"s\" }\npoints = \"points.csv\"\n"
      "[pt]\ncontroller = \"pmc600\"\nquantity = \"velocity\"\n";
  const Made made = make(spec(head, "delta_time [ms],velocity [m/s]\n1000,0.01\n2000,0\n"));
  const auto& curve = std::get<Trajectory>(*made.curve);
  EXPECT_EQ(curve.end(), 3);
  EXPECT_EQ(curve.jet(1)[1], 10);
  EXPECT_EQ(
      complaint(head, "delta_time,velocity\n1,10\n0.0005,0\n"),
      "points.csv:3:1: delta_time = 0.0005 s: must be a whole number of ms, the resolution of "
      "the data type TIME");
  EXPECT_THAT(
      complaint(head, "delta_time,velocity\n1,10\n0,0\n"),
      ::testing::StartsWith("points.csv:3:1: delta_time = 0 s: must be greater than 0 (PMC600"));
  EXPECT_THAT(complaint(head, "delta_time,position\n1,10\n"),
              ::testing::StartsWith("points.csv:1: position: is not a column of this table"));
}

}  // namespace
}  // namespace jounce::point_file_test
