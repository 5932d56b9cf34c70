// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/plan.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "jounce/profiles/error.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/corners/rounding.hpp"
#include "path/src/corners/turn.hpp"
#include "path/src/geometry/average.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/route.hpp"
#include "path/src/geometry/vector.hpp"
#include "path/src/maps/joined.hpp"
#include "path/src/timing/laws.hpp"
#include "path/src/timing/stretch.hpp"

namespace jounce {
namespace {

/// Position limits at the ends of all commands.
void require_inside(const Program& program, const GroupLimits& limits) {
  const auto check = [&](std::size_t axis, double x, int line) {
    const Limits& l = limits.axes[axis];
    const double low = l.position_min.value_or(-PathSettings::none);
    const double high = l.position_max.value_or(PathSettings::none);
    if (x < low || x > high)
      throw InputError(
          "to[" + std::to_string(axis + 1) + "]", x,
          "must be from " + number(low) + " to " + number(high) + ", the limits of the axis")
          .at({}, line);
  };
  bool limited = false;
  for (const Limits& l : limits.axes) limited = limited || l.position_min || l.position_max;
  if (!limited) return;
  for (std::size_t i = 0; i < program.axes(); ++i) check(i, program.start()[i], 0);
  for (const Program::Command& c : program.commands())
    for (std::size_t i = 0; c.kind != Program::Kind::dwell && i < program.axes(); ++i)
      check(i,
            c.kind == Program::Kind::line  ? program.numbers()[c.data + i]
            : c.kind == Program::Kind::arc ? program.arcs()[c.data].to[i]
                                           : program.curves()[c.data].to[i],
            c.line);
}

/// Marks the joints between the plan's rests where stopping everywhere is faster; false if there are none.
bool mark_slower(const Laws& plan, const Laws& stopping, std::vector<bool>& stop) {
  bool any = false;
  std::size_t s = 0;
  for (std::size_t k = 0; k + 1 < plan.rests.size(); ++k) {
    const Rest& from = plan.rests[k];
    const Rest& to = plan.rests[k + 1];
    while (stopping.rests[s].joint < from.joint) ++s;
    const double begin = stopping.rests[s].time;
    while (stopping.rests[s].joint < to.joint) ++s;
    if (to.time - from.time <= (stopping.rests[s].time - begin) * (1 + 1e-12)) continue;
    for (std::size_t joint = from.joint + 1; joint < to.joint; ++joint) {
      any = any || !stop[joint];
      stop[joint] = true;
    }
  }
  return any;
}

}  // namespace

Plan plan(const Program& program, const GroupLimits& limits, const PlanOptions& options) {
  const Joined joined(program, limits, options.joints);
  require_inside(program, limits);
  const Route tool = route_of(program);
  const Route sharp = joined.with_linear(tool);
  const Rates shaping = joined.corner_rates(sharp);
  const auto corners_of = [&](const Route& route, const std::vector<bool>& stop) {
    return joined.with_fitted(rounded(route, program, shaping, stop));
  };
  const auto law_of = [&](const Jointed& r, const Route& route) {
    return fastest_law(r.rounded, joined.rates(), program, route);
  };
  Jointed result = corners_of(sharp, std::vector<bool>(sharp.joints.size(), true));
  Laws law = law_of(result, sharp);
  const double stop_duration = law.rests.back().time;
  if (!options.stop_at_corners) {
    const Route route = joined.with_linear(with_averages(tool, program));
    std::vector<bool> stop(route.joints.size(), false);
    Jointed corners = corners_of(route, stop);
    Laws fast = law_of(corners, route);
    if (route.joints.size() == sharp.joints.size() && mark_slower(fast, law, stop)) {
      corners = corners_of(route, stop);
      fast = law_of(corners, route);
    }
    if (fast.rests.back().time <= stop_duration) {
      result = std::move(corners);
      law = std::move(fast);
    }
  }
  return {std::move(result.rounded.path),
          TimingLaw(std::move(law.stretches)),
          std::move(result.rounded.joints),
          stop_duration,
          {joined.limits(),
           {program.settings().begin(), program.settings().end()},
           program.path_axes(),
           std::move(result.drawn),
           result.fit}};
}

Plan::Plan(Path path, TimingLaw law, std::vector<JointMark> joints, double stop_duration,
           Given given)
    : path_(std::move(path)),
      law_(std::move(law)),
      joints_(std::move(joints)),
      stop_duration_(stop_duration),
      given_(std::move(given)) {}

void Plan::at(double t, std::span<Motion> out) const {
  assert(out.size() == path_.axes());
  const LawStretch& stretch = law_.stretches()[law_.stretch_at(t)];
  const Motion q = motion_in(stretch, t - stretch.time);
  // The piece within the stretch: mostly its only one.
  std::size_t piece = stretch.piece;
  const auto pieces = path_.pieces();
  double u = q.position + (stretch.start - pieces[piece].start);
  if (stretch.pieces > 1) {
    const double at = pieces[piece].start + u;
    const auto first = pieces.begin() + static_cast<std::ptrdiff_t>(piece);
    const auto it = std::upper_bound(first + 1, first + stretch.pieces, at,
                                     [](double x, const PathPiece& p) { return x < p.start; });
    piece = static_cast<std::size_t>(it - pieces.begin()) - 1;
    u = at - pieces[piece].start;
  }
  std::array<Jet, max_axes> jet;
  path_.jets(piece, std::clamp(u, 0.0, pieces[piece].length), std::span(jet).first(out.size()));
  const double v = q.velocity;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Jet& r = jet[i];
    out[i] = {r[0], r[1] * v, r[1] * q.acceleration + r[2] * v * v,
              r[1] * q.jerk + 3 * r[2] * v * q.acceleration + r[3] * v * v * v};
  }
}

