// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/path_length.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/corners/turn.hpp"
#include "path/src/geometry/pieces.hpp"

// Let g = |r'|^2, a polynomial, and f = g^(1/2) the speed. On a part of a piece, x from -1 to 1, f is
// replaced by the polynomial p of degree 10 with its values at the 11 Chebyshev nodes, and the length by
// the integral of p. If f is analytic and |f| <= M in the ellipse with the foci -1 and 1 and the half axes
// (r + 1/r) / 2 and (r - 1/r) / 2, the Chebyshev coefficients of f are at most 2 M r^-k, and
//
//   (1)  |f - p| <= 4 M r^-10 / (r - 1)
//
// (Trefethen, Approximation Theory and Approximation Practice, theorems 8.1 and 8.2). Let b_k be the
// coefficients of g in x, and R = (r + 1/r) / 2, the greatest |x| in the ellipse. If
//
//   (2)  S = sum over k >= 1 of |b_k| R^k < b_0,
//
// g has no zero there, so f is analytic, and M^2 = b_0 + S. The piece is halved until (2) holds. Near a
// place where the path stands (g = 0), a part is so short that its whole length is below the tolerance.

namespace jounce {
namespace {

using profiles_detail::rounded_root;

constexpr std::size_t nodes = 11;
constexpr double ellipse = 10;  ///< r of (1)
/// Square of the length of a direction of path axes: 1, or 0 if only followers move.
constexpr double least_direction = 0.5;

/// g as a polynomial.
struct SpeedSquared {
  std::array<double, 2 * Segment::max_degree - 1> c{};
  std::size_t count = 1;

  [[nodiscard]] double at(double x) const {
    double g = 0;
    for (std::size_t k = count; k-- > 0;) g = g * x + c[k];
    return g;
  }
  /// The sum of |c_k| reach^k for k >= 1.
  [[nodiscard]] double swing(double reach) const {
    double sum = 0;
    for (std::size_t k = count; k-- > 1;) sum = (sum + std::abs(c[k])) * reach;
    return sum;
  }
};

SpeedSquared speed_squared(std::span<const Segment> axes) {
  SpeedSquared g;
  for (const Segment& axis : axes) {
    const Segment f = derivative(axis);
    const auto n = static_cast<std::size_t>(f.degree) + 1;
    g.count = std::max(g.count, 2 * n - 1);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) g.c[i + k] += f.c[i] * f.c[k];
  }
  return g;
}

/// g as a polynomial of x on the part of this middle and half width.
SpeedSquared about(SpeedSquared g, double middle, double half) {
  for (std::size_t i = 0; i + 1 < g.count; ++i)
    for (std::size_t k = g.count - 1; k-- > i;) g.c[k] += middle * g.c[k + 1];
  double scale = 1;
  for (std::size_t k = 1; k < g.count; ++k) g.c[k] *= scale *= half;
  return g;
}

/// A bound of the error of the length over an extent in q; nullopt if (2) does not hold and the part is longer than the
/// tolerance.
std::optional<double> error_of(const SpeedSquared& g, double extent, double tolerance) {
  static const double share = 4 * std::pow(ellipse, 1 - int{nodes}) / (ellipse - 1);
  const double swing = g.swing((ellipse + 1 / ellipse) / 2);
  if (swing < g.c[0]) return share * std::sqrt(g.c[0] + swing) * extent;
  const double whole = std::sqrt(std::max(0.0, g.c[0] + g.swing(1))) * extent;
  return whole <= tolerance ? std::optional(whole) : std::nullopt;
}

/// The Chebyshev nodes from 0 to 1, and the inverse distances of node i and node i - k.
struct Nodes {
  std::array<double, nodes> x{};
  std::array<std::array<double, nodes>, nodes> inverse{};

  Nodes() {
    for (std::size_t i = 0; i < nodes; ++i)
      x[i] = (1 - std::cos((2 * static_cast<double>(i) + 1) * std::numbers::pi / (2 * nodes))) / 2;
    for (std::size_t k = 1; k < nodes; ++k)
      for (std::size_t i = k; i < nodes; ++i) inverse[k][i] = 1 / (x[i] - x[i - k]);
  }
};

/// The coefficients of p over s from 0 to 1: Newton's interpolation.
std::array<double, nodes> interpolated(const SpeedSquared& g) {
  static const Nodes at;
  std::array<double, nodes> d{};
  for (std::size_t i = 0; i < nodes; ++i) d[i] = std::sqrt(std::max(0.0, g.at(2 * at.x[i] - 1)));
  for (std::size_t k = 1; k < nodes; ++k)
    for (std::size_t i = nodes - 1; i >= k; --i) d[i] = (d[i] - d[i - 1]) * at.inverse[k][i];
  std::array<double, nodes> p{};
  for (std::size_t k = nodes; k-- > 0;) {  // p = p (s - x_k) + d_k
    for (std::size_t i = nodes - 1; i > 0; --i) p[i] = p[i - 1] - at.x[k] * p[i];
    p[0] = d[k] - at.x[k] * p[0];
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
  const SpeedSquared whole = speed_squared(axes);
  // Halves from the left: places are multiples of a power of 1/2, without rounding.
  double step = 1;
  for (double from = 0; from < 1;) {
    const SpeedSquared g = about(whole, from + step / 2, step / 2);
    const auto error = error_of(g, step * extent, tolerance);
    if (!error) {
      step /= 2;
      continue;
    }
    add_polynomial(interpolated(g), step * extent);
    error_ += *error;
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
