// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::coupling_test {
namespace {

/// 90 u in 360 m from rest to rest, again and again.
Cam indexing(Extrapolation outside = Extrapolation::wrap) {
  CamSpec spec;
  spec.segments = {{Law::quintic, {360, 90, 0, 0}, ""}};
  return with(design(spec).cam, outside);
}

Cam ramp() {  // y = 2x on [0, 10], once
  return Cam({line(10, 0, 20)}, 0, Extrapolation::hold);
}

CouplingSpec ramping(StartMode start = StartMode::ramp_in) {
  return {
      .start = start, .velocity_diff = 50, .acceleration = 200, .deceleration = 100, .jerk = 5000};
}

TEST(Coupling, ScalesAndMovesMasterAndSlave) {
  // X = 2 * 3 - 1 = 5, y = 3 * 10 + 7; y' = 3 * 2 * 2 x'.
  const Coupling coupling(
      ramp(), {.master_scaling = 2, .master_offset = -1, .slave_scaling = 3, .slave_offset = 7});
  const Jet master{3, 0.5, 0.25, 0.125};
  const Engagement in = engage(coupling, {}, master, 0);
  ASSERT_TRUE(in);
  const Jet y = point(coupling, in.engaged, master, 0);
  EXPECT_DOUBLE_EQ(y[0], 37);
  EXPECT_DOUBLE_EQ(y[1], 6);
  EXPECT_DOUBLE_EQ(y[2], 3);
  EXPECT_DOUBLE_EQ(y[3], 1.5);
  EXPECT_DOUBLE_EQ(in.jump.position, 37) << "from 0";
}

TEST(Coupling, AMasterAtRestOnTheSeamTakesTheSideItStartsTo) {
  // 90 u in 360 m, again and again: at 0 the slave is at 0 ahead and at 90 behind.
  const Coupling coupling(indexing());
  const auto at = [&](const Jet& master, Side side) {
    return placed(coupling.cam(), coupling.placement(), master, side)[0];
  };
  EXPECT_EQ(at({0, 0, 100, 0}, Side::right), 0);
  EXPECT_EQ(at({0, 0, -100, 0}, Side::right), 90);
  EXPECT_EQ(at({0, 0, 0, -100}, Side::right), 90);
  EXPECT_EQ(at({0, 0, -100, 0}, Side::left), 90) << "it came forwards, and turns";
  EXPECT_EQ(at({0, 0, 100, 0}, Side::left), 0) << "it came backwards, and turns";
  EXPECT_EQ(at({0, 5, 0, 0}, Side::left), 90);
  EXPECT_EQ(at({0, -5, 0, 0}, Side::left), 0);
  EXPECT_EQ(at({360 - 1e-11, 5, 0, 0}, Side::right), 0) << "on the seam but for rounding";
}

TEST(Coupling, HasTheTableOfModes) {
  // The master stands at 90 of a cam y = x (0 to 360), the slave at 5: where is it at 100?
  const Cam cam({line(360, 0, 360)}, 0, Extrapolation::wrap);
  struct Row {
    bool master_absolute, slave_absolute;
    StartMode start;
    double jump, at_100;
  };
  const Row rows[] = {{true, true, StartMode::absolute, 85, 100},
                      {false, true, StartMode::absolute, -5, 10},
                      {true, false, StartMode::absolute, 0, 15},
                      {false, false, StartMode::absolute, 0, 15},
                      {true, true, StartMode::relative, 0, 15},
                      {false, true, StartMode::relative, 0, 15},
                      {true, false, StartMode::relative, 0, 15},
                      {true, true, StartMode::ramp_in, 0, 100},
                      {false, true, StartMode::ramp_in, 0, 10},
                      {true, false, StartMode::ramp_in, 0, 15},
                      {true, true, StartMode::ramp_in_distance, 0, 100},
                      {true, false, StartMode::ramp_in_distance, 0, 15}};
  for (const Row& row : rows) {
    CouplingSpec spec = ramping(row.start);
    spec.distance = 5;
    spec.master_absolute = row.master_absolute;
    spec.slave_absolute = row.slave_absolute;
    const Coupling coupling(cam, spec);
    const Engagement in = engage(coupling, {.position = 5}, {90, 0, 0, 0}, 0);
    ASSERT_TRUE(in);
    const std::string which = std::string(name(row.start)) + (row.master_absolute ? " M" : " m") +
                              (row.slave_absolute ? "S" : "s");
    EXPECT_DOUBLE_EQ(in.jump.position, row.jump) << which;
    EXPECT_DOUBLE_EQ(point(coupling, in.engaged, {90, 0, 0, 0}, 0)[0], 5 + row.jump) << which;
    EXPECT_DOUBLE_EQ(point(coupling, in.engaged, {100, 0, 0, 0}, 1e3)[0], row.at_100) << which;
  }
}

TEST(Coupling, ASlaveOffsetMovesARelativeCamToo) {
  const Coupling jumps(indexing(), {.slave_offset = 3, .start = StartMode::relative});
  EXPECT_DOUBLE_EQ(engage(jumps, {.position = 5}, {90, 0, 0, 0}, 0).jump.position, 3);
  CouplingSpec spec = ramping();
  spec.slave_offset = 3;
  spec.slave_absolute = false;
  const Coupling ramps(indexing(), spec);
  const Engagement in = engage(ramps, {.position = 5}, {90, 0, 0, 0}, 0);
  EXPECT_DOUBLE_EQ(point(ramps, in.engaged, {90, 0, 0, 0}, 0)[0], 5);
  EXPECT_DOUBLE_EQ(point(ramps, in.engaged, {90, 0, 0, 0}, 1e3)[0], 8);
}

TEST(Coupling, RampsInAsAMoveFromTheDifferenceToZero) {
  // Slave 10 u behind a cam at rest: 50 u/s, 200 up, 100 down, 5000.
  const Coupling coupling(indexing(), ramping());
  const Engagement in = engage(coupling, {.position = -10}, {0, 0, 0, 0}, 2);
  ASSERT_TRUE(in);
  const Profile& c = in.engaged.correction.profile();
  EXPECT_DOUBLE_EQ(c.start().position, -10);
  EXPECT_EQ(c.end(), MotionState{});
  const Ranges ranges = extrema(c.curve());
  EXPECT_NEAR(ranges[2].max.value, 200, 1e-9) << "speeding up by acceleration";
  EXPECT_NEAR(ranges[2].min.value, -100, 1e-9) << "slowing down by deceleration";
  EXPECT_LE(ranges[1].max.value, 50);
  EXPECT_NEAR(ranges[3].peak().value, 5000, 1e-9);
  EXPECT_DOUBLE_EQ(point(coupling, in.engaged, {0, 0, 0, 0}, 2)[0], -10);
  EXPECT_NEAR(point(coupling, in.engaged, {0, 0, 0, 0}, 2 + c.duration())[0], 0, 1e-15);

  const Engagement back = engage(coupling, {.position = 10}, {0, 0, 0, 0}, 2);
  const Ranges mirrored = extrema(back.engaged.correction.profile().curve());
  EXPECT_NEAR(mirrored[2].min.value, -200, 1e-9) << "speeding up backwards";
  EXPECT_NEAR(mirrored[2].max.value, 100, 1e-9);
}

TEST(Coupling, TakesUpVelocityAndAccelerationWithoutAJump) {
  const Coupling coupling(indexing(), ramping());
  const MotionState slave{12, -30, 40};
  const Jet master{100, 200, 50, 0};
  const Engagement in = engage(coupling, slave, master, 7);
  ASSERT_TRUE(in);
  const Jet y = point(coupling, in.engaged, master, 7);
  EXPECT_NEAR(y[0], slave.position, 1e-12);
  EXPECT_NEAR(y[1], slave.velocity, 1e-12);
  EXPECT_NEAR(y[2], slave.acceleration, 1e-11);
  EXPECT_EQ(in.jump, MotionState{});
}

TEST(Coupling, ARotarySlaveTakesTheWayThatIsAskedFor) {
  // At 100, the cam at 0, 360 a turn: back 100, on 260.
  const auto travel = [](StartMode start) {
    CouplingSpec spec = ramping(start);
    spec.slave_period = 360;
    const Coupling coupling(indexing(), spec);
    const Engagement in = engage(coupling, {.position = 100}, {0, 0, 0, 0}, 0);
    return point(coupling, in.engaged, {0, 0, 0, 0}, 1e3)[0] - 100;
  };
  EXPECT_DOUBLE_EQ(travel(StartMode::ramp_in), -100);
  EXPECT_DOUBLE_EQ(travel(StartMode::ramp_in_pos), 260);
  EXPECT_DOUBLE_EQ(travel(StartMode::ramp_in_neg), -100);
}

TEST(Coupling, ARotarySlaveNeverReverses) {
  CouplingSpec spec = ramping(StartMode::ramp_in_pos);
  spec.slave_period = 360;
  const Coupling coupling(indexing(), spec);
  // 1 u before the cam at 50 u/s: it cannot stop there, and goes on to the next turn.
  const Engagement in = engage(coupling, {.position = -1, .velocity = 50}, {0, 0, 0, 0}, 0);
  ASSERT_TRUE(in);
  EXPECT_DOUBLE_EQ(point(coupling, in.engaged, {0, 0, 0, 0}, 1e3)[0], 360);
  EXPECT_GE(extrema(in.engaged.correction.profile().curve())[1].min.value, -1e-9);
}

TEST(Coupling, ALinearSlaveIsRejectedTheWrongWay) {
  const Coupling positive(indexing(), ramping(StartMode::ramp_in_pos));
  const Coupling negative(indexing(), ramping(StartMode::ramp_in_neg));
  const auto status = [](const Coupling& c, const MotionState& slave) {
    return engage(c, slave, {0, 0, 0, 0}, 0).status;
  };
  EXPECT_EQ(status(positive, {.position = -10}), CouplingStatus::ok);
  EXPECT_EQ(status(positive, {.position = 10}), CouplingStatus::would_reverse);
  EXPECT_EQ(status(negative, {.position = 10}), CouplingStatus::ok);
  EXPECT_EQ(status(negative, {.position = -10}), CouplingStatus::would_reverse);
  EXPECT_EQ(status(positive, {}), CouplingStatus::ok) << "it is there";
  EXPECT_EQ(status(positive, {.position = -1, .velocity = 50}), CouplingStatus::would_reverse)
      << "it would overshoot";
  EXPECT_EQ(status(positive, {.position = -10, .velocity = -20}), CouplingStatus::ok)
      << "it has to brake before it can go the right way";
}

TEST(Coupling, RoundingGivesADirectionNoWay) {
  const Jet master{50.3, 0, 0, 0};
  for (const double period : {0.0, 360.0})
    for (const StartMode mode : {StartMode::ramp_in_pos, StartMode::ramp_in_neg})
      for (const double off : {0.0, 5e-14, -5e-14, 5e-11, -5e-11, 1e-8, -1e-8})
        for (const double turns : {0.0, 3.0}) {
          CouplingSpec spec = ramping(mode);
          spec.slave_offset = 10;
          if (period > 0) spec.slave_period = period;
          const Coupling coupling(indexing(), spec);
          const double y = placed(coupling.cam(), coupling.placement(), master)[0];
          const double at = y + turns * period + off;
          const Engagement in = engage(coupling, {.position = at}, master, 0);
          ASSERT_TRUE(in) << name(in.status) << " " << off;
          EXPECT_NEAR(point(coupling, in.engaged, master, 1e3)[0], at, 1.1e-8) << name(mode) << off;
          // Nor does a trace of speed that halts it there.
          const Engagement moving = engage(coupling, {.position = at, .velocity = 1e-9}, master, 0);
          ASSERT_TRUE(moving) << name(moving.status) << " " << off;
          EXPECT_NEAR(point(coupling, moving.engaged, master, 1e3)[0], at, 2e-8) << off;
        }
  // Beyond rounding it is a way: a linear slave is refused, a rotary one goes round.
  CouplingSpec spec = ramping(StartMode::ramp_in_pos);
  EXPECT_EQ(engage(Coupling(indexing(), spec), {.position = 1e-6}, {}, 0).status,
            CouplingStatus::would_reverse);
  spec.slave_period = 360;
  const Coupling rotary(indexing(), spec);
  const Engagement round = engage(rotary, {.position = 1e-6}, {}, 0);
  EXPECT_DOUBLE_EQ(point(rotary, round.engaged, {}, 1e3)[0], 360);
}

TEST(Coupling, ACorrectionThatNoDoubleHoldsIsRejected) {
  for (const auto& [distance, slave, x] : {std::tuple{2.7e230, 99.0, Jet{0, 4e-6, 0, 0}},
                                           {1e-130, 5.0, Jet{0, 1, 0, 0}},
                                           {4e180, 1e-10, Jet{0, 7e-10, 0, 0}},
                                           {1e80, 1e262, Jet{0, 6e3, 0, 0}}}) {
    const Coupling coupling(indexing(),
                            {.start = StartMode::ramp_in_distance, .distance = distance});
    const Engagement in = engage(coupling, {slave, 6e-9, 8e54}, x, 0);
    if (in) {
      for (const double v : point(coupling, in.engaged, x, 0)) EXPECT_TRUE(std::isfinite(v));
    } else {
      EXPECT_EQ(in.status, CouplingStatus::no_ramp);
    }
  }
  const Coupling far(indexing(), {.start = StartMode::ramp_in_distance, .distance = 1e230});
  EXPECT_EQ(engage(far, {1, 1, 1}, {0, 1e-6, 0, 0}, 0).status, CouplingStatus::no_ramp);
}

TEST(Coupling, RampsInOverADistanceOfTheMasterInEitherDirection) {
  const Coupling coupling(indexing(), {.start = StartMode::ramp_in_distance, .distance = 40});
  const MotionState slave{3, 25, -100};
  const Jet master{100, 200, 50, 0};
  const Engagement in = engage(coupling, slave, master, 0);
  ASSERT_TRUE(in);
  const Jet y = point(coupling, in.engaged, master, 0);
  EXPECT_NEAR(y[0], slave.position, 1e-12);
  EXPECT_NEAR(y[1], slave.velocity, 1e-12);
  EXPECT_NEAR(y[2], slave.acceleration, 1e-10);
  for (const double x : {60.0, 140.0, 141.0})
    EXPECT_EQ(point(coupling, in.engaged, {x, 200, 0, 0}, 9)[0],
              placed(coupling.cam(), in.engaged.placement, {x, 200, 0, 0})[0])
        << x;
  EXPECT_EQ(point(coupling, in.engaged, {110, 0, 0, 0}, 1)[0],
            point(coupling, in.engaged, {110, 0, 0, 0}, 2)[0])
      << "it waits for the master";
}

TEST(Coupling, TheCorrectionOverMasterHasItsOwnDerivatives) {
  const Correction c = Correction::over_master({3, -0.5, 0.02, 0}, 10, 8);
  const double h = 1e-5;
  for (const double x : {3.0, 9.0, 10.5, 13.0, 17.5}) {
    const auto at = [&](double u) { return c.jet(0, {u, 1, 0, 0}); };
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR((at(x + h)[k] - at(x - h)[k]) / (2 * h), at(x)[k + 1], 1e-7) << x << " " << k;
  }
  // (1 - s)^3 (p0 + (p1 + 3 p0) s + (p2 + 3 p1 + 6 p0) s^2) at s = 1/2, p = 3, -4, 0.64.
  const Jet middle = c.jet(0, {14, 1, 0, 0});
  EXPECT_DOUBLE_EQ(middle[0], 0.125 * (3 + 0.5 * 5 + 0.25 * (0.64 + 3 * -4.0 + 18)));
}

TEST(Coupling, RejectsWhatItCannotDo) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Coupling once(with(ramp(), Extrapolation::refuse), {.master_offset = 1});
  EXPECT_EQ(engage(once, {}, {9.1, 0, 0, 0}, 0).status, CouplingStatus::master_outside_cam);
  EXPECT_EQ(engage(once, {}, {-1.1, 0, 0, 0}, 0).status, CouplingStatus::master_outside_cam);
  EXPECT_EQ(engage(once, {}, {9, 0, 0, 0}, 0).status, CouplingStatus::ok);
  EXPECT_EQ(engage(Coupling(ramp()), {}, {11, 0, 0, 0}, 0).jump.position, 20)
      << "a cam that holds has a value everywhere";
  EXPECT_EQ(engage(once, {}, {nan, 0, 0, 0}, 0).status, CouplingStatus::not_finite);
  EXPECT_EQ(engage(once, {nan, 0, 0}, {}, 0).status, CouplingStatus::not_finite);
  EXPECT_EQ(engage(once, {}, {}, nan).status, CouplingStatus::not_finite);

