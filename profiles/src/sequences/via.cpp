// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/via.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "profiles/src/curve/magnitude.hpp"
#include "profiles/src/sequences/sequence.hpp"
#include "profiles/src/sequences/stretches.hpp"

// One axis. Between two turning points, the shortest motion through all points is the shortest
// motion from the first to the last of them. It does not reverse, so it passes the others anyway.
// Only the acceleration at the turning points, where the velocity is 0, can be chosen: with a = 0
// the axis would brake and start more gently than necessary.
//
// Several axes pass a point at the same instant, which the shortest motions of the single axes do
// not do. So every point is a knot of the search (stretches.cpp).

namespace jounce {
namespace {

using profiles_detail::Knot;

std::string key(std::size_t point) {
  return "points[" + std::to_string(point + 1) + "]";
}

void require_valid_point(const ViaSpec& spec, std::size_t k) {
  const auto& point = spec.points[k];
  if (point.size() != spec.axes.size())
    throw InputError(
        key(k), "",
        "must have a position for each axis, " + std::to_string(spec.axes.size()) + " in all");
  for (std::size_t i = 0; i < point.size(); ++i) {
    const std::string name = key(k) + "[" + std::to_string(i + 1) + "]";
    profiles_detail::require_moderate(name, point[i]);
    if (point[i] < spec.axes[i].position_min)
      throw InputError(
          name, point[i],
          "must be at least position_min = " + number(spec.axes[i].position_min) + " of its axis");
    if (point[i] > spec.axes[i].position_max)
      throw InputError(
          name, point[i],
          "must be at most position_max = " + number(spec.axes[i].position_max) + " of its axis");
  }
  if (k > 0 && point == spec.points[k - 1])
    throw InputError(key(k), "", "must differ from the previous point");
}

/// Checks the magnitude of each bound; move_to() checks the signs, and that the bounds agree.
void require_magnitudes(const Bounds& b, const std::string& axis) {
  const std::pair<const char*, double> values[] = {{"velocity_min", b.velocity_min},
                                                   {"velocity_max", b.velocity_max},
                                                   {"acceleration_min", b.acceleration_min},
                                                   {"acceleration_max", b.acceleration_max},
                                                   {"jerk_min", b.jerk_min},
                                                   {"jerk_max", b.jerk_max}};
  for (const auto& [name, value] : values) {
    if (std::isfinite(value) && value != 0 && !profiles_detail::is_magnitude(std::abs(value)))
      throw InputError(axis + "." + name, value,
                       "must be between 1e-30 and 1e30 in magnitude, or infinite");
  }
}

void require_one_each(const ViaSpec& spec, const std::vector<double>& rates,
                      const std::string& name) {
  if (!rates.empty() && rates.size() != spec.axes.size())
    throw InputError(
        name, "",
        "must have a number for each axis, " + std::to_string(spec.axes.size()) + " in all");
  for (const double rate : rates) profiles_detail::require_moderate(name, rate);
}

void require_valid_stretches(const ViaSpec& spec) {
  if (spec.stretches.empty()) return;
  if (spec.stretches.size() + 1 != spec.points.size())
    throw InputError("stretches", std::to_string(spec.stretches.size()),
                     "must be one less than the points");
  for (std::size_t k = 0; k < spec.stretches.size(); ++k) {
    const std::string name = "stretches[" + std::to_string(k + 1) + "]";
    if (spec.stretches[k].size() != spec.axes.size())
      throw InputError(name, "", "must have bounds for each axis");
    for (const Bounds& bounds : spec.stretches[k]) require_magnitudes(bounds, name);
  }
}

void require_valid_norm(const Limits& norm) {
  for (const auto& [name, position] : {std::pair{"norm.position_min", norm.position_min},
                                       {"norm.position_max", norm.position_max}})
    if (position)
      throw InputError(name, *position, "does not limit a norm: use the bounds of the axes");
  for (const auto& [name, value] : {std::pair{"norm.velocity", norm.velocity},
                                    {"norm.acceleration", norm.acceleration},
                                    {"norm.jerk", norm.jerk}})
    if (value &&
        (!(*value > 0) || (std::isfinite(*value) && !profiles_detail::is_magnitude(*value))))
      throw InputError(name, *value, "must be between 1e-30 and 1e30, or infinite");
}

void require_valid(const ViaSpec& spec) {
  if (spec.axes.empty()) throw InputError("axes", "none", "a motion needs an axis");
  for (std::size_t i = 0; i < spec.axes.size(); ++i)
    require_magnitudes(spec.axes[i], "axes[" + std::to_string(i + 1) + "]");
  if (spec.points.size() < 2) throw InputError("points", "", "a motion needs at least two points");
  for (std::size_t k = 0; k < spec.points.size(); ++k) require_valid_point(spec, k);
  for (const auto& [rates, name] : {std::pair{&spec.start, "start."}, {&spec.end, "end."}}) {
    require_one_each(spec, rates->velocity, std::string(name) + "velocity");
    require_one_each(spec, rates->acceleration, std::string(name) + "acceleration");
  }
  require_valid_stretches(spec);
  require_valid_norm(spec.norm);
}

/// The bounds of an axis that goes `share` of the distance under limits of the norm. They do not limit an axis that
/// does not move.
Bounds within_norm(Bounds b, const Limits& norm, double share) {
  if (!(share > 0)) return b;
  const auto limit = [share](std::optional<double> norm_limit, double& min, double& max) {
    const double most = share * norm_limit.value_or(Bounds::none);
    min = std::max(min, -most);
    max = std::min(max, most);
  };
  limit(norm.velocity, b.velocity_min, b.velocity_max);
  limit(norm.acceleration, b.acceleration_min, b.acceleration_max);
  limit(norm.jerk, b.jerk_min, b.jerk_max);
  return b;
}

/// The bounds of each axis on each stretch.
profiles_detail::StretchBounds stretch_bounds(const ViaSpec& spec) {
  profiles_detail::StretchBounds all;
  for (std::size_t k = 0; k + 1 < spec.points.size(); ++k) {
    all.push_back(spec.stretches.empty() ? spec.axes : spec.stretches[k]);
    double way = 0;
    for (std::size_t i = 0; i < spec.axes.size(); ++i)
      way = std::hypot(way, spec.points[k + 1][i] - spec.points[k][i]);
    for (std::size_t i = 0; i < spec.axes.size(); ++i)
      all[k][i] = within_norm(all[k][i], spec.norm,
                              std::abs(spec.points[k + 1][i] - spec.points[k][i]) / way);
  }
  return all;
}

Knot knot_at(const std::vector<double>& point, const ViaRates& rates) {
  const auto rate = [](const std::vector<double>& all, std::size_t i) {
    return all.empty() ? 0 : all[i];
  };
  Knot knot;
  for (std::size_t i = 0; i < point.size(); ++i)
    knot.push_back({point[i], rate(rates.velocity, i), rate(rates.acceleration, i)});
  return knot;
}

/// The knots of the motion that rests at every intermediate point.
std::vector<Knot> stopping(const ViaSpec& spec) {
  std::vector<Knot> knots;
  for (const auto& point : spec.points) knots.push_back(knot_at(point, {}));
  knots.front() = knot_at(spec.points.front(), spec.start);
  knots.back() = knot_at(spec.points.back(), spec.end);
  return knots;
}

/// The points between which the motion is the shortest one: for several axes, all points; for one
/// axis, the turning points and both ends.
std::vector<std::size_t> essential(const ViaSpec& spec,
                                   const profiles_detail::StretchBounds& bounds) {
  std::vector<std::size_t> points;
  const auto& p = spec.points;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const bool inner = k > 0 && k + 1 < p.size();
    const bool passed = inner && spec.axes.size() == 1 &&
                        (p[k - 1][0] < p[k][0]) == (p[k][0] < p[k + 1][0]) &&
                        bounds[k - 1] == bounds[k];
    if (!passed) points.push_back(k);
  }
  return points;
}

/// The duration of the motion with a stop at each intermediate point; infinite if a stretch is
/// impossible without reversing.
double stopping_duration(const ViaSpec& spec, const profiles_detail::StretchBounds& bounds) {
  const std::vector<Knot> knots = stopping(spec);
  double total = 0;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    std::vector<AxisMove> moves;
    for (std::size_t i = 0; i < spec.axes.size(); ++i)
      moves.push_back({knots[k][i], knots[k + 1][i], bounds[k][i]});
    std::vector<Profile> profiles(moves.size());
    const Synchronized all = synchronize(moves, Sync::time, profiles);
    if (all.status != MoveStatus::ok)
      throw InputError("axes[" + std::to_string(all.axis + 1) + "]", "", explain(all.status));
    if (!(all.duration > 0))
      throw InputError("axes", "", "must limit the motion: without limits it takes no time");
    total += profiles_detail::stretch(bounds[k], knots[k], knots[k + 1]).duration;
  }
  return total;
}

