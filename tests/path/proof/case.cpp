// SPDX-License-Identifier: Apache-2.0
#include "path/proof/case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace jounce::path_proof {
namespace {

std::string list(const Point& p, std::size_t axes) {
  std::string all = "[";
  for (std::size_t i = 0; i < axes; ++i) all += (i > 0 ? ", " : "") + text(p[i]);
  return all + "]";
}

/// `key = value` of each rate that is limited, joined by `between`.
std::string listed(std::initializer_list<std::pair<const char*, double>> rates,
                   const char* between) {
  std::string all;
  for (const auto& [key, value] : rates)
    if (std::isfinite(value)) all += (all.empty() ? "" : between) + (key + (" = " + text(value)));
  return all;
}

std::string corner_text(const PathSettings& s) {
  const char* const keys[] = {"", "deviation", "distance", "curvature", "velocity", "average"};
  if (s.corner == Corner::stop) return "\"stop\"";
  return std::string("{ ") + keys[static_cast<int>(s.corner)] + " = " + text(s.value) + " }";
}

/// Limits of axes in a command.
std::string axis_limits_text(const std::vector<AxisRates>& axes) {
  std::string all;
  for (std::size_t i = 0; i < axes.size(); ++i)
    all += (i > 0 ? ", a" : "a") + std::to_string(i + 1) + " = { " +
           listed({{"velocity", axes[i].velocity},
                   {"acceleration", axes[i].acceleration},
                   {"jerk", axes[i].jerk}},
                  ", ") +
           " }";
  return "axis_limits = { " + all + " }\n";
}

std::string command_text(const Case& c, const Leg& leg) {
  const char* const types[] = {"line", "arc", "spline"};
  const char* const junctions[] = {"buffered",      "blending_low",  "blending_previous",
                                   "blending_next", "blending_high", "look_ahead"};
  std::string all;
  if (leg.dwell > 0) all += "[[command]]\ntype = \"dwell\"\ntime = " + text(leg.dwell) + "\n";
  all += std::string("[[command]]\ntype = \"") + types[static_cast<int>(leg.shape)] + "\"\n";
  const PathSettings& s = leg.settings;
  all += axis_limits_text(s.axes);
  const std::string rates = listed({{"velocity", s.velocity},
                                    {"acceleration", s.acceleration},
                                    {"deceleration", s.deceleration},
                                    {"jerk", s.jerk}},
                                   "\n");
  all += (rates.empty() ? "" : rates + "\n") + "corner = " + corner_text(s) + "\n";
  all += std::string("junction = \"") + junctions[static_cast<int>(s.junction)] + "\"\n";
  if (leg.shape == Leg::Shape::arc) all += "via = " + list(leg.via, c.axes) + "\n";
  if (leg.shape != Leg::Shape::spline) return all + "to = " + list(leg.to, c.axes) + "\n";
  all += "point = [";
  for (const Point& p : leg.through) all += "{ to = " + list(p, c.axes) + " }, ";
  return all + "{ to = " + list(leg.to, c.axes) + " }]\n";
}

/// The part of an arc from one share of its sweep to another.
Arc part_of(const Arc& whole, double from, double to) {
  Arc part = whole;
  const double angle = whole.sweep * from;
  for (std::size_t i = 0; i < max_axes; ++i) {
    part.e1[i] = whole.e1[i] * std::cos(angle) + whole.e2[i] * std::sin(angle);
    part.e2[i] = whole.e2[i] * std::cos(angle) - whole.e1[i] * std::sin(angle);
    part.center[i] += whole.drift[i] * from;
    part.drift[i] = whole.drift[i] * (to - from);
  }
  part.sweep = whole.sweep * (to - from);
  part.to = to == 1 ? whole.to : point_at(whole, whole.sweep * to);
  return part;
}

}  // namespace

std::string text(double x) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", x);
  return digits;
}

double Case::size(std::size_t axis) const {
  double most = std::abs(start[axis]);
  for (const Leg& leg : legs) most = std::max(most, std::abs(leg.to[axis]));
  return most;
}

