// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>
#include <vector>

#include "jounce/base/units.hpp"
#include "jounce/controllers/detail/time_table_limits.hpp"
#include "jounce/optimize/spline_times.hpp"
#include "jounce/pvt/fill.hpp"

#include "spec/src/toml/parts.hpp"
#include "spec/src/toml/point_file.hpp"

namespace jounce::spec_detail {
namespace {

const std::vector<std::string> fillings{"natural",      "clamped",      "periodic",
                                        "not_a_knot",   "monotone",     "shape_preserving",
                                        "minimum_jerk", "within_limits"};
const std::vector<std::string> objectives{"shortest"};

/// Reads a derivative of a knot. It may be omitted only if `velocities` names the rule that
/// computes it.
std::optional<double> derivative_of(TomlReader& knot, const char* key, const std::string& unit,
                                    bool may_be_missing) {
  if (!knot.has(key)) knot.refuse_misspelt(key);
  if (!may_be_missing && !knot.has(key))
    knot.fail(key, "",
              std::string("is missing: add ") + key +
                  " to each knot, or a rule at the top, such as velocities = \"clamped\"");
  return knot.optional_number(key, unit);
}

void read_rows(TomlReader& top, const Units& units, FillSpec& fill, bool may_be_missing) {
  if (top.tables("knot").size() < 2) top.refuse_misspelt("knot");
  if (top.tables("knot").empty())
    top.fail("knot", "",
             "is missing: add [[knot]] with time and position for each knot, or points = "
             "\"FILE.csv\"");
  for (TomlReader& knot : top.tables("knot")) {
    fill.x.push_back(knot.number("time", units.x));
    fill.p.push_back(knot.number("position", units.position));
    if (fill.rule != Interpolation::linear)
      fill.v.push_back(
          derivative_of(knot, "velocity", rate_unit(units.position, units.x, 1), may_be_missing));
    if (fill.rule == Interpolation::quintic_hermite)
      fill.a.push_back(derivative_of(knot, "acceleration", rate_unit(units.position, units.x, 2),
                                     may_be_missing));
    if (fill.rule != Interpolation::quintic_hermite)
      for (const char* key : {"velocity", "acceleration"})
        if (fill.rule == Interpolation::linear || key[0] == 'a')
          knot.refuse_here(key, std::string("does not apply to rule = \"") + name(fill.rule) +
                                    "\": leave it out, or change the rule");
    knot.finish();
  }
}

void take_columns(const Points& points, const Units& units, FillSpec& fill, bool may_be_missing) {
  const auto derivative = [&](const char* name, int order, auto& values) {
    if (points.find(name) == nullptr) {
      if (!may_be_missing)
        throw InputError(
            name, "",
            "is missing: add the column, or a rule in the spec, such as velocities = \"clamped\"")
            .at(points.document, 1);
      values.resize(points.size());
    } else {
      for (const double v : points.in_unit(name, rate_unit(units.position, units.x, order)))
        values.push_back(v);
    }
  };
  fill.x = points.in_unit("time", units.x);
  require_ascending(points, {"time", units.x});
  fill.p = points.in_unit("position", units.position);
  if (points.size() < 2)
    throw InputError("", "", "is the only point of the file: a table needs at least two")
        .at(points.document, static_cast<int>(points.lines.front()));
  if (fill.rule != Interpolation::linear) derivative("velocity", 1, fill.v);
  if (fill.rule == Interpolation::quintic_hermite) derivative("acceleration", 2, fill.a);
}

std::optional<Points> knots_file(TomlReader& top, Interpolation rule) {
  switch (rule) {
    case Interpolation::linear:
      return read_point_file(top, "knot", {"time", "position"});
    case Interpolation::cubic_hermite:
      return read_point_file(top, "knot", {"time", "position", "velocity"});
    case Interpolation::quintic_hermite:
      break;
  }
  return read_point_file(top, "knot", {"time", "position", "velocity", "acceleration"});
}

FillSpec read_fill(TomlReader& top, const Units& units, Interpolation rule,
                   const std::optional<Points>& points) {
  FillSpec fill;
  const auto filling = top.optional_choice("velocities", fillings);
  if (filling) fill.filling = *filling_named(fillings[*filling]);
  fill.rule = rule;
  fill.outside = read_outside(top, true);
  if (points)
    take_columns(*points, units, fill, filling.has_value());
  else
    read_rows(top, units, fill, filling.has_value());
  if (filling && rule == Interpolation::linear)
    top.fail("velocities", '"' + fillings[*filling] + '"',
             "does not apply to rule = \"linear\", which has no velocities: leave it out");
  return fill;
}

Table made_of(FillSpec fill, Spec& spec) {
  if (fill.rule == Interpolation::linear)
    return Table(Domain::time, fill.rule, fill.outside,
                 {std::move(fill.x), std::move(fill.p), {}, {}});
  fill.limits = spec.limits;
  try {
    Filled made = filled(fill);
    spec.fill = std::move(made.report);
    return std::move(made.table);
  } catch (const InputError& error) {
    if (error.key() != "rule") throw;
    throw InputError("table.rule", error.value(), error.rule());
  }
}

/// The table. Throws InputError for the knot at the end of the first segment that is not finite.
Table with_finite_segments(Table table) {
  try {
    require_curve(table);
  } catch (const InputError& error) {
    const std::string begin = "segment[";
    if (!error.key().starts_with(begin)) throw;
    const int segment = std::stoi(error.key().substr(begin.size()));
    throw InputError("knot[" + std::to_string(segment + 1) + "]", "",
                     "is the end of a segment whose " + error.rule());
  }
  return table;
}

Table filled_table(TomlReader& top, Spec& spec, Interpolation rule) {
  std::optional<Points> points = knots_file(top, rule);
  FillSpec fill = read_fill(top, spec.units, rule, points);
  const bool has_file = points.has_value();
  points.reset();  // read again for the place of an error
  const auto table = [&] {
    if (spec.himc) himc::require_pvt(fill.x);
    return with_finite_segments(made_of(fill, spec));
  };
  if (!has_file) return table();
  ColumnUnits units{{"time", spec.units.x}};
  for (const auto& [column, order] :
       {std::pair{"position", 0}, {"velocity", 1}, {"acceleration", 2}})
    units[column] = rate_unit(spec.units.position, spec.units.x, order);
  try {
    return table();
  } catch (const InputError& error) {
    throw placed(error, *knots_file(top, rule), units);
  }
}

/// The cubic spline as a table with its knots. It is exact, also as a quintic table.
Table table_of(const Trajectory& spline, Interpolation rule, Extrapolation outside) {
  Columns columns;
  for (const double x : spline.breaks()) {
    const Jet jet = spline.jet(x, x == spline.end() ? Side::left : Side::right);
    columns.x.push_back(x);
    columns.p.push_back(jet[0]);
    columns.v.push_back(jet[1]);
    if (rule == Interpolation::quintic_hermite) columns.a.push_back(jet[2]);
  }
  return Table(Domain::time, rule, outside, std::move(columns));
}

Table shortest_table(TomlReader& top, const Spec& spec, Interpolation rule) {
  if (rule == Interpolation::linear)
    top.fail("times", "\"shortest\"", "needs rule = \"cubic_hermite\" or \"quintic_hermite\"");
  top.refuse_here(
      "velocities",
      "times = \"shortest\" computes the velocities: remove velocities, or remove times");
  const Extrapolation outside = read_outside(top, false);
  if (top.has("points"))
    top.fail("points", "",
             "has times: for times = \"shortest\" give each [[knot]] a position only");
  SplineTimesSpec times;
  times.limits = {spec.limits};
  std::vector<TomlReader> knots = top.tables("knot");
  bool refused = false;  // one message for all of them
  for (const char* key : {"time", "velocity", "acceleration"})
    for (TomlReader& knot : knots)
      if (!refused && knot.has(key)) {
        refused = true;
        knot.refuse_here(key,
                         "times = \"shortest\" computes the times and velocities of all knots: "
                         "give each knot a position only, or remove the line times = \"shortest\"");
      }
  for (TomlReader& knot : knots) {
    times.points.push_back({knot.number("position", spec.units.position)});
    for (const char* key : {"time", "velocity", "acceleration"}) knot.may_have(key);
    knot.finish();
  }
  try {
    return table_of(spline_times(times).best.joints.front(), rule, outside);
  } catch (const InputError& error) {
    const bool of_limits = error.key().starts_with("limits[1]");
    throw InputError(of_limits ? "limits" + error.key().substr(9) : "knot", error.value(),
                     error.rule());
  }
}

}  // namespace

bool wants_shortest_times(TomlReader& top) {
  return top.optional_choice("times", objectives).has_value();
}

Table read_knots(TomlReader& top, Spec& spec, Interpolation rule) {
  static const std::vector<std::string> controllers{"himc"};
  spec.himc = top.optional_choice("controller", controllers).has_value();
  if (!wants_shortest_times(top)) return filled_table(top, spec, rule);
  Table table = shortest_table(top, spec, rule);
  if (spec.himc) himc::require_pvt(table.columns().x);
  return table;
}

}  // namespace jounce::spec_detail
