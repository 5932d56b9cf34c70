// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

const std::vector<std::string> rules{"linear", "cubic_hermite", "quintic_hermite"};

}  // namespace

std::string read_unit(TomlReader& reader, const char* key, const char* fallback,
                      const UnitRule& rule) {
  const std::array placeholders{fallback ? fallback : "mm", fallback ? fallback : "deg"};
  if (const auto unit = reader.placeholder(key, placeholders)) return *unit;
  if (fallback == nullptr && !reader.has(key)) {
    reader.refuse_misspelt(key);
    reader.fail(key, "", std::string("is missing: add ") + key + " = \"mm\", or another unit");
  }
  auto unit = reader.optional_text(key).value_or(fallback == nullptr ? "" : fallback);
  if (!is_unit(unit) || !rule.fits(unit)) reader.fail(key, '"' + unit + '"', rule.text);
  return unit;
}

std::string read_time_unit(TomlReader& reader, const char* key) {
  return read_unit(reader, key, "s",
                   {[](const std::string& unit) { return is_convertible(unit, "s"); },
                    "is not a unit of time: give s, ms, us, min or h"});
}

std::string read_position_unit(TomlReader& reader, const char* key, const char* fallback) {
  return read_unit(
      reader, key, fallback,
      {[](const std::string& unit) { return is_position_unit(unit); },
       "is not a unit of position: give a length (m mm um cm in ft yd), an angle (rad deg rev), or "
       "pulse, count or inc"});
}

std::string read_master_unit(TomlReader& reader, const char* key) {
  return read_unit(
      reader, key, nullptr,
      {[](const std::string& unit) { return is_position_unit(unit) || is_convertible(unit, "s"); },
       "is not a unit of a master: give an angle (deg rad rev), a length (m mm um cm in ft yd), "
       "pulse, "
       "count or inc, or a time (s ms) for a virtual master"});
}

TableOptions read_table_options(TomlReader& owner, const Units& units, bool finished, Domain axis) {
  TableOptions options;
  auto table = owner.optional_table("table");
  if (!table) return options;
  if (const auto rule = table->optional_choice("rule", rules))
    options.rule = static_cast<Interpolation>(*rule);
  if (finished) {
    table->finish();
    return options;
  }
  options.tolerance = table->optional_number("tolerance", units.position);
  options.intervals = table->optional_count("intervals");
  if (options.intervals.value_or(1) > 10'000'000)
    table->fail("intervals", std::to_string(*options.intervals), "must be at most 10000000");
  if (options.tolerance && !(*options.tolerance > 0))
    table->fail("tolerance", number(*options.tolerance), "must be greater than 0");
  if (options.tolerance && options.intervals)
    table->fail("intervals", "", "cannot be combined with tolerance: give one of the two");
  read_target(*table, units, axis, options);
  table->finish();
  return options;
}

namespace {

/// Reads the three rates under these keys, in units per `x`. The first `required` of them cannot be
/// left out.
void read_rates(TomlReader& table, Limits& limits, const std::array<const char*, 4>& names,
                const std::string& position, const std::string& x, std::size_t required = 0) {
  const std::array rates{&limits.velocity, &limits.acceleration, &limits.jerk};
  for (std::size_t k = 0; k < rates.size(); ++k) {
    *rates[k] =
        table.optional_number(names[k + 1], rate_unit(position, x, static_cast<int>(k) + 1));
    if (!*rates[k] || **rates[k] > 0) continue;
    (void)table.attempt([&] {
      table.fail(names[k + 1], number(**rates[k]),
                 k < required ? "must be greater than 0"
                              : "must be greater than 0; leave it out for no limit");
    });
    rates[k]->reset();
    if (k < required) *rates[k] = 1;  // the limit is given, although it is wrong
  }
}

}  // namespace

Limits read_limits(TomlReader& owner, const Units& units) {
  return read_limits(owner, units, nullptr, "");
}

Limits read_limits(TomlReader& owner, const Units& units, Limits* slave,
                   const std::string& time_unit) {
  Limits limits;
  auto table = owner.optional_table("limits");
  if (!table) return limits;
  limits.position_min = table->optional_number("position_min", units.position);
  limits.position_max = table->optional_number("position_max", units.position);
  if (slave)
    for (std::size_t k = 1; k < OverTime::names.size(); ++k)
      if (table->optional_quantity(OverTime::names[k]))
        table->fail(OverTime::names[k], "", "is a limit over time: give it in [limits.slave]");
  constexpr std::size_t of_axis = 2;  // velocity and acceleration
  read_rates(*table, limits, slave ? OverMaster::names : OverTime::names, units.position, units.x,
             owner.is_table("axis") ? of_axis : 0);
  const bool in_order = table->attempt([&] {
    if (limits.position_min && limits.position_max && *limits.position_min > *limits.position_max)
      table->fail("position_min", number(*limits.position_min),
                  "must not be above position_max = " + number(*limits.position_max) +
                      ": exchange the two");
  });
  if (!in_order) limits.position_min = limits.position_max = std::nullopt;
  if (slave) {
    if (auto over_time = table->optional_table("slave")) {
      read_rates(*over_time, *slave, OverTime::names, units.position, time_unit);
      over_time->finish();
    }
  }
  table->finish();
  return limits;
}

}  // namespace jounce::spec_detail
