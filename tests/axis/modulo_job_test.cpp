// SPDX-License-Identifier: Apache-2.0
// A table over time on a modulo axis: it begins in the turn of the axis.
#include <cmath>
#include <memory>

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