/// The time in [from, to] at which a motion without reversal is at x.
double passage(const Trajectory& motion, double from, double to, double x) {
  const double direction = motion.at(from).position < x ? 1 : -1;
  for (int i = 0; i < 80; ++i) {
    const double middle = from + (to - from) / 2;
    if (middle <= from || middle >= to) break;
    ((x - motion.at(middle).position) * direction > 0 ? from : to) = middle;
  }
  return to;
}

ViaKnot seen_at(const std::vector<Trajectory>& axes, double time) {
  ViaKnot knot{time, {}, {}};
  for (const Trajectory& axis : axes) {
    const Motion m = axis.at(time);
    knot.velocity.push_back(m.velocity);
    knot.acceleration.push_back(m.acceleration);
  }
  return knot;
}

ViaKnot chosen(const Knot& states, double time) {
  ViaKnot knot{time, {}, {}};
  for (const MotionState& s : states) {
    knot.velocity.push_back(s.velocity);
    knot.acceleration.push_back(s.acceleration);
  }
  return knot;
}

/// The trajectories through the knots, and the times at which they pass them.
struct Built {
  std::vector<Trajectory> axes;
  std::vector<double> times{0};
};

Built build(const profiles_detail::StretchBounds& bounds, const std::vector<Knot>& knots) {
  Built built;
  std::vector<profiles_detail::Sequence> paths(knots.front().begin(), knots.front().end());
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const profiles_detail::Hop stretch =
        profiles_detail::stretch(bounds[k], knots[k], knots[k + 1]);
    built.times.push_back(built.times.back() + stretch.duration);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const Profile& profile = stretch.profiles[i];
      paths[i].add(profile, 1);
      if (profile.phases() == 0) paths[i].hold(stretch.duration);
    }
  }
  for (profiles_detail::Sequence& path : paths)
    built.axes.emplace_back(std::move(path).segments(), 0, Extrapolation::hold);
  const auto moves = [](const MotionState& s) { return s.velocity != 0 || s.acceleration != 0; };
  if (std::any_of(knots.back().begin(), knots.back().end(), moves))
    for (const Trajectory& axis : built.axes)  // beyond its end an axis would stand still
      built.times.back() = std::min(built.times.back(), axis.end());
  return built;
}

