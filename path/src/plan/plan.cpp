// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/plan.hpp"

#include <algorithm>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/corners/rounding.hpp"
#include "path/src/geometry/average.hpp"
#include "path/src/geometry/route.hpp"
#include "path/src/kept_memory.hpp"
#include "path/src/maps/joined.hpp"
#include "path/src/timing/laws.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;
/// Checks the position limits at the ends of all commands.
void require_inside(const Program& program, const GroupLimits& limits) {
  const auto check = [&](std::size_t axis, double x, int line) {
    const Limits& l = limits.axes[axis];
    const bool below = l.position_min && x < *l.position_min;
    if (!below && !(l.position_max && x > *l.position_max)) return;
    throw InputError("to[" + std::to_string(axis + 1) + "]", x,
                     below ? "must be at least position_min, " + number(*l.position_min)
                           : "must be at most position_max, " + number(*l.position_max))
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

/// Throws if a command has limits of more axes than the plan has.
void require_known_axes(const Program& program, std::size_t axes) {
  for (const Program::Command& c : program.commands())
    if (const std::size_t given = program.settings()[c.settings].axes.size(); given > axes)
      throw InputError("axes", std::to_string(given),
                       "must be limits of at most " + std::to_string(axes) + " axes")
          .at({}, c.line);
}

/// Marks the joints between two rests of the plan if a stop at each of them is faster; returns
/// false if there are none. `stopping`: times of the motion with stops at these rests.
bool mark_slower(std::span<const Rest> rests, std::span<const double> stopping,
                 std::vector<bool>& stop) {
  bool any = false;
  for (std::size_t k = 0; k + 1 < rests.size(); ++k) {
    const double stops = (stopping[k + 1] - stopping[k]) * (1 + rounded_sum);
    if (rests[k + 1].time - rests[k].time <= stops) continue;
    for (std::size_t joint = rests[k].joint + 1; joint < rests[k + 1].joint; ++joint) {
      any = any || !stop[joint];
      stop[joint] = true;
    }
  }
  return any;
}

/// The times of the joints `at` among the rests of a law, and its duration.
std::vector<double> times_of(std::span<const Rest> rests, std::span<const Rest> at) {
  std::vector<double> times;
  std::size_t s = 0;
  for (const Rest& rest : at) {
    while (rests[s].joint < rest.joint) ++s;
    times.push_back(rests[s].time);
  }
  times.push_back(rests.back().time);
  return times;
}

/// The path in memory of its own size: that of a route may be the memory of a longer one.
Path without_spare(Path path) {
  const std::size_t axes = path.axes();
  auto [pieces, numbers] = std::move(path).release();
  pieces.shrink_to_fit();
  numbers.shrink_to_fit();
  return {axes, std::move(pieces), std::move(numbers)};
}

void keep_memory_of(Path path) {
  auto [pieces, numbers] = std::move(path).release();
  path_detail::keep_memory(std::move(pieces));
  path_detail::keep_memory(std::move(numbers));
}

}  // namespace

Plan plan(const Program& program, const GroupLimits& limits, const PlanOptions& options) {
  const Joined joined(program, limits, options.joints, options.canceled);
  require_inside(program, limits);
  require_known_axes(program, joined.rates().axes);
  Route tool = route_of(program);
  std::optional<Route> averaged;
  if (!options.stop_at_corners) averaged = with_averages(tool, program);
  Route sharp = joined.with_linear(std::move(tool));
  if (averaged) averaged = joined.with_linear(std::move(*averaged));
  const Rates shaping = joined.corner_rates(sharp);
  const auto corners_of = [&](const Route& route, const Lines& lines,
                              std::span<const CornerShape> shapes) {
    return joined.with_fitted(rounded(route, lines, program, shaping, shapes), route);
  };
  const auto law_of = [&](Jointed& path, const Route& route, bool times_only = false) {
    return fastest_law(path.rounded, joined.rates(), program, route, times_only);
  };
  Lines lines = lines_of(sharp, program, shaping);
  const auto chosen = [&](const Route& route, const Lines& own, const std::vector<bool>& stop) {
    return shapes_of(route, own, program, shaping, stop,
                     options.stop_at_corners ? JunctionNote::none : JunctionNote::slower);
  };
  const auto with_stops = [&](const Route& route, const Lines& own) {
    return chosen(route, own, std::vector<bool>(route.joints.size(), true));
  };
  const auto stop_times_at = [&](std::span<const Rest> at, const Route& route, const Lines& own,
                                 std::span<const CornerShape> shapes) {
    if (!joined.fitted()) return stop_times(route, own, program, joined.rates(), shapes, at);
    Jointed stops = corners_of(route, own, with_stops(route, own));
    return times_of(law_of(stops, route, true).rests, at);
  };
  Jointed result;
  Laws law;
  Route* from = nullptr;  // route of the result
  double stop_duration = 0;
  const auto make_rounded = [&](Route& route, const Lines& own) {
    std::vector<bool> stop(route.joints.size(), false);
    std::vector<CornerShape> shapes = chosen(route, own, stop);
    result = corners_of(route, own, shapes);
    law = law_of(result, route);
    stop_duration = law.rests.back().time;
    if (std::ranges::any_of(shapes, &CornerShape::is_round)) {
      const std::vector<double> stopping = stop_times_at(law.rests, route, own, shapes);
      stop_duration = stopping.back();
      if (mark_slower(law.rests, stopping, stop)) {
        shapes = chosen(route, own, stop);
        result = corners_of(route, own, shapes);
        law = law_of(result, route);
      }
    }
    path_detail::keep_memory(std::move(shapes));
    from = &route;
  };
  if (averaged) {
    make_rounded(*averaged, lines_of(*averaged, program, shaping));
    stop_duration = stop_times_at({}, sharp, lines, with_stops(sharp, lines)).back();
  } else if (!options.stop_at_corners) {
    make_rounded(sharp, lines);
  }
  if (from != nullptr && law.rests.back().time > stop_duration) from = nullptr;
  if (from == nullptr) {
    from = &sharp;
    result = corners_of(sharp, lines, with_stops(sharp, lines));
    law = law_of(result, sharp);
    stop_duration = law.rests.back().time;
  }
  path_detail::keep_memory(std::move(lines.directions));
  path_detail::keep_memory(std::move(lines.boxes));
  path_detail::keep_memory(std::move(sharp.joints));
  path_detail::keep_memory(std::move(result.rounded.units));
  Rounded& made = result.rounded;
  Path path = made.path ? std::move(*made.path) : without_spare(std::move(from->path));
  if (made.path || from != &sharp) keep_memory_of(std::move(sharp.path));
  return {std::move(path),
          TimingLaw(std::move(law.stretches)),
          std::move(made.junctions),
          stop_duration,
          {joined.limits(),
           {program.settings().begin(), program.settings().end()},
           program.path_axes(),
           std::move(result.drawn),
           result.fit}};
}

Plan::Plan(Path path, TimingLaw law, std::vector<JunctionMark> junctions, double stop_duration,
           Given given)
    : path_(std::move(path)),
      law_(std::move(law)),
      junctions_(std::move(junctions)),
      stop_duration_(stop_duration),
      given_(std::move(given)) {}

}  // namespace jounce
