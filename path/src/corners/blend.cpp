// SPDX-License-Identifier: Apache-2.0
#include "path/src/corners/blend.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/vector.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
/// The product f g of two polynomials; the degree of the product must fit into a Segment.
Segment product(const Segment& f, const Segment& g) {
  Segment h;
  h.length = f.length;
  h.degree = f.degree + g.degree;
  for (int i = 0; i <= f.degree; ++i)
    for (int k = 0; k <= g.degree; ++k)
      h.c[static_cast<std::size_t>(i + k)] +=
          f.c[static_cast<std::size_t>(i)] * g.c[static_cast<std::size_t>(k)];
  return h;
}

/// The sum of the squares of several polynomials.
Segment squares(std::span<const Segment> axes) {
  Segment total;
  total.length = axes.front().length;
  for (const Segment& f : axes) {
    const Segment h = product(f, f);
    total.degree = std::max(total.degree, h.degree);
    for (std::size_t i = 0; i < total.c.size(); ++i) total.c[i] += h.c[i];
  }
  return total;
}

Range range_of(const Segment& f, int order = 0) {
  return segment_range(f, 0, f.length, order);
}

std::array<Segment, max_axes> relative(std::span<const Segment> axes, const Point& p) {
  std::array<Segment, max_axes> r;
  for (std::size_t i = 0; i < axes.size(); ++i) r[i] = scaled(axes[i], 1, -p[i]);
  return r;
}

/// r(from + distance) - r(from) on a piece. It has all digits at any distance of the piece from 0, and if it is a tiny
/// share of the piece: the third derivative of a blend divides it by the cube of a length.
Point step_on(const Path& route, std::size_t k, double from, double distance) {
  const PathPiece& piece = route.pieces()[k];
  const double* data = route.numbers(k);
  const std::size_t n = route.axes();
  const double share = distance / piece.length;
  const double s0 = from / piece.length;
  const double s1 = s0 + share;
  Point step{};
  if (piece.kind == PieceKind::line) {
    for (std::size_t i = 0; i < n; ++i) step[i] = data[n + i] * share;
  } else if (piece.kind == PieceKind::arc) {
    const ArcNumbers arc(data, n);
    const double half = arc.sweep() * share / 2;
    const double middle = arc.phase() + arc.sweep() * (s0 + s1) / 2;
    const double chord = 2 * std::sin(half);
    for (std::size_t i = 0; i < n; ++i)
      step[i] = chord * (arc.sine(i) * std::cos(middle) - arc.cosine(i) * std::sin(middle)) +
                arc.drift(i) * share;
  } else {
    const auto degree = static_cast<std::size_t>(data[0]);
    for (std::size_t i = 0; i < n; ++i) {
      double mean = 1;   // (s1^m - s0^m) / (s1 - s0)
      double power = 1;  // s0^(m - 1)
      for (std::size_t m = 1; m <= degree; ++m) {
        step[i] += data[1 + i * (degree + 1) + m] * mean * share;
        power *= s0;
        mean = s1 * mean + power;
      }
    }
  }
  return step;
}

}  // namespace

Blend blend_of(const Path& route, std::size_t k, double trim) {
  std::array<Jet, max_axes> before{};
  std::array<Jet, max_axes> behind{};
  const std::size_t n = route.axes();
  route.jets(k, route.pieces()[k].length - trim, std::span(before).first(n));
  route.jets(k + 1, trim, std::span(behind).first(n));
  const Point in = step_on(route, k, route.pieces()[k].length - trim, trim);
  const Point out = step_on(route, k + 1, 0, trim);
  Blend blend;
  blend.count = n;
  blend.trim = trim;
  for (std::size_t i = 0; i < n; ++i) {
    blend.axes[i] = quintic(2 * trim, 0, before[i][1], before[i][2], in[i] + out[i], behind[i][1],
                            behind[i][2]);
    blend.axes[i].c[0] = before[i][0];
  }
  return blend;
}

double least_distance(std::span<const Segment> axes, const Point& p, std::size_t n) {
  const auto r = relative(axes.first(n), p);
  const Range range = range_of(squares(std::span(r).first(n)));
  // The root of the least square has half of its digits: the distance of the place has all of them.
  Point at{};
  for (std::size_t i = 0; i < n; ++i) at[i] = value(r[i], range.min.where / r[i].length);
  return vec::norm(at, n);
}

double greatest_speed(std::span<const Segment> axes, std::size_t n) {
  std::array<Segment, max_axes> slope;
  for (std::size_t i = 0; i < n; ++i) {
    slope[i] = derivative(axes[i]);
    slope[i].length = axes[i].length;
  }
  return std::sqrt(range_of(squares(std::span(slope).first(n))).max.value);
}

