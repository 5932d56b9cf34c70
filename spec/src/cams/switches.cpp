// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

const std::vector<std::string> axis_directions{"both", "positive", "negative"};
const std::vector<std::string> switch_modes{"position", "time"};
const std::vector<std::string> sources{"position", "master", "actual"};

int read_track(TomlReader& reader) {
  const std::int64_t track = reader.whole("track");
  if (track < 1 || track > CamSwitchSpec::most_tracks)
    reader.fail("track", std::to_string(track), "must be 1 to 32");
  return static_cast<int>(track);
}

CamSwitch read_switch(TomlReader& reader, const std::string& unit) {
  CamSwitch s{.track = read_track(reader)};
  s.first_on_position = reader.number("first_on_position", unit);
  s.last_on_position = reader.optional_number("last_on_position", unit);
  s.duration = reader.optional_number("duration", "s");
  s.axis_direction = static_cast<AxisDirection>(
      reader.optional_choice("axis_direction", axis_directions).value_or(0));
  // A duration implies a switch by time.
  s.mode = static_cast<CamSwitchMode>(reader.optional_choice("mode", switch_modes)
                                          .value_or(s.duration && !s.last_on_position ? 1 : 0));
  reader.finish();
  return s;
}

SwitchTrack read_options(TomlReader& reader, const std::string& unit) {
  SwitchTrack t{.track = read_track(reader)};
  t.on_compensation = reader.optional_number("on_compensation", "s").value_or(0);
  t.off_compensation = reader.optional_number("off_compensation", "s").value_or(0);
  t.hysteresis = reader.optional_number("hysteresis", unit).value_or(0);
  t.inverted = reader.optional_flag("inverted").value_or(false);
  t.enabled = reader.optional_flag("enabled").value_or(true);
  t.initial = reader.optional_flag("initial").value_or(false);
  reader.finish();
  return t;
}

}  // namespace

AxisSwitches read_switches(TomlReader& top, const Spec& spec, SwitchesOf of,
                           std::optional<double> master_period) {
  AxisSwitches read{.of = of, .table = {}};
  auto group = top.optional_table("switches");
  if (group) {
    if (const auto choice = group->optional_choice("of", sources))
      read.of = static_cast<SwitchesOf>(*choice);
    if (read.of == SwitchesOf::master && !spec.over_master() && spec.master_unit.empty())
      group->fail("of", "\"master\"",
                  "needs units.master: add units = { position = ..., master = ... }");
  }
  if (read.of == SwitchesOf::actual && spec.over_master())
    group->fail("of", "\"actual\"",
                "applies to an axis only, because a cam has no drive: leave it out");
  const bool of_master = read.of == SwitchesOf::master;
  const std::string& unit = !of_master           ? spec.units.position
                            : spec.over_master() ? spec.units.x
                                                 : spec.master_unit;
  if (of_master) read.table.period = master_period;
  if (group) {
    if (const auto period = group->optional_number("period", unit)) {
      if (!(*period > 0)) group->fail("period", number(*period), "must be greater than 0");
      read.table.period = period;
    }
    group->finish();
  }
  top.for_each("switch", [&](TomlReader& reader) {
    read.table.switches.push_back(read_switch(reader, unit));
  });
  top.for_each("track", [&](TomlReader& reader) {
    read.table.tracks.push_back(read_options(reader, unit));
  });
  require_valid(read.table);
  return read;
}

}  // namespace jounce::spec_detail
