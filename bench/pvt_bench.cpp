// SPDX-License-Identifier: Apache-2.0
// What a table costs: in blocks, query by query, checked and built, beside GSL and Boost in the same run
// (Debian's libgsl-dev and libboost-dev; each is measured where it is found).
//   build/release/bench/bench_pvt --benchmark_repetitions=11 --benchmark_report_aggregates_only=true
// Position, velocity and acceleration each (a single query of Jounce's gives the third derivative
// as well). Results: docs/performance.md, "Tables".
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "jounce/profiles/detail/lanes.hpp"
#include "jounce/pvt/check.hpp"
#include "jounce/pvt/cursor.hpp"
#include "jounce/pvt/table.hpp"

#include "pvt/src/table/sample_kernel.hpp"

#ifdef JOUNCE_BENCH_BOOST
#include <boost/math/interpolators/cubic_hermite.hpp>
#include <boost/math/interpolators/quintic_hermite.hpp>
#endif
#ifdef JOUNCE_BENCH_GSL
#include <gsl/gsl_spline.h>
#endif

namespace {

using namespace jounce;
using State = benchmark::State;

enum Order { ascending, random_order };

/// n intervals that differ in length up to 1:9, between random values; v and a as the rule needs.
const Columns& knots(std::size_t n, Interpolation rule) {
  static std::map<std::pair<std::size_t, Interpolation>, Columns> all;
  Columns& columns = all[{n, rule}];
  if (!columns.x.empty()) return columns;
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> value(-1, 1);
  std::uniform_real_distribution<double> length(0.2, 1.8);
  double x = 0;
  for (std::size_t i = 0; i <= n; ++i, x += length(engine)) {
    columns.x.push_back(x);
    columns.p.push_back(value(engine));
    if (rule != Interpolation::linear) columns.v.push_back(value(engine));
    if (rule == Interpolation::quintic_hermite) columns.a.push_back(value(engine));
  }
  return columns;
}

Table table(std::size_t n, Interpolation rule) {
  return {Domain::time, rule, Extrapolation::hold, knots(n, rule)};
}

std::vector<double> positions(const Columns& columns, std::size_t n, Order order) {
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> anywhere(0, columns.x.back());
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i)
    x[i] = order == random_order
               ? anywhere(engine)
               : columns.x.back() * static_cast<double>(i) / static_cast<double>(n);
  return x;
}

// ---- in blocks -------------------------------------------------------------------------------------
// 64 samples an interval on average. Three columns of 960 stay in the first cache, of 16000 in the second;
// no powers of two, so that the columns do not fall on the same places of a cache.

struct Results {
  std::vector<double> p, v, a;
  explicit Results(std::size_t n) : p(n), v(n), a(n) {}
  [[nodiscard]] pvt_detail::Samples columns() { return {p.data(), v.data(), a.data()}; }
};

void count(State& state, std::size_t n) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

// The limit: the three columns filled by the widest stores that the processor has, without computing.
#ifdef __x86_64__
__attribute__((noinline, target("avx2"))) void fill_256(double* to, std::size_t n, double x) {
  for (const profiles_detail::Vector4 value{x, x, x, x}; n >= 4; n -= 4, to += 4)
    __builtin_memcpy(to, &value, sizeof value);
}
__attribute__((noinline, target("avx512f"))) void fill_512(double* to, std::size_t n, double x) {
  for (const profiles_detail::Vector8 value{x, x, x, x, x, x, x, x}; n >= 8; n -= 8, to += 8)
    __builtin_memcpy(to, &value, sizeof value);
}
#endif
__attribute__((noinline)) void fill_128(double* to, std::size_t n, double x) {
  for (const profiles_detail::Vector2 value{x, x}; n >= 2; n -= 2, to += 2)
    __builtin_memcpy(to, &value, sizeof value);
}

auto widest_fill() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f")) return fill_512;
  if (__builtin_cpu_supports("avx2")) return fill_256;
#endif
  return fill_128;
}

