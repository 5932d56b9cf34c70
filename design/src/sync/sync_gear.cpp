// SPDX-License-Identifier: Apache-2.0
#include "design/src/sync/sync_gear.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce::design_detail {
Report check_gear(const GearCourse& course, const Units& units) {
  double ratio = course.ratio;
  for (const RatioChange& change : course.changes)
    if (change.at == course.master_start && change.distance == 0) ratio = change.ratio;
  if (ratio == course.ratio) return {};
  Finding f;
  f.rule = "gear/ratio_step";
  f.quantity = "the ratio";
  f.where = course.master_start;
  f.value = ratio;
  f.limit = course.ratio;
  f.margin = -1;
  f.broken = true;
  f.unit = units.position + "/" + units.x;
  f.advice = "engage over a distance greater than 0, or give from_ratio = " + number(ratio) +
             " if the slave already has this ratio at the start";
  return {{f}};
}

Report check_gear(const GearInPosPart& part, const Units& units) {
  const GearInPos gear = gear_in_pos(part.gear);
  const double way =
      gear.ratio * part.gear.master_start_distance;  // travel of the gear in this time
  const double h = gear.slave_sync - gear.slave_start;
  // If a reversal could be avoided, the warnings of the cam report it.
  if (!gear || h * way > 0) return {};
  const Range slope = extrema(*gear.curve, 1);
  const Extremum back = gear.ratio > 0 ? slope.min : slope.max;
  if (-back.value * gear.ratio <= 0) return {};
  const Range y = extrema(*gear.curve, 0);
  const double most = way > 0 ? y.min.value : y.max.value;
  const auto [low, high] = std::minmax({gear.slave_sync - 0.6 * way, gear.slave_sync - 0.4 * way});
  Finding f;
  f.rule = "gear/reversal";
  f.has_limit = false;
  f.quantity = "geo_velocity";
  f.where = back.where;
  f.value = back.value;
  f.margin = -std::abs(back.value / gear.ratio);
  f.severity = Severity::warning;
  f.advice = engage_window(part.gear).advice + ", here to " + rounded(most) + " " + units.position +
             "; with slave_start between " + rounded(low) + " and " + rounded(high) +
             " the slave neither reverses nor exceeds the velocity of the gear";
  return {{f}};
}

}  // namespace jounce::design_detail
