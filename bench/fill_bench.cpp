// SPDX-License-Identifier: Apache-2.0
// The velocities of a C2 cubic spline, and the other fillings, beside GSL's and Boost's: what it takes
// to build one through n knots at uneven distances.
#include <cmath>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "jounce/pvt/fill.hpp"

#ifdef JOUNCE_BENCH_GSL
#include <gsl/gsl_interp.h>
#endif
#ifdef JOUNCE_BENCH_BOOST
// Boost 1.74's pchip.hpp calls isnan without std::
// clang-format off
#include <math.h>
#include <boost/math/interpolators/pchip.hpp>
// clang-format on
#endif

using namespace jounce;

namespace {

struct Data {
  std::vector<double> x, p;
};

Data data(std::size_t n) {
  Data all{std::vector<double>(n), std::vector<double>(n)};
  double x = 0;
  for (std::size_t i = 0; i < n; ++i) {
    x += 0.5 + std::fmod(0.618033988749895 * static_cast<double>(i), 1.0);
    all.x[i] = x;
    all.p[i] = std::sin(0.01 * x) + 0.1 * std::sin(x);
  }
  return all;
}

void report(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void velocities(benchmark::State& state, Filling ends) {
  const Data all = data(static_cast<std::size_t>(state.range(0)));
  std::vector<double> v(all.x.size());
  for (auto _ : state) {
    spline_velocities(all.x, all.p, ends, v);
    benchmark::DoNotOptimize(v.data());
  }
  report(state);
}

void fill(benchmark::State& state, Filling filling, Interpolation rule) {
  const Data all = data(static_cast<std::size_t>(state.range(0)));
  FillSpec spec{.x = all.x, .p = all.p, .rule = rule, .filling = filling};
  spec.limits = {.velocity = 0.2, .acceleration = 0.3};
  for (auto _ : state) benchmark::DoNotOptimize(filled(spec));
  report(state);
}

BENCHMARK_CAPTURE(velocities, natural, Filling::natural)->Arg(1000)->Arg(1000000);
BENCHMARK_CAPTURE(velocities, periodic, Filling::periodic)->Arg(1000)->Arg(1000000);

#ifdef JOUNCE_BENCH_GSL
void gsl(benchmark::State& state, const gsl_interp_type* type) {
  const Data all = data(static_cast<std::size_t>(state.range(0)));
  gsl_interp* spline = gsl_interp_alloc(type, all.x.size());
  for (auto _ : state) {
    gsl_interp_init(spline, all.x.data(), all.p.data(), all.x.size());
    benchmark::DoNotOptimize(spline);
  }
  gsl_interp_free(spline);
  report(state);
}
void gsl_cspline(benchmark::State& state) {
  gsl(state, gsl_interp_cspline);
}
void gsl_cspline_periodic(benchmark::State& state) {
  gsl(state, gsl_interp_cspline_periodic);
}
void gsl_steffen(benchmark::State& state) {
  gsl(state, gsl_interp_steffen);
}
BENCHMARK(gsl_cspline)->Arg(1000)->Arg(1000000);
BENCHMARK(gsl_cspline_periodic)->Arg(1000000);
BENCHMARK(gsl_steffen)->Arg(1000000);
#endif

BENCHMARK_CAPTURE(fill, natural, Filling::natural, Interpolation::cubic_hermite)->Arg(1000000);
BENCHMARK_CAPTURE(fill, monotone, Filling::monotone, Interpolation::cubic_hermite)->Arg(1000000);
BENCHMARK_CAPTURE(fill, shape, Filling::shape_preserving, Interpolation::cubic_hermite)
    ->Arg(1000000);
BENCHMARK_CAPTURE(fill, limits, Filling::within_limits, Interpolation::cubic_hermite)->Arg(1000000);
BENCHMARK_CAPTURE(fill, jerk, Filling::minimum_jerk, Interpolation::quintic_hermite)->Arg(1000000);

#ifdef JOUNCE_BENCH_BOOST
void boost_pchip(benchmark::State& state) {
  const Data all = data(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    auto x = all.x, p = all.p;  // pchip() consumes both
    benchmark::DoNotOptimize(boost::math::interpolators::pchip(std::move(x), std::move(p)));
  }
  report(state);
}
BENCHMARK(boost_pchip)->Arg(1000000);
#endif

}  // namespace
