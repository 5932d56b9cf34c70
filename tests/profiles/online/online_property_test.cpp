// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "jounce/profiles/online/online.hpp"

#include "support/random.hpp"

// Two promises over random cases: a limit lowered in flight makes no axis pass its target or turn round,
// and orders repeated in every cycle make no axis late. The judges see setpoints alone. JOUNCE_CASES
// sets how many cases there are.

namespace jounce::online_property_test {
namespace {

int cases(int usual) {
  const char* text = std::getenv("JOUNCE_CASES");
  return text ? std::atoi(text) : usual;
}

/// The limits of an axis, the same in both directions.
struct Triple {
  double v, a, j;

  [[nodiscard]] Bounds bounds() const { return within(v, a, j); }
};

/// Distance to rest of an axis with v > 0, integrated numerically: the acceleration falls at full
/// jerk until its release removes the remaining velocity. Negative if the velocity passes zero in
/// every case.
double braking_distance(double v, double a, const Triple& limits) {
  if (a < 0 && a * a > 2 * limits.j * v * (1 + 1e-9)) return -1;
  const double dt = (v / limits.a + (limits.a + std::abs(a)) / limits.j) / 4000;
  double x = 0;
  while (a > 0 || v > a * a / (2 * limits.j)) {
    const double next = a < -limits.a ? std::min(a + limits.j * dt, -limits.a)
                                      : std::max(a - limits.j * dt, -limits.a);
    x += v * dt + (2 * a + next) * dt * dt / 6;
    v += (a + next) / 2 * dt;
    a = next;
  }
  const double release = -a / limits.j;  // v + a t + j t^2/2 falls to rest
  return x + release * std::max(v, 0.0) / 3;
}

/// Watches an axis on its way forwards to a target at rest.
class Judge {
 public:
  Judge(double target, const Triple& before, double dt)
      : target_(target), before_(before), after_(before), dt_(dt) {}

  /// From the next setpoint on.
  void lowered(const Triple& after) {
    after_ = after;
    const double rise = std::max(last_.acceleration, 0.0);
    highest_ = std::max(after.v, last_.velocity + rise * rise / (2 * after.j));
  }

  void see(const Motion& m, const Bounds& in_force) {
    overshoot = std::max(overshoot, (m.position - target_) / target_);
    farthest_ = std::max(farthest_, m.position);
    reversal = std::max(reversal, (farthest_ - m.position) / target_);
    const bool wide = in_force.jerk_max > after_.j || in_force.acceleration_max > after_.a;
    judge_integral(m, wide ? before_.j : after_.j);
    judge_acceleration(m, wide ? before_ : after_);
    judge_velocity(m);
    if (wide && last_.velocity <= after_.v) judge_need();
    last_ = m;
  }

  double overshoot = 0, reversal = 0;  ///< shares of the target: passed, gone back
  int jerks = 0, accelerations = 0, velocities = 0, breaks = 0, needless = 0;

 private:
  /// Position and velocity are the integrals of what stands beside them.
  void judge_integral(const Motion& m, double jerk) {
    const double dv = m.velocity - last_.velocity - dt_ * (last_.acceleration + m.acceleration) / 2;
    const double dx = m.position - last_.position - dt_ * (last_.velocity + m.velocity) / 2 +
                      dt_ * dt_ * (m.acceleration - last_.acceleration) / 12;
    if (std::abs(dv) > jerk * dt_ * dt_ / 4 * (1 + 1e-6) + 1e-9 * before_.v) ++breaks;
    if (std::abs(dx) > jerk * dt_ * dt_ * dt_ / 8 + 1e-9 * target_) ++breaks;
    if (std::abs(m.acceleration - last_.acceleration) > jerk * dt_ * (1 + 1e-6)) ++jerks;
  }
  /// Inside the limit, or on the way there at full jerk, or held where the axis could not stop in time
  /// otherwise.
  void judge_acceleration(const Motion& m, const Triple& limits) {
    const double a = std::abs(m.acceleration);
    const double before = std::abs(last_.acceleration);
    const double slack = 1e-6 * before_.a;
    if (a <= std::max(limits.a, before - limits.j * dt_) + slack) return;
    if (a > before + slack)
      ++accelerations;
    else
      judge_need();
  }
  /// Never higher than it had to be, and once inside never outside.
  void judge_velocity(const Motion& m) {
    if (m.velocity > highest_ * (1 + 1e-9)) ++velocities;
    if (m.velocity <= after_.v && m.acceleration <= 0) highest_ = after_.v;
  }
  /// Wider limits than those that are set: only where these would pass the target or turn round, or the
  /// velocity would leave its limit again.
  void judge_need() {
    if (++seen_ % 8 != 1) return;
    const double rise = std::max(last_.acceleration, 0.0);
    if (last_.velocity + rise * rise / (2 * after_.j) > after_.v * (1 - 1e-9)) return;
    const double s = braking_distance(last_.velocity, last_.acceleration, after_);
    if (s >= 0 && s < (target_ - last_.position) * (1 - 1e-2) - 1e-6 * target_) ++needless;
  }

