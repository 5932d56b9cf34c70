// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/table.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "jounce/profiles/detail/evaluate.hpp"
#include "jounce/profiles/error.hpp"

#include "pvt/src/table/piece.hpp"

namespace jounce {
namespace {

/// The names of the columns, which depend on the axis: "time", "velocity"; or "master",
/// "geo_velocity".
const char* column_name(Domain axis, std::size_t column) {
  if (column == 0) return name(axis);
  return axis == Domain::time ? OverTime::names[column - 1] : OverMaster::names[column - 1];
}

/// In messages, knots count from 1, as in a spec.
std::string entry(Domain axis, std::size_t column, std::size_t knot) {
  return "knot[" + std::to_string(knot + 1) + "]." + column_name(axis, column);
}

/// The first i < n that is not good; n if all are good. `bad_bits(i)` has its highest bit set if i
/// is not good. Several results are combined without a branch, and examined only if one is bad.
template <class BadBits>
std::size_t first_bad(std::size_t n, BadBits bad_bits) {
  const auto is_bad = [](std::uint64_t bits) { return bits >> 63U != 0; };
  std::uint64_t any = 0;
  for (std::size_t i = 0; i < n; ++i) any |= bad_bits(i);
  if (!is_bad(any)) return n;
  std::size_t i = 0;
  while (!is_bad(bad_bits(i))) ++i;
  return i;
}

/// A number is finite unless all bits of its exponent are 1; adding one to that overflows.
std::uint64_t not_finite(double value) {
  constexpr std::uint64_t exponent = 0x7FF0'0000'0000'0000, one = 0x0010'0000'0000'0000;
  return (std::bit_cast<std::uint64_t>(value) & exponent) + one;
}

/// For finite numbers. A small difference is exact: here it is negative, or a zero of either sign.
std::uint64_t not_greater(double value, double than) {
  const auto difference = std::bit_cast<std::uint64_t>(value - than);
  return difference | (difference - 1);
}

void require_column(Domain axis, Interpolation rule, std::size_t column,
                    const std::vector<double>& values, std::size_t knots) {
  const bool needed = column < 2 || rule == Interpolation::quintic_hermite ||
                      (column == 2 && rule == Interpolation::cubic_hermite);
  const std::size_t expected = needed ? knots : 0;
  if (values.size() != expected)
    throw InputError(std::string("column ") + column_name(axis, column),
                     std::to_string(values.size()) + " values",
                     std::string("a ") + name(rule) + " table of " + std::to_string(knots) +
                         " knots needs " + std::to_string(expected));
  const std::size_t i =
      first_bad(values.size(), [v = values.data()](std::size_t k) { return not_finite(v[k]); });
  if (i < values.size())
    throw InputError(entry(axis, column, i), values[i], "must be a finite number");
}

}  // namespace

Table::Table(Domain axis, Interpolation rule, Extrapolation outside, Columns columns)
    : axis_(axis), rule_(rule), outside_(outside) {
  const std::vector<double>& x = columns.x;
  const std::size_t knots = x.size();
  if (knots < 2) throw InputError("knots", std::to_string(knots), "must be at least 2");
  const std::array all{&columns.x, &columns.p, &columns.v, &columns.a};
  for (std::size_t column = 0; column < all.size(); ++column)
    require_column(axis, rule, column, *all[column], knots);
  const std::size_t i = 1 + first_bad(knots - 1, [at = x.data()](std::size_t k) {
                          return not_greater(at[k + 1], at[k]);
                        });
  if (i < knots)
    throw InputError(entry(axis, 0, i), x[i],
                     "must be greater than " + number(x[i - 1]) + ", the previous knot");
  BreakIndex index(x);
  knots_ = std::make_shared<const Knots>(Knots{std::move(columns), std::move(index)});
}

Segment Table::segment(std::size_t i) const {
  assert(i + 1 < size());
  const auto& [x, p, v, a] = columns();
  const double length = x[i + 1] - x[i];
  switch (rule_) {
    case Interpolation::linear:
      return line(length, p[i], p[i + 1]);
    case Interpolation::cubic_hermite:
      return cubic(length, p[i], v[i], p[i + 1], v[i + 1]);
    case Interpolation::quintic_hermite:
      break;
  }
  return quintic(length, p[i], v[i], a[i], p[i + 1], v[i + 1], a[i + 1]);
}

/// If there are more knots than this, the columns do not fit into a processor's nearer caches.
constexpr std::size_t cached = 16384;

/// Prefetches the knots next to interval i from all columns, during the comparison of x.
[[gnu::always_inline]] inline void Table::fetch(std::size_t i) const {
  const Columns& columns = knots_->columns;
  __builtin_prefetch(columns.p.data() + i);
  if (rule_ != Interpolation::linear) __builtin_prefetch(columns.v.data() + i);
  if (rule_ == Interpolation::quintic_hermite) __builtin_prefetch(columns.a.data() + i);
}

Jet Table::jet(double x, Side side) const {
  if (x >= start() && x < end()) [[likely]] {
    if (size() > cached) fetch(knots_->index.near(x));
    return inside(knots_->index.find(breaks(), x, side), x);
  }
  return at_end_or_outside(x, side);
}

Jet Table::at_end_or_outside(double x, Side side) const {
  if (profiles_detail::is_nowhere(x, outside_)) return profiles_detail::not_a_number;
  const auto within = [&](double at) { return inside(knots_->index.find(breaks(), at, side), at); };
  if (x == end() && !(side == Side::right && repeats(outside_))) return within(x);
  assert(outside_ != Extrapolation::refuse &&
         "query outside the range of a table that rejects this");
  if (!repeats(outside_)) return {inside(x < start() ? 0 : size() - 2, x)[0], 0, 0, 0};
  const auto [at, turns] = in_period(x, side, start(), end());
  Jet f = within(at);
  f[0] += turns * advance();
  return f;
}

double Table::advance() const {
  return outside_ == Extrapolation::advance ? columns().p.back() - columns().p.front() : 0;
}

template <int degree>
[[gnu::always_inline]] inline Jet jet_in(const pvt_detail::KnotColumns& t, std::size_t i,
                                         double at) {
  const pvt_detail::Piece<degree> f = pvt_detail::piece<degree>(t, i);
  const double s = pvt_detail::place(f, at, t.x[i + 1]);
  return {position(f, s), velocity(f, s), acceleration(f, s), jerk(f, s)};
}

[[gnu::always_inline]] inline Jet Table::inside(std::size_t i, double at) const {
  const pvt_detail::KnotColumns t = pvt_detail::knots_of(columns());
  switch (rule_) {
    case Interpolation::linear:
      return jet_in<1>(t, i, at);
    case Interpolation::cubic_hermite:
      return jet_in<3>(t, i, at);
    case Interpolation::quintic_hermite:
      break;
  }
  return jet_in<5>(t, i, at);
}

template <class Over>
Curve<Over> Table::curve() const {
  constexpr Domain wanted = std::is_same_v<Over, OverTime> ? Domain::time : Domain::master;
  if (axis_ != wanted)
    throw InputError("axis", name(axis_), std::string("must be ") + name(wanted));
  std::vector<Segment> segments;
  segments.reserve(size() - 1);
  for (std::size_t i = 0; i + 1 < size(); ++i) segments.push_back(segment(i));
  return Curve<Over>(std::move(segments), start(), outside_);
}

template Curve<OverTime> Table::curve() const;
template Curve<OverMaster> Table::curve() const;

void require_curve(const Table& table) {
  // No derivative up to the fourth exceeds 5! times the sum of the coefficients, divided by
  // length^4.
  const auto surely_finite = [](const Segment& f) {
    double sum = 0;
    for (std::size_t k = 0; k <= 5; ++k) sum += std::abs(f.c[k]);
    const double rate = std::max(1.0, 1 / f.length);
    return std::isfinite(120 * sum * rate * rate * rate * rate);
  };
  std::size_t i = 0;
  while (i + 1 < table.size() && surely_finite(table.segment(i))) ++i;
  if (i + 1 == table.size()) return;
  if (table.axis() == Domain::time)
    (void)table.curve<OverTime>();
  else
    (void)table.curve<OverMaster>();
}

Table stretched(const Table& table, double factor) {
  require_positive("factor", factor);
  Columns columns = table.columns();
  for (double& x : columns.x) x *= factor;
  for (double& v : columns.v) v /= factor;
  for (double& a : columns.a) a /= factor * factor;
  return Table(table.axis(), table.rule(), table.outside(), std::move(columns));
}

const char* name(Interpolation rule) {
  switch (rule) {
    case Interpolation::linear:
      return "linear";
    case Interpolation::cubic_hermite:
      return "cubic_hermite";
    case Interpolation::quintic_hermite:
      break;
  }
  return "quintic_hermite";
}

const char* name(Domain axis) {
  return axis == Domain::time ? "time" : "master";
}

const char* name(Extrapolation outside) {
  switch (outside) {
    case Extrapolation::refuse:
      return "refuse";
    case Extrapolation::hold:
      return "hold";
    case Extrapolation::wrap:
      return "wrap";
    case Extrapolation::advance:
      break;
  }
  return "advance";
}

}  // namespace jounce
