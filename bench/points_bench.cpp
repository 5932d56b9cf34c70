// SPDX-License-Identifier: Apache-2.0
// CSV points: bytes a second, beside std::from_chars over the same cells.
#include <charconv>
#include <cmath>
#include <string>

#include <benchmark/benchmark.h>

#include "jounce/io/points.hpp"

namespace {

/// Time, position, velocity, acceleration with this many decimals.
std::string text(int decimals) {
  std::string all = "time [s],position [mm],velocity [mm/s],acceleration [mm/s^2]\n";
  char cell[64];
  for (int i = 0; i < 200'000; ++i) {
    const double t = 1e-3 * i;
    for (const double value : {t, 50 * std::sin(t), 50 * std::cos(t), -50 * std::sin(t)}) {
      const auto end = decimals > 0 ? std::to_chars(cell, cell + sizeof cell, value,
                                                    std::chars_format::fixed, decimals)
                                    : std::to_chars(cell, cell + sizeof cell, value);
      all.append(cell, end.ptr);
      all += ',';
    }
    all.back() = '\n';
  }
  return all;
}

void points(benchmark::State& state) {
  const std::string csv = text(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(jounce::parse_points(csv, "bench"));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(csv.size()));
}
BENCHMARK(points)
    ->ArgName("decimals")
    ->Arg(0)
    ->Arg(3)
    ->Arg(6)
    ->Arg(9)
    ->Unit(benchmark::kMillisecond);

void from_chars_alone(benchmark::State& state) {
  const std::string csv = text(static_cast<int>(state.range(0)));
  const char* const end = csv.data() + csv.size();
  for (auto _ : state) {
    double sum = 0;
    for (const char* at = csv.data() + csv.find('\n') + 1; at < end;) {
      double value = 0;
      at = std::from_chars(at, end, value).ptr + 1;
      sum += value;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(csv.size()));
}
BENCHMARK(from_chars_alone)
    ->ArgName("decimals")
    ->Arg(0)
    ->Arg(3)
    ->Arg(6)
    ->Arg(9)
    ->Unit(benchmark::kMillisecond);

}  // namespace
