// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/query.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/random.hpp"

namespace jounce::query_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The same questions by bisection in long double, on ramps walked phase by phase.
using Long = long double;

struct Reference {
  Long duration = 0, distance = 0, velocity = 0, acceleration = 0;

  void go(Long t, Long jerk) {
    distance += t * (velocity + t * (acceleration / 2 + t * jerk / 6));
    velocity += t * (acceleration + t * jerk / 2);
    acceleration += t * jerk;
    duration += t;
  }
  /// From v = start by rise > 0, upwards.
  static Reference ramp(Long start, Long rise, const Ramp& r) {
    Reference walk{.velocity = start};
    if (std::isinf(r.jerk)) {
      walk.acceleration = r.acceleration;
      walk.go(rise / walk.acceleration, 0);
      return walk;
    }
    const Long peak = std::min<Long>(r.acceleration, std::sqrt(rise * r.jerk));
    walk.go(peak / r.jerk, r.jerk);
    walk.go(std::max<Long>((rise - peak * peak / r.jerk) / peak, 0), 0);
    walk.go(peak / r.jerk, -static_cast<Long>(r.jerk));
    return walk;
  }
};

/// The largest w in [0, hi] with way(w^2) <= distance: squared, so that small ones are resolved.
template <class Way>
Long bisect(const Way& way, Long hi, Long distance) {
  Long lo = 0;
  hi = std::sqrt(hi);
  for (int i = 0; i < 130; ++i) {
    const Long mid = (lo + hi) / 2;
    (way(mid * mid) <= distance ? lo : hi) = mid;
  }
  return lo * lo;
}

struct Answer {
  Long duration, peak;
};

Answer reference_way(double distance, const SpanEnds& ends, const Ramp& ramp) {
  const Long l = std::min(ends.entry, ends.exit);
  const Long h = std::max(ends.entry, ends.exit);
  const auto both = [&](Long e, auto member) {
    return Reference::ramp(l, h - l + e, ramp).*member + Reference::ramp(h, e, ramp).*member;
  };
  const auto way = [&](Long e) { return both(e, &Reference::distance); };
  const Long room = static_cast<Long>(ends.velocity) - h;
  const bool cruises = way(room) <= distance;
  const Long e = cruises ? room : bisect(way, room, distance);
  const Long cruise = cruises ? (distance - way(room)) / ends.velocity : 0;
  return {both(e, &Reference::duration) + cruise, h + e};
}

Ramp any_ramp(test::Random& random) {
  return {random.log_uniform(1e-3, 1e3),
          random.below(8) == 0 ? infinite : random.log_uniform(1e-3, 1e3)};
}

double any_velocity(test::Random& random) {
  return random.below(4) == 0 ? 0 : random.log_uniform(1e-3, 1e3);
}

void expect_close(double got, Long expected, double tolerance, const char* what) {
  EXPECT_NEAR(got, static_cast<double>(expected),
              tolerance * std::abs(static_cast<double>(expected)))
      << what;
}

TEST(RampBetween, HmplSmoothingExample) {
  // HIMC HMPL manual 5.1: v 100, a 500, smoothing 50 ms (jerk 10000): 250 ms.
  const auto ramp = ramp_between(0, 100, {.acceleration = 500, .jerk = 1e4});
  ASSERT_TRUE(ramp);
  EXPECT_DOUBLE_EQ(ramp->duration, 0.25);
  EXPECT_DOUBLE_EQ(ramp->distance, 12.5);
}

TEST(EntryVelocity, UndoesTheRampOverSixDecades) {
  test::Random random(1);
  for (int i = 0; i < 100000 && !::testing::Test::HasFailure(); ++i) {
    const Ramp ramp = any_ramp(random);
    const double exit = any_velocity(random);
    const double distance = random.log_uniform(1e-3, 1e3);
    SCOPED_TRACE(::testing::Message()
                 << distance << ' ' << exit << ' ' << ramp.acceleration << ' ' << ramp.jerk);
    const auto entry = entry_velocity(distance, exit, ramp);
    ASSERT_TRUE(entry);
    // The stop from there over the distance, independent of the method that found the entry.
    const auto way = [&](Long e) { return Reference::ramp(exit, e, ramp).distance; };
    Long high = 1;
    while (way(high) < distance) high *= 2;
    expect_close(*entry, exit + bisect(way, high, distance), 1e-15, "entry");
  }
}

