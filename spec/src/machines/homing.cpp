// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {

std::optional<AxisSpec::Homing> read_homing(TomlReader& top, const Units& units) {
  auto homing = top.optional_table("homing");
  if (!homing) return std::nullopt;
  const auto read = [&](const char* key, const std::string& unit, double& value) {
    value = homing->optional_positive(key, unit).value_or(value);
  };
  AxisSpec::Homing spec;
  const std::int64_t method = homing->optional_whole("method").value_or(spec.method);
  if (method < 1 || method > 37)
    homing->fail("method", std::to_string(method),
                 "must be 1 to 14, 17 to 30, 33, 34, 35 or 37 (CiA 402, object 6098h)");
  spec.method = static_cast<int>(method);
  read("search_velocity", rate_unit(units.position, units.x, 1), spec.search_velocity);
  read("index_velocity", rate_unit(units.position, units.x, 1), spec.index_velocity);
  read("acceleration", rate_unit(units.position, units.x, 2), spec.acceleration);
  read("timeout", "s", spec.timeout);
  spec.distance = homing->optional_positive("distance", units.position);
  spec.offset = homing->optional_number("offset", units.position).value_or(0);
  homing->finish();
  return spec;
}

}  // namespace jounce::spec_detail