  const Coupling over_master(indexing(), {.start = StartMode::ramp_in_distance, .distance = 40});
  EXPECT_EQ(engage(over_master, {0, 5, 0}, {}, 0).status, CouplingStatus::master_stands);
  EXPECT_EQ(engage(over_master, {5, 0, 0}, {}, 0).status, CouplingStatus::ok);

  const Coupling huge(indexing(), ramping());
  EXPECT_EQ(engage(huge, {1e60, 0, 0}, {}, 0).status, CouplingStatus::no_ramp);
}

TEST(Coupling, RejectsABadSpecByItsKey) {
  const auto key = [](const CouplingSpec& spec) -> std::string {
    return test::key_of([&] { require_valid(spec); });
  };
  EXPECT_EQ(key({}), "");
  EXPECT_EQ(key({.master_scaling = 0}), "master_scaling");
  EXPECT_EQ(key({.master_scaling = -1}), "master_scaling");
  EXPECT_EQ(key({.slave_scaling = -1}), "slave_scaling");
  EXPECT_EQ(key({.slave_offset = INFINITY}), "slave_offset");
  EXPECT_EQ(key({.start = StartMode::ramp_in, .acceleration = 1}), "velocity_diff");
  EXPECT_EQ(key({.start = StartMode::ramp_in_neg, .velocity_diff = 1}), "acceleration");
  EXPECT_EQ(key({.start = StartMode::ramp_in_distance}), "distance");
  EXPECT_EQ(key({.velocity_diff = -1}), "velocity_diff") << "even where it is not used";
  EXPECT_EQ(key({.slave_period = 0}), "slave_period");
}

