// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <utility>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {

std::optional<CouplingSpec> read_coupling(TomlReader& top, const Units& units,
                                          const std::string& time_unit) {
  auto table = top.optional_table("coupling");
  if (!table) return std::nullopt;
  CouplingSpec c;
  c.master_scaling = table->optional_number("master_scaling", "1").value_or(1);
  c.master_offset = table->optional_number("master_offset", units.x).value_or(0);
  c.slave_scaling = table->optional_number("slave_scaling", "1").value_or(1);
  c.slave_offset = table->optional_number("slave_offset", units.position).value_or(0);
  c.master_absolute = table->optional_flag("master_absolute").value_or(true);
  c.slave_absolute = table->optional_flag("slave_absolute").value_or(true);
  std::vector<std::string> modes;
  for (std::size_t i = 0; i < start_mode_count; ++i)
    modes.emplace_back(name(static_cast<StartMode>(i)));
  c.start = static_cast<StartMode>(table->optional_choice("start", modes).value_or(0));
  // A coupling counts in s, also if the spec has another unit of time.
  const auto rate = [&](const char* key, int order) {
    auto value = table->optional_number(key, rate_unit(units.position, time_unit, order));
    for (int k = 0; value && k < order; ++k) *value /= conversion(time_unit, "s");
    return value;
  };
  c.velocity_diff = rate("velocity_diff", 1);
  c.acceleration = rate("acceleration", 2);
  c.deceleration = rate("deceleration", 2);
  c.jerk = rate("jerk", 3);
  c.distance = table->optional_number("distance", units.x);
  c.slave_period = table->optional_number("slave_period", units.position);
  table->finish();
  try {
    require_valid(c);
  } catch (const InputError& error) {
    table->fail(error.key().c_str(), error.value(), error.rule());
  }
  return c;
}

}  // namespace jounce::spec_detail
