// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/axis_drive.hpp"

namespace jounce::spec_detail {
namespace {

double read_bounce(TomlReader& reader) {
  const double bounce = reader.optional_number("bounce", "s").value_or(0);
  if (!(bounce >= 0)) reader.fail("bounce", number(bounce), "must not be negative");
  return bounce;
}

std::optional<MachineSwitch> read_home_switch(TomlReader& machine, const std::string& unit) {
  auto reader = machine.optional_table("home_switch");
  if (!reader) return std::nullopt;
  MachineSwitch home{.position = reader->number("position", unit)};
  home.width = reader->optional_positive("width", unit).value_or(home.width);
  home.inverted = reader->optional_flag("inverted").value_or(false);
  home.bounce = read_bounce(*reader);
  reader->finish();
  return home;
}

std::optional<MachineSwitch> read_limit_switch(TomlReader& machine, const char* key,
                                               const std::string& unit,
                                               MachineSwitch (*made)(double, double)) {
  auto reader = machine.optional_table(key);
  if (!reader) return std::nullopt;
  const double position = reader->number("position", unit);
  const double bounce = read_bounce(*reader);
  reader->finish();
  return made(position, bounce);
}

std::optional<MachineIndex> read_index(TomlReader& machine, const std::string& unit) {
  auto reader = machine.optional_table("index");
  if (!reader) return std::nullopt;
  MachineIndex index{.period = reader->number("period", unit)};
  if (!(index.period > 0))
    reader->fail("period", number(index.period),
                 "must be greater than 0: it is the travel of one turn");
  index.offset = reader->optional_number("offset", unit).value_or(0);
  reader->finish();
  return index;
}

const std::vector<std::string> mark_sources{"motor", "master"};

MachineMarks read_marks(TomlReader& reader, const Units& units, const std::string& master_unit) {
  MachineMarks marks;
  marks.input = static_cast<int>(reader.optional_whole("input").value_or(marks.input));
  if (marks.input < 1 || marks.input > 4)
    reader.fail("input", std::to_string(marks.input), "must be 1 to 4");
  marks.on_master = reader.optional_choice("of", mark_sources).value_or(0) == 1;
  if (marks.on_master && master_unit.empty())
    reader.fail("of", "\"master\"",
                "needs units.master: add units = { position = ..., master = ... }");
  const std::string& unit = marks.on_master ? master_unit : units.position;
  marks.first = reader.number("first", unit);
  for (const auto& [key, value] :
       {std::pair{"distance", &marks.distance}, {"width", &marks.width}}) {
    *value = reader.number(key, unit);
    if (!(*value > 0)) reader.fail(key, number(*value), "must be greater than 0");
  }
  marks.wander = reader.optional_number("wander", unit).value_or(0);
  marks.wander_marks = reader.optional_number("wander_marks", "1").value_or(1);
  if (const auto count = reader.optional_count("count"))
    marks.count = static_cast<std::int64_t>(*count);
  if (reader.has("missing"))
    for (const double mark : reader.number_list("missing", "1"))
      marks.missing.push_back(static_cast<std::int64_t>(mark));
  if (reader.has("extra")) marks.extra = reader.number_list("extra", unit);
  reader.finish();
  return marks;
}

}  // namespace

std::optional<MachineSensorsSpec> read_machine_sensors(TomlReader& drive, const Units& units,
                                                       const std::string& master_unit) {
  auto machine = drive.optional_table("machine");
  if (!machine) return std::nullopt;
  const std::string& unit = units.position;
  MachineSensorsSpec spec;
  spec.encoder_offset = machine->optional_number("encoder_offset", unit).value_or(0);
  spec.home = read_home_switch(*machine, unit);
  spec.negative = read_limit_switch(*machine, "negative_switch", unit, negative_switch);
  spec.positive = read_limit_switch(*machine, "positive_switch", unit, positive_switch);
  spec.index = read_index(*machine, unit);
  for (TomlReader& marks : machine->tables("marks"))
    spec.marks.push_back(read_marks(marks, units, master_unit));
  machine->finish();
  if (spec.negative && spec.positive && !(spec.negative->position < spec.positive->position))
    machine->fail(
        "positive_switch", number(spec.positive->position),
        "must be above the position of the negative switch, " + number(spec.negative->position));
  return spec;
}

}  // namespace jounce::spec_detail
