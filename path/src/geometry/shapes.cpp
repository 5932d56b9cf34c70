// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "jounce/cam/laws/spline.hpp"
#include "jounce/profiles/detail/hermite.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/geometry/gauss.hpp"
#include "path/src/geometry/hull.hpp"
#include "path/src/geometry/vector.hpp"

// An ellipse over its arc length s. With the speed w(t) = sqrt(a^2 sin^2 t + b^2 cos^2 t) with
// respect to its angle t,
//
//   (1)  dt/ds = 1 / w(t)
//
// The Taylor coefficients of t(s) follow one from another. Then x = a cos t(s), y = b sin t(s) have
// six coefficients at both ends of a piece, which define the Hermite polynomial of degree 11. This
// polynomial is the path. With X = x / a, Y = y / b,
//
//   (2)  its distance from the ellipse is at most
//        a |sqrt(X^2 + Y^2) - 1| <= a g / (1 + sqrt(1 - g)),   g >= |X^2 + Y^2 - 1|

namespace jounce {
namespace {

using profiles_detail::EndSeries;
using profiles_detail::rounded_input;

/// Taylor coefficients of cos and sin about t.
std::pair<EndSeries, EndSeries> cosine_and_sine(double t) {
  const double cs = std::cos(t);
  const double sn = std::sin(t);
  const double cycle[] = {cs, -sn, -cs, sn};
  EndSeries c{};
  EndSeries s{};
  double factor = 1;
  for (std::size_t k = 0; k < c.size(); ++k) {
    c[k] = factor * cycle[k % 4];
    s[k] = factor * cycle[(k + 3) % 4];
    factor /= static_cast<double>(k + 1);
  }
  return {c, s};
}

EndSeries product(const EndSeries& f, const EndSeries& g) {
  EndSeries h{};
  for (std::size_t i = 0; i < h.size(); ++i)
    for (std::size_t k = 0; i + k < h.size(); ++k) h[i + k] += f[i] * g[k];
  return h;
}

/// f^(-1/2), by h f' + 2 f h' = 0.
EndSeries inverse_root(const EndSeries& f) {
  EndSeries h{1 / std::sqrt(f[0])};
  for (std::size_t n = 1; n < h.size(); ++n) {
    double sum = 0;
    for (std::size_t k = 1; k <= n; ++k) {
      const double weight = 0.5 * static_cast<double>(k) + static_cast<double>(n - k);
      sum += weight * f[k] * h[n - k];
    }
    h[n] = -sum / (static_cast<double>(n) * f[0]);
  }
  return h;
}

struct Halves {
  double a, b;  ///< major and minor semi-axis

  [[nodiscard]] double speed(double t) const {
    return std::hypot(a * std::sin(t), b * std::cos(t));
  }

  /// Cosine and sine of the angle as series in the arc length, times `sense`, with `h` as the unit
  /// of length.
  [[nodiscard]] std::pair<EndSeries, EndSeries> series(double t, double sense, double h) const {
    const auto [c, s] = cosine_and_sine(t);
    EndSeries squared{};
    const EndSeries cc = product(c, c);
    const EndSeries ss = product(s, s);
    for (std::size_t k = 0; k < squared.size(); ++k) squared[k] = a * a * ss[k] + b * b * cc[k];
    const EndSeries rate = inverse_root(squared);  // 1 / w as a function of the angle
    EndSeries d{};
    for (std::size_t k = 0; k + 1 < d.size(); ++k)  // (1)
      d[k + 1] = sense * h * profiles_detail::substituted(rate, d)[k] / static_cast<double>(k + 1);
    return {profiles_detail::substituted(c, d), profiles_detail::substituted(s, d)};
  }

