// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/override.hpp"

#include <gtest/gtest.h>

#include "jounce/path/hold.hpp"
#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

namespace jounce::override_test {
namespace {

using path_tests::Random;
using path_tests::usual;

/// Lines with corners, and arcs that are tangent to the line before them.
Program random_program(Random& random, double reach) {
  Program p(2);
  PathSettings s{.velocity = random.log_between(20, 200),
                 .corner = Corner::deviation,
                 .value = random.log_between(0.05, 5)};
  Point at{};
  for (int i = 0; i < 8; ++i) {
    if (random() < 0.3) s.velocity = random.log_between(20, 200);
    p.set(s);
    Point to = at;
    to[0] += random.between(-reach, reach);
    to[1] += random.between(-reach, reach);
    if (random() < 0.3) {
      const double radius = std::hypot(to[0] - at[0], to[1] - at[1]) * random.between(0.55, 2);
      p.arc(arc_of_radius(at, radius, to, Plane{0, 1},
                          random() < 0.5 ? ArcRotation::clockwise : ArcRotation::counterclockwise),
            i + 1);
    } else {
      p.line(to, i + 1);
    }
    at = to;
    if (random() < 0.1) p.dwell(0.1);
  }
  return p;
}

std::vector<FactorRequest> random_steps(Random& random, double duration) {
  std::vector<FactorRequest> steps;
  double t = duration * random.between(0, 0.3);
  for (int i = 0; i < 8; ++i) {
    const double pick = random();
    steps.push_back({t, pick < 0.2 ? 0 : pick < 0.4 ? 1 : random.between(0, 2)});
    t += duration * random.log_between(1e-4, 0.3);
  }
  steps.push_back({t, 1});
  return steps;
}

/// Continuous axes from the start to the end of a path, within the limits, and on it.
void expect_good(const Plan& motion, const GroupLimits& limits) {
  const PlanAxes axes = to_axes(motion);
  EXPECT_LE(path_tests::excess(axes, limits), 1e-12);
  std::vector<Motion> now(2);
  for (std::size_t i = 0; i < 2; ++i) {
    const Trajectory& f = axes.curves[i];
    EXPECT_LE(std::abs(largest_jump(f, 0).step), 1e-9);
    EXPECT_LE(std::abs(largest_jump(f, 1).step), 1e-6);
    EXPECT_NEAR(f.at(0).velocity, 0, 1e-7);
    EXPECT_NEAR(f.at(f.end(), Side::left).velocity, 0, 1e-7);
    EXPECT_NEAR(f.end(), motion.duration(), 1e-9 * motion.duration());
  }
  double q = -1;
  double before = -1;
  for (const LawInterval& s : motion.law().stretches()) {
    EXPECT_NEAR(s.start, before < 0 ? s.start : before, 1e-9 * motion.path().length());
    before = s.start + s.length;
    for (const double share : {0.0, 0.3, 0.7}) {
      const double t = s.time + share * s.duration;
      const Motion law = motion.law().at(t);
      EXPECT_GE(law.position, q - 1e-9);
      EXPECT_GE(law.velocity, -1e-9);
      q = law.position;
      motion.at(t, now);
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(axes.curves[i].at(t).position, now[i].position, 1e-8);
    }
  }
}

/// Example 8.2 of the PMC600 manual: 5000 pulses, v 3000, a 10000, ratio 0.5, from 0.2 s 1.5, from 0.6 s 1. By hand:
/// 0.15 s to 1500, 0.05 s, 0.3 s to 4500, 0.1 s, 0.15 s to 3000, the rest of 2450 pulses at 3000, 0.3 s to 0.
TEST(Override, TakesTheTimeOfThePmc600Manual) {
  Program p(2);
  p.set({.velocity = 3000, .acceleration = 10000, .deceleration = 10000});
  p.line({3000, 4000});
  const Plan made = plan(p, {.axes = std::vector<Limits>(2)});
  const FactorRequest steps[] = {{0, 0.5}, {0.2, 1.5}, {0.6, 1}};
  const Plan motion = played(made, steps);
  EXPECT_NEAR(motion.duration(), 0.75 + 2450.0 / 3000 + 0.3, 1e-9);
  EXPECT_NEAR(motion.law().at(0.19).velocity, 1500, 1e-6);
  EXPECT_NEAR(motion.law().at(0.59).velocity, 4500, 1e-6);
  EXPECT_NEAR(motion.law().at(1).velocity, 3000, 1e-6);
}

/// A jerk of 1e4: 200 mm at 100 mm/s, half of it from 1 s on. The ramp from 100 to 50 takes T = 50 / 1000 + 1000 / 1e4.
TEST(Override, ARampHasTheLimitsOfTheAxis) {
  Program p(1);
  p.set({.velocity = 100});
  p.line({200});
  const Plan made = plan(p, usual(1));
  const FactorRequest half[] = {{1, 0.5}};
  // 1 s: 90 mm. The ramp: 0.15 s, 11.25 mm. The last ramp from 50 to 0: 0.15 s, 3.75 mm.
  EXPECT_NEAR(played(made, half).duration(), 1 + 0.15 + (200 - 90 - 11.25 - 3.75) / 50 + 0.15,
              1e-9);
  // A hold of 1 s: 0.2 s and 10 mm down, rest, up again.
  const FactorRequest hold[] = {{1, 0}, {2, 1}};
  EXPECT_NEAR(played(made, hold).duration(), 2 + 2.2 - 1 - 0.1 + 0.1, 1e-9);
  const FactorRequest stays[] = {{1, 0}};
  EXPECT_NEAR(played(made, stays).duration(), 1.2, 1e-9);
  EXPECT_NEAR(played(made, stays).duration(), halted(made, 1).duration(), 1e-12);
}

TEST(Override, OfOneIsThePlan) {
  Random random(7);
  const Plan made = plan(random_program(random, 30), usual(2));
  const FactorRequest one[] = {{0.1, 1}, {0.2, 1}};
  EXPECT_EQ(played(made, one).duration(), made.duration());
  // A step behind the end changes nothing, and a short one in the last second almost nothing before it.
  const FactorRequest late[] = {{made.duration() + 1, 0.1}};
  EXPECT_EQ(played(made, late).duration(), made.duration());
}

TEST(Override, AnyStepsStayOnThePathWithinTheLimits) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GroupLimits limits = usual(2, random.log_between(1e3, 1e6));
    const Plan made = plan(random_program(random, random.log_between(1, 100)), limits);
    const Plan motion = played(made, random_steps(random, made.duration()));
    expect_good(motion, limits);
    EXPECT_EQ(motion.path().length(), made.path().length());
    std::vector<Motion> end(2);
    std::vector<Motion> planned(2);
    motion.at(motion.duration(), end);
    made.at(made.duration(), planned);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(end[i].position, planned[i].position, 1e-9);
    if (HasFailure()) break;
  }
}

