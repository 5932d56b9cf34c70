// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/fit.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/drawing.hpp"
#include "jounce/io/points.hpp"
#include "jounce/spec/detail/drawn_cam.hpp"

#include "design/src/convert/missing_units.hpp"
#include "design/src/fit/fit_spec.hpp"
#include "design/src/input/file_name.hpp"

namespace jounce {
namespace {

/// The points of a file, and their motion between them.
struct Measurement {
  MeasuredCam cam;
  Units units;
  std::size_t points = 0;
  Interpolation rule = Interpolation::linear;
  Columns columns;
  std::optional<DiscPart> disc = {};  ///< for the drawing of a plate
};

double option(const char* key, const std::string& text, const std::string& unit) {
  try {
    const double value = quantity(text, unit);
    if (!(value > 0)) throw InputError(key, text, "must be greater than 0");
    return value;
  } catch (const InputError& error) {
    throw InputError(key, text, error.rule());
  }
}

std::string unit_of(const char* key, const std::string& in_file, const std::string& given,
                    const char* example) {
  if (!given.empty() && !is_position_unit(given))
    throw InputError(key, given, "is not a unit of a length or an angle, or pulse");
  if (!in_file.empty() && !given.empty() && given != in_file)
    throw InputError(key, given, "is not the unit in the file, " + in_file + ": leave it out");
  if (!in_file.empty()) return in_file;
  if (given.empty())
    throw InputError(
        key, "", std::string("is missing: the file names no unit. Give one, such as ") + example);
  return given;
}

Units units_of(const Units& in_file, const FitOptions& options) {
  if (in_file.x.empty() && in_file.position.empty() && options.master_unit.empty() &&
      options.position_unit.empty())
    throw design_detail::both_units_missing("deg", "mm");
  return {unit_of("master_unit", in_file.x, options.master_unit, "deg"),
          unit_of("position_unit", in_file.position, options.position_unit, "mm")};
}

std::vector<double> tolerances_of(const Points& file, const FitOptions& options,
                                  const std::string& unit) {
  if (!options.tolerance.empty())
    return std::vector<double>(file.size(), option("tolerance", options.tolerance, unit));
  if (file.find("tolerance") == nullptr)
    throw InputError("tolerance", "",
                     "is missing: give the greatest distance from a point, such as --tolerance "
                     "20um, or add a column `tolerance` to the file");
  std::vector<double> all = file.in_unit("tolerance", unit);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!(all[i] > 0)) throw file.error(i, "tolerance", all[i], unit, "must be greater than 0");
  return all;
}

void require_over_master(const Points& file) {
  const auto is_named = [&](const char* column) { return file.find(column) != nullptr; };
  if (is_named("time") && !is_named("master"))
    throw InputError("time", "",
                     "is a column of a motion over time: fit makes cams, from the columns "
                     "master and slave. For such points, use `points` of a spec of kind pvt or pt")
        .at(file.document, 1);
}

Measurement from_points(Points file, const FitOptions& options) {
  const std::vector<std::string> known{"master", "slave", "time", "tolerance"};
  file.name_columns(known);
  require_over_master(file);
  const auto named = [&](const char* column) {
    const PointColumn* found = file.find(column);
    return found == nullptr ? std::string() : found->unit;
  };
  Measurement m;
  m.units = units_of({named("master"), named("slave")}, options);
  m.columns.x = file.in_unit("master", m.units.x);
  m.columns.p = file.in_unit("slave", m.units.position);
  m.points = file.size();
  const std::vector<double> tolerances = tolerances_of(file, options, m.units.position);
  for (std::size_t i = 0; i < m.points; ++i) {
    if (i > 0 && !(m.columns.x[i] > m.columns.x[i - 1]))
      throw file.error(i, "master", m.columns.x[i], m.units.x,
                       "must be greater than " + number(m.columns.x[i - 1]) + " " + m.units.x +
                           ", the previous point");
    m.cam.points.push_back({m.columns.x[i], m.columns.p[i], tolerances[i]});
  }
  return m;
}

/// The points of a drawing. A plate repeats after one turn.
Measurement from_drawing(const std::string& path, const FitOptions& options) {
  DrawnCam drawn =
      read_drawn_cam(path, options.drawing, {options.master_unit, options.position_unit});
  Measurement m = from_points(std::move(drawn.points), options);
  m.cam.periodic = drawn.disc.has_value();
  m.disc = std::move(drawn.disc);
  return m;
}

/// Knots of a table. If it is not linear, places between the knots become points, too.
Measurement from_table(const Input& input, const FitOptions& options) {
  constexpr std::size_t places = 720;  // points of a table with velocities, at least
  const Table& table = input.table.table;
  if (table.axis() != Domain::master)
    throw InputError("FILE", design_detail::file_name(input),
                     "is a table over time: fit reads cams, over a master");
  if (options.tolerance.empty())
    throw InputError(
        "tolerance", "",
        "is missing: give the greatest distance from the table, such as --tolerance 20um");
  Measurement m;
  m.units = units_of(input.table.units, options);
  m.rule = table.rule();
  m.columns = table.columns();
  m.points = table.size();
  m.cam.periodic = repeats(table.outside());
  const double tolerance = option("tolerance", options.tolerance, m.units.position);
  const std::size_t parts =
      table.rule() == Interpolation::linear ? 1 : 1 + places / (table.size() - 1);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double from = m.columns.x[i];
    m.cam.points.push_back({from, m.columns.p[i], tolerance});
    for (std::size_t k = 1; k < parts && i + 1 < table.size(); ++k) {
      const double at =
          from + (m.columns.x[i + 1] - from) * static_cast<double>(k) / static_cast<double>(parts);
      m.cam.points.push_back({at, table.jet(at)[0], tolerance});
    }
  }
  return m;
}

