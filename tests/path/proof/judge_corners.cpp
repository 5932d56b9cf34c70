// SPDX-License-Identifier: Apache-2.0
// Distances between a path and the lines and arcs that the program asks for.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "path/proof/judge.hpp"

namespace jounce::path_proof {
namespace {

constexpr double permitted = 1e-9;          ///< share of a deviation
constexpr double rounded_position = 1e-11;  ///< share of the size
constexpr int places = 12;                  ///< evaluated places of a corner

double from_line(const Point& p, const Point& a, const Point& b, std::size_t axes) {
  double along = 0;
  double square = 0;
  for (std::size_t k = 0; k < axes; ++k) {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    square += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  Point foot = a;
  for (std::size_t k = 0; k < axes; ++k) foot[k] = a[k] + t * (b[k] - a[k]);
  return distance(p, foot, axes);
}

double from_arc(const Point& p, const Arc& arc, std::size_t axes) {
  double x = 0;
  double y = 0;
  for (std::size_t k = 0; k < axes; ++k) {
    x += (p[k] - arc.center[k]) * arc.e1[k];
    y += (p[k] - arc.center[k]) * arc.e2[k];
  }
  double angle = std::atan2(y, x);
  if (angle < 0) angle += 2 * std::numbers::pi;
  const auto at = [&](double a) { return distance(p, point_at(arc, a), axes); };
  return angle <= arc.sweep ? at(angle) : std::min(at(0), at(arc.sweep));
}

/// Distance from the commands around leg `k`; 0 beside a spline.
double from_sides(const Case& c, const Point& p, std::size_t k) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = k > 4 ? k - 5 : 0; i < std::min(c.legs.size(), k + 5); ++i) {
    if (c.legs[i].shape == Leg::Shape::spline) return 0;
    least = std::min(least, c.legs[i].shape == Leg::Shape::arc
                                ? from_arc(p, arc_of(c, i), c.path_axes)
                                : from_line(p, c.from(i), c.legs[i].to, c.path_axes));
  }
  return least;
}

/// The least value of a function of q in an interval: the best of many places, narrowed down.
template <class F>
double least(double from, double to, F f) {
  double best = from;
  double smallest = f(from);
  const auto consider = [&](double q) {
    if (!(q >= from && q <= to)) return;
    if (const double x = f(q); x < smallest) {
      smallest = x;
      best = q;
    }
  };
  for (int i = 1; i <= places; ++i) consider(from + (to - from) * i / places);
  double step = (to - from) / 2 / places;
  for (int i = 0; i < 40; ++i, step *= 0.6)
    for (const double q : {best - step, best + step}) consider(q);
  return smallest;
}

/// Judges a rounded corner at the start of leg `k`.
std::string judge_corner(const Case& c, const Path& path, const CornerRecord& corner, std::size_t k,
                         Worst& worst) {
  const auto pieces = path.pieces();
  const auto behind = std::upper_bound(pieces.begin(), pieces.end(), corner.where,
                                       [](double q, const PathPiece& p) { return q < p.start; });
  const auto piece = static_cast<std::size_t>(behind - pieces.begin()) - 1;
  if (pieces[piece].kind != PieceKind::turn && pieces[piece].kind != PieceKind::blend) return {};
  double size = path.length();
  for (std::size_t i = 0; i < c.axes; ++i) size = std::max(size, c.size(i));
  const double rounding = rounded_position * size;
  const bool followers = pieces[piece].kind == PieceKind::turn && corner.angle == 0;
  const std::size_t axes = followers ? c.axes : c.path_axes;
  const double off = least(0, pieces[piece].length, [&](double u) {
    return distance(path.point(piece, u), c.from(k), axes);
  });
  // The sides of an average are curves near the lines; if only followers turn, the report is a bound.
  const bool average = corner.asked == Corner::average;
  const double below = followers || average ? corner.deviation : permitted * off + rounding;
  if (!(off - corner.deviation <= permitted * off + rounding && corner.deviation - off <= below) &&
      !average)
    return "line " + std::to_string(corner.line) + " is " + text(off) +
           " from the corner, reported is " + text(corner.deviation);
  double wide = 0;
  for (int i = 0; i <= places; ++i) {
    const Point p = path.point(piece, pieces[piece].length * i / places);
    wide = std::max(wide, from_sides(c, p, k));
  }
  if (!(wide <= corner.one_sided * (1 + permitted) + rounding) && !average)
    return "line " + std::to_string(corner.line) + " is " + text(wide) +
           " from its sides, reported is " + text(corner.one_sided);
  wide = std::max(wide, off);
  if (corner.asked == Corner::deviation || average) {
    worst.wide = std::max(worst.wide, (wide - rounding) / corner.value);
    if (!(wide <= corner.value * (1 + permitted) + rounding))
      return "line " + std::to_string(corner.line) + " deviates by " + text(wide) +
             ", permitted is " + text(corner.value);
  }
  if (corner.asked == Corner::distance && !(corner.trim <= corner.value * (1 + permitted)))
    return "line " + std::to_string(corner.line) + " is cut by " + text(corner.trim) +
           ", permitted is " + text(corner.value);
  if (corner.asked == Corner::curvature && corner.note == JunctionNote::none && !followers &&
      !(corner.curvature <= corner.value * (1 + permitted)))
    return "line " + std::to_string(corner.line) + " has the curvature " + text(corner.curvature) +
           ", permitted is " + text(corner.value);
  return {};
}

}  // namespace

