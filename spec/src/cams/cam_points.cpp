// SPDX-License-Identifier: Apache-2.0
#include "spec/src/cams/cam_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "spec/src/cams/drawn_cam.hpp"
#include "spec/src/toml/point_file.hpp"

namespace jounce::spec_detail {
namespace {

using profiles_detail::rounded_input;

/// The points of a segment, from a file of points or from a drawing.
Points points_of_file(TomlReader& segment, const Units& units,
                      const std::vector<std::string>& columns) {
  if (auto drawn = read_drawn_points(segment, units)) return *std::move(drawn);
  if (segment.has("drawing"))
    segment.fail("drawing", "", "applies to points from a drawing: points = \"plate.dxf\"");
  return *read_point_file(segment, "point", columns);
}

std::vector<std::string> columns_for(Law law) {
  std::vector<std::string> columns{"master", "slave"};
  if (law == Law::quintic_spline) columns.emplace_back("tolerance");
  if (is_spline(law)) return columns;
  columns.insert(columns.end(), {"geo_velocity", "geo_acceleration", "geo_jerk"});
  return columns;
}

void read_column(const Points& file, const char* name, const std::string& unit,
                 std::vector<CamPoint>& points, std::optional<double> CamPoint::*field) {
  if (file.find(name) == nullptr) return;
  const std::vector<double> values = file.in_unit(name, unit);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].*field = values[i];
}

void read_masters(const Points& file, const std::string& unit, std::vector<CamPoint>& points) {
  const std::vector<double> masters = file.in_unit("master", unit);
  require_ascending(file, {"master", unit});
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].master = masters[i];
    if (i > 0 && !(masters[i] > masters[i - 1]))
      throw file.error(
          i, "master", masters[i], unit,
          "must be greater than " + number(masters[i - 1]) + " " + unit + ", the previous point");
  }
}

/// Reads the tolerances: the column of the file, or the key of the segment for all points.
void read_tolerances(TomlReader& segment, Law law, const Points& file, const std::string& unit,
                     std::vector<CamPoint>& points) {
  std::vector<double> tolerances(points.size(), 0);
  if (file.find("tolerance") != nullptr) tolerances = file.in_unit("tolerance", unit);
  if (const auto all = segment.optional_number("tolerance", unit)) {
    if (law != Law::quintic_spline)
      segment.fail("tolerance", number(*all), "applies to the law `quintic_spline` only");
    if (file.find("tolerance") != nullptr)
      segment.fail("tolerance", number(*all),
                   "cannot be combined with the column tolerance of the file: leave one of the two "
                   "out");
    if (!(*all >= 0)) segment.fail("tolerance", number(*all), "must not be negative");
    tolerances.assign(points.size(), *all);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(tolerances[i] >= 0))
      throw file.error(i, "tolerance", tolerances[i], unit, "must not be negative");
    points[i].tolerance = tolerances[i];
  }
}

}  // namespace

CamKnot CamPointFile::knot_of(const CamPoint& point) {
  return {point.master, point.slave.value_or(0), point.geo_velocity, point.geo_acceleration};
}

std::vector<CamPoint> CamPointFile::within(Law law, const CamKnot& from, const CamKnot& to) const {
  std::vector<CamPoint> inside;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CamPoint& point = points[i];
    if (point.master < from.master || point.master > to.master)
      throw file.error(i, "master", point.master, units.x,
                       "must lie in its segment, " + number(from.master) + " to " +
                           number(to.master) + " " + units.x);
    const CamKnot* const knot = point.master == from.master ? &from
                                : point.master == to.master ? &to
                                                            : nullptr;
    if (knot == nullptr || law == Law::hermite) inside.push_back(point);
    if (knot == nullptr) continue;
    const double rounding = rounded_input * std::max(std::abs(knot->slave), std::abs(*point.slave));
    if (std::abs(*point.slave - knot->slave) > point.tolerance + rounding)
      throw file.error(i, "slave", *point.slave, units.position,
                       "must be " + number(knot->slave) + " " + units.position +
                           ", the knot of the spec at this master position");
  }
  return inside;
}

std::optional<CamPointFile> read_cam_points(TomlReader& segment, Law law, const Units& units) {
  if (!segment.is_text("points")) {
    if (segment.has("tolerance"))
      segment.fail("tolerance", "",
                   "applies to points = \"FILE\" only: leave it out, or give each point in points "
                   "a tolerance");
    return std::nullopt;
  }
  if (!takes_points(law))
    segment.fail("points", *segment.optional_text("points"),
                 std::string("the law ") + name(law) +
                     " takes no points: leave them out, or use polynomial, cubic_spline, "
                     "quintic_spline or hermite");
  Points file = points_of_file(segment, units, columns_for(law));
  std::vector<CamPoint> points(file.size());
  read_masters(file, units.x, points);
  read_column(file, "slave", units.position, points, &CamPoint::slave);
  if (!points.front().slave) (void)file.in_unit("slave", units.position);  // throws: it is missing
  int order = 1;
  for (const auto& [name, field] : {std::pair{"geo_velocity", &CamPoint::geo_velocity},
                                    {"geo_acceleration", &CamPoint::geo_acceleration},
                                    {"geo_jerk", &CamPoint::geo_jerk}})
    read_column(file, name, rate_unit(units.position, units.x, order++), points, field);
  read_tolerances(segment, law, file, units.position, points);
  return CamPointFile{std::move(file), std::move(points), units};
}

std::optional<MasterSpan> span_of_points(TomlReader& segment, const Units& units) {
  if (!segment.is_text("points")) return std::nullopt;
  std::vector<std::string> any = columns_for(Law::hermite);
  any.emplace_back("tolerance");
  const auto masters = points_of_file(segment, units, any).in_unit("master", units.x);
  return MasterSpan{masters.front(), masters.back()};
}

}  // namespace jounce::spec_detail
