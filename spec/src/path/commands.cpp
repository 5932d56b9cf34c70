// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>
#include <vector>

#include "jounce/path/arc.hpp"
#include "jounce/path/shapes.hpp"

#include "spec/src/path/parts.hpp"

namespace jounce::spec_detail {
namespace {

constexpr double curve_tolerance = 1e-9;  ///< share of the size of a curve

const std::vector<std::string> command_types{"line",   "arc",     "ellipse",
                                             "spline", "bspline", "dwell"};
const std::vector<std::string> rotations{"clockwise", "counterclockwise"};

/// The point from which positions count: the start of a relative command, otherwise 0.
Point base(const Point* origin) {
  return origin != nullptr ? *origin : Point{};
}

/// Reads the rates of a command along the path; omitted rates are those of [path.limits].
void read_rates_along(TomlReader& command, const PathAxes& axes, PathSettings& settings) {
  if (const auto a = command.optional_positive("acceleration", axes.unit(2)))
    settings.acceleration = settings.deceleration = *a;
  if (const auto d = command.optional_positive("deceleration", axes.unit(2)))
    settings.deceleration = *d;
  if (const auto j = command.optional_positive("jerk", axes.unit(3))) settings.jerk = *j;
}

/// Reads axis_limits = { x = { velocity = 50 }, ... }: further limits of the axes from this command on.
void read_axis_limits(TomlReader& command, const PathAxes& axes, PathSettings& settings) {
  auto limits = command.optional_table("axis_limits");
  if (!limits) return;
  settings.axes.clear();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    auto axis = limits->optional_table(axes.names[i].c_str());
    if (!axis) continue;
    settings.axes.resize(i + 1);
    const auto unit = [&](int order) {
      return rate_unit(axes.position_units[i], axes.units.x, order);
    };
    AxisRates& rates = settings.axes[i];
    if (const auto v = axis->optional_positive("velocity", unit(1))) rates.velocity = *v;
    if (const auto a = axis->optional_positive("acceleration", unit(2))) rates.acceleration = *a;
    if (const auto j = axis->optional_positive("jerk", unit(3))) rates.jerk = *j;
    axis->finish();
  }
  limits->finish();
}

Plane read_plane(TomlReader& command, const PathAxes& axes) {
  const std::vector<std::string> names = command.texts("plane");
  if (!command.has("plane")) return {};
  std::vector<std::size_t> found;
  for (const std::string& name : names)
    for (std::size_t i = 0; i < axes.path_axes; ++i)
      if (axes.names[i] == name) found.push_back(i);
  if (names.size() != 2 || found.size() != 2 || names[0] == names[1])
    command.fail("plane", "",
                 "must name two different axes that are not followers, such as [\"x\", \"y\"]");
  return {found[0], found[1]};
}

ArcRotation read_rotation(TomlReader& command) {
  return command.choice("rotation", rotations) == 0 ? ArcRotation::clockwise
                                                    : ArcRotation::counterclockwise;
}

int read_turns(TomlReader& command) {
  const std::int64_t turns = command.optional_whole("turns").value_or(0);
  if (turns < 0 || turns > 1'000'000)
    command.fail("turns", std::to_string(turns), "must be 0 to 1e6 extra turns");
  return static_cast<int>(turns);
}

Arc read_arc_about(TomlReader& command, const PathAxes& axes, const Point& from,
                   const Point* origin) {
  command.describe("an arc with center");
  const Plane plane = read_plane(command, axes);
  const Point center = read_position(command, "center", axes, base(origin), Followers::optional);
  if (const auto angle = command.optional_number("angle", "deg")) {
    command.refuse_here("to", "cannot be combined with angle: leave one of the two out");
    return arc_by_angle(from, center, *angle, from, plane);
  }
  const Point to = read_end(command, axes, from, origin);
  const ArcRotation rotation = read_rotation(command);
  const int turns = read_turns(command);
  const auto tolerance = command.optional_positive("tolerance", axes.unit(0));
  return tolerance ? arc_about(from, center, to, plane, rotation, turns, *tolerance)
                   : arc_about(from, center, to, plane, rotation, turns);
}

constexpr const char* one_definition =
    "cannot be combined with another definition of the arc: give only one of center, radius and "
    "via";

/// Reads an arc by one of its definitions. finish() then rejects the keys of the others, which were
/// not read.
Arc read_arc(TomlReader& command, const PathAxes& axes, const Point& from, const Point* origin) {
  if (command.has("via")) {
    command.describe("an arc with via");
    for (const char* key : {"center", "radius"}) command.refuse_here(key, one_definition);
    const Point via = read_position(command, "via", axes, base(origin), Followers::optional);
    const Point to = read_end(command, axes, from, origin);
    return arc_through(from, via, to, axes.path_axes, read_turns(command));
  }
  if (command.has("radius")) {
    command.describe("an arc with radius");
    command.refuse_here("center", one_definition);
    const Plane plane = read_plane(command, axes);
    const double radius = command.number("radius", axes.unit(0));
    const Point to = read_end(command, axes, from, origin);
    const ArcRotation rotation = read_rotation(command);
    return arc_of_radius(from, radius, to, plane, rotation, read_turns(command));
  }
  if (!command.has("center"))
    command.fail("center", "", "is missing: add center, radius or via to this arc");
  return read_arc_about(command, axes, from, origin);
}

void read_dwell(TomlReader& command, const PathAxes& axes, Program& program) {
  const double time = command.number("time", axes.units.x);
  if (!(time >= 0)) command.fail("time", number(time), "must not be negative");
  program.dwell(time, command.line());
}

PathCurve read_ellipse(TomlReader& command, const PathAxes& axes, const Point& from,
                       const Point* origin) {
  const Plane plane = read_plane(command, axes);
  const Point center = read_position(command, "center", axes, base(origin), Followers::optional);
  const Point to = read_end(command, axes, from, origin);
  const double major = command.optional_number("major", "deg").value_or(0);
  const double ratio = command.number("ratio", "1");
  const ArcRotation rotation = read_rotation(command);
  return ellipse(from, center, to, plane, major, ratio, rotation, axes.size(),
                 {.extra_turns = read_turns(command), .path_axes = axes.path_axes});
}

/// Reads the start and each [[command.point]].
std::vector<Point> read_curve_points(TomlReader& command, const PathAxes& axes, const Point& from,
                                     const Point* origin) {
  std::vector<Point> points{from};
  for (TomlReader& point : command.tables("point")) {
    points.push_back(read_end(point, axes, points.back(), origin));
    point.finish();
  }
  if (points.size() == 1)
    command.fail("point", "",
                 "is missing: add point = [{ to = [NUMBER, ...] }], with at least one point");
  return points;
}

PathCurve read_b_spline(TomlReader& command, const PathAxes& axes, const Point& from,
                        const Point* origin) {
  const std::vector<Point> points = read_curve_points(command, axes, from, origin);
  const std::size_t degree = command.optional_count("degree").value_or(3);
  std::vector<double> knots;
  if (command.has("knots")) knots = command.number_list("knots", "1");
  const PathCurve curve = b_spline(points, axes.size(), degree, knots);
  const auto travel = [&](std::size_t count) {
    double sum = 0;
    for (std::size_t k = 1; k < points.size(); ++k)
      for (std::size_t i = 0; i < count; ++i) sum += std::abs(points[k][i] - points[k - 1][i]);
    return sum;
  };
  const double size = travel(axes.path_axes) > 0 ? travel(axes.path_axes) : travel(axes.size());
  const auto tolerance = command.optional_positive("tolerance", axes.unit(0));
  return over_length(curve, tolerance.value_or(curve_tolerance * size), axes.path_axes);
}

/// Makes the spline through the start and each point; with a tolerance, as a function of its arc
/// length.
PathCurve read_spline(TomlReader& command, const PathAxes& axes, const Point& from,
                      const Point* origin) {
  const std::vector<Point> points = read_curve_points(command, axes, from, origin);
  SplineDirections ends;
  if (command.has("start_direction"))
    ends.start = read_position(command, "start_direction", axes, {});
  if (command.has("end_direction")) ends.end = read_position(command, "end_direction", axes, {});
  const PathCurve curve = spline_through(points, axes.size(), ends, axes.path_axes);
  const auto tolerance = command.optional_positive("tolerance", axes.unit(0));
  return tolerance ? over_length(curve, *tolerance, axes.path_axes) : curve;
}

void read_movement(TomlReader& command, const PathAxes& axes, std::size_t type, Program& program) {
  const Point from = program.position();
  const bool relative = command.optional_flag("relative").value_or(false);
  const Point* const origin = relative ? &from : nullptr;
  switch (type) {
    case 0:
      return program.line(read_end(command, axes, from, origin), command.line());
    case 1:
      return program.arc(read_arc(command, axes, from, origin), command.line());
    case 2:
      return program.curve(read_ellipse(command, axes, from, origin), command.line());
    case 4:
      return program.curve(read_b_spline(command, axes, from, origin), command.line());
    default:
      return program.curve(read_spline(command, axes, from, origin), command.line());
  }
}

}  // namespace

namespace {

/// The key of the spec for that of the library, which counts the start of a curve as points[1].
std::string key_of(const std::string& key) {
  const std::string points = "points[";
  if (!key.starts_with(points)) return key;
  const int number = std::stoi(key.substr(points.size()));
  return number < 2 ? "point" : "point[" + std::to_string(number - 1) + "]";
}

}  // namespace

void read_path_command(TomlReader& command, const PathAxes& axes, PathSettings& settings,
                       Program& program) {
  const std::size_t type = command.variant("type", command_types);
  if (type == 5) {
    read_dwell(command, axes, program);
  } else {
    read_path_settings(command, axes, settings);
    read_rates_along(command, axes, settings);
    read_axis_limits(command, axes, settings);
    program.set(settings);
    try {
      read_movement(command, axes, type, program);
    } catch (
        const InputError& error) {  // an arc names its own fields, which are keys of the command
      if (!error.document().empty()) throw;
      throw InputError(command.path(key_of(error.key())), error.value(), error.rule());
    }
  }
  command.finish();
}

}  // namespace jounce::spec_detail
