// SPDX-License-Identifier: Apache-2.0
// Recordings of a drive: columns and units, and what is refused with which words.
#include "jounce/io/recording.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "support/errors.hpp"

namespace jounce::recording_test {
namespace {

using test::error_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A file of this process alone: tests run side by side.
struct File {
  explicit File(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  ~File() { std::filesystem::remove(path); }
  const std::string path = ::testing::TempDir() + "recording_" + std::to_string(getpid()) + ".csv";
};

Recording recorded(const std::string& text, const Drive& drive = servo_400w()) {
  const File file(text);
  return read_recording(file.path, drive, "deg");
}

std::string refused(const std::string& text, const Drive& drive = servo_400w()) {
  return error_of([&] { (void)recorded(text, drive); });
}

const std::string rows = "0,0,0\n1,1,1\n2,2,2\n3,3,3\n";

TEST(Recording, IsReadInTheUnitsOfItsHeader) {
  const Recording run = recorded("time [ms],command [rev],torque [N mm]\n" + rows);
  EXPECT_THAT(run.time, ElementsAre(0, 0.001, 0.002, 0.003));
  EXPECT_THAT(run.command, ElementsAre(0, 360, 720, 1080));
  EXPECT_THAT(run.torque, ElementsAre(0, 0.001, 0.002, 0.003));
  EXPECT_THAT(run.position, IsEmpty());
}

TEST(Recording, HasTheUnitsOfTheDriveWithoutBrackets) {
  const Recording run = recorded("time,command,feedback\n" + rows);
  EXPECT_THAT(run.command, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(run.position, ElementsAre(0, 1, 2, 3));
}

TEST(Recording, CountsACurrentByTheTorqueConstant) {
  Drive drive = servo_400w();
  drive.motor.torque_constant = 0.5;
  const Recording run = recorded("time;command;current\n0;0;0\n1;1;2\n2;2;4\n3;3;6\n", drive);
  EXPECT_THAT(run.torque, ElementsAre(0, 1, 2, 3));
  drive.motor.torque_constant = 0;
  EXPECT_THAT(refused("time,command,current\n" + rows, drive),
              HasSubstr("current: needs motor.torque_constant"));
}

TEST(Recording, RejectsWhatIsNone) {
  const std::string head = "time,command,feedback\n";
  EXPECT_THAT(refused(""), HasSubstr("is empty"));
  EXPECT_THAT(refused(head), HasSubstr("has a header but no points: add at least one row"));
  EXPECT_THAT(refused(head + "0,0,0\n1,1,1\n2,2,2\n"),
              HasSubstr("time: needs at least four rows; the number of rows is 3"));
  EXPECT_THAT(refused("time,feedback,load\n" + rows), HasSubstr("column \"command\": is missing"));
  EXPECT_THAT(
      refused("time,command,other\n" + rows),
      HasSubstr(".csv:1: column \"feedback\": is missing: the columns of the file are time, "
                "command, other. A recording needs time, command, and at least one of "
                "feedback, velocity, torque, current and load. Name the columns in the "
                "header, with units, such as time [s],command [deg],feedback [deg]"));
  EXPECT_THAT(
      refused(rows),
      HasSubstr(".csv:1:1: header = 0: must be the name of a column, with or without a unit, such "
                "as position [mm]: write a header above the numbers. A recording needs time"));
  EXPECT_THAT(refused("time,command [mm],feedback\n" + rows), HasSubstr("command = mm"));
  EXPECT_THAT(refused(head + "0,0,0\n1,nan,1\n2,2,2\n3,3,3\n"),
              HasSubstr(".csv:3:3: command = nan"));
  EXPECT_THAT(refused(head + "0,0,0\n1,1,1\n2,2,1e300\n3,3,3\n"),
              HasSubstr(".csv:4:5: feedback = 1e300 deg: must be below 1e100 in magnitude"));
  EXPECT_THAT(refused(head + "0,0,0\n1,1\n2,2,2\n3,3,3\n"),
              HasSubstr(".csv:3: has 2 values, but the header has 3 columns"));
  EXPECT_THAT(refused(head + "0,0,0\n1,1,1\n1,2,2\n3,3,3\n"),
              HasSubstr(".csv:4:1: time = 1 s: must be greater than 1 s"));
}

const std::string ticks =
    "tick,time [s],state,position [rev],velocity [rev/s],acceleration [rev/s^2],job,fault,"
    "actual [rev],following_error [rev],torque [rated]\n";

TEST(Recording, IsReadFromTheTicksOfARun) {
  const std::string log = ticks +
                          "0,0,disabled,0,0,0,0,none,0,0,0\n"
                          "1,0.001,standstill,0,0,0,0,none,nan,nan,0\n"
                          "2,0.002,standstill,0,0,0,0,none,0.25,-0.25,0\n"
                          "3,0.003,discrete_motion,1,7,3,1,none,0.5,-0.5,0.5\n"
                          "4,0.004,discrete_motion,2,7,0,1,none,1.5,-0.5,-1\n"
                          "6,0.006,standstill,4,0,0,0,none,3.5,-1.5,0\n"
                          "7,0.007,standstill,4,0,0,0,none,4,0,0.5\n";
  Drive drive = servo_400w();
  drive.motor.rated_torque = 1.5;
  const Recording run = recorded(log, drive);
  EXPECT_THAT(run.time, ElementsAre(0.001, 0.002, 0.003, 0.006));
  EXPECT_THAT(run.command, ElementsAre(0, 0, 360, 1440));
  EXPECT_THAT(run.position, ElementsAre(90, 180, 540, 1440)) << "of the next tick";
  EXPECT_THAT(run.torque, ElementsAre(0, 0.75, -1.5, 0.75));
  EXPECT_THAT(run.velocity, IsEmpty()) << "that of a tick is a setpoint";
  ASSERT_EQ(run.setpoints.size(), 6U) << "also those without a response";
  EXPECT_EQ(run.setpoints[2].time, 0.003);
  EXPECT_EQ(run.setpoints[2].position, 360);
  EXPECT_EQ(run.setpoints[2].velocity, 7 * 360);
  EXPECT_EQ(run.setpoints[2].acceleration, 3 * 360);
  drive.motor.rated_torque = 0;
  drive.motor.torque_limit = 3;
  EXPECT_THAT(recorded(log, drive).torque, ElementsAre(0, 1.5, -3, 1.5));
}

/// Five ticks of a standstill at `position`, from this tick on; the drive is `error` behind.
std::string standing(int tick, const std::string& position, const std::string& error) {
  std::string rows;
  for (int k = tick; k < tick + 5; ++k)
    rows += std::to_string(k) + "," + std::to_string(k) + "e-3,standstill," + position +
            ",0,0,0,none," + position + "," + error + ",0\n";
  return rows;
}

TEST(Recording, KeepsTheCoordinateOfItsFirstTick) {
  const Recording run = recorded(ticks + standing(1, "1", "0.25") + standing(6, "-3", "0.5"));
  EXPECT_THAT(run.command, ::testing::Each(360));
  EXPECT_EQ(run.command.size(), 9U);
  EXPECT_EQ(run.position.front(), 270);
  EXPECT_EQ(run.position.back(), 180);
}

TEST(Recording, IsTheLongestSectionOfEnabledTicks) {
  const Recording run =
      recorded(ticks + standing(1, "1", "0") + "6,6e-3,disabled,1,0,0,0,none,1,0,0\n" +
               standing(7, "2", "0") + standing(12, "2", "0"));
  EXPECT_EQ(run.time.front(), 0.007);
  EXPECT_EQ(run.time.size(), 9U);
  EXPECT_EQ(run.setpoints.size(), 10U);
  EXPECT_THAT(
      refused(ticks + "1,1e-3,discrete_motion,1,5,0,0,none,1,0,0\n" + standing(2, "1", "0")),
      HasSubstr("velocity = 1800 deg/s: must be 0, with acceleration 0, in the first tick: "
                "the recording must begin at standstill. List more ticks of the record: "
                "increase or omit --last"));
}

TEST(Recording, NamesTheCommandsThatListTheFeedback) {
  const std::string no = refused(
      "tick,time [s],state,position [deg],velocity [deg/s],acceleration [deg/s^2],job,fault\n"
      "0,0,disabled,0,0,0,0,none\n");
  EXPECT_THAT(no, HasSubstr("column \"actual\": is missing"));
  EXPECT_THAT(no, HasSubstr("jounce replay run.lcmlog --csv run.csv"));
  EXPECT_THAT(refused("time [s],state,position\n0,disabled,0\n"),
              HasSubstr("A recording needs time, command"));
}

}  // namespace
}  // namespace jounce::recording_test
