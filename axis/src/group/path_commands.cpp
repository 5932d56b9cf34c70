// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/detail/path_commands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "jounce/path/reach.hpp"
#include "jounce/path/rotary.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

double given(double value) {
  return std::isnan(value) ? PathSettings::none : value;
}

bool blends(PathBuffer buffer) {
  return buffer >= PathBuffer::blending_low;
}

Junction junction_of(PathBuffer buffer) {
  switch (buffer) {
    case PathBuffer::aborting:
    case PathBuffer::buffered:
      break;
    case PathBuffer::blending_low:
      return Junction::blending_low;
    case PathBuffer::blending_previous:
      return Junction::blending_previous;
    case PathBuffer::blending_next:
      return Junction::blending_next;
    case PathBuffer::blending_high:
      return Junction::blending_high;
    case PathBuffer::look_ahead:
      return Junction::look_ahead;
  }
  return Junction::buffered;
}

PathSettings settings_of(const command::PathDynamics& path) {
  PathSettings settings{.velocity = given(path.along.velocity),
                        .acceleration = given(path.along.acceleration),
                        .deceleration = given(path.along.deceleration),
                        .jerk = given(path.along.jerk),
                        .junction = junction_of(path.buffer)};
  const bool deviates = !std::isnan(path.deviation);
  const bool cuts = !std::isnan(path.corner_distance);
  if (deviates && cuts)
    throw InputError("corner_distance", path.corner_distance,
                     "cannot be combined with --deviation: give one of them");
  if (!deviates && !cuts) return settings;
  settings.corner = deviates ? Corner::deviation : Corner::distance;
  settings.value = deviates ? path.deviation : path.corner_distance;
  if (blends(path.buffer)) return settings;
  throw InputError(
      deviates ? "deviation" : "corner_distance", settings.value,
      "needs a buffer mode that blends (--blend), because otherwise the command begins "
      "at rest");
}

/// "(10, 0)".
std::string listed_point(const Point& point, std::size_t axes) {
  std::string text;
  for (std::size_t i = 0; i < axes; ++i) text += (i == 0 ? "(" : ", ") + six_digits(point[i]);
  return text + ")";
}

/// Coordinates that are given replace those of `from`, or are added to them.
template <std::size_t N>
Point moved(const Point& from, const std::array<double, N>& by, bool relative) {
  Point to = from;
  for (std::size_t i = 0; i < N; ++i)
    if (!std::isnan(by[i])) to[i] = by[i] + (relative ? from[i] : 0.0);
  return to;
}

template <std::size_t N>
bool is_given(const std::array<double, N>& coordinates) {
  return !std::all_of(coordinates.begin(), coordinates.end(),
                      [](double x) { return std::isnan(x); });
}

template <std::size_t N>
void require_given(const std::array<double, N>& coordinates) {
  if (!is_given(coordinates))
    throw InputError("the command", "", "has no coordinate: give at least one, such as x=10");
}

/// Throws for a coordinate that the group does not have. The subject of the sentence is the command:
/// a sender may give coordinates by names, or by an option.
template <std::size_t N>
void require_axes(const std::array<double, N>& coordinates, std::size_t axes) {
  const auto given = std::find_if(coordinates.rbegin(), coordinates.rend(),
                                  [](double x) { return !std::isnan(x); });
  const auto count = static_cast<std::size_t>(coordinates.rend() - given);
  if (count > axes)
    throw InputError("the command", "",
                     "has " + std::to_string(count) + " coordinates, but the group has " +
                         std::to_string(axes) + " axes");
}

}  // namespace

PathCommands::PathCommands(std::size_t axes, const Point& start, std::int32_t first,
                           std::size_t path_axes)
    : axes_(axes), path_axes_(path_axes), start_(start), first_(first) {}

Point PathCommands::part() const {
  return framed() ? within(frame_, position()) : position();
}

Point PathCommands::machine(const Point& part) const {
  return framed() ? placed(frame_, part) : part;
}

