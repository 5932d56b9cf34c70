// SPDX-License-Identifier: Apache-2.0
#include "path/proof/draw.hpp"

#include <algorithm>
#include <cmath>

#include "support/draw_until.hpp"

namespace jounce::path_proof {
namespace {

bool chance(Random& r, double probability) {
  return r.uniform(0, 1) < probability;
}

double direction_along(const Point& u, const Point& w) {
  double sum = 0;
  for (std::size_t i = 0; i < max_axes; ++i) sum += u[i] * w[i];
  return sum;
}

double length_of(const Point& u) {
  return std::sqrt(direction_along(u, u));
}

/// u + factor * w.
Point plus(Point u, double factor, const Point& w) {
  for (std::size_t i = 0; i < max_axes; ++i) u[i] += factor * w[i];
  return u;
}

/// A random direction of length 1 in the first axes.
Point direction(Random& r, std::size_t axes) {
  const auto once = [&r, axes] {
    Point u{};
    for (std::size_t i = 0; i < axes; ++i) u[i] = r.uniform(-1, 1);
    return u;
  };
  const Point u = test::draw_until(once, [](const Point& d) { return length_of(d) >= 0.1; });
  return plus({}, 1 / length_of(u), u);
}

/// A direction perpendicular to another one.
Point perpendicular(Random& r, std::size_t axes, const Point& u) {
  const auto once = [&r, axes, &u] {
    const Point w = direction(r, axes);
    return plus(w, -direction_along(u, w), u);
  };
  const Point n = test::draw_until(once, [](const Point& d) { return length_of(d) > 0.1; });
  return plus({}, 1 / length_of(n), n);
}

double some_rate(Random& r, double probability, double least, double most) {
  return chance(r, probability) ? r.log_uniform(least, most) : PathSettings::none;
}

/// Changes settings as a spec can: a limit that is given stays given.
void change(Random& r, double scale, PathSettings& s) {
  s.velocity = r.log_uniform(1, 1000);
  if (chance(r, 0.3) || std::isfinite(s.acceleration)) {
    s.acceleration = r.log_uniform(50, 1e4);
    s.deceleration = chance(r, 0.5) ? s.acceleration : r.log_uniform(50, 1e4);
  }
  if (chance(r, 0.2) || std::isfinite(s.jerk)) s.jerk = r.log_uniform(1e3, 1e6);
  const Corner corners[] = {Corner::stop, Corner::deviation, Corner::distance, Corner::curvature,
                            Corner::velocity};
  s.corner = corners[r.below(5)];
  s.value = s.corner == Corner::stop        ? 0
            : s.corner == Corner::velocity  ? r.log_uniform(0.1, 200)
            : s.corner == Corner::curvature ? 1 / (scale * r.log_uniform(1e-4, 1))
                                            : scale * r.log_uniform(1e-4, 1);
}

GroupLimits limits(Random& r, std::size_t axes) {
  GroupLimits l;
  for (std::size_t i = 0; i < axes; ++i)
    l.axes.push_back({.velocity = r.log_uniform(10, 1000),
                      .acceleration = r.log_uniform(100, 1e4),
                      .jerk = r.log_uniform(1e3, 1e6)});
  PathLimits& p = l.path;
  p.velocity = some_rate(r, 0.2, 10, 1000);
  p.acceleration = some_rate(r, 0.3, 50, 1e4);
  p.deceleration = chance(r, 0.3) ? r.log_uniform(50, 1e4) : p.acceleration;
  p.jerk = some_rate(r, 0.2, 1e3, 1e6);
  p.normal_acceleration = some_rate(r, 0.2, 50, 1e4);
  p.total_acceleration = some_rate(r, 0.2, 50, 1e4);
  return l;
}

/// An arc that begins in the direction `ahead`; returns its direction at the end.
Point tangent_arc(Random& r, const Case& c, double reach, const Point& ahead, const Point& from,
                  Leg& leg) {
  const Point normal = perpendicular(r, c.path_axes, ahead);
  const double sweep = r.log_uniform(0.05, 6);
  const double radius = reach / std::min(sweep, 2.0);
  const auto at = [&](double angle) {
    return plus(plus(from, radius * std::sin(angle), ahead), radius * (1 - std::cos(angle)),
                normal);
  };
  leg.shape = Leg::Shape::arc;
  leg.via = at(sweep / 2);
  leg.to = at(sweep);
  return plus(plus({}, std::cos(sweep), ahead), std::sin(sweep), normal);
}

/// Shares of the kinds of commands.
struct Mix {
  double arc = 0, spline = 0, straight = 0;
};

/// A command from `from`; `ahead` is the direction at its start, and becomes the direction at its end.
void shape(Random& r, const Case& c, const Mix& mix, double reach, const Point& from, Point& ahead,
           Leg& leg) {
  leg.to = from;
  const double kind = r.uniform(0, 1);
  if (kind < mix.arc) {
    const Point begin = chance(r, mix.straight) && direction_along(ahead, ahead) > 0
                            ? ahead
                            : direction(r, c.path_axes);
    ahead = tangent_arc(r, c, reach, begin, from, leg);
  } else if (kind < mix.arc + mix.spline) {
    leg.shape = Leg::Shape::spline;
    Point at = from;
    for (int i = r.below(4) + 1; i >= 0; --i) {
      at = plus(at, reach * r.uniform(0.5, 1), direction(r, c.path_axes));
      if (i > 0) leg.through.push_back(at);
    }
    leg.to = at;
    ahead = {};
  } else {
    if (!chance(r, mix.straight) || !(direction_along(ahead, ahead) > 0))
      ahead = direction(r, c.path_axes);
    leg.to = plus(from, reach, ahead);
  }
  for (std::size_t i = c.path_axes; i < c.axes; ++i) {
    leg.to[i] += r.below(3) > 0 ? r.uniform(-reach, reach) : 0;
    for (std::size_t k = 0; k < leg.through.size(); ++k)
      leg.through[k][i] = from[i] + (leg.to[i] - from[i]) * static_cast<double>(k + 1) /
                                        static_cast<double>(leg.through.size() + 1);
  }
}

Case mixed(Random& r, const Mix& mix, int most) {
  Case c;
  c.axes = c.path_axes = static_cast<std::size_t>(2 + r.below(2));
  if (mix.spline > 0 && chance(r, 0.3)) ++c.axes;
  const double scale = r.log_uniform(0.1, 100);
  for (std::size_t i = 0; i < c.axes; ++i)
    c.start[i] = chance(r, 0.5) ? 0 : scale * r.uniform(-10, 10);
  PathSettings settings;
  Point ahead{};
  for (int i = r.below(most) + 1; i > 0; --i) {
    if (c.legs.empty() || chance(r, 0.15)) change(r, scale, settings);
    Leg leg;
    leg.settings = settings;
    if (chance(r, 0.05)) leg.settings.junction = static_cast<Junction>(r.below(6));
    if (chance(r, 0.05)) leg.dwell = r.log_uniform(1e-3, 1);
    shape(r, c, mix, scale * r.log_uniform(0.01, 1), c.from(c.legs.size()), ahead, leg);
    c.legs.push_back(leg);
  }
  c.limits = limits(r, c.axes);
  return c;
}

}  // namespace

Case lines(Random& r) {
  Case c;
  c.axes = c.path_axes = static_cast<std::size_t>(1 + r.below(4));
  const double scale = r.log_uniform(0.1, 100);
  for (std::size_t i = 0; i < c.axes; ++i)
    c.start[i] = chance(r, 0.5) ? 0 : scale * r.uniform(-10, 10);
  PathSettings settings;
  for (int i = r.below(12); i >= 0; --i) {
    if (c.legs.empty() || chance(r, 0.15)) change(r, scale, settings);
    Leg leg;
    leg.settings = settings;
    if (chance(r, 0.05)) leg.settings.junction = Junction::buffered;
    if (chance(r, 0.05)) leg.dwell = r.log_uniform(1e-3, 1);
    const std::size_t at = c.legs.size();
    const double reach = scale * r.log_uniform(0.01, 1);
    leg.to = c.from(at);
    for (std::size_t k = 0; k < c.axes; ++k)
      if (chance(r, 0.8)) leg.to[k] += r.uniform(-reach, reach);
    if (leg.to == c.from(at)) leg.to[0] += reach;
    if (at > 0 && chance(r, 0.02)) leg.to = c.from(at - 1);  // back
    c.legs.push_back(leg);
  }
  c.limits = limits(r, c.axes);
  return c;
}

Case arcs(Random& r) {
  return mixed(r, {.arc = 0.4, .straight = 0.3}, 6);
}

Case curves(Random& r) {
  return mixed(r, {.arc = 0.2, .spline = 0.3, .straight = 0.3}, 4);
}

namespace {

/// Short lines along a curve. `jump`: probability of a sharp corner at the end of a line.
Case short_lines(Random& r, Corner corner, double jump) {
  Case c;
  c.axes = c.path_axes = static_cast<std::size_t>(2 + r.below(2));
  const double step = r.log_uniform(0.05, 5);
  Leg leg;
  leg.settings.velocity = r.log_uniform(10, 300);
  leg.settings.corner = corner;
  leg.settings.value = step * r.log_uniform(1e-3, 1);
  double turn = 0;
  double heading = r.uniform(0, 6);
  for (int i = r.below(60) + 2; i > 0; --i) {
    turn = chance(r, 0.1) ? r.uniform(-0.4, 0.4) : turn;
    heading += chance(r, jump) ? r.uniform(-3, 3) : turn;
    leg.to = c.from(c.legs.size());
    leg.to[0] += step * std::cos(heading);
    leg.to[1] += step * std::sin(heading);
    if (c.axes > 2) leg.to[2] += step * r.uniform(-0.1, 0.1);
    c.legs.push_back(leg);
  }
  c.limits = limits(r, c.axes);
  c.limits.path = {};
  return c;
}

}  // namespace

Case averages(Random& r) {
  return short_lines(r, Corner::average, 0.02);
}

Case dense(Random& r) {
  return short_lines(r, chance(r, 0.7) ? Corner::deviation : Corner::distance, 0);
}

Case narrow(Random& r) {
  Case c = lines(r);
  if (c.axes < 2) return c;
  const double far = r.log_uniform(1, 1e9);
  if (chance(r, 0.3))
    c = mapped(c, [&](Point p) {
      p[0] += far;
      return p;
    });
  for (std::size_t k = 1; k < c.legs.size(); ++k) {
    Point& to = c.legs[k].to;
    const Point& from = c.from(k);
    const Point& before = c.from(k - 1);
    const double small = r.log_uniform(1e-12, 1e-2);
    switch (r.below(5)) {
      case 0:  // near the previous point
        for (std::size_t i = 0; i < c.axes; ++i) to[i] = from[i] + small * r.uniform(-1, 1);
        break;
      case 1:  // nearly back
        to = before;
        to[1] += small * r.uniform(-1, 1);
        break;
      case 2:  // nearly straight
        to = plus(from, 1, plus(from, -1, before));
        to[1] += small * r.uniform(-1, 1);
        break;
      case 3:
        c.legs[k].settings.value *= 1e3;
        break;
      default:
        break;
    }
  }
  return c;
}

Case limited(Random& r, bool only_lines) {
  const int kind = only_lines ? 0 : r.below(8);
  Case c = kind < 5 ? lines(r) : kind < 7 ? arcs(r) : averages(r);
  std::vector<AxisRates> axes;
  const bool short_lines = kind == 7;
  for (Leg& leg : c.legs) {
    if (chance(r, short_lines ? 0.1 : 0.5)) {
      axes.resize(chance(r, 0.2) ? 0 : c.axes);
      for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto share = [&](double limit) {
          return chance(r, 0.5) ? limit * r.log_uniform(0.03, 1.5) : AxisRates::none;
        };
        const Limits& limits = c.limits.axes[i];
        axes[i] = {share(*limits.velocity), share(*limits.acceleration), share(*limits.jerk)};
      }
    }
    leg.settings.axes = axes;
  }
  return c;
}

std::vector<FactorRequest> steps(Random& r, double duration) {
  std::vector<FactorRequest> all;
  double t = duration * r.uniform(0, 0.3);
  for (int i = r.below(8); i >= 0; --i) {
    const int kind = r.below(5);
    all.push_back({t, kind == 0 ? 0 : kind == 1 ? 1 : r.uniform(0, 2)});
    t += duration * r.log_uniform(1e-4, 0.3);
  }
  all.push_back({t, 1});
  return all;
}

}  // namespace jounce::path_proof
