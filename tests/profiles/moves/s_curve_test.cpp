// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/s_curve.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "support/invariants.hpp"
#include "support/oracle.hpp"
#include "support/random.hpp"

namespace jounce::s_curve_test {
namespace {

using test::oracle;

/// Properties of every rest-to-rest move, for the move and its mirror image.
void expect_move(const Profile& move, double velocity, double acceleration, double deceleration,
                 double jerk, int order) {
  const Trajectory f = move.curve();
  const Ranges r = extrema(f);
  EXPECT_EQ(f.at(0).position, move.start().position);
  const double from = move.start().position;
  const double to = move.end().position;
  EXPECT_NEAR(f.at(f.end(), Side::left).position, to,
              4e-16 * std::max(std::abs(from), std::abs(to)));
  EXPECT_LE(std::abs(r[1].peak().value), velocity * (1 + 1e-12));
  const double sign = to > from ? 1 : -1;
  const Range& a = r[2];
  EXPECT_LE(sign > 0 ? a.max.value : -a.min.value, acceleration * (1 + 1e-12));
  EXPECT_LE(sign > 0 ? -a.min.value : a.max.value, deceleration * (1 + 1e-12));
  if (std::isfinite(jerk)) {
    EXPECT_LE(std::abs(r[3].peak().value), jerk * (1 + 1e-12));
  }
  test::expect_invariants(f, order);
}

TEST(Trapezoid, Googol71TakesThirteenHundredMilliseconds) {
  const Profile move =
      trapezoid({.to = 50000, .velocity = 50, .acceleration = 0.25, .deceleration = 0.125});
  EXPECT_DOUBLE_EQ(move.duration(), 1300);
  const auto& expected = oracle("googol_7_1")["trapezoid"];
  const Trajectory f = move.curve();
  for (std::size_t i = 0; i < expected["t"].size(); ++i)
    EXPECT_NEAR(f.at(expected["t"][i]).position, expected["position"][i].get<double>(), 1e-9);
}

TEST(SCurve, Googol71SmoothedTakesThirteenHundredAndTwentyFive) {
  const Profile move = s_curve({.to = 50000,
                                .velocity = 50,
                                .acceleration = 0.25,
                                .deceleration = 0.125,
                                .jerk = 0.25 / 25,
                                .deceleration_jerk = 0.125 / 25});
  EXPECT_DOUBLE_EQ(move.duration(), 1325);
  const auto& expected = oracle("googol_7_1")["smoothed"];
  const Trajectory f = move.curve();
  for (std::size_t i = 0; i < expected["t"].size(); ++i) {
    EXPECT_NEAR(f.at(expected["t"][i]).position, expected["position"][i].get<double>(), 1e-9);
    EXPECT_NEAR(f.at(expected["t"][i]).acceleration, expected["acceleration"][i].get<double>(),
                1e-13);
  }
}

TEST(SCurve, HmplSmoothingExample) {
  // HIMC HMPL manual 5.1: v 100, a 500, smoothing 50 ms: ramp 250 ms, jerk 10000.
  const Profile move =
      s_curve({.to = 1000, .velocity = 100, .acceleration = 500, .jerk = 500 / 0.05});
  EXPECT_NEAR(move.phase(0).duration + move.phase(1).duration + move.phase(2).duration, 0.25,
              1e-15);
}

TEST(Trapezoid, MeetsTheOracle) {
  for (const auto& c : oracle("trapezoids")) {
    SCOPED_TRACE(c["name"].get<std::string>());
    const Profile move =
        trapezoid({c["from"], c["to"], c["velocity"], c["acceleration"], c["deceleration"]});
    const double duration = c["duration"];
    EXPECT_NEAR(move.duration(), duration, 1e-13 * duration);
    EXPECT_NEAR(std::abs(extrema(move.curve(), 1).peak().value),
                std::abs(c["peak_velocity"].get<double>()),
                1e-13 * std::abs(c["peak_velocity"].get<double>()));
    expect_move(move, c["velocity"], c["acceleration"], c["deceleration"],
                std::numeric_limits<double>::infinity(), 1);
  }
}

TEST(SCurve, MeetsTheOracle) {
  for (const auto& c : oracle("s_curves")) {
    SCOPED_TRACE(c["name"].get<std::string>());
    const Profile move = s_curve({c["from"], c["to"], c["velocity"], c["acceleration"],
                                  c["deceleration"], c["jerk"], c["deceleration_jerk"]});
    const double duration = c["duration"];
    // The distance is all that a solver has: where from and to nearly cancel, so does the accuracy.
    const double given = c["distance"];
    const double rounding =
        std::abs(std::abs(c["to"].get<double>() - c["from"].get<double>()) - std::abs(given)) /
        std::abs(given);
    EXPECT_NEAR(move.duration(), duration, (2e-13 + rounding) * duration);
    expect_move(move, c["velocity"], c["acceleration"], c["deceleration"],
                std::max(c["jerk"].get<double>(), c["deceleration_jerk"].get<double>()), 2);
  }
}

TEST(SCurve, HoldsItsLimitsOverSixDecadesForwardAndBack) {
  test::Random random(20);
  for (int i = 0; i < 2000; ++i) {
    SCurveSpec s;
    s.from = random.uniform(-1, 1);
    s.to = s.from + random.log_uniform(1e-3, 1e3);
    s.velocity = random.log_uniform(1e-3, 1e3);
    s.acceleration = random.log_uniform(1e-3, 1e3);
    s.deceleration = random.log_uniform(1e-3, 1e3);
    s.jerk = random.log_uniform(1e-3, 1e3);
    s.deceleration_jerk = random.log_uniform(1e-3, 1e3);
    SCOPED_TRACE(i);
    const Profile move = s_curve(s);
    expect_move(move, s.velocity, s.acceleration, s.deceleration,
                std::max(s.jerk, s.deceleration_jerk), 2);
    std::swap(s.from, s.to);
    const Profile mirror = s_curve(s);
    EXPECT_DOUBLE_EQ(mirror.duration(), move.duration());
    if (HasFailure()) break;
  }
}

TEST(SCurve, DurationDoesNotDependOnTheUnit) {
  const SCurveSpec meters{0, 0.3, 1.1, 7, 5, 90, 60};
  for (const double k : {1e3, 1e6, 1e-6}) {
    const SCurveSpec other{0, 0.3 * k, 1.1 * k, 7 * k, 5 * k, 90 * k, 60 * k};
    EXPECT_NEAR(s_curve(other).duration(), s_curve(meters).duration(), 1e-14);
  }
}

TEST(Moves, RejectsAnInvalidMove) {
  EXPECT_THROW(trapezoid({.to = 0, .velocity = 1, .acceleration = 1}), InputError);
  EXPECT_THROW(trapezoid({.to = 1, .velocity = 0, .acceleration = 1}), InputError);
  EXPECT_THROW(trapezoid({.to = 1, .velocity = 1, .acceleration = -1}), InputError);
  EXPECT_THROW(trapezoid({.to = std::nan(""), .velocity = 1, .acceleration = 1}), InputError);
  EXPECT_THROW(trapezoid({.from = -1e308, .to = 1e308, .velocity = 1, .acceleration = 1}),
               InputError);
  EXPECT_THROW(s_curve({.to = 1, .velocity = 1, .acceleration = 1, .jerk = 0}), InputError);
  EXPECT_THROW(s_curve({.to = 1, .velocity = 1, .acceleration = 1, .jerk = 1e20}), InputError);
  EXPECT_THROW(s_curve({.to = 1,
                        .velocity = 1,
                        .acceleration = 1,
                        .jerk = std::numeric_limits<double>::infinity()}),
               InputError);
}

// Distances below 1e-300: the duration was not a number, and the error was of a key that no spec has.
TEST(Moves, ADistanceTooShortForADoubleIsAnErrorOfTheTarget) {
  for (const double to : {1e-320, -5e-324}) {
    const SCurveSpec spec{
        .to = to, .velocity = 400, .acceleration = 4000, .deceleration = 2500, .jerk = 80000};
    try {
      s_curve(spec);
      ADD_FAILURE() << to;
    } catch (const InputError& error) {
      EXPECT_EQ(error.key(), "to");
      EXPECT_EQ(error.rule(), "is too close to `from`: the move would be too short to compute");
    }
  }
}

// A cruise that absorbed the rounding of its ends exceeded its velocity by up to 5e-10 of it.
TEST(Moves, FarFromZeroKeepTheirLimits) {
  test::Random random(1253);
  for (int k = 0; k < 2000; ++k) {
    const double from = (k % 2 == 0 ? 1 : -1) * random.log_uniform(1e3, 1e9);
    SCurveSpec spec{.from = from, .to = from + random.log_uniform(0.1, 100)};
    spec.velocity = random.log_uniform(0.5, 500);
    spec.acceleration = spec.velocity * random.uniform(3, 50);
    spec.jerk = spec.acceleration * random.uniform(5, 50);
    const Trajectory f = s_curve(spec).curve();
    const Report limits =
        check(f, {.velocity = spec.velocity, .acceleration = spec.acceleration, .jerk = spec.jerk});
    EXPECT_TRUE(limits.ok()) << from << ": " << limits.findings.front().value;
    EXPECT_TRUE(check_continuity(f, 2).ok()) << from;
    EXPECT_NEAR(f.at(f.end(), Side::left).position, spec.to, 4e-16 * std::abs(spec.to) + 1e-15);
  }
}

}  // namespace
}  // namespace jounce::s_curve_test
