// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/b_spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"

#include "cam/src/design/table.hpp"

// Between two different knots t_j < t_(j+1), a B-spline of degree p is a polynomial f with a
// blossom F(u1, ..., up): symmetric, affine in each argument, and f(x) = F(x, ..., x) (Ramshaw
// 1989). Its values at consecutive knots are the control values, d_i = F(t_(i+1), ..., t_(i+p)). De
// Boor's step replaces a knot by u:
//
//   (1)  d_i <- (1 - w) d_(i-1) + w d_i,   w = (u - t_i) / (t_(i+p+1-r) - t_i)   in round r
//
// so the Bezier values of the interval are
//
//   (2)  b_k = F(t_j (p - k times), t_(j+1) (k times)),   k = 0 ... p
//
// All are convex combinations: nothing cancels. With s in [0, 1] along the interval
//
//   (3)  f = sum_k C(p, k) (k-th forward difference of b at 0) s^k
//
// Interpolation: sum_i d_i B_i(x_k) = y_k. Each B_i has p + 1 intervals, so the matrix is banded;
// it is totally positive and, with t_i < x_i < t_(i+p+1) for all i, invertible (Schoenberg,
// Whitney), so that elimination without pivots is stable (de Boor, Pinkus 1977).

namespace jounce {
namespace {

constexpr int max_interpolating = 7;
using Values = std::array<double, Segment::max_degree + 1>;

std::string counted(const char* name, std::size_t i) {
  return std::string(name) + "[" + std::to_string(i + 1) + "]";
}

void require_finite_values(const char* name, std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    require_finite(counted(name, i).c_str(), values[i]);
}

void require_degree(int degree, int least, int most) {
  if (degree < least || degree > most)
    throw InputError("degree", degree,
                     "must be " + std::to_string(least) + " to " + std::to_string(most));
}

void require_count(const char* name, std::size_t count, std::size_t wanted) {
  if (count != wanted)
    throw InputError(name, std::to_string(count) + " values", "must be " + std::to_string(wanted));
}

void require_valid(const BSplineSpec& spec) {
  require_degree(spec.degree, 1, Segment::max_degree);
  const auto p = static_cast<std::size_t>(spec.degree);
  if (spec.control.size() < p + 1)
    throw InputError("control", std::to_string(spec.control.size()) + " values",
                     "must be at least " + std::to_string(p + 1) + ", one more than the degree");
  require_count("knots", spec.knots.size(), spec.control.size() + p + 1);
  require_finite_values("knots", spec.knots);
  require_finite_values("control", spec.control);
  const std::vector<double>& t = spec.knots;
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t[i] < t[i - 1])
      throw InputError(counted("knots", i), t[i],
                       "must not be less than " + number(t[i - 1]) + ", the previous knot");
  for (std::size_t i = p + 1; i < spec.control.size(); ++i)
    if (t[i] > t[p] && t[i] < t[spec.control.size()] && t[i] == t[i + p])
      throw InputError(counted("knots", i), t[i],
                       "occurs more than " + std::to_string(p) + " times: the curve would break");
  if (!(t[p] < t[spec.control.size()]))
    throw InputError(
        counted("knots", p), t[p],
        "must be less than " + counted("knots", spec.control.size()) + ", where the curve ends");
}

/// Equation (2): one Bezier value of the interval [t_j, t_(j+1)].
double blossom(const BSplineSpec& spec, std::size_t j, int at_end) {
  const std::vector<double>& t = spec.knots;
  const auto p = static_cast<std::size_t>(spec.degree);
  Values d{};
  for (std::size_t i = 0; i <= p; ++i) d[i] = spec.control[j - p + i];
  for (std::size_t r = 1; r <= p; ++r) {
    const double u = t[static_cast<int>(r) <= at_end ? j + 1 : j];
    for (std::size_t i = p; i >= r; --i) {
      const double from = t[j - p + i];
      const double w = (u - from) / (t[j + 1 + i - r] - from);
      d[i] = (1 - w) * d[i - 1] + w * d[i];  // (1)
    }
  }
  return d[p];
}

/// The values at x, in (t_j, t_(j+1)] or at t_j, of the B-splines j - p ... j: de Boor's
/// recurrence.
Values basis(const std::vector<double>& t, std::size_t p, std::size_t j, double x) {
  Values b{};
  b[0] = 1;
  for (std::size_t r = 1; r <= p; ++r) {
    double carried = 0;
    for (std::size_t i = 0; i < r; ++i) {
      const double right = t[j + 1 + i] - x;
      const double left = x - t[j + 1 + i - r];
      const double share = b[i] / (right + left);
      b[i] = carried + right * share;
      carried = left * share;
    }
    b[r] = carried;
  }
  return b;
}

/// Knots at which the interpolating spline of the given degree always exists.
std::vector<double> knots_for(const std::vector<SplinePoint>& points, std::size_t p) {
  const std::size_t n = points.size();
  std::vector<double> t(p + 1, points.front().master);
  for (std::size_t i = 0; i + p + 1 < n; ++i) {
    const std::size_t k = i + (p + 1) / 2;
    t.push_back(p % 2 == 1 ? points[k].master
                           : points[k].master + (points[k + 1].master - points[k].master) / 2);
  }
  t.insert(t.end(), p + 1, points.back().master);
  return t;
}

/// Rows of a banded matrix: entry (i, k) is at row[i][k - first[i]], with first ascending.
struct Banded {
  std::vector<Values> row;
  std::vector<std::size_t> first;
};

void eliminate(Banded& a, std::vector<double>& y, std::size_t width) {
  const std::size_t n = y.size();
  const auto entry = [&](std::size_t i, std::size_t k) -> double& {
    return a.row[i][k - a.first[i]];
  };
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n && a.first[i] <= k; ++i) {
      const double factor = entry(i, k) / entry(k, k);
      // The previous row ends no later: first ascends.
      for (std::size_t c = k + 1; c < a.first[k] + width; ++c) entry(i, c) -= factor * entry(k, c);
      y[i] -= factor * y[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t c = k + 1; c < std::min(n, a.first[k] + width); ++c)
      y[k] -= entry(k, c) * y[c];
    y[k] /= entry(k, k);
  }
}

}  // namespace

