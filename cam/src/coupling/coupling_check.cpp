// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "jounce/cam/coupling/coupling.hpp"

#include "cam/src/coupling/settle.hpp"

namespace jounce {
namespace {

Finding finding(Rule rule, const char* quantity, double where, double value, bool broken,
                const char* advice) {
  return {.rule = std::move(rule),
          .axis = {},
          .quantity = quantity,
          .where = where,
          .value = value,
          .limit = 0,
          .margin = broken ? -1.0 : 0.0,
          .broken = broken,
          .segment = {},
          .advice = broken ? advice : "",
          .has_limit = false};
}

/// Adds the finding for a master outside the cam: it enters at an end of the cam, where the resting
/// slave would have to move at once.
void add_enter(const Coupling& coupling, const Placement& p, const Jet& x, Report& report) {
  const Cam& cam = coupling.cam();
  const double X = p.at(x[0]);
  if (spot(X, cam.start(), cam.length(), p.periodic).inside) return;
  const bool before = X < cam.start();
  const double end = before ? cam.start() : cam.end();
  const double slope =
      cam.jet(end, before ? Side::right : Side::left)[1] * p.slave_scaling * p.master_scaling;
  report.findings.push_back(finding("coupling/enter", "velocity", end, slope * x[1],
                                    std::abs(slope) > 1e-9 * coupling.reach()[1],
                                    "the slave waits at rest, but the cam moves where the master "
                                    "enters: let the cam begin at rest"));
}

/// Adds the greatest values of the correction: over time with their times, over the master with
/// positions in the direction of travel.
void add_ramp(const Engaged& engaged, const Jet& x, Report& report) {
  const Correction& c = engaged.correction;
  const auto add = [&](const char* quantity, const Extremum& peak, double where) {
    report.findings.push_back(finding("coupling/ramp", quantity, where, peak.value, false, ""));
  };
  if (c.duration() > 0) {
    const Ranges f = extrema(c.profile().curve());
    for (std::size_t k = 0; k < 3; ++k) {
      add(OverTime::names[k], f[k].peak(), f[k].peak().where);
      report.findings.back().where_unit = "s";
    }
  }
  if (c.follows_master()) {
    const Ranges f = segment_extrema(c.curve(), backwards(x) ? 0 : 1);
    for (std::size_t k = 0; k < 3; ++k)
      add(OverMaster::names[k], f[k].peak(), engaged.placement.at(f[k].peak().where));
  }
}

}  // namespace

Report check_ends(const Cam& cam) {
  Report report;
  if (repeats(cam.outside())) return report;
  const double least = 1e-9 * std::abs(extrema(cam, 1).peak().value);
  for (const auto& [where, side] : {std::pair{cam.start(), Side::right}, {cam.end(), Side::left}})
    if (const double slope = cam.jet(where, side)[1]; std::abs(slope) > least)
      report.findings.push_back(finding(side == Side::left ? "coupling/end" : "coupling/begin",
                                        "geo_velocity", where, slope, false, ""));
  return report;
}

Report check(const Coupling& coupling, const MotionState& slave, const Jet& master) {
  Report report;
  const Engagement in = engage(coupling, slave, master, 0);
  const double X = in.engaged.placement.at(master[0]);
  if (!in) {
    report.findings.push_back(finding(std::string("coupling/") + name(in.status), "master", X,
                                      master[0], true, explain(in.status)));
    return report;
  }
  const Jet y = placed(coupling.cam(), in.engaged.placement, master);
  const Jet near = cam_detail::roundings(coupling, slave, y, master);
  const std::array<double, 3> jumps{in.jump.position, in.jump.velocity, in.jump.acceleration};
  for (std::size_t k = 0; k < jumps.size(); ++k)
    report.findings.push_back(finding("coupling/start", OverTime::names[k], X, jumps[k],
                                      std::abs(jumps[k]) > near[k],
                                      "the slave jumps by this step: use start = \"ramp_in\""));
  if (coupling.periodic())
    report.findings.push_back(finding(
        "coupling/period", "position", coupling.cam().end(), coupling.period_jump(),
        std::abs(coupling.period_jump()) > near[0],
        "the slave jumps by this step at the end of each period: use slave_absolute = false"));
  else
    for (Finding& f : check_ends(coupling.cam()).findings)
      if (f.rule == "coupling/end") report.findings.push_back(std::move(f));
  add_enter(coupling, in.engaged.placement, master, report);
  add_ramp(in.engaged, master, report);
  sort(report);
  return report;
}

}  // namespace jounce
