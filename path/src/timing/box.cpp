// SPDX-License-Identifier: Apache-2.0
#include "path/src/timing/box.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/geometry/hull.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/rate.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_digit;
using profiles_detail::square;

constexpr double last_velocity_step = 1e-16;  ///< share of the velocity

/// What `used` leaves of a limit: 0 if it uses all of it, also with rounding. A rest of rounding size
/// would permit a velocity of rounding size.
double left_of(double limit, double used) {
  const double left = limit - used;
  return std::abs(left) < rounded_digit * limit ? 0 : left;
}

double or_none(const std::optional<double>& limit) {
  return limit.value_or(PathSettings::none);
}

/// The radius of an arc in the path axes.
double radius_of(const ArcNumbers& arc, std::size_t path_axes) {
  double cosine = 0;
  double sine = 0;
  for (std::size_t i = 0; i < path_axes; ++i) {
    cosine += square(arc.cosine(i));
    sine += square(arc.sine(i));
  }
  return std::sqrt(std::max(cosine, sine));
}

/// On a turn, |r'| is at most 1.
void bound_turn(std::size_t path_axes, Derivatives& bounds) {
  for (std::size_t i = 0; i < path_axes; ++i) bounds.bend += square(bounds.second[i]);
  bounds.bend = bounds.along = std::sqrt(bounds.bend);
}

}  // namespace

Rates rates_of(const GroupLimits& limits, std::size_t axes, std::size_t path_axes) {
  if (limits.axes.size() != axes)
    throw InputError("axes", std::to_string(limits.axes.size()),
                     "needs limits for each of the " + std::to_string(axes) + " axes");
  Rates rates{axes, path_axes, {}, {}, {}, limits.path};
  for (std::size_t i = 0; i < axes; ++i) {
    require_valid(limits.axes[i]);
    rates.velocity[i] = or_none(limits.axes[i].velocity);
    rates.acceleration[i] = or_none(limits.axes[i].acceleration);
    rates.jerk[i] = or_none(limits.axes[i].jerk);
    require_rate("velocity", rates.velocity[i]);
    require_rate("acceleration", rates.acceleration[i]);
    require_rate("jerk", rates.jerk[i]);
  }
  const PathLimits& p = limits.path;
  const std::pair<const char*, double> given[] = {{"velocity", p.velocity},
                                                  {"acceleration", p.acceleration},
                                                  {"deceleration", p.deceleration},
                                                  {"jerk", p.jerk},
                                                  {"normal_acceleration", p.normal_acceleration},
                                                  {"total_acceleration", p.total_acceleration}};
  for (const auto& [key, value] : given) require_rate(key, value);
  return rates;
}

Rates reserved(const Rates& rates) {
  Rates r = rates;
  for (std::size_t i = 0; i < r.axes; ++i)
    for (double* limit : {&r.velocity[i], &r.acceleration[i], &r.jerk[i]}) *limit *= 1 - fit_share;
  r.path.normal_acceleration *= 1 - fit_share;
  r.path.total_acceleration *= 1 - fit_share;
  return r;
}

bool limit_axes(std::span<const PathSettings> settings) {
  return std::ranges::any_of(settings, [](const PathSettings& s) { return !s.axes.empty(); });
}

Rates rates_on(Rates rates, const PathPiece& piece, std::span<const PathSettings> settings,
               bool corner) {
  const auto lower = [&](const PathSettings& by) {
    for (std::size_t i = 0; i < std::min(by.axes.size(), rates.axes); ++i) {
      rates.velocity[i] = std::min(rates.velocity[i], by.axes[i].velocity);
      rates.acceleration[i] = std::min(rates.acceleration[i], by.axes[i].acceleration);
      rates.jerk[i] = std::min(rates.jerk[i], by.axes[i].jerk);
    }
  };
  lower(settings[piece.settings]);
  if (corner) lower(settings[piece.settings_before]);
  return rates;
}

Box path_box(const Rates& rates, const PathSettings& settings) {
  const PathLimits& p = rates.path;
  double a = std::min(p.acceleration, settings.acceleration);
  double d = std::min(p.deceleration, settings.deceleration);
  if (d == PathSettings::none) d = a;
  a = std::min(a, p.total_acceleration);
  d = std::min(d, p.total_acceleration);
  return {std::min(p.velocity, settings.velocity), a, d, std::min(p.jerk, settings.jerk)};
}

