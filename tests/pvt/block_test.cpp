// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/cursor.hpp"
#include "jounce/pvt/table.hpp"

#include "pvt/src/table/sample_kernel.hpp"
#include "support/random.hpp"

namespace jounce::block_test {
namespace {

using test::Random;

constexpr std::array rules{Interpolation::linear, Interpolation::cubic_hermite,
                           Interpolation::quintic_hermite};
constexpr std::array policies{Extrapolation::hold, Extrapolation::wrap, Extrapolation::advance};

/// Knots that are 1e-3 to 1e3 apart, values of any sign, in a scale of their own.
Table random_table(Random& random, Interpolation rule, Extrapolation outside) {
  const int n = 2 + random.below(40);
  const double unit = random.log_uniform(1e-6, 1e6);
  Columns columns;
  double x = random.uniform(-10, 10);
  for (int i = 0; i < n; ++i, x += random.log_uniform(1e-3, 1e3)) {
    columns.x.push_back(x);
    columns.p.push_back(unit * random.uniform(-1, 1));
    if (rule != Interpolation::linear) columns.v.push_back(unit * random.uniform(-1, 1));
    if (rule == Interpolation::quintic_hermite) columns.a.push_back(unit * random.uniform(-1, 1));
  }
  return {Domain::time, rule, outside, std::move(columns)};
}

struct Block {
  std::vector<double> p, v, a;
  // The shift makes blocks begin at any place of a cache line.
  Block(std::size_t n, std::size_t shift = 0) : p(n + shift), v(n + shift), a(n + shift) {}
};

std::uint64_t bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

void expect_jets(const Table& table, const std::vector<double>& x, const double* p, const double* v,
                 const double* a, const char* how) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Jet f = table.jet(x[k]);
    ASSERT_EQ(bits(p[k]), bits(f[0])) << how << ", sample " << k << " at " << x[k];
    ASSERT_EQ(bits(v[k]), bits(f[1])) << how << ", sample " << k << " at " << x[k];
    ASSERT_EQ(bits(a[k]), bits(f[2])) << how << ", sample " << k << " at " << x[k];
  }
}

/// Any number of samples, knots among them, from a way before the table to a way behind it.
std::vector<double> some_instants(Random& random, const Table& table) {
  std::vector<double> x;
  const int n = random.below(600);
  for (int k = 0; k < n; ++k)
    x.push_back(
        random.uniform(table.start() - table.length() / 4, table.end() + table.length() / 4));
  for (const double knot : table.breaks())
    if (random.below(2) == 0) x.push_back(knot);
  std::sort(x.begin(), x.end());
  return x;
}

TEST(Block, IsEveryJetToTheBit) {
  Random random(1);
  for (int trial = 0; trial < 600; ++trial) {
    SCOPED_TRACE(trial);
    const Table table = random_table(random, rules[static_cast<std::size_t>(trial) % 3],
                                     policies[static_cast<std::size_t>(random.below(3))]);
    const auto x = some_instants(random, table);
    const auto shift = static_cast<std::size_t>(random.below(8));
    Block out(x.size(), shift);
    const std::span p(out.p), v(out.v), a(out.a);
    table.sample(x, p.subspan(shift), v.subspan(shift), a.subspan(shift));
    expect_jets(table, x, &p[shift], &v[shift], &a[shift], "ascending");
    if (HasFatalFailure()) return;
  }
}

TEST(Block, TakesInstantsInAnyOrder) {
  Random random(2);
  for (const Interpolation rule : rules) {
    const Table table = random_table(random, rule, Extrapolation::wrap);
    auto x = some_instants(random, table);
    std::reverse(x.begin(), x.end());
    Block out(x.size());
    table.sample(x, out.p, out.v, out.a);
    expect_jets(table, x, out.p.data(), out.v.data(), out.a.data(), "descending");
  }
  const Table line(Domain::time, Interpolation::linear, Extrapolation::hold,
                   {{0, 1}, {0, 1}, {}, {}});
  line.sample(std::vector<double>{}, {}, {}, {});  // none at all
}

