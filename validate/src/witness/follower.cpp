// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/follower.hpp"

#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"

#include "validate/src/peak_finding.hpp"
#include "validate/src/tolerances.hpp"
#include "validate/src/witness/follower_run.hpp"

namespace jounce {
namespace {

void require_valid(const FollowerOptions& options) {
  require_not_negative("settle", options.settle);
  if (!(options.tolerance >= validate_detail::finest_integration && options.tolerance <= 1e-3))
    throw InputError("tolerance", options.tolerance, "must be between 1e-12 and 1e-3");
  if (options.max_steps < 1)
    throw InputError("max_steps", std::to_string(options.max_steps), "must be at least 1");
  const FollowerLimits& limits = options.limits;
  if (limits.least_force) require_not_negative("limits.least_force", *limits.least_force);
  if (limits.greatest_force) require_positive("limits.greatest_force", *limits.greatest_force);
  if (limits.impact_speed) require_positive("limits.impact_speed", *limits.impact_speed);
  if (limits.residual) require_positive("limits.residual", *limits.residual);
}

Finding at_most(const char* rule, const char* quantity, const char* unit, const Peak& peak,
                double limit, const char* advice) {
  Finding finding = validate_detail::peak_finding(rule, quantity, peak, limit, advice);
  finding.unit = unit;
  return finding;
}

/// The margin is a share of the greatest force: a limit of 0 has none.
Finding contact_of(const FollowerResult& result, double limit) {
  Finding finding;
  finding.rule = "follower/contact";
  finding.quantity = "contact force";
  finding.unit = "N";
  finding.where = result.least_force.where;
  finding.value = result.least_force.value;
  finding.limit = limit;
  finding.margin = (finding.value - limit) / result.greatest_force.value;
  finding.broken = !result.flights.empty() || !(finding.value >= limit);
  if (!result.flights.empty()) {
    finding.where = result.flights.front().from;
    finding.advice =
        "the follower leaves the cam: raise the preload, or lower the speed, the mass or the "
        "deceleration of the lift";
  } else if (finding.broken) {
    finding.advice = "raise the preload, or lower the speed";
  }
  return finding;
}

Peak hardest(const std::vector<Flight>& flights) {
  Peak peak;
  for (const Flight& j : flights)
    if (j.impact_speed > peak.value) peak = {j.impact_speed, j.to};
  return peak;
}

Report report_of(const FollowerResult& result, const FollowerLimits& limits) {
  Report report;
  report.findings.push_back(contact_of(result, limits.least_force.value_or(0)));
  if (limits.greatest_force)
    report.findings.push_back(at_most("follower/force", "contact force", "N", result.greatest_force,
                                      *limits.greatest_force,
                                      "lower the preload, the speed, or the peak acceleration"));
  if (limits.impact_speed)
    report.findings.push_back(at_most("follower/impact", "impact speed", "m/s",
                                      hardest(result.flights), *limits.impact_speed,
                                      "keep the follower on the cam"));
  if (limits.residual)
    report.findings.push_back(at_most("follower/residual", "residual vibration", "",
                                      result.residual, *limits.residual,
                                      "use a smoother law, or a polydyne cam"));
  if (!result.integration.ok()) {
    report.findings.push_back(
        validate_detail::integration_finding("follower/integration", "time", result.integration));
    report.findings.back().unit = "s";
  }
  sort(report);
  return report;
}

}  // namespace

void require_valid(const SpringFollower& f) {
  require_positive("mass", f.mass);
  require_positive("linkage_stiffness", f.linkage_stiffness);
  require_not_negative("linkage_damping", f.linkage_damping);
  require_not_negative("spring_stiffness", f.spring_stiffness);
  require_not_negative("spring_damping", f.spring_damping);
  require_not_negative("preload", f.preload);
  require_positive("meters_per_unit", f.meters_per_unit);
  if (f.preload == 0 && f.spring_stiffness == 0)
    throw InputError("preload", f.preload,
                     "must be greater than 0, because no spring_stiffness presses on the cam");
}

FollowerResult follow(const SignalView& lift, const SpringFollower& follower,
                      const FollowerOptions& options) {
  require_valid(follower);
  require_valid(options);
  if (lift.over_master())
    throw InputError("axis", "master", "must be time: a follower follows a lift over time");
  FollowerResult result = validate_detail::run(lift, follower, options);
  result.report = report_of(result, options.limits);
  return result;
}

}  // namespace jounce