TEST(Coupling, ContinuesFromPeriodToPeriodWhereItIsRelative) {
  const Coupling relative(indexing(), {.start = StartMode::relative});
  const Engagement in = engage(relative, {.position = 7}, {0, 0, 0, 0}, 0);
  EXPECT_DOUBLE_EQ(point(relative, in.engaged, {720, 1, 0, 0}, 0)[0], 7 + 180);
  EXPECT_DOUBLE_EQ(point(relative, in.engaged, {-180, 1, 0, 0}, 0)[0], 7 - 45);
  EXPECT_EQ(relative.period_jump(), 0);

  const Coupling absolute(indexing(), {});
  EXPECT_EQ(absolute.period_jump(), -90) << "an absolute one comes back";
  const Coupling turning(indexing(), {.slave_period = 45});
  EXPECT_EQ(turning.period_jump(), 0) << "for a rotary slave two turns are none";
  const Engagement turned = engage(turning, {.position = 7}, {0, 0, 0, 0}, 0);
  EXPECT_DOUBLE_EQ(point(turning, turned.engaged, {720, 1, 0, 0}, 0)[0], 180);
}

TEST(Coupling, LandsOnWholeTurnsWhateverTheStrokesLastDigit) {
  // B&R 37111: a stroke that is off whole turns by rounding must not add up. 1000000 periods of
  // 3 turns of 0.1, which no double is.
  CamSpec spec;
  spec.segments = {{Law::quintic, {360, 0.1 + 0.2, 0, 0}, ""}};
  const Cam cam = with(design(spec).cam, Extrapolation::wrap);
  const Coupling coupling(cam, {.slave_period = 0.1});
  const Engagement in = engage(coupling, {}, {}, 0);
  const double n = 1e6;
  EXPECT_EQ(point(coupling, in.engaged, {360 * n, 1, 0, 0}, 0)[0], n * (3 * 0.1));
}

