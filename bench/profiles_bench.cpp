// SPDX-License-Identifier: Apache-2.0
// What time generators cost, beside their peers in the same run. KDL is Debian's liborocos-kdl;
// Ruckig is measured where find_package finds one.
//   build/release/bench/bench_profiles --benchmark_repetitions=9 --benchmark_report_aggregates_only
// One call a case, over 8192 cases; `p99` is of single calls, the least of five each, less what
// reading the clock takes. Results: docs/performance.md.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/moves/batch.hpp"
#include "jounce/profiles/moves/fourth_order.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/synchronize.hpp"

#ifdef JOUNCE_BENCH_KDL
#include <kdl/velocityprofile_trap.hpp>
#endif
#ifdef JOUNCE_BENCH_RUCKIG
#include <ruckig/ruckig.hpp>
#endif
#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace {

using namespace jounce;

constexpr std::size_t cases = 8192;

/// One axis of a case; limits are the same in both directions.
struct Axis {
  MotionState from, to;
  double velocity, acceleration, jerk;
};

/// The distributions of Ruckig's own benchmark (its test/benchmark_target.cpp).
class Source {
 public:
  Axis general() {
    Axis x;
    x.from = {position(p_), sometimes(0.9), sometimes(0.8)};
    do {
      x.to = {position(p_), sometimes(0.7), sometimes(0.6)};
      x.velocity = limit_(l_) + std::abs(x.to.velocity);
      x.acceleration = limit_(l_) + std::abs(x.to.acceleration);
      x.jerk = limit_(l_);
    } while (std::abs(x.to.velocity) + x.to.acceleration * x.to.acceleration / (2 * x.jerk) >
             x.velocity);
    return x;
  }
  Axis moving() {
    Axis x = general();
    x.from.acceleration = x.to.acceleration = 0;
    x.velocity = std::max(x.velocity, std::abs(x.from.velocity));
    return x;
  }
  Axis stepping() {  // for the second order
    Axis x = general();
    x.from.acceleration = x.to.acceleration = 0;
    return x;
  }
  Axis resting() {
    const Axis x = general();
    return {{x.from.position}, {x.to.position}, x.velocity, x.acceleration, x.jerk};
  }

 private:
  double position(std::default_random_engine& g) { return position_(g); }
  double sometimes(double share) { return share_(d_) < share ? dynamic_(d_) : 0.0; }

  std::default_random_engine p_{42}, d_{43}, l_{44};
  std::normal_distribution<double> position_{0, 4};
  std::normal_distribution<double> dynamic_{0, 0.8};
  std::uniform_real_distribution<double> limit_{0.1, 12}, share_{0, 1};
};

template <std::size_t Axes>
using Cases = std::vector<std::array<Axis, Axes>>;

template <std::size_t Axes>
Cases<Axes> make(Axis (Source::*kind)()) {
  Source source;
  Cases<Axes> all(cases);
  for (auto& one : all)
    for (Axis& axis : one) axis = (source.*kind)();
  return all;
}

double now() {  // ns
#if defined(__x86_64__)
  static const double per_tick = [] {
    const auto t0 = std::chrono::steady_clock::now();
    const auto c0 = __rdtsc();
    while (std::chrono::steady_clock::now() - t0 < std::chrono::milliseconds(50)) continue;
    return 5e7 / static_cast<double>(__rdtsc() - c0);
  }();
  _mm_lfence();
  return static_cast<double>(__rdtsc()) * per_tick;
#else
  return std::chrono::duration<double, std::nano>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
#endif
}

template <class Call>
double least_of_five(const Call& call) {
  double least = 1e300;
  for (int i = 0; i < 5; ++i) {
    const double t0 = now();
    call();
    least = std::min(least, now() - t0);
  }
  return least;
}

/// Runs `solve(case)` over all cases: the mean as the benchmark's time, the p99 as a counter.
template <class AllCases, class Solve>
void measure(benchmark::State& state, const AllCases& all, Solve solve) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve(all[i++ & (cases - 1)]));
  }
  std::vector<double> each;
  const double clock = least_of_five([] {});
  for (const auto& one : all)
    each.push_back(least_of_five([&] { benchmark::DoNotOptimize(solve(one)); }) - clock);
  std::nth_element(each.begin(), each.begin() + cases * 99 / 100, each.end());
  state.counters["p99"] = each[cases * 99 / 100];
}

