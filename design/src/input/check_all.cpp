// SPDX-License-Identifier: Apache-2.0
// The check of an input against everything that needs no integration.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/design/detail/limit_advice.hpp"
#include "jounce/design/detail/sync_check.hpp"
#include "jounce/design/disc.hpp"
#include "jounce/design/input.hpp"
#include "jounce/pvt/check.hpp"
#include "jounce/validate/loop.hpp"

#include "design/src/check/against.hpp"
#include "design/src/check/load_check.hpp"
#include "design/src/check/step_check.hpp"
#include "design/src/check/table_check.hpp"
#include "design/src/input/advice.hpp"
#include "design/src/input/excursions.hpp"
#include "design/src/input/table_error.hpp"
#include "design/src/path/path_rounding.hpp"

namespace jounce {
namespace {

void append(Report& report, const Report& part) {
  report.findings.insert(report.findings.end(), part.findings.begin(), part.findings.end());
}

/// Checks the continuity at the joints. The moving ends of a cam that runs once are no joints;
/// add_ends() reports them.
Report check_joints(const Input& input, int continuity) {
  if (design_detail::is_lines_of_a_smooth_curve(input)) continuity = std::min(continuity, 0);
  if (input.labels.over_master) {
    const Cam& cam = std::get<Cam>(*input.curve);
    if (!check_ends(cam).findings.empty())
      return check_continuity(with(cam, Extrapolation::refuse), continuity);
  }
  return of_motion(input, [&](const auto& motion) { return check_continuity(motion, continuity); });
}

Report check_curve(const Input& input, int continuity) {
  Report report = of_motion(input, [&](const auto& motion) { return check(motion, input.limits); });
  design_detail::forgive_rounding(report, input);
  design_detail::join_excursions(input, report);
  design_detail::keep_worst(report, input.labels);
  advise_on_limits(input, report);
  if (input.plan)
    for (Finding& f : report.findings)
      if (f.broken && f.rule.name().starts_with("position"))
        f.advice = "move this part of the path into the range of the axis";
  design_detail::name_first_passages(input, report);
  append(report, check_joints(input, continuity));
  for (Finding& f : report.findings)
    if (f.broken && f.rule.family() == RuleFamily::continuity)
      if (const std::string advice = design_detail::advice_at_edge(input, f); !advice.empty())
        f.advice = advice;
  if (input.plan) design_detail::discount_rounding(std::get<Trajectory>(*input.curve), report);
  append(report, design_detail::check_steps(input, report));
  append(report, design_detail::check_slave(input));
  if (input.against) design_detail::judge_against(input, report);
  if (!input.error) return report;
  if (!design_detail::is_best_of_so_many(input))
    report.findings.push_back(design_detail::table_error(input));
  // The table may break a limit between its knots although the curve keeps it.
  append(report, design_detail::check_table(input.table.table, input, report));
  return report;
}

/// Findings for the start of the coupling. Times of a coupling are in s, also if the spec has
/// another unit of time.
Report check_coupling(const Spec& spec, const Cam& cam, const EngageState& at) {
  const Coupling coupling(cam, *spec.coupling);
  const double slave = at.slave.value_or(value(cam.segments().front(), 0));
  const Jet master{at.master.value_or(cam.start()), design_detail::master_speed(spec, at), 0, 0};
  Report report = check(coupling, {.position = slave}, master);
  for (Finding& f : report.findings) {
    if (f.quantity == "master") f.unit = spec.units.x;
    for (std::size_t k = 1; k < OverTime::names.size(); ++k)
      if (f.quantity == OverTime::names[k])
        f.unit = rate_unit(spec.units.position, "s", static_cast<int>(k));
  }
  return report;
}

/// Adds findings for the ends of a cam that runs once. Other checks contain the ends of a follow
/// spec (tables) and the beginning of a coupled cam (coupling). A cam that refuses positions
/// outside may begin in motion.
void add_ends(const Input& input, const EngageState& at, Report& report) {
  if (!input.labels.over_master) return;
  const Cam& cam = std::get<Cam>(*input.curve);
  const auto* const sync = input.spec ? std::get_if<SyncSpec>(&input.spec->subject) : nullptr;
  if (sync != nullptr && std::holds_alternative<FollowPart>(*sync)) return;
  if (!input.spec || !input.spec->coupling)
    for (Finding& end : check_ends(cam).findings)
      if (end.rule == "coupling/end" || cam.outside() == Extrapolation::hold)
        report.findings.push_back(std::move(end));
  for (Finding& f : report.findings)
    if (f.rule == "coupling/end" || f.rule == "coupling/begin") {
      f.broken = f.rule == "coupling/begin";
      if (f.broken) f.margin = -1;
      f.severity = design_detail::judge_end(f, input);
      f.advice = design_detail::advice_for_end(f, input, at);
    }
}

/// Reports each step of the velocity once. The finding of the continuity check gets the advice of
/// the warning, which depends on the type of the table.
Report merged(Report warnings, Report& found) {
  std::erase_if(warnings.findings, [&](const Finding& w) {
    if (w.rule != "pt/velocity_step" && w.rule != "pt/end_velocity") return false;
    const auto same =
        std::find_if(found.findings.begin(), found.findings.end(), [&](const Finding& f) {
          return f.broken && f.rule == "continuity/velocity" && f.where == w.where;
        });
    if (same == found.findings.end()) return false;
    same->advice = w.advice;
    return true;
  });
  return warnings;
}

/// The warning for a table over time that advances in each period: no executor plays it.
std::optional<Finding> not_played(const Input& input) {
  if (input.labels.over_master || input.table.table.outside() != Extrapolation::advance)
    return std::nullopt;
  Finding f;
  f.rule = "warning/not_played";
  f.quantity = "outside";
  f.severity = Severity::warning;
  f.has_limit = false;
  f.advice = "to play it, let it hold or wrap";
  return f;
}

}  // namespace

Report check_all(const Input& input, int continuity, const EngageState& at) {
  Report report = check_curve(input, continuity);
  if (input.spec) {
    const Spec& spec = *input.spec;
    const auto add = [&](const Report& part) { append(report, part); };
    if (spec.himc) design_detail::name_himc_errors(report);
    if (!input.against) {  // these findings concern the spec, not the table
      add(spec.fill);
      add(check_sync(spec));
      add(merged(table_warnings(spec), report));
    }
    if (spec.is_cam()) add(check_load(spec, std::get<Cam>(*input.curve)));
    if (spec.disc) {
      Report disc = check_disc(spec, std::get<Cam>(*input.curve));
      if (design_detail::is_lines_of_a_smooth_curve(input))  // the plate follows the curve
        std::erase_if(disc.findings, [](const Finding& f) { return f.rule == "disc/corner"; });
      add(disc);
    }
    if (spec.coupling) add(check_coupling(spec, std::get<Cam>(*input.curve), at));
    if (spec.compare && !spec.compare->plane && spec.compare->axis == input.axis)
      add(check(spec.compare->compare, std::get<Trajectory>(*input.curve), spec.compare->device));
  }
  add_ends(input, at, report);
  if (!input.newer_spec.empty()) report.findings.push_back(design_detail::older_table(input));
  if (auto warning = not_played(input)) report.findings.push_back(*std::move(warning));
  if (input.drive)
    if (auto unstable = unstable_loop(input.drive->drive)) {
      unstable->axis = "drive";
      report.findings.push_back(*std::move(unstable));
    }
  sort(report);
  return report;
}

}  // namespace jounce
