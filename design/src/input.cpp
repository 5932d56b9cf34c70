// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/base/printable.hpp"
#include "jounce/base/units.hpp"
#include "jounce/controllers/time_table_limits.hpp"
#include "jounce/design/disc.hpp"
#include "jounce/design/limit_advice.hpp"
#include "jounce/design/sync_check.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/pvt/check.hpp"
#include "jounce/validate/loop.hpp"

#include "design/src/against.hpp"
#include "design/src/load_check.hpp"
#include "design/src/path/path_rounding.hpp"
#include "design/src/table_check.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_value;

// Default tolerances of a table with equal intervals and of others, as shares of the stroke.
constexpr double coarse_share = 1e-6;
constexpr double fine_share = 1e-9;

Input from_made(Made made, const Spec& spec, const std::string& path) {
  const AxisPart& part = made.part;
  TableFile table{std::move(made.sampled.table),
                  part.units,
                  {path == "-" ? "" : printable(path), hex(spec.document.hash), made_by()}};
  const bool is_table = std::holds_alternative<Table>(spec.subject) && spec.then.empty();
  const std::string name = spec.name.empty() ? printable(path) : spec.name;
  return {spec,
          std::move(made.curve),
          std::move(table),
          is_table ? std::nullopt : std::optional(made.sampled.error),
          part.limits,
          Labels{part.units, spec.over_master(), std::move(made.segments)},
          part.name.empty() ? name : name + " " + part.name,
          part.name,
          part.table,
          part.drive,
          std::move(made.residuals),
          std::move(made.zones),
          made.sampled.binding,
          {},
          std::move(made.plan),
          std::move(made.overlap),
          {},
          made.fit};
}

/// True if the number of knots is given, so that the table has the least error for this number.
bool is_best_of_so_many(const Input& input) {
  return input.options.target && !input.options.tolerance;
}

/// The finding for the error of the table against its tolerance.
Finding table_error(const Input& input) {
  const double allowed = *table_tolerance(input);
  const bool broken = input.error->position > allowed;
  return {"table/position",
          "table",
          "position",
          input.error->where,
          input.error->position,
          allowed,
          (allowed - input.error->position) / allowed,
          broken,
          std::nullopt,
          broken ? "give [table] a tolerance, or more intervals" : "",
          {},
          {}};
}

void append(Report& report, const Report& part) {
  report.findings.insert(report.findings.end(), part.findings.begin(), part.findings.end());
}

/// Checks the continuity at the joints. The moving ends of a cam that runs once are no joints;
/// add_ends() reports them.
Report check_joints(const Input& input, int continuity) {
  if (input.labels.over_master) {
    const Cam& cam = std::get<Cam>(*input.curve);
    if (!check_ends(cam).findings.empty())
      return check_continuity(with(cam, Extrapolation::refuse), continuity);
  }
  return of_motion(input, [&](const auto& motion) { return check_continuity(motion, continuity); });
}

/// Advice for a step at an edge of the grid of a compensation, where the correction ends while the
/// motion goes on; "" for another step.
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

/// The positions at which the pieces of a curve begin.
std::vector<double> joints_of(const Input& input) {
  return of_motion(input, [](const auto& motion) {
    std::vector<double> all;
    if constexpr (requires { motion.segments(); })
      for (const Segment& piece : motion.segments()) all.push_back(value(piece, 0));
    else
      all = motion.columns().p;
    return all;
  });
}