#ifdef JOUNCE_BENCH_RUCKIG
template <std::size_t Axes>
void ruckig_solves(benchmark::State& state, const Cases<Axes>& all, bool jerk = true,
                   ruckig::Synchronization sync = ruckig::Synchronization::Time) {
  std::vector<ruckig::InputParameter<Axes>> inputs(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < Axes; ++k) {
      auto& in = inputs[i];
      in.synchronization = sync;
      const Axis& x = all[i][k];
      in.current_position[k] = x.from.position;
      in.current_velocity[k] = x.from.velocity;
      in.current_acceleration[k] = x.from.acceleration;
      in.target_position[k] = x.to.position;
      in.target_velocity[k] = x.to.velocity;
      in.target_acceleration[k] = x.to.acceleration;
      in.max_velocity[k] = x.velocity;
      in.max_acceleration[k] = x.acceleration;
      if (jerk) in.max_jerk[k] = x.jerk;
    }
  ruckig::Ruckig<Axes> solver;
  ruckig::Trajectory<Axes> trajectory;
  measure(state, inputs, [&](const auto& in) {
    solver.calculate(in, trajectory);
    return trajectory.get_duration();
  });
}
void general_ruckig(benchmark::State& s) {
  ruckig_solves<1>(s, make<1>(&Source::general));
}
void moving_ruckig(benchmark::State& s) {
  ruckig_solves<1>(s, make<1>(&Source::moving));
}
void resting_ruckig(benchmark::State& s) {
  ruckig_solves<1>(s, make<1>(&Source::resting));
}
void trapezoid_ruckig(benchmark::State& s) {
  ruckig_solves<1>(s, make<1>(&Source::resting), false);
}
void second_order_ruckig(benchmark::State& s) {
  ruckig_solves<1>(s, make<1>(&Source::stepping), false);
}
void resting_3_ruckig(benchmark::State& s) {
  ruckig_solves<3>(s, make<3>(&Source::resting));
}
void resting_7_ruckig(benchmark::State& s) {
  ruckig_solves<7>(s, make<7>(&Source::resting));
}
void each_3_ruckig(benchmark::State& s) {
  ruckig_solves<3>(s, make<3>(&Source::general), true, ruckig::Synchronization::None);
}
void synchronized_3_ruckig(benchmark::State& s) {
  ruckig_solves<3>(s, make<3>(&Source::general));
}
void synchronized_7_ruckig(benchmark::State& s) {
  ruckig_solves<7>(s, make<7>(&Source::general));
}
BENCHMARK(general_ruckig);
BENCHMARK(moving_ruckig);
BENCHMARK(resting_ruckig);
BENCHMARK(trapezoid_ruckig);
BENCHMARK(second_order_ruckig);
BENCHMARK(resting_3_ruckig);
BENCHMARK(resting_7_ruckig);
BENCHMARK(each_3_ruckig);
BENCHMARK(synchronized_3_ruckig);
BENCHMARK(synchronized_7_ruckig);
#endif

Bounds bounds(const Axis& x) {
  return within(x.velocity, x.acceleration, x.jerk);
}
void moves(benchmark::State& state, const Cases<1>& all) {
  measure(state, all, [](const auto& c) { return move_to(c[0].from, c[0].to, bounds(c[0])); });
}
void general_jounce(benchmark::State& s) {
  moves(s, make<1>(&Source::general));
}
void moving_jounce(benchmark::State& s) {
  moves(s, make<1>(&Source::moving));
}
void resting_jounce(benchmark::State& s) {
  moves(s, make<1>(&Source::resting));
}
void second_order_jounce(benchmark::State& s) {
  measure(s, make<1>(&Source::stepping), [](const auto& c) {
    return move_to(c[0].from, c[0].to, within(c[0].velocity, c[0].acceleration));
  });
}
BENCHMARK(second_order_jounce);
BENCHMARK(general_jounce);
BENCHMARK(moving_jounce);
BENCHMARK(resting_jounce);

template <std::size_t Axes>
void synchronized(benchmark::State& state, Axis (Source::*kind)(), Sync sync = Sync::time) {
  std::vector<std::array<AxisMove, Axes>> all;
  for (const auto& one : make<Axes>(kind)) {
    auto& axes = all.emplace_back();
    for (std::size_t k = 0; k < Axes; ++k) axes[k] = {one[k].from, one[k].to, bounds(one[k])};
  }
  std::array<Profile, Axes> out;
  measure(state, all, [&](const auto& axes) { return synchronize(axes, sync, out); });
}
void synchronized_3_jounce(benchmark::State& s) {
  synchronized<3>(s, &Source::general);
}
void synchronized_7_jounce(benchmark::State& s) {
  synchronized<7>(s, &Source::general);
}
void resting_3_jounce(benchmark::State& s) {
  synchronized<3>(s, &Source::resting);
}
void resting_7_jounce(benchmark::State& s) {
  synchronized<7>(s, &Source::resting);
}
void each_3_jounce(benchmark::State& s) {
  synchronized<3>(s, &Source::general, Sync::none);
}
BENCHMARK(resting_3_jounce);
BENCHMARK(resting_7_jounce);
BENCHMARK(each_3_jounce);
BENCHMARK(synchronized_3_jounce);
BENCHMARK(synchronized_7_jounce);

