// SPDX-License-Identifier: Apache-2.0
#include "path/proof/judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/path/along.hpp"
#include "jounce/path/axes_by_stretch.hpp"

#include "path/proof/extremes.hpp"

namespace jounce::path_proof {
namespace {

constexpr double permitted = 1e-12;         ///< excess over a limit, share
constexpr double rounded_position = 1e-11;  ///< share of the size
constexpr double rounded_velocity = 3e-9;   ///< share of the greatest velocity
constexpr double rounded_acceleration = 1e-6;
constexpr double rounded_time = 1e-12;

/// Position, velocity and acceleration at an end of a segment.
std::array<double, 3> state(const Segment& f, double s) {
  const Jet jet = evaluate(f, s);
  return {jet[0], jet[1], jet[2]};
}

std::string limited(const Segment& f, const Limits& limits, std::size_t axis, Worst& worst) {
  const std::pair<const char*, std::optional<double>> rates[] = {
      {"velocity", limits.velocity}, {"acceleration", limits.acceleration}, {"jerk", limits.jerk}};
  int order = 0;
  for (const auto& [name, limit] : rates) {
    ++order;
    if (!limit) continue;
    const Bounded found = bounded(f, order, *limit * (1 + permitted));
    worst.excess = std::max(worst.excess, found.largest / *limit - 1);
    if (!found.holds)
      return std::string(name) + " of axis " + std::to_string(axis + 1) + " is " +
             text(found.largest / *limit) + " of its limit";
  }
  return {};
}

std::string judge_axis(const Trajectory& curve, const Jet& error, const Limits& limits,
                       const Demand& demand, std::size_t axis, Worst& worst) {
  const auto segments = curve.segments();
  double fastest = std::max(demand.velocity, limits.velocity.value_or(0));
  double strongest = limits.acceleration.value_or(0);
  for (const Segment& f : segments)
    for (const double s : {0.0, 0.5, 1.0}) {
      const auto [x, v, a] = state(f, s);
      fastest = std::max(fastest, std::abs(v));
      if (!limits.acceleration) strongest = std::max(strongest, std::abs(a));
    }
  std::array<double, 3> before{demand.from[axis], 0, 0};
  const double near[] = {rounded_position * demand.size + 4 * error[0],
                         rounded_velocity * fastest + 4 * error[1],
                         rounded_acceleration * strongest + 4 * error[2]};
  const char* const names[] = {"position", "velocity", "acceleration"};
  double shorter = HUGE_VAL;  // time of the segments at a joint
  const auto join = [&](const std::array<double, 3>& next, const std::string& where) {
    for (std::size_t k = 0; k < (demand.steps ? 2U : 3U); ++k)
      if (!(std::abs(next[k] - before[k]) <=
            near[k] + demand.rounding * demand.size / std::pow(shorter, k)))
        return std::string(names[k]) + " of axis " + std::to_string(axis + 1) + " steps by " +
               text(next[k] - before[k]) + where;
    return std::string();
  };
  double time = 0;
  double last = HUGE_VAL;
  for (const Segment& f : segments) {
    shorter = std::min(f.length, std::exchange(last, f.length));
    if (std::string why = limited(f, limits, axis, worst); !why.empty()) return why;
    if (std::string why = join(state(f, 0), " at " + text(time) + " s"); !why.empty()) return why;
    before = state(f, 1);
    time += f.length;
  }
  if (!(std::abs(time - demand.duration) <= rounded_time * demand.duration * 100))
    return "the axis lasts " + text(time) + " s, not " + text(demand.duration);
  if (demand.size > 0)
    worst.end =
        std::max(worst.end, (std::abs(before[0] - demand.to[axis]) - 2 * error[0]) / demand.size);
  return join({demand.to[axis], 0, 0}, " at the end");
}

/// The legs to which a piece of the path belongs: two on a rounded corner.
std::vector<std::size_t> legs_of(const Case& c, const PathPiece& piece) {
  const auto leg = static_cast<std::size_t>(piece.line) - 1;
  if (piece.kind != PieceKind::turn && piece.kind != PieceKind::blend) return {leg};
  std::size_t before = leg - 1;
  while (before > 0 && distance(c.from(before), c.legs[before].to) == 0) --before;
  return {leg, before};
}

/// Each axis stays within the limits of the commands, each in its part of the path.
std::string judge_commands(const Case& c, const Plan& motion, Worst& worst) {
  if (std::ranges::all_of(c.legs, [](const Leg& leg) { return leg.settings.axes.empty(); }))
    return {};
  const auto given = [](double limit) {
    return std::isfinite(limit) ? std::optional(limit) : std::nullopt;
  };
  AxesByStretch axes(motion);
  for (const LawInterval& stretch : motion.law().stretches()) {
    axes.next();
    for (std::size_t i = 0; i < c.axes; ++i)
      for (std::size_t k = 0; k < axes.segments(i).size(); ++k)
        for (const std::size_t leg : legs_of(c, motion.path().pieces()[axes.pieces(i)[k]])) {
          const std::vector<AxisRates>& rates = c.legs[leg].settings.axes;
          if (i >= rates.size()) continue;
          const Limits limits{.velocity = given(rates[i].velocity),
                              .acceleration = given(rates[i].acceleration),
                              .jerk = given(rates[i].jerk)};
          if (const std::string why = limited(axes.segments(i)[k], limits, i, worst); !why.empty())
            return why + " in command " + std::to_string(leg + 1) + " after " + text(stretch.time) +
                   " s";
        }
  }
  return {};
}

double least_time(const Case& c, const Plan& made) {
  double spared = 0;
  for (const CornerRecord& corner : made.corners()) spared += 2 * corner.deviation;
  double longest = 0;
  double time = 0;
  double fastest = 0;
  for (std::size_t k = 0; k < c.legs.size(); ++k) {
    longest += distance(c.from(k), c.legs[k].to, c.path_axes);
    fastest = std::max(fastest, c.legs[k].settings.velocity);
    time += c.legs[k].dwell;
  }
  return time + std::max(longest - spared, 0.0) / std::min(fastest, c.limits.path.velocity);
}

/// Time of a line from rest to rest, by the seven phases; the deceleration may differ.
double rest_to_rest(double length, double v, double a, double d, double j) {
  const auto ramp = [j](double speed, double rate) {
    return speed * j > rate * rate ? speed / rate + rate / j : 2 * std::sqrt(speed / j);
  };
  const auto way = [&](double speed) { return speed / 2 * (ramp(speed, a) + ramp(speed, d)); };
  double low = 0;
  double high = v;
  if (way(v) > length)
    for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
      const double middle = (low + high) / 2;
      (way(middle) > length ? high : low) = middle;
    }
  else
    low = v;
  return ramp(low, a) + ramp(low, d) + (length - way(low)) / low;
}

double with_stop(const Case& c, std::size_t k) {
  const Leg& leg = c.legs[k];
  const double length = distance(c.from(k), leg.to);
  if (length == 0) return leg.dwell;
  const PathLimits& p = c.limits.path;
  double v = std::min(leg.settings.velocity, p.velocity);
  double a = std::min({leg.settings.acceleration, p.acceleration, p.total_acceleration});
  double d = std::min({leg.settings.deceleration, p.deceleration, p.total_acceleration});
  double j = std::min(leg.settings.jerk, p.jerk);
  for (std::size_t i = 0; i < c.axes; ++i) {
    const double u = std::abs(leg.to[i] - c.from(k)[i]) / length;
    if (u == 0) continue;
    const auto least = [u](double x, const std::optional<double>& limit) {
      return limit ? std::min(x, *limit / u) : x;
    };
    v = least(v, c.limits.axes[i].velocity);
    a = least(a, c.limits.axes[i].acceleration);
    d = least(d, c.limits.axes[i].acceleration);
    j = least(j, c.limits.axes[i].jerk);
    if (i >= leg.settings.axes.size()) continue;
    const AxisRates& further = leg.settings.axes[i];
    v = std::min(v, further.velocity / u);
    a = std::min(a, further.acceleration / u);
    d = std::min(d, further.acceleration / u);
    j = std::min(j, further.jerk / u);
  }
  return rest_to_rest(length, v, a, d, j) + leg.dwell;
}

bool steps(const Plan& plan) {
  return std::ranges::any_of(plan.junctions(),
                             [](const JunctionMark& m) { return m.note == JunctionNote::steps; });
}

Demand demand_of(const Case& c, const Plan& motion) {
  Demand d;
  d.size = motion.path().length();
  for (std::size_t i = 0; i < c.axes; ++i) d.size = std::max(d.size, c.size(i));
  for (std::size_t k = 0; k < c.legs.size(); ++k)
    if (c.legs[k].shape == Leg::Shape::arc) {
      const Arc arc = arc_of(c, k);
      for (const double x : arc.center) d.size = std::max(d.size, std::abs(x) + arc.radius);
    }
  d.duration = motion.duration();
  for (const LawInterval& s : motion.law().stretches()) d.velocity = std::max(d.velocity, s.peak);
  d.steps = steps(motion);
  return d;
}

}  // namespace

