// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

std::optional<double> not_negative(TomlReader& table, const char* key, const char* unit) {
  const std::optional<double> value = table.optional_number(key, unit);
  if (value && *value < 0) table.fail(key, number(*value), "must not be negative");
  return value;
}

FollowerLimits read_follower_limits(TomlReader& limits, const Units& units) {
  FollowerLimits found;
  found.least_force = not_negative(limits, "least_force", "N");
  found.greatest_force = limits.optional_positive("greatest_force", "N");
  found.impact_speed = limits.optional_positive("impact_speed", "m/s");
  found.residual = limits.optional_positive("residual", units.position);
  limits.finish();
  return found;
}

}  // namespace

std::optional<FollowerSpec> read_follower(TomlReader& top, const Spec& spec) {
  auto table = top.optional_table("follower");
  if (!table) return std::nullopt;
  if (!spec.master)
    top.fail("follower", "",
             "needs the speed of the master, on which the contact force depends: add [master]");
  FollowerSpec found;
  SpringFollower& f = found.follower;
  f.mass = table->number("mass", "kg");
  f.linkage_stiffness = table->number("linkage_stiffness", "N/m");
  f.linkage_damping = table->optional_number("linkage_damping", "N s/m").value_or(0);
  f.spring_stiffness = table->optional_number("spring_stiffness", "N/m").value_or(0);
  f.spring_damping = table->optional_number("spring_damping", "N s/m").value_or(0);
  f.preload = table->optional_number("preload", "N").value_or(0);
  found.settle = not_negative(*table, "settle", "s").value_or(0);
  try {
    f.meters_per_unit = conversion(spec.units.position, "m");
  } catch (const InputError&) {
    top.fail("follower", "",
             "needs a slave with a unit of length, such as mm, not " + spec.units.position);
  }
  if (auto limits = table->optional_table("limits"))
    found.limits = read_follower_limits(*limits, spec.units);
  table->finish();
  try {
    require_valid(f);
  } catch (const InputError& error) {
    throw InputError(top.path("follower." + error.key()), error.value(), error.rule());
  }
  return found;
}

}  // namespace jounce::spec_detail
