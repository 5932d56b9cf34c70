// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/sync_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/design/detail/cut_lengths.hpp"
#include "jounce/design/make.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/report/report_text.hpp"

#include "design/src/sync/sync_follow.hpp"
#include "design/src/sync/sync_gear.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

template <class Kind>
Report findings_of(const Kind&, const Spec&) {
  return {};
}

Report findings_of(const FollowPart&, const Spec& spec) {
  return check_follow(spec);
}

Report findings_of(const GearCourse& course, const Spec& spec) {
  return design_detail::check_gear(course, spec.units);
}

Report findings_of(const GearInPosPart& part, const Spec& spec) {
  return design_detail::check_gear(part, spec.units);
}

Report findings_of(const RotaryKnifeSpec& knife, const Spec& spec) {
  Report report = check(knife);
  for (Finding& f : report.findings) {
    if (f.rule == "knife/contact") f.unit = spec.units.position;
    if (f.rule == "knife/contact" && f.broken)
      f.advice = fmt::format(
          "the blade touches the web before it is in step: raise sync_angle in [knife] to at least "
          "{} {}",
          six_digits_up(f.limit), spec.units.position);
    if (f.rule == "knife/reversal" && f.broken)
      f.advice = fmt::format(
          "cut lengths above {} {} need a stop between the cuts: add dwell = true to [knife]",
          rounded(figures(knife).longest), spec.units.x);
  }
  return report;
}

/// Warns if stroke and return leave too little time in step for a cut.
Report findings_of(const FlyingShear& shear, const Spec& spec) {
  if (shear.sync_time || shear.sync_length) return {};
  const ShearPlan plan = shear_plan(shear);
  const double millisecond = 1e-3 / seconds_per_unit(spec);
  Finding f;
  f.rule = "shear/sync";
  f.quantity = "sync";
  f.unit = spec.units.x;
  f.where = plan.accelerate;
  f.segment = 1;
  f.value = plan.sync;
  f.limit = std::max(0.01 * shear.cut_length, millisecond * shear.line_speed);
  f.margin = f.value / f.limit - 1;
  f.severity = Severity::warning;
  const bool far = plan.stroke >= *shear.stroke * (1 - rounded_input);
  f.advice = far ? "the stroke is too short: lengthen it, or slow the line down"
                 : "the return is too short: cut longer pieces, or slow the line down";
  return f.value < f.limit ? Report{{f}} : Report{};
}

/// The findings of the knife itself; a list has no piece for which it would reverse.
Report findings_of(const CutListSpec& cuts, const Spec& spec) {
  const auto* knife = std::get_if<RotaryKnifeSpec>(&cuts.machine);
  if (knife == nullptr) return {};
  Report report = findings_of(*knife, spec);
  std::erase_if(report.findings, [](const Finding& f) { return f.rule == "knife/reversal"; });
  return report;
}

template <class Kind>
std::vector<SyncFigure> figures_of(const Kind&, const Spec&) {
  return {};
}

std::string runs_at(const RotaryKnifeSpec& knife, const RotaryKnifeFigures& f) {
  if (f.dwell > 0) return "the knife stops between the cuts";
  return fmt::format(
             "rho = {}; halfway between two cuts, the blade moves at {} times the speed of the web",
             rounded(f.rho), rounded(f.surface_ratio)) +
         (knife.speed_ratio == 1 ? "" : fmt::format(", {} in step", number(knife.speed_ratio)));
}

std::string speed_unit(const Spec& spec) {
  return rate_unit(spec.units.x, spec.time_unit, 1);
}

/// True if the line accelerates. The figures of cuts are for a line at constant speed, so they need
/// a word for this.
bool line_accelerates(const Spec& spec) {
  return spec.master && spec.master->acceleration.value_or(0) > 0;
}
const char* constant(const Spec& spec) {
  return line_accelerates(spec) ? "constant " : "";
}
const char* at_constant_speed(const Spec& spec) {
  return line_accelerates(spec) ? "at constant speed (without the acceleration of [master]), " : "";
}

/// Adds the shortest cut at the speed of the line, which is the master of the spec.
void add_speeds(std::vector<SyncFigure>& all, const Spec& spec) {
  if (!spec.master) return;
  const CutLengths cuts = cut_lengths(spec);
  const double line = spec.master->velocity;
  const CutLimits limits{spec.slave, std::numeric_limits<double>::infinity()};
  if (const auto least = cuts.shortest(line, limits)) {
    const std::string limit = cuts.fastest(*least, limits).limit;
    all.push_back({"shortest cut", *least, spec.units.x,
                   fmt::format("at {}{} {}, ", constant(spec), rounded(line), speed_unit(spec)) +
                       (limit == "length" ? "because no travel of the master is left for the return"
                                          : "limited by the slave's " + limit)});
  }
}

std::vector<SyncFigure> figures_of(const RotaryKnifeSpec& knife, const Spec& spec) {
  const RotaryKnifeFigures f = figures(knife);
  const std::string& m = spec.units.x;
  const std::string& u = spec.units.position;
  std::vector<SyncFigure> all{
      {"synchronous length", f.synchronous, m, "a cut of this length needs no correction"},
      {"in step", f.sync_length, m, fmt::format("{} {} of the knife", rounded(f.sync_angle), u)},
      {"recovery", f.recovery_length, m, runs_at(knife, f)},
      {"longest cut", f.longest, m, "the longest without a stop of the knife"}};
  if (knife.matching == KnifeMatching::horizontal)
    all[0].meaning = "at this cut length, blade and web have the same mean speed";
  if (f.contact_angle > 0)
    all.push_back(
        {"contact angle", f.contact_angle, u, "from the first contact of the blade to the bottom"});
  if (f.dwell > 0)
    all.push_back({"dwell", f.dwell, m, "travel of the web while the knife stands still"});
  add_speeds(all, spec);
  return all;
}

