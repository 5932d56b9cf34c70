// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/spline_space.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "jounce/cam/detail/quadrature.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr std::array factorials{1.0,   1.0,    2.0,     6.0,      24.0,      120.0,
                                720.0, 5040.0, 40320.0, 362880.0, 3628800.0, 39916800.0};

double over_factorial(double power, int k) {
  return power / factorials[static_cast<std::size_t>(k)];
}

/// The power of two nearest to x, so that scaling causes no rounding.
double power_of_two(double x) {
  return std::exp2(std::round(std::log2(x)));
}

/// Derivatives have the same sines, so that their sum always fits.
Segment quantity_with_sines(const LinearQuantity& q, const Segment& f) {
  Segment total;
  total.length = f.length;
  total.c[0] = q.constant;
  Segment g = f;
  for (const double by : q.by) {
    if (by != 0) total = sum(total, scaled(g, by)).value();
    g = derivative(g);
  }
  return total;
}

}  // namespace

int order_of(const LinearQuantity& q) {
  for (std::size_t k = q.by.size(); k-- > 0;)
    if (q.by[k] != 0) return static_cast<int>(k);
  return -1;
}

Segment quantity_of(const LinearQuantity& q, const Segment& f) {
  if (f.sines > 0) return quantity_with_sines(q, f);
  Segment sum;
  sum.length = f.length;
  sum.c[0] = q.constant;
  Segment g = f;
  for (const double factor : q.by) {
    if (factor != 0) {
      sum.degree = std::max(sum.degree, g.degree);
      for (std::size_t i = 0; i <= static_cast<std::size_t>(g.degree); ++i)
        sum.c[i] += factor * g.c[i];
    }
    g = derivative(g);
    if (g.degree == 0 && g.c[0] == 0) break;
  }
  return sum;
}

SplineSpace::SplineSpace(std::vector<double> knots, int degree, int order, double size,
                         double offset)
    : knots_(std::move(knots)), degree_(degree), offset_(offset) {
  assert(knots_.size() >= 2 && degree_ >= 1 && degree_ <= Segment::max_degree && size > 0);
  const double per_length = 1 / (knots_.back() - knots_.front());
  double unit = size;
  for (std::size_t j = 0; j < sizes_.size(); ++j) {  // (3)
    sizes_[j] = power_of_two(unit);
    unit *= per_length * (j == 0 ? 1.0 : 4.0 * static_cast<double>(j));
  }
  units_.reserve(this->size() + 1);
  for (std::size_t i = 0; i <= pieces(); ++i)
    for (int j = 0; j <= degree_; ++j) {
      const double h = length(std::min(i, pieces() - 1));
      const double above = power_of_two(std::pow(h, std::max(0, j - order)));
      units_.push_back(sizes_[static_cast<std::size_t>(std::min(j, order))] / above);
    }
}

double SplineSpace::natural(const LinearQuantity& q) const {
  double sum = 0;
  for (int k = 0; k < static_cast<int>(q.by.size()) && k <= degree_; ++k)
    sum += std::abs(q.by[static_cast<std::size_t>(k)]) * sizes_[static_cast<std::size_t>(k)];
  return sum;
}

std::size_t SplineSpace::piece_at(double x) const {
  const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, x);
  return static_cast<std::size_t>(after - knots_.begin()) - 1;
}

Form SplineSpace::at(const LinearQuantity& q, std::size_t piece, double s) const {
  if (s == 1 && order_of(q) < degree_) return derivative_at(q, piece + 1, 0);
  Form form{q.constant + q.by[0] * offset_, {}};
  const double u = s * length(piece);
  for (int j = 0; j <= degree_; ++j) {
    double factor = 0;
    double power = 1;
    for (int k = j; k >= 0; --k, power *= u)
      if (k < static_cast<int>(q.by.size()))
        factor += q.by[static_cast<std::size_t>(k)] * over_factorial(power, j - k);
    if (factor != 0) form.terms.push_back({index(piece, j), factor * unit(piece, j)});
  }
  return form;
}

Form SplineSpace::derivative_at(const LinearQuantity& q, std::size_t piece, int j) const {
  Form form{j == 0 ? q.constant + q.by[0] * offset_ : 0, {}};
  for (int k = 0; k < static_cast<int>(q.by.size()) && k + j <= degree_; ++k)
    if (const double by = q.by[static_cast<std::size_t>(k)]; by != 0)
      form.terms.push_back({index(piece, k + j), by * unit(piece, k + j)});
  return form;
}