double distance(const Point& a, const Point& b, std::size_t axes) {
  double square = 0;
  for (std::size_t k = 0; k < axes; ++k) square += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(square);
}

Point point_at_length(const Path& path, double q) {
  const auto pieces = path.pieces();
  const auto behind = std::upper_bound(pieces.begin(), pieces.end(), q,
                                       [](double x, const PathPiece& p) { return x < p.start; });
  const auto piece =
      static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, behind - pieces.begin())) - 1;
  return path.point(piece, std::clamp(q - pieces[piece].start, 0.0, pieces[piece].length));
}

std::string judge_axes(const PlanAxes& axes, const GroupLimits& limits, const Demand& demand,
                       Worst& worst) {
  for (std::size_t i = 0; i < axes.curves.size(); ++i)
    if (std::string why =
            judge_axis(axes.curves[i], axes.error[i], limits.axes[i], demand, i, worst);
        !why.empty())
      return why;
  return {};
}

double time_with_stops(const Case& c) {
  double time = 0;
  for (std::size_t k = 0; k < c.legs.size(); ++k) time += with_stop(c, k);
  return time;
}

std::string judge_plan(const Case& c, const Plan& plan, Worst& worst, double rounding) {
  Demand demand = demand_of(c, plan);
  demand.rounding = rounding;
  demand.from = c.start;
  demand.to = c.legs.back().to;
  const PlanAxes axes = to_axes(plan);
  if (std::string why = judge_axes(axes, c.limits, demand, worst); !why.empty()) return why;
  if (std::string why = judge_commands(c, plan, worst); !why.empty()) return why;
  if (std::string why = judge_corners(c, plan, worst); !why.empty()) return why;
  const double T = plan.duration();
  const bool all_lines = !c.has(Leg::Shape::arc) && !c.has(Leg::Shape::spline);
  const double stops =
      all_lines ? time_with_stops(c) * (1 + 1e-9) : plan.stop_duration() * (1 + rounded_time);
  if (!(T <= stops)) return "lasts " + text(T) + " s, with stops " + text(stops);
  const double bound = std::max(lower_bound(plan, 2), least_time(c, plan)) * (1 - rounded_time);
  if (!(T >= bound)) return "lasts " + text(T) + " s, the bound is " + text(bound);
  const Report along = check_along(plan);
  if (along.ok()) return {};
  const Finding& first = along.findings.front();
  return first.rule.text() + " is " + text(first.value) + ", the limit " + text(first.limit);
}