TEST(Override, LowerIsNeverFasterAnywhere) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Program program = random_program(random, 50);
    const Plan made = plan(program, usual(2));
    const FactorRequest steps[] = {{0, 0.3}};
    const Plan slow = played(made, steps);
    EXPECT_GE(slow.duration(), made.duration());
    double feed = 0;
    for (const PathSettings& s : program.settings())
      if (std::isfinite(s.velocity)) feed = std::max(feed, s.velocity);
    for (const LawInterval& s : slow.law().stretches()) EXPECT_LE(s.peak, 0.3 * feed * (1 + 1e-9));
  }
}

TEST(Override, AnAverageIsPlayedToo) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::average, .value = 0.05});
  for (int i = 1; i <= 200; ++i) p.line({50 - 50 * std::cos(i * 0.02), 50 * std::sin(i * 0.02)}, i);
  const GroupLimits limits = usual(2);
  const Plan made = plan(p, limits);
  const FactorRequest steps[] = {{0.5, 0.5}, {1, 0}, {1.5, 1.3}};
  expect_good(played(made, steps), limits);
}

TEST(Override, RejectsBadSteps) {
  Program p(1);
  p.set({.velocity = 100});
  p.line({200});
  const Plan made = plan(p, usual(1));
  const auto rejects = [&](std::vector<FactorRequest> steps, const char* key) {
    try {
      (void)played(made, steps);
      ADD_FAILURE() << key;
    } catch (const InputError& error) {
      EXPECT_EQ(error.key(), key);
    }
  };
  rejects({{-1, 1}}, "override[1].time");
  rejects({{0, 2.5}}, "override[1].factor");
  rejects({{0, 1}, {0, 0.5}}, "override[2].time");
  rejects({{0, 1}, {1, -0.5}}, "override[2].factor");
}