void stores(State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  Results out(n);
  const auto fill = widest_fill();
  double x = 1;
  for (auto _ : state) {
    for (auto* column : {&out.p, &out.v, &out.a}) fill(column->data(), n, x);
    benchmark::ClobberMemory();
  }
  count(state, n);
}
BENCHMARK(stores)->Arg(960)->Arg(16000)->Arg(4000000);

void block(State& state, Interpolation rule) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const Table f = table(n / 64, rule);
  const auto x = positions(f.columns(), n, ascending);
  Results out(n);
  for (auto _ : state) {
    f.sample(x, out.p, out.v, out.a);
    benchmark::ClobberMemory();
  }
  count(state, n);
}
BENCHMARK_CAPTURE(block, linear, Interpolation::linear)->Arg(16000);
BENCHMARK_CAPTURE(block, cubic, Interpolation::cubic_hermite)->Arg(960)->Arg(16000)->Arg(4000000);
BENCHMARK_CAPTURE(block, quintic, Interpolation::quintic_hermite)->Arg(960)->Arg(16000);

void grid(State& state, Interpolation rule) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const Table f = table(n / 64, rule);
  const Grid at{0, f.end() / static_cast<double>(n)};
  Results out(n);
  for (auto _ : state) {
    f.sample(at, out.p, out.v, out.a);
    benchmark::ClobberMemory();
  }
  count(state, n);
}
BENCHMARK_CAPTURE(grid, linear, Interpolation::linear)->Arg(16000);
BENCHMARK_CAPTURE(grid, cubic, Interpolation::cubic_hermite)->Arg(960)->Arg(16000)->Arg(4000000);
BENCHMARK_CAPTURE(grid, quintic, Interpolation::quintic_hermite)->Arg(960)->Arg(16000);

void kernel(State& state, const pvt_detail::SampleKernels& kernels, bool supported = true) {
  if (!supported) return state.SkipWithError("the processor does not have these vectors");
  const std::size_t n = 16000;
  const Table f = table(n / 64, Interpolation::cubic_hermite);
  Results out(n);
  for (auto _ : state) {
    kernels.uniform(pvt_detail::knots_of(f.columns()), f.rule(), {0, f.end() / n}, 0, n,
                    out.columns());
    benchmark::ClobberMemory();
  }
  count(state, n);
}
BENCHMARK_CAPTURE(kernel, anywhere, pvt_detail::sample_anywhere);
#ifdef __x86_64__
BENCHMARK_CAPTURE(kernel, avx2, pvt_detail::sample_avx2, __builtin_cpu_supports("avx2"));
BENCHMARK_CAPTURE(kernel, avx512, pvt_detail::sample_avx512, __builtin_cpu_supports("avx512f"));
#endif

// ---- query by query ------------------------------------------------------------------------------

constexpr std::size_t queries = 65536;  // a power of two: no branch predictor learns them

template <class Evaluate>
void at_each(State& state, const std::vector<double>& x, Evaluate evaluate) {
  std::size_t i = 0;
  for (auto _ : state) {
    auto value = evaluate(x[i++ & (queries - 1)]);
    benchmark::DoNotOptimize(value);
  }
}

void single(State& state, Interpolation rule, Order order) {
  const Table f = table(static_cast<std::size_t>(state.range(0)), rule);
  at_each(state, positions(f.columns(), queries, order), [&](double x) { return f.jet(x); });
}
BENCHMARK_CAPTURE(single, cubic_ascending, Interpolation::cubic_hermite, ascending)
    ->Arg(1000)
    ->Arg(1'000'000);
BENCHMARK_CAPTURE(single, cubic_random, Interpolation::cubic_hermite, random_order)
    ->Arg(1000)
    ->Arg(1'000'000);
BENCHMARK_CAPTURE(single, quintic_ascending, Interpolation::quintic_hermite, ascending)->Arg(1000);
BENCHMARK_CAPTURE(single, quintic_random, Interpolation::quintic_hermite, random_order)
    ->Arg(1000)
    ->Arg(1'000'000);