TEST(CouplingCheck, AnnouncesTheJumpThatIsMade) {
  const Jet master{90, 200, 50, 0};
  const MotionState slave{5, 1, 2};
  for (const StartMode mode : {StartMode::absolute, StartMode::relative}) {
    const Coupling coupling(indexing(), {.start = mode});
    const Report report = check(coupling, slave, master);
    const Engagement in = engage(coupling, slave, master, 0);
    const Jet y = point(coupling, in.engaged, master, 0);
    EXPECT_FALSE(report.ok());
    for (const Finding& f : report.findings) {
      if (f.rule != "coupling/start") continue;
      const double jump = f.quantity == "position"   ? y[0] - slave.position
                          : f.quantity == "velocity" ? y[1] - slave.velocity
                                                     : y[2] - slave.acceleration;
      EXPECT_NEAR(f.value, jump, 1e-12) << f.quantity;
      EXPECT_EQ(f.broken, jump != 0) << f.quantity;
    }
  }
  EXPECT_TRUE(
      check(Coupling(with(indexing(), Extrapolation::hold), ramping()), slave, master).ok());
}

std::optional<Finding> find(const Report& report, const std::string& rule,
                            const std::string& quantity) {
  for (const Finding& f : report.findings)
    if (f.rule == rule && f.quantity == quantity) return f;
  return {};
}

