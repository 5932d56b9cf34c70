// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>

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

}  // namespace

std::optional<MachineSensorsSpec> read_machine_sensors(TomlReader& drive, const Units& units) {
  auto machine = drive.optional_table("machine");
  if (!machine) return std::nullopt;
  const std::string& unit = units.position;
  MachineSensorsSpec spec;
  spec.encoder_offset = machine->optional_number("encoder_offset", unit).value_or(0);
  spec.home = read_home_switch(*machine, unit);
  spec.negative = read_limit_switch(*machine, "negative_switch", unit, negative_switch);
  spec.positive = read_limit_switch(*machine, "positive_switch", unit, positive_switch);
  spec.index = read_index(*machine, unit);
  machine->finish();
  if (spec.negative && spec.positive && !(spec.negative->position < spec.positive->position))
    machine->fail(
        "positive_switch", number(spec.positive->position),
        "must be above the position of the negative switch, " + number(spec.negative->position));
  return spec;
}

}  // namespace jounce::spec_detail
