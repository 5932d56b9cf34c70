// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/played.hpp"

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::played_test {
namespace {

const std::string header = "tick,time [s],state,master [],position [mm],job,fault\n";

/// A log of an axis that stands, plays job 1, stands, and plays job 2 along 10 t from tick 5 on.
std::string two_motions(double last_position) {
  return header +
         "0,0,standstill,0,0,0,none\n"
         "1,0.1,discrete_motion,0,7,1,none\n"
         "2,0.2,standstill,0,7,0,none\n"
         "5,0.5,discrete_motion,0,0,2,none\n"
         "6,0.6,discrete_motion,0,1,2,none\n"
         "7,0.7,discrete_motion,0," +
         number(last_position) + ",2,none\n";
}

const Designed ramp{.over_time = {.table =
                                      [](double t) {
                                        return Motion{10 * t, 10, 0, 0};
                                      }},
                    .duration = 0.2};

TEST(Played, ComparesEveryTickOfTheLastMotion) {
  const auto ticks = read_played(two_motions(2), "run.csv");
  ASSERT_EQ(ticks.size(), 3U);
  EXPECT_NEAR(ticks[1].time, 0.1, 1e-15);
  const Played played = compare_played(ticks, ramp);
  EXPECT_TRUE(played.report.ok());
  EXPECT_LT(played.table.error, 1e-14);
  EXPECT_FALSE(played.curve) << "the table is all there is";
}

TEST(Played, FindsOneWrongTick) {
  const Played played = compare_played(read_played(two_motions(2.5), "run.csv"), ramp);
  EXPECT_FALSE(played.report.ok());
  EXPECT_EQ(played.report.findings.front().rule, "played/table");
  EXPECT_NEAR(played.table.error, 0.5, 1e-14);
  EXPECT_NEAR(played.table.where, 0.2, 1e-14);
}

// The table may stray from its curve by its tolerance; what is played may not stray from the table.
TEST(Played, TakesTheToleranceOfTheTableForTheCurveAlone) {
  Designed designed = ramp;
  designed.over_time.curve = [](double t) { return 10 * t + 0.001; };
  designed.tolerance = 0.0011;
  const auto ticks = read_played(two_motions(2), "run.csv");
  const Played played = compare_played(ticks, designed);
  EXPECT_TRUE(played.report.ok());
  EXPECT_LT(played.table.error, 1e-14);
  ASSERT_TRUE(played.curve);
  EXPECT_NEAR(played.curve->error, 0.001, 1e-14);
  EXPECT_NEAR(played.curve->limit, 0.0011, 1e-12);

  designed.tolerance = 0.0009;
  const Played strays = compare_played(ticks, designed);
  ASSERT_FALSE(strays.report.ok());
  EXPECT_EQ(strays.report.findings.front().rule, "played/curve");

  designed.tolerance = 1;
  designed.over_time.table = [](double t) { return Motion{10 * t + 0.001, 10, 0, 0}; };
  const Played other = compare_played(ticks, designed);
  EXPECT_EQ(other.report.findings.front().rule, "played/table")
      << "within the tolerance of the curve, yet another table";
}

// The limit of the table's comparison is rounding: it grows with what the numbers are, not with the stroke.
TEST(Played, MeasuresRoundingByThePositionAndTheTime) {
  const double late = 86400;
  std::string log = header;
  for (int k = 0; k <= 200; ++k)
    log += std::to_string(k) + "," + number(late + k * 0.001) + ",discrete_motion,0," +
           number(1e6 + 100 * k * 0.001) + ",1,none\n";
  const auto far = [](double t) { return Motion{1e6 + 100 * t, 100, 0, 0}; };
  const Played played =
      compare_played(read_played(log, "run.csv"), {.over_time = {.table = far}, .duration = 0.2});
  EXPECT_TRUE(played.report.ok()) << played.table.error;
  EXPECT_GT(played.table.error, 0);
  EXPECT_LT(played.table.limit, 1e-7);
}

// A cycle that came 5 ms late: the next one is at rest at the end.
TEST(Played, AnEndThatALateCycleLeftOutIsShownByTheTickAfterIt) {
  const auto log = [](double rest) {
    std::string rows = header;
    for (int k = 0; k <= 195; ++k)
      rows += std::to_string(k) + "," + number(k * 0.001) + ",discrete_motion,0," +
              number(100 * k * 0.001) + ",1,none\n";
    return rows + "201,0.201,standstill,0," + number(rest) + ",0,none\n";
  };
  const auto line = [](double t) { return Motion{100 * t, 100, 0, 0}; };
  const Designed designed{.over_time = {.table = line}, .duration = 0.2};
  EXPECT_TRUE(compare_played(read_played(log(20), "run.csv"), designed).report.ok());
  const Played beside = compare_played(read_played(log(19.7), "run.csv"), designed);
  EXPECT_FALSE(beside.report.ok());
  EXPECT_EQ(beside.report.findings.front().rule, "played/table");
}

TEST(Played, FindsAMotionThatWasCutShort) {
  Designed longer = ramp;
  longer.duration = 0.5;
  const Played played = compare_played(read_played(two_motions(2), "run.csv"), longer);
  EXPECT_FALSE(played.report.ok());
  EXPECT_EQ(played.report.findings.front().rule, "played/complete");
  longer.duration = 0.3;
  EXPECT_TRUE(compare_played(read_played(two_motions(2), "run.csv"), longer).report.ok())
      << "within one cycle";
}

TEST(Played, FindsAHoleInTheLog) {
  std::string log = header;
  for (int k = 0; k <= 400; ++k)
    if (k < 100 || k > 250)
      log += std::to_string(k) + "," + number(k * 0.001) + ",discrete_motion,0," +
             number(k * 0.01) + ",1,none\n";
  const Played played =
      compare_played(read_played(log, "run.csv"), {.over_time = ramp.over_time, .duration = 0.4});
  EXPECT_FALSE(played.report.ok());
  EXPECT_EQ(played.report.findings.front().rule, "played/gap");
  EXPECT_EQ(played.report.findings.front().value, 151);
}

std::string complaint(const std::string& csv) {
  return test::error_of([&] { (void)read_played(csv, "run.csv"); });
}

TEST(Played, RejectsWhatIsNoLog) {
  EXPECT_EQ(complaint(""),
            "run.csv:1: has no column tick: the file is not a tick log of `jounce run --log`");
  EXPECT_EQ(complaint("a,b\n1,2\n"),
            "run.csv:1: has no column tick: the file is not a tick log of `jounce run --log`");
  EXPECT_EQ(complaint(header),
            "run.csv: contains no motion of a table: give the log of the axis that played the "
            "table");
  EXPECT_EQ(complaint(header + "0,0,standstill,0,0,0,none\n1,0.1,discr"),
            "run.csv:3: row = 1,0.1,discr: must have as many values as the header");
  EXPECT_EQ(complaint(header + "0,0,discrete_motion,0,nan,1,none\n"),
            "run.csv:2: position = nan: must be a finite number");
}

/// A cam y = m^2 that its axis followed: from the master position `start`, to 1, back, and to 2.
std::string live_log(double start, double slave, double last_error) {
  std::string text = "tick,time [s],state,master [mm],position [mm],job,fault,profile [s=mm]\n";
  int tick = 0;
  for (const double m : {0.0, 0.5, 1.0, 0.2, 2.0}) {
    const double error = m == 2 ? last_error : 0;
    text += std::to_string(tick) + "," + number(tick * 0.1) + ",synchronized_motion," +
            number(start + m) + "," + number(slave + m * m + error) + ",1,none,\n";
    ++tick;
  }
  return text;
}

Designed square_cam() {
  Designed designed = ramp;
  designed.over_master = {.table =
                              [](double m) {
                                return Motion{m * m, 2 * m, 2, 0};
                              },
                          .curve = [](double m) { return m * m + 0.001; }};
  designed.over_time.curve = [](double t) { return 10 * t; };
  designed.tolerance = 0.0011;
  return designed;
}

TEST(Played, ACamMayFollowALiveMaster) {
  for (const auto& [start, slave] : {std::pair{0.0, 0.0}, {300.0, 7.0}}) {
    const Played played =
        compare_played(read_played(live_log(start, slave, 0), "run.csv"), square_cam());
    EXPECT_TRUE(played.live);
    EXPECT_TRUE(played.report.ok()) << start;
    EXPECT_LT(played.table.error, 1e-12);
    ASSERT_TRUE(played.curve);
    EXPECT_NEAR(played.curve->error, 0.001, 1e-12);
  }
}

// An override slows the virtual master of a table over time: this log is no proof of the table.
TEST(Played, AVirtualMasterIsNotLive) {
  std::string log = live_log(0, 0, 0);
  for (std::size_t at = 0; (at = log.find(",profile [s=mm]")) != std::string::npos;)
    log.erase(at, 15);
  for (std::size_t at = 0; (at = log.find("none,\n")) != std::string::npos;) log.erase(at + 4, 1);
  const Played played = compare_played(read_played(log, "run.csv"), square_cam());
  EXPECT_FALSE(played.live);
  EXPECT_FALSE(played.report.ok());
}

TEST(Played, ReportsTheFaultThatEndedALiveMotion) {
  const std::string log = live_log(0, 0, 0) + "5,0.5,error_stop,9,4,0,jump,\n";
  const Played played = compare_played(read_played(log, "run.csv"), square_cam());
  EXPECT_TRUE(played.live);
  EXPECT_EQ(played.report.findings.front().rule, "played/fault");
  EXPECT_FALSE(played.report.ok());
}

TEST(Played, FindsOneWrongTickOfALiveMaster) {
  const Played played =
      compare_played(read_played(live_log(300, 7, 1e-6), "run.csv"), square_cam());
  EXPECT_FALSE(played.report.ok());
  EXPECT_FALSE(played.live);
}

/// A log of a slave at 2 units per unit of its master, with a correction that grows by 0.5 a tick.
std::string corrected_log(const std::string& unit_of_correction) {
  std::string log =
      "tick,time [s],state,master [mm],position [deg],job,fault,profile [s=mm],deviation [mm]," +
      std::string("correction [") + unit_of_correction + "]\n";
  for (int k = 0; k < 20; ++k)
    log += std::to_string(k) + "," + number(k * 0.001) + ",synchronized_motion," +
           number(10.0 * k) + "," + number(20.0 * k + 0.5 * k) + ",1,none,,0," + number(0.5 * k) +
           "\n";
  return log;
}

Designed doubled() {
  const auto table = [](double x) { return Motion{2 * x, 2, 0, 0}; };
  return {.over_time = {.table = table}, .over_master = {.table = table}, .duration = 0.019};
}

TEST(Played, SubtractsTheCorrectionOfASlave) {
  const Played played = compare_played(read_played(corrected_log("deg"), "run.csv"), doubled());
  EXPECT_TRUE(played.report.ok()) << played.table.error;
  EXPECT_TRUE(played.live);
  // A correction of the master is part of the column master.
  EXPECT_FALSE(compare_played(read_played(corrected_log("mm"), "run.csv"), doubled()).report.ok());
}

TEST(Played, StatesThatACutterPlaysAPlan) {
  Designed designed = doubled();
  designed.cutter = true;
  const Played played = compare_played(read_played(corrected_log("mm"), "run.csv"), designed);
  ASSERT_FALSE(played.report.ok());
  EXPECT_NE(played.report.findings.front().advice.find("plays a plan of cuts and not this table"),
            std::string::npos);
}

// A live master needs no motion of a virtual one.
TEST(Played, ComparesACamWithoutAMotionOfItsMasterOverTheLog) {
  Designed cam = doubled();
  cam.over_time = {};
  cam.duration = 0;
  std::string log = "tick,time [s],state,master [mm],position [mm],job,fault,profile [s=mm]\n";
  for (int k = 0; k < 50; ++k)
    log += std::to_string(k) + "," + number(k * 0.001) + ",synchronized_motion," +
           number(420 + 10.0 * k) + "," + number(840 + 20.0 * k) + "," + (k < 10 ? "6" : "7") +
           ",none,\n";
  const Played played = compare_played(read_played(log, "run.csv"), cam);
  EXPECT_TRUE(played.report.ok()) << played.table.error;
  EXPECT_TRUE(played.live);
  EXPECT_EQ(played.ticks, 40U);
  EXPECT_EQ(played.job, 7);
  EXPECT_EQ(played.start, 0.01);
  log.replace(log.rfind("1820,"), 5, "1821,");
  const Played wrong = compare_played(read_played(log, "run.csv"), cam);
  EXPECT_FALSE(wrong.report.ok());
  EXPECT_NEAR(wrong.table.error, 1, 1e-9);
  EXPECT_NE(wrong.report.findings.front().advice.find("a halt, a hold, an override"),
            std::string::npos);
}

/// A log of the slave of doubled(), whose correction falls from 20 to 0 in 20 ticks, and which has
/// an error in one tick. `blade`: a shift of the slave.
std::string ramped_log(int ticks, double blade, int wrong_tick) {
  std::string log = "tick,time [s],state,master [mm],position [mm],job,fault,profile [s=mm]\n";
  for (int k = 0; k < ticks; ++k) {
    const double ramp = k < 20 ? 0.05 * (20 - k) * (20 - k) : 0;
    log += std::to_string(k) + "," + number(k * 0.001) + ",synchronized_motion," +
           number(420 + 10.0 * k) + "," +
           number(840 + 20.0 * k + ramp + blade + (k == wrong_tick ? 1e-6 : 0)) + ",1,none,\n";
  }
  return log;
}

Designed ramped() {
  Designed designed = doubled();
  designed.ramp =
      CouplingSpec{.start = StartMode::ramp_in, .velocity_diff = 2000, .acceleration = 1e5};
  return designed;
}

TEST(Played, LeavesOutTheRamp) {
  Designed designed = ramped();
  designed.ramp->slave_period = 180;
  for (const double blade : {0.0, -180.0}) {
    const Played played =
        compare_played(read_played(ramped_log(400, blade, -1), "run.csv"), designed);
    EXPECT_TRUE(played.report.ok()) << played.table.error;
    EXPECT_TRUE(played.live);
    EXPECT_EQ(played.left_out, 20U);
    EXPECT_EQ(played.ticks, 380U);
  }
  // Without the ramp in the spec, the start is an error.
  EXPECT_FALSE(
      compare_played(read_played(ramped_log(400, 0, -1), "run.csv"), doubled()).report.ok());
}

// A slave with absolute positions and a period is shifted by whole periods; any other shift is reported.
TEST(Played, FindsAWrongShiftAfterTheRamp) {
  const auto played = [](double shift, const Designed& designed) {
    return compare_played(read_played(ramped_log(400, shift, -1), "run.csv"), designed);
  };
  Designed designed = ramped();
  EXPECT_EQ(played(0, designed).shift, 0);
  EXPECT_TRUE(played(-179.999, designed).report.ok());
  EXPECT_NEAR(played(-179.999, designed).shift, -179.999, 1e-9);
  designed.ramp->slave_period = 180;
  EXPECT_FALSE(played(-179.999, designed).report.ok());
  EXPECT_EQ(played(-180, designed).shift, -180);
}

TEST(Played, FindsOneWrongTickAfterTheRamp) {
  for (const int wrong : {30, 399}) {
    const Played played =
        compare_played(read_played(ramped_log(400, 0, wrong), "run.csv"), ramped());
    EXPECT_FALSE(played.report.ok()) << wrong;
    EXPECT_NEAR(played.table.error, 1e-6, 1e-10);
  }
}

// Another motion is no long ramp, even if its last ticks keep the distance of the cam.
TEST(Played, TheRampIsNotLongerThanItsLimitsPermit) {
  Designed other = ramped();
  other.over_master.table = [](double x) { return Motion{x < 4000 ? 2.001 * x : 2 * x, 2, 0, 0}; };
  const Played played = compare_played(read_played(ramped_log(400, 0, -1), "run.csv"), other);
  EXPECT_FALSE(played.report.ok());
  EXPECT_EQ(played.report.findings.front().rule, "played/table");
}

TEST(Played, StatesThatAMotionWithinItsRampCannotBeCompared) {
  EXPECT_EQ(test::error_of([&] {
              (void)compare_played(read_played(ramped_log(15, 0, -1), "run.csv"), ramped());
            }),
            "cannot be compared with the table: all 15 ticks of the motion may belong to the ramp "
            "of [coupling]: give the log of a longer motion");
}

// The same over time: a ramp on a virtual master.
TEST(Played, LeavesOutTheRampOverTime) {
  std::string log = header;
  for (int k = 0; k <= 400; ++k)
    log += std::to_string(k) + "," + number(k * 0.001) + ",synchronized_motion,0," +
           number(0.01 * k + (k < 20 ? 0.05 * (20 - k) * (20 - k) : 0)) + ",1,none\n";
  Designed designed = ramped();
  designed.over_master = {};
  designed.over_time = ramp.over_time;
  designed.duration = 0.4;
  const Played played = compare_played(read_played(log, "run.csv"), designed);
  EXPECT_TRUE(played.report.ok()) << played.table.error;
  EXPECT_EQ(played.left_out, 20U);
  EXPECT_FALSE(played.live);
}

}  // namespace
}  // namespace jounce::played_test
