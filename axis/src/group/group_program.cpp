// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/detail/group_program.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "jounce/path/axes_by_stretch.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/src/group/axis_pass.hpp"

namespace jounce {
namespace {

constexpr double admitted_excess = 1e-9;  ///< relative, as for a table
/// The limits of the MotionAxis of a group exceed those of its axes by this factor: they never bind.
constexpr double not_binding = 1000;

/// The line of the command that goes to the place of a piece: for a corner, the command before it.
template <class Piece>
int line_of_position(Piece piece, Piece first) {
  const bool corner = piece->kind == PieceKind::turn || piece->kind == PieceKind::blend;
  return corner && piece != first ? std::prev(piece)->line : piece->line;
}

/// The planned motion of one axis of a group, and how messages name it.
struct PlannedAxis {
  const std::string& name;
  const std::string& unit;  ///< "mm"; "": not known
  const Plan& plan;
  const AxisConfig& config;

  /// "mm/s^2"; "u/s^2" if the unit is not known.
  [[nodiscard]] std::string rate(int order) const {
    const std::string length = unit.empty() ? "u" : unit;
    return order == 0 ? unit : length + (order == 1 ? "/s" : "/s^" + std::to_string(order));
  }
  /// The error, with the line of the command that the plan executes at this time.
  [[nodiscard]] InputError error(int order, double value, double where,
                                 const std::string& rule) const {
    constexpr std::array quantities{"position", "velocity", "acceleration", "jerk"};
    const auto pieces = plan.drawn().pieces();
    const double q = plan.law().at(where).position;
    const auto after = std::upper_bound(pieces.begin(), pieces.end(), q,
                                        [](double at, const PathPiece& p) { return at < p.start; });
    int line = after == pieces.begin() ? 0 : std::prev(after)->line;
    if (line > 0 && order == 0) line = line_of_position(std::prev(after), pieces.begin());
    return InputError(name + "." + quantities[static_cast<std::size_t>(order)],
                      six_digits(value) + (order == 0 && unit.empty() ? "" : " " + rate(order)),
                      rule)
        .at({}, line);
  }
};

std::string at_time(double where) {
  return "at " + six_digits(where) + " s";
}

/// Throws if the extremum of this order exceeds the limit.
void require_within(const PlannedAxis& axis, int order, const Extremum& peak,
                    const std::optional<double>& limit) {
  if (!limit || std::abs(peak.value) <= *limit * (1 + admitted_excess)) return;
  throw axis.error(order, std::abs(peak.value), peak.where,
                   at_time(peak.where) + " exceeds the limit of the axis, " + six_digits(*limit) +
                       " " + axis.rate(order) + ": lower the limits of the path");
}

void require_inside(const PlannedAxis& axis, const Range& position) {
  const Limits& limits = axis.config.limits;
  const double near = admitted_excess * (position.max.value - position.min.value);
  const std::string unit = axis.unit.empty() ? "" : " " + axis.unit;
  const double span = position.max.value - position.min.value;
  const double room =
      limits.position_max.value_or(INFINITY) - limits.position_min.value_or(-INFINITY);
  const std::string remedy = span > room ? "make the path smaller: it spans " + six_digits(span) +
                                               unit + ", the axis " + six_digits(room) + unit
                                         : "shift the path";
  const auto reject = [&](const Extremum& end, const char* rule, double limit) {
    throw axis.error(
        0, end.value, end.where,
        at_time(end.where) + rule + " of the axis, " + six_digits(limit) + unit + ": " + remedy);
  };
  if (limits.position_max && position.max.value > *limits.position_max + near)
    reject(position.max, " exceeds position_max", *limits.position_max);
  if (limits.position_min && position.min.value < *limits.position_min - near)
    reject(position.min, " is less than position_min", *limits.position_min);
}

/// A step of the velocity counts as the acceleration that makes it in one tick, and a step of the
/// acceleration as such a jerk, as in a table.
void require_smooth(const PlannedAxis& axis, const AxisSteps& steps) {
  const Limits& limits = axis.config.limits;
  const double tick = seconds(axis.config.period);
  const auto at_most = [&](int order, double most) {
    return "must be at most " + six_digits(most) + " " + axis.rate(order);
  };
  const Jump& position = steps.position;
  const double rounding = profiles_detail::rounded_input * *limits.velocity;
  if (std::abs(position.step) > rounding * tick)
    throw axis.error(0, position.step, position.where,
                     "is a step " + at_time(position.where) +
                         ", from rounding: divide the path, or use smaller coordinates and radii");
  const Jump& velocity = steps.velocity;
  const double most = *limits.acceleration * tick + rounding;
  if (std::abs(velocity.step) > most)
    throw axis.error(1, velocity.step, velocity.where,
                     "is a step " + at_time(velocity.where) + ", and " + at_most(1, most) +
                         ": the acceleration limit times one cycle");
  if (!limits.jerk) return;
  const Jump& acceleration = steps.acceleration;
  const double most_acceleration = *limits.jerk * tick;
  if (std::abs(acceleration.step) > most_acceleration * (1 + admitted_excess))
    throw axis.error(2, acceleration.step, acceleration.where,
                     "is a step " + at_time(acceleration.where) + ", and " +
                         at_most(2, most_acceleration) +
                         ": the jerk limit times one cycle. Give the path a jerk limit, and round "
                         "its corners: the curvature steps between a line and an arc");
}

std::optional<double> lower(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::min(*a, *b) : a ? a : b;
}

double norm(std::span<const AxisConfig> axes, double (*of)(const AxisConfig&)) {
  double sum = 0;
  for (const AxisConfig& axis : axes) sum += of(axis) * of(axis);
  return std::sqrt(sum);
}

void raise(double& peak, double value) {
  if (std::isfinite(value)) peak = std::max(peak, value);
}

void raise(Peaks& peaks, const LawInterval& s) {
  for (const double v : {s.v0, s.peak, s.v1}) raise(peaks.velocity, v);
  for (const double a : {s.acceleration, s.deceleration}) raise(peaks.acceleration, std::abs(a));
  raise(peaks.jerk, std::abs(s.jerk));
}

void raise(Peaks& peaks, const Peaks& by) {
  peaks.velocity = std::max(peaks.velocity, by.velocity);
  peaks.acceleration = std::max(peaks.acceleration, by.acceleration);
  peaks.jerk = std::max(peaks.jerk, by.jerk);
}

/// `error`: of an arc, which has a greater reserve.
Peaks peaks_of(const Ranges& ranges, const Jet& error) {
  return {.velocity = std::abs(ranges[1].peak().value) + error[1],
          .acceleration = std::abs(ranges[2].peak().value) + error[2],
          .jerk = std::abs(ranges[3].peak().value) + error[3]};
}

/// The motions of the axes of a group, examined in one pass over the stretches of their plan.
struct Examined {
  std::vector<AxisPass> axes;
  std::vector<ProgramPart> sections;  ///< peaks between two rests, without the errors of the fits
  std::vector<Jet> error;             ///< tolerances of the fits, for all axes of the plan
};

Examined examined(const GroupProgram& program, std::span<const AxisConfig> configs) {
  Examined all;
  for (const AxisConfig& config : configs) all.axes.emplace_back(seconds(config.period));
  AxesByStretch motion(*program.plan);
  const auto end_section = [&] {
    for (AxisPass& axis : all.axes) all.sections.back().axes.push_back(axis.end_section());
  };
  for (const LawInterval& stretch : program.plan->law().stretches()) {
    const bool rests = !all.sections.empty() && stretch.v0 == 0;
    if (rests) end_section();
    if (rests || all.sections.empty()) all.sections.push_back({.start = stretch.start});
    raise(all.sections.back().along, stretch);
    motion.next();
    for (std::size_t k = 0; k < all.axes.size(); ++k)
      for (const Segment& f : motion.segments(program.first + k)) all.axes[k].add(f);
  }
  end_section();
  all.error.assign(motion.error().begin(), motion.error().end());
  return all;
}

bool same_peaks(const ProgramPart& a, const ProgramPart& b) {
  return a.along == b.along && a.axes == b.axes;
}

/// The parts of a program: each rest at which the peaks up to the end of the program are lower than
/// before. `sections`: the peaks between two rests. `whole`: the whole program.
std::vector<ProgramPart> parts_of(std::span<const ProgramPart> sections, ProgramPart whole) {
  std::vector<ProgramPart> parts;
  ProgramPart part{.axes = std::vector<Peaks>(whole.axes.size())};
  for (std::size_t i = sections.size(); i-- > 1;) {
    part.start = sections[i].start;
    raise(part.along, sections[i].along);
    for (std::size_t k = 0; k < part.axes.size(); ++k) raise(part.axes[k], sections[i].axes[k]);
    if (!parts.empty() && same_peaks(parts.back(), part))
      parts.back().start = part.start;
    else
      parts.push_back(part);
  }
  if (!parts.empty() && same_peaks(parts.back(), whole)) parts.pop_back();
  parts.push_back(std::move(whole));
  std::reverse(parts.begin(), parts.end());
  return parts;
}

}  // namespace

Peaks peaks_of(const TimingLaw& law) {
  Peaks peaks;
  for (const LawInterval& s : law.stretches()) raise(peaks, s);
  return peaks;
}

const ProgramPart& part_at(const GroupProgram& program, double length) {
  const auto after = std::upper_bound(program.parts.begin() + 1, program.parts.end(), length,
                                      [](double at, const ProgramPart& p) { return at < p.start; });
  return *std::prev(after);
}

GroupProgram group_program(std::shared_ptr<const Plan> plan, std::span<const AxisConfig> axes,
                           std::span<const std::string> names, std::span<const std::string> units) {
  const std::string unknown;
  const bool joints = plan->given().fit.has_value();
  if (joints ? plan->path().axes() <= axes.size() : plan->path().axes() != axes.size())
    throw InputError(
        "axes", std::to_string(axes.size()),
        "must be " + std::to_string(plan->path().axes()) + ", the number of axes of the path");
  GroupProgram program{.plan = std::move(plan), .axes = {}};
  program.first = program.plan->path().axes() - axes.size();
  ProgramPart whole{.along = peaks_of(program.plan->law())};
  Examined motion = examined(program, axes);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const AxisConfig config = resolved(axes[k]);
    const Ranges& ranges = motion.axes[k].ranges();
    const PlannedAxis axis{names[k], k < units.size() ? units[k] : unknown, *program.plan, config};
    require_smooth(axis, motion.axes[k].steps());
    require_inside(axis, ranges[0]);
    require_within(axis, 1, ranges[1].peak(), config.limits.velocity);
    require_within(axis, 2, ranges[2].peak(), config.limits.acceleration);
    require_within(axis, 3, ranges[3].peak(), config.limits.jerk);
    const Jet& error = motion.error[program.first + k];
    whole.axes.push_back(peaks_of(ranges, error));
    for (ProgramPart& section : motion.sections) {
      section.axes[k].velocity += error[1];
      section.axes[k].acceleration += error[2];
      section.axes[k].jerk += error[3];
    }
    program.axes.push_back({config, whole.axes.back()});
  }
  program.parts = parts_of(motion.sections, std::move(whole));
  return program;
}

