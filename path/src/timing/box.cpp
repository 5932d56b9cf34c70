// SPDX-License-Identifier: Apache-2.0
#include "path/src/timing/box.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/geometry/hull.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/timing/stretch.hpp"

// On an arc an axis is  r = m sin(k q + p) + h q + const  (k the angle per q, m > 0):
//
//   r'   = m k cos + h,   r'' = -m k^2 sin,   r''' = -m k^3 cos,
//
// so with M = m k the acceleration r' a + r'' v^2 and the jerk r' j + 3 r'' v a + r''' v^3 are at most
//
//   (1)  M sqrt(a^2 + (k v^2)^2) + |h| a                              <= A
//   (2)  M sqrt((j + k^2 v^3)^2 + (3 k v a)^2) + |h| j                <= J
//
// (Cauchy and Schwarz; r''' and r' have opposite signs, so j + k^2 v^3 is the worse case). For given v (1) gives a,
// for given v and a (2) gives j. A slower arc leaves more for its ramps: of some velocities and accelerations that pair
// is taken with which the motion over the arc between the velocities of its ends, and what its neighbors lose by
// them, take the least time. Between two rests this is the fastest constant box, to the search's last step of 0.15 %.

namespace jounce {
namespace {

double or_none(const std::optional<double>& limit) {
  return limit.value_or(PathSettings::none);
}

/// The greatest x >= 0 with M sqrt((x + c)^2 + b^2) + h x <= L; negative if there is none. M, h >= 0.
double greatest_rate(double M, double h, double c, double b, double L) {
  if (L == PathSettings::none) return L;
  const double l = L + h * c;  // for y = x + c: M sqrt(y^2 + b^2) <= l - h y
  const double rest = l * l - M * M * b * b;
  if (rest < 0) return -1;
  const double spread = h * h * l * l + (M * M - h * h) * rest;
  const double divisor = h * l + std::sqrt(std::max(spread, 0.0));
  if (!(divisor > 0)) return M == 0 && h == 0 ? PathSettings::none : -1;
  return rest / divisor - c;
}

struct ArcAxis {
  double M, h;
};

/// a of (1) and j of (2) for the tightest axis; a given a larger than what (1) allows is reduced.
struct ArcRates {
  const Rates& rates;
  std::array<ArcAxis, max_axes> axis{};
  double k = 0;
  std::size_t n = 0;

