// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/recorded_output.hpp"

#include <algorithm>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {

using Part = RecordedOutput::Part;

bool recordable(const AxisCompare& compare) {
  return !compare.list || compare.list->points.size() <= RecordedOutput::longest;
}

std::vector<RecordedOutput> parts_of(std::size_t axis, const AxisSwitches& switches,
                                     const AxisCompare& compare) {
  std::vector<RecordedOutput> parts;
  const RecordedOutput of_switches{
      .axis = axis, .of = switches.of, .period = switches.table.period};
  for (const CamSwitch& each : switches.table.switches) {
    parts.push_back(of_switches);
    parts.back().cam_switch = each;
  }
  for (const SwitchTrack& each : switches.table.tracks) {
    parts.push_back(of_switches);
    parts.back().part = Part::track;
    parts.back().track = each;
  }
  if (!compare.list || !recordable(compare)) return parts;
  const std::vector<ComparePoint>& points = compare.list->points;
  for (std::size_t i = 0; i < points.size(); i += RecordedOutput::most_points) {
    const auto from = points.begin() + static_cast<std::ptrdiff_t>(i);
    const auto some = std::min(RecordedOutput::most_points, points.size() - i);
    parts.push_back({.axis = axis,
                     .part = Part::compare,
                     .of = compare.of,
                     .mode = compare.list->mode,
                     .pulse = compare.list->pulse,
                     .points = static_cast<std::int64_t>(points.size()),
                     .some = {from, from + static_cast<std::ptrdiff_t>(some)}});
  }
  return parts;
}

bool apply(const RecordedOutput& part, AxisSwitches& switches, AxisCompare& compare) {
  if (part.part == Part::compare) {
    if (!compare.list) compare.list.emplace();
    compare.of = part.of;
    compare.list->mode = part.mode;
    compare.list->pulse = part.pulse;
    if (!compare.list->points.empty() &&
        static_cast<std::int64_t>(compare.list->points.size()) >= part.points)
      throw InputError("points", std::to_string(part.points), "are complete already");
    compare.list->points.insert(compare.list->points.end(), part.some.begin(), part.some.end());
    return static_cast<std::int64_t>(compare.list->points.size()) >= part.points;
  }
  switches.of = part.of;
  switches.table.period = part.period;
  if (part.part == Part::cam_switch)
    switches.table.switches.push_back(part.cam_switch);
  else
    switches.table.tracks.push_back(part.track);
  return true;
}

}  // namespace jounce
