// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/detail/points_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

constexpr std::array words{"normal", "even", "stop", "continue"};

void require_quadratic(const Columns& c, std::size_t i) {
  const double h = c.x[i] - c.x[i - 1];
  const double off = c.p[i] - c.p[i - 1] - (c.v[i - 1] + c.v[i]) / 2 * h;
  const double size =
      std::abs(c.p[i - 1]) + std::abs(c.p[i]) + (std::abs(c.v[i - 1]) + std::abs(c.v[i])) * h;
  if (std::abs(off) <= rounded_sum * size) return;
  throw InputError("rule", "cubic_hermite",
                   "is not possible for the format points, which needs a constant acceleration "
                   "between the knots; before knot " +
                       std::to_string(i + 1) +
                       ", the acceleration changes. Use --controller googol_pt or googol_follow");
}

/// True if the first velocity is zero within the rounding of a law at its begin.
bool begins_at_rest(const Columns& c) {
  double peak = 0;
  for (const double v : c.v) peak = std::max(peak, std::abs(v));
  return std::abs(c.v.front()) <= rounded_sum * peak;
}

/// Type of the piece that ends at knot i.
PtType type_of(const Table& table, std::size_t i) {
  if (table.rule() == Interpolation::linear) return PtType::even;
  const Columns& c = table.columns();
  require_quadratic(c, i);
  if (i > 1 || begins_at_rest(c)) return PtType::normal;
  if (table.axis() == Domain::master) return PtType::continued;
  throw InputError("knot[1].velocity", c.v[0],
                   "must be 0: the first normal segment begins at rest");
}

/// Whole numbers of the controller's unit, without the rounding of a change of units.
double tidy(double x) {
  const double whole = std::round(x);
  return std::abs(x - whole) <= rounded_sum * std::abs(x) ? whole : x;
}

}  // namespace

std::vector<PtPoint> points_of(const Table& table) {
  if (table.rule() == Interpolation::quintic_hermite)
    throw InputError("rule", name(table.rule()),
                     "is not possible for the format points, which has only straight lines and "
                     "parabolas: use --rule linear, or --controller googol_pt or googol_follow");
  const Columns& c = table.columns();
  std::vector<PtPoint> points;
  for (std::size_t i = 1; i < table.size(); ++i)
    points.push_back({tidy(c.x[i] - c.x[0]), c.p[i] - c.p[0], type_of(table, i)});
  return points;
}

std::string points_text(const TableFile& file) {
  const bool over_time = file.table.axis() == Domain::time;
  std::string text = std::string(over_time ? "time" : "master") + " [" + file.units.x + "]," +
                     (over_time ? "position" : "slave") + " [" + file.units.position + "],type\n";
  for (const PtPoint& point : points_of(file.table))
    text += number(point.x) + "," + number(point.position) + "," +
            words[static_cast<std::size_t>(point.type)] + "\n";
  return text;
}

}  // namespace jounce
