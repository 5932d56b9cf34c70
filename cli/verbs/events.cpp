// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/profiles/curve/composed.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

/// A change of one output along the spec's motion.
struct Event {
  double time = 0;
  std::string output;
  bool on = false;
  double position = 0;  ///< then, of what the output stands on
};

/// A motion that is over stays where it ended.
double position_at(const Trajectory& motion, double time) {
  return time < motion.end() ? motion.jet(time)[0] : motion.jet(motion.end(), Side::left)[0];
}

/// Those of [compare].
std::vector<Event> of_compare(const CompareSpec& compare, const Trajectory& motion) {
  std::vector<Event> events;
  for (const OutputEdge& edge : compared(compare.compare, motion).edges)
    events.push_back({edge.time, "compare", edge.on, position_at(motion, edge.time)});
  return events;
}

/// The slave behind its master, to 1e-12 of its positions: a position counts as reached to so much
/// in any case (cam_switch.hpp).
Trajectory slave_of(const Cam& cam, const Trajectory& master) {
  const double turns = std::abs(extrema(master, 0).peak().value) / cam.length();
  const double size = std::abs(extrema(cam, 0).peak().value) + std::abs(cam.advance()) * turns;
  return composed_within(cam, master, 1e-12 * (size > 0 ? size : 1)).curve;
}

/// Those of a cam's [[switch]] while its [master] runs, times in units of `unit` seconds.
std::vector<Event> of_switches(const Spec& spec, const Cam& cam, double unit) {
  const Trajectory master = make_master(spec);
  const bool of_master = spec.switches.of == SwitchesOf::master;
  const Trajectory position = of_master ? master : slave_of(cam, master);
  const SwitchTimes times = switch_times(spec.switches.table, position);
  const auto named = [](int track) { return "track " + std::to_string(track); };
  std::vector<Event> events;
  for (int track = 1; track <= CamSwitchSpec::most_tracks; ++track)
    if ((times.outputs >> static_cast<unsigned>(track - 1) & 1U) != 0)
      events.push_back(
          {master.start() / unit, named(track), true, position_at(position, master.start())});
  for (const SwitchEdge& edge : times.edges)
    events.push_back(
        {edge.time / unit, named(edge.track), edge.on, position_at(position, edge.time)});
  return events;
}

struct Events {
  std::vector<Event> all;
  std::string time, position;  ///< their units
  Report report;               ///< broken where a point does not fire, or the device is too slow
  Labels labels;               ///< with which the report is printed
};

Events events_of(const std::string& file) {
  const std::vector<Input> axes = load_axes(file);
  if (!axes.front().spec)
    throw InputError("FILE", file, "is a table: outputs need a spec with [compare] or [[switch]]");
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
      InputError("compare", "", "is missing: the spec has neither [compare] nor [[switch]]"));
}

struct EventsArguments {
  std::string file;
  std::string output = "-";
  bool json = false;
};

std::string json_of(const Events& events) {
  nlohmann::ordered_json document{{"time", events.time},
                                  {"position", events.position},
                                  {"events", nlohmann::ordered_json::array()}};
  for (const Event& event : events.all)
    document["events"].push_back({{"time", event.time},
                                  {"output", event.output},
                                  {"on", event.on},
                                  {"position", event.position}});
  return document.dump(2) + "\n";
}

std::string csv_of(const Events& events) {
  std::string text =
      fmt::format("time [{}],output,on,position [{}]\n", events.time, events.position);
  for (const Event& event : events.all)
    text += fmt::format("{},{},{},{}\n", number(event.time), event.output, event.on ? 1 : 0,
                        number(event.position));
  return text;
}

int run_events(const EventsArguments& options) {
  require_other_file(options.file, options.output);
  const Events events = events_of(options.file);
  write_file(options.output, options.json ? json_of(events) : csv_of(events));
  for (const Finding& f : events.report.findings) {
    if (!f.broken) continue;
    fmt::print(stderr, "jounce: {}: {}\n", f.rule, sentence(f, events.labels));
    if (!f.advice.empty()) fmt::print(stderr, "jounce:   {}\n", f.advice);
  }
  return events.report.ok() ? fine : finding;
}

}  // namespace

void add_events(CommandLine& line) {
  const auto options = std::make_shared<EventsArguments>();
  const Verb verb = line.verb("events", "List the exact times at which outputs switch",
                              "jounce events scan.toml -o events.csv");
  verb.option("FILE", options->file,
              "Spec of a motion with [compare], or of a cam with [[switch]] and [master]; "
              "- is standard input")
      .required();
  verb.option("-o,--output", options->output, "CSV to write; - is standard output");
  verb.flag("--json", options->json, "For machines");
  verb.work([options] { return run_events(*options); });
}

}  // namespace jounce::cli
