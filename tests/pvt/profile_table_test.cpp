// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/profile_table.hpp"

#include <array>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/warnings.hpp"

#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::pmc600 {
namespace {

using jounce::test::expect_invariants;
using jounce::test::Random;
using ::testing::HasSubstr;

/// PMC600 manual, figure 5.13.
ProfileTable fig_5_13() {
  return {.points = {{1, 10000}, {2, 40000}, {1, -10000}, {0.5, -5000}}, .is_absolute = false};
}

template <class Make>
std::string message(const Make& make) {
  return test::error_of([&] { (void)make(); });
}

TEST(PositionProfile, Figure513PassesItsKnotsByBothRules) {
  for (const PositionRule rule : {PositionRule::cubic, PositionRule::linear}) {
    const Trajectory f = position_profile(fig_5_13(), rule);
    EXPECT_EQ(f.end(), 4.5);
    for (const auto& [t, p] : {std::pair{0, 0.0}, {1, 10000.0}, {3, 50000.0}, {4, 40000.0}})
      EXPECT_NEAR(f.at(t).position, p, 1e-10);
    EXPECT_NEAR(f.at(4.5).position, 35000, 1e-10);
  }
}

TEST(PositionProfile, IsContinuousInVelocityAtRestAtItsEndsAndDoesNotOvershoot) {
  const Trajectory f = position_profile(fig_5_13());
  expect_invariants(f, 1);
  EXPECT_TRUE(velocity_steps(f).findings.empty());
  EXPECT_TRUE(overshoot(f).findings.empty());
  EXPECT_EQ(extrema(f, 0).max.where, 3);
  // (4): 3 * 3 / ((4 + 1) / 10000 + (2 + 2) / 20000)
  EXPECT_NEAR(f.at(1).velocity, 9 / (5e-4 + 2e-4), 1e-9);
}

TEST(PositionProfile, LinearStepsAtEveryPointWhichIsNamed) {
  const Report report = velocity_steps(position_profile(fig_5_13(), PositionRule::linear));
  ASSERT_EQ(report.findings.size(), 4U);  // 0 to 10000, 20000, -10000; -10000 goes on; to 0
  EXPECT_EQ(report.findings.front().value, -30000);
  EXPECT_EQ(report.findings.front().where, 3);
}

TEST(PositionProfile, ScalesThenShiftsOnce) {
  ProfileTable table = fig_5_13();
  table.scale = -2;
  table.offset = 7;
  table.from = 100;
  const Trajectory relative = position_profile(table);
  EXPECT_NEAR(relative.at(0).position, 100, 1e-12);
  EXPECT_NEAR(relative.at(1).position, 100 - 20000 + 7, 1e-9);
  EXPECT_NEAR(relative.at(4.5).position, 100 - 70000 + 7, 1e-9);
  table.is_absolute = true;
  const Trajectory absolute = position_profile(table);
  EXPECT_NEAR(absolute.at(0).position, 100, 1e-12);
  EXPECT_NEAR(absolute.at(1).position, -20000 + 7, 1e-9);
  EXPECT_NEAR(absolute.at(4.5).position, 10000 + 7, 1e-9);
}

TEST(PositionProfile, NeverOvershootsFromRest) {
  Random random(513);
  for (int n = 0; n < 500; ++n) {
    ProfileTable table;
    const double u = random.log_uniform(1e-6, 1e6);
    for (int i = 0; i < 10; ++i)
      table.points.push_back({random.log_uniform(1e-3, 10), u * random.uniform(-1, 1)});
    const Trajectory f = position_profile(table);
    EXPECT_TRUE(overshoot(f).findings.empty()) << "case " << n << " of seed 513";
    EXPECT_TRUE(check_continuity(f, 1).ok()) << "case " << n << " of seed 513";
  }
}

TEST(VelocityProfile, IsLinearInVelocityFromTheAxis) {
  const ProfileTable table{.points = {{1, 10}, {2, 10}, {1, 0}}, .from = 5};
  const Trajectory f = velocity_profile(table);
  EXPECT_EQ(f.at(0).velocity, 0);
  EXPECT_EQ(f.at(0.5).velocity, 5);
  EXPECT_EQ(f.at(4).position, 5 + 5 + 20 + 5);
  EXPECT_EQ(f.at(4, Side::left).velocity, 0);
  expect_invariants(f, 1);
  EXPECT_TRUE(velocity_steps(f).findings.empty());
  ProfileTable relative = table;
  relative.is_absolute = false;  // changes of the velocity: 10, 20, 20, from 3
  relative.from_velocity = 3;
  const Trajectory g = velocity_profile(relative);
  EXPECT_EQ(g.at(0).velocity, 3);
  EXPECT_EQ(g.at(1).velocity, 13);
  EXPECT_EQ(g.at(4, Side::left).velocity, 23);
}

TEST(VelocityProfile, ThatEndsMovingIsWarnedOf) {
  const Trajectory f = velocity_profile({.points = {{1, 10}, {2, 10}}});
  const Report report = velocity_steps(f);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].rule, "pt/end_velocity");
  EXPECT_EQ(report.findings[0].value, 10);
  EXPECT_EQ(f.at(10).velocity, 0);
  EXPECT_EQ(f.at(10).position, 25);
}

TEST(AccelerationProfile, IsLinearInAcceleration) {
  // 0 to 6, to 0, to -6, to 0 in 1 s each: from rest to rest, symmetric about 2 s.
  const Trajectory f = acceleration_profile({.points = {{1, 6}, {1, 0}, {1, -6}, {1, 0}}});
  expect_invariants(f, 2);
  EXPECT_EQ(f.at(1).velocity, 3);
  EXPECT_EQ(f.at(2).velocity, 6);
  EXPECT_EQ(f.at(1).position, 1);  // 6 / 6
  EXPECT_EQ(f.at(2).position, 6);
  EXPECT_EQ(f.at(4).position, 12);
  EXPECT_NEAR(f.at(4, Side::left).velocity, 0, 1e-15);
}

TEST(ProfileTables, NameTheControllersErrors) {
  ProfileTable table = fig_5_13();
  table.points[2].delta_time = 0;
  EXPECT_EQ(message([&] { (void)position_profile(table); }),
            "point[3].delta_time = 0: must be greater than 0 (PMC600 error 326)");
  EXPECT_THAT(message([&] { (void)velocity_profile(table); }), HasSubstr("error 351"));
  EXPECT_THAT(message([&] { (void)acceleration_profile(table); }), HasSubstr("error 376"));
  table.number_of_pairs = 2;  // the third is not played
  EXPECT_EQ(position_profile(table).end(), 3);
  table.array_size = 1;
  EXPECT_EQ(message([&] { (void)position_profile(table); }),
            "array_size = 1: must be 2, the points played, to 100 (PMC600 error 325)");
  table.number_of_pairs = 5;
  EXPECT_THAT(message([&] { (void)velocity_profile(table); }), HasSubstr("error 350"));
  EXPECT_THAT(message([&] { (void)acceleration_profile({}); }), HasSubstr("error 375"));
  EXPECT_EQ(message([&] {
              (void)position_profile({.points = std::vector<ProfilePoint>(101, {1, 1})});
            }),
            "point = 101 points: must be 1 to 100 (PMC600 error 325)");
}

}  // namespace
}  // namespace jounce::pmc600
