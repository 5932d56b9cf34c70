// SPDX-License-Identifier: Apache-2.0
// The checker must reject what is wrong: every good profile here is also spoilt in every way that a
// solver could.
#include "profiles/proof/checker.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiles/proof/envelope.hpp"

namespace jounce::proof {
namespace {

using ::testing::HasSubstr;

using Phases = std::vector<Profile::Phase>;

Profile made(const Case& c, int order, const Phases& phases) {
  Profile f(c.from, order);
  for (const Profile::Phase& phase : phases) f.add(phase.duration, phase.value);
  f.finish(c.to);
  return f;
}

std::string fault(const Case& c, int order, const Phases& phases) {
  return check(made(c, order, phases), c).fault;
}

/// 0 to 2 with jerk 1, acceleration up to 1, velocity up to 1: 4 s.
const Case rest_to_rest{{0, 0, 0}, {2, 0, 0}, within(1, 1, 1), {}};
const Phases four{{1, 1}, {2, -1}, {1, 1}};
const Phases good{{1, 1}, {1, -1}, {1, -1}, {1, 1}};

TEST(Checker, AcceptsWhatIsRight) {
  for (const Phases& phases : {four, good}) {
    const Verdict v = check(made(rest_to_rest, 3, phases), rest_to_rest);
    EXPECT_EQ(v.fault, "");
    EXPECT_LT(v.end_error, 1e-18);
    EXPECT_EQ(v.excess, 0);
    EXPECT_EQ(v.duration, 4);
    EXPECT_EQ(v.scale.acceleration, 4);
  }
}

TEST(Checker, RejectsAPhaseThatIsALittleTooLongOrTooStrong) {
  for (std::size_t i = 0; i < good.size(); ++i)
    for (const double factor : {1 + 1e-10, 1 - 1e-10}) {
      Phases longer = good;
      longer[i].duration *= factor;
      EXPECT_NE(fault(rest_to_rest, 3, longer), "") << i << " " << factor;
      if (factor > 1) {
        Phases stronger = good;
        stronger[i].value *= factor;
        EXPECT_NE(fault(rest_to_rest, 3, stronger), "") << i;
      }
    }
}

TEST(Checker, RejectsPhasesMissingDoubledSwappedOrNegated) {
  for (std::size_t i = 0; i < good.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    Phases f = good;
    f.erase(f.begin() + at);
    EXPECT_NE(fault(rest_to_rest, 3, f), "") << "missing " << i;
    f = good;
    f.insert(f.begin() + at, f[i]);
    EXPECT_NE(fault(rest_to_rest, 3, f), "") << "doubled " << i;
    f = good;
    f[i].value = -f[i].value;
    EXPECT_NE(fault(rest_to_rest, 3, f), "") << "negated " << i;
  }
  EXPECT_NE(fault(rest_to_rest, 3, {good[0], good[2], good[3], good[1]}), "");
}

TEST(Checker, RejectsAnotherStartOrEnd) {
  for (const MotionState& other : {MotionState{1e-300, 0, 0}, {0, 1e-300, 0}, {0, 0, -1e-300}}) {
    Case c = rest_to_rest;
    c.from = other;
    EXPECT_THAT(check(made(rest_to_rest, 3, good), c).fault, HasSubstr("start()"));
  }
  Case c = rest_to_rest;
  c.to.position = std::nextafter(2, 3);
  EXPECT_THAT(check(made(rest_to_rest, 3, good), c).fault, HasSubstr("end()"));
}

TEST(Checker, SeesAnEndThatIsOnlyClaimed) {
  Case c = rest_to_rest;
  c.to.position = 2 + 1e-10;
  EXPECT_THAT(fault(c, 3, good), HasSubstr("ends off in position"));
  c.to = {2, 1e-10, 0};
  EXPECT_THAT(fault(c, 3, good), HasSubstr("ends off in velocity"));
  c.to = {2, 0, 1e-10};
  EXPECT_THAT(fault(c, 3, good), HasSubstr("ends off in acceleration"));
}

TEST(Checker, MeasuresEachLimitInItsDirection) {
  const auto with = [](auto change) {
    Case c = rest_to_rest;
    change(c.bounds);
    return fault(c, 3, good);
  };
  EXPECT_THAT(with([](Bounds& b) { b.jerk_max *= 1 - 1e-10; }), HasSubstr("jerk_max"));
  EXPECT_THAT(with([](Bounds& b) { b.jerk_min *= 1 - 1e-10; }), HasSubstr("jerk_min"));
  EXPECT_THAT(with([](Bounds& b) { b.acceleration_max *= 1 - 1e-10; }),
              HasSubstr("acceleration_max"));
  EXPECT_THAT(with([](Bounds& b) { b.acceleration_min *= 1 - 1e-10; }),
              HasSubstr("acceleration_min"));
  EXPECT_THAT(with([](Bounds& b) { b.velocity_max *= 1 - 1e-10; }), HasSubstr("velocity_max"));
  EXPECT_THAT(with([](Bounds& b) { b.position_max = 2 - 1e-10; }), HasSubstr("position_max"));
  // A limit that is not reached may be arbitrarily tight.
  EXPECT_EQ(with([](Bounds& b) { b.velocity_min = -1e-9; }), "");
  EXPECT_EQ(with([](Bounds& b) {
              b.position_min = 0;
              b.position_max = 2;
            }),
            "");
}

TEST(Checker, FindsExtremaInsidePhases) {
  // From velocity -1 under acceleration 1: turns at 1 s, half a unit behind the start.
  const Case c{{0, -1, 0}, {0, 1, 0}, {-2, 2, -1, 1, -Bounds::none, Bounds::none, -0.5, 1}, {}};
  EXPECT_EQ(fault(c, 2, {{2, 1}}), "");
  Case tight = c;
  tight.bounds.position_min = -0.5 + 1e-10;
  EXPECT_THAT(fault(tight, 2, {{2, 1}}), HasSubstr("position_min"));
  // Jerk -1 from acceleration 1: the velocity peaks at 1 s, half a unit above the ends.
  const Case peak{{0, 0, 1}, {2.0 / 3, 0, -1}, within(0.5, 1, 1), {}};
  EXPECT_EQ(fault(peak, 3, {{2, -1}}), "");
  Case low = peak;
  low.bounds.velocity_max = 0.25;
  low.from.velocity = low.to.velocity = -0.25 + 1e-10;
  low.to.position = 2.0 / 3 + 2 * low.from.velocity;
  EXPECT_EQ(fault(low, 3, {{2, -1}}), "") << "this peak is unavoidable";
  // The same peak, but made on the way: not to be excused.
  const Case made_peak{{0, -0.25, 0}, {1.125, 0.5, 0}, within(0.6, 1, 1), {}};
  EXPECT_THAT(fault(made_peak, 3, {{1, 1}, {1.5, -1}, {0.5, 1}}), HasSubstr("velocity_max"));
}

TEST(Checker, ChecksTheOrderTheSumAndTheDurationAskedFor) {
  Case c = rest_to_rest;
  c.duration = 4;
  EXPECT_EQ(fault(c, 3, good), "");
  c.duration = 4 + 1e-11;  // 1e-12 of 4 s and of the 1 s in which acceleration builds up is kept
  EXPECT_THAT(fault(c, 3, good), HasSubstr("duration asked for"));
  EXPECT_THAT(fault(rest_to_rest, 2, {{1, 1}, {1, -1}}), HasSubstr("order"));
  EXPECT_THAT(fault(rest_to_rest, 3, {{1, std::nan("")}}), HasSubstr("finite"));
  EXPECT_THAT(fault(rest_to_rest, 3, {{INFINITY, 0}}), HasSubstr("finite"));
}

TEST(Checker, HoldsAStartOutsideOfSecondOrderToItsBraking) {
  // Velocity 2 where 1 is allowed, brakes with 1.
  const Bounds b = within(1, 1);
  EXPECT_EQ(fault({{0, 2, 0}, {2.5, 1, 0}, b, {}}, 2, {{1, -1}, {1, 0}}), "");
  EXPECT_THAT(fault({{0, 2, 0}, {4.25, 1, 0}, b, {}}, 2, {{0.5, -1}, {0.5, 1}, {1, -1}, {1, 0}}),
              HasSubstr("velocity_max"));
  EXPECT_THAT(fault({{0, 2, 0}, {2.75, 1, 0}, b, {}}, 2, {{1, -1}, {0.5, 1}, {0.5, -1}, {0, 0}}),
              HasSubstr("velocity_max"))
      << "outside again";
}

/// Velocity 2 where 1 is allowed, third order, all limits 1. The level return is 1 s of jerk -1 and
/// 1 s of jerk 1, and runs 3 u.
Case too_fast(const MotionState& to) {
  return {{0, 2, 0}, to, within(1, 1, 1), {}};
}

/// End state of the phases: faults are then those of limits alone.
MotionState led(const MotionState& from, const Phases& phases) {
  MotionState s = from;
  for (const auto& [t, j] : phases)
    s = {s.position + t * (s.velocity + t * (s.acceleration / 2 + t * j / 6)),
         s.velocity + t * (s.acceleration + t * j / 2), s.acceleration + t * j};
  return s;
}

std::string outside(Case c, const Phases& phases) {
  c.to = led(c.from, phases);
  return fault(c, 3, phases);
}

TEST(Checker, AllowsTheLevelReturnAndAnyThatIsNeverFaster) {
  EXPECT_EQ(fault(too_fast({4, 1, 0}), 3, {{1, -1}, {1, 1}, {1, 0}}), "");
  EXPECT_EQ(outside(too_fast({}), {{1, -1}, {0.5, 0}, {1, 1}}), "") << "straight through the limit";
  EXPECT_EQ(outside(too_fast({}), {{1, -1}, {1.5, 0}, {1, 1}, {0.5, 1}, {0.5, -1}}), "");
}

TEST(Checker, RejectsAVelocityBeyondTheLevelReturn) {
  const double little = 1e-9;
  EXPECT_THAT(outside(too_fast({}), {{little, 0}, {1, -1}, {1, 1}}), HasSubstr("velocity_max"));
  EXPECT_THAT(outside(too_fast({}), {{1, -1 + little}, {1, 1}}), HasSubstr("velocity_max"));
  EXPECT_THAT(outside(too_fast({}), {{1 - little, -1}, {1, 1}}), HasSubstr("velocity_max"));
  EXPECT_THAT(outside(too_fast({}), {{1, -1}, {1, 1}, {0.01, 1}, {0.01, -1}}),
              HasSubstr("velocity_max"))
      << "outside again";
  const Case mirrored{{0, -2, 0}, {}, within(1, 1, 1), {}};
  EXPECT_EQ(outside(mirrored, {{1, 1}, {1, -1}}), "");
  EXPECT_THAT(outside(mirrored, {{1 - little, 1}, {1, -1}}), HasSubstr("velocity_min"));
}

TEST(Checker, HoldsAnUnavoidablePeakToFullBraking) {
  // Inside, but the acceleration cannot be back at zero below 1.5: level return from there.
  const Case c{{0, 1, 1}, {}, within(1, 1, 1), {}};
  const double release = std::sqrt(0.5);  // 1.5 - s^2 = 1
  EXPECT_EQ(outside(c, {{1 + release, -1}, {release, 1}}), "");
  EXPECT_THAT(outside(c, {{1, -0.999}, {release, -1}, {release, 1}}), HasSubstr("velocity_max"));
}

TEST(Checker, LetsASteepBrakingPassTheLimitAtFullJerk) {
  const Case c{{0, 1.2, -1}, {}, within(1, 1, 1), {}};
  EXPECT_EQ(outside(c, {{1, 1}, {0.3, 1}, {0.3, -1}}), "");
  EXPECT_EQ(outside(c, {{0.2, 0}, {1, 1}}), "") << "slower all the time";
}

TEST(Checker, HoldsAnAccelerationOutsideToItsReturnAtFullJerk) {
  const Case c{{0, 0, 2}, {}, within(10, 1, 1), {}};
  EXPECT_EQ(outside(c, {{2, -1}}), "");
  EXPECT_EQ(outside(c, {{1, -1}, {1, 0}, {1, -1}}), "");
  EXPECT_THAT(outside(c, {{1, 0}, {2, -1}}), HasSubstr("acceleration_max"));
  EXPECT_THAT(outside(c, {{1, -1 + 1e-9}, {1, -1}}), HasSubstr("acceleration_max"));
}

TEST(Checker, LetsABrakingUnderWayGoOnOnlyAsFarAsItMust) {
  // Velocity 4, braking with 2 where 1 is allowed: stops in 19/3, in 13/3 if it goes on.
  const auto at = [](double d) { return Case{{0, 4, -2}, {d, 0, 0}, within(9, 1, 1), {}}; };
  const Phases going_on{{1, 0}, {2, 1}};
  EXPECT_EQ(fault(at(13.0 / 3), 3, going_on), "");
  EXPECT_EQ(fault(at(19.0 / 3), 3, {{1, 1}, {2, 0}, {1, 1}}), "");
  // Between them, the least limit that does not pass the target.
  const auto stop = [](double x) {
    const double t = 2 - x;
    const double r = 4 * t - t * t + t * t * t / 6;
    const double v = 4 - 2 * t + t * t / 2;
    const double hold = 2 / x;
    return r + v * hold - x * hold * hold / 2 + x * x * x / 6;
  };
  const auto phases = [](double x) { return Phases{{2 - x, 1}, {2 / x, 0}, {x, 1}}; };
  EXPECT_EQ(fault(at(stop(1.5)), 3, phases(1.5)), "");
  Case farther = at(0);  // holds 1.7 first, then 1: there with less throughout
  const double first = 1 / 1.7;
  const double rest = 2 - 1;
  const Phases harder{{0.3, 1}, {first, 0}, {0.7, 1}, {rest, 0}, {1, 1}};
  farther.to = led(farther.from, harder);
  EXPECT_THAT(fault(farther, 3, harder), HasSubstr("acceleration_min"));
  EXPECT_EQ(in_force({0, 4, -2}, {7, 0, 0}, at(7).bounds).bounds.acceleration_min, -1);
  EXPECT_NEAR(in_force({0, 4, -2}, {stop(1.5), 0, 0}, at(0).bounds).bounds.acceleration_min, -1.5,
              1e-12);
}

TEST(Checker, HoldsABrakingThatPassesTheTargetAnyway) {
  // It would stop in 13/3: the 1 s that this holds the braking is held, then it returns to the limit.
  const Case c{{0, 4, -2}, {4, 0, 0}, within(9, 1, 1), {}};
  EXPECT_EQ(in_force(c.from, c.to, c.bounds).hold, 1);
  const auto judged = [&](Phases phases) {  // and on to the target as the solver goes
    const Profile rest = move_to(led(c.from, phases), c.to, c.bounds).profile;
    for (std::size_t i = 0; i < rest.phases(); ++i) phases.push_back(rest.phase(i));
    return fault(c, 3, phases);
  };
  EXPECT_EQ(judged({{1, 0}, {1, 1}}), "");
  EXPECT_THAT(judged({{0.99, 0}, {1, 1}}), HasSubstr("acceleration_max"));
  EXPECT_THAT(judged({{1.01, 0}, {1, 1}}), HasSubstr("acceleration_min"));
  EXPECT_THAT(judged({{1, 1}}), HasSubstr("acceleration_max"));
}

TEST(Checker, ResolvesTheEndOfALongHoldToItsLastDigits) {
  // Held for 168 s, returned in 2 ms: the last digit of the hold is 1.2e-12 of the acceleration.
  const Case c{{0x1.9d721716a1236p+1, 0x1.57ebc3b1dab39p+4, -0x1.061c993f20363p-3},
               {0x1.f95cb2badbacp+2, 0, 0},
               within(0x1.b79e34aa624f6p+3, 0x1.b3e334ba54e26p-4, 0x1.6bf3c2cc06a3ap+3)};
  const Profile f = move_to(c.from, c.to, c.bounds).profile;
  ASSERT_GT(f.phase(0).duration, 167);
  const auto judged = [&](double factor) {
    Phases phases{{f.phase(0).duration * factor, 0}};
    for (std::size_t i = 1; i < f.phases(); ++i) phases.push_back(f.phase(i));
    return fault(c, 3, phases);
  };
  EXPECT_EQ(judged(1), "");
  EXPECT_EQ(judged(1 - 0x1p-53), "");
  EXPECT_EQ(judged(1 + 0x1p-52), "");
  EXPECT_THAT(judged(1 - 0x1p-48), HasSubstr("acceleration_max"));
  EXPECT_THAT(judged(1 + 0x1p-48), HasSubstr("acceleration_min"));
}

TEST(Checker, PrintsALineThatAsksAgain) {
  Case c = rest_to_rest;
  c.duration = 4;
  EXPECT_EQ(reproducer(c),
            "move_to({0x0p+0, 0x0p+0, 0x0p+0}, {0x1p+1, 0x0p+0, 0x0p+0}, {-0x1p+0, 0x1p+0, "
            "-0x1p+0, 0x1p+0, -0x1p+0, 0x1p+0, -Bounds::none, Bounds::none}, 0x1p+2);");
}

}  // namespace
}  // namespace jounce::proof