TEST(CouplingCheck, ReportsWhereAWaitingSlaveMustMoveAtOnce) {
  // y = 2x on [0, 10], three times as high over half the master: 12 u/m at both ends.
  CouplingSpec spec = ramping();
  spec.master_scaling = 2;
  spec.slave_scaling = 3;
  const Coupling moving(ramp(), spec);
  for (const auto& [x, y, v, end] : {std::tuple{-1.0, 0.0, 5.0, 0.0}, {6.0, 60.0, -5.0, 10.0}}) {
    const Report report = check(moving, {.position = y}, {x, v, 0, 0});
    const auto enter = find(report, "coupling/enter", "velocity");
    ASSERT_TRUE(enter) << x;
    EXPECT_TRUE(enter->broken) << x;
    EXPECT_DOUBLE_EQ(enter->value, 12 * v) << x;
    EXPECT_EQ(enter->where, end) << x;
    // And so it does: at rest outside, at that speed inside.
    const Engaged in = engage(moving, {.position = y}, {x, v, 0, 0}, 0).engaged;
    EXPECT_EQ(point(moving, in, {end / 2 - 1e-6 * v, v, 0, 0}, 1)[1], 0);
    EXPECT_DOUBLE_EQ(point(moving, in, {end / 2 + 1e-6 * v, v, 0, 0}, 1)[1], 12 * v);
  }
  EXPECT_FALSE(find(check(moving, {}, {1, 5, 0, 0}), "coupling/enter", "velocity")) << "inside";
  const Coupling rests(with(indexing(), Extrapolation::hold), ramping());
  EXPECT_TRUE(check(rests, {}, {-1, 5, 0, 0}).ok()) << "begins at rest";
}