std::vector<Form> SplineSpace::squares(const LinearQuantity& q) const {
  std::vector<Form> all;
  const auto rule = jounce::cam_detail::gauss(degree_ + 1);
  for (std::size_t i = 0; i < pieces(); ++i)
    for (const auto& [s, weight] : rule)
      all.push_back(scaled(at(q, i, s), std::sqrt(weight * length(i))));
  return all;
}

std::vector<Form> SplineSpace::joints() const {
  std::vector<Form> all;
  for (std::size_t i = 0; i < pieces(); ++i)
    for (int j = 0; j < degree_; ++j) {
      Form form{0, {{index(i + 1, j), -1}}};
      double power = 1;
      for (int k = j; k <= degree_; ++k, power *= length(i))
        form.terms.push_back(
            {index(i, k), over_factorial(power, k - j) * unit(i, k) / unit(i + 1, j)});
      all.push_back(std::move(form));
    }
  return all;
}

std::vector<Form> SplineSpace::ends(const ShapeEnd& from, const ShapeEnd& to, bool periodic) const {
  std::vector<Form> all;
  const auto a = derivatives_of(from);
  const auto b = derivatives_of(to);
  for (int j = 0; j < degree_; ++j) {
    const auto fix = [&](std::size_t piece, double value) {
      if (j == 0) value -= offset_;
      all.push_back({-value / unit(piece, j), {{index(piece, j), 1}}});
    };
    const auto k = static_cast<std::size_t>(j);
    if (k < a.size() && a[k]) fix(0, *a[k]);
    if (k < b.size() && b[k]) fix(pieces(), *b[k]);
    const bool tied = k < a.size() && a[k] && b[k];
    if (periodic && j > 0 && !tied)
      all.push_back({0, {{index(pieces(), j), 1}, {index(0, j), -unit(0, j) / unit(pieces(), j)}}});
  }
  return all;
}

std::vector<Segment> SplineSpace::segments(const Coordinates& z) const {
  std::vector<Segment> all(pieces());
  for (std::size_t i = 0; i < pieces(); ++i) {
    Segment& f = all[i];
    f.length = length(i);
    f.degree = degree_;
    double power = 1;
    for (int j = 0; j <= degree_; ++j, power *= f.length)
      f.c[static_cast<std::size_t>(j)] = over_factorial(power, j) * unit(i, j) * z[index(i, j)];
    f.c[0] += offset_;
  }
  return all;
}

Coordinates SplineSpace::coordinates(const std::vector<Segment>& shape) const {
  Coordinates z(size());
  std::vector<double> breaks{knots_.front()};
  for (const Segment& f : shape) breaks.push_back(breaks.back() + f.length);
  for (std::size_t i = 0; i <= pieces(); ++i) {
    const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, knots_[i]);
    const auto own = static_cast<std::size_t>(after - breaks.begin()) - 1;
    const double s = std::clamp((knots_[i] - breaks[own]) / shape[own].length, 0.0, 1.0);
    Segment f = shape[own];
    for (int j = 0; j < degree_; ++j, f = derivative(f))
      z[index(i, j)] = (value(f, s) - (j == 0 ? offset_ : 0)) / unit(i, j);
  }
  for (std::size_t i = 0; i < pieces(); ++i)
    z[index(i, degree_)] = (z[index(i + 1, degree_ - 1)] * unit(i + 1, degree_ - 1) -
                            z[index(i, degree_ - 1)] * unit(i, degree_ - 1)) /
                           (unit(i, degree_) * length(i));
  return z;
}

Coordinates SplineSpace::propagated(Coordinates z) const {
  for (std::size_t i = 0; i < pieces(); ++i)
    for (int j = 0; j < degree_; ++j) {
      double sum = 0;
      double power = 1;
      for (int k = j; k <= degree_; ++k, power *= length(i))
        sum += over_factorial(power, k - j) * unit(i, k) / unit(i + 1, j) * z[index(i, k)];
      z[index(i + 1, j)] = sum;
    }
  return z;
}

std::array<std::optional<double>, 5> derivatives_of(const ShapeEnd& end) {
  return {end.value, end.velocity, end.acceleration, end.jerk, end.jounce};
}

}  // namespace jounce::optimize_detail
