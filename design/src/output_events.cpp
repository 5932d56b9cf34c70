// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/output_events.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/curve/composed.hpp"

namespace jounce {
namespace {

/// The position; after the end of the motion, its last position.
double position_at(const Trajectory& motion, double time) {
  return time < motion.end() ? motion.jet(time)[0] : motion.jet(motion.end(), Side::left)[0];
}

/// The events of [compare].
std::vector<OutputEvent> of_compare(const CompareSpec& compare, const Trajectory& motion) {
  std::vector<OutputEvent> events;
  for (const OutputEdge& edge : compared(compare.compare, motion).edges)
    events.push_back({edge.time, "compare", edge.on, position_at(motion, edge.time)});
  return events;
}

/// The slave behind its master, to 1e-12 of its positions: a switch position counts as reached within this distance
/// (cam_switch.hpp).
Trajectory slave_of(const Cam& cam, const Trajectory& master) {
  const double turns = std::abs(extrema(master, 0).peak().value) / cam.length();
  const double size = std::abs(extrema(cam, 0).peak().value) + std::abs(cam.advance()) * turns;
  return composed_within(cam, master, 1e-12 * (size > 0 ? size : 1)).curve;
}

/// The events of a cam's [[switch]] while its [master] runs; times in units of `unit` seconds.
std::vector<OutputEvent> of_switches(const Spec& spec, const Cam& cam, double unit) {
  const Trajectory master = make_master(spec);
  const bool of_master = spec.switches.of == SwitchesOf::master;
  const Trajectory position = of_master ? master : slave_of(cam, master);
  const SwitchTimes times = switch_times(spec.switches.table, position);
  const auto named = [](int track) { return "track " + std::to_string(track); };
  std::vector<OutputEvent> events;
  for (int track = 1; track <= CamSwitchSpec::most_tracks; ++track)
    if ((times.outputs >> static_cast<unsigned>(track - 1) & 1U) != 0)
      events.push_back(
          {master.start() / unit, named(track), true, position_at(position, master.start())});
  for (const SwitchEdge& edge : times.edges)
    events.push_back(
        {edge.time / unit, named(edge.track), edge.on, position_at(position, edge.time)});
  return events;
}

}  // namespace

OutputEvents output_events(const std::vector<Input>& axes) {
  if (!axes.front().spec)
    throw InputError("spec", axes.front().name,
                     "is a table: outputs need a spec with [compare] or [[switch]]");
  const Spec& spec = *axes.front().spec;
  if (spec.compare)
    for (const Input& axis : axes)
      if (axis.axis == spec.compare->axis)
        return {
            of_compare(*spec.compare, std::get<Trajectory>(*axis.curve)), spec.time_unit,
            axis.labels.units.position,
            check(spec.compare->compare, std::get<Trajectory>(*axis.curve), spec.compare->device),
            axis.labels};
  if (spec.over_master() && !spec.switches.table.switches.empty())
    return {of_switches(spec, std::get<Cam>(*axes.front().curve), seconds_per_unit(spec)),
            spec.time_unit,
            spec.switches.of == SwitchesOf::master ? spec.units.x : spec.units.position,
            {},
            {}};
  throw spec.document.located(
      InputError("compare", "", "is missing: add [compare] or [[switch]] to the spec"));
}

std::string to_json(const OutputEvents& events) {
  nlohmann::ordered_json document{{"time", events.time},
                                  {"position", events.position},
                                  {"events", nlohmann::ordered_json::array()}};
  for (const OutputEvent& event : events.all)
    document["events"].push_back({{"time", event.time},
                                  {"output", event.output},
                                  {"on", event.on},
                                  {"position", event.position}});
  return document.dump(2) + "\n";
}

std::string to_csv(const OutputEvents& events) {
  std::string text =
      fmt::format("time [{}],output,on,position [{}]\n", events.time, events.position);
  for (const OutputEvent& event : events.all)
    text += fmt::format("{},{},{},{}\n", number(event.time), event.output, event.on ? 1 : 0,
                        number(event.position));
  return text;
}

}  // namespace jounce
