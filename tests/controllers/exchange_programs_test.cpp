// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

// Motions over time and cams in counts, as the examples of the manuals and other programs write
// them. The files that Jounce writes are in tests/design/controller_files_test.cpp.
namespace jounce::exchange_programs_test {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pointwise;
using Numbers = std::vector<double>;

Columns columns(const std::string& text, const std::string& name = "t") {
  return parse_exchange(text, name).table.columns();
}

std::string complaint(const std::string& text, const std::string& name = "t") {
  return test::error_of([&] { (void)parse_exchange_tables(text, name); });
}

TEST(Xps, HasAColumnPairForEachPositioner) {
  const auto tables = parse_exchange_tables(
      "0.1, 4.140625, 105.46875, 1, 20\n0.1, 15.859375, 187.5, 1, 0\n\n0.1,1,0,-2,0\r\n", "a.TRJ");
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[1].name, "2");
  const Columns& first = tables[0].file.table.columns();
  EXPECT_THAT(first.x, Pointwise(DoubleNear(1e-15), Numbers{0, 0.1, 0.2, 0.3}));
  EXPECT_THAT(first.p, ElementsAre(0, 4.140625, 20, 21));
  EXPECT_THAT(first.v, ElementsAre(0, 105.46875, 187.5, 0));
  EXPECT_THAT(tables[1].file.table.columns().p, ElementsAre(0, 1, 2, 0));
  EXPECT_EQ(tables[0].file.units.x, "s");
  EXPECT_EQ(tables[0].file.table.axis(), Domain::time);
}

TEST(Xps, RejectsWhatIsNoTrajectory) {
  EXPECT_EQ(complaint("0.1,1,2\n0.1,1,2\n", "a.trj"),
            "a.trj:2: velocity = 2: must be 0 in the last element: is the file complete?");
  EXPECT_EQ(complaint("0.1,1,2\n0.1,1\n", "a.trj"),
            "a.trj:2: row = 2 values: must have 3, as the first row");
  EXPECT_EQ(complaint("0,1,0\n", "a.trj"), "a.trj:1: time = 0: must be greater than 0");
  EXPECT_EQ(complaint("0.1,1,0\n0.1,nan,0\n", "a.trj"),
            "a.trj:2: displacement = \"nan\": must be a finite number");
  EXPECT_EQ(exchange_format_of_text("0.1,1,0\n"), exchange_format_named("pairs"))
      << "without its ending, three numbers may be a point with a torque";
}

TEST(Zaber, ReadsTheUnitsOfTheHeader) {
  const auto tables = parse_exchange_tables(
      "Time (ms),Axis 0 Position (cm),Axis 0 Velocity (cm/s),Axis 1 Velocity (mm/s),Axis 1 "
      "Position (mm)\n0,0,0,0,5\n100,0.5,10,1,6\n200,2,0,0,8\n",
      "t");
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_THAT(tables[0].file.table.columns().x, Pointwise(DoubleNear(1e-15), Numbers{0, 0.1, 0.3}));
  EXPECT_THAT(tables[0].file.table.columns().v, ElementsAre(0, 10, 0));
  EXPECT_EQ(tables[0].file.units.position, "cm");
  EXPECT_THAT(tables[1].file.table.columns().p, ElementsAre(5, 6, 8));
  EXPECT_EQ(tables[1].name, "axis 1");
}

TEST(Zaber, RejectsWhatTheLibraryGenerates) {
  const std::string head = "Time (s),Axis 1 Position (mm),Axis 1 Velocity (mm/s)\n0,0,0\n";
  EXPECT_THAT(complaint(head + "0.1,1,\n"), HasSubstr("t:3: Velocity: is empty: Zaber's library"));
  EXPECT_THAT(complaint("Time (s),Axis 1 Position (mm)\n0,0\n"), HasSubstr("has no velocities"));
  EXPECT_THAT(complaint(head + "0,1,0\n"), HasSubstr("t:3: Time = 0: must be greater than 0"));
  EXPECT_THAT(complaint(head + "1,1\n"), HasSubstr("t:3: row = 2 values: must have 3"));
  EXPECT_THAT(complaint("Time (s),Axis 1 Position (mm),Axis 1 Velocity (deg/s)\n0,0,0\n"),
              HasSubstr("deg/s: does not convert to mm/s"));
}

