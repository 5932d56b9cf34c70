// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/make.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/cam/laws/polydyne.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/pvt/warnings.hpp"
#include "jounce/spec/detail/in_document.hpp"

#include "design/src/make/cam_of.hpp"
#include "design/src/make/table_of.hpp"
#include "design/src/motions/motion.hpp"
#include "design/src/path/path_motion.hpp"

namespace jounce {

CamSpec design_detail::cam_of(const Spec& spec) {
  return filled(std::get<CamSpec>(spec.subject), spec.boundaries);
}

namespace {

using profiles_detail::rounded_input;

using design_detail::cam_of;
using design_detail::table_limits;
using design_detail::table_of;

constexpr double linear_table = 1e-6;   ///< share of the stroke
constexpr double least_master = 1e-9;   ///< share of the length of a cam
constexpr double shortest_pass = 1e-6;  ///< s

std::string numbered(std::size_t i, const std::string& name) {
  return std::to_string(i + 1) + (name.empty() ? "" : " " + name);
}

/// The mode of [polydyne] in cycles per unit of the master.
Mode mode_over_master(const Spec& spec) {
  if (!spec.master)
    throw InputError("polydyne", "", "needs the speed of the master: add [master] with velocity");
  const double speed = spec.master->velocity / seconds_per_unit(spec);
  return {spec.polydyne->frequency / speed, spec.polydyne->damping};
}

/// The cam that makes the load move as the knots state, in spite of the spec's mode.
Polydyne driven(const Spec& spec, const Cam& output) {
  return polydyne(output, mode_over_master(spec));
}

/// Residual vibration after one run of the cam, at the speed of the master.
double residual_of(const Spec& spec, const Cam& cam) {
  const auto segments = cam.segments();
  return residual_vibration(Trajectory({segments.begin(), segments.end()}), mode_over_master(spec));
}

/// The cam of a spec of kind "cam", before [polydyne].
NamedCam output_of(const Spec& spec) {
  if (const auto* made = std::get_if<NamedCam>(&spec.subject)) return *made;
  return named(std::get<CamSpec>(spec.subject), spec.boundaries);
}

Made make_cam(const Spec& spec) {
  auto [curve, names, error, velocity_error] = output_of(spec);
  std::vector<Residual> residuals;
  if (spec.polydyne) {
    Cam made = driven(spec, curve).cam;
    residuals.push_back({*spec.polydyne, residual_of(spec, curve), residual_of(spec, made)});
    curve = std::move(made);
  }
  Sampled table = table_of(curve, spec.table, table_limits(spec));
  table.error.position += error;
  table.error.velocity += velocity_error;
  Made made{spec.parts().front(), std::move(curve), std::move(names), std::move(table),
            std::move(residuals)};
  made.fit = error;
  return made;
}

Made make_sync(const Spec& spec) {
  SyncCam made = sync_cam_of(std::get<SyncSpec>(spec.subject));
  std::vector<std::string> names;
  std::size_t number = 0;  // all pieces of a law have the same number
  for (std::size_t i = 0; i < made.segments.size(); ++i) {
    if (i > 0 && made.segments[i] != made.segments[i - 1]) ++number;
    names.push_back(numbered(number, made.segments[i]));
  }
  Sampled table = table_of(made.cam, spec.table, table_limits(spec));
  return {spec.parts().front(), std::move(made.cam), std::move(names), std::move(table), {},
          std::move(made.zones)};
}

/// The motions before any operator, and the names of their segments. Without names, segments have
/// the numbers 1, 2, ...
struct Motions {
  std::vector<Trajectory> curves;
  std::vector<std::string> names;
  design_detail::PathMotion path = {};  ///< for the kind "path": names for each axis, and fits

