// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/follow_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/follow/follow_gap.hpp"
#include "gear/src/follow/follow_knots.hpp"
#include "gear/src/follow/follow_passes.hpp"

namespace jounce {
namespace {

using gear_detail::FollowGap;
using gear_detail::FollowKnot;
using gear_detail::FollowPiece;

using profiles_detail::rounded_input;

}  // namespace

FollowTable follow_table(const FollowPlan& plan) {
  const auto knots = gear_detail::follow_knots(plan);
  FollowTable table;
  table.loops = plan.periodic ? 0 : 1;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const FollowKnot& to = knots[i];
    if (to.zone) {
      table.segments.push_back({to.master, to.slave, PtType::even});
      continue;
    }
    const auto pieces = pieces_of(gap(knots[i - 1], to), plan.whole_master);
    PtPoint at{knots[i - 1].master, knots[i - 1].slave, PtType::normal};
    for (const FollowPiece& piece : pieces)
      table.segments.push_back(at = {at.x + piece.length, at.position + piece.travel, piece.type});
    // The last point is exactly the given knot, without the rounding of the pieces, so a motion
    // ends exactly at rest.
    PtPoint& last = table.segments.back();
    last = {to.master, to.slave,
            *to.ratio == 0 && last.type == PtType::normal ? PtType::stop : last.type};
  }
  PtType& first = table.segments.front().type;
  if (first == PtType::normal && *knots.front().ratio != 0) first = PtType::continued;
  return table;
}

CamSpec cam_spec(const FollowPlan& plan) {
  const auto knots = gear_detail::follow_knots(plan);
  // In a zone the ratio is that of the spec. The ratio computed from far positions would differ by
  // their rounding.
  const auto in_step = [&](std::size_t i) {
    return knots[i].zone || (i + 1 < knots.size() && knots[i + 1].zone);
  };
  const bool seam = plan.periodic && (in_step(0) || in_step(knots.size() - 1));
  const auto cam_knot = [&](std::size_t i) {
    const FollowKnot& k = knots[i];
    const bool end = i == 0 || i + 1 == knots.size();
    if (in_step(i) || (end && seam)) return CamKnot{k.master, k.slave, {}, 0.0};
    return CamKnot{k.master, k.slave, k.ratio, 0.0};
  };
  CamSpec spec;
  spec.start = cam_knot(0);
  spec.periodic = plan.periodic;
  const double travel = std::abs(knots.back().slave);
  if (plan.periodic && travel > 0) spec.slave_period = travel;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const FollowKnot& k = knots[i];
    const bool stands =
        !k.zone && k.slave == knots[i - 1].slave && *k.ratio == 0 && *knots[i - 1].ratio == 0;
    const Law law = k.zone ? Law::line : (stands ? Law::dwell : plan.law);
    spec.segments.push_back({law, cam_knot(i), k.zone ? plan.zones[*k.zone].name : ""});
  }
  return spec;
}

namespace {

FollowSpec table_spec(const FollowPlan& plan) {
  return {{follow_table(plan)}, *gear_detail::follow_knots(plan).front().ratio};
}

std::vector<SyncZone> zones_of(const FollowPlan& plan) {
  std::vector<SyncZone> zones;
  for (const FollowZone& z : plan.zones)
    zones.push_back({z.from, z.to, z.name.empty() ? "ratio " + six_digits(z.ratio) : z.name});
  return zones;
}

SyncCam smooth(const FollowPlan& plan) {
  const CamSpec spec = cam_spec(plan);
  auto [cam, origin] = design(spec);
  std::vector<std::string> names;
  for (const std::size_t i : origin) {
    const CamSegment& segment = spec.segments[i];
    names.push_back((segment.name.empty() ? name(segment.law) : segment.name) +
                    (" to " + gear_detail::place(segment.end.master)));
  }
  const bool starts_in_step = !plan.periodic && *gear_detail::follow_knots(plan).front().ratio != 0;
  return {starts_in_step ? with(cam, Extrapolation::refuse) : cam, std::move(names),
          zones_of(plan)};
}

/// A gap as a separate cam.
Cam gap_cam(const FollowGap& g, Law law) {
  CamSpec spec;
  spec.start = {0, 0, g.r0, 0.0};
  spec.segments = {{law, {g.length, g.travel, g.r1, 0.0}}};
  return design(spec).cam;
}

/// Greatest backward ratio of the slave in a gap; 0 if it does not run backwards.
Extremum backwards_in(const FollowGap& g, const FollowPlan& plan) {
  const int s = gear_detail::way(g);
  if (s == 0 || (g.travel == 0 && g.r0 == 0 && g.r1 == 0)) return {};
  if (plan.form == FollowForm::table && s * g.travel > 0) return {};
  const Cam cam = plan.form == FollowForm::smooth ? gap_cam(g, plan.law) : [&] {
    std::vector<PtPoint> points;
    PtPoint at;
    for (const FollowPiece& p : pieces_of(g, false))
      points.push_back(at = {at.x + p.length, at.position + p.travel, PtType::continued});
    return pt<OverMaster>(points, g.r0);
  }();
  const Range r = extrema(cam, 1);
  const Extremum& worst = s > 0 ? r.min : r.max;
  const bool against = -s * worst.value > rounded_input * std::abs(r.peak().value);
  return against ? worst : Extremum{};
}

/// The least travel for which the gap's law does not move backwards. It lies between the given
/// travel, which does, and that of a straight ramp, which does not.
double least_travel(const FollowGap& g, const FollowPlan& plan) {
  if (plan.form == FollowForm::table) return 0;
  double bad = g.travel;
  double good = (g.r0 + g.r1) * g.length / 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (bad + good) / 2;
    FollowGap tried = g;
    tried.travel = middle;
    (backwards_in(tried, plan).value != 0 ? bad : good) = middle;
  }
  return good;
}

