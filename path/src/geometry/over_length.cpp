// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string>

#include "jounce/path/shapes.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/geometry/gauss.hpp"
#include "path/src/geometry/hull.hpp"
#include "path/src/geometry/septic.hpp"
#include "path/src/geometry/vector.hpp"
#include "path/src/maps/series_map.hpp"

// A polynomial curve r(t) over its arc length. x in [0, 1] is the position in a part of length h.
// With the speed w = |r'|,
//
//   (1)  dt/dx = h / w(t)
//
// gives the coefficients of t(x) one after another. If t is an interval that contains the whole
// part, they enclose the eighth coefficient of r(t(x)), which bounds the distance of its polynomial
// of degree 7.

namespace jounce {
namespace {

using path_detail::Interval;
using path_detail::Series;

template <class T, std::size_t n>
Series<T, n> at_series(std::span<const double> c, const Series<T, n>& t) {
  Series<T, n> sum;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * t + Series<T, n>(c[k]);
  return sum;
}

/// The axes of a part as functions of x, (1): expansions about t for numbers, enclosures of the
/// whole part for an interval.
template <class T, std::size_t n>
std::array<Series<T, n>, max_axes> by_length(std::span<const Segment> axes, std::size_t measured,
                                             const T& at, double h) {
  std::array<std::array<double, Segment::max_degree + 1>, max_axes> slope{};
  std::array<std::size_t, max_axes> terms{};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    terms[i] = static_cast<std::size_t>(axes[i].degree);
    for (std::size_t k = 0; k < terms[i]; ++k)
      slope[i][k] = static_cast<double>(k + 1) * axes[i].c[k + 1];
  }
  Series<T, n> t;
  t[0] = at;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    Series<T, n> square;
    for (std::size_t i = 0; i < measured; ++i)
      square = square + squared(at_series<T, n>(std::span(slope[i]).first(terms[i]), t));
    const Series<T, n> rate = Series<T, n>(h) / root(square);
    t[k + 1] = rate[k] / T(static_cast<double>(k + 1));
  }
  std::array<Series<T, n>, max_axes> out;
  for (std::size_t i = 0; i < axes.size(); ++i)
    out[i] = at_series<T, n>(std::span(axes[i].c).first(terms[i] + 1), t);
  return out;
}

class OverArcLength {
 public:
  OverArcLength(const PathCurve& curve, std::size_t measured, double tolerance)
      : from_(curve), measured_(measured), tolerance_(tolerance) {
    made_.axes = curve.axes;
    made_.from = curve.from;
    made_.to = curve.to;
    made_.deviation = curve.deviation;
  }

  PathCurve run() {
    for (std::size_t k = 0; k < from_.segments.size(); k += from_.axes)
      divide(std::span(from_.segments).subspan(k, from_.axes), 0);
    made_.deviation += farthest_;
    return std::move(made_);
  }

 private:
  /// Arc length of a part, by Gauss quadrature with ten nodes.
  [[nodiscard]] double length_of(std::span<const Segment> axes, double from, double to) const {
    const auto speed = [&](double s) {
      double square = 0;
      for (std::size_t i = 0; i < measured_; ++i)
        square += profiles_detail::square(evaluate(axes[i], s)[1] * axes[i].length);
      return std::sqrt(square);
    };
    double sum = 0;
    add_gauss(sum, speed, (from + to) / 2, (to - from) / 2);
    return sum * (to - from) / 2;
  }

  void divide(std::span<const Segment> axes, int depth) {
    const double coarse = length_of(axes, 0, 1);
    const double h = length_of(axes, 0, 0.5) + length_of(axes, 0.5, 1);
    double square = 0;
    const auto bound = by_length<Interval, 9>(axes, measured_, Interval(0, 1), h);
    for (std::size_t i = 0; i < axes.size(); ++i)
      square += profiles_detail::square(bound[i][8].magnitude() * septic_error);
    // An error of the length shifts the point along the curve.
    const double error = std::sqrt(square) + std::abs(h - coarse);
    if (!(error <= tolerance_)) {
      if (depth > 40)
        throw InputError("point", h,
                         "makes a cusp: the curve comes to a standstill within this length");
      for (const double from : {0.0, 0.5}) {
        std::array<Segment, max_axes> half;
        for (std::size_t i = 0; i < axes.size(); ++i) half[i] = part(axes[i], from, from + 0.5);
        divide(std::span(half).first(axes.size()), depth + 1);
      }
      return;
    }
    farthest_ = std::max(farthest_, error);
    const auto begin = by_length<double, 4>(axes, measured_, 0.0, h);
    const auto end = by_length<double, 4>(axes, measured_, 1.0, h);
    const auto jet = [&](const Series<double, 4>& c) {
      return Jet{c[0], c[1] / h, 2 * c[2] / (h * h), 6 * c[3] / (h * h * h)};
    };
    const std::size_t first = made_.segments.size();
    for (std::size_t i = 0; i < axes.size(); ++i)
      made_.segments.push_back(septic(h, jet(begin[i]), jet(end[i])));
    const auto [low, high] =
        hull_of_speed_squared(std::span(made_.segments).subspan(first, measured_));
    made_.speed_error =
        std::max({made_.speed_error, std::sqrt(high) - 1, 1 - std::sqrt(std::max(low, 0.0))});
    made_.length += h;
  }