Segment bezier(double length, std::span<const double> control) {
  require_positive("length", length);
  if (control.empty() || control.size() > Segment::max_degree + 1)
    throw InputError("control", std::to_string(control.size()) + " values", "must be 1 to 12");
  require_finite_values("control", control);
  Values b{};
  std::copy(control.begin(), control.end(), b.begin());
  Segment f;
  f.length = length;
  f.degree = static_cast<int>(control.size()) - 1;
  double binomial = 1;
  for (std::size_t k = 0; k < control.size(); ++k) {  // (3)
    f.c[k] = binomial * b[0];
    for (std::size_t i = 0; i + 1 < control.size() - k; ++i) b[i] = b[i + 1] - b[i];
    binomial = binomial * static_cast<double>(control.size() - 1 - k) / static_cast<double>(k + 1);
  }
  return f;
}

std::vector<Segment> bezier_chain(std::span<const double> breaks, std::span<const double> control,
                                  int degree) {
  require_degree(degree, 1, Segment::max_degree);
  if (breaks.size() < 2)
    throw InputError("breaks", std::to_string(breaks.size()) + " values", "must be at least 2");
  require_finite_values("breaks", breaks);
  const auto p = static_cast<std::size_t>(degree);
  require_count("control", control.size(), (breaks.size() - 1) * p + 1);
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (!(breaks[i + 1] > breaks[i]))
      throw InputError(counted("breaks", i + 1), breaks[i + 1],
                       "must be greater than " + number(breaks[i]) + ", the previous break");
    segments.push_back(bezier(breaks[i + 1] - breaks[i], control.subspan(i * p, p + 1)));
  }
  return segments;
}

std::vector<Segment> b_spline(const BSplineSpec& spec) {
  require_valid(spec);
  const auto p = static_cast<std::size_t>(spec.degree);
  std::vector<Segment> segments;
  for (std::size_t j = p; j < spec.control.size(); ++j) {
    const double length = spec.knots[j + 1] - spec.knots[j];
    if (!(length > 0)) continue;
    Values b{};
    for (int k = 0; k <= spec.degree; ++k) b[static_cast<std::size_t>(k)] = blossom(spec, j, k);
    segments.push_back(bezier(length, std::span(b).first(p + 1)));
  }
  return segments;
}

BSplineSpec interpolating_b_spline(const std::vector<SplinePoint>& points, int degree) {
  require_degree(degree, 1, max_interpolating);
  const auto p = static_cast<std::size_t>(degree);
  cam_detail::require_points(points, p + 1, false);
  BSplineSpec spec{degree, knots_for(points, p), {}};
  Banded a;
  for (const SplinePoint& point : points) {
    const auto inner = spec.knots.begin() + degree + 1;
    const auto above = std::upper_bound(inner, spec.knots.end() - degree - 1, point.master);
    const auto j = static_cast<std::size_t>(above - spec.knots.begin()) - 1;
    a.row.push_back(basis(spec.knots, p, j, point.master));
    a.first.push_back(j - p);
    spec.control.push_back(point.slave);
  }
  eliminate(a, spec.control, p + 1);
  return spec;
}

}  // namespace jounce