TEST(PeakVelocity, AndDurationAgreeWithBisectionOverSixDecades) {
  test::Random random(2);
  for (int i = 0; i < 100000 && !::testing::Test::HasFailure(); ++i) {
    const Ramp ramp = any_ramp(random);
    SpanEnds ends{any_velocity(random), any_velocity(random), 0};
    if (random.below(4) == 0) ends.exit = ends.entry;
    ends.velocity = std::max({ends.entry, ends.exit, 1e-3}) * (1 + random.log_uniform(1e-3, 1e3));
    const double direct = ramp_between(ends.entry, ends.exit, ramp)->distance;
    const double distance = direct + random.log_uniform(1e-3, 1e3);
    SCOPED_TRACE(::testing::Message()
                 << distance << ' ' << ends.entry << ' ' << ends.exit << ' ' << ends.velocity << ' '
                 << ramp.acceleration << ' ' << ramp.jerk);
    const auto peak = peak_velocity(distance, ends, ramp);
    const auto duration = minimum_duration(distance, ends, ramp);
    ASSERT_TRUE(peak && duration);
    const Answer expected = reference_way(distance, ends, ramp);
    expect_close(*duration, expected.duration, 2e-15, "duration");
    // For a short distance beyond the direct ramp the peak is as accurate as its excess.
    expect_close(*peak, expected.peak, 2e-15, "peak");
  }
}

TEST(MinimumDuration, IsTheRestToRestMoves) {
  test::Random random(3);
  for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
    const double h = random.log_uniform(1e-3, 1e3);
    const double v = random.log_uniform(1e-3, 1e3);
    const Ramp ramp{random.log_uniform(1e-3, 1e3), random.log_uniform(1e-3, 1e3)};
    SCOPED_TRACE(::testing::Message()
                 << h << ' ' << v << ' ' << ramp.acceleration << ' ' << ramp.jerk);
    const double s =
        s_curve({.to = h, .velocity = v, .acceleration = ramp.acceleration, .jerk = ramp.jerk})
            .duration();
    const double t =
        trapezoid({.to = h, .velocity = v, .acceleration = ramp.acceleration}).duration();
    expect_close(minimum_duration(h, {.velocity = v}, ramp).value(), s, 2e-15, "S-curve");
    expect_close(minimum_duration(h, {.velocity = v}, {ramp.acceleration}).value(), t, 2e-15,
                 "trapezoid");
  }
}

TEST(PeakVelocity, OfTheShortestWayIsTheFasterEnd) {
  test::Random random(4);
  for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
    const Ramp ramp = any_ramp(random);
    const double exit = any_velocity(random);
    const double distance = random.log_uniform(1e-3, 1e3);
    const double entry = entry_velocity(distance, exit, ramp).value();
    SCOPED_TRACE(::testing::Message()
                 << distance << ' ' << exit << ' ' << ramp.acceleration << ' ' << ramp.jerk);
    // Rounding in one answer must not make the other question impossible.
    EXPECT_TRUE(peak_velocity(distance, {entry, exit}, ramp));
    EXPECT_FALSE(peak_velocity(distance * (1 - 1e-12), {entry * (1 + 1e-12), exit}, ramp));
  }
}

/// A stop with the velocity driven to 0 by bisection on the peak deceleration.
Reference reference_stop(Moving now, const Ramp& ramp, Long sign) {
  const Long a = sign * now.acceleration;
  const Long limit = ramp.acceleration;
  const auto walk = [&](Long p, Long hold) {
    Reference w{.velocity = sign * now.velocity, .acceleration = a};
    w.go(std::abs(a + p) / ramp.jerk,
         a > -p ? -static_cast<Long>(ramp.jerk) : static_cast<Long>(ramp.jerk));
    w.acceleration = -p;  // rounding of a large a would show beside a small p
    w.go(hold, 0);
    w.go(p / ramp.jerk, ramp.jerk);
    return w;
  };
  const Long left = walk(limit, 0).velocity;
  if (left >= 0) return walk(limit, left / limit);
  Long lo = std::max<Long>(0, -a);
  Long hi = limit;
  for (int i = 0; i < 200; ++i) {
    const Long mid = (lo + hi) / 2;
    (walk(mid, 0).velocity >= 0 ? lo : hi) = mid;
  }
  return walk(lo, 0);
}

