// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear_course.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/gear/feasibility.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/dynamics.hpp"

#include "support/invariants.hpp"

namespace jounce::gear_course_test {
namespace {

GearCourse example_75() {
  return {.master_end = 200000, .changes = {{.at = 0, .ratio = 0.5, .distance = 100000}}};
}

TEST(GearCourse, OfGoogol75BehindItsMaster) {
  const SyncCam made = gear_course(example_75());
  EXPECT_EQ(made.segments, (std::vector<std::string>{"clutch", "gear"}));
  ASSERT_EQ(made.zones.size(), 1U);
  EXPECT_EQ(made.zones[0].from, 100000);
  EXPECT_DOUBLE_EQ(made.cam.jet(100000)[0], 25000);
  // Master: 100 pulse/ms with 1 pulse/ms^2, over ms.
  const Trajectory master = velocity_ramp(MotionState{}, 100, Dynamics{.acceleration = 1}).curve();
  const Trajectory run = concatenated(master, Trajectory({line(1500, 5000, 155000)}, 100));
  const Followed slave(made.cam, run);
  EXPECT_NEAR(slave.at(1050).position, 25000, 1e-9);
  EXPECT_NEAR(slave.at(1050).velocity, 50, 1e-12);
  EXPECT_NEAR(slave.at(1049, Side::left).velocity, 49.95, 1e-9);
  EXPECT_NEAR(slave.at(1600).position, 25000 + 55000 / 2.0, 1e-9);
  test::expect_invariants(made.cam, 1);
}

TEST(GearCourse, ChangesTheRatioOnTheFly) {
  // Fig. 7-10: 4:3, later 2:1 by a second clutch.
  const SyncCam made = gear_course({.master_start = -500,
                                    .master_end = 6000,
                                    .slave_start = 7,
                                    .changes = {{0, 0.75, 1000}, {3000, 0.5, 500}}});
  EXPECT_EQ(made.segments, (std::vector<std::string>{"hold", "clutch", "gear", "clutch", "gear"}));
  EXPECT_EQ(made.cam.jet(-100)[0], 7);
  EXPECT_NEAR(made.cam.jet(1000)[0], 7 + 375, 1e-10);
  EXPECT_NEAR(made.cam.jet(3000)[0], 7 + 375 + 1500, 1e-10);
  EXPECT_NEAR(made.cam.jet(3500)[0], 7 + 1875 + 312.5, 1e-10);
  EXPECT_NEAR(made.cam.jet(5999)[1], 0.5, 1e-15);
  test::expect_invariants(made.cam, 1);
}

TEST(GearCourse, CoversTheSameWayWithEverySymmetricLaw) {
  for (const LawInfo& law : all_laws()) {
    if (!has_own_shape(law.law) || law.law == Law::dwell || law.law == Law::scca ||
        reverses(law.ends))
      continue;  // scca takes a form
    try {
      const SyncCam made =
          gear_course({.master_end = 40, .ratio = -1, .changes = {{10, 3, 20, law.law}}});
      EXPECT_NEAR(made.cam.jet(30)[0], -10 + 20 * (-1 + 3) / 2.0, 1e-12) << law.name;
      test::expect_invariants(made.cam, law.law == Law::line ? 1 : 2);
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.rule()).find("degree"), std::string::npos)
          << law.name << " " << error.what();
    }
  }
}

TEST(GearCourse, LaysShiftsOverTheGear) {
  const SyncCam plain = gear_course(example_75());
  GearCourse course = example_75();
  course.shifts = {{.at = 50000, .shift = -300, .distance = 100000},
                   {.at = 120000, .shift = 100, .distance = 10000, .law = Law::simple_sine}};
  const SyncCam made = gear_course(course);
  EXPECT_NEAR(made.cam.jet(50000)[0], plain.cam.jet(50000)[0], 1e-9);
  EXPECT_NEAR(made.cam.jet(160000)[0], plain.cam.jet(160000)[0] - 200, 1e-9);
  const double z = 0.75;  // at 125000; the second one is half done
  const double poly345 = z * z * z * (10 + z * (-15 + 6 * z));
  EXPECT_NEAR(made.cam.jet(125000)[0], plain.cam.jet(125000)[0] - 300 * poly345 + 50, 1e-9);
  test::expect_invariants(made.cam, 1);
  ASSERT_EQ(made.zones.size(), 1U);
  EXPECT_EQ(made.zones[0].from, 150000) << "in step only where nothing shifts";
}