/// The time of one move out of many at once.
void batch(benchmark::State& state, const Cases<1>& all, bool moving) {
  std::array<std::vector<double>, 6> columns;
  for (const auto& [x] : all) {
    columns[0].push_back(x.to.position - x.from.position);
    columns[1].push_back(x.from.velocity);
    columns[2].push_back(x.to.velocity);
    columns[3].push_back(x.velocity);
    columns[4].push_back(x.acceleration);
    columns[5].push_back(x.jerk);
  }
  const auto& [way, entry, exit, velocity, acceleration, jerk] = columns;
  MoveColumns all_moves{way, entry, exit, velocity, acceleration, jerk};
  if (!moving) all_moves.entry = all_moves.exit = {};
  std::vector<double> durations(all.size());
  const auto n = static_cast<benchmark::IterationCount>(all.size());
  while (state.KeepRunningBatch(n)) {
    minimum_durations(all_moves, durations);
    benchmark::DoNotOptimize(durations.data());
  }
}
void moving_batch(benchmark::State& s) {
  batch(s, make<1>(&Source::moving), true);
}
void resting_batch(benchmark::State& s) {
  batch(s, make<1>(&Source::resting), false);
}
BENCHMARK(moving_batch);
BENCHMARK(resting_batch);

void fourth_order_jounce(benchmark::State& state) {
  measure(state, make<1>(&Source::resting), [](const auto& c) {
    return fourth_order({.from = c[0].from.position,
                         .to = c[0].to.position,
                         .velocity = c[0].velocity,
                         .acceleration = c[0].acceleration,
                         .jerk = c[0].jerk,
                         .jounce = 10 * c[0].jerk});
  });
}
BENCHMARK(fourth_order_jounce);

#ifdef JOUNCE_BENCH_KDL
void trapezoid_kdl(benchmark::State& state) {
  measure(state, make<1>(&Source::resting), [](const auto& c) {
    KDL::VelocityProfile_Trap profile(c[0].velocity, c[0].acceleration);
    profile.SetProfile(c[0].from.position, c[0].to.position);
    return profile.Duration();
  });
}
BENCHMARK(trapezoid_kdl);
#endif

void trapezoid_jounce(benchmark::State& state) {
  measure(state, make<1>(&Source::resting), [](const auto& c) {
    return trapezoid({.from = c[0].from.position,
                      .to = c[0].to.position,
                      .velocity = c[0].velocity,
                      .acceleration = c[0].acceleration});
  });
}
BENCHMARK(trapezoid_jounce);

void resting_s_curve(benchmark::State& state) {
  measure(state, make<1>(&Source::resting), [](const auto& c) {
    return s_curve({.from = c[0].from.position,
                    .to = c[0].to.position,
                    .velocity = c[0].velocity,
                    .acceleration = c[0].acceleration,
                    .jerk = c[0].jerk});
  });
}
BENCHMARK(resting_s_curve);

/// A span of its own for the queries, whose ends do not run backwards.
struct Query {
  double distance;
  SpanEnds ends;
  Ramp ramp;
};
std::vector<Query> queries() {
  std::vector<Query> all;
  for (const auto& [x] : make<1>(&Source::moving)) {
    const Ramp ramp{x.acceleration, x.jerk};
    const SpanEnds ends{std::abs(x.from.velocity), std::abs(x.to.velocity), x.velocity};
    const double direct = ramp_between(ends.entry, ends.exit, ramp)->distance;
    all.push_back({std::abs(x.to.position - x.from.position) + direct, ends, ramp});
  }
  return all;
}
void query_stopping(benchmark::State& state) {
  measure(state, queries(), [](const Query& q) { return stopping({q.ends.entry}, q.ramp); });
}
void query_entry_velocity(benchmark::State& state) {
  measure(state, queries(),
          [](const Query& q) { return entry_velocity(q.distance, q.ends.exit, q.ramp); });
}
void query_peak_velocity(benchmark::State& state) {
  measure(state, queries(), [](const Query& q) {
    return peak_velocity(q.distance, {q.ends.entry, q.ends.exit}, q.ramp);
  });
}
void query_minimum_duration(benchmark::State& state) {
  measure(state, queries(),
          [](const Query& q) { return minimum_duration(q.distance, q.ends, q.ramp); });
}
void query_minimum_duration_resting(benchmark::State& state) {
  measure(state, queries(), [](const Query& q) {
    return minimum_duration(q.distance, {.velocity = q.ends.velocity}, q.ramp);
  });
}
BENCHMARK(query_stopping);
BENCHMARK(query_entry_velocity);
BENCHMARK(query_peak_velocity);
BENCHMARK(query_minimum_duration);
BENCHMARK(query_minimum_duration_resting);

}  // namespace
