// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/compensation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/fill.hpp"

#include "pvt/src/compensation/grid_cell.hpp"

// Within a cell the grid's coordinates are s_j = (x_j - start_j) / interval_j and
//
//   (1)  c = sum over a, b, c of k_abc s_1^a s_2^b s_3^c
//
// The coefficients are those of the linear interpolation, or of the cubic one between values f and
// slopes d (with respect to s) at both ends,
//
//   (2)  f0 + d0 s + (3 (f1 - f0) - 2 d0 - d1) s^2 + (2 (f0 - f1) + d0 + d1) s^3,
//
// applied along one reference after another. The slopes are those of the natural spline.

namespace jounce {
namespace {

void require_axis(const GridAxis& axis, const std::string& key) {
  require_finite((key + ".base").c_str(), axis.base);
  require_positive((key + ".interval").c_str(), axis.interval);
  if (axis.count < 2)
    throw InputError(key + ".count", std::to_string(axis.count), "must be at least 2");
  if (!std::isfinite(axis.end()))
    throw InputError(key + ".interval", axis.interval, "leads beyond the range of a double");
}

void require_valid(const CompensationSpec& spec) {
  const std::size_t n = spec.axes.size();
  if (n < 1 || n > Compensation::most_references)
    throw InputError("axes", std::to_string(n), "must be one, two or three references");
  if (spec.rule == GridRule::cubic && n == 3)
    throw InputError("rule", "cubic",
                     "is for one or two references: three are interpolated linearly");
  std::size_t points = 1;
  for (std::size_t j = 0; j < n; ++j) {
    require_axis(spec.axes[j], "axes[" + std::to_string(j + 1) + "]");
    points *= spec.axes[j].count;
  }
  if (spec.values.size() != points)
    throw InputError("values", std::to_string(spec.values.size()),
                     "the grid has " + std::to_string(points) + " points");
  for (std::size_t i = 0; i < points; ++i) {
    const std::string key = "values[" + std::to_string(i + 1) + "]";
    require_finite(key.c_str(), spec.values[i]);
    if (std::abs(spec.values[i]) > spec.most)
      throw InputError(key, spec.values[i],
                       "exceeds the greatest correction, " + number(spec.most));
  }
}

/// The slopes of the natural spline through `count` values that are `stride` entries apart, with
/// respect to s.
void natural_slopes(const double* f, double* d, std::size_t count, std::size_t stride) {
  std::vector<double> x(count);
  std::vector<double> p(count);
  std::vector<double> v(count);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = static_cast<double>(i);
    p[i] = f[i * stride];
  }
  spline_velocities(x, p, Filling::natural, v);
  for (std::size_t i = 0; i < count; ++i) d[i * stride] = v[i];
}

/// Equation (2), or a straight line: coefficients of the powers of s from the values and slopes at
/// both ends.
using Line = std::array<double, 4>;  // f0, f1, d0, d1 and back as 1, s, s^2, s^3
Line powers(const Line& ends, GridRule rule) {
  const auto [f0, f1, d0, d1] = ends;
  if (rule == GridRule::linear) return {f0, f1 - f0, 0, 0};
  return {f0, d0, 3 * (f1 - f0) - 2 * d0 - d1, 2 * (f0 - f1) + d0 + d1};
}

/// The place of a reference on its axis: the interval, and the side of the grid (-1: before it, 0:
/// inside, 1: after it).
struct Spot {
  std::size_t interval = 0;
  int outside = 0;
};
Spot spot(const GridAxis& axis, double x) {
  const double s = (x - axis.base) / axis.interval;
  const auto last = static_cast<double>(axis.count - 2);
  if (!(s >= 0)) return {0, -1};
  if (s > last + 1) return {axis.count - 2, 1};
  return {static_cast<std::size_t>(std::min(std::floor(s), last)), 0};
}

/// Outside the grid, the cell has the constant value of s_j = 0 or 1 along s_j: only the constant
/// of the powers of s_j remains.
void hold(Compensation::Cell& cell, std::size_t j, std::size_t references, int outside) {
  std::size_t terms = 1;
  std::size_t stride = 1;
  for (std::size_t i = 0; i < references; ++i) terms *= cell.order;
  for (std::size_t i = 0; i < j; ++i) stride *= cell.order;
  for (std::size_t i = 0; i < terms; ++i) {
    const std::size_t e = i / stride % cell.order;
    if (e == 0) continue;
    if (outside > 0) cell.k[i - e * stride] += cell.k[i];
    cell.k[i] = 0;
  }
  cell.per_interval[j] = 0;
}

}  // namespace

