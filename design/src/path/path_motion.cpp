// SPDX-License-Identifier: Apache-2.0
#include "design/src/path/path_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "jounce/path/detail/tool_unit.hpp"
#include "jounce/path/override.hpp"
#include "jounce/path/refine.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::design_detail {
namespace {

constexpr double path_tolerance = 1e-9;  ///< greatest distance from the path, in its unit
constexpr double path_rounding = 2e-14;  ///< share of the largest coordinate

std::string name_of(const PathPiece& piece) {
  const bool corner = piece.kind == PieceKind::turn || piece.kind == PieceKind::blend;
  return (corner ? "corner " : "line ") + std::to_string(piece.line);
}

/// The source line of each segment: that of the piece of the path at the middle of the segment.
/// Both ascend.
std::vector<std::string> names_of(const Plan& plan, const Trajectory& curve) {
  const auto pieces = plan.drawn().pieces();
  auto stretch = plan.law().stretches().begin();
  std::vector<std::string> names;
  names.reserve(curve.segments().size());
  std::size_t piece = 0;
  for (std::size_t i = 0; i < curve.segments().size(); ++i) {
    const double t = (curve.breaks()[i] + curve.breaks()[i + 1]) / 2;
    while (stretch.next_time() <= t) ++stretch;
    if (stretch->pieces == 0) {
      names.emplace_back("dwell");
      continue;
    }
    const double q = plan.law().at(t).position;
    while (piece + 1 < pieces.size() && pieces[piece + 1].start <= q) ++piece;
    names.push_back(name_of(pieces[piece]));
  }
  return names;
}

/// The precision of a fit: 1e-9, or a hundred times the rounding of the greatest coordinate of an
/// arc.
double fine(const Program& program) {
  double largest = 0;
  for (const Arc& arc : program.arcs()) {
    largest = std::max(largest, arc.radius);
    for (const double c : arc.center) largest = std::max(largest, std::abs(c));
  }
  return std::max(path_tolerance, path_rounding * largest);
}

/// The curve without the segments that are shorter than the rounding of its times, because knots of
/// a table cannot be that close.
Trajectory without_slivers(const Trajectory& curve) {
  const double shortest = 16 * std::numeric_limits<double>::epsilon() * curve.end();
  std::vector<Segment> segments;
  for (const Segment& segment : curve.segments())
    if (segment.length > shortest) segments.push_back(segment);
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

/// The rule of a missing acceleration, with the names of the axes that have none.
std::string without_acceleration(const PathSpec& path) {
  std::string names;
  for (std::size_t i = 0; i < path.limits.axes.size(); ++i)
    if (!path.limits.axes[i].acceleration)
      names += (names.empty() ? "" : ", ") + path.machine.axes[i].name;
  return "is missing: no axis that moves here has this limit. Add acceleration to the limits of " +
         names + ", or to [path.limits]";
}

/// Adds the name and the unit of the axis to an error: to[3] -> to[3] (z).
InputError named(const InputError& error, const PathSpec& path) {
  const GcodeMachine& machine = path.machine;
  if (error.key() == "acceleration" && error.rule().starts_with("is missing"))
    return {"acceleration", "", without_acceleration(path)};
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    const std::string key = "to[" + std::to_string(i + 1) + "]";
    if (error.key() != key) continue;
    const std::string unit = " " + machine.axes[i].unit;
    const char last = error.rule().empty() ? ' ' : error.rule().back();
    return InputError(key + " (" + machine.axes[i].name + ")", error.value() + unit,
                      error.rule() + (last >= '0' && last <= '9' ? unit : ""));
  }
  return in_unit_of_tool(error, machine.axes.empty() ? "" : machine.axes.front().unit);
}

/// Calls `make`; its errors get the source of the path.
template <class Make>
auto in_source(const PathSpec& path, const Make& make) {
  if (path.program.commands().empty())
    throw InputError("command", "",
                     "is missing: add [[command]], points = \"FILE.csv\" or gcode = { file = "
                     "\"FILE\" }, or name this spec with --machine when you check a G-code "
                     "program");
  try {
    return make();
  } catch (const InputError& error) {
    const InputError placed = named(error, path);
    if (placed.key() == "start") throw InputError("path.start", placed.value(), placed.rule());
    if (error.line() == 0) throw;
    throw InputError(placed.key(), placed.value(), placed.rule()).at(path.source, error.line());
  }
}

/// Names of the segments of overlapping lines.
std::vector<std::string> names_of(const Overlapped& motion, const Trajectory& curve, int first) {
  std::vector<std::string> names;
  std::size_t next = 0;  // the next corner
  for (std::size_t i = 0; i < curve.segments().size(); ++i) {
    const double t = (curve.breaks()[i] + curve.breaks()[i + 1]) / 2;
    while (next < motion.corners.size() &&
           motion.corners[next].time + motion.corners[next].overlap <= t)
      ++next;
    const bool overlaps = next < motion.corners.size() && motion.corners[next].time <= t;
    const int line = overlaps    ? motion.corners[next].line
                     : next == 0 ? first
                                 : motion.corners[next - 1].line;
    names.push_back((overlaps ? "corner " : "line ") + std::to_string(line));
  }
  return names;
}

PathMotion overlapping(const PathSpec& path) {
  PathMotion made;
  made.overlap = std::make_shared<const Overlapped>(
      in_source(path, [&] { return overlapped(path.program, path.limits, *path.overlap); }));
  made.axes.curves = made.overlap->axes;
  made.axes.error.assign(made.axes.curves.size(), {});
  for (const Trajectory& curve : made.axes.curves)
    made.names.push_back(names_of(*made.overlap, curve, path.program.commands().front().line));
  return made;
}

}  // namespace

PathMotion motion_of(const PathSpec& path) {
  if (path.overlap) return overlapping(path);
  PathMotion made;
  const Plan planned = in_source(path, [&] {
    Plan motion = plan(path.program, path.limits, {.joints = path.joints});
    return path.refine ? refined(motion) : std::move(motion);
  });
  made.plan = std::make_shared<const Plan>(played(planned, path.override_steps));
  made.axes = to_axes(*made.plan, path.tolerance.value_or(fine(path.program)));
  for (Trajectory& curve : made.axes.curves) {
    curve = without_slivers(curve);
    made.names.push_back(names_of(*made.plan, curve));
  }
  return made;
}

}  // namespace jounce::design_detail
