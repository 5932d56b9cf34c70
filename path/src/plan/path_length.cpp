// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/path_length.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/detail/hermite.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/corners/turn.hpp"
#include "path/src/geometry/hull.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/timing/box.hpp"

// Let g = |r'|^2, a polynomial of s from 0 to 1 on a piece or a part of it. The speed f = g^(1/2) is
// replaced by the polynomial p of degree 10 with its values at the 11 Chebyshev nodes, and the length
// by the integral of p. With M >= |f^(11)| / 11!,
//
//   (1)  |f - p| <= M |(s - s_0) ... (s - s_10)| <= M 2 / 4^11
//
// Let m > 0 be a lower bound of g, and G_k bounds of its Taylor coefficients at any place. There,
//
//   (2)  f(s + d) = g^(1/2) (1 + w)^(1/2),   |coefficient k of w| <= A_k = G_k / g,   k >= 1
//
// The coefficients of (1 + w)^(1/2) are at most those of H = 1 - (1 - A)^(1/2), and
//
//   (3)  H = (A + H^2) / 2,   M = m^(1/2) H_11
//
// In (2), g^(1/2) times a product of j >= 1 factors G / g falls with g, so g may be replaced by m.
// The piece is halved until (1) is below the tolerance. Near a place where the path stands (m = 0), a
// part is so short that its whole length is below the tolerance.

namespace jounce {
namespace {

using profiles_detail::Majorant;
using profiles_detail::rounded_root;

constexpr std::size_t nodes = 11;
/// Square of the length of a direction of path axes: 1, or 0 if only followers move.
constexpr double least_direction = 0.5;

/// The path axes of a piece in s from 0 to 1, or of a part of it: their first derivatives by q.
struct Slopes {
  std::array<Segment, max_axes> of{};
  std::size_t axes = 0;

  [[nodiscard]] std::span<const Segment> all() const { return std::span(of).first(axes); }
  [[nodiscard]] double speed(double s) const {
    double square = 0;
    for (const Segment& f : all()) square += value(f, s) * value(f, s);
    return std::sqrt(square);
  }
};

Slopes slopes_of(std::span<const Segment> axes, double from, double to) {
  Slopes slopes;
  for (const Segment& f : axes) slopes.of[slopes.axes++] = derivative(part(f, from, to));
  return slopes;
}

/// M of (3) for a lower bound m of g.
double majorant_of(const Slopes& slopes, double m) {
  Majorant A{};
  for (const Segment& f : slopes.all()) {
    const Majorant r = profiles_detail::majorant(f, 1);
    for (std::size_t i = 0; i < r.size(); ++i)
      for (std::size_t k = 0; i + k < r.size(); ++k) A[i + k] += r[i] * r[k] / m;
  }
  Majorant H{};
  for (std::size_t n = 1; n <= nodes; ++n) {
    H[n] = A[n] / 2;
    for (std::size_t i = 1; i < n; ++i) H[n] += H[i] * H[n - i] / 2;
  }
  return std::sqrt(m) * H[nodes];
}

/// A bound of the error of the length over an extent in q.
double error_of(const Slopes& slopes, double extent) {
  const auto [low, high] = hull_of_products(slopes.all(), slopes.all());
  const double whole = std::sqrt(std::max(0.0, high)) * extent;
  if (!(low > 0)) return whole;
  return std::min(whole, majorant_of(slopes, low) * std::ldexp(extent, 1 - 2 * int{nodes}));
}

/// The coefficients of p: Newton's interpolation.
std::array<double, nodes> interpolated(const Slopes& slopes) {
  std::array<double, nodes> x{};
  std::array<double, nodes> d{};
  for (std::size_t i = 0; i < nodes; ++i) {
    x[i] = (1 - std::cos((2 * static_cast<double>(i) + 1) * std::numbers::pi / (2 * nodes))) / 2;
    d[i] = slopes.speed(x[i]);
  }
  for (std::size_t k = 1; k < nodes; ++k)
    for (std::size_t i = nodes - 1; i >= k; --i) d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - k]);
  std::array<double, nodes> p{};
  for (std::size_t k = nodes; k-- > 0;) {  // p = p (s - x_k) + d_k
    for (std::size_t i = nodes - 1; i > 0; --i) p[i] = p[i - 1] - x[k] * p[i];
    p[0] = d[k] - x[k] * p[0];
  }
  return p;
}