namespace {

/// True if the command at the start of leg `k` asks for a rest: also one before it without distance.
bool asks_for_rest(const Case& c, const std::vector<CornerRecord>& corners, std::size_t k) {
  const auto rests = [&](std::size_t i) {
    const Leg& leg = c.legs[i];
    return leg.dwell > 0 || leg.settings.junction == Junction::buffered;
  };
  const auto is_empty = [&](std::size_t i) {
    return std::ranges::any_of(corners, [&](const CornerRecord& r) {
      return r.note == JunctionNote::no_distance && r.line == static_cast<std::int32_t>(i + 1);
    });
  };
  for (; !rests(k); --k)
    if (k == 0 || !is_empty(k - 1)) return c.legs[k].settings.corner == Corner::stop;
  return true;
}

/// Every rest of the law is at a junction that is reported, and has a note unless the command asks for it.
std::string judge_rests(const Case& c, const Plan& plan, const std::vector<CornerRecord>& corners) {
  std::vector<double> reported;
  for (const CornerRecord& corner : corners) {
    if (!corner.stop) continue;
    reported.push_back(corner.where);
    if (corner.note == JunctionNote::none &&
        !asks_for_rest(c, corners, static_cast<std::size_t>(corner.line) - 1))
      return "stops at line " + std::to_string(corner.line) + " without a note";
  }
  const double near = rounded_position * plan.path().length();
  for (const LawInterval& s : plan.law().stretches())
    if (s.v0 == 0 && s.start > near && s.start < plan.path().length() - near &&
        std::ranges::none_of(reported, [&](double q) { return std::abs(q - s.start) <= near; }))
      return "rests at " + text(s.start) + " of the path without a record";
  return {};
}

}  // namespace

std::string judge_corners(const Case& c, const Plan& plan, Worst& worst) {
  const std::vector<CornerRecord> corners = plan.corners();
  if (std::string why = judge_rests(c, plan, corners); !why.empty()) return why;
  for (const CornerRecord& corner : corners) {
    if (corner.stop || corner.line < 2) continue;
    if (corner.note == JunctionNote::no_distance || corner.note == JunctionNote::steps) continue;
    if (std::string why =
            judge_corner(c, plan.path(), corner, static_cast<std::size_t>(corner.line) - 1, worst);
        !why.empty())
      return why;
  }
  return {};
}

std::string judge_average(const Case& c, const Plan& plan, Worst& worst) {
  const double value = c.legs.front().settings.value;
  const double rounding = rounded_position * (plan.path().length() + distance(c.start, {}));
  double q = 0;
  for (std::size_t k = 0; k < c.legs.size(); ++k) {
    const double length = distance(c.from(k), c.legs[k].to, c.path_axes);
    for (const double share : {0.5, 1.0}) {
      Point p = c.from(k);
      for (std::size_t i = 0; i < c.axes; ++i) p[i] += share * (c.legs[k].to[i] - p[i]);
      const double middle = q + share * length;
      const auto at = [&](double x) { return distance(point_at_length(plan.path(), x), p); };
      const double off = std::min(at(middle), least(middle - value, middle + value, at));
      worst.wide = std::max(worst.wide, (off - rounding) / value);
      if (!(off <= value * (1 + permitted) + rounding))
        return "line " + std::to_string(k + 1) + " is " + text(off) + " from the path, permitted " +
               text(value);
    }
    q += length;
  }
  return {};
}

}  // namespace jounce::path_proof
