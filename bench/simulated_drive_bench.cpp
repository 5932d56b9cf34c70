// SPDX-License-Identifier: Apache-2.0
// What a cycle costs besides the axis itself.
#include <cmath>

#include <benchmark/benchmark.h>

#include "jounce/validate/drive_stepper.hpp"

namespace jounce {
namespace {

void step(benchmark::State& state, const Drive& drive, double reach) {
  DriveStepper stepper(drive, 0.001);
  double t = 0;
  for (auto _ : state) {
    t += 0.001;
    const double w = 20;
    benchmark::DoNotOptimize(stepper.step({reach * std::sin(w * t), reach * w * std::cos(w * t),
                                           -reach * w * w * std::sin(w * t), 0}));
  }
}

void BM_simulated_drive(benchmark::State& state) {
  step(state, servo_400w(), 100);
}
BENCHMARK(BM_simulated_drive);

void BM_simulated_drive_saturated(benchmark::State& state) {
  Drive drive = servo_400w();
  drive.motor.torque_limit = 0.05;
  step(state, drive, 100);
}
BENCHMARK(BM_simulated_drive_saturated);

void BM_simulated_drive_sampled(benchmark::State& state) {
  Drive drive = servo_400w();
  drive.controller.cycle = 1e-3 / static_cast<double>(state.range(0));
  step(state, drive, 100);
}
BENCHMARK(BM_simulated_drive_sampled)->Arg(1)->Arg(4)->Arg(16);

}  // namespace
}  // namespace jounce