GroupLimits within(const GroupLimits& limits, std::span<const AxisConfig> axes) {
  if (limits.axes.size() != axes.size())
    throw InputError(
        "axes", std::to_string(limits.axes.size()),
        "must be " + std::to_string(axes.size()) + ", the number of axes of the group");
  GroupLimits all = limits;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const Limits& axis = axes[k].limits;
    Limits& one = all.axes[k];
    one = {.velocity = lower(one.velocity, axis.velocity),
           .acceleration = lower(one.acceleration, axis.acceleration),
           .jerk = lower(one.jerk, axis.jerk)};
  }
  return all;
}

void require_order(std::span<const std::string> path, std::span<const std::string> group) {
  const auto known = [&](const std::string& name) {
    return std::find(group.begin(), group.end(), name) != group.end();
  };
  if (std::none_of(path.begin(), path.end(), known)) return;
  for (std::size_t k = 0; k < path.size() && k < group.size(); ++k)
    if (path[k] != group[k])
      throw InputError("axes", group[k],
                       "is axis " + std::to_string(k + 1) + " of the group, but axis " +
                           std::to_string(k + 1) + " of the path is " + path[k] +
                           ": name the axes of the path as those of the group, in the same order");
}

AxisConfig group_config(std::span<const AxisConfig> axes) {
  if (axes.empty()) throw InputError("axes", "", "are missing: a group needs at least one axis");
  AxisConfig group{.period = axes.front().period, .longest_gap = axes.front().longest_gap};
  group.limits.velocity =
      not_binding * norm(axes, [](const AxisConfig& a) { return *a.limits.velocity; });
  group.limits.acceleration =
      not_binding * norm(axes, [](const AxisConfig& a) { return *a.limits.acceleration; });
  return group;
}

}  // namespace jounce
