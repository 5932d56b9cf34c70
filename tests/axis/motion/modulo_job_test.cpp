// SPDX-License-Identifier: Apache-2.0
// A table over time on a modulo axis: it begins in the turn of the axis.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "axis/bench.hpp"
#include "axis/tables.hpp"

namespace jounce::modulo_job_test {
namespace {

using test::Bench;
using test::limits;
using test::refusal;

AxisConfig config_at(double position) {
  return {.limits = limits(100, 1000), .position = position, .modulo = 360};
}

std::shared_ptr<const Table> from_350_to_400() {
  return std::make_shared<const Table>(Domain::time, Interpolation::cubic_hermite,
                                       Extrapolation::hold,
                                       Columns{.x = {0, 2}, .p = {350, 400}, .v = {0, 0}, .a = {}});
}

TEST(ModuloJob, BeginsInTheTurnOfTheAxis) {
  for (const double turns : {-3.0, -1.0, 0.0, 1.0, 1e6}) {
    Bench axis(config_at(350 + 360 * turns));
    Job job(1, from_350_to_400(), nullptr, 1e-3, {.slave_period = 360});
    Tick now = axis.play(job);
    EXPECT_EQ(refusal(now), Cause::none) << turns;
    for (int i = 0; i < 2100; ++i) {
      const double s = std::min(static_cast<double>(i) * 1e-3 / 2, 1.0);
      EXPECT_NEAR(now.position, 350 + 360 * turns + 50 * s * s * (3 - 2 * s),
                  1e-9 + 1e-15 * std::abs(360 * turns));
      now = axis.step();
    }
    EXPECT_EQ(now.state, State::standstill);
    EXPECT_EQ(now.fault, Cause::none);
  }
}

/// From p to q and, with `back`, to p again, at rest at all of them, 1 s each.
std::shared_ptr<const Table> between(double p, double q, bool back) {
  Columns columns{.x = {0, 1}, .p = {p, q}, .v = {0, 0}, .a = {}};
  if (back) {
    columns.x.push_back(2);
    columns.p.push_back(p);
    columns.v.push_back(0);
  }
  return std::make_shared<const Table>(Domain::time, Interpolation::cubic_hermite,
                                       back ? Extrapolation::wrap : Extrapolation::hold,
                                       std::move(columns));
}

double smooth(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

// A table that began some turns away ends there, and the next table begins at this place, in other turns of its own:
// 400 deg is 40 deg in the next turn. The first table runs once, or is left at the end of its second pass.
TEST(ModuloJob, ASwapBeginsInTheTurnInWhichTheShiftedTableEnds) {
  for (const double turns : {-3.0, 0.0, 2.0, 1e6}) {
    for (const bool repeats : {false, true}) {
      const double off = 360 * turns;
      const double first_end = repeats ? 10 : 70;  // end of the first table, which begins at 10
      Bench axis(config_at(10 + off));
      Job first(1, between(10, 70, repeats), nullptr, 1e-3, {.slave_period = 360});
      Job second(2, between(first_end + 720, first_end + 780, false), nullptr, 1e-3,
                 {.slave_period = 360});
      axis.play(first, repeats ? 2500 : 500);
      ASSERT_EQ(refusal(axis.arm(second)), Cause::none) << turns;
      ASSERT_EQ(refusal(axis.step({command::Start{.when = StartAt::end_of_table}})), Cause::none);
      const std::int64_t joint = repeats ? 4000 : 1000;  // ticks since the start
      for (std::int64_t k = (repeats ? 2500 : 500) + 3; k < joint + 1500; ++k) {
        const Tick now = axis.step();
        const double t = static_cast<double>(k) * 1e-3;
        const double s = t - 2 * std::floor(t / 2);
        const double way = k >= joint
                               ? first_end + 60 * smooth(t - 1e-3 * static_cast<double>(joint))
                               : 10 + 60 * (s <= 1 ? smooth(s) : smooth(2 - s));
        ASSERT_NEAR(now.position, off + way, 1e-9 + 1e-15 * std::abs(off)) << k;
        ASSERT_EQ(now.fault, Cause::none) << k;
      }
      EXPECT_EQ(axis.step().state, State::standstill);
    }
  }
}

// A table that begins at another place in the turn does not meet the end of the shifted one.
TEST(ModuloJob, ASwapToAnotherPlaceInTheTurnIsRejected) {
  Bench axis(config_at(730));
  Job first(1, between(10, 70, false), nullptr, 1e-3, {.slave_period = 360});
  Job second(2, between(71, 80, false), nullptr, 1e-3, {.slave_period = 360});
  axis.play(first, 500);
  EXPECT_EQ(refusal(axis.arm(second)), Cause::start_position);
  EXPECT_EQ(axis.run(600).position, 790) << "the present table goes on to its end";
}

TEST(ModuloJob, AnotherPlaceInTheTurnIsRejected) {
  for (const double position : {0.0, 349.0, 350.001, -10.5}) {
    Bench axis(config_at(position));
    Job job(1, from_350_to_400(), nullptr, 1e-3, {.slave_period = 360});
    axis.send(CommandKind::enable);
    EXPECT_EQ(refusal(axis.arm(job)), Cause::start_position) << position;
  }
}

TEST(ModuloJob, ALinearAxisHasNoTurns) {
  Bench axis({.limits = limits(100, 1000), .position = -10});
  Job job(1, from_350_to_400());
  axis.send(CommandKind::enable);
  EXPECT_EQ(refusal(axis.arm(job)), Cause::start_position);
}

}  // namespace
}  // namespace jounce::modulo_job_test