/// "return acceleration" -> "limited by the slave's acceleration on its return"
std::string limited_by(const ShearBound& bound) {
  const std::string& q = bound.quantity;
  const std::string limit = "limited by the slave's " + q.substr(q.find(' ') + 1);
  if (q == "stroke") return "limited by the stroke";
  if (q == "cut length" || q == "return length")
    return "because no travel of the master is left for the return";
  if (q.starts_with("sync")) return limit + " in step";
  return limit + (q.starts_with("ramp") ? " as it runs up" : " on its return");
}

std::vector<SyncFigure> figures_of(const FlyingShear& shear, const Spec& spec) {
  const ShearPlan plan = shear_plan(shear);
  const ShearBound least = least_cut_length(shear);
  const ShearBound most = greatest_line_speed(shear);
  const std::string& m = spec.units.x;
  const std::string speed = rounded(shear.line_speed) + " " + speed_unit(spec);
  const bool left = !shear.sync_time && !shear.sync_length;
  const std::string none = left ? "; the sync zone vanishes there" : "";
  std::vector<SyncFigure> all{
      {"in step", plan.sync, m,
       fmt::format("{} {} at {}{}", rounded(plan.sync / shear.line_speed), spec.time_unit, speed,
                   left ? ", as long as stroke and return allow" : "")}};
  if (std::isfinite(least.value))
    all.push_back({"shortest cut", least.value, m,
                   fmt::format("at {}{}, {}{}", constant(spec), speed, limited_by(least), none)});
  if (std::isfinite(most.value))
    all.push_back(
        {"fastest line", most.value, speed_unit(spec),
         fmt::format("for cuts of {} {} with a new table, {}{}{}", rounded(shear.cut_length), m,
                     at_constant_speed(spec), limited_by(most), none)});
  return all;
}

std::string pieces_of(const CutList& list) {
  const std::size_t n = list.lengths.size();
  return fmt::format("{} piece{}", n, n == 1 ? "" : "s") + (list.waste ? " and one of waste" : "");
}

/// The slowest piece of a list: the line must not be faster.
CutSpeed slowest_piece(const CutListSpec& cuts, const Spec& spec) {
  const CutLengths lengths = cut_lengths(spec);
  const CutLimits limits{spec.slave, std::numeric_limits<double>::infinity()};
  CutSpeed least = lengths.fastest(cuts.list[0], limits);
  for (std::size_t i = 1; i < cuts.list.size(); ++i)
    if (const CutSpeed next = lengths.fastest(cuts.list[i], limits); next.speed < least.speed)
      least = next;
  return least;
}

std::vector<SyncFigure> figures_of(const CutListSpec& cuts, const Spec& spec) {
  const Cutter cutter(cuts.machine, cuts.line);
  const std::string& m = spec.units.x;
  double pass = 0;
  for (std::size_t i = 0; i < cuts.list.size(); ++i) pass += cuts.list[i];
  std::vector<SyncFigure> all{
      {"one pass", pass, m, pieces_of(cuts.list)},
      {"from home", cutter.approach(), m, "travel of the web from home to a cut"},
      {"to home", cutter.retreat(), m, "travel of the web from a cut to home"},
      {"next cut", cutter.approach() + cutter.retreat(), m,
       "after a cut, if the cutter has begun to return home"}};
  add_speeds(all, spec);
  const CutSpeed least = slowest_piece(cuts, spec);
  if (std::isfinite(least.speed))
    all.push_back({"fastest line", least.speed, speed_unit(spec),
                   fmt::format("for the piece of {} {}, {}limited by the slave's {}",
                               rounded(least.length), m, at_constant_speed(spec), least.limit)});
  return all;
}

template <class Find>
auto of_sync(const Spec& spec, Find&& find) -> decltype(find(GearSpec{})) {
  const auto* sync = std::get_if<SyncSpec>(&spec.subject);
  if (sync == nullptr) return {};
  try {
    return std::visit(find, *sync);
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

}  // namespace

Report check_sync(const Spec& spec) {
  return of_sync(spec, [&](const auto& kind) { return findings_of(kind, spec); });
}

std::vector<SyncFigure> sync_figures(const Spec& spec) {
  return of_sync(spec, [&](const auto& kind) { return figures_of(kind, spec); });
}

bool is_made_for_a_speed(const Spec& spec) {
  const auto* sync = std::get_if<SyncSpec>(&spec.subject);
  if (sync == nullptr) return false;
  const auto cuts = cut_list_of(*sync);
  return cuts && std::holds_alternative<FlyingShear>(cuts->machine);
}

bool stays_in_gear(const Spec& spec) {
  const auto* sync = std::get_if<SyncSpec>(&spec.subject);
  return sync != nullptr && (std::holds_alternative<GearCourse>(*sync) ||
                             std::holds_alternative<GearInPosPart>(*sync));
}

}  // namespace jounce
