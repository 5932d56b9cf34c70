#include "jounce/pvt/sample.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/extrema.hpp"

namespace jounce {
namespace {

/// Lets a periodic table end on exactly the numbers it begins with, where they differ by rounding.
void close_period(std::vector<double>& column) {
  if (column.empty()) return;
  double scale = 0;
  for (const double value : column) scale = std::max(scale, std::abs(value));
  if (std::abs(column.back() - column.front()) <= 1e-12 * scale) column.back() = column.front();
}

template <class Over>
Columns columns_at(const Curve<Over>& f, Rule rule, std::vector<double> knots) {
  Columns columns;
  for (const double x : knots) {
    const Jet jet = f.jet(x, x == f.end() ? Side::left : Side::right);
    columns.p.push_back(jet[0]);
    if (rule != Rule::linear) columns.v.push_back(jet[1]);
    if (rule == Rule::quintic_hermite) columns.a.push_back(jet[2]);
  }
  columns.x = std::move(knots);
  return columns;
}

/// The exact error of the table: the difference is a curve of the same kind (a Hermite piece minus
/// a segment keeps the segment's sines), so its extrema are exact too.
template <class Over>
SampleError error_of(const Curve<Over>& f, const Table& table) {
  const auto difference = sum(table.curve<Over>(), scaled(with(f, table.outside()), -1));
  const Ranges ranges = extrema(difference);
  return {std::abs(ranges[0].peak().value), ranges[0].peak().where,
          std::abs(ranges[1].peak().value)};
}

std::vector<double> equal_parts(double from, double to, std::size_t intervals) {
  std::vector<double> knots;
  for (std::size_t i = 0; i < intervals; ++i)
    knots.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(intervals));
  return knots;
}

/// A knot has one velocity and one acceleration: where the curve's steps, the table has the right
/// one, and strays in the interval before by at most (greatest values of the Hermite shapes)
///
///     (1)  cubic:   4/27 |dv| d;      quintic:   0.2 |dv| d + 0.01728 |da| d^2
///
/// over an interval of length d: so that one is made short enough for an eighth of `wanted`. A curve
/// that repeats has its end's from its start.
template <class Over>
std::vector<double> shortened_before_steps(const Curve<Over>& f, Rule rule, double wanted,
                                           const std::vector<double>& knots) {
  std::vector<double> all{knots.front()};
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double x = knots[i];
    if (rule != Rule::linear && (x != f.end() || repeats(f.outside()))) {
      const Jet left = f.jet(x, Side::left);
      const Jet right = f.jet(x == f.end() ? f.start() : x, Side::right);
      const double dv = std::abs(right[1] - left[1]);
      const double da = rule == Rule::quintic_hermite ? std::abs(right[2] - left[2]) : 0;
      double d = x - all.back();
      const auto stray = [&] { return 0.2 * dv * d + 0.01728 * da * d * d; };
      while (stray() > wanted / 8 && x - d / 2 < x) d /= 2;
      if (d < x - all.back()) all.push_back(x - d);
    }
    all.push_back(x);
  }
  return all;
}

}  // namespace

template <class Over>
Sampled sample(const Curve<Over>& f, Rule rule, const std::vector<double>& knots) {
  if (knots.size() < 2)
    throw InputError("knots", std::to_string(knots.size()), "at least two are needed");
  if (knots.front() != f.start() || knots.back() != f.end())
    throw InputError("knots", number(knots.front()) + " to " + number(knots.back()),
                     "must span the curve, " + number(f.start()) + " to " + number(f.end()));
  return certified(f, rule, columns_at(f, rule, knots));
}

template <class Over>
Sampled certified(const Curve<Over>& f, Rule rule, Columns columns) {
  if (f.outside() == Outside::wrap) close_period(columns.p);
  if (repeats(f.outside()))
    for (auto* column : {&columns.v, &columns.a}) close_period(*column);
  constexpr Axis axis = std::is_same_v<Over, OverTime> ? Axis::time : Axis::master;
  Table table(axis, rule, f.outside(), std::move(columns));
  const SampleError error = error_of(f, table);
  return {std::move(table), error, {}};
}

const char* name(Binding binding) {
  switch (binding) {
    case Binding::none:
      return "none";
    case Binding::tolerance:
      return "tolerance";
    case Binding::velocity_tolerance:
      return "velocity_tolerance";
    case Binding::most:
      break;
  }
  return "most";
}

template <class Over>
Sampled sample(const Curve<Over>& f, Rule rule, std::size_t intervals) {
  if (intervals < 1) throw InputError("intervals", 0.0, "must be at least 1");
  auto knots = equal_parts(f.start(), f.end(), intervals);
  knots.push_back(f.end());
  return sample(f, rule, knots);
}

template <class Over>
Sampled sample_within(const Curve<Over>& f, Rule rule, double tolerance, std::size_t most) {
  require_positive("tolerance", tolerance);
  // What is below the rounding of the values cannot be asked for.
  const double wanted = std::max(tolerance, 4e-16 * std::abs(extrema(f, 0).peak().value));
  std::vector<double> knots;
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    const Curve<Over> piece({f.segments()[i]}, f.breaks()[i]);
    const auto fits = [&](std::size_t n) {
      return sample(piece, rule, n).error.position <= wanted;
    };
    std::size_t enough = 1;
    while (!fits(enough)) {
      enough *= 2;
      if (knots.size() + enough > most)
        throw InputError(
            "tolerance", tolerance,
            "needs more than " + std::to_string(most) + " knots with a " + name(rule) + " table");
    }
    std::size_t too_few = enough / 2;
    while (enough - too_few > 1) {
      const std::size_t middle = (enough + too_few) / 2;
      (fits(middle) ? enough : too_few) = middle;
    }
    const auto inner = equal_parts(f.breaks()[i], f.breaks()[i + 1], enough);
    knots.insert(knots.end(), inner.begin(), inner.end());
  }
  knots.push_back(f.end());
  knots = shortened_before_steps(f, rule, wanted, knots);
  Sampled sampled = sample(f, rule, knots);
  // An interval that fitted by its symmetry may no longer do so once it is shortened.
  for (int i = 0; i < 20 && sampled.error.position > wanted; ++i) {
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, sampled.error.where);
    knots.insert(above, (*(above - 1) + *above) / 2);
    sampled = sample(f, rule, knots);
  }
  return sampled;
}

#define JOUNCE_INSTANTIATE(Over)                                                 \
  template Sampled sample(const Curve<Over>&, Rule, const std::vector<double>&); \
  template Sampled sample(const Curve<Over>&, Rule, std::size_t);                \
  template Sampled certified(const Curve<Over>&, Rule, Columns);                 \
  template Sampled sample_within(const Curve<Over>&, Rule, double, std::size_t);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
