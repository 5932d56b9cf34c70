// SPDX-License-Identifier: Apache-2.0
// Words of the trade in a spec: rates over time, master rates, names of laws.
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/make.hpp"
#include "jounce/spec/detail/edit.hpp"
#include "jounce/spec/spec.hpp"

#include "support/errors.hpp"

namespace jounce::over_time_keys_test {
namespace {

using testing::HasSubstr;

const std::string master = "[master]\nvelocity = \"120 cpm\"\n";

std::string cam(const std::string& segments, const std::string& rest = master,
                const std::string& top = "periodic = true\n") {
  return "jounce = 1\nkind = \"cam\"\n" + top +
         "units = { master = \"deg\", position = \"mm\" }\nstart = { master = 0, slave = 0 }\n" +
         segments + rest;
}

std::string segment(const std::string& law, const std::string& end, const std::string& more = "") {
  return "[[segment]]\nlaw = \"" + law + "\"\nend = { " + end + " }\n" + more;
}

const std::string turn =
    segment("345", "master = 90, slave = 40") + segment("345", "master = 360, slave = 0");

Spec read(const std::string& text) {
  return parse_spec(text, "a.toml");
}

std::string complaint(const std::string& text) {
  return test::error_of([&] { (void)make(read(text)); });
}

// ---- [master] ----------------------------------------------------------------------------------

TEST(MasterRate, CountsCyclesOfTheCam) {
  for (const char* velocity : {"120 cpm", "120 1/min", "2 Hz", "2 1/s", "120 rpm", "2 rev/s"})
    EXPECT_DOUBLE_EQ(read(cam(turn, std::string("[master]\nvelocity = \"") + velocity + "\"\n"))
                         .master->velocity,
                     720)
        << velocity;
  // Two turns of the shaft in a cycle: 120 cpm are 240 rpm.
  const std::string two =
      segment("345", "master = 720, slave = 40") + segment("345", "master = 800, slave = 0");
  EXPECT_DOUBLE_EQ(read(cam(two)).master->velocity, 1600);
  EXPECT_DOUBLE_EQ(read(cam(two, "[master]\nvelocity = \"120 rpm\"\n")).master->velocity, 720);
}

TEST(MasterRate, IsInCyclesForAKnifeAsWell) {
  const Spec knife = read(
      "jounce = 1\nkind = \"knife\"\nunits = { master = \"mm\", position = \"deg\" }\n[knife]\n"
      "diameter = 200\ncut_length = 800\nsync_angle = 60\n[master]\nvelocity = \"150 cpm\"\n");
  EXPECT_DOUBLE_EQ(knife.master->velocity, 2000) << "2.5 cuts of 800 mm a second";
  EXPECT_DOUBLE_EQ(knife.master->distance, 800);
}

TEST(MasterRate, NeedsACycle) {
  const std::string once = cam(segment("345", "master = 90, slave = 40"), master, "");
  EXPECT_EQ(complaint(once),
            "a.toml:9:12: master.velocity = \"120 cpm\": counts cycles, but this motion does not "
            "repeat: give the velocity in deg/s");
  EXPECT_EQ(complaint(cam(turn, "[master]\nvelocity = \"0 cpm\"\n")),
            "a.toml:13:12: master.velocity = \"0 cpm\": must be greater than 0");
  EXPECT_EQ(complaint(cam(turn, "[master]\nvelocity = \"120 mm/s\"\n")),
            "a.toml:13:12: master.velocity = \"120 mm/s\": mm/s is not a unit of this quantity: "
            "give the value in deg/s");
}

TEST(MasterDistance, IsOneCycleAtFullSpeedWithItsRamps) {
  EXPECT_DOUBLE_EQ(read(cam(turn)).master->distance, 360);
  // Ramps of 0.5 s: 360 deg in both together.
  EXPECT_DOUBLE_EQ(read(cam(turn, master + "acceleration = 1440\n")).master->distance, 720);
  EXPECT_DOUBLE_EQ(read(cam(turn, master + "acceleration = 1400\n")).master->distance, 1080);
  EXPECT_DOUBLE_EQ(read(cam(turn, master + "distance = 100\n")).master->distance, 100);
  const std::string once = segment("345", "master = 90, slave = 40");
  EXPECT_DOUBLE_EQ(read(cam(once, "[master]\nvelocity = 720\n", "")).master->distance, 90);
  EXPECT_DOUBLE_EQ(make_master(read(cam(turn))).end(), 0.5) << "s for a cycle";
}

/// A pass begins at a position of the master, which may have any distance to it.
TEST(MasterDistance, IsRequiredWhereNothingDefinesIt) {
  EXPECT_EQ(
      complaint("jounce = 1\nkind = \"follow\"\nunits = { master = \"deg\", position = \"deg\" "
                "}\n[follow]\npass = { position = 90 }\n[[segment]]\nmaster = 100\nslave = 50\n"
                "[[segment]]\nmaster = 200\nslave = 100\ntype = \"stop\"\n"
                "[master]\nvelocity = 360\n"),
      "a.toml:13:1: master.distance: is missing: add distance = NUMBER, in deg");
  EXPECT_EQ(complaint(cam(turn, master + "acceleration = 0\n")),
            "a.toml:14:16: master.acceleration = 0 deg/s^2: must be greater than 0");
}

// ---- knots -------------------------------------------------------------------------------------

TEST(KnotsOverTime, AreTakenAtTheSpeedOfTheMaster) {
  const Spec spec = read(cam(
      segment("quintic", "master = 60, slave = 10, velocity = \"0.36 m/s\", acceleration = 5184") +
      segment("quintic", "master = 360, slave = 0")));
  const CamKnot& end = std::get<CamSpec>(spec.subject).segments[0].end;
  EXPECT_DOUBLE_EQ(*end.geo_velocity, 0.5) << "360 mm/s at 720 deg/s";
  EXPECT_DOUBLE_EQ(*end.geo_acceleration, 0.01) << "5184 mm/s^2 at (720 deg/s)^2";
}

TEST(KnotsOverTime, PointsOfASplineAndFreeValuesToo) {
  const Spec spec = read(
      cam(segment("hermite", "master = 90, slave = 0",
                  "points = [{ master = 45, slave = 10, velocity = 72, acceleration = 0, jerk = "
                  "\"373.248 m/s^3\" }]\n") +
          segment("quintic", "master = 360, slave = 0") +
          "free = { velocity = [-360, 720], acceleration = [\"-5.184 m/s^2\", 0] }\n"));
  const CamPoint& point = std::get<CamSpec>(spec.subject).segments[0].points[0];
  EXPECT_DOUBLE_EQ(*point.geo_velocity, 0.1);
  EXPECT_DOUBLE_EQ(*point.geo_jerk, 0.001);
  const FreeKnot& free = spec.optimize.free.front();
  EXPECT_DOUBLE_EQ(free.geo_velocity->lower, -0.5);
  EXPECT_DOUBLE_EQ(free.geo_velocity->upper, 1);
  EXPECT_DOUBLE_EQ(free.geo_acceleration->lower, -0.01);
}

TEST(MasterRate, ALastKnotThatDoesNotFollowIsTheOnlyError) {
  const std::string wrong = segment("345", "master = 90, slave = 40, velocity = 0") +
                            segment("345", "master = 0, slave = 0");
  EXPECT_EQ(
      complaint(cam(wrong)),
      "a.toml:11:18: segment[2].end.master = 0 deg: must be greater than 90 deg, the previous "
      "knot: the last knot of a periodic cam is the end of its turn");
}

TEST(MasterRate, AWrongMasterDoesNotMakeTheCouplingUnknown) {
  EXPECT_EQ(complaint(cam(turn,
                          "[coupling]\nstart = \"absolute\"\n[master]\nvelocity = 1\n"
                          "distance = 0\n")),
            "a.toml:16:12: master.distance = 0 deg: must be greater than 0");
}

TEST(KnotsOverTime, NeedASpeedAndOneKey) {
  const std::string knot = "master = 60, slave = 10, velocity = 300";
  EXPECT_EQ(complaint(cam(segment("quintic", knot), "", "")),
            "a.toml:7:45: segment[1].end.velocity = 300 mm/s: is over time and needs the speed of "
            "the master: "
            "add [master] with velocity, or give geo_velocity");
  EXPECT_EQ(complaint(cam(segment("quintic", knot + ", geo_velocity = 1"),
                          "[master]\nvelocity = 720\n", "")),
            "a.toml:7:45: segment[1].end.velocity = 300 mm/s: cannot be combined with "
            "geo_velocity: give one "
            "of the two");
  EXPECT_EQ(complaint(cam(segment("quintic", "master = 60, slave = 10, velocity = \"3 m\""),
                          "[master]\nvelocity = 720\n", "")),
            "a.toml:7:45: segment[1].end.velocity = \"3 m\": m is not a unit of this quantity: "
            "give the value in mm/s");
  EXPECT_EQ(complaint(cam(segment("quintic", knot), "[master]\nvelocity = -1\n", "")),
            "a.toml:9:12: master.velocity = -1 deg/s: must be greater than 0")
      << "the knot is no second error";
  EXPECT_EQ(complaint(cam(segment("quintic", knot), "[master]\nvelocity = \"0 rev/min\"\n", "")),
            "a.toml:9:12: master.velocity = \"0 rev/min\": must be greater than 0");
}

TEST(KnotsOverTime, AnOptimizedKnotKeepsItsKey) {
  const Spec spec =
      read(cam(segment("quintic", "master = 60, slave = 10, velocity = 300, acceleration = 0",
                       "free = { velocity = [0, 600] }\n") +
               segment("quintic", "master = 360, slave = 0")));
  CamSpec better = std::get<CamSpec>(spec.subject);
  better.segments[0].end.geo_velocity = 0.5;
  const std::string text = with_knots(spec, better);
  EXPECT_THAT(text, HasSubstr("velocity = 360, acceleration = 0"));
  EXPECT_THAT(text, testing::Not(HasSubstr("geo_velocity")));
}

TEST(LimitsOverTime, BelongToTheSlave) {
  EXPECT_EQ(complaint(cam(turn, "[limits]\nacceleration = \"15 m/s^2\"\n")),
            "a.toml:13:16: limits.acceleration = \"15 m/s^2\": is a limit over time: give it in "
            "[limits.slave]");
}

// ---- a line that keeps its speed ---------------------------------------------------------------

std::string with_line(const std::string& end, const std::string& more = "") {
  return cam(segment("quintic", "master = 60, slave = 10") + segment("line", end, more) +
             segment("quintic", "master = 360, slave = 0"));
}

TEST(LineAtASpeed, DefinesItsEnd) {
  for (const char* end : {"master = 84, velocity = \"0.3 m/s\"",
                          "master = 84, geo_velocity = "
                          "0.4166666666666667"}) {
    const Spec spec = read(with_line(end));
    EXPECT_DOUBLE_EQ(std::get<CamSpec>(spec.subject).segments[1].end.slave, 20) << end;
    EXPECT_EQ(complaint(with_line(end)), "") << end;
  }
  EXPECT_EQ(complaint(with_line("master = 84")),
            "a.toml:11:7: segment[2].end.slave: is missing: add slave = NUMBER, in mm");
}

TEST(LineAtASpeed, IsNotMovedByFreeKnots) {
  const std::string line = "master = 84, velocity = 300";
  EXPECT_EQ(complaint(with_line(line, "free = { master = [80, 90] }\n")),
            "a.toml:11:7: segment[2].end.slave: is missing: it follows from the velocity of the "
            "line only if neither the line nor its knots are free. Add slave = NUMBER, or replace "
            "free with [[optimize.parameter]]");
}

// ---- laws and units ----------------------------------------------------------------------------

TEST(LawsOfOtherTools, AreNamedInTheError) {
  EXPECT_EQ(complaint(cam(segment("cycloidal", "master = 90, slave = 40"), "", "")),
            "a.toml:6:7: segment[1].law = \"cycloidal\": is called \"inclined_sine\" here");
  EXPECT_EQ(complaint(cam(segment("poly5", "master = 90, slave = 40"), "", "")),
            "a.toml:6:7: segment[1].law = \"poly5\": is called \"quintic\" here; between two rests "
            "it is the same as \"345\"");
  EXPECT_THAT(complaint("jounce = 1\nkind = \"indexer\"\nunits = { master = \"deg\", position = "
                        "\"mm\" }\n[indexer]\ndistance = 1\ncycle = 360\nmotion = 90\nlaw = "
                        "\"Bestehorn\"\n"),
              HasSubstr("indexer.law = \"Bestehorn\": is called \"inclined_sine\" here"));
}

TEST(UnitsOfPositions, MeasureAPosition) {
  for (const char* unit : {"N", "mm/s", "1/min", "kg", "A"}) {
    std::string text = cam(turn);
    text.replace(text.find("\"deg\""), 5, std::string("\"") + unit + "\"");
    EXPECT_THAT(complaint(text), HasSubstr("is not a unit of a master: give an angle")) << unit;
  }
  for (const char* unit : {"s", "N", "mm/s", "deg^2"}) {
    std::string text = cam(turn);
    text.replace(text.find("\"mm\""), 4, std::string("\"") + unit + "\"");
    EXPECT_THAT(complaint(text), HasSubstr("is not a unit of position: give a length")) << unit;
  }
}

}  // namespace
}  // namespace jounce::over_time_keys_test
