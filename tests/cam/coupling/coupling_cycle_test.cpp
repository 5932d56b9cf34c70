// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/coupling_cycle.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/errors.hpp"
#include "support/fig_6_14.hpp"
#include "support/random.hpp"

namespace jounce::coupling_cycle_test {
namespace {

using test::fig_6_14;

Cam line_cam(Extrapolation outside) {
  return Cam({line(10, 0, 20)}, 0, outside);
}

Cam indexing() {
  CamSpec spec;
  spec.segments = {{Law::quintic, {360, 90, 0, 0}, ""}};
  return with(design(spec).cam, Extrapolation::wrap);
}

Sample steady(double t, double v) {
  return {t, {v * t, v, 0, 0}};
}

TEST(CouplingCycle, PlaysThePmc600Example43) {
  // PMC600 manual 6.2, example 4.3: 200 pulse/s, 1080 pulses, three periods.
  const Coupling coupling(design(fig_6_14()).cam);
  const Trajectory master = trapezoid({.to = 1080, .velocity = 200, .acceleration = 1000}).curve();
  Engaged state = engage(coupling, {}, master.jet(0), 0).engaged;
  std::vector<double> ends;
  for (int n = 1; n * 1e-3 <= master.end() + 1e-3; ++n) {
    const double t = std::min(n * 1e-3, master.end());
    const Stepped now = step(coupling, state, {t, master.jet(t)});
    const double X = std::fmod(master.jet(t)[0], 360);
    if (X > 75 && X < 200 && t > 0.2 && t < master.end() - 0.2) {
      EXPECT_NEAR(now.slave[1], 200, 1e-9) << t;
      EXPECT_NEAR(now.slave[0], 25 + X, 1e-9) << t;
    }
    if (now.periods != 0) ends.push_back(now.end_time);
    state = now.engaged;
    if (t == master.end()) {
      EXPECT_NEAR(now.slave[0], 0, 1e-9) << "the end of a period";
      EXPECT_EQ(now.slave[1], 0);
      break;
    }
  }
  // x = 200 t - 20 at speed.
  ASSERT_GE(ends.size(), 2U);
  EXPECT_NEAR(ends[0], 1.9, 1e-12);
  EXPECT_NEAR(ends[1], 3.7, 1e-12);
}

TEST(CouplingCycle, PlaysThePmc600Example44) {
  // Table 6.3: (0, 0) (5000, 5000) (10000, 7000), once; master at 10000 pulse/s for 10000 pulses.
  const Coupling coupling(
      Cam({line(5000, 0, 5000), line(5000, 5000, 7000)}, 0, Extrapolation::hold));
  const double v = 10000;
  Engaged state = engage(coupling, {}, {0, v, 0, 0}, 0).engaged;
  Stepped now;
  for (int n = 1; n <= 1000; ++n) {
    const double t = n * 1e-3;
    now = step(coupling, state, steady(t, v));
    state = now.engaged;
    if (n == 1000) break;
    EXPECT_FALSE(now.released) << t;
    EXPECT_NEAR(now.slave[1], t < 0.5 ? 10000 : 4000, 1e-8) << t;
  }
  ASSERT_TRUE(now.released) << "coupling then ends";
  EXPECT_EQ(now.periods, 1);
  EXPECT_NEAR(now.end_time, 1, 1e-12);
  EXPECT_NEAR(now.slave[0], 7000, 1e-9);
  EXPECT_NEAR(point(*now.released, 1.5)[0], 9000, 1e-9) << "the slave keeps its velocity";
}

TEST(CouplingCycle, EndsOfPeriodsComeWithTheirTimeForwardsAndBackwards) {
  const Coupling coupling(indexing(), {.start = StartMode::relative});
  // x = 100 t^2 / 2 + 350: passes 360 at sqrt(0.2).
  const auto master = [](double t) { return Sample{t, {350 + 50 * t * t, 100 * t, 100, 0}}; };
  Engaged state = engage(coupling, {}, master(0).master, 0).engaged;
  int pulses = 0;
  for (int n = 1; n <= 100; ++n) {
    const Stepped now = step(coupling, state, master(n * 0.01));
    state = now.engaged;
    pulses += now.periods;
    EXPECT_NEAR(now.periods * now.end_time, now.periods * std::sqrt(0.2), 1e-14);
  }
  EXPECT_EQ(pulses, 1);
  const Stepped back = step(coupling, state, {1.1, {355, -500, 0, 0}});
  EXPECT_EQ(back.periods, -1);
  EXPECT_EQ(step(coupling, back.engaged, {1.2, {355 + 3 * 360, 500, 0, 0}}).periods, 3);
}

TEST(CouplingCycle, AnEndThatASampleLiesOnHasThatSamplesTime) {
  // x = 0.5 - 200 t at 1.25 ms a cycle: on the seam at 2.5 ms, left backwards in the cycle after.
  for (const double scale : {1.0, 0.3}) {
    const Coupling coupling(indexing(), {.master_scaling = scale});
    for (const double v : {-200.0, 200.0}) {
      const auto master = [&](int n) {
        return Sample{n * 1.25e-3, {(360 * 7 + v * (n - 2) * 1.25e-3) / scale, v / scale, 0, 0}};
      };
      Engaged state = engage(coupling, {}, master(0).master, 0).engaged;
      int pulses = 0;
      for (int n = 1; n <= 4; ++n) {
        const Stepped now = step(coupling, state, master(n));
        state = now.engaged;
        pulses += now.periods;
        if (now.periods != 0) {
          EXPECT_NEAR(now.end_time, 2.5e-3, 1e-15) << v << " " << scale;
        }
      }
      EXPECT_EQ(pulses, v > 0 ? 1 : -1) << scale;
    }
  }
}

TEST(CouplingCycle, ACamThatRunsOnceLetsTheSlaveGoAtItsEnd) {
  const Coupling coupling(line_cam(Extrapolation::hold));
  Engaged state = engage(coupling, {}, {0, 4, 0, 0}, 0).engaged;
  state = step(coupling, state, steady(2.4, 4)).engaged;
  const Stepped now = step(coupling, state, steady(2.6, 4));  // 10 at 2.5
  ASSERT_TRUE(now.released);
  EXPECT_NEAR(now.end_time, 2.5, 1e-14);
  EXPECT_NEAR(now.slave[0], 20.8, 1e-12) << "8 u/s on for 0.1 s";
  EXPECT_NEAR(now.slave[1], 8, 1e-12);

  const Stepped back =
      step(coupling, engage(coupling, {}, {1, -4, 0, 0}, 0).engaged, {0.5, {-1, -4, 0, 0}});
  ASSERT_TRUE(back.released) << "also at its start";
  EXPECT_EQ(back.periods, -1);
  EXPECT_NEAR(back.slave[0], -2, 1e-12);
}

TEST(CouplingCycle, CamOutKeepsTheVelocity) {
  const Jet slave{10, 5, 3, 0};
  const Released hard = cam_out(slave, 1);
  EXPECT_EQ(point(hard, 3), (Jet{20, 5, 0, 0}));
  const Released soft = cam_out(slave, 1, 30);
  EXPECT_DOUBLE_EQ(point(soft, 1)[2], 3);
  const double end = soft.profile.duration();
  EXPECT_GT(end, 0.1);
  EXPECT_DOUBLE_EQ(point(soft, 1 + end)[1], 5);
  const Jet before = point(soft, 1 + end - 1e-9);
  const Jet after = point(soft, 1 + end + 1e-9);
  EXPECT_NEAR(after[0] - before[0], 1e-8, 1e-12);
  EXPECT_NEAR(point(soft, 1 + end + 2)[0] - point(soft, 1 + end)[0], 10, 1e-12);
}

TEST(CouplingCycle, OnceInSyncItStaysInSync) {
  const Coupling coupling(indexing(), {.start = StartMode::ramp_in_distance, .distance = 10});
  Engaged state = engage(coupling, {.position = 4}, {0, 1, 0, 0}, 0).engaged;
  Stepped now = step(coupling, state, {5, {5, 1, 0, 0}});
  EXPECT_FALSE(now.in_sync);
  now = step(coupling, now.engaged, {10, {10, 1, 0, 0}});
  EXPECT_TRUE(now.in_sync);
  now = step(coupling, now.engaged, {15, {5, -1, 0, 0}});
  EXPECT_TRUE(now.in_sync) << "the master came back";
  EXPECT_DOUBLE_EQ(now.slave[0], coupling.cam().jet(5)[0]);
}

TEST(CouplingCycle, AMasterThatReversesRunsTheSameCamBackwards) {
  const Coupling coupling(design(fig_6_14()).cam);
  Engaged state = engage(coupling, {}, {}, 0).engaged;
  const auto x = [](double t) { return 180 - 180 * std::cos(t); };
  for (int n = 1; n <= 6000; ++n) {
    const double t = n * 1e-3;
    const Jet master{x(t), 180 * std::sin(t), 180 * std::cos(t), -180 * std::sin(t)};
    const Stepped now = step(coupling, state, {t, master});
    state = now.engaged;
    EXPECT_NEAR(now.slave[0], coupling.cam().jet(std::min(x(t), 359.9999999))[0], 1e-5) << t;
  }
}

TEST(CouplingCycle, NoiseOfTheMasterCountsByTheSlope) {
  const Coupling coupling(design(fig_6_14()).cam);
  const double slope = std::abs(extrema(coupling.cam(), 1).peak().value);
  test::Random random(7);
  Engaged state = engage(coupling, {}, {0, 200, 0, 0}, 0).engaged;
  for (int n = 1; n <= 2000; ++n) {
    Sample now = steady(n * 1e-3, 200);
    const Jet clean = point(coupling, state, now.master, now.t);
    now.master[0] += random.uniform(-0.01, 0.01);
    const Stepped noisy = step(coupling, state, now);
    state = noisy.engaged;
    EXPECT_LE(std::abs(noisy.slave[0] - clean[0]), 0.01 * slope * (1 + 1e-9)) << now.t;
  }
}

TEST(CouplingCycle, AJumpOfTheMasterIsAnnouncedAndRampedIn) {
  CouplingSpec spec{.start = StartMode::ramp_in,
                    .velocity_diff = 100,
                    .acceleration = 1000,
                    .jerk = 50000,
                    .master_jump = 1};
  const Coupling ramps(indexing(), spec);
  const Jet at_speed{100, 200, 0, 0};
  const Jet on_cam = placed(ramps.cam(), ramps.placement(), at_speed);
  const Engaged state = engage(ramps, {on_cam[0], on_cam[1], on_cam[2]}, at_speed, 0).engaged;
  const Sample calm{0.001, {100.2, 200, 0, 0}};
  const Sample jump{0.001, {130.2, 200, 0, 0}};
  const Jet would = step(ramps, state, calm).slave;
  const Stepped now = step(ramps, state, jump);
  EXPECT_TRUE(now.jumped);
  EXPECT_FALSE(now.in_sync);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(now.slave[k], would[k], 1e-9) << k;
  const Jet later = point(ramps, now.engaged, {230, 200, 0, 0}, 9);
  EXPECT_DOUBLE_EQ(later[0], placed(ramps.cam(), ramps.placement(), {230, 200, 0, 0})[0]);

  spec.start = StartMode::absolute;
  const Coupling follows(indexing(), spec);
  const Stepped jumped = step(follows, engage(follows, {}, at_speed, 0).engaged, jump);
  EXPECT_TRUE(jumped.jumped);
  EXPECT_DOUBLE_EQ(jumped.slave[0], follows.cam().jet(130.2)[0]);
}

TEST(CouplingCycle, AMasterThatIsNoNumberLeavesTheSlaveWhereItIs) {
  const Coupling coupling(indexing());
  const Engaged state = engage(coupling, {}, {100, 1, 0, 0}, 0).engaged;
  const Stepped now =
      step(coupling, state, {1, {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0}});
  EXPECT_EQ(now.status, CouplingStatus::not_finite);
  EXPECT_EQ(now.slave[0], coupling.cam().jet(100)[0]);
  EXPECT_EQ(now.engaged.time, 0);
}

TEST(CouplingCycle, AJumpThatItsModeCannotTakeUpNeverMovesTheSlave) {
  // 20 m back or on in a cam y = x, at 200 u/s: one of the two is against each one-way mode.
  const Cam straight({line(360, 0, 360)}, 0, Extrapolation::wrap);
  for (const StartMode mode :
       {StartMode::ramp_in_pos, StartMode::ramp_in_neg, StartMode::ramp_in_distance})
    for (const double jump : {-20.0, 20.0})
      for (const double v : {200.0, 0.0})  // to a master that stands: no ramp over its distance
        for (const bool limits : {true, false}) {
          CouplingSpec spec{.start = mode, .distance = 50, .master_jump = 5};
          if (limits) spec.velocity_diff = 150;
          if (limits) spec.acceleration = 5000;
          if (!limits && mode != StartMode::ramp_in_distance) continue;
          const Coupling coupling(straight, spec);
          const Engaged state = engage(coupling, {100, 200, 0}, {100, 200, 0, 0}, 0).engaged;
          const Stepped now = step(coupling, state, {1e-3, {100.2 + jump, v, 0, 0}});
          const std::string which = std::string(name(mode)) + " " + std::to_string(jump) + " " +
                                    std::to_string(v) + (limits ? " limits" : "");
          EXPECT_TRUE(now.jumped) << which;
          EXPECT_NEAR(now.slave[0], 100.1 + 5e-4 * v, 1e-9) << which;
          const bool against = (mode == StartMode::ramp_in_pos && jump < 0) ||
                               (mode == StartMode::ramp_in_neg && jump > 0);
          if (against && v != 0) {
            EXPECT_EQ(now.status, CouplingStatus::would_reverse) << which;
          }
          EXPECT_FALSE(limits && now.released) << which;
          if (!now.released) {
            const Jet later = point(coupling, now.engaged, {200, 200, 0, 0}, 9);
            EXPECT_NEAR(later[0], 200, 1e-9) << which << ": back in step";
          }
        }
}

TEST(CouplingCycle, ASlaveThatNoCorrectionCanBringBackIsLetGo) {
  const Cam straight({line(360, 0, 360)}, 0, Extrapolation::advance);
  const Coupling coupling(
      straight,
      {.start = StartMode::ramp_in, .velocity_diff = 150, .acceleration = 5000, .master_jump = 5});
  const Engaged state = engage(coupling, {100, 200, 0}, {100, 200, 0, 0}, 0).engaged;
  const Stepped now = step(coupling, state, {1e-3, {1e60, 200, 0, 0}});
  EXPECT_EQ(now.status, CouplingStatus::no_ramp);
  ASSERT_TRUE(now.released);
  EXPECT_NEAR(now.slave[0], 100.2, 1e-12);
  EXPECT_NEAR(point(*now.released, 2e-3)[0], 100.4, 1e-12) << "at the speed that it had";
}

TEST(CouplingCycle, AMasterThatComesBackFromNoNumberHasJumped) {
  const Coupling coupling(
      indexing(),
      {.start = StartMode::ramp_in, .velocity_diff = 150, .acceleration = 5000, .master_jump = 5});
  const Jet on = placed(coupling.cam(), coupling.placement(), {100, 200, 0, 0});
  Engaged state = engage(coupling, {on[0], on[1], on[2]}, {100, 200, 0, 0}, 0).engaged;
  for (const double t : {0.001, 0.002}) {
    const Stepped gone = step(coupling, state, {t, {NAN, 200, 0, 0}});
    EXPECT_EQ(gone.slave, (Jet{on[0], 0, 0, 0})) << "it stands";
    state = gone.engaged;
  }
  const Stepped back = step(coupling, state, {0.003, {100.6, 200, 0, 0}});
  EXPECT_TRUE(back.jumped);
  EXPECT_EQ(back.status, CouplingStatus::ok);
  EXPECT_NEAR(back.slave[0], on[0], 1e-12) << "where it stood";
  EXPECT_NEAR(back.slave[1], 0, 1e-12);
  EXPECT_FALSE(step(coupling, back.engaged, {0.004, {100.8, 200, 0, 0}}).jumped) << "once";
}

TEST(Passing, IsExactForConstantAcceleration) {
  const auto master = [](double t) { return Sample{t, {3 * t + 2 * t * t, 3 + 4 * t, 4, 0}}; };
  const auto at = passing(master(0.2), master(0.3), 3 * 0.25 + 2 * 0.0625);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->t, 0.25, 1e-15);
  EXPECT_NEAR(at->master[1], 4, 1e-14);
  EXPECT_EQ(at->master[2], 4);
  EXPECT_FALSE(passing(master(0.2), master(0.3), 5));
  EXPECT_FALSE(passing(master(0.2), master(0.3), master(0.2).master[0])) << "it was there before";
  EXPECT_TRUE(passing(master(0.2), master(0.3), master(0.3).master[0]));
}

TEST(Trigger, ComesAtAPositionOrAPeriodsEnd) {
  using When = Trigger::When;
  const Coupling coupling(indexing());
  const auto at = [&](const Trigger& trigger, const Sample& before, const Sample& now) {
    return due(trigger, coupling.cam(), coupling.placement(), before, now).at;
  };
  const auto fast = [](double t) { return steady(t, 100); };
  EXPECT_EQ(at({}, fast(1), fast(1.1))->t, 1.1) << "now";
  EXPECT_NEAR(at({When::period_end}, fast(7), fast(7.4))->t, 7.2, 1e-14);
  EXPECT_FALSE(at({When::period_end}, fast(7), fast(7.1)));
  EXPECT_NEAR(at({When::master_position, 90}, fast(4.4), fast(4.6))->t, 4.5, 1e-14)
      << "in every period";
  EXPECT_TRUE(at({When::master_position, 90}, {0, {90, 0, 0, 0}}, {1, {90, 0, 0, 0}}))
      << "a master that stands there";

  const Trigger narrow{When::master_position, 90, 2};
  const Due missed = due(narrow, coupling.cam(), coupling.placement(), fast(0.8), fast(1));
  EXPECT_EQ(missed.status, CouplingStatus::window_missed);
  EXPECT_FALSE(missed.at);
  EXPECT_EQ(at(narrow, fast(0.87), fast(0.89))->t, 0.89);
}

TEST(Trigger, RejectsAPositionOrWindowThatIsNotInTheCam) {
  const auto key = [](const Trigger& trigger) -> std::string {
    return test::key_of([&] { require_valid(trigger, indexing(), "engage"); });
  };
  using When = Trigger::When;
  EXPECT_EQ(key({When::master_position, 360, 180}), "");
  EXPECT_EQ(key({When::master_position, 361, 0}), "engage_position");
  EXPECT_EQ(key({When::master_position, NAN, 0}), "engage_position");
  EXPECT_EQ(key({When::master_position, 0, -1}), "engage_window");
  EXPECT_EQ(key({When::master_position, 0, 181}), "engage_window");
}

TEST(Exchange, ConnectsARelativeCamExactlyAtThePeriodsEnd) {
  const Coupling first(indexing(), {.start = StartMode::relative});
  const Coupling second(indexing(),
                        {.slave_scaling = 2, .master_absolute = false, .slave_absolute = false});
  const Engaged state = engage(first, {}, {0, 100, 0, 0}, 0).engaged;
  const Trigger at_end{Trigger::When::period_end};
  const Due when = due(at_end, first.cam(), state.placement, steady(3.55, 100), steady(3.65, 100));
  ASSERT_TRUE(when.at);
  const Engagement in = exchange(first, state, second, *when.at);
  ASSERT_TRUE(in);
  EXPECT_NEAR(in.jump.velocity, 0, 1e-12);
  const Jet half = point(second, in.engaged, {540, 100, 0, 0}, 5.4);
  EXPECT_NEAR(half[0], 90 + 90, 1e-12) << "one step of 90, then half of one of 180";
}

TEST(Exchange, BeginsWhereTheSlaveHasComeToInEitherDirection) {
  // An open absolute cam from 5 to 95 on [-30, 330], exchanged at its seam for one that ramps.
  CamSpec rise;
  rise.start = {-30, 5, 0, 0};
  rise.segments = {{Law::quintic, {330, 95, 0, 0}, ""}};
  const Cam open = with(design(rise).cam, Extrapolation::wrap);
  const Coupling running(open, {.master_scaling = 0.3, .master_offset = 0.1});
  const Coupling next(open, {.start = StartMode::ramp_in, .velocity_diff = 9, .acceleration = 99});
  for (const double v : {200.0, -200.0})
    for (const int period : {0, 1, 1000}) {
      const double seam = ((v > 0 ? 330 : -30) + 360 * period - 0.1) / 0.3;
      const Sample before{0, {seam - 1e-3 * v, v, 0, 0}};
      const Sample now{2e-3, {seam + 1e-3 * v, v, 0, 0}};
      const Engaged state = engage(running, {}, before.master, 0).engaged;
      const Due when = due({Trigger::When::period_end}, open, state.placement, before, now);
      ASSERT_TRUE(when.at) << v << " " << period;
      const Engagement in = exchange(running, state, next, *when.at);
      ASSERT_TRUE(in);
      EXPECT_NEAR(point(next, in.engaged, when.at->master, when.at->t)[0], v > 0 ? 95 : 5, 1e-4)
          << v << " " << period;
    }
  // A master that stands on the seam keeps the slave where the last cycle put it.
  const Engaged stands = engage(running, {.position = 5}, {-30.1 / 0.3, 0, 0, 0}, 0).engaged;
  const Engagement in = exchange(running, stands, next, {1, {-30.1 / 0.3, 0, 0, 0}});
  EXPECT_DOUBLE_EQ(point(next, in.engaged, {-30.1 / 0.3, 0, 0, 0}, 1)[0], 5);
}

}  // namespace
}  // namespace jounce::coupling_cycle_test
