// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/command_times.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

/// The time at which the axes first are at q. Near a rest q hardly depends on time; if a stretch
/// ends at q except for rounding, the result is its end.
double first_time_at(const TimingLaw& law, double q) {
  const LawStretches& stretches = law.stretches();
  const LawInterval last = stretches.back();
  const double rounding = rounded_sum * (last.start + last.length);
  if (q <= rounding) return 0;
  const auto ends_before = [&](const LawInterval& s) { return s.start + s.length < q - rounding; };
  auto stretch = stretches.last_where(ends_before);
  if (ends_before(*stretch) && stretch.index() + 1 < stretches.size()) ++stretch;
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

/// Distance between two points in the axes from `first` to before `last`.
double distance_in(const Point& a, const Point& b, std::size_t first, std::size_t last) {
  double square = 0;
  for (std::size_t i = first; i < last; ++i) square += (b[i] - a[i]) * (b[i] - a[i]);
  return std::sqrt(square);
}

/// Length of a command in q.
double length_of(const Program& program, std::size_t index) {
  const Program::Command& command = program.commands()[index];
  const std::size_t m = program.path_axes();
  if (command.kind == Program::Kind::curve) return program.curves()[command.data].length;
  if (command.kind == Program::Kind::arc) {
    const Arc& arc = program.arcs()[command.data];
    return std::hypot(arc.radius * arc.sweep, distance_in({}, arc.drift, 0, m));
  }
  const Point from = program.place_before(index);
  const Point to = program.place_before(index + 1);
  const double length = distance_in(from, to, 0, m);
  return length > 0 ? length : distance_in(from, to, m, program.axes());
}

bool averages(const Program& program) {
  const auto settings = program.settings();
  return std::any_of(settings.begin(), settings.end(),
                     [](const PathSettings& s) { return s.corner == Corner::average; });
}

/// The start of the first piece with this source line, or a later one.
double start_of_line(const Path& path, std::int32_t line) {
  const auto pieces = path.pieces();
  const auto piece = std::find_if(pieces.begin(), pieces.end(),
                                  [&](const PathPiece& p) { return p.line >= line; });
  return piece == pieces.end() ? path.length() : piece->start;
}

}  // namespace

std::vector<CommandStart> command_starts(const Program& program, const Plan& plan,
                                         std::span<const std::size_t> commands) {
  const auto all = program.commands();
  const bool averaged = averages(program);
  std::vector<CommandStart> starts;
  double q = 0;
  double dwell = 0;
  std::size_t k = 0;
  for (const std::size_t command : commands) {
    for (; k < command; ++k) {
      const bool rests = all[k].kind == Program::Kind::dwell;
      dwell = rests ? dwell + program.numbers()[all[k].data] : 0;
      if (!rests) q += length_of(program, k);
    }
    const double end = plan.path().length();
    const bool by_line = averaged && command > 0 && command < all.size();
    CommandStart start{.where = by_line ? start_of_line(plan.drawn(), all[command].line) : q};
    start.where = std::min(start.where, end);
    if (command == all.size()) start.where = end;
    start.time = std::min(first_time_at(plan.law(), start.where) + dwell, plan.duration());
    starts.push_back(start);
  }
  return starts;
}

}  // namespace jounce