TEST(CouplingCheck, StatesTheLargestValuesOfTheCorrection) {
  const Coupling over_time(indexing(), ramping());
  const Report timed = check(over_time, {.position = -10}, {});
  EXPECT_DOUBLE_EQ(find(timed, "coupling/ramp", "position")->value, -10);
  EXPECT_NEAR(find(timed, "coupling/ramp", "acceleration")->value, 200, 1e-9);

  // A master that has barely begun: a difference of velocity swings far out.
  const double L = 40, dv = 50;
  const Coupling coupling(indexing(), {.start = StartMode::ramp_in_distance, .distance = L});
  test::Random random(3);
  for (int n = 0; n < 200; ++n) {
    const double w = std::pow(10, random.uniform(-3, 3)) * (n % 2 == 0 ? 1 : -1);
    const double b = random.uniform(-10, 10), d = random.uniform(-9, 9), da = random.uniform(-9, 9);
    const Jet x{180, w, b, 0};
    const Jet y = placed(coupling.cam(), coupling.placement(), x);
    const MotionState slave{y[0] + d, y[1] + dv, y[2] + da};
    const Engaged in = engage(coupling, slave, x, 0).engaged;
    double swing = 0;
    for (int i = 0; i <= 4000; ++i)
      swing = std::max(swing, std::abs(in.correction.jet(
                                  0, {180 + std::copysign(L, w) * i / 4000, 0, 0, 0})[0]));
    const auto told = find(check(coupling, slave, x), "coupling/ramp", "position");
    ASSERT_TRUE(told);
    EXPECT_NEAR(std::abs(told->value), swing, 1e-5 * swing) << w << " " << b << " " << d;
    const double bound = std::abs(d) + 0.2 * L * dv / std::abs(w) +
                         0.0173 * L * L * std::abs(da - dv * b / w) / (w * w);
    EXPECT_LE(std::abs(told->value), bound) << w << " " << b << " " << d;
  }
}