TEST(Stopping, AgreesWithBisectionOverSixDecades) {
  test::Random random(5);
  for (int i = 0; i < 100000 && !::testing::Test::HasFailure(); ++i) {
    const Ramp ramp{random.log_uniform(1e-3, 1e3), random.log_uniform(1e-3, 1e3)};
    const double size = random.log_uniform(1e-3, 1e3);
    const Moving now{random.uniform(-1, 1) * random.log_uniform(1e-3, 1e3),
                     random.uniform(-1, 1) * size};
    SCOPED_TRACE(::testing::Message() << now.velocity << ' ' << now.acceleration << ' '
                                      << ramp.acceleration << ' ' << ramp.jerk);
    const auto stop = stopping(now, ramp);
    ASSERT_TRUE(stop);
    const Long rest = static_cast<Long>(now.velocity) + static_cast<Long>(now.acceleration) *
                                                            std::abs(now.acceleration) /
                                                            (2 * static_cast<Long>(ramp.jerk));
    const Long sign = rest < 0 ? -1 : 1;
    const Reference expected = reference_stop(now, ramp, sign);
    // If little is left after the release of a, the time is the square root of that rest.
    const Long size_of_parts = std::abs(now.velocity) + std::abs(rest - now.velocity);
    const double lost = 1e-15 * static_cast<double>(std::sqrt(size_of_parts / std::abs(rest)));
    EXPECT_NEAR(stop->duration, static_cast<double>(expected.duration),
                (1e-15 + lost) * stop->duration);
    const double scale = stop->duration * static_cast<double>(size_of_parts);
    EXPECT_NEAR(stop->distance, static_cast<double>(sign * expected.distance),
                (1e-14 + lost) * scale);
  }
}

TEST(Stopping, SecondOrderIsTheTextbooks) {
  const auto stop = stopping({-3, 7}, {.acceleration = 2});
  ASSERT_TRUE(stop);
  EXPECT_DOUBLE_EQ(stop->duration, 1.5);
  EXPECT_DOUBLE_EQ(stop->distance, -2.25);
}

TEST(Queries, AreTheSolversAnswers) {
  test::Random random(6);
  for (int i = 0; i < 50000 && !::testing::Test::HasFailure(); ++i) {
    const Ramp ramp = any_ramp(random);
    const double v = any_velocity(random);
    const double w = any_velocity(random);
    const double limit = std::max({v, w, 1e-3}) * (1 + random.log_uniform(1e-3, 1e3));
    SCOPED_TRACE(::testing::Message()
                 << v << ' ' << w << ' ' << limit << ' ' << ramp.acceleration << ' ' << ramp.jerk);
    const Bounds bounds = within(limit, ramp.acceleration, ramp.jerk);

    const Extent ramped = ramp_between(v, w, ramp).value();
    const MoveResult change = move_velocity({0, v, 0}, w, bounds);
    ASSERT_TRUE(change);
    EXPECT_NEAR(ramped.duration, change.profile.duration(), 1e-14 * ramped.duration);
    EXPECT_NEAR(ramped.distance, change.profile.end().position, 1e-14 * ramped.distance);

    const double distance = ramped.distance + random.log_uniform(1e-3, 1e3);
    const double duration = minimum_duration(distance, {v, w, limit}, ramp).value();
    const MoveResult move = move_to({0, v, 0}, {distance, w, 0}, bounds);
    ASSERT_TRUE(move);
    EXPECT_NEAR(duration, move.profile.duration(), 1e-13 * duration);

    if (std::isinf(ramp.jerk)) continue;
    const double a = random.uniform(-1, 1) * ramp.acceleration;
    const double rest = v + a * std::abs(a) / (2 * ramp.jerk);
    const double parts = v + std::abs(rest - v);
    if (std::abs(rest) < 1e-6 * parts) continue;  // a stop that hangs on rounding
    const Extent stopped = stopping({v, a}, ramp).value();
    const MoveResult halt = stop({0, v, a}, within(Bounds::none, ramp.acceleration, ramp.jerk));
    ASSERT_TRUE(halt);
    EXPECT_NEAR(stopped.duration, halt.profile.duration(), 1e-12 * stopped.duration) << "a " << a;
    EXPECT_NEAR(stopped.distance, halt.profile.end().position, 1e-11 * parts * stopped.duration);
  }
}

TEST(Queries, DoNotDependOnTheUnit) {
  const double k = 1024;
  const Ramp meters{7, 90};
  const Ramp other{7 * k, 90 * k};
  EXPECT_EQ(minimum_duration(0.3, {1, 0.2, 1.1}, meters),
            minimum_duration(0.3 * k, {k, 0.2 * k, 1.1 * k}, other));
  EXPECT_EQ(minimum_duration(0.02, {}, meters), minimum_duration(0.02 * k, {}, other));
  EXPECT_EQ(entry_velocity(0.01, 0.2, meters).value() * k,
            entry_velocity(0.01 * k, 0.2 * k, other));
  EXPECT_EQ(stopping({1, -2}, meters)->duration, stopping({k, -2 * k}, other)->duration);
}