Box line_box(const Rates& rates, const PathSettings& settings, const double* direction) {
  Box box = path_box(rates, settings);
  double a = PathSettings::none;
  for (std::size_t i = 0; i < rates.axes; ++i) {
    const double u = std::abs(direction[i]);
    if (u == 0) continue;
    box.velocity = std::min(box.velocity, rates.velocity[i] / u);
    a = std::min(a, rates.acceleration[i] / u);
    box.jerk = std::min(box.jerk, rates.jerk[i] / u);
  }
  box.acceleration = std::min(box.acceleration, a);
  box.deceleration = std::min(box.deceleration, a);
  return box;
}

void bound_vectors(std::span<const Segment> axes, Derivatives& bounds) {
  std::array<Segment, max_axes> slope;
  std::array<Segment, max_axes> bend;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    slope[i] = derivative(axes[i]);
    bend[i] = derivative(slope[i]);
  }
  const auto slopes = std::span<const Segment>(slope).first(axes.size());
  const auto bends = std::span<const Segment>(bend).first(axes.size());
  bounds.speed = std::sqrt(std::max(1.0, hull_of_products(slopes, slopes).second));
  bounds.bend = std::sqrt(std::max(0.0, hull_of_products(bends, bends).second));
  const auto [low, high] = hull_of_products(slopes, bends);
  bounds.along = std::max(-low, high);
}

Derivatives derivatives_of(const Path& path, std::size_t piece, std::size_t path_axes) {
  Derivatives bounds;
  const std::size_t n = path.axes();
  const PathPiece& p = path.pieces()[piece];
  const double* data = path.numbers(piece);
  if (p.kind == PieceKind::arc) {
    const ArcNumbers arc(data, n);
    const double k = arc.sweep() / p.length;
    for (std::size_t i = 0; i < n; ++i) {
      const double m = std::hypot(arc.cosine(i), arc.sine(i)) * k;
      bounds.first[i] = m + std::abs(arc.drift(i)) / p.length;
      bounds.second[i] = m * k;
      bounds.third[i] = m * k * k;
    }
    bounds.bend = radius_of(arc, path_axes) * k * k;
    return bounds;
  }
  std::vector<Segment> segments;
  segments.reserve(3);  // of a turn
  std::array<Segment, max_axes> axes;
  for (std::size_t i = 0; i < n; ++i) {
    segments.clear();
    path.segments(piece, i, segments);
    axes[i] = segments.front();
    for (const Segment& f : segments) {
      if (f.degree > 3) {
        const AxisPeaks peak = peaks_of(f);
        bounds.first[i] = std::max(bounds.first[i], peak.direction);
        bounds.second[i] = std::max(bounds.second[i], peak.curvature);
        bounds.third[i] = std::max(bounds.third[i], peak.rate);
        continue;
      }
      // Uses the range of the Bernstein coefficients of the first derivative; the higher
      // derivatives are linear and constant.
      const double h = f.length;
      for (const double b : {f.c[1], f.c[1] + f.c[2], f.c[1] + 2 * f.c[2] + 3 * f.c[3]})
        bounds.first[i] = std::max(bounds.first[i], std::abs(b) / h);
      for (const double b : {2 * f.c[2], 2 * f.c[2] + 6 * f.c[3]})
        bounds.second[i] = std::max(bounds.second[i], std::abs(b) / (h * h));
      bounds.third[i] = std::max(bounds.third[i], std::abs(6 * f.c[3]) / (h * h * h));
    }
  }
  if (p.kind == PieceKind::curve || p.kind == PieceKind::blend)
    bound_vectors(std::span(axes).first(path_axes), bounds);
  else if (p.kind == PieceKind::turn)
    bound_turn(path_axes, bounds);
  return bounds;
}

