// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/program.hpp"

#include <algorithm>
#include <string>

#include "jounce/path/path.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/geometry/vector.hpp"
#include "path/src/rate.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

void require_axes(std::size_t axes, std::size_t path_axes) {
  if (axes < 1 || axes > max_axes)
    throw InputError("axes", std::to_string(axes), "must be 1 to " + std::to_string(max_axes));
  if (path_axes > axes)
    throw InputError("path_axes", std::to_string(path_axes),
                     "must be at most the number of axes, " + std::to_string(axes));
}

void require_on_axes(const Point& p, std::size_t axes, int line) {
  for (std::size_t i = 0; i < max_axes; ++i)
    if (!std::isfinite(p[i]) || (i >= axes && p[i] != 0))
      throw InputError("to[" + std::to_string(i + 1) + "]", p[i],
                       i < axes ? "must be finite" : "is beyond the axes of the program")
          .at({}, line);
}

}  // namespace

Program::Program(std::size_t axes, const Point& start, std::size_t path_axes)
    : axes_(axes), path_axes_(path_axes == 0 ? axes : path_axes), start_(start), position_(start) {
  require_axes(axes_, path_axes_);
  require_on_axes(start, axes_, 0);
}

void Program::set(const PathSettings& settings) {
  require_rate("velocity", settings.velocity);
  require_rate("acceleration", settings.acceleration);
  require_rate("deceleration", settings.deceleration);
  require_rate("jerk", settings.jerk);
  for (const AxisRates& axis : settings.axes) {
    require_rate("velocity", axis.velocity);
    require_rate("acceleration", axis.acceleration);
    require_rate("jerk", axis.jerk);
  }
  if (settings.corner != Corner::stop) require_positive("value", settings.value);
  if (settings_.back() == settings) return;
  const bool unused = commands_.empty() || commands_.back().settings + 1 != settings_.size();
  if (unused)
    settings_.back() = settings;
  else if (settings_.size() < PathPiece::most_settings)
    settings_.push_back(settings);
  else
    throw InputError("settings", std::to_string(settings_.size() + 1),
                     "must be at most " + std::to_string(PathPiece::most_settings) +
                         " in a program: divide the program");
}

void Program::line(const Point& to, int line) {
  require_on_axes(to, axes_, line);
  commands_.push_back(
      {numbers_.size(), line, static_cast<std::uint32_t>(settings_.size() - 1), Kind::line});
  numbers_.insert(numbers_.end(), to.begin(), to.begin() + static_cast<std::ptrdiff_t>(axes_));
  position_ = to;
}

void Program::arc(const Arc& arc, int line) {
  require_on_axes(arc.to, axes_, line);
  const double gap = vec::distance(point_at(arc, 0), position_);
  const double scale = arc.radius + vec::norm(position_);
  if (!(arc.radius > 0) || !(arc.sweep > 0) || !(gap <= rounded_input * scale))
    throw InputError("arc", gap, "must begin at the end of the command before, with a radius > 0")
        .at({}, line);
  for (std::size_t i = path_axes_; i < max_axes; ++i)
    if (arc.e1[i] != 0 || arc.e2[i] != 0)
      throw InputError("plane", "",
                       path_axes_ < 2
                           ? "needs two axes, but this path has only one: all other axes "
                             "are followers"
                           : "must not contain a follower: name two of the first " +
                                 std::to_string(path_axes_) + " axes")
          .at({}, line);
  commands_.push_back(
      {arcs_.size(), line, static_cast<std::uint32_t>(settings_.size() - 1), Kind::arc});
  arcs_.push_back(arc);
  position_ = arc.to;
}

void Program::curve(const PathCurve& curve, int line) {
  require_on_axes(curve.to, axes_, line);
  const double gap = vec::distance(curve.from, position_);
  if (curve.axes != axes_ || curve.segments.empty() ||
      !(gap <= rounded_input * (curve.length + vec::norm(position_))))
    throw InputError("curve", gap,
                     "must have the axes of the program and begin at the end of the command before")
        .at({}, line);
  commands_.push_back(
      {curves_.size(), line, static_cast<std::uint32_t>(settings_.size() - 1), Kind::curve});
  curves_.push_back(curve);
  position_ = curve.to;
}

void Program::dwell(double seconds, int line) {
  if (!(seconds >= 0) || !std::isfinite(seconds))
    throw InputError("dwell", seconds, "must be finite and not negative").at({}, line);
  commands_.push_back(
      {numbers_.size(), line, static_cast<std::uint32_t>(settings_.size() - 1), Kind::dwell});
  numbers_.push_back(seconds);
}

Point Program::place_before(std::size_t command) const {
  while (command-- > 0) {
    const Command& one = commands_[command];
    if (one.kind == Kind::arc) return arcs_[one.data].to;
    if (one.kind == Kind::curve) return curves_[one.data].to;
    if (one.kind == Kind::dwell) continue;
    Point place{};
    std::copy_n(numbers_.begin() + static_cast<std::ptrdiff_t>(one.data), axes_, place.begin());
    return place;
  }
  return start_;
}

Program Program::part(std::size_t first, std::size_t last) const {
  Program some(axes_, place_before(first), path_axes_);
  for (std::size_t k = first; k < last; ++k) {
    const Command& one = commands_[k];
    some.set(settings_[one.settings]);
    if (one.kind == Kind::line) some.line(place_before(k + 1), one.line);
    if (one.kind == Kind::arc) some.arc(arcs_[one.data], one.line);
    if (one.kind == Kind::curve) some.curve(curves_[one.data], one.line);
    if (one.kind == Kind::dwell) some.dwell(numbers_[one.data], one.line);
  }
  return some;
}

}  // namespace jounce
