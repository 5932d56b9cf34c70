// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/pmc600/pmc600.hpp"

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "controllers/motion.hpp"
#include "support/random.hpp"

namespace jounce::pmc600 {
namespace {

using test::Random;

constexpr double pi = 3.14159265358979323846;
const Dynamics example_6_7{.velocity = 2000, .acceleration = 4000};

TEST(Pmc600Modes, TheSigmoidTakesTheTrapezoidsTimeAtMoreAcceleration) {
  const Trajectory trapezoid = move_absolute(0, 4000, example_6_7);
  const Trajectory sigmoid = move_absolute(0, 4000, example_6_7, VelocityMode::sigmoid);
  EXPECT_DOUBLE_EQ(trapezoid.end(), 2.5);
  EXPECT_DOUBLE_EQ(sigmoid.end(), 2.5);
  EXPECT_NEAR(extrema(sigmoid, 2).max.value, 4000 * pi / 2, 1e-9);
  EXPECT_NEAR(sigmoid.at(0.125).velocity, 2000 * std::pow(std::sin(pi / 8), 2), 1e-9);
  EXPECT_DOUBLE_EQ(sigmoid.at(1).position, trapezoid.at(1).position);  // the same area
  test::expect_invariants(sigmoid, 2);
}

TEST(Pmc600Modes, TheLimitedSigmoidKeepsItsAcceleration) {
  const Trajectory f = move_absolute(0, 4000, example_6_7, VelocityMode::sigmoid_limit);
  EXPECT_DOUBLE_EQ(f.end(), 2 + 0.5 * pi / 2);
  EXPECT_NEAR(extrema(f, 2).max.value, 4000, 1e-9);
}

TEST(Pmc600Modes, QuadraticIsTheSevenSegmentCurve) {
  const auto quadratic = [](const Dynamics& d) {
    return move_absolute(0, 4000, d, VelocityMode::quadratic).end();
  };
  Dynamics d = example_6_7;
  EXPECT_THROW(quadratic(d), InputError);
  d.jerk = 40000;
  d.deceleration = 3000;
  const Profile expected = s_curve(
      {.to = 4000, .velocity = 2000, .acceleration = 4000, .deceleration = 3000, .jerk = 40000});
  EXPECT_DOUBLE_EQ(quadratic(d), expected.duration());
  d.deceleration_jerk = 20000;
  EXPECT_DOUBLE_EQ(quadratic(d), s_curve({.to = 4000,
                                          .velocity = 2000,
                                          .acceleration = 4000,
                                          .deceleration = 3000,
                                          .jerk = 40000,
                                          .deceleration_jerk = 20000})
                                     .duration());
}

TEST(Pmc600Modes, ShortAndLongMovesKeepTheirLimitsInEveryMode) {
  Random random(51);
  for (int i = 0; i < 1200 && !::testing::Test::HasFailure(); ++i) {
    const auto mode = static_cast<VelocityMode>(i % 4);
    const Dynamics r{random.log_uniform(1e-2, 1e2), random.log_uniform(1e-2, 1e2),
                     random.log_uniform(1e-2, 1e2), random.log_uniform(1e-2, 1e3)};
    const double from = random.uniform(-10, 10);
    const double to = from + random.uniform(-1, 1) * random.log_uniform(1e-3, 1e3);
    SCOPED_TRACE(i);
    const Trajectory f = move_absolute(from, to, r, mode);
    EXPECT_EQ(f.at(0).position, from);
    EXPECT_NEAR(f.at(f.end(), Side::left).position, to, 1e-14 * (std::abs(to) + std::abs(from)));
    const double peak = std::max(r.acceleration, r.deceleration);
    test::expect_within(
        f, r.velocity, mode == VelocityMode::sigmoid ? pi / 2 * peak : peak,
        mode == VelocityMode::quadratic ? r.jerk : std::numeric_limits<double>::infinity());
    test::expect_invariants(f, mode == VelocityMode::trapezoid ? 1 : 2);
    EXPECT_DOUBLE_EQ(f.end(), move_absolute(-from, -to, r, mode).end());
  }
}

TEST(Pmc600Modes, PowersOfTwoInTheUnitChangeNoDuration) {
  for (const auto mode : {VelocityMode::trapezoid, VelocityMode::sigmoid, VelocityMode::quadratic})
    for (const double k : {0x1p-20, 0x1p13, 0x1p31}) {
      const Dynamics r{1.1, 7, 5, 90};
      const Dynamics scaled{1.1 * k, 7 * k, 5 * k, 90 * k};
      for (const double to : {0.3, 0.01})
        EXPECT_EQ(move_absolute(0, to * k, scaled, mode).end(),
                  move_absolute(0, to, r, mode).end());
    }
}

TEST(Pmc600Modes, TheSigmoidAlwaysTakesTheTrapezoidsTimeAndTheQuadraticThatOfTheSCurve) {
  Random random(54);
  for (int i = 0; i < 1000; ++i) {
    const Dynamics r{random.log_uniform(1e-2, 1e2), random.log_uniform(1e-2, 1e2),
                     random.log_uniform(1e-2, 1e2), random.log_uniform(1e-2, 1e3)};
    const double to = random.log_uniform(1e-3, 1e3);
    const double straight =
        trapezoid({0, to, r.velocity, r.acceleration, r.deceleration}).duration();
    const double curved =
        s_curve({0, to, r.velocity, r.acceleration, r.deceleration, r.jerk}).duration();
    const auto lasts = [&](VelocityMode mode) { return move_absolute(0, to, r, mode).end(); };
    EXPECT_NEAR(lasts(VelocityMode::trapezoid), straight, 1e-14 * straight) << i;
    EXPECT_NEAR(lasts(VelocityMode::sigmoid), straight, 1e-14 * straight) << i;
    EXPECT_NEAR(lasts(VelocityMode::quadratic), curved, 1e-13 * curved) << i;
  }
}

TEST(LsMove, ExampleBeginsAtItsStartVelocity) {
  // 5.2.4, Fig. 5.18: 50000 at 10000, a = d = 100000, StartVel 1000: 0.09 s and 495 pulses.
  const LsMove m{.to = 50000,
                 .velocity = 10000,
                 .acceleration = 100000,
                 .start_velocity = 1000,
                 .end_second_velocity = 1000};
  const Profile p = ls_move(m);
  EXPECT_DOUBLE_EQ(p.phase(0).duration, 0.09);
  EXPECT_DOUBLE_EQ(p.at(0.09).position, 495);
  EXPECT_EQ(p.at(0).velocity, 1000);
  EXPECT_EQ(p.end(), (MotionState{50000, 1000, 0}));
  EXPECT_DOUBLE_EQ(p.duration(), 0.18 + (50000 - 990) / 10000.0);
  test::expect_arrives(p);
}

TEST(LsMove, AStepTooShortForBothSpeedsLowersTheHigherOne) {
  const LsMove m{.to = 0.02,
                 .velocity = 10,
                 .acceleration = 100,
                 .start_velocity = 5,
                 .end_second_velocity = 1};
  const Profile p = ls_move(m);  // v^2 = 1 + 2 * 100 * 0.02
  EXPECT_NEAR(p.start().velocity, std::sqrt(5.0), 1e-14);
  EXPECT_EQ(p.end().velocity, 1);
  test::expect_arrives(p);
  LsMove back = m;
  std::swap(back.start_velocity, back.end_second_velocity);
  EXPECT_NEAR(ls_move(back).end().velocity, std::sqrt(5.0), 1e-14);
  back.start_velocity = back.end_second_velocity = 2;
  EXPECT_NEAR(ls_move(back).duration(), 0.02 * (std::sqrt(6.0) - 2),
              1e-15);  // 6 = 4 + 2 * 100 / 100
}

TEST(LsMove, RandomMovesArriveAndKeepTheirLimits) {
  Random random(52);
  for (int i = 0; i < 1000 && !::testing::Test::HasFailure(); ++i) {
    const double v = random.log_uniform(1, 1e4);
    const LsMove m{.from = random.uniform(-10, 10),
                   .to = random.uniform(-1, 1) * random.log_uniform(1, 1e4),
                   .velocity = v,
                   .acceleration = random.log_uniform(1, 1e5),
                   .deceleration = random.log_uniform(1, 1e5),
                   .start_velocity = random.uniform(0.001, v),
                   .end_second_velocity = random.uniform(0.001, v)};
    SCOPED_TRACE(::testing::Message()
                 << i << ": from " << number(m.from) << " to " << number(m.to) << " v "
                 << number(m.velocity) << " a " << number(m.acceleration) << " d "
                 << number(m.deceleration) << " start " << number(m.start_velocity) << " end "
                 << number(m.end_second_velocity));
    const Profile p = ls_move(m);
    ASSERT_GT(p.phases(), 0U);
    test::expect_arrives(p);
    test::expect_within(p.curve(), m.velocity, std::max(m.acceleration, m.deceleration));
    EXPECT_LE(std::abs(p.start().velocity), m.start_velocity);
    EXPECT_LE(std::abs(p.end().velocity), m.end_second_velocity);
    test::expect_invariants(with(p.curve(), Extrapolation::refuse), 1);
  }
}

TEST(LsMove, RejectsAsTheManual) {
  const LsMove good{.to = 100, .velocity = 30, .acceleration = 100};
  const auto refused = [&](auto change) {
    LsMove bad = good;
    change(bad);
    EXPECT_THROW(ls_move(bad), InputError);
  };
  EXPECT_NO_THROW(ls_move(good));
  refused([](LsMove& m) { m.start_velocity = 0; });
  refused([](LsMove& m) { m.end_second_velocity = -1; });
  refused([](LsMove& m) { m.start_velocity = 31; });
  refused([](LsMove& m) { m.acceleration = 0; });
  refused([](LsMove& m) { m.velocity = 0; });
  refused([](LsMove& m) { m.to = 0; });
}

TEST(LsMove, ABlocksOwnEndVelocityIsNotAboveTheVelocity) {
  const Profile slow = ls_move({.to = 100, .velocity = 10, .acceleration = 100});
  EXPECT_EQ(slow.start().velocity, 10);
  EXPECT_EQ(slow.end().velocity, 10);
  EXPECT_DOUBLE_EQ(slow.duration(), 10);
  EXPECT_EQ(ls_move_velocity(0, 30, 100).start().velocity, 20);
  EXPECT_THROW(ls_move_velocity(0, 30, 100, 31), InputError);
  EXPECT_THROW(ls_move_velocity(0, 0, 100), InputError);
}

TEST(LsMoveVelocity, StepsToItsStartVelocityInItsDirection) {
  const Profile p = ls_move_velocity(0, -10000, 100000, 1000);
  EXPECT_EQ(p.at(0).velocity, -1000);
  EXPECT_DOUBLE_EQ(p.duration(), 0.09);
  EXPECT_EQ(p.end().velocity, -10000);
  EXPECT_DOUBLE_EQ(p.end().position, -495);
}

TEST(VelocityCommands, FollowOneAnotherAsTheManualShows) {
  // 5.2.2, Fig. 5.8 to 5.10; accelerations are ours.
  const Dynamics d{.acceleration = 6000, .jerk = 60000};
  const Trajectory fast = velocity_ramp({}, 3000, d).curve();
  for (const double t : {0.3, 2.0}) {  // before and after 3000 is reached
    const Trajectory slower = with_velocity(fast, t, 2000, d);
    EXPECT_DOUBLE_EQ(state_at(slower, 9).velocity, 2000);
    test::expect_invariants(with(slower, Extrapolation::refuse), 2);
    const Trajectory stopped = with_velocity(slower, 10, 0, d);
    EXPECT_NEAR(state_at(stopped, stopped.end()).velocity, 0, 1e-10);
    const Trajectory again = with_velocity(stopped, 10.2, 2000, d);  // before it stands
    EXPECT_GT(extrema(until(again, 11), 1).max.value, 0);
    EXPECT_DOUBLE_EQ(state_at(again, 11).velocity, 2000);
    EXPECT_GT(state_at(again, 10.3).velocity, 100);
  }
}

TEST(LsMoveVelocity, RejectsAnInvalidNumber) {
  EXPECT_THROW(ls_move_velocity(std::nan(""), 100, 100), InputError);
  EXPECT_THROW(ls_move_velocity(0, std::nan(""), 100), InputError);
}

TEST(PositionToVelocity, ExamplePassesTheJointAtFiveThousand) {
  // 5.2.4, Fig. 5.21.
  const PositionToVelocity m{.end_pos = {10000, 50000},
                             .velocity = {5000, 20000},
                             .acceleration = {10000, 20000},
                             .deceleration = {10000, 20000},
                             .mode = VelocityMode::trapezoid};
  const Trajectory f = position_to_velocity(m);
  EXPECT_DOUBLE_EQ(f.end(), 5.03125);
  EXPECT_DOUBLE_EQ(f.at(2.25).position, 10000);
  EXPECT_DOUBLE_EQ(f.at(2.25).velocity, 5000);
  test::expect_invariants(f, 1);
}

TEST(PositionToVelocity, TheJointIsAsFastAsBothSidesAllow) {
  PositionToVelocity m{.end_pos = {10000, 50000},
                       .velocity = {20000, 5000},
                       .acceleration = {10000, 10000},
                       .deceleration = {10000, 10000},
                       .mode = VelocityMode::trapezoid};
  const auto joint = [](const Trajectory& f, double position) {
    for (std::size_t i = 1; i < f.segments().size(); ++i)
      if (std::abs(value(f.segments()[i], 0) - position) < 1e-6)
        return evaluate(f.segments()[i], 0)[1];
    return std::nan("");
  };
  EXPECT_DOUBLE_EQ(joint(position_to_velocity(m), 10000), 5000);  // the slower one
  m.end_pos = {50, 50000};
  EXPECT_DOUBLE_EQ(joint(position_to_velocity(m), 50), 1000);  // no faster in 50
  m.end_pos = {50000, 50050};
  EXPECT_DOUBLE_EQ(joint(position_to_velocity(m), 50000), 1000);  // to stop within 50
  m.end_pos = {10000, 5000};
  EXPECT_EQ(joint(position_to_velocity(m), 10000), 0);  // turns round
  m.relative = true;
  m.from = 100;
  const Trajectory f = position_to_velocity(m);
  EXPECT_DOUBLE_EQ(f.at(f.end()).position, 15100);
}

TEST(PositionToVelocity, RandomPairsKeepLimitsAndAreContinuousInEveryMode) {
  Random random(53);
  for (int i = 0; i < 800 && !::testing::Test::HasFailure(); ++i) {
    PositionToVelocity m{.from = random.uniform(-10, 10),
                         .relative = true,
                         .end_pos = {random.uniform(-100, 100), random.uniform(-100, 100)},
                         .mode = static_cast<VelocityMode>(i % 4)};
    for (std::size_t k = 0; k < 2; ++k) {
      m.velocity[k] = random.log_uniform(0.1, 100);
      m.acceleration[k] = random.log_uniform(0.1, 100);
      m.deceleration[k] = random.log_uniform(0.1, 100);
      m.jerk[k] = random.log_uniform(1, 1000);
    }
    SCOPED_TRACE(i);
    const Trajectory f = position_to_velocity(m);
    test::expect_within(f, std::max(m.velocity[0], m.velocity[1]), 160);
    test::expect_invariants(f, m.mode == VelocityMode::trapezoid ? 1 : 2);
    EXPECT_NEAR(f.at(f.end()).position, m.from + m.end_pos[0] + m.end_pos[1], 1e-12);
  }
}

TEST(MoveAdditive, AddsToThePreviousTarget) {
  // 5.2.2, Fig. 5.11: 6000 and 4000 more, after the first move is done or while it runs.
  const Dynamics d{.velocity = 2000, .acceleration = 4000, .jerk = 40000};
  const Trajectory first = point_to_point(0, 6000, d).curve();
  EXPECT_LT(first.at(1.9).position, 4000);
  for (const double t : {1.9, first.end(), first.end() + 1}) {
    const Trajectory f = move_additive(first, t, 4000, d);
    EXPECT_NEAR(f.at(f.end()).position, 10000, 1e-11);
    test::expect_invariants(f, 2);
  }
  const Trajectory twice = move_additive(move_additive(first, 1, 4000, d), 1.5, -500, d);
  EXPECT_NEAR(twice.at(twice.end()).position, 9500, 1e-11);
}

TEST(MoveAdditive, AfterAVelocityCommandMovesTheDistanceAndStops) {
  const Dynamics d{.velocity = 2000, .acceleration = 4000};
  const Trajectory jog = velocity_ramp({}, 1000, d).curve();  // 125 in 0.25 s
  const Trajectory f = move_additive(jog, 2, 4000, d);
  EXPECT_NEAR(f.at(f.end()).position, 125 + 1750 + 4000, 1e-11);
  const Trajectory g = move_superimposed(jog, 2, 4000, d);
  EXPECT_EQ(g.end(), f.end());
}

TEST(Superimposed, AddsBothMotionsAndBothDistances) {
  // 5.2.2, Fig. 5.12: a relative move of 6000 with one on top ends between 7000 and 8000.
  const Trajectory base = point_to_point(0, 6000, {.velocity = 2000, .acceleration = 4000}).curve();
  const Dynamics top{.velocity = 500, .acceleration = 1000};
  const Trajectory whole = move_superimposed(base, 1, 2000, top);
  EXPECT_DOUBLE_EQ(whole.at(whole.end()).position, 8000);
  EXPECT_DOUBLE_EQ(whole.at(2).velocity, 2500);
  EXPECT_DOUBLE_EQ(whole.end(), 1 + 4.5);
  test::expect_invariants(whole, 1);
  const Trajectory aborted = move_superimposed(base, 1, 2000, top, 3);
  const double end = aborted.at(aborted.end()).position;  // 125 + 750 + 125 of the second motion
  EXPECT_NEAR(end, 7000, 1e-9);
  EXPECT_DOUBLE_EQ(move_superimposed(base, 1, 2000, top, 0.5).at(10).position, 6000);
}

TEST(Superimposed, RejectsAnAbortThatIsNoNumber) {
  const Dynamics d{.velocity = 2000, .acceleration = 4000};
  const Trajectory base = point_to_point(0, 6000, d).curve();
  EXPECT_THROW(move_superimposed(base, 1, 2000, d, std::nan("")), InputError);
  EXPECT_THROW(move_superimposed(base, std::nan(""), 2000, d), InputError);
}

TEST(Superimposed, SinesAreAddedExactly) {
  const Dynamics d{.velocity = 2000, .acceleration = 4000};
  const Trajectory base = move_absolute(0, 6000, d, VelocityMode::sigmoid);
  const Trajectory top = shifted(move_absolute(0, 500, d, VelocityMode::sigmoid), 0.1);
  const Trajectory both = superimposed(base, top);
  for (int n = 0; n < 100; ++n) {
    const double t = 0.1 + (both.end() - 0.1) * n / 100;
    const double above = t < top.end() ? top.at(t).position : 500;
    EXPECT_NEAR(both.at(t).position, base.at(t).position + above, 1e-9);
  }
  test::expect_invariants(both, 2);
}

TEST(Inch, IsOneStepUnlessReleased) {
  const Dynamics d{.velocity = 10, .acceleration = 20};
  EXPECT_DOUBLE_EQ(inch(5, -5, d).at(10).position, 0);
  const Trajectory released = inch(0, 50, d, 1);  // 2.5 + 5, then 2.5 to stop
  EXPECT_DOUBLE_EQ(released.end(), 1.5);
  EXPECT_DOUBLE_EQ(released.at(1.5).position, 10);
  EXPECT_DOUBLE_EQ(inch(0, 50, d, 100).at(100).position, 50);
}

TEST(Jog, RejectsTimesThatDoNotAscend) {
  const Dynamics d{.velocity = 10, .acceleration = 20};
  for (const double second : {1.0, 0.5, std::nan("")}) {
    const std::array inputs{JogInput{1, true, false}, JogInput{second, false, false}};
    EXPECT_THROW(jog(0, inputs, d), InputError) << second;
  }
}

TEST(Jog, BothInputsTogetherMeanNoMotion) {
  const Dynamics d{.velocity = 10, .acceleration = 20, .deceleration = 40};
  const std::array inputs{JogInput{0, true, false}, JogInput{2, true, true},
                          JogInput{3, false, true}, JogInput{5, false, false}};
  const Trajectory f = jog(0, inputs, d, 8.0);
  EXPECT_DOUBLE_EQ(f.at(1).velocity, 8);  // clipped
  EXPECT_DOUBLE_EQ(f.at(2.5).velocity, 0);
  EXPECT_DOUBLE_EQ(f.at(4).velocity, -8);
  EXPECT_DOUBLE_EQ(f.end(), 5.2);
  test::expect_invariants(f, 1);
  const std::array both{JogInput{0, true, true}};
  EXPECT_THROW(jog(0, both, d), InputError);
}

}  // namespace
}  // namespace jounce::pmc600