double greatest_bend(std::span<const Segment> axes) {
  std::array<Segment, max_axes> bend;
  for (std::size_t i = 0; i < axes.size(); ++i) bend[i] = derivative(derivative(axes[i]));
  return std::sqrt(std::max(range_of(squares(std::span(bend).first(axes.size()))).max.value, 0.0));
}

AxisPeaks peaks_of(const Segment& axis) {
  const auto peak = [&](int order) { return std::abs(range_of(axis, order).peak().value); };
  return {peak(1), peak(2), peak(3)};
}

double greatest_curvature(std::span<const Segment> axes, std::size_t n) {
  const auto curvature = [&](double s) {
    double vv = 0;
    double va = 0;
    double aa = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Jet f = evaluate(axes[i], s);
      vv += f[1] * f[1];
      va += f[1] * f[2];
      aa += f[2] * f[2];
    }
    return std::sqrt(std::max(vv * aa - va * va, 0.0)) / (vv * std::sqrt(vv));
  };
  constexpr int samples = 64;
  int best = 0;
  double peak = 0;
  for (int i = 0; i <= samples; ++i)
    if (const double k = curvature(static_cast<double>(i) / samples); k > peak) {
      peak = k;
      best = i;
    }
  double a = std::max(0, best - 1) / static_cast<double>(samples);
  double b = std::min(samples, best + 1) / static_cast<double>(samples);
  for (int i = 0; i < 40; ++i) {  // golden section search
    const double x = b - 0.6180339887498949 * (b - a);
    const double y = a + 0.6180339887498949 * (b - a);
    (curvature(x) < curvature(y) ? a : b) = curvature(x) < curvature(y) ? x : y;
  }
  return std::max(peak, curvature((a + b) / 2));
}

double distance_from_sides(const Path& route, std::size_t k, const Blend& blend, std::size_t n) {
  double farthest = 0;
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    std::array<Segment, max_axes> half;
    for (std::size_t i = 0; i < blend.count; ++i)
      half[i] = part(blend.axes[i], side == 0 ? 0 : 0.5, side == 0 ? 0.5 : 1);
    const PathPiece& piece = route.pieces()[k + side];
    std::array<Jet, max_axes> jet{};
    const double u = side == 0 ? piece.length - blend.trim : blend.trim;
    route.jets(k + side, u, std::span(jet).first(route.axes()));
    Point at{};
    Point tangent{};
    Point bend{};
    for (std::size_t i = 0; i < n; ++i) {
      at[i] = jet[i][0];
      tangent[i] = jet[i][1];
      bend[i] = jet[i][2];
    }
    double distance = 0;
    if (piece.kind == PieceKind::arc && std::abs(vec::norm(tangent) - 1) < rounded_input) {
      // From the circle: the radial and the axial distance.
      const double kk = vec::dot(bend, bend);
      const Point center = vec::sum(at, bend, 1 / kk);
      const double radius = 1 / std::sqrt(kk);
      const Point e1 = vec::scaled(bend, radius);
      std::array<Segment, 2> plane;
      std::array<Segment, max_axes> off = relative(std::span(half).first(n), center);
      for (std::size_t c = 0; c < 2; ++c) {
        const Point& e = c == 0 ? e1 : tangent;
        plane[c].length = half[0].length;
        plane[c].degree = 5;
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t m = 0; m <= 5; ++m) plane[c].c[m] += e[i] * off[i].c[m];
      }
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t m = 0; m <= 5; ++m)
          off[i].c[m] -= e1[i] * plane[0].c[m] + tangent[i] * plane[1].c[m];
      const Range in_plane = range_of(squares(plane));
      const double axial = range_of(squares(std::span(off).first(n))).max.value;
      const double radial =
          std::max(std::abs(std::sqrt(in_plane.max.value) - radius),
                   std::abs(std::sqrt(std::max(in_plane.min.value, 0.0)) - radius));
      distance = std::sqrt(radial * radial + std::max(axial, 0.0));
    } else {
      // From the tangent at the trim, plus what the piece leaves the tangent by: 0 for a line.
      std::array<Segment, max_axes> off = relative(std::span(half).first(n), at);
      Segment along;
      along.length = half[0].length;
      along.degree = 5;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t m = 0; m <= 5; ++m) along.c[m] += tangent[i] * off[i].c[m];
      const double tt = vec::dot(tangent, tangent);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t m = 0; m <= 5; ++m) off[i].c[m] -= tangent[i] / tt * along.c[m];
      distance = std::sqrt(std::max(range_of(squares(std::span(off).first(n))).max.value, 0.0)) +
                 vec::norm(bend) * blend.trim * blend.trim / 2;
    }
    farthest = std::max(farthest, distance);
  }
  return farthest;
}

}  // namespace jounce