  [[nodiscard]] double acceleration(double v) const {
    const double b = k * v * v;
    double a = rates.path.total_acceleration == PathSettings::none
                   ? PathSettings::none
                   : greatest_rate(1, 0, 0, b, rates.path.total_acceleration);
    for (std::size_t i = 0; i < n; ++i)
      a = std::min(a, greatest_rate(axis[i].M, axis[i].h, 0, b, rates.acceleration[i]));
    return a;
  }
  [[nodiscard]] double jerk(double v, double a) const {
    double j = PathSettings::none;
    for (std::size_t i = 0; i < n; ++i)
      j = std::min(
          j, greatest_rate(axis[i].M, axis[i].h, k * k * v * v * v, 3 * k * v * a, rates.jerk[i]));
    return j;
  }
  /// The acceleration at which (2) leaves no jerk.
  [[nodiscard]] double acceleration_of_jerk(double v) const {
    double a = PathSettings::none;
    for (std::size_t i = 0; i < n; ++i) {
      const double most = rates.jerk[i] / axis[i].M;
      if (!(most < PathSettings::none)) continue;
      const double normal = k * k * v * v * v;
      a = std::min(a, std::sqrt(std::max((most - normal) * (most + normal), 0.0)) / (3 * k * v));
    }
    return a;
  }
  /// The greatest constant velocity, by axis velocities, (1) and (2) with a = j = 0.
  [[nodiscard]] double velocity() const {
    double v =
        std::sqrt(std::min(rates.path.normal_acceleration, rates.path.total_acceleration) / k);
    for (std::size_t i = 0; i < n; ++i) {
      const auto [M, h] = axis[i];
      v = std::min(v, rates.velocity[i] / (M + h));
      if (M > 0) v = std::min(v, std::sqrt(rates.acceleration[i] / (M * k)));
      if (M > 0) v = std::min(v, std::cbrt(rates.jerk[i] / (M * k * k)));
    }
    return v;
  }
};

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
  }
  const PathLimits& p = limits.path;
  const std::pair<const char*, double> given[] = {{"velocity", p.velocity},
                                                  {"acceleration", p.acceleration},
                                                  {"deceleration", p.deceleration},
                                                  {"jerk", p.jerk},
                                                  {"normal_acceleration", p.normal_acceleration},
                                                  {"total_acceleration", p.total_acceleration}};
  for (const auto& [key, value] : given)
    if (!(value > 0)) throw InputError(key, value, "must be greater than 0");
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

namespace {

/// The box of path limits and settings alone.
Box path_box(const Rates& rates, const PathSettings& settings) {
  const PathLimits& p = rates.path;
  const double a = std::min({p.acceleration, settings.acceleration, p.total_acceleration});
  double d = std::min({p.deceleration, settings.deceleration, p.total_acceleration});
  if (d == PathSettings::none) d = a;
  return {std::min(p.velocity, settings.velocity), a, d, std::min(p.jerk, settings.jerk)};
}

}  // namespace

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

Box arc_box(const Rates& rates, const PathSettings& settings, const double* numbers, double length,
            double entry, double exit) {
  const ArcNumbers arc(numbers, rates.axes);
  ArcRates limits{rates};
  limits.n = rates.axes;
  limits.k = arc.sweep() / length;
  for (std::size_t i = 0; i < rates.axes; ++i)
    limits.axis[i] = {std::hypot(arc.cosine(i), arc.sine(i)) * limits.k,
                      std::abs(arc.drift(i)) / length};
  Box best = path_box(rates, settings);
  const Box path = best;
  const double slow_a = std::min(limits.acceleration(0), path.acceleration);  // a slow motion's
  const double slow_j = std::min(limits.jerk(0, 0), path.jerk);
  const double most = std::min(path.velocity, limits.velocity());
  const double beyond = std::min(path.velocity, 2 * most);  // velocity of the neighbors
  if (!(slow_a > 0) || !(slow_j > 0) || !std::isfinite(slow_a) || !std::isfinite(most)) return best;
  double fastest = most;
  const double share = (entry == 0) + (exit == 0);
  if (share > 0)
    fastest = std::min(fastest,
                       entry_velocity(length / share, 0, Ramp{slow_a, slow_j}).value_or(fastest));
  const auto lost = [&](double v) {  // on a neighbor, where the motion is only at v here
    return ramp_time(beyond - v, slow_a, slow_j) -
           ramp_distance(v, beyond, slow_a, slow_j) / beyond;
  };
  double shortest = PathSettings::none;
  double best_v = 0;
  double best_a = 0;
  const auto consider = [&](double v, double gentle) {
    const double greatest =
        gentle * std::min(limits.acceleration(v), limits.acceleration_of_jerk(v));
    const double a = std::min(greatest, path.acceleration);
    const double d = std::min(greatest, path.deceleration);
    if (!(a > 0) || !(v <= fastest)) return;
    const double j = std::min(limits.jerk(v, std::max(a, d)), path.jerk);
    if (!(j > 0)) return;
    const double v0 = std::min(v, entry);
    const double v1 = std::min(v, exit);
    const double cruise = length - ramp_distance(v0, v, a, j) - ramp_distance(v1, v, d, j);
    double time = 0;
    if (cruise >= 0) {
      time = ramp_time(v - v0, a, j) + ramp_time(v - v1, d, j) + cruise / v +
             (v0 > 0 ? lost(v0) : 0) + (v1 > 0 ? lost(v1) : 0) +
             (share < 2 ? 0.01 * ramp_time(v, std::min(a, d), j) : 0);  // other ramps
    } else if (share == 2) {                                            // v is not reached
      const double least = std::min(a, d);
      time = 2 * ramp_time(entry_velocity(length / 2, 0, Ramp{least, j}).value_or(v), least, j);
    } else {
      return;  // a slower box reaches its velocity
    }
    if (!(time < shortest * (1 - 1e-9))) return;  // more than rounding
    shortest = time;
    best_v = v;
    best_a = gentle;
    best = {v, a, d, j};
  };
  for (const double v :
       {1.0, 0.99, 0.97, 0.94, 0.9, 0.8, 0.7, 0.6, 0.5, 0.35, 0.2, 0.1, 0.05, 0.02, 0.01, 0.001})
    for (const double gentle : {0.99, 0.9, 0.75, 0.6, 0.45, 0.3, 0.15})
      consider(v * fastest, gentle);
  for (const double step : {0.1, 0.05, 0.025, 0.0125, 0.006, 0.003, 0.0015})
    for (int round = 0; round < 2; ++round)
      for (const double v : {1 - step, 1.0, 1 + step})
        for (const double gentle : {1 - step, 1.0, 1 + step})
          consider(best_v * v, std::min(1.0, best_a * gentle));
  return best;
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
    return bounds;
  }
  std::vector<Segment> segments;
  std::array<Segment, max_axes> axes;
  for (std::size_t i = 0; i < n; ++i) {
    segments.clear();
    path.segments(piece, i, segments);
    axes[i] = segments.front();
    for (const Segment& f : segments) {
      if (f.degree > 3) {
        const Peaks peak = peaks_of(f);
        bounds.first[i] = std::max(bounds.first[i], peak.direction);
        bounds.second[i] = std::max(bounds.second[i], peak.curvature);
        bounds.third[i] = std::max(bounds.third[i], peak.rate);
        continue;
      }
      // The hull of the Bernstein coefficients of the first derivative; the others are linear and constant.
      const double h = f.length;
      for (const double b : {f.c[1], f.c[1] + f.c[2], f.c[1] + 2 * f.c[2] + 3 * f.c[3]})
        bounds.first[i] = std::max(bounds.first[i], std::abs(b) / h);
      for (const double b : {2 * f.c[2], 2 * f.c[2] + 6 * f.c[3]})
        bounds.second[i] = std::max(bounds.second[i], std::abs(b) / (h * h));
      bounds.third[i] = std::max(bounds.third[i], std::abs(6 * f.c[3]) / (h * h * h));
    }
  }
  if (p.kind == PieceKind::curve || p.kind == PieceKind::blend)
    bounds.speed =
        std::sqrt(std::max(1.0, hull_of_speed_squared(std::span(axes).first(path_axes)).second));
  return bounds;
}