TEST(GearCourse, HoldsOutsideOnlyWhereItEndsAtRest) {
  EXPECT_EQ(gear_course(example_75()).cam.outside(), Extrapolation::refuse);
  const SyncCam stroke = gear_course({.master_end = 30, .changes = {{0, 1, 10}, {20, 0, 10}}});
  EXPECT_EQ(stroke.cam.outside(), Extrapolation::hold);
  EXPECT_DOUBLE_EQ(stroke.cam.jet(99)[0], 20);
}

TEST(GearCourse, StepsInVelocityAloneWhereTheDistanceIsNone) {
  const SyncCam made = gear_course({.master_end = 20, .ratio = 1, .changes = {{10, 2, 0}}});
  EXPECT_EQ(made.segments, (std::vector<std::string>{"gear", "gear"}));
  EXPECT_EQ(largest_jump(made.cam, 0).step, 0);
  EXPECT_EQ(largest_jump(made.cam, 1).step, 1);
}

TEST(GearCourse, RejectsContradictions) {
  const auto words = [](const GearCourse& course) -> std::string {
    try {
      gear_course(course);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(words({.master_start = 5, .master_end = 5}),
            "master_end = 5: must be greater than master_start, 5");
  EXPECT_EQ(words({.master_end = 50, .changes = {{0, 1, 20}, {10, 2, 5}}}),
            "change[2].at = 10: must be at least 20, the end of the previous change");
  EXPECT_EQ(words({.master_end = 50, .changes = {{40, 1, 20}}}),
            "change[1].distance = 20: must be at most 10: the change begins at 40 and must end at "
            "or before "
            "master_end = 50");
  EXPECT_EQ(words({.master_end = 50, .changes = {{10, 1, 20, Law::double_harmonic}}}),
            "change[1].law = double_harmonic: must be a line or a law from rest to rest");
  EXPECT_EQ(words({.master_end = 50, .shifts = {{10, 1, 20, Law::line}}}),
            "shift[1].law = line: must be a law from rest to rest");
  EXPECT_NE(words({.master_end = 50, .changes = {{10, 1, -2}}}), "");
  EXPECT_NE(words({.master_end = 50, .shifts = {{-10, 1, 2}}}), "");
}

TEST(Feasibility, NamesTheLimitThePlaceAndTheFastestMaster) {
  const SyncCam made = gear_course(example_75());
  // f' = 0.5 at most, f'' = 5e-6: 50 pulse/ms at 100, 0.05 pulse/ms^2 at 100.
  const Limits slave{.velocity = 60, .acceleration = 0.02};
  const Report report = feasibility(made.cam, slave, {.velocity = 100});
  ASSERT_EQ(report.findings.size(), 2U);
  const Finding& f = report.findings[0];
  EXPECT_TRUE(f.broken);
  EXPECT_EQ(f.rule, "feasible/acceleration");
  EXPECT_NEAR(f.limit, std::sqrt(0.02 / 5e-6), 1e-9);
  EXPECT_LE(f.where, 100000);
  EXPECT_NE(f.advice.find("slow the master down to 63.24"), std::string::npos) << f.advice;
  EXPECT_FALSE(report.findings[1].broken);
  EXPECT_NEAR(report.findings[1].limit, 120, 1e-9);
  EXPECT_TRUE(feasibility(made.cam, slave, {.velocity = 63}).ok());
  // f'' w^2 + f' a at the clutch's end: 5e-6 w^2 + 0.5 * 0.02.
  const Report live =
      feasibility(made.cam, slave, {.velocity = 50, .rates = {.acceleration = 0.02}});
  EXPECT_NEAR(live.findings[0].limit, std::sqrt(0.01 / 5e-6), 1e-9);
  EXPECT_NEAR(live.findings[0].where, 100000, 1e-6);
}

TEST(Feasibility, OfAGearAtOnceReportsThatNoSpeedIsLowEnough) {
  const SyncCam made = gear_course({.master_end = 20, .ratio = 1, .changes = {{10, 2, 0}}});
  const Report report = feasibility(made.cam, {.acceleration = 1}, {.velocity = 1e-6});
  ASSERT_EQ(report.broken(), 1U);
  EXPECT_EQ(report.findings[0].where, 10);
  EXPECT_EQ(report.findings[0].advice,
            "no speed of the master keeps the acceleration limit of the slave here");
}

}  // namespace
}  // namespace jounce::gear_course_test
