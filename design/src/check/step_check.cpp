// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/step_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/pvt/check.hpp"

#include "design/src/check/master_check.hpp"

namespace jounce::design_detail {
namespace {

using profiles_detail::rounded_input;

constexpr double cycle_in_seconds = 1e-3;

/// The motion of an input over time.
struct Motion {
  const Input& input;
  double speed = 1;  ///< speed of the master; 1 over time
  std::string time_unit = {};
  Limits limits = {};  ///< over time

  [[nodiscard]] bool is_cam() const { return input.labels.over_master; }
  [[nodiscard]] const auto& names() const { return is_cam() ? OverMaster::names : OverTime::names; }
  /// The unit of a derivative over time, as the finding gives it.
  [[nodiscard]] std::string unit(std::size_t order) const {
    return is_cam() ? slave_rate_unit(*input.spec, static_cast<int>(order))
                    : input.labels.unit_of(OverTime::names[order]);
  }
  /// Its size in the unit of the spec.
  [[nodiscard]] double size(std::size_t order) const {
    if (!is_cam()) return 1;
    const std::string own =
        rate_unit(input.labels.units.position, time_unit, static_cast<int>(order));
    return conversion(own, unit(order));
  }
};

std::optional<Motion> motion_of(const Input& input) {
  if (!input.labels.over_master) return Motion{input, 1, input.labels.units.x, input.limits};
  if (!input.spec || !input.spec->master || !has_slave_limits(*input.spec)) return std::nullopt;
  const Spec& spec = *input.spec;
  return Motion{input, spec.master->velocity, spec.time_unit, spec.slave};
}

bool steps_in_velocity(const Report& report) {
  return std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& f) {
    return f.broken && f.rule.family() == RuleFamily::continuity;
  });
}

/// A limit of the derivative after a step, and the step.
struct Step {
  const Finding& continuity;  ///< from check_continuity()
  std::size_t order;          ///< order of the derivative that steps
  bool of_table;              ///< only the table steps
};

std::string advice_for(const Motion& motion, const Step& step, const Finding& f, double limit) {
  const std::size_t next = step.order + 1;
  const std::string text =
      fmt::format("in one cycle of 1 ms, the {} limit permits no more: ", OverTime::names[next]);
  if (motion.input.against)
    return text + "`jounce check " + printable(motion.input.against->spec) + "` gives the remedy";
  if (step.of_table)
    return text +
           "only the table steps, the curve is continuous. Set rule = \"quintic_hermite\" in "
           "[table], or give it a smaller tolerance";
  const std::string raised =
      fmt::format("raise the {} limit to {} {}", OverTime::names[next],
                  six_digits_up(limit * f.value / f.limit), motion.unit(next));
  return text + fmt::format("make the {} continuous there, {}or {}", motion.names()[step.order],
                            motion.is_cam() ? "slow the master down, " : "", raised);
}

/// The finding for a step; nullopt for rounding, and for a step that a limit permits. A permitted
/// step of the velocity is a note.
std::optional<Finding> finding_of(const Motion& motion, const Step& step) {
  const auto& limit_of = step.order == 1 ? motion.limits.acceleration : motion.limits.jerk;
  Finding f = step.continuity;
  if (!f.broken) return std::nullopt;  // no more than rounding
  const std::string name = OverTime::names[step.order];
  f.axis = step.of_table ? "table" : "";
  f.advice.clear();
  f.severity = Severity::note;
  f.has_limit = false;
  f.broken = false;
  f.rule = Rule(RuleFamily::joint, motion.names()[step.order]);
  const bool notes = step.order == 1;
  if (!limit_of) return notes ? std::optional(std::move(f)) : std::nullopt;
  const double rate = f.value * std::pow(motion.speed, static_cast<double>(step.order));
  const double most = *limit_of * usual_cycle(motion.time_unit);
  if (rate <= most * (1 + rounded_input)) return notes ? std::optional(std::move(f)) : std::nullopt;
  if (motion.input.plan) return f;  // a path steps at a tangential joint that it does not round
  f.rule = Rule(RuleFamily::limit, name + "_step");
  f.quantity = "step of " + name;
  f.unit = motion.is_cam() ? motion.unit(step.order) : "";
  f.value = rate * motion.size(step.order);
  f.limit = most * motion.size(step.order);
  f.margin = 1 - f.value / f.limit;
  f.has_limit = f.broken = true;
  f.severity = Severity::required;
  f.advice = advice_for(motion, step, f, *limit_of * motion.size(step.order + 1));
  return f;
}

/// The findings for the steps of a curve or a table.
template <class Of>
void add_steps(const Motion& motion, const Of& of, bool of_table, Report& report) {
  const Report continuity = check_continuity(of, 2);
  for (const std::size_t order : {1U, 2U}) {
    const Rule rule(RuleFamily::continuity, motion.names()[order]);
    const auto step = std::find_if(continuity.findings.begin(), continuity.findings.end(),
                                   [&](const Finding& f) { return f.rule == rule; });
    if (auto f = finding_of(motion, {*step, order, of_table}))
      report.findings.push_back(*std::move(f));
  }
}

}  // namespace

double usual_cycle(const std::string& time_unit) {
  return time_unit.empty() ? cycle_in_seconds : cycle_in_seconds * conversion("s", time_unit);
}

bool is_lines_of_a_smooth_curve(const Input& input) {
  if (input.table.table.rule() != Interpolation::linear) return false;
  if (!input.against) return false;
  const auto& broken = input.against->broken;
  return std::none_of(broken.begin(), broken.end(), [](const std::string& rule) {
    return Rule(rule).family() == RuleFamily::continuity;
  });
}

Report check_steps(const Input& input, const Report& found) {
  Report report;
  const std::optional<Motion> motion = motion_of(input);
  if (!motion || steps_in_velocity(found)) return report;
  of_motion(input, [&](const auto& of) { add_steps(*motion, of, false, report); });
  if (report.ok() && input.error) add_steps(*motion, input.table.table, true, report);
  return report;
}

}  // namespace jounce::design_detail
