#include "jounce/executor/played.hpp"

#include <string>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
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

const Designed ramp{[](double t) { return 10 * t; }, 0.2, 2};

TEST(Played, ComparesEveryTickOfTheLastMotion) {
  const auto ticks = read_played(two_motions(2), "run.csv");
  ASSERT_EQ(ticks.size(), 3U);
  EXPECT_NEAR(ticks[1].time, 0.1, 1e-15);
  const Played played = compare_played(ticks, ramp);
  EXPECT_TRUE(played.report.ok());
  EXPECT_LT(played.error, 1e-14);
}

TEST(Played, FindsOneWrongTick) {
  const Played played = compare_played(read_played(two_motions(2.5), "run.csv"), ramp);
  EXPECT_FALSE(played.report.ok());
  EXPECT_EQ(played.report.findings.front().rule, "played/position");
  EXPECT_NEAR(played.error, 0.5, 1e-14);
  EXPECT_NEAR(played.where, 0.2, 1e-14);
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
      compare_played(read_played(log, "run.csv"), {[](double t) { return 10 * t; }, 0.4, 4});
  EXPECT_FALSE(played.report.ok());
  EXPECT_EQ(played.report.findings.front().rule, "played/gap");
  EXPECT_EQ(played.report.findings.front().value, 151);
}

std::string complaint(const std::string& csv) {
  try {
    (void)read_played(csv, "run.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Played, RefusesWhatIsNoLog) {
  EXPECT_EQ(complaint(""), "run.csv:1: tick: is missing: this is not a tick log");
  EXPECT_EQ(complaint("a,b\n1,2\n"), "run.csv:1: tick: is missing: this is not a tick log");
  EXPECT_EQ(complaint(header), "run.csv: job: the log holds no motion");
  EXPECT_EQ(complaint(header + "0,0,standstill,0,0,0,none\n1,0.1,discr"),
            "run.csv:3: row = 1,0.1,discr: does not have as many values as the header");
  EXPECT_EQ(complaint(header + "0,0,discrete_motion,0,nan,1,none\n"),
            "run.csv:2: position = nan: must be a finite number");
}

}  // namespace
}  // namespace jounce