Point PathCommands::machine_end(const Point& end) const {
  if (!framed()) return end;
  const Point from = part();
  const std::size_t m = measured();
  Point to = machine(end);
  if (std::equal(end.begin(), end.begin() + static_cast<std::ptrdiff_t>(m), from.begin()))
    std::copy_n(position().begin(), m, to.begin());
  for (std::size_t i = m; i < axes_; ++i)
    if (end[i] == from[i]) to[i] = position()[i];
  return to;
}

/// The length of a line: that of its path axes, or of its followers if only these move.
double PathCommands::length(const Point& from, const Point& to) const {
  double path = 0;
  double all = 0;
  for (std::size_t i = 0; i < axes_; ++i) {
    all = std::hypot(all, to[i] - from[i]);
    if (i < measured()) path = all;
  }
  return path > 0 ? path : all;
}

const Point& PathCommands::from_of_last() const {
  return all_.size() > 1 ? all_[all_.size() - 2].to : start_;
}

/// True if the last command ends here. In a frame, the coordinates are rounded.
bool PathCommands::is_at(const Point& part) const {
  if (!framed()) return part == position();
  const Point at = machine(part);
  double scale = 1;
  double far = 0;
  for (std::size_t i = 0; i < axes_; ++i) {
    scale = std::max({scale, std::abs(at[i]), std::abs(part[i])});
    far = std::max(far, std::abs(at[i] - position()[i]));
  }
  return far <= profiles_detail::rounded_sum * scale;
}

PathSettings PathCommands::within_limits(PathSettings settings) const {
  settings.velocity = std::min(settings.velocity, limits_.velocity);
  settings.acceleration = std::min(settings.acceleration, limits_.acceleration);
  settings.deceleration = std::min(settings.deceleration, limits_.deceleration);
  settings.jerk = std::min(settings.jerk, limits_.jerk);
  settings.axes = axis_limits_;
  return settings;
}

Point PathCommands::target(const command::Coordinates& to, bool relative) const {
  require_axes(to, axes_);
  require_given(to);
  const Point from = part();
  Point end = moved(from, to, relative);
  for (std::size_t i = measured(); i < std::min(axes_, modulo_.size()) && !relative; ++i)
    if (!std::isnan(to[i])) end[i] = shortest_way(from[i], end[i], modulo_[i]);
  return end;
}

void PathCommands::add_line(const command::Coordinates& to, bool relative,
                            const PathSettings& settings) {
  const Point end = target(to, relative);
  if (is_at(end))
    throw InputError("the move", "",
                     "has no length: the path already ends at " + listed_point(end, axes_) +
                         ": give another position");
  all_.push_back({within_limits(settings), Line{}, machine_end(end), settings.velocity});
}

template <bool relative>
void PathCommands::append(const command::MoveLinear<relative>& line) {
  add_line(line.to, relative, settings_of(line.path));
}

template <bool relative>
void PathCommands::append(const command::MoveDirect<relative>& line) {
  add_line(line.to, relative, settings_of(line.path));
}

template <bool relative>
void PathCommands::append(const command::MoveCircular<relative>& arc) {
  const PathSettings settings = settings_of(arc.path);
  if (measured() < 2)
    throw InputError("an arc", "",
                     "needs two path axes, but the group has only one" +
                         std::string(axes_ > 1 ? ": its other axes are followers" : ""));
  const Point from = part();
  const Point to = is_given(arc.to) ? target(arc.to, relative) : from;
  require_axes(arc.via, axes_);
  const bool through = is_given(arc.via);
  const bool around = is_given(arc.center);
  for (std::size_t i = measured(); i < arc.via.size(); ++i)
    if (!std::isnan(arc.via[i]))
      throw InputError("via", arc.via[i],
                       "is the coordinate of a follower, which has a value at the end of the arc "
                       "only: leave it out");
  const bool by_radius = !std::isnan(arc.radius);
  if (static_cast<int>(through) + static_cast<int>(around) + static_cast<int>(by_radius) != 1)
    throw InputError("an arc", "", "needs exactly one of --via, --center and --radius");
  if (arc.turns > command::most_extra_turns)
    throw InputError("turns", std::to_string(arc.turns),
                     "must be at most " + std::to_string(command::most_extra_turns) +
                         ": send more turns as further commands");
  const Plane plane{0, 1};
  const ArcRotation rotation =
      arc.clockwise ? ArcRotation::clockwise : ArcRotation::counterclockwise;
  const Arc arc_of_part =
      through  ? arc_through(from, moved(from, arc.via, relative), to,
                             std::min<std::size_t>(measured(), 3), arc.turns)
      : around ? arc_about(from, moved(from, arc.center, relative), to, plane, rotation, arc.turns)
               : arc_of_radius(from, arc.radius, to, plane, rotation, arc.turns);
  const Arc made = framed() ? placed(frame_, arc_of_part) : arc_of_part;
  all_.push_back({within_limits(settings), made, made.to, settings.velocity});
}

