// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/line_follow.hpp"

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/errors.hpp"

namespace jounce::line_follow_test {
namespace {

TEST(LineFollow, OfExample67TakesTwoAndAHalfSeconds) {
  // PMC600 manual 6.3, example 6.7; as a trapezoid 2.5 s, slave peak 1000.
  const Trajectory master = trapezoid({.to = 4000, .velocity = 2000, .acceleration = 4000}).curve();
  const Trajectory slave = line_follow(master, 0, 2000);
  EXPECT_DOUBLE_EQ(slave.end(), 2.5);
  EXPECT_DOUBLE_EQ(extrema(slave, 1).max.value, 1000);
  EXPECT_DOUBLE_EQ(slave.at(2.5).position, 2000);
  for (int i = 0; i <= 100; ++i)
    EXPECT_NEAR(slave.at(i * 0.025).position, master.at(i * 0.025).position / 2, 1e-12);

  const auto both = pmc600::line_follow({.end_master = 4000,
                                         .end_slave = 2000,
                                         .velocity = 2000,
                                         .acceleration = 4000,
                                         .deceleration = 4000});
  EXPECT_NEAR(both.slave.end(), 2.5 + 4000 / 90e6, 1e-12) << "the jerk's share";
  EXPECT_EQ(both.slave.end(), both.master.end());
  EXPECT_NEAR(extrema(both.slave, 1).max.value, 1000, 1e-9);
}

TEST(LineFollow, RelativeCountsFromWhereTheAxesStand) {
  const auto both = pmc600::line_follow({.start_master = 100,
                                         .start_slave = -50,
                                         .end_master = -400,
                                         .end_slave = 30,
                                         .relative = true,
                                         .velocity = 200,
                                         .acceleration = 400,
                                         .deceleration = 800});
  EXPECT_NEAR(both.master.at(both.master.end()).position, -300, 1e-9);
  EXPECT_NEAR(both.slave.at(both.slave.end()).position, -20, 1e-9);
  EXPECT_EQ(both.slave.at(0).position, -50);
}

TEST(LineFollow, RejectsZeroes) {
  const pmc600::LineFollow fine{
      .end_master = 10, .end_slave = 5, .velocity = 1, .acceleration = 1, .deceleration = 1};
  EXPECT_NO_THROW(pmc600::line_follow(fine));
  const auto key_of = [&](auto change) -> std::string {
    pmc600::LineFollow spec = fine;
    change(spec);
    return test::key_of([&] { pmc600::line_follow(spec); });
  };
  EXPECT_EQ(key_of([](auto& s) { s.velocity = 0; }), "velocity");
  EXPECT_EQ(key_of([](auto& s) { s.acceleration = 0; }), "acceleration");
  EXPECT_EQ(key_of([](auto& s) { s.deceleration = 0; }), "deceleration");
  EXPECT_EQ(key_of([](auto& s) { s.jerk = 0; }), "jerk");
  EXPECT_EQ(key_of([](auto& s) { s.ipo_cycle = 0; }), "ipo_cycle");
  EXPECT_EQ(key_of([](auto& s) { s.end_master = 0; }), "end_master");
  EXPECT_THROW(line_follow(Trajectory({line(1, 3, 3)}), 0, 1), InputError);
}

}  // namespace
}  // namespace jounce::line_follow_test