std::string away_from_zero(double travel) {
  return travel < 0 ? six_digits_down(travel) : six_digits_up(travel);
}

std::string travel_advice(const FollowGap& g, const FollowPlan& plan, double from, double to) {
  const std::string where = "between master " + six_digits(from) + " and master " + six_digits(to) +
                            ", the slave travels " + six_digits(g.travel);
  const double least = least_travel(g, plan);
  if (plan.form == FollowForm::table || gear_detail::way(g) * g.travel <= 0)
    return where +
           ", but the ratios at both ends move it the other way: change the slave position "
           "of one of the two points, or add a point where it reverses";
  return where + ": let it travel at least " + away_from_zero(least) +
         " there, or use form = \"table\", whose slave can wait between two zones";
}

/// Adds a finding for each segment whose end should be on a whole master unit and is not.
void add_whole(Report& report, const FollowPlan& plan) {
  const auto segments = follow_table(plan).segments;
  const auto odd = std::find_if(segments.begin(), segments.end(),
                                [](const PtPoint& p) { return p.x != std::round(p.x); });
  if (!plan.whole_master || odd == segments.end()) return;
  Finding f;
  f.rule = "follow/whole_master";
  f.quantity = "the master's position";
  f.where = f.value = odd->x;
  f.limit = std::round(odd->x);
  f.margin = -std::abs(f.value - f.limit);
  f.broken = true;
  f.segment = static_cast<std::size_t>(odd - segments.begin());
  f.advice =
      "it is not a whole number: put points and zones on whole numbers, with space between them";
  report.findings.push_back(std::move(f));
}

}  // namespace

SyncCam follow(const FollowPlan& plan) {
  if (plan.form == FollowForm::smooth) return smooth(plan);
  SyncCam made = follow(table_spec(plan));
  made.zones = zones_of(plan);
  return made;
}

Report check(const FollowPlan& plan) {
  Report report;
  if (plan.form == FollowForm::table) {
    report = check(table_spec(plan));
    add_whole(report, plan);
  }
  const auto knots = gear_detail::follow_knots(plan);
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i].zone) continue;
    const FollowGap g = gap(knots[i - 1], knots[i]);
    const Extremum worst = backwards_in(g, plan);
    if (worst.value == 0) continue;
    Finding f;
    f.rule = "follow/backwards";
    f.has_limit = false;
    f.quantity = "geo_velocity";
    f.where = knots[i - 1].master + worst.where;
    f.value = worst.value;
    f.margin =
        -std::abs(worst.value) / std::max({std::abs(g.r0), std::abs(g.r1), std::abs(worst.value)});
    f.broken = true;
    f.advice = travel_advice(g, plan, knots[i - 1].master, knots[i].master);
    report.findings.push_back(std::move(f));
  }
  sort(report);
  return report;
}

std::optional<double> master_period(const FollowPlan& plan) {
  if (!plan.periodic) return std::nullopt;
  return gear_detail::follow_knots(plan).back().master;
}

}  // namespace jounce