/// Keeps the worst finding of each excursion beyond a limit of the position. An excursion may take
/// several pieces: it goes on where the curve is beyond the limit at their joint.
void join_excursions(const Input& input, Report& report) {
  std::vector<const Finding*> beyond;
  for (const Finding& f : report.findings)
    if (f.broken && f.segment && (f.rule == "limit/position_max" || f.rule == "limit/position_min"))
      beyond.push_back(&f);
  if (beyond.size() < 2) return;
  std::sort(beyond.begin(), beyond.end(), [](const Finding* a, const Finding* b) {
    return std::pair(a->rule.text(), *a->segment) < std::pair(b->rule.text(), *b->segment);
  });
  const std::vector<double> joints = joints_of(input);
  const auto excess = [](const Finding& f) { return std::abs(f.value - f.limit); };
  std::set<const Finding*> dropped;
  const Finding* worst = beyond.front();
  for (std::size_t i = 1; i < beyond.size(); ++i) {
    const Finding& f = *beyond[i];
    const bool above = f.value > f.limit;
    const auto first = joints.begin() + static_cast<std::ptrdiff_t>(*beyond[i - 1]->segment) + 1;
    const bool goes_on =
        f.rule == worst->rule &&
        std::all_of(first, joints.begin() + static_cast<std::ptrdiff_t>(*f.segment) + 1,
                    [&](double joint) { return above ? joint > f.limit : joint < f.limit; });
    if (goes_on) dropped.insert(excess(f) > excess(*worst) ? worst : &f);
    if (!goes_on || excess(f) > excess(*worst)) worst = &f;
  }
  std::erase_if(report.findings, [&](const Finding& f) { return dropped.contains(&f); });
}

/// Adds the first passage of a limit of the position to its worst finding: there, the soft limit of a
/// controller stops the axis (Googol manual, example 9-1).
void name_first_passages(const Input& input, Report& report) {
  if (input.labels.over_master) return;
  for (const char* const limit : {"limit/position_max", "limit/position_min"}) {
    const auto worst = std::find_if(report.findings.begin(), report.findings.end(),
                                    [&](const Finding& f) { return f.broken && f.rule == limit; });
    if (worst == report.findings.end()) continue;
    const std::vector<double> passages =
        crossings(std::get<Trajectory>(*input.curve), 0, worst->limit);
    if (passages.empty()) continue;
    worst->advice = fmt::format("the motion first passes this limit at {:.6g} {}; {}",
                                passages.front(), input.labels.units.x, worst->advice);
  }
}

Report check_curve(const Input& input, int continuity) {
  Report report = of_motion(input, [&](const auto& motion) { return check(motion, input.limits); });
  design_detail::forgive_rounding(report, input);
  join_excursions(input, report);
  design_detail::keep_worst(report, input.labels);
  advise_on_limits(input, report);
  if (input.plan)
    for (Finding& f : report.findings)
      if (f.broken && f.rule.name().starts_with("position"))
        f.advice = "move this part of the path into the range of the axis";
  name_first_passages(input, report);
  append(report, check_joints(input, continuity));
  for (Finding& f : report.findings)
    if (f.broken && f.rule.family() == RuleFamily::continuity)
      if (const std::string advice = advice_at_edge(input, f); !advice.empty()) f.advice = advice;
  if (input.plan) design_detail::discount_rounding(std::get<Trajectory>(*input.curve), report);
  append(report, design_detail::check_slave(input));
  if (input.against) design_detail::judge_against(input, report);
  if (!input.error) return report;
  if (!is_best_of_so_many(input)) report.findings.push_back(table_error(input));
  // The table may break a limit between its knots although the curve keeps it.
  append(report, design_detail::check_table(input.table.table, input, report));
  return report;
}

/// Velocity of the master in units per second; 0 if none is given.
double master_speed(const Spec& spec, const EngageState& at) {
  const double speed = spec.master ? spec.master->velocity / seconds_per_unit(spec) : 0;
  return at.master_velocity.value_or(speed);
}

/// Findings for the start of the coupling. Times of a coupling are in s, also if the spec has
/// another unit of time.
Report check_coupling(const Spec& spec, const Cam& cam, const EngageState& at) {
  const Coupling coupling(cam, *spec.coupling);
  const double slave = at.slave.value_or(value(cam.segments().front(), 0));
  const Jet master{at.master.value_or(cam.start()), master_speed(spec, at), 0, 0};
  Report report = check(coupling, {.position = slave}, master);
  for (Finding& f : report.findings) {
    if (f.quantity == "master") f.unit = spec.units.x;
    for (std::size_t k = 1; k < OverTime::names.size(); ++k)
      if (f.quantity == OverTime::names[k])
        f.unit = rate_unit(spec.units.position, "s", static_cast<int>(k));
  }
  return report;
}