void PathCommands::append(const command::GroupWait& wait) {
  constexpr double longest_wait = 1e6;  // s
  if (!(wait.duration >= 0 && wait.duration <= longest_wait))
    throw InputError("VALUE", six_digits(wait.duration) + " s", "must be from 0 s to 1e6 s");
  all_.push_back({{}, Wait{wait.duration}, position()});
}

template void PathCommands::append(const command::MoveLinearAbsolute& line);
template void PathCommands::append(const command::MoveLinearRelative& line);
template void PathCommands::append(const command::MoveDirectAbsolute& line);
template void PathCommands::append(const command::MoveDirectRelative& line);
template void PathCommands::append(const command::MoveCircularAbsolute& arc);
template void PathCommands::append(const command::MoveCircularRelative& arc);

namespace {

/// The direction of a jog: its path axes have the length 1, or its followers if only these move.
Point direction_of(const command::GroupJog& jog, std::size_t axes, std::size_t path_axes) {
  require_axes(jog.along, axes);
  const auto length = [&](std::size_t first, std::size_t last) {
    double square = 0;
    for (std::size_t i = first; i < last; ++i)
      if (!std::isnan(jog.along[i])) square += jog.along[i] * jog.along[i];
    return std::sqrt(square);
  };
  const double path = length(0, path_axes);
  const double norm = path != 0 ? path : length(path_axes, axes);
  if (!(norm > 0) || !std::isfinite(norm))
    throw InputError("the direction of the jog", "",
                     "has no length: give a component that is not 0, such as x=1");
  Point direction{};
  for (std::size_t i = 0; i < axes; ++i)
    direction[i] = std::isnan(jog.along[i]) ? 0 : jog.along[i] / norm;
  return direction;
}

constexpr double longest_jog = 3600;  // s

/// A straight line of a jog.
struct JogLine {
  double length = std::numeric_limits<double>::infinity();
  JogEnd end = {};
};

/// To the end of the position range, or as far as an axis moves in an hour.
JogLine line_in_range(const Point& from, const Point& direction, std::span<const Limits> limits) {
  JogLine line;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double u = direction[i];
    if (u == 0) continue;
    const auto& end = u > 0 ? limits[i].position_max : limits[i].position_min;
    if (limits[i].velocity)
      line.length = std::min(line.length, *limits[i].velocity * longest_jog / std::abs(u));
    if (!end || (*end - from[i]) / u >= line.length) continue;
    line = {(*end - from[i]) / u, {.cause = Cause::range_end, .index = i, .limit = *end}};
  }
  return line;
}

/// The velocity along a line that the limits of the coordinates and of the path permit.
double velocity_along(const Point& direction, double velocity, const GroupSpace& space) {
  for (std::size_t i = 0; i < space.limits.size(); ++i)
    if (space.limits[i].velocity && direction[i] != 0)
      velocity = std::min(velocity, *space.limits[i].velocity / std::abs(direction[i]));
  return std::min(velocity, space.path.velocity);
}