  /// Arc length between two angles that are at most 1/32 of a turn apart: Gauss quadrature with ten
  /// nodes on each half.
  [[nodiscard]] double length(double t0, double t1) const {
    double sum = 0;
    for (const double share : {0.25, 0.75})
      add_gauss(
          sum, [&](double t) { return speed(t); }, t0 + share * (t1 - t0), (t1 - t0) / 4);
    return sum * std::abs(t1 - t0) / 4;
  }
};

/// Sets the bound of the speed in the first `measured` axes.
void measure(PathCurve& curve, std::size_t measured) {
  for (std::size_t k = 0; k < curve.segments.size(); k += curve.axes) {
    const auto [low, high] = hull_of_speed_squared(std::span(curve.segments).subspan(k, measured));
    curve.speed_error =
        std::max({curve.speed_error, std::sqrt(high) - 1, 1 - std::sqrt(std::max(low, 0.0))});
  }
}

/// Number of axes in which the length of a spline is measured.
std::size_t measured_axes(std::span<const Point> points, std::size_t axes, std::size_t path_axes) {
  const bool moves = std::any_of(points.begin(), points.end(), [&](const Point& p) {
    return vec::distance(p, points.front(), path_axes) > 0;
  });
  return moves ? path_axes : axes;
}

}  // namespace

PathCurve spline_through(std::span<const Point> points, std::size_t axes,
                         const SplineDirections& ends, std::size_t path_axes) {
  if (axes < 1 || axes > max_axes) throw InputError("axes", std::to_string(axes), "must be 1 to 9");
  if (points.size() < 2)
    throw InputError("points", std::to_string(points.size()),
                     "must be at least 2: a start and an end");
  const std::size_t measured = measured_axes(points, axes, path_axes);
  std::vector<double> at{0};
  for (std::size_t k = 1; k < points.size(); ++k) {
    const double chord = vec::distance(points[k], points[k - 1], measured);
    if (!(chord > 0) || !std::isfinite(chord))
      throw InputError("points[" + std::to_string(k + 1) + "]", "",
                       measured == axes
                           ? "coincides with the point before it, or is not finite: remove it"
                           : "coincides with the point before it, except for followers, or is not "
                             "finite: remove it");
    at.push_back(at.back() + chord);
  }
  PathCurve curve;
  curve.axes = axes;
  curve.from = points.front();
  curve.to = points.back();
  curve.length = at.back();
  curve.segments.resize(axes * (points.size() - 1));
  const auto slope = [&](const std::optional<Point>& direction,
                         std::size_t i) -> std::optional<double> {
    if (!direction) return {};
    const double size = vec::norm(*direction, measured);
    require_positive("direction", size);
    return (*direction)[i] / size;
  };
  for (std::size_t i = 0; i < axes; ++i) {
    SplineSpec spec;
    for (std::size_t k = 0; k < points.size(); ++k) spec.points.push_back({at[k], points[k][i]});
    spec.start.geo_velocity = slope(ends.start, i);
    spec.end.geo_velocity = slope(ends.end, i);
    const std::vector<Segment> segments = cubic_spline(spec);
    for (std::size_t k = 0; k < segments.size(); ++k) curve.segments[k * axes + i] = segments[k];
  }
  measure(curve, measured);
  return curve;
}

PathCurve ellipse(const Point& from, const Point& center, const Point& to, Plane plane,
                  double degrees, double ratio, ArcRotation rotation, std::size_t axes,
                  const EllipseOptions& options) {
  const std::size_t measured = options.path_axes == 0 ? axes : options.path_axes;
  require_finite("angle", degrees);
  if (!(ratio > 0 && ratio <= 1))
    throw InputError("ratio", ratio, "must be greater than 0 and at most 1");
  if (plane.first >= measured || plane.second >= measured || plane.first == plane.second ||
      measured > axes || axes > max_axes)
    throw InputError("plane", std::to_string(plane.first) + ", " + std::to_string(plane.second),
                     "must be two different axes of the path that are not followers");
  if (options.extra_turns < 0)
    throw InputError("turns", std::to_string(options.extra_turns), "must not be negative");
  const double angle = degrees * (std::numbers::pi / 180);
  const double cs = std::cos(angle);
  const double sn = std::sin(angle);
  // Coordinates along the major axis, and perpendicular to it.
  const auto local = [&](const Point& p) {
    const double x = p[plane.first] - center[plane.first];
    const double y = p[plane.second] - center[plane.second];
    return std::pair(cs * x + sn * y, cs * y - sn * x);
  };
  const auto [x0, y0] = local(from);
  const auto [x1, y1] = local(to);
  const double a = std::hypot(x0, y0 / ratio);
  require_positive("center", a);
  const Halves half{a, a * ratio};
  const double off = std::hypot(x1 / half.a, y1 / half.b) - 1;
  if (!(std::abs(off) <= options.tolerance))
    throw InputError("to", number(to[plane.first]) + ", " + number(to[plane.second]),
                     "must lie on the ellipse through the start, but is " +
                         six_digits(100 * std::abs(off)) + " % of its size " +
                         (off < 0 ? "inside" : "outside") + "; at most " +
                         six_digits(100 * options.tolerance) + " % is permitted");
  const double sense = rotation == ArcRotation::counterclockwise ? 1 : -1;
  const double t0 = std::atan2(y0 / half.b, x0 / half.a);
  double sweep = sense * (std::atan2(y1 / half.b, x1 / half.a) - t0);
  if (std::hypot(x1 - x0, y1 - y0) <= rounded_input * a) sweep = 0;
  while (sweep <= 0) sweep += profiles_detail::two_pi;
  sweep += profiles_detail::two_pi * options.extra_turns;
  const int count = std::max(1, static_cast<int>(std::ceil(sweep / profiles_detail::two_pi * 32)));
  PathCurve curve;
  curve.axes = axes;
  curve.from = from;
  curve.to = to;
  std::vector<double> planar;
  for (int k = 0; k < count; ++k)
    planar.push_back(
        half.length(t0 + sense * sweep * k / count, t0 + sense * sweep * (k + 1) / count));
  double whole = 0;
  for (const double length : planar) whole += length;
  double drift = 0;
  for (std::size_t i = 0; i < measured; ++i)
    if (i != plane.first && i != plane.second) drift += profiles_detail::square(to[i] - from[i]);
  const double stretch = std::hypot(1.0, std::sqrt(drift) / whole);
  double gone = 0;
  double farthest = 0;
  for (int k = 0; k < count; ++k) {
    const double h = planar[static_cast<std::size_t>(k)];
    const auto [c0, s0] = half.series(t0 + sense * sweep * k / count, sense, h);
    const auto [c1, s1] = half.series(t0 + sense * sweep * (k + 1) / count, sense, h);
    const std::array unit{profiles_detail::hermite(h * stretch, c0, c1),
                          profiles_detail::hermite(h * stretch, s0, s1)};
    const auto [low, high] = hull_of_products(unit, unit);
    farthest = std::max({farthest, high - 1, 1 - low});
    for (std::size_t i = 0; i < axes; ++i) {
      Segment f = line(h * stretch, from[i] + (to[i] - from[i]) * (gone / whole),
                       from[i] + (to[i] - from[i]) * ((gone + h) / whole));
      if (i == plane.first || i == plane.second) {
        const bool first = i == plane.first;
        f = *sum(scaled(unit[0], half.a * (first ? cs : sn), center[i]),
                 scaled(unit[1], half.b * (first ? -sn : cs)));
      }
      curve.segments.push_back(f);
    }
    gone += h;
  }
  curve.length = whole * stretch;
  curve.deviation =
      half.a * (farthest < 1 ? farthest / (1 + std::sqrt(1 - farthest)) : farthest);  // (2)
  measure(curve, measured);
  return curve;
}

}  // namespace jounce
