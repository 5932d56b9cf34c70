// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include <gtest/gtest.h>

#include "jounce/profiles/online/online.hpp"

#include "support/random.hpp"

// Orders repeated in every cycle cost no time. A move is *late* if it arrives more than 0.1 % and one
// cycle after the one-shot optimum: the motion that synchronize() finds once, at the beginning, for the
// place (or the motion) that the target has in the end.

namespace jounce::online_late_test {
namespace {

constexpr double cycles = 300;  // per move
constexpr double late = 1.001;

int cases(int usual) {
  const char* text = std::getenv("JOUNCE_CASES");
  return text ? std::atoi(text) : usual;
}

MotionState random_state(test::Random& random) {
  return {random.uniform(-3, 3), random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9)};
}

AxisMove random_move(test::Random& random, MoveGoal goal) {
  AxisMove m{random_state(random), random_state(random),
             within(random.uniform(2, 6), random.uniform(1, 6), random.uniform(1, 20)), goal};
  if (goal == MoveGoal::moving) m.to.acceleration = 0;
  return m;
}

double optimum(const AxisMove& m) {
  Profile best;
  EXPECT_EQ(synchronize({&m, 1}, Sync::none, {&best, 1}).status, MoveStatus::ok);
  return best.duration();
}

/// The target as a program gives it at t.
using Target = std::function<MotionState(double t)>;

Target as_it_moves(const AxisMove& m) {
  return [m](double t) {
    MotionState now = m.to;
    if (m.goal == MoveGoal::moving) now.position += t * now.velocity;
    return now;
  };
}

/// When the generator arrives, the target set in every cycle.
double arrival(const AxisMove& m, const Target& target, double tolerance, double dt,
               double give_up) {
  OnlineGenerator<1> g;
  g.set_tolerance(0, tolerance);
  g.set_state(0, m.from);
  g.set_bounds(0, m.bounds);
  for (int k = 0; k * dt < give_up; ++k) {
    g.set_target(0, target(k * dt), m.goal);
    if (g.step(dt).arrived) return k * dt;  // in the course of this cycle
  }
  return give_up;
}

/// The same without a generator: the shortest move from each setpoint.
double replanned_arrival(AxisMove m, const Target& target, double dt, double give_up) {
  Profile plan;
  for (int k = 0; k * dt < give_up; ++k) {
    m.to = target(k * dt);
    (void)synchronize({&m, 1}, Sync::none, {&plan, 1});
    if (plan.duration() <= dt) return k * dt;
    const Motion next = plan.at(dt);
    m.from = {next.position, next.velocity, next.acceleration};
  }
  return give_up;
}

struct Late {
  int generator = 0;
  int replanned = 0;
};

/// Counts the late moves, for a target with noise of this size.
Late late_moves(MoveGoal goal, double noise, double tolerance, std::uint64_t seed, int n) {
  test::Random random(seed);
  Late count;
  for (int i = 0; i < n; ++i) {
    const AxisMove m = random_move(random, goal);
    const double t = optimum(m);
    const Target exact = as_it_moves(m);
    const Target noisy = [&](double now) {
      MotionState s = exact(now);
      s.position += noise * random.uniform(-1, 1) * (std::abs(s.position) + 1);
      return s;
    };
    const double dt = t / cycles;
    count.generator += arrival(m, noisy, tolerance, dt, 2 * t) > late * t;
    count.replanned += replanned_arrival(m, noisy, dt, 2 * t) > late * t + dt;
  }
  std::printf("seed %d: late %d, planned in every cycle %d, of %d\n", static_cast<int>(seed),
              count.generator, count.replanned, n);
  return count;
}

TEST(OnlineLate, NoMoveToAStateThatIsSetInEveryCycle) {
  const Late count = late_moves(MoveGoal::state, 0, 0, 71, cases(1000));
  EXPECT_EQ(count.generator, 0);
  EXPECT_GT(count.replanned, cases(1000) / 20);  // the cost of planning in every cycle
}

TEST(OnlineLate, NoMoveToAStateWithTheNoiseOfRounding) {
  EXPECT_EQ(late_moves(MoveGoal::state, 0x1p-52, 0, 72, cases(1000)).generator, 0);
}

TEST(OnlineLate, NoMoveToAStateWithNoiseWithinTheTolerance) {
  const Late count = late_moves(MoveGoal::state, 1e-6, 1e-5, 73, cases(500));
  EXPECT_EQ(count.generator, 0);
  EXPECT_GT(count.replanned, cases(500) / 20);
}

TEST(OnlineLate, NoMeetingOfATargetThatMoves) {
  EXPECT_EQ(late_moves(MoveGoal::moving, 0, 0, 74, cases(1000)).generator, 0);
  EXPECT_EQ(late_moves(MoveGoal::moving, 0x1p-52, 0, 75, cases(1000)).generator, 0);
  EXPECT_EQ(late_moves(MoveGoal::moving, 1e-6, 1e-4, 76, cases(500)).generator, 0);
}

/// A target at rest that creeps on and stays where it is before the axis begins to brake: the optimum
/// is that of where it stays.
TEST(OnlineLate, NoMoveWhoseTargetComesToRestBeforeTheAxisBrakes) {
  test::Random random(77);
  int n = 0;
  for (int i = 0; i < cases(1000); ++i) {
    AxisMove m{{}, {random.uniform(1, 3), 0, 0}, within(2, random.uniform(2, 6), 30)};
    const double t = optimum(m);
    const double creeps = random.uniform(0, 0.3) * t;
    const double way = random.uniform(-0.1, 0.1);
    const MotionState begins{m.to.position - way, 0, 0};
    const double dt = t / cycles;
    const double when = arrival(
        m,
        [&](double now) {
          return now < creeps ? MotionState{begins.position + way * now / creeps, 0, 0} : m.to;
        },
        0, dt, 2 * t);
    if (when > late * t) ++n;
  }
  EXPECT_EQ(n, 0);
}

/// Several axes at once, all orders in every cycle.
TEST(OnlineLate, NoCommonMoveOfSeveralAxes) {
  test::Random random(78);
  int n = 0;
  for (int i = 0; i < cases(500); ++i) {
    std::array<AxisMove, 3> moves;
    for (auto& m : moves) m = random_move(random, MoveGoal::state);
    std::array<Profile, 3> best;
    const double t = synchronize(moves, Sync::time, best).duration;
    OnlineGenerator<3> g(Sync::time);
    for (std::size_t a = 0; a < 3; ++a) g.set_state(a, moves[a].from);
    const double dt = t / cycles;
    double when = 2 * t;
    for (int k = 0; k * dt < when; ++k) {
      for (std::size_t a = 0; a < 3; ++a) {
        MotionState to = moves[a].to;
        to.position *= 1 + 0x1p-52 * random.uniform(-1, 1);
        g.set_bounds(a, moves[a].bounds);
        g.set_target(a, to);
      }
      if (g.step(dt).arrived) when = k * dt;
    }
    if (when > late * t) ++n;
  }
  EXPECT_EQ(n, 0);
}

}  // namespace
}  // namespace jounce::online_late_test