TEST(Block, OfAGridIsThatOfItsInstants) {
  Random random(3);
  for (int trial = 0; trial < 600; ++trial) {
    SCOPED_TRACE(trial);
    const Table table = random_table(random, rules[static_cast<std::size_t>(trial) % 3],
                                     policies[static_cast<std::size_t>(random.below(3))]);
    const auto n = static_cast<std::size_t>(random.below(700));
    const Grid grid{table.start() + random.uniform(-0.3, 0.6) * table.length(),
                    table.length() * random.log_uniform(1e-6, 0.3)};
    std::vector<double> x;
    for (std::size_t k = 0; k < n; ++k)
      x.push_back(grid.start + static_cast<double>(k) * grid.step);
    Block out(n);
    table.sample(grid, out.p, out.v, out.a);
    expect_jets(table, x, out.p.data(), out.v.data(), out.a.data(), "grid");
    if (HasFatalFailure()) return;
  }
}

/// Every width that this processor has, beside the one without special instructions.
void expect_kernel(const pvt_detail::SampleKernels& kernels) {
  Random random(4);
  for (int trial = 0; trial < 300; ++trial) {
    const Table table =
        random_table(random, rules[static_cast<std::size_t>(trial) % 3], Extrapolation::hold);
    const pvt_detail::KnotColumns columns = pvt_detail::knots_of(table.columns());
    const auto n = static_cast<std::size_t>(1 + random.below(900));
    const double step = table.length() / static_cast<double>(n + 1);
    std::vector<double> x;
    for (std::size_t k = 0; k < n; ++k) x.push_back(table.start() + static_cast<double>(k) * step);
    Block out(n);
    kernels.uniform(columns, table.rule(), {table.start(), step}, 0, n,
                    {out.p.data(), out.v.data(), out.a.data()});
    expect_jets(table, x, out.p.data(), out.v.data(), out.a.data(), "uniform");
    EXPECT_TRUE(kernels.ascends(x.data(), n));
    if (n > 1) {  // two that change places, and one NaN, at any place
      auto turned = x;
      const auto k = static_cast<std::size_t>(random.below(static_cast<int>(n) - 1));
      std::swap(turned[k], turned[k + 1]);
      EXPECT_FALSE(kernels.ascends(turned.data(), n)) << k << " of " << n;
      turned = x;
      turned[k] = std::nan("");
      EXPECT_FALSE(kernels.ascends(turned.data(), n)) << k << " of " << n;
    }
    out = Block(n);
    kernels.listed(columns, table.rule(), {x.data()}, 0, n,
                   {out.p.data(), out.v.data(), out.a.data()});
    expect_jets(table, x, out.p.data(), out.v.data(), out.a.data(), "listed");
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(Block, IsTheSameToTheBitWithEachVectorWidthOfThisProcessor) {
  expect_kernel(pvt_detail::sample_anywhere);
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) expect_kernel(pvt_detail::sample_avx2);
  if (__builtin_cpu_supports("avx512f")) expect_kernel(pvt_detail::sample_avx512);
#endif
}

/// p, v, a of an interval in long double, and the largest term of each in magnitude.
struct Reference {
  long double value[3]{};
  long double scale[3]{};
};
Reference reference(const Table& table, std::size_t i, double at) {
  using Long = long double;
  const Columns& t = table.columns();
  const Long length = Long(t.x[i + 1]) - t.x[i];
  const Long s = (Long(at) - t.x[i]) / length;
  const Long h = Long(t.p[i + 1]) - t.p[i];
  std::array<Long, 6> c{t.p[i], h};
  // The terms that a coefficient is the sum of, as large as they may be beside what remains of them.
  std::array<Long, 6> size{std::abs(c[0]), std::abs(Long(t.p[i])) + std::abs(Long(t.p[i + 1]))};
  if (table.rule() != Interpolation::linear) {
    const Long m0 = t.v[i] * length;
    const Long m1 = t.v[i + 1] * length;
    const bool fifth = table.rule() == Interpolation::quintic_hermite;
    const Long k0 = fifth ? t.a[i] * length * length : 0;
    const Long k1 = fifth ? t.a[i + 1] * length * length : 0;
    if (fifth)
      c = {c[0],
           m0,
           k0 / 2,
           10 * h - 6 * m0 - 4 * m1 - (3 * k0 - k1) / 2,
           -15 * h + 8 * m0 + 7 * m1 + (3 * k0 - 2 * k1) / 2,
           6 * h - 3 * (m0 + m1) - (k0 - k1) / 2};
    else
      c = {c[0], m0, 3 * h - 2 * m0 - m1, -2 * h + m0 + m1, 0, 0};
    const Long largest =
        std::max({std::abs(h), std::abs(m0), std::abs(m1), std::abs(k0), std::abs(k1)});
    const std::array<Long, 6> factors =
        fifth ? std::array<Long, 6>{0, 1, 0.5L, 10, 15, 6} : std::array<Long, 6>{0, 1, 3, 2, 0, 0};
    for (std::size_t k = 1; k < 6; ++k) size[k] = factors[k] * largest;
  }
  Reference f;
  for (std::size_t order = 0; order < 3; ++order) {
    const Long unit = std::pow(length, -Long(order));
    for (std::size_t k = order; k < 6; ++k) {
      Long factor = unit;
      for (std::size_t d = 0; d < order; ++d) factor *= Long(k - d);
      f.value[order] += factor * c[k] * std::pow(s, Long(k - order));
      f.scale[order] = std::max(f.scale[order], std::abs(factor) * size[k]);
    }
  }
  return f;
}

TEST(Block, IsWithinFourUlpOfLongDouble) {
  Random random(5);
  long double worst = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Table table =
        random_table(random, rules[static_cast<std::size_t>(trial) % 3], Extrapolation::hold);
    const std::size_t n = 64;
    Block out(n);
    const Grid grid{table.start(), table.length() / static_cast<double>(n)};
    table.sample(grid, out.p, out.v, out.a);
    for (std::size_t k = 0; k < n; ++k) {
      const double at = grid.start + static_cast<double>(k) * grid.step;
      if (!(at < table.end())) continue;
      const auto knot = std::upper_bound(table.breaks().begin(), table.breaks().end(), at);
      const auto f =
          reference(table, static_cast<std::size_t>(knot - table.breaks().begin()) - 1, at);
      const std::array got{out.p[k], out.v[k], out.a[k]};
      for (std::size_t order = 0; order < 3; ++order) {
        if (f.scale[order] == 0) continue;
        const long double ulp = f.scale[order] * std::numeric_limits<double>::epsilon();
        worst = std::max(worst, std::abs(got[order] - f.value[order]) / ulp);
        ASSERT_LE(std::abs(got[order] - f.value[order]), 4 * ulp)
            << "trial " << trial << ", order " << order << " at " << at;
      }
    }
  }
  RecordProperty("worst_ulp", std::to_string(worst));
}

TEST(Block, SamplesIntoSpansOfTheSameSize) {
  Random random(8);
  const Table table = random_table(random, Interpolation::cubic_hermite, Extrapolation::hold);
  const std::vector<double> x{table.start(), table.end()};
  std::vector<double> p(2), v(2), a(2), one(1);
  EXPECT_THROW(table.sample(x, one, v, a), InputError);
  EXPECT_THROW(table.sample(x, p, one, a), InputError);
  EXPECT_THROW(table.sample(x, p, v, one), InputError);
  EXPECT_THROW(table.sample(Grid{table.start(), 0.1}, p, one, a), InputError);
  EXPECT_THROW(table.sample(Grid{table.start(), 0.1}, p, v, one), InputError);
  table.sample(x, p, v, a);
  EXPECT_EQ(p[0], table.jet(x[0])[0]);
}

}  // namespace
}  // namespace jounce::block_test