TEST(Ros, ReadsBlocksAndTheNamesOfRos1) {
  const std::string text =
      "header: {stamp: {secs: 0, nsecs: 0}}\njoint_names:\n- shoulder\n- elbow\npoints:\n"
      "  - positions: [0.0, 1]\n    velocities: [0, 0.5]\n    accelerations: []\n"
      "    time_from_start:\n      secs: 0\n      nsecs: 0\n"
      "  - positions: [0.5, 2]\n    velocities: [0, 0]\n    effort: [1, 2]\n"
      "    time_from_start: {secs: 1, nsecs: 250000000}\n";
  const auto tables = parse_exchange_tables(text, "t");
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[1].name, "elbow");
  EXPECT_EQ(tables[1].file.table.rule(), Interpolation::cubic_hermite);
  EXPECT_THAT(tables[1].file.table.columns().x, ElementsAre(0, 1.25));
  EXPECT_THAT(tables[1].file.table.columns().v, ElementsAre(0.5, 0));
  EXPECT_THAT(tables[0].unread, ElementsAre("the efforts are not read"));
}

TEST(Ros, ReadsJson) {
  const Columns c = columns(
      "{\"joint_names\": [\"a\"], \"points\": [{\"positions\": [0], \"velocities\": [0], "
      "\"accelerations\": [0], \"time_from_start\": {\"sec\": 0, \"nanosec\": 0}}, {\"positions\": "
      "[0.04], \"velocities\": [0], \"accelerations\": [1], \"time_from_start\": {\"sec\": 0, "
      "\"nanosec\": 400000000}}]}");
  EXPECT_THAT(c.x, ElementsAre(0, 0.4));
  EXPECT_THAT(c.a, ElementsAre(0, 1));
}

TEST(Ros, RejectsPointsThatDiffer) {
  const auto message = [](const std::string& second) {
    return "joint_names: [a]\npoints:\n- {positions: [0], velocities: [0], time_from_start: {sec: "
           "0, nanosec: 0}}\n- " +
           second + "\n";
  };
  EXPECT_EQ(complaint(message("{positions: [1], time_from_start: {sec: 1, nanosec: 0}}")),
            "t:4: points[2].velocities: is missing: the first point has it");
  EXPECT_THAT(complaint(message("{positions: [1, 2], velocities: [0], time_from_start: {sec: 1}}")),
              HasSubstr("t:4: points[2].positions = 2 values: must have one value for each joint"));
  EXPECT_THAT(complaint(message("{positions: [x], velocities: [0], time_from_start: {sec: 1}}")),
              HasSubstr("t:4: points[2].positions = \"x\": must be a finite number"));
  EXPECT_THAT(
      complaint(message("{positions: [1], velocities: [0], time_from_start: {nanosec: 1.0e9}}")),
      HasSubstr("the nanoseconds from 0 to 999999999"));
  EXPECT_THAT(complaint(message("{positions: [1], velocities: [0], time_from_start: {sec: 0}}")),
              HasSubstr("t:4: knot[2].time = 0: must be greater than 0"));
  EXPECT_THAT(complaint("joint_names: [a\npoints: time_from_start\n"),
              HasSubstr("is not a JointTrajectory in YAML"));
  EXPECT_THAT(complaint("- joint_names\n- time_from_start\n"), HasSubstr("must have keys"));
}

TEST(Galil, ReadsTheExampleOfTheNotes) {
  const Columns c = columns(
      "EAA\nEM 9000,100; EP 3000,0\nET[0]=,0\nET[1]=,4141\nREM ET[9]=,1\nET[2]=,20000\n"
      "ET[3]=,100\nEB 1\nEG ,0\n");
  EXPECT_THAT(c.x, ElementsAre(0, 3000, 6000, 9000));
  EXPECT_THAT(c.p, ElementsAre(0, 4141, 20000, 100));
  const std::string good = "EM 200,0\nEP 100,0\nET[0]=,0\nET[1]=,5\nET[2]=,0\n";
  EXPECT_EQ(complaint(good), "");
  EXPECT_THAT(complaint(good.substr(0, good.size() - 9)), HasSubstr("ET[2]: is missing"));
  EXPECT_THAT(complaint("EP 0\n" + good.substr(18)), HasSubstr("EP = 0: must be from 1 to 32767"));
  EXPECT_THAT(complaint("EM 250\n" + good.substr(9)), HasSubstr("EM = 250: must be 1 to 256"));
  EXPECT_THAT(complaint(good + "ET[1e9]=,0\n"), HasSubstr("ET = 1e+09: must be a whole"));
}

