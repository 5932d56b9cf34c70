// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jounce/base/units.hpp"
#include "jounce/design/path_text.hpp"
#include "jounce/path/along.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

/// The greatest factor of an override; at least 1.
double greatest_factor(const PathSpec& path) {
  double greatest = 1;
  for (const FactorRequest& step : path.override_steps) greatest = std::max(greatest, step.factor);
  return greatest;
}

}  // namespace

Report path_report(const Spec& spec, const Plan& played) {
  Report report = check_along(played, greatest_factor(std::get<PathSpec>(spec.subject)));
  for (Finding& f : report.findings)
    if (f.quantity.ends_with("celeration"))
      f.unit = rate_unit(spec.units.position, spec.units.x, 2);
  return report;
}

namespace {

/// The time at which the axes first are at q. Near a rest q hardly depends on time; if a stretch
/// ends at q except for rounding, the result is its end.
double first_time_at(const TimingLaw& law, double q) {
  const auto stretches = law.stretches();
  const double rounding = rounded_sum * (stretches.back().start + stretches.back().length);
  if (q <= rounding) return 0;
  const auto stretch =
      std::lower_bound(stretches.begin(), stretches.end() - 1, q - rounding,
                       [](const LawInterval& s, double at) { return s.start + s.length < at; });
  double low = stretch->time;
  double high = stretch->time + stretch->duration;
  if (stretch->start + stretch->length <= q + rounding) return high;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (law.at(middle).position < q ? low : high) = middle;
  }
  return high;
}

Point end_of(const Program& program, const Program::Command& command) {
  if (command.kind == Program::Kind::arc) return program.arcs()[command.data].to;
  if (command.kind == Program::Kind::curve) return program.curves()[command.data].to;
  Point to{};
  for (std::size_t i = 0; i < program.axes(); ++i) to[i] = program.numbers()[command.data + i];
  return to;
}

/// Distance between two points in the axes from `first` to before `last`.
double distance(const Point& a, const Point& b, std::size_t first, std::size_t last) {
  double square = 0;
  for (std::size_t i = first; i < last; ++i) square += (b[i] - a[i]) * (b[i] - a[i]);
  return std::sqrt(square);
}

/// Length of a command in q.
double length_of(const Program& program, const Program::Command& command, const Point& from) {
  const std::size_t m = program.path_axes();
  if (command.kind == Program::Kind::curve) return program.curves()[command.data].length;
  if (command.kind == Program::Kind::arc) {
    const Arc& arc = program.arcs()[command.data];
    return std::hypot(arc.radius * arc.sweep, distance({}, arc.drift, 0, m));
  }
  const double length = distance(from, end_of(program, command), 0, m);
  return length > 0 ? length : distance(from, end_of(program, command), m, program.axes());
}

}  // namespace

std::vector<EventPlace> places_of(const PathSpec& path, const Plan& plan,
                                  std::span<const GcodeEvent> events) {
  std::vector<EventPlace> places;
  const auto commands = path.program.commands();
  Point at = path.program.start();
  double q = 0;
  double dwell = 0;
  std::size_t k = 0;
  std::vector<Motion> axes(plan.path().axes());
  for (const GcodeEvent& event : events) {
    for (; k < commands.size() && commands[k].line < event.line; ++k) {
      const bool rests = commands[k].kind == Program::Kind::dwell;
      dwell = rests ? dwell + path.program.numbers()[commands[k].data] : 0;
      if (rests) continue;
      q += length_of(path.program, commands[k], at);
      at = end_of(path.program, commands[k]);
    }
    EventPlace place{.event = event, .where = std::min(q, plan.path().length())};
    place.time = std::min(first_time_at(plan.law(), place.where) + dwell, plan.duration());
    plan.at(place.time, axes);
    for (std::size_t i = 0; i < axes.size(); ++i) place.position[i] = axes[i].position;
    places.push_back(std::move(place));
  }
  return places;
}

std::vector<EventPlace> places_of_lines(const PathSpec& path, const Plan& plan) {
  std::vector<GcodeEvent> lines;
  for (const Program::Command& command : path.program.commands())
    if (lines.empty() || lines.back().line != command.line)
      lines.push_back({"line " + std::to_string(command.line), command.line});
  return places_of(path, plan, lines);
}

PathSummary summary_of(const Spec& spec, const Plan& played) {
  const auto& path = std::get<PathSpec>(spec.subject);
  const bool overridden = !path.override_steps.empty();
  const Plan plan =
      overridden ? jounce::plan(path.program, path.limits, {.joints = path.joints}) : played;
  PathSummary summary{.duration = plan.duration(),
                      .played = overridden ? std::optional(played.duration()) : std::nullopt,
                      .stop_duration = plan.stop_duration(),
                      .lower_bound = lower_bound(plan),
                      .length = plan.path().length(),
                      .cost = {},
                      .corners = plan.corners(),
                      .events = {},
                      .along = path_report(spec, played),
                      .fit = plan.given().fit};
  summary.cost = cost_of(plan, summary.corners);
  summary.events = places_of(path, played, path.events);
  return summary;
}

}  // namespace jounce