Compensation::Compensation(const CompensationSpec& spec)
    : axes_(spec.axes), rule_(spec.rule), values_(spec.values) {
  require_valid(spec);
  if (rule_ == GridRule::linear) return;
  const std::size_t n = axes_[0].count;
  const std::size_t rows = values_.size() / n;
  for (auto& slopes : slopes_) slopes.assign(values_.size(), 0);
  for (std::size_t row = 0; row < rows; ++row)
    natural_slopes(&values_[row * n], &slopes_[0][row * n], n, 1);
  if (rows == 1) return;
  for (std::size_t i = 0; i < n; ++i) {
    natural_slopes(&values_[i], &slopes_[1][i], rows, n);
    natural_slopes(&slopes_[0][i], &slopes_[2][i], rows, n);
  }
}

Compensation::Cell Compensation::cell(std::span<const double> references) const {
  require_size("references", references.size(), axes_.size());
  Cell cell;
  cell.order = rule_ == GridRule::linear ? 2 : 4;
  std::array<Spot, most_references> spots{};
  for (std::size_t j = 0; j < axes_.size(); ++j) {
    spots[j] = spot(axes_[j], references[j]);
    cell.start[j] = axes_[j].base + axes_[j].interval * static_cast<double>(spots[j].interval);
    cell.per_interval[j] = 1 / axes_[j].interval;
  }
  fill(cell, {spots[0].interval, spots[1].interval, spots[2].interval});
  for (std::size_t j = 0; j < axes_.size(); ++j)
    if (spots[j].outside != 0) hold(cell, j, axes_.size(), spots[j].outside);
  return cell;
}

/// Computes the coefficients (1): first along the first reference, for the values (and the slopes
/// along the second) at each end of the other references; then along the second, then along the
/// third.
void Compensation::fill(Cell& cell, const std::array<std::size_t, 3>& interval) const {
  const std::size_t n = axes_[0].count;
  const std::size_t m = axes_.size() > 1 ? axes_[1].count : 1;
  const auto along_first = [&](std::size_t j, std::size_t k, bool by_second) {
    const std::size_t i = interval[0] + n * (interval[1] + j + m * (interval[2] + k));
    const auto& f = by_second ? slopes_[1] : values_;
    const auto& d = slopes_[by_second ? 2 : 0];
    const bool sloped = rule_ == GridRule::cubic;
    return powers({f[i], f[i + 1], sloped ? d[i] : 0, sloped ? d[i + 1] : 0}, rule_);
  };
  const auto along_second = [&](std::size_t k, std::size_t a) {
    if (m == 1) return Line{along_first(0, k, false)[a], 0, 0, 0};
    Line ends{along_first(0, k, false)[a], along_first(1, k, false)[a], 0, 0};
    if (rule_ == GridRule::cubic)
      ends = {ends[0], ends[1], along_first(0, k, true)[a], along_first(1, k, true)[a]};
    return powers(ends, rule_);
  };
  const std::size_t order = cell.order;
  const std::size_t second = m == 1 ? 1 : order;
  for (std::size_t a = 0; a < order; ++a) {
    const Line low = along_second(0, a);
    for (std::size_t b = 0; b < second; ++b) cell.k[a + order * b] = low[b];
    if (axes_.size() < 3) continue;
    const Line high = along_second(1, a);
    for (std::size_t b = 0; b < second; ++b) cell.k[a + order * (b + order)] = high[b] - low[b];
  }
}

double Compensation::peak() const {
  double peak = 0;
  for (const double value : values_) peak = std::max(peak, std::abs(value));
  return peak;
}

double Compensation::at(std::span<const double> references) const {
  const Cell here = cell(references);
  std::array<pvt_detail::Terms<1>, most_references> s{};
  for (std::size_t j = 0; j < references.size(); ++j)
    s[j] = {(references[j] - here.start[j]) * here.per_interval[j]};
  return pvt_detail::evaluated(here, s, references.size())[0];
}

Jet Compensation::at(std::span<const Jet> references) const {
  require_size("references", references.size(), axes_.size());
  std::array<double, most_references> places{};
  for (std::size_t j = 0; j < references.size(); ++j) places[j] = references[j][0];
  const Cell here = cell(std::span(places).first(references.size()));
  std::array<pvt_detail::Terms<3>, most_references> s{};  // series over time
  for (std::size_t j = 0; j < references.size(); ++j) {
    const auto& [x, v, a, jerk] = references[j];
    const double per = here.per_interval[j];
    s[j] = {(x - here.start[j]) * per, v * per, a / 2 * per};
  }
  const auto c = pvt_detail::evaluated(here, s, references.size());
  return {c[0], c[1], 2 * c[2], 0};
}

}  // namespace jounce