std::string judge_motion(const Case& c, const Plan& plan, const Plan& motion, double from,
                         Worst& worst) {
  Demand demand = demand_of(c, plan);
  demand.duration = motion.duration();
  const LawInterval& last = motion.law().stretches().back();
  demand.from = point_at_length(plan.path(), from);
  demand.to = point_at_length(plan.path(), last.start + last.length);
  const PlanAxes axes = to_axes(motion);
  if (std::string why = judge_axes(axes, c.limits, demand, worst); !why.empty()) return why;
  if (std::string why = judge_commands(c, motion, worst); !why.empty()) return why;
  double q = from;
  constexpr int places = 24;
  for (int i = 0; i <= places; ++i) {
    const double t = motion.duration() * i / places;
    const Motion law = motion.law().at(t);
    if (!(law.position >= q - rounded_position * demand.size))
      return "moves back along the path at " + text(t) + " s";
    q = law.position;
    const Point on = point_at_length(plan.path(), q);
    for (std::size_t k = 0; k < c.axes; ++k)
      if (!(std::abs(axes.curves[k].at(t).position - on[k]) <=
            rounded_position * demand.size + 2 * axes.error[k][0]))
        return "leaves the path by " + text(axes.curves[k].at(t).position - on[k]) + " at " +
               text(t) + " s";
  }
  return {};
}

}  // namespace jounce::path_proof
