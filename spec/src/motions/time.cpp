// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {

namespace {

constexpr double shortest_cycle = 1e-5;  ///< s
/// Reads the stops and the supervision of the axis. A function whose key is omitted is off, or has
/// the executor's default.
void read_watch(TomlReader& axis, const Units& units, AxisSpec& spec) {
  const auto read = [&](const char* key, const std::string& unit, double& value) {
    const auto given = axis.optional_number(key, unit);
    if (given && !(*given > 0)) axis.fail(key, jounce::number(*given), "must be greater than 0");
    value = given.value_or(0);
  };
  const auto rate = [&](int order) { return rate_unit(units.position, units.x, order); };
  read("modulo", units.position, spec.modulo);
  read("stop_acceleration", rate(2), spec.stop_acceleration);
  read("stop_jerk", rate(3), spec.stop_jerk);
  read("abort_acceleration", rate(2), spec.abort_acceleration);
  read("limit_acceleration", rate(2), spec.limit_acceleration);
  read("following_error", units.position, spec.following_error);
  read("following_time", "s", spec.following_time);
  read("in_position", units.position, spec.in_position);
  read("in_position_time", "s", spec.in_position_time);
}

/// Reads the longest permitted delay of a cycle, and the longest time without a heartbeat of the
/// axis' owner.
void read_patience(TomlReader& axis, AxisSpec& spec) {
  if (const auto gap = axis.optional_number("longest_gap", "s")) {
    if (!(*gap >= spec.cycle && *gap <= 1e6 * spec.cycle))
      axis.fail("longest_gap", jounce::number(*gap),
                "must be 1 to 1e6 cycles of " + jounce::number(spec.cycle) + " s");
    spec.longest_gap = *gap;
  }
  spec.session_timeout =
      axis.optional_number("session_timeout", "s").value_or(spec.session_timeout);
  // A heartbeat is sent every 100 ms, and one may be lost.
  if (!(spec.session_timeout >= 0.25 && spec.session_timeout <= 3600))
    axis.fail("session_timeout", jounce::number(spec.session_timeout),
              "must be between 250 ms and 1 h");
}

}  // namespace

AxisSpec read_axis(TomlReader axis, const Units& units) {
  AxisSpec spec;
  spec.cycle = axis.optional_number("cycle", "s").value_or(spec.cycle);
  constexpr double longest_cycle = 0.1;
  if (!(spec.cycle >= shortest_cycle && spec.cycle <= longest_cycle))
    axis.fail("cycle", number(spec.cycle),
              std::string("must be between 10 us and 100 ms") +
                  (axis.document().given.contains(axis.path("cycle"))
                       ? ", such as \"1 ms\""
                       : "; a number without a unit is in s: write \"1 ms\""));
  spec.position = axis.optional_number("position", units.position).value_or(0);
  spec.require_home = axis.optional_flag("require_home").value_or(false);
  spec.cutter = axis.optional_text("cutter").value_or("");
  read_watch(axis, units, spec);
  read_patience(axis, spec);
  axis.finish();
  return spec;
}

}  // namespace jounce::spec_detail
