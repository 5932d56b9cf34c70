#include "jounce/io/make.hpp"

#include <utility>

#include "jounce/io/units.hpp"

namespace jounce {
namespace {

template <class Over>
Sampled sampled(const Curve<Over>& curve, const TableOptions& options) {
  if (options.intervals) return sample(curve, options.rule, *options.intervals);
  const Range travel = extrema(curve, 0);
  const double stroke = travel.max.value - travel.min.value;
  // A billionth of the stroke is finer than any encoder of today resolves.
  const double tolerance = options.tolerance.value_or(1e-9 * (stroke > 0 ? stroke : 1));
  return sample_within(curve, options.rule, tolerance);
}

std::string numbered(std::size_t i, const std::string& name) {
  return std::to_string(i + 1) + (name.empty() ? "" : " " + name);
}

Made make_cam(const CamSpec& cam, const TableOptions& options) {
  auto [curve, origin] = design(cam);
  std::vector<std::string> names;
  names.reserve(origin.size());
  for (const std::size_t i : origin) names.push_back(numbered(i, cam.segments[i].name));
  Sampled table = sampled(curve, options);
  return {std::move(curve), std::move(names), std::move(table)};
}

Made make_trajectory(Trajectory curve, Sampled table) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < curve.segments().size(); ++i) names.push_back(numbered(i, ""));
  return {std::move(curve), std::move(names), std::move(table)};
}

/// A generator names its own fields; in the document they stand under [move].
Profile make_profile(const MoveSpec& move) {
  try {
    return std::holds_alternative<SCurveSpec>(move) ? s_curve(std::get<SCurveSpec>(move))
                                                    : trapezoid(std::get<TrapezoidSpec>(move));
  } catch (const InputError& error) {
    throw InputError("move." + error.key(), error.value(), error.rule());
  }
}

Made make_any(const Spec& spec) {
  if (std::holds_alternative<AxisSpec>(spec.subject))
    throw InputError("kind", "\"axis\"", "an axis makes no table; it is what `jounce run` takes");
  if (const auto* cam = std::get_if<CamSpec>(&spec.subject)) return make_cam(*cam, spec.table);
  if (const auto* knots = std::get_if<Table>(&spec.subject))
    return make_trajectory(knots->curve<OverTime>(), {*knots, {}});
  Trajectory curve = make_profile(std::get<MoveSpec>(spec.subject)).curve();
  Sampled table = sampled(curve, spec.table);
  return make_trajectory(std::move(curve), std::move(table));
}

}  // namespace

Made make(const Spec& spec) {
  try {
    return make_any(spec);
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

namespace {

Trajectory master_of(const Spec& spec) {
  if (!spec.master)
    throw InputError(
        "master", "",
        "is missing: a cam is played by a master; add [master] with velocity and distance");
  const MasterSpec& master = *spec.master;
  const double unit = seconds_per_unit(spec);
  const double velocity = master.velocity / unit;
  const auto& cam = std::get<CamSpec>(spec.subject);
  const double start = cam.start.master;
  const double turn = cam.segments.back().end.master - start;
  // Every period has breaks of its own, and each is integrated.
  if (master.distance < 1e-9 * turn || master.distance > 1e4 * turn)
    throw InputError("master.distance", number(master.distance),
                     "must be between 1e-9 and 1e4 lengths of the cam, which is " + number(turn));
  if (!master.acceleration)
    return Trajectory({line(master.distance / velocity, start, start + master.distance)}, 0,
                      Outside::hold);
  return trapezoid(
             {start, start + master.distance, velocity, *master.acceleration / (unit * unit), 0})
      .curve();
}

}  // namespace

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

CamProblem make_problem(const Spec& spec) {
  const auto* cam = std::get_if<CamSpec>(&spec.subject);
  if (cam == nullptr)
    throw InputError("kind", "", "only a cam can be optimised").at(spec.document.name);
  CamProblem problem{.cam = *cam,
                     .free = spec.optimize.free,
                     .limits = spec.limits,
                     .minimize = spec.optimize.minimize};
  if (spec.optimize.seed) problem.seed = *spec.optimize.seed;
  if (spec.optimize.starts) problem.starts = static_cast<int>(*spec.optimize.starts);
  if (spec.optimize.tolerance) problem.tolerance = *spec.optimize.tolerance;
  try {
    require_valid(problem);
  } catch (const InputError& error) {
    // The problem names its own fields; in the document all but the knots stand under [optimize].
    const bool of_a_knot = error.key().starts_with("segment") || error.key().starts_with("start.");
    const std::string key = of_a_knot ? error.key() : "optimize." + error.key();
    throw spec.document.located(InputError(key, error.value(), error.rule()));
  }
  return problem;
}

}  // namespace jounce