/// True if q is not the length on this piece.
bool differs(const Path& path, std::size_t piece, std::size_t path_axes) {
  const PieceKind kind = path.pieces()[piece].kind;
  if (kind != PieceKind::turn) return kind == PieceKind::blend || kind == PieceKind::curve;
  const TurnNumbers turn(path.numbers(piece), path.axes());
  double before = 0;
  double after = 0;
  for (std::size_t i = 0; i < path_axes; ++i) {
    before += turn.before(i) * turn.before(i);
    after += turn.after(i) * turn.after(i);
  }
  return std::min(before, after) > least_direction;  // otherwise a side moves only followers
}

}  // namespace

PathLength::PathLength(const Plan& plan) {
  const Path& path = plan.drawn();
  const std::size_t n = plan.given().path_axes;
  std::array<std::vector<Segment>, max_axes> segments;
  std::array<Segment, max_axes> axes;
  for (std::size_t k = 0; k < path.pieces().size(); ++k) {
    const PathPiece& piece = path.pieces()[k];
    end_.q = piece.start;
    if (!differs(path, k, n)) {
      add_plain(piece.length);
      continue;
    }
    for (std::size_t i = 0; i < n; ++i) {
      segments[i].clear();
      path.segments(k, i, segments[i]);
    }
    for (std::size_t part = 0; part < segments[0].size(); ++part) {
      for (std::size_t i = 0; i < n; ++i) axes[i] = segments[i][part];
      add_curved(std::span(axes).first(n), axes[0].length, rounded_root * piece.length);
    }
  }
}

void PathLength::append(Part part, double length) {
  part.start = end_.q;
  part.before = end_.length;
  parts_.push_back(part);
  end_.q += part.extent;
  end_.length += length;
}

void PathLength::add_plain(double extent) {
  if (parts_.empty() || !parts_.back().plain) return append({.extent = extent}, extent);
  Part& last = parts_.back();
  last.extent = end_.q - last.start + extent;
  end_ = {last.start + last.extent, last.before + last.extent};
}

void PathLength::add_curved(std::span<const Segment> axes, double extent, double tolerance) {
  // Halves from the left: places are multiples of a power of 1/2, without rounding.
  double step = 1;
  for (double from = 0; from < 1;) {
    const Slopes slopes = slopes_of(axes, from, from + step);
    const double error = error_of(slopes, step * extent);
    if (error > tolerance) {
      step /= 2;
      continue;
    }
    add_polynomial(interpolated(slopes), step * extent);
    error_ += error;
    from += step;
    while (step < 1 && std::fmod(from, 2 * step) == 0) step *= 2;
  }
}

void PathLength::add_polynomial(std::span<const double, numbers - 1> speed, double extent) {
  const std::size_t first = coefficients_.size();
  double length = 0;
  for (std::size_t k = 0; k < speed.size(); ++k) {
    coefficients_.push_back(extent * speed[k] / static_cast<double>(k + 1));
    length += coefficients_.back();
  }
  append({.extent = extent, .plain = false, .first = first}, length);
}

PathLength::Place PathLength::at(double q) const noexcept {
  const auto behind = std::upper_bound(parts_.begin() + 1, parts_.end(), q,
                                       [](double x, const Part& p) { return x < p.start; });
  const Part& part = *std::prev(behind);
  const double u = std::clamp(q - part.start, 0.0, part.extent);
  if (part.plain) return {part.before + u, 1};
  const double s = u / part.extent;
  double length = 0;
  double slope = 0;
  for (std::size_t k = numbers - 1; k-- > 0;) {
    slope = slope * s + coefficients_[part.first + k] * static_cast<double>(k + 1);
    length = length * s + coefficients_[part.first + k];
  }
  return {part.before + length * s, slope / part.extent};
}

Curve<OverLength> PathLength::curve() const {
  std::vector<Segment> segments;
  for (const Part& part : parts_) {
    segments.push_back(line(part.extent, part.before, part.before + part.extent));
    if (part.plain) continue;
    Segment& f = segments.back();
    f.degree = Segment::max_degree;
    for (std::size_t k = 0; k + 1 < numbers; ++k) f.c[k + 1] = coefficients_[part.first + k];
  }
  return Curve<OverLength>(std::move(segments), 0, Extrapolation::hold);
}

Fitted<OverTime> length_over_time(const Plan& plan) {
  const PathLength length(plan);
  const double tolerance =
      profiles_detail::rounded_sum * std::max(length.whole(), plan.path().length());
  Fitted<OverTime> fit = composed_within(length.curve(), plan.law().curve(), tolerance);
  fit.error[0] += length.error();
  return fit;
}

}  // namespace jounce