/// The same through a cursor: 64 queries an interval and more at 1000 of them.
void cursor(State& state, Interpolation rule) {
  const Table f = table(static_cast<std::size_t>(state.range(0)), rule);
  Cursor near(f);
  at_each(state, positions(f.columns(), queries, ascending), [&](double x) { return near.jet(x); });
}
BENCHMARK_CAPTURE(cursor, cubic, Interpolation::cubic_hermite)->Arg(1000)->Arg(1'000'000);
BENCHMARK_CAPTURE(cursor, quintic, Interpolation::quintic_hermite)->Arg(1000);

// ---- the peers -------------------------------------------------------------------------------------

#ifdef JOUNCE_BENCH_GSL
/// GSL's own users' way: a natural cubic spline, three calls, one accelerator.
struct Gsl {
  explicit Gsl(const Columns& columns)
      : f(gsl_spline_alloc(gsl_interp_cspline, columns.x.size())), near(gsl_interp_accel_alloc()) {
    gsl_spline_init(f, columns.x.data(), columns.p.data(), columns.x.size());
  }
  Gsl(const Gsl&) = delete;
  Gsl& operator=(const Gsl&) = delete;
  ~Gsl() {
    gsl_interp_accel_free(near);
    gsl_spline_free(f);
  }
  std::array<double, 3> operator()(double x) const {
    return {gsl_spline_eval(f, x, near), gsl_spline_eval_deriv(f, x, near),
            gsl_spline_eval_deriv2(f, x, near)};
  }
  gsl_spline* f;
  gsl_interp_accel* near;
};

void gsl_block(State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const Columns& columns = knots(n / 64, Interpolation::cubic_hermite);
  const Gsl f(columns);
  const auto x = positions(columns, n, ascending);
  Results out(n);
  for (auto _ : state) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto at = f(x[k]);
      out.p[k] = at[0];
      out.v[k] = at[1];
      out.a[k] = at[2];
    }
    benchmark::ClobberMemory();
  }
  count(state, n);
}
BENCHMARK(gsl_block)->Arg(960)->Arg(16000);

void gsl_single(State& state, Order order) {
  const Columns& columns =
      knots(static_cast<std::size_t>(state.range(0)), Interpolation::cubic_hermite);
  const Gsl f(columns);
  at_each(state, positions(columns, queries, order), [&](double x) { return f(x); });
}
BENCHMARK_CAPTURE(gsl_single, ascending, ascending)->Arg(1000)->Arg(1'000'000);
BENCHMARK_CAPTURE(gsl_single, random, random_order)->Arg(1000)->Arg(1'000'000);

void gsl_build(State& state) {
  const Columns& columns = knots(1'000'000, Interpolation::cubic_hermite);
  for (auto _ : state) {
    const Gsl f(columns);
    benchmark::DoNotOptimize(f.f);
  }
}
BENCHMARK(gsl_build)->Unit(benchmark::kMillisecond);
#endif

#ifdef JOUNCE_BENCH_BOOST
void boost_cubic(State& state, Order order) {
  auto [x, p, v, a] = knots(static_cast<std::size_t>(state.range(0)), Interpolation::cubic_hermite);
  const auto at = positions(knots(x.size() - 1, Interpolation::cubic_hermite), queries, order);
  const boost::math::interpolators::cubic_hermite<std::vector<double>> f(std::move(x), std::move(p),
                                                                         std::move(v));
  at_each(state, at, [&](double u) {
    return std::array{f(u), f.prime(u)};
  });  // no second derivative
}
BENCHMARK_CAPTURE(boost_cubic, ascending, ascending)->Arg(1000);
BENCHMARK_CAPTURE(boost_cubic, random, random_order)->Arg(1000)->Arg(1'000'000);

void boost_quintic(State& state, Order order) {
  auto [x, p, v, a] =
      knots(static_cast<std::size_t>(state.range(0)), Interpolation::quintic_hermite);
  const auto at = positions(knots(x.size() - 1, Interpolation::quintic_hermite), queries, order);
  const boost::math::interpolators::quintic_hermite<std::vector<double>> f(
      std::move(x), std::move(p), std::move(v), std::move(a));
  at_each(state, at, [&](double u) { return std::array{f(u), f.prime(u), f.double_prime(u)}; });
}
BENCHMARK_CAPTURE(boost_quintic, ascending, ascending)->Arg(1000);
BENCHMARK_CAPTURE(boost_quintic, random, random_order)->Arg(1000)->Arg(1'000'000);
#endif

