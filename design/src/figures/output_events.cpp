// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/output_events.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/design/detail/path_text.hpp"
#include "jounce/path/path_length.hpp"
#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;
/// The position at a time; after the end of the motion, its last position.
double position_at(const Trajectory& motion, double time) {
  return time < motion.end() ? motion.jet(time)[0] : motion.jet(motion.end(), Side::left)[0];
}

/// x without the digits that its error leaves open: rounded by at most half of the error.
double without_open_digits(double x, double error) {
  if (!(error > 0)) return x;
  const int digits = static_cast<int>(std::clamp(std::ceil(-std::log10(error)), 0.0, 300.0));
  return std::stod(fmt::format("{:.{}f}", x, digits));
}

/// The events of [compare]. `error`: bound of the error of the positions of the motion.
std::vector<OutputEvent> of_compare(const CompareSpec& compare, const Trajectory& motion,
                                    double error = 0) {
  std::vector<OutputEvent> events;
  for (const OutputEdge& edge : compared(compare.compare, motion).edges)
    events.push_back(
        {edge.time, "compare", edge.on,
         compare.compare.pulse > 0 && !edge.on
             ? without_open_digits(edge.position,
                                   std::max(error, rounded_sum * std::abs(edge.position)))
             : edge.position});
  return events;
}

/// The pulses of a compare in a plane. Overlapping pulses of one output are joined.
std::vector<OutputEvent> of_zones(const PlaneCompare& zone, const Trajectory& x,
                                  const Trajectory& y) {
  const std::vector<CompareEvent> fired = compared(zone, x, y);
  std::vector<OutputEvent> events;
  std::map<int, double> ends;  // end of the last pulse of each output
  std::map<int, std::size_t> last;
  for (const CompareEvent& event : fired) {
    const int output = zone.points[event.point].output;
    const std::string name = "output " + std::to_string(output);
    const double end = event.time + zone.pulse;
    if (const auto running = ends.find(output);
        running != ends.end() && event.time <= running->second) {
      events[last[output]].time = end;
      events[last[output]].position = position_at(x, end);
    } else {
      events.push_back({event.time, name, true, position_at(x, event.time)});
      last[output] = events.size();
      events.push_back({end, name, false, position_at(x, end)});
    }
    ends[output] = end;
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const OutputEvent& a, const OutputEvent& b) { return a.time < b.time; });
  return events;
}

/// The words of a G-code program that do not move axes, and the starts of the lines of a path.
OutputEvents of_path(const Spec& spec, const Plan& plan) {
  const auto& path = std::get<PathSpec>(spec.subject);
  OutputEvents events{{}, spec.time_unit, spec.units.position, {}, {}};
  for (const auto& places : {places_of_lines(path, plan), places_of(path, plan, path.events)})
    for (const EventPlace& place : places)
      events.all.push_back({place.time, place.event.word, true, place.where});
  std::stable_sort(events.all.begin(), events.all.end(),
                   [](const OutputEvent& a, const OutputEvent& b) { return a.time < b.time; });
  return events;
}

const Input& axis_of(const std::vector<Input>& axes, const std::string& name) {
  return *std::find_if(axes.begin(), axes.end(),
                       [&](const Input& axis) { return axis.axis == name; });
}

/// The events of [compare]: for two axes, for the length along a path, or for one axis.
OutputEvents of_compare(const Spec& spec, const std::vector<Input>& axes) {
  const CompareSpec& compare = *spec.compare;
  OutputEvents events{{}, spec.time_unit, spec.units.position, {}, axes.front().labels};
  if (compare.plane) {
    const Input& x = axis_of(axes, compare.plane_axes[0]);
    const Input& y = axis_of(axes, compare.plane_axes[1]);
    events.position = x.labels.units.position;
    events.labels = x.labels;
    const auto& motion_x = std::get<Trajectory>(*x.curve);
    const auto& motion_y = std::get<Trajectory>(*y.curve);
    events.all = of_zones(*compare.plane, motion_x, motion_y);
    events.report = check(*compare.plane, motion_x, motion_y, events.position);
    return events;
  }
  const auto add = [&](const Trajectory& motion, double error = 0) {
    events.all = of_compare(compare, motion, error);
    events.report = check(compare.compare, motion, compare.device, events.position);
  };
  const auto axis = std::find_if(axes.begin(), axes.end(),
                                 [&](const Input& each) { return each.axis == compare.axis; });
  if (axis == axes.end()) {
    if (!axes.front().plan)
      throw spec.document.located(InputError("compare.axis", "\"path\"",
                                             "is not possible for lines that overlap in time: they "
                                             "have no length along the path. Name an axis"));
    const Fitted<OverTime> length = length_over_time(*axes.front().plan);
    add(length.curve, length.error[0]);
    return events;
  }
  events.position = axis->labels.units.position;
  events.labels = axis->labels;
  add(std::get<Trajectory>(*axis->curve));
  return events;
}

/// The motion of the slave, to 1e-12 of its positions. A switch position counts as reached within
/// this distance (cam_switch.hpp).
Trajectory slave_of(const Cam& cam, const Trajectory& master) {
  const double turns = std::abs(extrema(master, 0).peak().value) / cam.length();
  const double size = std::abs(extrema(cam, 0).peak().value) + std::abs(cam.advance()) * turns;
  return composed_within(cam, master, rounded_sum * (size > 0 ? size : 1)).curve;
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
  if (spec.compare) return of_compare(spec, axes);
  if (axes.front().plan) return of_path(spec, *axes.front().plan);
  if (spec.over_master() && !spec.switches.table.switches.empty())
    return {of_switches(spec, std::get<Cam>(*axes.front().curve), seconds_per_unit(spec)),
            spec.time_unit,
            spec.switches.of == SwitchesOf::master ? spec.units.x : spec.units.position,
            {},
            {}};
  throw spec.document.located(
      spec.over_master() ? InputError("switch", "", "is missing: add [[switch]] to the spec")
                         : InputError("compare", "", "is missing: add [compare] to the spec"));
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