  double target_;
  Triple before_, after_;
  double dt_;
  double highest_ = Bounds::none;
  double farthest_ = 0;
  Motion last_;
  int seen_ = 0;
};

struct Tally {
  int overshoot = 0, reversal = 0, late = 0, wide = 0, other = 0, printed = 0, stopped = 0;
};

/// Permitted rounding, as a share of the target.
constexpr double rounding = 1e-11;

/// One axis from rest to rest whose limits are lowered on the way, each in `which` or not.
void lower_in_flight(test::Random& r, const std::array<bool, 3>& which, Tally& tally) {
  const Triple before{r.log_uniform(0.1, 10), r.log_uniform(0.1, 30), r.log_uniform(0.5, 200)};
  const auto share = [&](bool lowers) { return lowers ? r.log_uniform(0.05, 1) : 1; };
  const Triple after{before.v * share(which[0]), before.a * share(which[1]),
                     before.j * share(which[2])};
  const double target = r.log_uniform(0.01, 50);
  OnlineGenerator<1> g;
  g.set_bounds(0, before.bounds());
  g.set_target(0, {.position = target});
  (void)g.step(0);
  const double dt = g.remaining() / 400;
  Judge judge(target, before, dt);
  const int lowered = 1 + r.below(398);
  bool wide = false;
  bool arrived = false;
  for (int k = 0; k < 400000 && !arrived; ++k) {
    if (k == lowered) {
      g.set_bounds(0, after.bounds());
      judge.lowered(after);
    }
    const OnlineStep s = g.step(dt);
    arrived = s.arrived;
    judge.see(g[0], g.in_force(0));
    wide = wide || (k > lowered && g.in_force(0) != after.bounds());
    tally.other += s.status != MoveStatus::ok;
  }
  tally.overshoot += judge.overshoot > rounding;
  tally.reversal += judge.reversal > rounding;
  tally.late += !arrived;
  tally.wide += wide;
  const int breaches =
      judge.breaks + judge.jerks + judge.accelerations + judge.velocities + judge.needless;
  tally.other += breaches > 0;
  if ((breaches > 0 || judge.overshoot > rounding || judge.reversal > rounding) &&
      ++tally.printed < 4)
    std::printf(
        "v %.17g a %.17g j %.17g, lowered to %.17g %.17g %.17g in cycle %d, target %.17g: passes "
        "it by "
        "%g, goes back by %g, breaks %d, jerk %d, acceleration %d, velocity %d, needless %d\n",
        before.v, before.a, before.j, after.v, after.a, after.j, lowered, target, judge.overshoot,
        judge.reversal, judge.breaks, judge.jerks, judge.accelerations, judge.velocities,
        judge.needless);
}

void expect_nothing(const std::array<bool, 3>& which, std::uint64_t seed) {
  test::Random random(seed);
  Tally tally;
  const int n = cases(1000);
  for (int i = 0; i < n; ++i) lower_in_flight(random, which, tally);
  EXPECT_EQ(tally.overshoot, 0) << "of " << n << ", seed " << seed;
  EXPECT_EQ(tally.reversal, 0) << "of " << n << ", seed " << seed;
  EXPECT_EQ(tally.late, 0) << "of " << n << ", seed " << seed;
  EXPECT_EQ(tally.other, 0) << "of " << n << ", seed " << seed;
}

TEST(OnlineLowered, TheAcceleration) {
  expect_nothing({false, true, false}, 61);
}
TEST(OnlineLowered, TheJerk) {
  expect_nothing({false, false, true}, 62);
}
TEST(OnlineLowered, AccelerationAndJerk) {
  expect_nothing({false, true, true}, 63);
}
TEST(OnlineLowered, TheVelocity) {
  expect_nothing({true, false, false}, 64);
}
TEST(OnlineLowered, AllLimits) {
  expect_nothing({true, true, true}, 65);
}

/// Three axes, the limits of one lowered on the way.
void lower_one_of_three(test::Random& r, Sync sync, Tally& tally) {
  constexpr std::size_t n = 3;
  std::array<double, n> target{}, overshoot{}, farthest{}, reversal{};
  std::array<Triple, n> limits{};
  OnlineGenerator<n> g(sync);
  for (std::size_t i = 0; i < n; ++i) {
    target[i] = r.log_uniform(0.1, 10);
    limits[i] = {r.log_uniform(0.3, 10), r.log_uniform(0.3, 30), r.log_uniform(1, 200)};
    g.set_bounds(i, limits[i].bounds());
    g.set_target(i, {.position = target[i]});
  }
  (void)g.step(0);
  const double dt = g.remaining() / 200;
  const int lowered = 1 + r.below(198);
  const auto which = static_cast<std::size_t>(r.below(3));
  const Triple low{limits[which].v * r.log_uniform(0.05, 1),
                   limits[which].a * r.log_uniform(0.05, 1),
                   limits[which].j * r.log_uniform(0.05, 1)};
  bool arrived = false;
  bool bent = false;  // no motion on the line keeps the lowered limits: the status reports it
  bool stopped = false;
  double off_line = 0;
  for (int k = 0; k < 40000 && !arrived; ++k) {
    if (k == lowered) g.set_bounds(which, low.bounds());
    const OnlineStep s = g.step(dt);
    arrived = s.arrived;
    bent = bent || s.status == MoveStatus::not_straight;
    const auto rests = [&g](std::size_t i) { return g[i].velocity == 0; };
    stopped = stopped || (!arrived && dt > 0 && rests(0) && rests(1) && rests(2));
    tally.other += s.status != MoveStatus::ok && s.status != MoveStatus::not_straight;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = g[i].position / target[i];
      overshoot[i] = std::max(overshoot[i], x - 1);
      farthest[i] = std::max(farthest[i], x);
      reversal[i] = std::max(reversal[i], farthest[i] - x);
    }
    off_line = std::max(off_line, std::abs(g[1].position / target[1] - g[0].position / target[0]));
  }
  tally.late += !arrived;
  for (std::size_t i = 0; i < n; ++i) {
    tally.overshoot += overshoot[i] > rounding;
    tally.reversal += reversal[i] > rounding;
  }
  tally.other += sync == Sync::phase && off_line > 1e-9 && !bent;
  tally.stopped += stopped;
}

TEST(OnlineLowered, OneOfSeveralAxes) {
  for (const Sync sync : {Sync::time, Sync::time_if_moving, Sync::phase, Sync::phase_or_time}) {
    test::Random random(66);
    Tally tally;
    const int n = cases(4000);
    for (int i = 0; i < n; ++i) lower_one_of_three(random, sync, tally);
    EXPECT_EQ(tally.overshoot, 0) << "of " << n << ", sync " << static_cast<int>(sync);
    EXPECT_EQ(tally.reversal, 0) << "of " << n << ", sync " << static_cast<int>(sync);
    EXPECT_EQ(tally.late, 0) << "of " << n << ", sync " << static_cast<int>(sync);
    EXPECT_EQ(tally.other, 0) << "of " << n << ", sync " << static_cast<int>(sync);
    EXPECT_EQ(tally.stopped, 0) << "of " << n << ", sync " << static_cast<int>(sync);
  }
}

}  // namespace
}  // namespace jounce::online_property_test