  /// The names of an axis, once: those of a long path take much memory.
  [[nodiscard]] std::vector<std::string> take_names(std::size_t axis) {
    return path.names.empty() ? names : std::move(path.names[axis]);
  }
};

Motions motions_of(const PathSpec& spec) {
  design_detail::PathMotion path = design_detail::motion_of(spec);
  std::vector<Trajectory> curves = std::move(path.axes.curves);
  return {std::move(curves), {}, std::move(path)};
}

Motions motions_of(const Spec& spec) {
  if (const auto* knots = std::get_if<Table>(&spec.subject))
    return {{knots->curve<OverTime>()}, {}};
  if (const auto* table = std::get_if<TimeTableSpec>(&spec.subject))
    return {{motion_of(*table)}, labels_of(*table)};
  if (const auto* axes = std::get_if<AxesSpec>(&spec.subject))
    return {design_detail::motions_of(*axes), {}};
  if (const auto* path = std::get_if<PathSpec>(&spec.subject)) return motions_of(*path);
  if (const auto* queue = std::get_if<QueueSpec>(&spec.subject)) {
    design_detail::QueueMotion motion = design_detail::motion_of(*queue);
    return {{std::move(motion.curve)}, std::move(motion.labels)};
  }
  return {{design_detail::motion_of(std::get<MoveSpec>(spec.subject))}, {}};
}

/// Names of the segments after the operators. The many segments of a filtered motion have no
/// meaning, and so no names.
std::vector<std::string> names_after(const Spec& spec, const Trajectory& curve,
                                     std::vector<std::string> names) {
  const bool same = std::all_of(spec.then.begin(), spec.then.end(), [](const Operator& each) {
    return std::holds_alternative<RetimeSpec>(each);
  });
  const bool changed = std::all_of(spec.then.begin(), spec.then.end(), [](const Operator& each) {
    return std::holds_alternative<RetimeSpec>(each) || std::holds_alternative<ChangeSpec>(each);
  });
  if (same && !names.empty()) return names;
  names.clear();
  for (std::size_t i = 0; i < curve.segments().size(); ++i)
    names.push_back(changed ? numbered(i, "") : "all");
  return names;
}

std::optional<Mode> mode_of(const Operator& each) {
  if (const auto* shaper = std::get_if<ShaperSpec>(&each)) return shaper->mode;
  if (const auto* notch = std::get_if<NotchSpec>(&each))
    return Mode{notch->frequency, notch->mode_damping};
  return std::nullopt;
}

std::vector<Residual> residuals_of(const Spec& spec, const Trajectory& before,
                                   const Trajectory& after) {
  std::vector<Residual> all;
  for (const Operator& each : spec.then) {
    const auto mode = mode_of(each);
    if (!mode) continue;
    const Mode scaled{mode->frequency * seconds_per_unit(spec), mode->damping};
    all.push_back({*mode, residual_vibration(before, scaled), residual_vibration(after, scaled)});
  }
  return all;
}

/// A table over time whose velocity steps becomes a linear table, the only rule that permits two
/// velocities at a knot. The tolerance is a millionth of the stroke, because its parabolas would
/// require very many lines for a smaller one.
void choose_rule(const Spec& spec, const Trajectory& curve, TableOptions& options) {
  if (!std::holds_alternative<TimeTableSpec>(spec.subject) || options.rule) return;
  const Jump step = largest_jump(with(curve, Extrapolation::refuse), 1);
  if (std::abs(step.step) <= rounded_input * std::abs(extrema(curve, 1).peak().value)) return;
  options.rule = Interpolation::linear;
  if (options.tolerance || options.intervals) return;
  const Range travel = extrema(curve, 0);
  if (travel.max.value > travel.min.value)
    options.tolerance = linear_table * (travel.max.value - travel.min.value);
}

/// The key of [[segment]], [[command]], [[point]] or [[knot]] with the number in the name of a
/// segment; "" if the spec has none.
std::string key_of_segment(const Spec& spec, const std::vector<std::string>& names,
                           std::size_t segment) {
  const std::string name = segment < names.size() ? names[segment] : "";
  const std::string number = name.substr(0, name.find_first_not_of("0123456789"));
  for (const char* list : {"segment", "command", "point", "knot"}) {
    std::string key = std::string(list) + "[" + number + "]";
    if (spec.document.places.contains(key)) return key;
  }
  return "";
}

/// The table of an axis. An error has the key of the table of this axis, or of the segment, which has
/// its number in `names`.
Sampled table_of_axis(const Spec& spec, const Trajectory& curve, const AxisPart& part,
                      std::size_t i, const std::vector<std::string>& names) {
  try {
    return table_of(curve, part.table, {part.limits});
  } catch (const design_detail::Unresolved& error) {
    throw spec_detail::renamed(error, key_of_segment(spec, names, error.segment()));
  } catch (const InputError& error) {
    const std::string own = "axis[" + std::to_string(i + 1) + "]." + error.key();
    throw spec_detail::renamed(error, spec.document.units.contains(own) ? own : error.key());
  }
}

std::vector<Made> make_motions(const Spec& spec) {
  std::vector<AxisPart> parts = spec.parts();
  // The knots of a PVT spec are its table, unless an operator has changed the motion.
  if (const auto* knots = std::get_if<Table>(&spec.subject); knots != nullptr && spec.then.empty())
    return {{parts.front(), LazyCurve(*knots), {}, {*knots, {}, {}}}};
  Motions before = motions_of(spec);
  // Without operators, nothing is compared with the motion before: a copy of a long path takes much memory.
  std::vector<Trajectory> curves = spec.then.empty() ? std::move(before.curves) : before.curves;
  const std::vector<Jet> fits =
      design_detail::apply(spec.then, parts, seconds_per_unit(spec), curves);
  std::vector<Made> all;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    choose_rule(spec, curves[i], parts[i].table);
    std::vector<std::string> names = names_after(spec, curves[i], before.take_names(i));
    Sampled table = table_of_axis(spec, curves[i], parts[i], i, names);
    table.error.position += fits[i][0];
    table.error.velocity += fits[i][1];
    if (!before.path.names.empty()) {
      table.error.position += before.path.axes.error[i][0];
      table.error.velocity += before.path.axes.error[i][1];
    }
    std::vector<Residual> residuals;
    if (!spec.then.empty()) residuals = residuals_of(spec, before.curves[i], curves[i]);
    all.push_back({parts[i],
                   std::move(curves[i]),
                   std::move(names),
                   std::move(table),
                   std::move(residuals),
                   {},
                   before.path.plan,
                   before.path.overlap});
  }
  return all;
}

std::vector<Made> make_any(const Spec& spec) {
  if (std::holds_alternative<AxisSpec>(spec.subject))
    throw InputError(
        "kind", "\"axis\"",
        "is an axis, which has no motion of its own: use it with `jounce check` and `jounce run`");
  if (std::holds_alternative<DriveAlone>(spec.subject))
    throw InputError("kind", "\"drive\"",
                     "is a drive, which has no motion of its own: use it with `jounce identify` or "
                     "`jounce plot --drive bode`");
  if (!spec.over_master()) return make_motions(spec);
  std::vector<Made> all;
  all.push_back(spec.is_cam() ? make_cam(spec) : make_sync(spec));
  return all;
}

}  // namespace