TEST(Retreat, ReturnsOnThePathWithinTheLimits) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GroupLimits limits = usual(2, random.log_between(1e3, 1e6));
    const Plan made = plan(random_program(random, random.log_between(1, 100)), limits);
    const Plan held = halted(made, made.duration() * random.between(0.2, 0.9));
    const LawInterval& last = held.law().stretches().back();
    const double to = random() < 0.2 ? 0 : (last.start + last.length) * random.between(0.1, 0.9);
    const Plan back = retreated(made, held, to);
    expect_good(back, limits);
    std::vector<Motion> is(2);
    std::vector<Motion> was(2);
    back.at(0, is);
    held.at(held.duration(), was);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(is[i].position, was[i].position, 1e-9);
    // The points of the way back are those of the path.
    const double length = made.path().length();
    for (int k = 0; k <= 20; ++k) {
      const double t = back.duration() * k / 20;
      back.at(t, is);
      const double q = length - back.law().at(t).position;
      std::size_t piece = 0;
      while (piece + 1 < made.path().pieces().size() && made.path().pieces()[piece + 1].start <= q)
        ++piece;
      const Point p = made.path().point(piece, q - made.path().pieces()[piece].start);
      for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(is[i].position, p[i], 1e-8);
    }
    EXPECT_NEAR(length - back.law().at(back.duration()).position, to, 1e-9 * length);
    expect_good(resumed(made, to), limits);
    if (HasFailure()) break;
  }
}

/// In the middle of a corner, the axes rest exactly there, and go on within the limits.
TEST(Retreat, RestsInTheMiddleOfACorner) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 2});
  p.line({100, 0});
  p.line({100, 100});
  const GroupLimits limits = usual(2);
  const Plan made = plan(p, limits);
  const PathPiece& corner = made.path().pieces()[1];
  ASSERT_EQ(corner.kind, PieceKind::turn);
  const Plan held = halted(made, 0.8 * made.duration());
  for (const double share : {0.0, 1e-6, 0.3, 0.5, 0.999999}) {
    SCOPED_TRACE(share);
    const double to = corner.start + share * corner.length;
    const Plan back = retreated(made, held, to);
    expect_good(back, limits);
    const Plan rest = resumed(made, to);
    expect_good(rest, limits);
    const Point at = made.path().point(1, share * corner.length);
    std::vector<Motion> end(2);
    std::vector<Motion> start(2);
    back.at(back.duration(), end);
    rest.at(0, start);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(end[i].position, at[i], 1e-10);
      EXPECT_NEAR(start[i].position, at[i], 1e-10);
      EXPECT_NEAR(end[i].velocity, 0, 1e-9);
    }
    // A hold in this corner rests there, too.
    if (share == 0.3) expect_good(halted(rest, 0.1 * rest.duration()), limits);
    EXPECT_LT(rest.duration(), made.duration() - made.law().stretches()[1].time + 0.5);
  }
}

/// A line: 90 mm at 1 s, 100 mm held at 1.2 s; 60 mm back take 60 / 100 + 0.2 s.
TEST(Retreat, OnALineTakesTheTimeOfAMove) {
  Program p(1);
  p.set({.velocity = 100});
  p.line({200});
  const Plan made = plan(p, usual(1));
  const Plan held = halted(made, 1);
  EXPECT_NEAR(retreated(made, held, 40).duration(), 60.0 / 100 + 0.2, 1e-9);
  EXPECT_THROW(retreated(made, held, 150), InputError);
  EXPECT_THROW(retreated(made, held, -1), InputError);
}

}  // namespace
}  // namespace jounce::override_test