double velocity_with(const Rates& rates, const Derivatives& bounds, double acceleration,
                     double jerk) {
  double v = PathSettings::none;
  for (std::size_t i = 0; i < rates.axes; ++i) {
    const double r1 = bounds.first[i];
    const double r2 = bounds.second[i];
    const double r3 = bounds.third[i];
    if (r1 > 0) v = std::min(v, rates.velocity[i] / r1);
    const double a = left_of(rates.acceleration[i], r1 * acceleration);
    if (a < 0) return -1;
    if (r2 > 0) v = std::min(v, std::sqrt(a / r2));
    const double j = left_of(rates.jerk[i], r1 * jerk);
    if (j < 0) return -1;
    // r3 v^3 + 3 r2 a v = j is convex, so Newton's method converges from above.
    const double slope = 3 * r2 * acceleration;
    const auto used = [&](double x) { return (r3 * x * x + slope) * x; };
    if (used(v) <= j || (r3 == 0 && slope == 0)) continue;
    double x = std::min({v, std::cbrt(j / r3), j / slope});
    for (int step = 0; step < 8; ++step) {
      const double less = (used(x) - j) / (3 * r3 * x * x + slope);
      if (!(less > last_velocity_step * x)) break;
      x -= less;
    }
    v = x * (1 - rounded_digit);
  }
  if (!(bounds.bend > 0)) return v;
  v = std::min(v, std::sqrt(rates.path.normal_acceleration / bounds.bend));
  const double total = rates.path.total_acceleration;
  if (total == PathSettings::none) return v;
  // acceleration_squared() is at most total^2: a quadratic in v^2.
  const double left = total * total - square(bounds.speed * acceleration);
  if (left < 0) return -1;
  const double half = bounds.along * acceleration;
  return std::min(v,
                  std::sqrt(left / (half + std::sqrt(half * half + square(bounds.bend) * left))));
}

Box curve_box(const Rates& rates, const PathSettings& settings, const Derivatives& bounds,
              double length) {
  Box path = path_box(rates, settings);
  path.velocity /= bounds.speed;
  double most = path.acceleration;
  double jerk = path.jerk;
  for (std::size_t i = 0; i < rates.axes; ++i)
    if (bounds.first[i] > 0) {
      most = std::min(most, rates.acceleration[i] / bounds.first[i]);
      jerk = std::min(jerk, rates.jerk[i] / bounds.first[i]);
    }
  Box best = path;
  double shortest = PathSettings::none;
  for (const double gentle : {1.0, 0.9, 0.7, 0.5, 0.3})
    for (const double calm : {1.0, 0.9, 0.7, 0.5, 0.3}) {
      const double a = gentle * most;
      const double d = std::min(a, path.deceleration);
      const double j = calm * jerk;
      // No velocity gives a shorter time than this.
      const double least = std::max(length / path.velocity, 2 * std::sqrt(length / a)) + a / j;
      if (least >= shortest) continue;
      const double v = std::min(path.velocity, velocity_with(rates, bounds, a, j));
      if (!(v > 0) || !std::isfinite(a)) continue;
      const double time = length / v + v / a + a / j;
      if (time < shortest) {
        shortest = time;
        best = {v, a, d, j};
      }
    }
  return best;
}

Box blend_box(const Rates& rates, std::span<const Segment> axes) {
  Box box;
  box.constant = true;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const AxisPeaks peak = peaks_of(axes[i]);
    const auto limit = [](double l, double by) { return by > 0 ? l / by : PathSettings::none; };
    box.velocity = std::min({box.velocity, limit(rates.velocity[i], peak.direction),
                             std::sqrt(limit(rates.acceleration[i], peak.curvature)),
                             std::cbrt(limit(rates.jerk[i], peak.rate))});
  }
  const double normal = std::min(rates.path.normal_acceleration, rates.path.total_acceleration);
  if (!(normal < PathSettings::none)) return box;
  const double bend = greatest_bend(axes.first(rates.path_axes));
  if (bend > 0) box.velocity = std::min(box.velocity, std::sqrt(normal / bend));
  return box;
}

Limits effective(const Limits& global, const LimitFactors& factors) {
  require_positive("override", factors.override);
  require_positive("factor", factors.factor);
  const auto least = [&](const std::optional<double>& a, const std::optional<double>& m) {
    if (!a && !m) return std::optional<double>{};
    const double l = std::min(or_none(a), m ? factors.factor * *m : PathSettings::none);
    return std::optional(factors.override * l);
  };
  Limits limits = global;
  limits.velocity = least(factors.ancillary.velocity, global.velocity);
  limits.acceleration = least(factors.ancillary.acceleration, global.acceleration);
  limits.jerk = least(factors.ancillary.jerk, global.jerk);
  return limits;
}

PathLimits effective(const PathLimits& command, const PathLimits& ancillary, double override) {
  require_positive("override", override);
  const auto least = [&](double a, double c) { return override * std::min(a, c); };
  return {least(ancillary.velocity, command.velocity),
          least(ancillary.acceleration, command.acceleration),
          least(ancillary.deceleration, command.deceleration),
          least(ancillary.jerk, command.jerk),
          least(ancillary.normal_acceleration, command.normal_acceleration),
          least(ancillary.total_acceleration, command.total_acceleration)};
}

}  // namespace jounce