/// Adds advice to the finding for a moving end of a cam: the motion of the slave after the end, or
/// the jump of a resting slave at the beginning.
void explain_end(Finding& end, const Input& input, const EngageState& at) {
  const Spec* const spec = input.spec ? &*input.spec : nullptr;
  const Units& units = input.labels.units;
  const auto coupling = spec != nullptr ? spec->coupling.value_or(CouplingSpec{}) : CouplingSpec{};
  const double speed = spec != nullptr ? master_speed(*spec, at) : at.master_velocity.value_or(0);
  const double slave = end.value * coupling.slave_scaling * coupling.master_scaling * speed;
  if (speed != 0)
    end.advice = fmt::format("at the master velocity {} {}, the slave moves at {} {} there; ",
                             rounded(speed), rate_unit(units.x, "s", 1), rounded(slave),
                             rate_unit(units.position, "s", 1));
  if (end.rule == "coupling/begin") {
    end.broken = true;
    end.margin = -1;
    end.advice +=
        "a slave at rest jumps to this speed: let the cam begin at rest, or bring the slave in "
        "with [coupling] start = \"ramp_in\"";
    return;
  }
  const bool in_gear = spec != nullptr && stays_in_gear(*spec);
  end.advice +=
      in_gear ? "with a live master, it stays in gear after the end of its table"
              : "with a live master, it brakes there within the limits of its axis, or keeps its "
                "velocity with `stream --keep-velocity`: let the cam end at rest, or repeat";
  if (!in_gear) end.severity = Severity::warning;
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
    if (f.rule == "coupling/end" || f.rule == "coupling/begin") explain_end(f, input, at);
}

