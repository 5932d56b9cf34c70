// SPDX-License-Identifier: Apache-2.0
// What a cam costs at random master positions, and what it costs to certify one, beside its peers in
// the same run. Boost is Debian's libboost-dev, GSL its libgsl-dev; each is measured where it is found.
//   build/release/bench/bench_cam --benchmark_repetitions=9 --benchmark_report_aggregates_only
// 65536 positions, so that no branch predictor learns them; value, velocity and acceleration each
// (Jounce gives the jerk as well). Results: docs/performance.md.
#include <cstdint>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/table.hpp"

#ifdef JOUNCE_BENCH_BOOST
#include <boost/math/interpolators/quintic_hermite.hpp>
#endif
#ifdef JOUNCE_BENCH_GSL
#include <gsl/gsl_spline.h>
#endif

namespace {

using namespace jounce;
using State = benchmark::State;

constexpr double turn = 360;
constexpr std::size_t queries = 65536;  // a power of two

enum Order { ascending, random_order };
enum Spacing { equal, irregular };

/// n quintic pieces over one turn between random values; irregular ones differ in length up to 1:9.
Columns knots(std::size_t n, Spacing spacing) {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> value(-1, 1);
  std::uniform_real_distribution<double> length(0.2, spacing == equal ? 0.2 : 1.8);
  Columns columns;
  double x = 0;
  for (std::size_t i = 0; i <= n; ++i, x += length(engine)) {
    columns.x.push_back(x);
    for (auto* column : {&columns.p, &columns.v, &columns.a}) column->push_back(value(engine));
  }
  const double interval = turn / columns.x.back();
  for (std::size_t i = 0; i <= n; ++i)
    columns.x[i] = spacing == equal ? turn * static_cast<double>(i) / static_cast<double>(n)
                                    : columns.x[i] * interval;
  columns.x.back() = turn;
  return columns;
}

Table table(std::size_t n, Spacing spacing, Extrapolation outside = Extrapolation::wrap) {
  return {Domain::master, Interpolation::quintic_hermite, outside, knots(n, spacing)};
}

std::vector<double> positions(Order order, double from = 0, double to = turn) {
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> anywhere(from, to);
  std::vector<double> x(queries);
  for (std::size_t i = 0; i < queries; ++i)
    x[i] = order == random_order
               ? anywhere(engine)
               : from + (to - from) * static_cast<double>(i) / static_cast<double>(queries);
  return x;
}

template <class Evaluate>
void at_each(State& state, const std::vector<double>& x, Evaluate evaluate) {
  std::size_t i = 0;
  for (auto _ : state) {
    auto value = evaluate(x[i++ & (queries - 1)]);
    benchmark::DoNotOptimize(value);
  }
}

// ---- evaluation ---------------------------------------------------------------------------------

void cam(State& state, std::size_t n, Spacing spacing, Order order) {
  const Cam f = table(n, spacing).curve<OverMaster>();
  at_each(state, positions(order), [&](double x) { return f.at(x); });
}
BENCHMARK_CAPTURE(cam, 360_ascending, 360, irregular, ascending);
BENCHMARK_CAPTURE(cam, 360_random, 360, irregular, random_order);
BENCHMARK_CAPTURE(cam, 360_random_equal, 360, equal, random_order);
BENCHMARK_CAPTURE(cam, 12_random, 12, irregular, random_order);

void cam_over_many_turns(State& state) {
  const Cam f = table(360, irregular).curve<OverMaster>();
  at_each(state, positions(random_order, -1e6, 1e6), [&](double x) { return f.at(x); });
}
BENCHMARK(cam_over_many_turns);

void cam_in_a_block(State& state, Order order) {
  const Cam f = table(360, irregular).curve<OverMaster>();
  const auto x = positions(order);
  std::vector<Transfer> out(queries);
  for (auto _ : state) {
    f.sample(x, out);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(queries));
}
BENCHMARK_CAPTURE(cam_in_a_block, ascending, ascending)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(cam_in_a_block, random, random_order)->Unit(benchmark::kMicrosecond);

void table_at(State& state, std::size_t n, Order order) {
  const Table f = table(n, irregular);
  at_each(state, positions(order), [&](double x) { return f.jet(x); });
}
BENCHMARK_CAPTURE(table_at, 360_ascending, 360, ascending);
BENCHMARK_CAPTURE(table_at, 360_random, 360, random_order);
BENCHMARK_CAPTURE(table_at, 1000000_random, 1'000'000, random_order);

#ifdef JOUNCE_BENCH_BOOST
void boost_quintic_hermite(State& state, std::size_t n, Spacing spacing, Order order) {
  auto [x, p, v, a] = knots(n, spacing);
  const boost::math::interpolators::quintic_hermite<std::vector<double>> f(
      std::move(x), std::move(p), std::move(v), std::move(a));
  at_each(state, positions(order), [&](double at) {
    return std::array{f(at), f.prime(at), f.double_prime(at)};
  });
}
BENCHMARK_CAPTURE(boost_quintic_hermite, 360_ascending, 360, irregular, ascending);
BENCHMARK_CAPTURE(boost_quintic_hermite, 360_random, 360, irregular, random_order);
BENCHMARK_CAPTURE(boost_quintic_hermite, 1000000_random, 1'000'000, irregular, random_order);

void boost_cardinal_quintic_hermite(State& state) {
  auto [x, p, v, a] = knots(360, equal);
  const boost::math::interpolators::cardinal_quintic_hermite<std::vector<double>> f(
      std::move(p), std::move(v), std::move(a), 0.0, 1.0);
  at_each(state, positions(random_order), [&](double at) {
    return std::array{f(at), f.prime(at), f.double_prime(at)};
  });
}
BENCHMARK(boost_cardinal_quintic_hermite);
#endif

#ifdef JOUNCE_BENCH_GSL
/// A cubic spline: GSL has no interpolation of degree 5.
void gsl_cubic_spline(State& state, std::size_t n, Order order) {
  const Columns columns = knots(n, irregular);
  gsl_spline* f = gsl_spline_alloc(gsl_interp_cspline, n + 1);
  gsl_interp_accel* near = gsl_interp_accel_alloc();
  gsl_spline_init(f, columns.x.data(), columns.p.data(), n + 1);
  at_each(state, positions(order), [&](double x) {
    return std::array{gsl_spline_eval(f, x, near), gsl_spline_eval_deriv(f, x, near),
                      gsl_spline_eval_deriv2(f, x, near)};
  });
  gsl_interp_accel_free(near);
  gsl_spline_free(f);
}
BENCHMARK_CAPTURE(gsl_cubic_spline, 360_ascending, 360, ascending);
BENCHMARK_CAPTURE(gsl_cubic_spline, 360_random, 360, random_order);
BENCHMARK_CAPTURE(gsl_cubic_spline, 1000000_random, 1'000'000, random_order);
#endif

// ---- building and certifying --------------------------------------------------------------------

/// A spec of n quintic segments that swings up and down from rest to rest, or between any values.
CamSpec swinging(std::size_t n, bool at_rest) {
  const Columns columns = knots(n, irregular);
  CamSpec spec;
  for (std::size_t i = 1; i <= n; ++i) {
    CamSegment segment;
    segment.law = Law::quintic;
    segment.end.master = columns.x[i];
    segment.end.slave = at_rest ? (i % 2 == 0 ? 0 : 2 + columns.p[i]) : columns.p[i];
    if (!at_rest) segment.end.geo_velocity = columns.v[i];
    if (!at_rest) segment.end.geo_acceleration = columns.a[i];
    spec.segments.push_back(segment);
  }
  return spec;
}

constexpr Limits limits{.velocity = 1000, .acceleration = 1e5};

void build(State& state) {
  const CamSpec spec = swinging(1000, true);
  for (auto _ : state) benchmark::DoNotOptimize(design(spec));
}
BENCHMARK(build)->Unit(benchmark::kMillisecond);

/// Every extremum of all four orders, and the report on two limits.
void build_and_certify(State& state, bool at_rest) {
  const CamSpec spec = swinging(1000, at_rest);
  for (auto _ : state) {
    const Cam f = design(spec).cam;
    benchmark::DoNotOptimize(extrema(f));
    benchmark::DoNotOptimize(check(f, limits));
  }
}
BENCHMARK_CAPTURE(build_and_certify, rest_to_rest, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_and_certify, any_values, false)->Unit(benchmark::kMillisecond);

void build_and_check(State& state, bool at_rest) {
  const CamSpec spec = swinging(1000, at_rest);
  for (auto _ : state) benchmark::DoNotOptimize(check(design(spec).cam, limits));
}
BENCHMARK_CAPTURE(build_and_check, rest_to_rest, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_and_check, any_values, false)->Unit(benchmark::kMillisecond);

#ifdef JOUNCE_BENCH_BOOST
/// Nothing is certified: Boost has no extrema.
void boost_build(State& state) {
  const Columns columns = knots(1000, irregular);
  for (auto _ : state) {
    auto [x, p, v, a] = columns;
    const boost::math::interpolators::quintic_hermite<std::vector<double>> f(
        std::move(x), std::move(p), std::move(v), std::move(a));
    benchmark::DoNotOptimize(f(1));
  }
}
BENCHMARK(boost_build)->Unit(benchmark::kMillisecond);
#endif

}  // namespace