TEST(CouplingCheck, RoundingIsNoJump) {
  // A dwell has no stroke to measure by: what counts is how far out the slave is.
  const Cam flat({line(100, 5, 5)}, 0, Extrapolation::wrap);
  const Coupling relative(flat, {.start = StartMode::relative});
  EXPECT_TRUE(check(relative, {.position = 0.1}, {10, 0, 0, 0}).ok());
  const Coupling absolute(flat, {.slave_offset = 0.1});
  EXPECT_TRUE(check(absolute, {.position = 5.1 + 1e-12}, {10, 0, 0, 0}).ok());
  EXPECT_FALSE(check(absolute, {.position = 5.1 + 1e-10}, {10, 0, 0, 0}).ok());
}

TEST(CouplingCheck, NamesRejectionPeriodJumpAndAMovingEnd) {
  const auto rules = [](const Report& report) {
    std::string all;
    for (const Finding& f : report.findings) all += (f.broken ? "!" : "") + f.rule.text() + " ";
    return all;
  };
  EXPECT_EQ(rules(check(Coupling(with(ramp(), Extrapolation::refuse)), {}, {20, 0, 0, 0})),
            "!coupling/master_outside_cam ");
  EXPECT_NE(rules(check(Coupling(indexing()), {}, {})).find("!coupling/period"), std::string::npos);
  EXPECT_EQ(
      rules(check(Coupling(with(indexing(), Extrapolation::hold)), {}, {})).find("coupling/end"),
      std::string::npos);
  EXPECT_NE(rules(check(Coupling(ramp()), {}, {})).find("coupling/end"), std::string::npos);
}

}  // namespace
}  // namespace jounce::coupling_test
