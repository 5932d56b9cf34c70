// SPDX-License-Identifier: Apache-2.0
#include "design/src/input/advice.hpp"

#include <cmath>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/controllers/detail/time_table_limits.hpp"
#include "jounce/design/detail/sync_check.hpp"

namespace jounce::design_detail {
namespace {

bool is_in_gear(const Input& input) {
  return input.spec && stays_in_gear(*input.spec);
}

}  // namespace

double master_speed(const Spec& spec, const EngageState& at) {
  const double speed = spec.master ? spec.master->velocity / seconds_per_unit(spec) : 0;
  return at.master_velocity.value_or(speed);
}

Severity judge_end(const Finding& end, const Input& input) {
  return end.rule == "coupling/begin" || is_in_gear(input) ? Severity::required : Severity::warning;
}

std::string advice_for_end(const Finding& end, const Input& input, const EngageState& at) {
  const Units& units = input.labels.units;
  const auto coupling = input.spec ? input.spec->coupling.value_or(CouplingSpec{}) : CouplingSpec{};
  const double speed = input.spec ? master_speed(*input.spec, at) : at.master_velocity.value_or(0);
  const double slave = end.value * coupling.slave_scaling * coupling.master_scaling * speed;
  const std::string motion =
      speed == 0 ? ""
                 : fmt::format("at the master velocity {} {}, the slave moves at {} {} there; ",
                               rounded(speed), rate_unit(units.x, "s", 1), rounded(slave),
                               rate_unit(units.position, "s", 1));
  if (end.rule == "coupling/begin")
    return motion +
           "a slave at rest jumps to this speed: let the cam begin at rest, or bring the slave in "
           "with [coupling] start = \"ramp_in\"";
  if (is_in_gear(input))
    return motion + "with a live master, the slave stays in gear after the end of its table";
  return motion +
         "with a live master, the slave brakes there within the limits of its axis, or keeps its "
         "velocity with `stream --keep-velocity`: let the cam end at rest, or repeat";
}

std::string advice_at_edge(const Input& input, const Finding& step) {
  if (!input.spec || input.labels.over_master) return "";
  const double position = std::get<Trajectory>(*input.curve).jet(step.where)[0];
  for (std::size_t k = 0; k < input.spec->then.size(); ++k) {
    const auto* const s = std::get_if<CompensateSpec>(&input.spec->then[k]);
    if (s == nullptr || s->references.size() != 1 || !s->references.front().empty()) continue;
    const double peak = Compensation(s->table).peak();
    for (const double edge : {s->table.axes.front().base, s->table.axes.front().end()})
      if (std::abs(position - edge) <= peak)
        return "the correction ends at " + rounded(edge) + " " + input.labels.units.position +
               " (then[" + std::to_string(k + 1) +
               "].reference), and the motion goes on: add points to its grid, or end the motion "
               "there";
  }
  return "";
}

void name_himc_errors(Report& report) {
  for (Finding& f : report.findings) {
    if (!f.broken || f.rule.family() != RuleFamily::limit) continue;
    const std::string error = himc::pvt_limit_error(f.quantity);
    if (!error.empty()) f.advice = "MovePVT refuses the table: HIMC error " + error;
  }
}

}  // namespace jounce::design_detail