  const PathCurve& from_;
  std::size_t measured_;
  double tolerance_;
  PathCurve made_;
  double farthest_ = 0;
};

/// The polar form of one span of a B-spline at `degree` arguments.
double blossom(std::span<const double> control, std::span<const double> knots, std::size_t span,
               std::span<const double> arguments) {
  const std::size_t p = arguments.size();
  std::array<double, Segment::max_degree + 1> d{};
  for (std::size_t j = 0; j <= p; ++j) d[j] = control[span - p + j];
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t j = p; j >= r; --j) {
      const double low = knots[span - p + j];
      const double high = knots[span + 1 + j - r];
      const double share = (arguments[r - 1] - low) / (high - low);
      d[j] = (1 - share) * d[j - 1] + share * d[j];
    }
  return d[p];
}

std::vector<double> clamped_knots(std::size_t points, std::size_t degree) {
  std::vector<double> knots(degree + 1, 0.0);
  for (std::size_t k = 1; k < points - degree; ++k) knots.push_back(static_cast<double>(k));
  knots.insert(knots.end(), degree + 1, static_cast<double>(points - degree));
  return knots;
}

void require_knots(std::span<const double> knots, std::size_t points, std::size_t degree) {
  if (knots.size() != points + degree + 1)
    throw InputError("knots", std::to_string(knots.size()),
                     "must be " + std::to_string(points + degree + 1) +
                         ": the number of points, the degree and one more");
  const std::size_t last = knots.size() - 1;
  for (std::size_t k = 0; k < last; ++k) {
    const bool end = k < degree || k >= last - degree;
    require_finite("knots", knots[k]);
    if (end ? knots[k + 1] != knots[k] : !(knots[k + 1] > knots[k]))
      throw InputError("knots", knots[k + 1],
                       "must ascend, each one time, between two ends that occur " +
                           std::to_string(degree + 1) + " times");
  }
}

/// True if one of the first `count` axes moves.
bool moves(const PathCurve& curve, std::size_t count) {
  for (std::size_t k = 0; k < curve.segments.size(); ++k) {
    const Segment& f = curve.segments[k];
    const auto slopes = std::span(f.c).subspan(1, static_cast<std::size_t>(f.degree));
    if (k % curve.axes < count &&
        std::any_of(slopes.begin(), slopes.end(), [](double c) { return c != 0; }))
      return true;
  }
  return false;
}

}  // namespace

PathCurve over_length(const PathCurve& curve, double tolerance, std::size_t path_axes) {
  require_positive("tolerance", tolerance);
  const std::size_t measured = moves(curve, path_axes) ? path_axes : curve.axes;
  return OverArcLength(curve, measured, tolerance).run();
}

PathCurve b_spline(std::span<const Point> points, std::size_t axes, std::size_t degree,
                   std::span<const double> knots) {
  if (degree < 3 || degree > 7)
    throw InputError("degree", std::to_string(degree),
                     "must be 3 to 7, for a curvature without steps");
  if (points.size() <= degree || axes < 1 || axes > max_axes)
    throw InputError("point", std::to_string(points.size()),
                     "a B-spline of degree " + std::to_string(degree) + " needs " +
                         std::to_string(degree + 1) + " points or more with its start");
  const std::vector<double> own = clamped_knots(points.size(), degree);
  if (knots.empty()) knots = own;
  require_knots(knots, points.size(), degree);
  PathCurve curve;
  curve.axes = axes;
  curve.from = points.front();
  curve.to = points.back();
  std::vector<double> control(points.size());
  std::vector<std::vector<Segment>> by_axis(axes);
  for (std::size_t i = 0; i < axes; ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      require_finite("point", points[k][i]);
      control[k] = points[k][i];
    }
    for (std::size_t span = degree; span < points.size(); ++span) {
      std::array<double, Segment::max_degree + 1> b{};  // Bezier points
      std::array<double, Segment::max_degree> arguments{};
      for (std::size_t j = 0; j <= degree; ++j) {
        for (std::size_t k = 0; k < degree; ++k) arguments[k] = knots[k < j ? span + 1 : span];
        b[j] = blossom(control, knots, span, std::span(arguments).first(degree));
      }
      Segment f;
      f.length = knots[span + 1] - knots[span];
      f.degree = static_cast<int>(degree);
      double binomial = 1;
      for (std::size_t k = 0; k <= degree; ++k) {  // differences of the Bezier points
        f.c[k] = binomial * b[0];
        for (std::size_t j = 0; j + 1 <= degree - k; ++j) b[j] = b[j + 1] - b[j];
        binomial = binomial * static_cast<double>(degree - k) / static_cast<double>(k + 1);
      }
      by_axis[i].push_back(f);
    }
  }
  for (std::size_t k = 0; k < by_axis[0].size(); ++k) {
    for (std::size_t i = 0; i < axes; ++i) curve.segments.push_back(by_axis[i][k]);
    curve.length += by_axis[0][k].length;
  }
  return curve;
}

}  // namespace jounce