bool Case::has(Leg::Shape shape) const {
  return std::ranges::any_of(legs, [shape](const Leg& leg) { return leg.shape == shape; });
}

Arc arc_of(const Case& c, std::size_t leg) {
  return arc_through(c.from(leg), c.legs[leg].via, c.legs[leg].to, c.path_axes);
}

Program program_of(const Case& c, int parts) {
  Program p(c.axes, c.start, c.path_axes);
  for (std::size_t k = 0; k < c.legs.size(); ++k) {
    const Leg& leg = c.legs[k];
    const int line = static_cast<int>(k) + 1;
    const Point from = p.position();
    if (leg.dwell > 0) p.dwell(leg.dwell, line);
    p.set(leg.settings);
    if (leg.shape == Leg::Shape::spline) {
      std::vector<Point> points{from};
      points.insert(points.end(), leg.through.begin(), leg.through.end());
      points.push_back(leg.to);
      p.curve(spline_through(points, c.axes), line);
      continue;
    }
    const Arc arc = leg.shape == Leg::Shape::arc ? arc_of(c, k) : Arc{};
    for (int i = 1; i <= parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      if (leg.shape == Leg::Shape::arc) {
        p.arc(parts == 1 ? arc : part_of(arc, (i - 1.0) / parts, share), line);
        continue;
      }
      Point to = leg.to;
      for (std::size_t n = 0; n < c.axes && i < parts; ++n)
        to[n] = from[n] + (leg.to[n] - from[n]) * share;
      p.line(to, line);
    }
  }
  return p;
}

std::string spec_of(const Case& c, const std::string& in_path, const std::string& rest) {
  std::string all = "jounce = 1\nkind = \"path\"\nname = \"random\"\n";
  all += "units = { position = \"mm\", time = \"s\" }\n" + rest;
  all += "[path]\nstart = " + list(c.start, c.axes) + "\n" + in_path;
  const PathLimits& p = c.limits.path;
  const std::string along = listed({{"velocity", p.velocity},
                                    {"acceleration", p.acceleration},
                                    {"deceleration", p.deceleration},
                                    {"jerk", p.jerk},
                                    {"normal_acceleration", p.normal_acceleration},
                                    {"total_acceleration", p.total_acceleration}},
                                   ", ");
  if (!along.empty()) all += "limits = { " + along + " }\n";
  for (std::size_t i = 0; i < c.axes; ++i) {
    const Limits& l = c.limits.axes[i];
    all += "[[axis]]\nname = \"a" + std::to_string(i + 1) + "\"\n";
    if (i >= c.path_axes) all += "follower = true\n";
    const std::string rates = listed({{"velocity", l.velocity.value_or(PathSettings::none)},
                                      {"acceleration", l.acceleration.value_or(PathSettings::none)},
                                      {"jerk", l.jerk.value_or(PathSettings::none)}},
                                     ", ");
    if (!rates.empty()) all += "limits = { " + rates + " }\n";
  }
  for (const Leg& leg : c.legs) all += command_text(c, leg);
  return all;
}

Case scaled(Case c, double length, double time) {
  c = mapped(c, [length](Point p) {
    for (double& x : p) x *= length;
    return p;
  });
  const double v = length / time;
  const double a = v / time;
  const double j = a / time;
  for (Leg& leg : c.legs) {
    PathSettings& s = leg.settings;
    s.velocity *= v;
    s.acceleration *= a;
    s.deceleration *= a;
    s.jerk *= j;
    s.value *= s.corner == Corner::velocity    ? v
               : s.corner == Corner::curvature ? 1 / length
                                               : length;
    for (AxisRates& axis : s.axes) axis = {axis.velocity * v, axis.acceleration * a, axis.jerk * j};
    leg.dwell *= time;
  }
  for (Limits& l : c.limits.axes)
    l = {.velocity = *l.velocity * v, .acceleration = *l.acceleration * a, .jerk = *l.jerk * j};
  PathLimits& p = c.limits.path;
  p = {p.velocity * v, p.acceleration * a,        p.deceleration * a,
       p.jerk * j,     p.normal_acceleration * a, p.total_acceleration * a};
  return c;
}

}  // namespace jounce::path_proof