TEST(Galil, ReadsThePvtExampleOfTheNotes) {
  const Columns c = columns(
      "PVA=4141,84375,128\nPVA=15859,150000,128\nPVA=15859,84375,128\n"
      "PVA=4141,0,128\nPVA=0,0,0\nBTA\n");
  EXPECT_THAT(c.x, ElementsAre(0, 0.125, 0.25, 0.375, 0.5));
  EXPECT_THAT(c.p, ElementsAre(0, 4141, 20000, 35859, 40000));
  EXPECT_THAT(c.v, ElementsAre(0, 84375, 150000, 84375, 0));
  EXPECT_THAT(complaint("PVA=1,0,128\n"), HasSubstr("does not end with PVA=0,0,0"));
  EXPECT_THAT(complaint("PVA=1,0,127\nPVA=0,0,0\n"), HasSubstr("t:1: PVA = 127: must be an even"));
  EXPECT_THAT(complaint("TM 500\nPVA=1,0,128\nPVA=0,0,0\n"),
              HasSubstr("t:1: TM = 500: must be 1000"));
  EXPECT_THAT(complaint("PVA=0,0,0\nPVA=1,0,2\n"), HasSubstr("t:2: PVA"));
}

TEST(Trio, ReadsTheExampleOfTheNotes) {
  const auto tables = parse_exchange_tables(
      "TABLE(1000, 0,4141,20000,35859,40000)\nTABLE(1005,40000,40000)' rest\nBASE(1)\n"
      "CAMBOX(1000,1006,0.001,360,0,4)\n",
      "t");
  const Columns& c = tables.at(0).file.table.columns();
  EXPECT_THAT(c.x, ElementsAre(0, 60, 120, 180, 240, 300, 360));
  EXPECT_THAT(c.p, ElementsAre(0, 4.141, 20, 35.859, 40, 40, 40));
  EXPECT_THAT(complaint("TABLE(0,1)\nCAMBOX(0,1,1,360,0)\n"),
              HasSubstr("needs the value TABLE(1)"));
  EXPECT_THAT(complaint("TABLE(0,1,2)\nCAMBOX(0,1,1,0,0)\n"), HasSubstr("t:2: CAMBOX"));
  EXPECT_THAT(complaint("TABLE(1e300,1,2)\nCAMBOX(0,1,1,1,0)\n"),
              HasSubstr("must be a whole number"));
  EXPECT_THAT(complaint("TABLE(0,1,2\nCAMBOX(0,1,1,1,0)\n"), HasSubstr("t:1: TABLE"));
}

TEST(Googol, ReadsCallsWithNamesAndDefaults) {
  // Example 7-3 of the manual: three segments of 1024 ms that end at 2, 2 and 0 pulse/ms.
  const Columns c = columns(
      "rtn = GT_PtData(1, 1024, 1024);\nrtn = GT_PtData(1, 3072, 2048, "
      "PT_SEGMENT_EVEN);\nrtn = GT_PtData(1, 4096, 3072, PT_SEGMENT_STOP, 0);\n");
  EXPECT_THAT(c.x, ElementsAre(0, 1024, 2048, 3072));
  EXPECT_THAT(c.p, ElementsAre(0, 1024, 3072, 4096));
  EXPECT_THAT(c.v, ElementsAre(0, 2, 2, 0));
  EXPECT_THAT(complaint("GT_PtData(1, 1024, 1024);\nGT_PtData(1, 2048, 2048, 1);\n"),
              HasSubstr("t:2: GT_PtData = 1: is the velocity at which the segment begins"));
  EXPECT_THAT(complaint("GT_PtData(1, 5, 5, 7);\n"), HasSubstr("must be a type of segment"));
  EXPECT_THAT(columns("GT_PtData(1, 1024L, 1024UL);\nGT_PtData(1, 2048.f, 2048, 2);\n").x,
              ElementsAre(0, 1024, 2048));
  EXPECT_THAT(columns("// GT_PtData(1, 9, 9);\nGT_PtData(1, 4, 2); /* GT_PtData(1, 9,\n9); */\n"
                      "GT_PtData(1, 8, 4, 2);\n")
                  .x,
              ElementsAre(0, 2, 4));
  EXPECT_THAT(complaint("GT_PtData(1, 1024X, 1024);\n"), HasSubstr("must be a finite number"));
  EXPECT_THAT(complaint("GT_PtData(1, L, 1024);\n"), HasSubstr("must be a finite number"));
  EXPECT_THAT(complaint("GT_PtData(1, 5, pos);\n"), HasSubstr("\"pos\": must be a finite number"));
  EXPECT_THAT(complaint("GT_PtData(1, 5, 5"), HasSubstr("has no closing parenthesis"));
  EXPECT_THAT(complaint("GT_FollowData(2, 10, 5, 3);\n"), HasSubstr("continues another table"));
  const Columns lines = columns("GT_FollowData(2, 10, 5, 1);\nGT_FollowData(2, 20, 5, 1);\n");
  EXPECT_TRUE(lines.v.empty());
  EXPECT_THAT(lines.p, ElementsAre(0, 5, 5));
}

