// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

struct Ratio {
  std::int64_t numerator = 1, denominator = 1;

  [[nodiscard]] double value() const {
    return static_cast<double>(numerator) / static_cast<double>(denominator);
  }
};

Ratio read_ratio(TomlReader& reader) {
  Ratio ratio{reader.whole("numerator"), reader.optional_whole("denominator").value_or(1)};
  if (ratio.denominator < 1)
    reader.fail("denominator", std::to_string(ratio.denominator), "must be at least 1");
  return ratio;
}

GearSpec read_for_ever(TomlReader& gear, const Units& units) {
  const Ratio ratio = read_ratio(gear);
  if (ratio.numerator == 0)
    gear.fail("numerator", "0",
              "must not be 0, because the slave would never move; 0 is possible with engage = "
              "\"distance\" and in [[gear.change]]");
  GearSpec spec{ratio.numerator, ratio.denominator, gear.number("master_period", units.x)};
  if (!(spec.master_period > 0))
    gear.fail("master_period", number(spec.master_period), "must be greater than 0");
  return spec;
}

/// Reads a clutch: of [gear], or of a [[gear.change]].
RatioChange read_change(TomlReader& reader, const Units& units, double at) {
  RatioChange change;
  change.at = at;
  change.ratio = read_ratio(reader).value();
  change.distance = reader.number("distance", units.x);
  change.law = read_law(reader, "law").value_or(Law::line);
  return change;
}

PhaseShift read_shift(TomlReader& reader, const Units& units) {
  PhaseShift shift;
  shift.at = reader.number("at", units.x);
  shift.shift = reader.number("shift", units.position);
  shift.distance = reader.number("distance", units.x);
  shift.law = read_law(reader, "law").value_or(Law::poly345);
  return shift;
}

GearCourse read_course(TomlReader& gear, const Units& units) {
  GearCourse course;
  course.master_start = gear.optional_number("master_start", units.x).value_or(0);
  course.master_end = gear.number("master_end", units.x);
  course.slave_start = gear.optional_number("slave_start", units.position).value_or(0);
  course.ratio =
      gear.optional_number("from_ratio", rate_unit(units.position, units.x, 1)).value_or(0);
  const double at = gear.optional_number("engage_at", units.x).value_or(course.master_start);
  course.changes.push_back(read_change(gear, units, at));
  for (TomlReader& change : gear.tables("change")) {
    course.changes.push_back(read_change(change, units, change.number("at", units.x)));
    change.finish();
  }
  for (TomlReader& shift : gear.tables("shift")) {
    course.shifts.push_back(read_shift(shift, units));
    shift.finish();
  }
  return course;
}

GearInPosPart read_in_pos(TomlReader& gear, const Units& units) {
  GearInPosPart part;
  const Ratio ratio = read_ratio(gear);
  GearInPosSpec& spec = part.gear;
  spec.numerator = ratio.numerator;
  spec.denominator = ratio.denominator;
  spec.master_sync_position = gear.number("master_sync_position", units.x);
  spec.slave_sync_position = gear.number("slave_sync_position", units.position);
  spec.master_start_distance = gear.number("master_start_distance", units.x);
  spec.slave_start = gear.optional_number("slave_start", units.position).value_or(0);
  spec.avoid_reversal = gear.optional_flag("avoid_reversal").value_or(false);
  spec.slave_period = gear.optional_number("slave_period", units.position);
  spec.law = read_law(gear, "law").value_or(Law::quintic);
  part.master_start = gear.optional_number("master_start", units.x).value_or(0);
  part.master_end = gear.number("master_end", units.x);
  return part;
}

}  // namespace

SyncSpec read_gear(TomlReader gear, const Units& units) {
  const std::vector<std::string> words{"at_once", "distance", "position"};
  SyncSpec spec;
  gear.may_have("engage");
  switch (gear.has("engage") ? gear.variant("engage", words) : 0) {
    case 0:
      for (const char* key : {"engage_at", "distance", "from_ratio", "law", "change", "shift"})
        gear.refuse_here(key, "needs engage = \"distance\": add it, or leave this key out");
      for (const char* key : {"master_start", "master_end", "slave_start"})
        gear.refuse_here(
            key,
            "needs engage = \"distance\" or \"position\", without master_period: change "
            "engage, or leave this key out");
      for (const char* key : {"master_sync_position", "slave_sync_position",
                              "master_start_distance", "avoid_reversal", "slave_period"})
        gear.refuse_here(key, "needs engage = \"position\": add it, or leave this key out");
      spec = read_for_ever(gear, units);
      break;
    case 1:
      gear.refuse_here("master_period",
                       "applies to engage = \"at_once\" only: leave master_period out");
      spec = read_course(gear, units);
      break;
    default:
      gear.refuse_here("master_period",
                       "applies to engage = \"at_once\" only: leave master_period out");
      spec = read_in_pos(gear, units);
  }
  gear.finish();
  return spec;
}

}  // namespace jounce::spec_detail
