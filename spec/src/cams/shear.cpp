// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

/// Slave units in one master unit, if both are lengths.
double ratio_of(TomlReader& shear, const Units& units) {
  if (const auto ratio = shear.optional_number("ratio", rate_unit(units.position, units.x, 1)))
    return *ratio;
  try {
    return conversion(units.x, units.position);
  } catch (const InputError&) {
    shear.fail(
        "ratio", "",
        "is missing: the travel of the carriage per " + units.x + " of the line in the sync zone");
  }
}

double angle_of(TomlReader& shear) {
  const double angle = shear.optional_number("angle", "deg").value_or(0);
  if (!(angle > -90 && angle < 90))
    shear.fail("angle", number(angle),
               "must be greater than -90 and less than 90 deg: otherwise the carriage does not "
               "move with the line");
  return angle * std::numbers::pi / 180;
}

void read_lengths(TomlReader& shear, const Spec& spec, FlyingShear& to) {
  const std::string& master = spec.units.x;
  to.line_speed = shear.number("line_speed", rate_unit(master, spec.time_unit, 1));
  to.sync_time = shear.optional_number("sync_time", spec.time_unit);
  to.sync_length = shear.optional_number("sync_length", master);
  to.stroke = shear.optional_number("stroke", spec.units.position);
  to.acceleration_length = shear.optional_number("acceleration_length", master);
  to.deceleration_length = shear.optional_number("deceleration_length", master);
  to.return_length = shear.optional_number("return_length", master);
}

}  // namespace

SyncSpec read_shear(TomlReader shear, Spec& spec) {
  FlyingShear made;
  auto list = read_cut_list(shear, spec.units.x);
  made.cut_length = list ? list->lengths.front() : shear.number("cut_length", spec.units.x);
  read_lengths(shear, spec, made);
  made.limits = spec.slave;
  made.safety = shear.optional_number("safety", "1").value_or(1);
  made.ramp = read_law(shear, "ramp").value_or(made.ramp);
  made.return_law = read_law(shear, "return_law").value_or(made.return_law);
  if (auto form = shear.optional_table("return_form")) {
    made.return_form = read_form(*form);
    form->finish();
  }
  made.ratio = ratio_of(shear, spec.units);
  made.angle = angle_of(shear);
  for (const auto& [key, value] : {std::pair{list ? "lengths" : "cut_length", made.cut_length},
                                   {"line_speed", made.line_speed}})
    if (!(value > 0)) shear.fail(key, number(value), "must be greater than 0");
  shear.finish();
  SyncSpec sync = with_list(made, list);
  // The line is the master, so a spec without [master] gets one from the shear.
  const double run = list ? sync_cam_of(sync).cam.length() : 3 * made.cut_length;
  spec.master = MasterSpec{made.line_speed, run, {}};
  return sync;
}

Indexer read_indexer(TomlReader indexer, const Units& units) {
  Indexer made;
  made.distance = indexer.number("distance", units.position);
  const auto positive = [&](const char* key) {
    const auto given = indexer.optional_positive(key, units.x);
    return given ? *given : indexer.number(key, units.x);  // reports a missing key
  };
  made.cycle = positive("cycle");
  made.motion = positive("motion");
  made.before = indexer.optional_number("before", units.x).value_or(0);
  if (const auto count = indexer.optional_count("count")) {
    if (*count < 1 || *count > 100'000)
      indexer.fail("count", std::to_string(*count), "must be between 1 and 100000");
    made.count = static_cast<int>(*count);
  }
  made.law = read_law(indexer, "law").value_or(made.law);
  made.form = read_form(indexer);
  indexer.finish();
  return made;
}

}  // namespace jounce::spec_detail