/// Adds the number of the error with which HIMC rejects a table that breaks a limit.
void name_himc_errors(Report& report) {
  for (Finding& f : report.findings) {
    if (!f.broken || f.rule.family() != RuleFamily::limit) continue;
    const std::string error = himc::pvt_limit_error(f.quantity);
    if (!error.empty()) f.advice = "MovePVT refuses the table: HIMC error " + error;
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

}  // namespace

void add_not_limited(Report& report, const Input& input) {
  const Limits slave = input.spec ? input.spec->slave : Limits{};
  const Limits& own = input.limits;
  const std::array limited{true, own.velocity || slave.velocity,
                           own.acceleration || slave.acceleration, own.jerk || slave.jerk};
  const auto& names = input.labels.over_master ? OverMaster::names : OverTime::names;
  const Ranges ranges = of_motion(input, [](const auto& motion) { return extrema(motion); });
  for (std::size_t k = 1; k < limited.size(); ++k) {
    const Extremum& peak = ranges[k].peak();
    if (limited[k] || peak.value == 0) continue;
    Finding f;
    f.rule = Rule(RuleFamily::unlimited, names[k]);
    f.quantity = names[k];
    f.where = peak.where;
    f.value = peak.value;
    f.severity = Severity::note;
    f.has_limit = false;
    report.findings.push_back(std::move(f));
  }
}

void add_no_limits(Report& report, const Spec* spec) {
  if (has_limits(report)) return;
  const auto gives = [&](const std::string& section) {
    return spec != nullptr &&
           std::any_of(spec->document.places.begin(), spec->document.places.end(),
                       [&](const auto& place) { return place.first.starts_with(section); });
  };
  const bool slave = gives("limits.slave.");
  const bool drive = gives("drive.limits.");
  Finding f;
  f.rule = "warning/no_limits";
  f.quantity = "limits";
  f.severity = Severity::warning;
  f.has_limit = false;
  f.advice = spec != nullptr ? "give [limits] in the spec, or --limit"
                             : "give the spec of the table with --against, or --limit";
  if (slave) {
    f.quantity = "limits.slave";
    f.advice = "add [master] with velocity: these limits are over time";
  } else if (drive) {
    f.quantity = "drive.limits";
    f.advice = "`jounce validate` compares the motion with these limits";
  }
  report.findings.push_back(std::move(f));
  sort(report);
}

std::optional<double> table_tolerance(const Input& input) {
  if (!input.error) return std::nullopt;
  if (is_best_of_so_many(input)) return input.error->position;
  const Range travel =
      std::visit([](const auto& curve) { return extrema(curve, 0); }, *input.curve);
  const double stroke = travel.max.value - travel.min.value;
  const double asked = input.options.tolerance.value_or(
      (input.options.intervals ? coarse_share : fine_share) * (stroke > 0 ? stroke : 1));
  return std::max(asked + input.fit, rounded_value * std::abs(travel.peak().value));
}

Input input_of(TableFile file, const std::string& path) {
  LazyCurve curve(file.table);
  Labels labels{file.units, file.table.axis() == Domain::master, {}};
  return {std::nullopt, std::move(curve),  std::move(file), std::nullopt,
          {},           std::move(labels), printable(path), ""};
}

std::vector<Input> inputs_of(const Spec& spec, const std::string& path) {
  std::vector<Input> all;
  for (Made& made : make_axes(spec)) all.push_back(from_made(std::move(made), spec, path));
  return all;
}

namespace {

/// Reads the spec of the machine of a G-code program: axes, limits and corners, but no motion.
Spec read_gcode_machine(const std::string& machine, const std::string& program) {
  std::string text = read_file(machine);
  if (const std::string kind = spec_kind(text); kind == "machine" || kind == "axis")
    throw InputError(
        "--machine", machine,
        "is of kind \"" + kind +
            "\", for `jounce run`. A G-code program needs a spec of kind \"path\" with "
            "the axes, their limits and the corners: see `jounce new path`");
  Spec spec = parse_spec(std::move(text), machine);
  const auto* const path = std::get_if<PathSpec>(&spec.subject);
  if (path == nullptr)
    throw InputError("--machine", machine, "must be a spec of kind \"path\" without commands");
  if (const auto commands = path->program.commands(); !commands.empty())
    throw InputError("--machine", machine,
                     "has a motion of its own, " + path->source + ":" +
                         std::to_string(commands.front().line) + ": remove it from " + machine +
                         " to use that spec for " + program + ", or give " + machine +
                         " instead of " + program + ", without --machine");
  return spec;
}

}  // namespace

Spec gcode_spec(const std::string& path, const std::string& machine) {
  const std::string name = path == "-" ? "standard input" : path;
  std::string program = read_file(path);
  if (!spec_kind(program).empty())
    throw InputError("", "", "is a spec, not a G-code program: leave out --machine").at(name, 1);
  Spec spec = read_gcode_machine(machine, path);
  auto* const of = std::get_if<PathSpec>(&spec.subject);
  set_gcode(*of, std::move(program), name);
  spec.name = path == "-" ? "standard input" : printable(path);
  return spec;
}

std::vector<Input> gcode_inputs(const std::string& path, const std::string& machine) {
  return inputs_of(gcode_spec(path, machine), machine);
}

Report check_all(const Input& input, int continuity, const EngageState& at) {
  Report report = check_curve(input, continuity);
  if (input.spec) {
    const Spec& spec = *input.spec;
    const auto add = [&](const Report& part) { append(report, part); };
    if (spec.himc) name_himc_errors(report);
    if (!input.against) {  // these findings concern the spec, not the table
      add(spec.fill);
      add(check_sync(spec));
      add(merged(table_warnings(spec), report));
    }
    if (spec.is_cam()) add(check_load(spec, std::get<Cam>(*input.curve)));
    if (spec.disc) add(check_disc(spec, std::get<Cam>(*input.curve)));
    if (spec.coupling) add(check_coupling(spec, std::get<Cam>(*input.curve), at));
    if (spec.compare && !spec.compare->plane && spec.compare->axis == input.axis)
      add(check(spec.compare->compare, std::get<Trajectory>(*input.curve), spec.compare->device));
  }
  add_ends(input, at, report);
  if (!input.newer_spec.empty()) report.findings.push_back(design_detail::older_table(input));
  if (input.drive)
    if (auto unstable = unstable_loop(input.drive->drive)) {
      unstable->axis = "drive";
      report.findings.push_back(*std::move(unstable));
    }
  sort(report);
  return report;
}

}  // namespace jounce