/// A first motion: at rest at the intermediate points, or at a part of the velocity of the nearest
/// end if it cannot rest there.
std::vector<Knot> feasible(const profiles_detail::StretchBounds& bounds, std::vector<Knot> knots) {
  const auto fits = [&] {
    const std::vector<double> all = profiles_detail::durations(bounds, knots);
    return std::all_of(all.begin(), all.end(), [](double t) { return std::isfinite(t); });
  };
  const std::size_t last = knots.size() - 1;
  const std::vector<Knot> rest = knots;
  constexpr int shares = 8;
  for (int first_share = 0; first_share <= shares; ++first_share)
    for (int last_share = 0; last_share <= shares; ++last_share) {
      knots = rest;
      for (std::size_t i = 0; last > 1 && i < knots[0].size(); ++i) {
        knots[1][i].velocity = rest[0][i].velocity * first_share / shares;
        if (last_share > 0)
          knots[last - 1][i].velocity = rest[last][i].velocity * last_share / shares;
      }
      if (fits()) return knots;
      if (last < 2) break;
    }
  throw InputError(
      "start", "",
      "no motion was found that keeps the bounds without a reversal: begin and end slower, within "
      "the limits of the stretch, or move the adjacent points apart");
}

}  // namespace

ViaMotion via(const ViaSpec& spec) {
  require_valid(spec);
  ViaMotion motion;
  const profiles_detail::StretchBounds all_bounds = stretch_bounds(spec);
  motion.stopping_duration = stopping_duration(spec, all_bounds);
  const std::vector<std::size_t> points = essential(spec, all_bounds);
  const std::vector<Knot> stops = stopping(spec);
  std::vector<Knot> knots;
  profiles_detail::StretchBounds bounds;
  for (const std::size_t p : points) {
    knots.push_back(stops[p]);
    if (p > 0) bounds.push_back(all_bounds[p - 1]);
  }
  knots = feasible(bounds, std::move(knots));
  profiles_detail::shorten(bounds, knots);

  Built built = build(bounds, knots);
  motion.axes = std::move(built.axes);
  motion.duration = built.times.back();
  for (std::size_t k = 0; k < knots.size(); ++k) {
    if (k > 0)
      for (std::size_t p = points[k - 1] + 1; p < points[k]; ++p)
        motion.knots.push_back(seen_at(motion.axes, passage(motion.axes[0], built.times[k - 1],
                                                            built.times[k], spec.points[p][0])));
    motion.knots.push_back(chosen(knots[k], built.times[k]));
  }
  motion.stops = spec.points.size() > 2 && !(motion.duration < motion.stopping_duration);
  return motion;
}

}  // namespace jounce