std::vector<Made> make_axes(const Spec& spec) {
  try {
    return make_any(spec);
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

Made make(const Spec& spec) {
  std::vector<Made> all = make_axes(spec);
  if (all.size() > 1)
    throw spec.document.located(InputError("axis", std::to_string(all.size()),
                                           "must be 1: this works with a single axis only"));
  return std::move(all.front());
}

namespace {

/// Start and end of the cam of a spec, in the master unit.
std::pair<double, double> master_range(const Spec& spec) {
  if (const auto* sync = std::get_if<SyncSpec>(&spec.subject)) {
    const Cam cam = sync_cam_of(*sync).cam;
    return {cam.start(), cam.end()};
  }
  if (const auto* made = std::get_if<NamedCam>(&spec.subject))
    return {made->cam.start(), made->cam.end()};
  const auto& cam = std::get<CamSpec>(spec.subject);
  return {cam.start.master, cam.segments.back().end.master};
}

Trajectory master_of(const Spec& spec) {
  if (!spec.master)
    throw InputError("master", "",
                     "is missing: the motion over time needs the speed of the master; add [master] "
                     "with velocity");
  const MasterSpec& master = *spec.master;
  const double unit = seconds_per_unit(spec);
  const double velocity = master.velocity / unit;
  const auto [start, end] = master_range(spec);
  const double turn = end - start;
  // Every period has its own breaks, and each is integrated.
  if (master.distance < least_master * turn || master.distance > 1e4 * turn)
    throw InputError("master.distance", number(master.distance),
                     "must be 1e-9 to 1e4 times the length of the cam, " + six_digits(turn));
  if (master.distance / velocity < shortest_pass)
    throw InputError("master.velocity",
                     number(master.velocity) + " " + rate_unit(spec.units.x, spec.time_unit, 1),
                     "is too high: the master would travel master.distance in less than 1 us");
  if (!master.acceleration)
    return Trajectory({line(master.distance / velocity, start, start + master.distance)}, 0,
                      Extrapolation::hold);
  return trapezoid(
             {start, start + master.distance, velocity, *master.acceleration / (unit * unit), 0})
      .curve();
}

}  // namespace

Report table_warnings(const Spec& spec) {
  if (!spec.then.empty()) return {};
  if (spec.polydyne) return driven(spec, output_of(spec).cam).warnings;
  const std::string unit = rate_unit(spec.units.position, spec.units.x, 1);
  if (const auto* table = std::get_if<TimeTableSpec>(&spec.subject))
    return warnings_of(*table, unit);
  const auto* knots = std::get_if<Table>(&spec.subject);
  if (knots == nullptr) return {};
  Report report = overshoot(*knots, unit);
  Report steps = velocity_steps(*knots);
  std::move(steps.findings.begin(), steps.findings.end(), std::back_inserter(report.findings));
  return report;
}

Trajectory make_master(const Spec& spec) {
  try {
    return master_of(spec);
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

double seconds_per_unit(const Spec& spec) {
  return conversion(spec.time_unit, "s");
}

Limits slave_limits_by_master(const Spec& spec) {
  Limits limits;
  double power = 1;
  const auto divide = [&](const char* name, const std::optional<double>& over_time,
                          std::optional<double>& by_master) {
    if (over_time && !spec.master)
      throw InputError(std::string("limits.slave.") + name, *over_time,
                       "is a limit over time: add [master], the speed of the master");
    if (spec.master) power *= spec.master->velocity;
    if (over_time) by_master = *over_time / power;
  };
  divide("velocity", spec.slave.velocity, limits.velocity);
  divide("acceleration", spec.slave.acceleration, limits.acceleration);
  divide("jerk", spec.slave.jerk, limits.jerk);
  return limits;
}

Limits with_slave_limits(Limits limits, const Spec& spec) {
  const auto tighten = [](std::optional<double>& limit, const std::optional<double>& other) {
    if (other && (!limit || *other < *limit)) limit = other;
  };
  const Limits slave = slave_limits_by_master(spec);
  tighten(limits.velocity, slave.velocity);
  tighten(limits.acceleration, slave.acceleration);
  tighten(limits.jerk, slave.jerk);
  return limits;
}

namespace {

/// Throws InputError for a jerk at a knot, which the optimizers do not consider.
void require_no_jerk(const CamSpec& cam) {
  const auto require = [](const CamKnot& knot, const std::string& key) {
    if (knot.geo_jerk.value_or(0) != 0)
      throw InputError(key + "geo_jerk", *knot.geo_jerk,
                       "cannot be combined with `free`: leave it out, or optimize any numbers of "
                       "the spec with [[optimize.parameter]]");
  };
  require(cam.start, "start.");
  for (std::size_t i = 0; i < cam.segments.size(); ++i)
    require(cam.segments[i].end, "segment[" + std::to_string(i + 1) + "].end.");
}

/// The limits of [limits.slave] for a cam whose master accelerates as stated by [master]; none
/// without [master].
RampedLimits ramped_limits(const Spec& spec) {
  if (!spec.master) return {};
  const double w = spec.master->velocity;
  return {spec.master->acceleration.value_or(0) / (w * w), slave_limits_by_master(spec)};
}

}  // namespace

design_detail::TableLimits design_detail::table_limits(const Spec& spec) {
  if (!spec.master) return {spec.limits};
  return {with_slave_limits(spec.limits, spec), ramped_limits(spec)};
}

InputError nothing_free(const Spec& spec) {
  if (std::holds_alternative<DriveAlone>(spec.subject))
    return spec.document.located(InputError(
        "kind", "\"drive\"",
        "has no motion to optimize: fit its numbers to a recording with `jounce identify`, "
        "or optimize a cam against it with --against"));
  if (std::holds_alternative<AxisSpec>(spec.subject))
    return spec.document.located(InputError(
        "kind", "\"axis\"",
        "has no motion to optimize: give the spec of a motion, such as a cam or a move"));
  return InputError("optimize.parameter", "",
                    "is missing: add [optimize] with minimize or maximize, and "
                    "[[optimize.parameter]] with key and range for each number that may change "
                    "(free knots and shapes are for kind = \"cam\")")
      .at(spec.document.name);
}

CamProblem make_problem(const Spec& spec) {
  const auto* cam = std::get_if<CamSpec>(&spec.subject);
  if (cam == nullptr) throw nothing_free(spec);
  if (spec.polydyne)
    throw spec.document.located(InputError(
        "polydyne", "",
        "cannot be combined with [optimize], because its knots describe the motion of the load: "
        "leave one of the two out"));
  CamProblem problem{
      .cam = *cam, .free = spec.optimize.free, .limits = {}, .minimize = spec.optimize.minimize};
  problem.options.seed = spec.optimize.seed.value_or(problem.options.seed);
  if (spec.optimize.starts) problem.options.starts = static_cast<int>(*spec.optimize.starts);
  problem.options.tolerance = spec.optimize.tolerance.value_or(problem.options.tolerance);
  problem.options.budget.seconds = spec.optimize.seconds;
  try {
    problem.cam = cam_of(spec);
    require_no_jerk(problem.cam);
    problem.limits = with_slave_limits(spec.limits, spec);
    problem.ramped = ramped_limits(spec);
    require_valid(problem);
  } catch (const InputError& error) {
    // The problem uses its own names. In the document, all but these keys are under [optimize].
    const bool of_a_knot = error.key().starts_with("segment") ||
                           error.key().starts_with("start.") || error.key().starts_with("limits.");
    const std::string key = error.key() == "free" ? "segment"  // the section of this key
                            : of_a_knot           ? error.key()
                                                  : "optimize." + error.key();
    throw spec.document.located(InputError(key, error.value(), error.rule()));
  }
  return problem;
}

}  // namespace jounce