TEST(Queries, AnswerWithNumbersUpToTheEdgesOfTheMagnitudes) {
  // 1e-30 to 1e30, each value on its own: every answer is finite, and agrees with the others.
  test::Random random(46);
  const auto any = [&] {
    const int which = random.below(8);
    return which == 0 ? 1e-30 : which == 1 ? 1e30 : random.log_uniform(1e-30, 1e30);
  };
  for (int i = 0; i < 100000 && !HasFailure(); ++i) {
    const Ramp ramp{any(), random.below(8) == 0 ? infinite : any()};
    const double distance = any();
    const double exit = random.below(3) == 0 ? 0 : any();
    const double a = (random.below(2) == 0 ? -1 : 1) * any();
    SCOPED_TRACE(::testing::Message() << ramp.acceleration << ' ' << ramp.jerk << ' ' << distance
                                      << ' ' << exit << ' ' << a);
    const auto positive = [](const auto& answer) { return std::isfinite(answer) && answer > 0; };
    const double entry = entry_velocity(distance, exit, ramp).value();
    EXPECT_TRUE(std::isfinite(entry) && entry >= exit);
    EXPECT_TRUE(positive(peak_velocity(distance, {}, ramp).value()));
    EXPECT_TRUE(positive(minimum_duration(distance, {}, ramp).value()));
    EXPECT_TRUE(positive(minimum_duration(distance, {.velocity = any()}, ramp).value()));
    const Extent stop = stopping({exit, a}, ramp).value();
    EXPECT_TRUE(std::isfinite(stop.duration) && std::isfinite(stop.distance));
    if (const auto t = minimum_duration(distance, {exit, 0, infinite}, ramp)) {
      EXPECT_TRUE(positive(*t));
    }
    // Without ends: 2 (z + tau) with A (z^2 + tau z) = D, or (32 D/J)^(1/3) where A is not reached.
    const double tau = ramp.acceleration / ramp.jerk;
    const double b = std::hypot(tau, 2 * std::sqrt(distance / ramp.acceleration));
    const double z = 2 * distance / ramp.acceleration / (tau + b);
    const double expected = z >= tau ? 2 * (z + tau) : std::cbrt(32 * (distance / ramp.jerk));
    EXPECT_NEAR(minimum_duration(distance, {}, ramp).value(), expected, 1e-13 * expected);
  }
}

TEST(Queries, AnswerNothingBeyondTheMagnitudes) {
  EXPECT_FALSE(stopping({1e300, 1e300}, {1, 1}));
  EXPECT_FALSE(stopping({1, -1e31}, {1, 1}));
  EXPECT_FALSE(peak_velocity(5e-324, {}, {1, 1}));
  EXPECT_FALSE(minimum_duration(1e-300, {}, {1e-300, 1e-300}));
  EXPECT_FALSE(minimum_duration(1e31, {}, {1, 1}));
  EXPECT_FALSE(minimum_duration(1, {.velocity = 1e31}, {1, 1}));
  EXPECT_FALSE(minimum_duration(1, {}, {1, 1e-31}));
  EXPECT_FALSE(minimum_duration(1, {}, {1, 1e300}));
  EXPECT_FALSE(ramp_between(0, 1e31, {1, 1}));
  EXPECT_FALSE(entry_velocity(1, 1e31, {1, 1}));
  EXPECT_FALSE(entry_velocity(1e-31, 0, {1, 1}));
}

TEST(Queries, AnswerTheImpossibleWithNothing) {
  const Ramp ramp{2, 10};
  const double nan = std::nan("");
  EXPECT_FALSE(entry_velocity(-1, 0, ramp));
  EXPECT_FALSE(entry_velocity(1, -1, ramp));
  EXPECT_FALSE(entry_velocity(1, 0, {.acceleration = 0}));
  EXPECT_FALSE(entry_velocity(1, 0, {2, nan}));
  EXPECT_FALSE(peak_velocity(0, {}, ramp));
  EXPECT_FALSE(peak_velocity(0.1, {3, 0}, ramp)) << "too short to stop from 3";
  EXPECT_FALSE(peak_velocity(1, {1, 0, 0.5}, ramp)) << "an end above the limit";
  EXPECT_FALSE(minimum_duration(infinite, {}, ramp));
  EXPECT_FALSE(stopping({nan, 0}, ramp));
  EXPECT_FALSE(ramp_between(0, infinite, ramp));
  EXPECT_EQ(entry_velocity(0, 3, ramp), 3);
}

}  // namespace
}  // namespace jounce::query_test