// ---- checking: no peer does ----------------------------------------------------------------------

/// A million intervals of a motion that swings at many frequencies, as a controller records one.
Table recorded(Interpolation rule) {
  Columns columns;
  constexpr std::size_t n = 1'000'000;
  constexpr double tau = 6.283185307179586;
  for (std::size_t i = 0; i <= n; ++i) {
    const double x = static_cast<double>(i) * 1e-3;
    Jet f{};
    for (const double w : {tau / 1000, tau / 13.7, tau / 0.731}) {
      f[0] += std::sin(w * x) / w;
      f[1] += std::cos(w * x);
      f[2] -= std::sin(w * x) * w;
    }
    columns.x.push_back(x);
    columns.p.push_back(f[0]);
    if (rule != Interpolation::linear) columns.v.push_back(f[1]);
    if (rule == Interpolation::quintic_hermite) columns.a.push_back(f[2]);
  }
  return {Domain::time, rule, Extrapolation::hold, std::move(columns)};
}

/// Positions at random, velocities too: every interval swings as it likes.
Table wild(Interpolation rule) {
  return table(1'000'000, rule);
}

void extrema_of_a_million(State& state, Table (*make)(Interpolation), Interpolation rule) {
  const Table f = make(rule);
  for (auto _ : state) benchmark::DoNotOptimize(extrema(f));
}
BENCHMARK_CAPTURE(extrema_of_a_million, recorded_linear, recorded, Interpolation::linear)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(extrema_of_a_million, recorded_cubic, recorded, Interpolation::cubic_hermite)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(extrema_of_a_million, recorded_quintic, recorded, Interpolation::quintic_hermite)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(extrema_of_a_million, wild_cubic, wild, Interpolation::cubic_hermite)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(extrema_of_a_million, wild_quintic, wild, Interpolation::quintic_hermite)
    ->Unit(benchmark::kMillisecond);

/// Limits on everything, which it keeps.
void verdict_on_a_million(State& state, Table (*make)(Interpolation), Interpolation rule) {
  const Table f = make(rule);
  const Limits limits{.position_min = -1e6,
                      .position_max = 1e6,
                      .velocity = 1e6,
                      .acceleration = 1e9,
                      .jerk = 1e12};
  for (auto _ : state) benchmark::DoNotOptimize(check(f, limits));
}
BENCHMARK_CAPTURE(verdict_on_a_million, recorded_cubic, recorded, Interpolation::cubic_hermite)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(verdict_on_a_million, recorded_quintic, recorded, Interpolation::quintic_hermite)
    ->Unit(benchmark::kMillisecond);

void continuity_of_a_million(State& state) {
  const Table f = recorded(Interpolation::cubic_hermite);
  for (auto _ : state) benchmark::DoNotOptimize(check_continuity(f, 1));
}
BENCHMARK(continuity_of_a_million)->Unit(benchmark::kMillisecond);

/// The way of a curve: made of the table, then every segment searched.
void verdict_through_a_curve(State& state) {
  const Table f = recorded(Interpolation::cubic_hermite);
  const Limits limits{.position_min = -1e6,
                      .position_max = 1e6,
                      .velocity = 1e6,
                      .acceleration = 1e9,
                      .jerk = 1e12};
  for (auto _ : state) benchmark::DoNotOptimize(check(f.curve<OverTime>(), limits));
}
BENCHMARK(verdict_through_a_curve)->Unit(benchmark::kMillisecond);

// ---- building ----------------------------------------------------------------------------------

/// The columns copied, every value looked at, the index made.
void build(State& state) {
  const Columns& columns = knots(1'000'000, Interpolation::cubic_hermite);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        Table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold, columns));
}
BENCHMARK(build)->Unit(benchmark::kMillisecond);

}  // namespace