/// The line of a jog, as far as the joints reach.
JogLine line_in_reach(const JogLine& line, const Point& from, const Point& direction,
                      double velocity, const GroupSpace& space) {
  const Reach reached = reach(*space.map, space.joints, from, direction, line.length, velocity);
  if (reached.end == LineEnd::length) return line;
  const Cause cause = reached.end == LineEnd::joint_limit ? Cause::range_end
                      : reached.end == LineEnd::singular  ? Cause::singular_end
                                                          : Cause::reach_end;
  return {reached.length,
          {.cause = cause, .of_joint = true, .index = reached.joint, .limit = reached.limit}};
}

}  // namespace

void PathCommands::append(const command::GroupJog& jog, const GroupSpace& space) {
  Point direction = direction_of(jog, axes_, measured());
  if (framed()) direction = placed({{}, frame_.rotation}, direction);
  const PathSettings commanded = settings_of({.along = jog.dynamics});
  const PathSettings settings = within_limits(commanded);
  JogLine line = line_in_range(position(), direction, std::span(space.limits).first(axes_));
  const double velocity = velocity_along(direction, settings.velocity, space);
  if (space.map) line.length = std::min(line.length, velocity * longest_jog);
  if (!std::isfinite(line.length))
    throw InputError("the jog", "",
                     "has no end: add position_min and position_max to the limits of the [[axis]] "
                     "in the kinematics of the group, or give the jog a velocity");
  if (space.map && line.length > 0)
    line = line_in_reach(line, position(), direction, velocity, space);
  constexpr double shortest_jog = 1e-8;  // u: the margin of a joint at the end of its range
  if (!(line.length > (space.map ? shortest_jog : 0))) throw JogLeadsOutward(line.end);
  Point to = position();
  for (std::size_t i = 0; i < axes_; ++i)
    if (direction[i] != 0)
      to[i] = std::clamp(to[i] + line.length * direction[i],
                         space.limits[i].position_min.value_or(-PathSettings::none),
                         space.limits[i].position_max.value_or(PathSettings::none));
  line.end.place = to;
  jog_end_ = line.end;
  all_.push_back({settings, Line{}, to, commanded.velocity});
}

void PathCommands::append(const ClientCommand& command, const GroupSpace& space) {
  std::visit(
      [&](const auto& what) {
        using What = std::remove_cvref_t<decltype(what)>;
        if constexpr (std::is_same_v<What, command::GroupJog>)
          append(what, space);
        else if constexpr (requires { append(what); })
          append(what);
        else
          throw InputError("command", "", "is not a motion of a group");
      },
      command);
}

std::optional<LoweredVelocity> PathCommands::lowered_velocity(const GroupSpace& space) const {
  if (all_.empty() || std::holds_alternative<Wait>(all_.back().what)) return std::nullopt;
  const One& last = all_.back();
  if (!std::isfinite(last.commanded)) return std::nullopt;
  const bool is_line = std::holds_alternative<Line>(last.what);
  const Point& from = from_of_last();
  const double whole = length(from, last.to);
  double most = std::min(space.path.velocity, limits_.velocity);
  if (is_line && whole > 0) {
    Point direction{};
    for (std::size_t i = 0; i < axes_; ++i) direction[i] = (last.to[i] - from[i]) / whole;
    most = std::min(most, velocity_along(direction, most, space));
  }
  if (!(last.commanded > most * (1 + profiles_detail::rounded_input))) return std::nullopt;
  return LoweredVelocity{last.commanded, most, is_line && !space.map};
}

std::optional<std::size_t> PathCommands::moves_only_follower() const {
  if (all_.empty() || !std::holds_alternative<Line>(all_.back().what)) return std::nullopt;
  for (std::size_t i = 0; i < axes_; ++i)
    if (all_.back().to[i] != from_of_last()[i])
      return i < measured() ? std::nullopt : std::optional(i);
  return std::nullopt;
}

bool PathCommands::moves() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const One& one) { return !std::holds_alternative<Wait>(one.what); });
}