// Other arrays may have such names; the program passes three of them to MovePVT.
TEST(Hmpl, ReadsTheArraysThatTheProgramPasses) {
  const std::string program =
      "// HIMC: a PVT motion\nvoid main() {\n  double t[3] = {0, 100, 250}, p[3] = {0, 2.5, 20};\n"
      "  double v[3] = {0, 60, 0};\n  double old_time[2] = {0, 1};\n"
      "  MovePVT(0, 3,\n          p, v, t);\n}\n";
  const Columns c = columns(program);
  EXPECT_THAT(c.x, ElementsAre(0, 100, 250));
  EXPECT_THAT(c.p, ElementsAre(0, 2.5, 20));
  EXPECT_THAT(c.v, ElementsAre(0, 0.06, 0));
  EXPECT_THAT(complaint("double a[2] = {0, 1};\ndouble b[2] = {0, 1};\nMovePVT(0, 2, a, b, a);\n"),
              HasSubstr("is in no array: the arrays are named a, b. Rename the array of these "
                        "numbers to t, or to a name with time"));
}

// The last comma is legal in C.
TEST(Hmpl, ReadsAListWithACommaAtItsEnd) {
  const Columns c = columns(
      "double t[2] = {\n 0,\n 100,\n};\ndouble p[2] = {0, 5,};\ndouble v[2] = {0, 0, };\n"
      "MovePVT(0, 2, t, p, v);\n");
  EXPECT_THAT(c.x, ElementsAre(0, 100));
  EXPECT_THAT(c.p, ElementsAre(0, 5));
  EXPECT_THAT(complaint("double t[2] = {0, , 1};\nMovePVT(0, 2, t, t, t);\n"),
              HasSubstr("must be a finite number"));
}

TEST(Hmpl, RejectsACallWithAnotherNumberOfPoints) {
  const auto program = [](const std::string& arguments) {
    return "double t[3] = {0, 100, 250}, p[3] = {0, 2.5, 20};\ndouble v[3] = {0, 60, "
           "0};\nMovePVT(" +
           arguments + ", t, p, v);\n";
  };
  EXPECT_EQ(
      complaint(program("0, 2")),
      "t:3: MovePVT = 0, 2: does not contain 3, the number of values in each array: make the call "
      "and the arrays agree");
  for (const char* arguments : {"0, 3", "axis, 2", "0, points", "0"})
    EXPECT_EQ(columns(program(arguments)).x.size(), 3U) << arguments;
}

TEST(Hmpl, ReadsTheArraysOfTheManual) {
  // Manual 5.2.8.
  const auto tables = parse_exchange_tables(
      "double pvt_time[6] = {0,2000,3000,4000,6000,11000};\n"
      "double pvt_pos[6] = {0,153.333,42.123,161.21,177,83.333};\n"
      "double pvt_vel[6] = {0,1000,800,\n 1660,450,0};\n",
      "t");
  const Table& table = tables.at(0).file.table;
  EXPECT_EQ(tables[0].file.units.x, "ms");
  // The middle of segment 0 of the cubic polynomials is at -173.3335 mm (notes, example 1).
  EXPECT_NEAR(table.jet(1000)[0], -173.3335, 1e-9);
  EXPECT_THAT(complaint("double pvt_time[2] = {0,1};\ndouble pvt_pos[1] = {0};\ndouble pvt_vel[2] "
                        "= {0,0};\n"),
              HasSubstr("t:2: pos = 1 values: must be as many as times: 2"));
  EXPECT_THAT(complaint("double pvt_time[2] = {0,1};\ndouble pvt_pos[2] = {0,1"),
              HasSubstr("has no closing brace"));
}

TEST(ExchangeFormats, ASpecThatMentionsCommandsIsNoTable) {
  for (const char* command :
       {"GT_PtData(1, 2, 3)", "GearIn(0, 1, 2)", "PVA=1,2,4", "CAMBOX(1) TABLE("})
    EXPECT_EQ(exchange_format_of_text("# " + std::string(command) + "\njounce = 1\n" + command),
              nullptr);
}

}  // namespace
}  // namespace jounce::exchange_programs_test