double velocity_with(const Rates& rates, const Derivatives& bounds, double acceleration,
                     double jerk) {
  double v = PathSettings::none;
  double bend = 0;
  for (std::size_t i = 0; i < rates.axes; ++i) {
    const double r1 = bounds.first[i];
    const double r2 = bounds.second[i];
    const double r3 = bounds.third[i];
    if (i < rates.path_axes) bend += r2 * r2;
    if (r1 > 0) v = std::min(v, rates.velocity[i] / r1);
    const double a = rates.acceleration[i] - r1 * acceleration;
    if (a < 0) return -1;
    if (r2 > 0) v = std::min(v, std::sqrt(a / r2));
    const double j = rates.jerk[i] - r1 * jerk;
    if (j < 0) return -1;
    // r3 v^3 + 3 r2 a v = j: convex, Newton from above.
    const double slope = 3 * r2 * acceleration;
    const auto used = [&](double x) { return (r3 * x * x + slope) * x; };
    if (used(v) <= j || (r3 == 0 && slope == 0)) continue;
    double x = std::min({v, std::cbrt(j / r3), j / slope});
    for (int step = 0; step < 8; ++step) x -= (used(x) - j) / (3 * r3 * x * x + slope);
    v = x * (1 - 1e-15);
  }
  const double total = rates.path.total_acceleration;
  const double left = total < PathSettings::none
                          ? std::sqrt(std::max(total * total - acceleration * acceleration, 0.0))
                          : total;
  if (bend > 0)
    v = std::min(v, std::sqrt(std::min(rates.path.normal_acceleration, left) / std::sqrt(bend)));
  return v;
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
  double bend = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Peaks peak = peaks_of(axes[i]);
    const auto limit = [](double l, double by) { return by > 0 ? l / by : PathSettings::none; };
    box.velocity = std::min({box.velocity, limit(rates.velocity[i], peak.direction),
                             std::sqrt(limit(rates.acceleration[i], peak.curvature)),
                             std::cbrt(limit(rates.jerk[i], peak.rate))});
    if (i < rates.path_axes) bend += peak.curvature * peak.curvature;
  }
  const double normal = std::min(rates.path.normal_acceleration, rates.path.total_acceleration);
  if (bend > 0) box.velocity = std::min(box.velocity, std::sqrt(normal / std::sqrt(bend)));
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