Program PathCommands::program() const {
  Program program(axes_, start_, path_axes_);
  std::int32_t number = first_;
  for (const One& one : all_) {
    if (const Wait* const wait = std::get_if<Wait>(&one.what)) {
      program.dwell(wait->duration, number++);
      continue;
    }
    program.set(one.settings);
    if (const Arc* const arc = std::get_if<Arc>(&one.what))
      program.arc(*arc, number++);
    else
      program.line(one.to, number++);
  }
  return program;
}

PathCommands PathCommands::stopping() const {
  PathCommands same = *this;
  const auto last = std::find_if(same.all_.rbegin(), same.all_.rend(), [](const One& one) {
    return !std::holds_alternative<Wait>(one.what);
  });
  if (last == same.all_.rend()) return same;
  last->settings.corner = Corner::stop;
  last->settings.junction = Junction::buffered;
  return same;
}

PathCommands PathCommands::slowed(const Plan& plan) const {
  std::vector<double> peaks(all_.size(), 0.0);
  const auto pieces = plan.path().pieces();
  for (const LawInterval& s : plan.law().stretches())
    for (std::size_t k = s.piece; k < s.piece + s.pieces; ++k) {
      double& peak = peaks[static_cast<std::size_t>(pieces[k].line - first_)];
      peak = std::max(peak, s.peak);
    }
  PathCommands same = *this;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (peaks[i] == 0 && i > 0) peaks[i] = peaks[i - 1];  // a line that the planner has joined
    if (peaks[i] > 0)
      same.all_[i].settings.velocity = std::min(same.all_[i].settings.velocity, peaks[i]);
  }
  return same;
}

PathCommands PathCommands::from(std::int32_t number) const {
  const std::int32_t skipped = std::clamp(number, first_, last() + 1) - first_;
  PathCommands rest(axes_, skipped == 0 ? start_ : all_[static_cast<std::size_t>(skipped) - 1].to,
                    first_ + skipped, path_axes_);
  rest.modulo_ = modulo_;
  rest.frame_ = frame_;
  rest.limits_ = limits_;
  rest.axis_limits_ = axis_limits_;
  rest.limits_vary_ = limits_vary_;
  rest.all_.assign(all_.begin() + skipped, all_.end());
  return rest;
}

std::int32_t PathCommands::number_at(std::int32_t number, double u) const {
  const auto is_line = [&](std::int32_t k) {
    return k >= first_ && k <= last() &&
           std::holds_alternative<Line>(all_[static_cast<std::size_t>(k - first_)].what);
  };
  for (double end = 0; is_line(number) && is_line(number + 1); ++number) {
    const auto k = static_cast<std::size_t>(number - first_);
    end += length(k == 0 ? start_ : all_[k - 1].to, all_[k].to);
    if (u < end) break;
  }
  return number;
}

Frame frame_of(const command::SetCoordinateTransform& what, std::size_t axes,
               std::size_t path_axes) {
  require_axes(what.offset, axes);
  Point offset{};
  for (std::size_t i = 0; i < axes; ++i)
    if (!std::isnan(what.offset[i])) offset[i] = what.offset[i];
  const bool turns = !std::isnan(what.rotation);
  if (is_given(what.zyz)) {
    if (turns) throw InputError("zyz", "", "cannot be combined with --rotation: give one of them");
    if (path_axes < 3) throw InputError("zyz", "", "needs a group with three path axes");
    std::array<double, 3> angles{};
    for (std::size_t i = 0; i < 3; ++i) angles[i] = std::isnan(what.zyz[i]) ? 0 : what.zyz[i];
    return euler_frame(offset, angles);
  }
  if (turns && path_axes < 2)
    throw InputError("rotation", what.rotation, "needs a group with two path axes");
  return turned_frame(offset, turns ? what.rotation : 0);
}

Frame shifted(Frame frame, const command::GroupSetPosition& what, const Point& machine,
              std::size_t axes) {
  require_axes(what.to, axes);
  require_given(what.to);
  const Point wanted = placed(frame, moved(within(frame, machine), what.to, what.relative));
  for (std::size_t i = 0; i < axes; ++i) frame.offset[i] += machine[i] - wanted[i];
  return frame;
}

}  // namespace jounce