/// Throws InputError if the way back to the first point, in the rest of the period, would be much steeper than the
/// motion in the file: the slave probably advances in each period.
void require_return(const Measurement& m, double end, const std::string& period) {
  constexpr double much = 4;  // times the greatest slope between two points
  const auto& points = m.cam.points;
  const auto slope = [](const SplinePoint& a, double slave, double master) {
    return std::abs(slave - a.slave) / (master - a.master);
  };
  double greatest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    greatest = std::max(greatest, slope(points[i - 1], points[i].slave, points[i].master));
  const double back = slope(points.back(), points.front().slave, end);
  if (back <= much * greatest) return;
  throw InputError("period", period,
                   "needs a point at " + number(end) + " " + m.units.x +
                       ", the end of the period: the slave would have to return from " +
                       rounded(points.back().slave) + " to " + rounded(points.front().slave) + " " +
                       m.units.position +
                       " in the rest of it. Add this point; a slave that "
                       "advances in each period has another position there");
}

/// Throws InputError if a tolerance is greater than the travel of the slave, so that a dwell would fit.
void require_tolerance_below_travel(const Measurement& m) {
  const auto& points = m.cam.points;
  const auto [least, greatest] = std::minmax_element(
      points.begin(), points.end(),
      [](const SplinePoint& a, const SplinePoint& b) { return a.slave < b.slave; });
  const double travel = points.empty() ? 0 : greatest->slave - least->slave;
  for (const SplinePoint& p : points)
    if (travel > 0 && p.tolerance > travel)
      throw InputError("tolerance", number(p.tolerance) + " " + m.units.position,
                       "must be at most the travel of the slave, " + rounded(travel) + " " +
                           m.units.position + ": with more, a dwell fits all points");
}

/// Makes the points those of one period.
void close(Measurement& m, const std::string& text) {
  const double period = option("period", text, m.units.x);
  auto& points = m.cam.points;
  const double end = points.front().master + period;
  constexpr double same_place = 1e-9;  // share of the period
  if (points.back().master > end + same_place * period)
    throw InputError("period", text,
                     "must be at least " + number(points.back().master - points.front().master) +
                         " " + m.units.x + ", the travel of the master in the file");
  m.cam.periodic = true;
  if (points.back().master >= end - same_place * period) return;
  require_return(m, end, text);
  points.push_back({end, points.front().slave, points.front().tolerance});
  m.columns.x.push_back(end);
  m.columns.p.push_back(m.columns.p.front());
  if (!m.columns.v.empty()) m.columns.v.push_back(m.columns.v.front());
  if (!m.columns.a.empty()) m.columns.a.push_back(m.columns.a.front());
}

Measurement from_text(const std::string& text, const std::string& path, const FitOptions& options) {
  if (!options.drawing.empty())
    throw InputError("drawing", options.drawing,
                     "applies to a drawing, .dxf or .svg: leave it out");
  if (!spec_kind(text).empty())
    throw InputError("FILE", path,
                     "is a spec: fit reads points or a table. Make its table with `jounce design`");
  return is_finished_table(text, path)
             ? from_table(table_inputs(text, path).front(), options)
             : from_points(parse_points(text, path == "-" ? "standard input" : path), options);
}

std::string stem(const std::string& path) {
  const std::string name = path == "-" ? "cam" : std::filesystem::path(path).stem().string();
  std::string plain;
  for (const char c : printable(name)) plain += c == '"' || c == '\\' ? '_' : c;
  return plain;
}

FittedCam fitted(Measurement m, const std::string& path, const FitOptions& options) {
  constexpr double table_share = 0.1;  // share of the tolerance, for the table of the spec
  require_tolerance_below_travel(m);
  if (!options.period.empty()) close(m, options.period);
  FittedCam made;
  made.source = path == "-" ? "standard input" : path;
  made.units = m.units;
  made.points = m.points;
  made.curved = m.rule != Interpolation::linear;
  for (const SplinePoint& p : m.cam.points) made.tolerance = std::max(made.tolerance, p.tolerance);
  try {
    made.fit = fit_cam(m.cam);
  } catch (const InputError& error) {
    throw error.key() == "points" ? error.at(made.source, 0) : error;
  }
  const Cam cam = design(made.fit.spec).cam;
  made.between = certified(cam, m.rule, m.columns).error;
  made.text = design_detail::fit_spec_text(
      made.fit.spec, m.units, stem(path),
      "Fitted by `jounce fit` to the " + std::to_string(m.points) + " points of " +
          printable(made.source) + ".\n# Greatest distance from a point: " + rounded(made.fit.gap) +
          " " + m.units.position + " (tolerance " + rounded(made.tolerance) + " " +
          m.units.position + ").",
      table_share * made.tolerance, m.disc);
  return made;
}

}  // namespace

FittedCam fitted_cam(const std::string& path, const FitOptions& options) {
  return is_drawing(path) ? fitted(from_drawing(path, options), path, options)
                          : fitted_cam(point_file_bytes(path), path, options);
}

FittedCam fitted_cam(const std::string& text, const std::string& path, const FitOptions& options) {
  return fitted(from_text(text, path, options), path, options);
}

}  // namespace jounce