std::vector<CornerRecord> Plan::corners() const {
  std::vector<CornerRecord> out;
  const Path& path = drawn();
  const std::size_t n = path.axes();
  const std::size_t m = given_.path_axes;
  for (const JointMark& mark : joints_) {
    CornerRecord c;
    c.line = mark.line;
    c.stop = mark.rests;
    c.note = mark.note;
    const PathPiece& p = path.pieces()[mark.piece];
    const PathSettings& settings = given_.settings[p.settings];
    c.asked = settings.corner;
    c.value = settings.value;
    const double* data = path.numbers(mark.piece);
    std::array<Jet, max_axes> before{};
    std::array<Jet, max_axes> behind{};
    const bool corner = p.kind == PieceKind::turn || p.kind == PieceKind::blend;
    const std::size_t last = corner ? mark.piece : mark.piece - 1;
    if (mark.note != JointNote::no_distance && (corner || mark.piece > 0)) {
      path.jets(last, path.pieces()[last].length, std::span(behind).first(n));
      path.jets(mark.piece, 0, std::span(before).first(n));
      if (!corner) std::swap(before, behind);
      Point u{};
      Point w{};
      for (std::size_t i = 0; i < n; ++i) {
        u[i] = before[i][1];
        w[i] = behind[i][1];
      }
      c.angle = 2 * std::atan2(vec::distance(u, w, m), vec::norm(vec::sum(u, w), m));
      c.where = p.start + (corner ? p.length / 2 : 0);
    }
    if (corner) {
      c.trim = p.length / 2;
      if (p.kind == PieceKind::turn) {
        const TurnNumbers turn(data, n);
        Point change{};
        for (std::size_t i = 0; i < n; ++i) change[i] = turn.after(i) - turn.before(i);
        double bend = vec::norm(change, m);
        if (!(bend > 1e-9)) bend = vec::norm(change, n);
        const double cosine = std::cos(c.angle / 2);
        c.deviation = bend * p.length * turn_offset(turn.share());
        c.one_sided = c.deviation * cosine;
        c.curvature = bend / ((1 - turn.share()) * p.length * cosine * cosine);
      } else {
        const std::size_t count = polynomial_count(n, static_cast<int>(data[0]));
        c.deviation = data[count];
        c.one_sided = data[count + 1];
        std::array<Segment, max_axes> axes;
        std::vector<Segment> one;
        for (std::size_t i = 0; i < n; ++i) {
          one.clear();
          path.segments(mark.piece, i, one);
          axes[i] = one.front();
        }
        c.curvature = greatest_curvature(std::span(axes).first(n), m);
      }
    }
    if (!c.stop && mark.note != JointNote::no_distance) {
      const auto stretches = law_.stretches();
      const auto it = std::upper_bound(stretches.begin(), stretches.end(), c.where,
                                       [](double q, const LawStretch& s) { return q < s.start; });
      const LawStretch& s = *(it - 1);
      if (s.v0 == s.peak && s.v1 == s.peak)
        c.velocity = s.peak;
      else {  // within a longer ramp: by halving time
        double low = 0;
        double high = s.duration;
        for (int i = 0; i < 60; ++i) {
          const double middle = (low + high) / 2;
          (motion_in(s, middle).position < c.where - s.start ? low : high) = middle;
        }
        c.velocity = motion_in(s, low).velocity;
      }
    }
    switch (mark.note) {
      case JointNote::none:
        break;
      case JointNote::turns_back:
        c.text = "The path turns back by " + number(c.angle * 180 / std::numbers::pi) +
                 " degrees: the plan stops here.";
        break;
      case JointNote::short_sides:
        c.text = "The sides are too short for the requested value: a corner with a trim of " +
                 number(c.trim) + " and a deviation of " + number(c.deviation) + " is used.";
        break;
      case JointNote::slower:
        c.text = "Rounding within the requested value of " + number(c.value) +
                 " takes longer than stopping: the plan stops here.";
        break;
      case JointNote::steps:
        c.text =
            "The curvature steps here, and the acceleration with it; a corner mode rounds the "
            "step.";
        break;
      case JointNote::no_distance:
        c.text = "The command covers no distance: it is left out.";
        break;
    }
    out.push_back(std::move(c));
  }
  return out;
}

}  // namespace jounce
