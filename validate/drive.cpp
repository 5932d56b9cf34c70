#include "jounce/validate/drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/detail/drive_run.hpp"
#include "jounce/validate/detail/peak_finding.hpp"
#include "jounce/validate/linear_drive.hpp"

namespace jounce {
namespace {

struct Limit {
  const char* key;
  std::optional<double> DriveLimits::*value;
};

constexpr std::array<Limit, 10> every_limit{{
    {"torque", &DriveLimits::torque},
    {"rms_torque", &DriveLimits::rms_torque},
    {"current", &DriveLimits::current},
    {"velocity", &DriveLimits::velocity},
    {"following_error", &DriveLimits::following_error},
    {"end_following_error", &DriveLimits::end_following_error},
    {"sync_following_error", &DriveLimits::sync_following_error},
    {"residual", &DriveLimits::residual},
    {"settling_band", &DriveLimits::settling_band},
    {"settling_time", &DriveLimits::settling_time},
}};

void require_options(const DriveOptions& options) {
  require_not_negative("settle", options.settle);
  if (!(options.tolerance >= 1e-12 && options.tolerance <= 1e-3))
    throw InputError("tolerance", options.tolerance, "must be between 1e-12 and 1e-3");
  if (options.max_steps < 1)
    throw InputError("max_steps", std::to_string(options.max_steps), "must be at least 1");
  for (const Limit& limit : every_limit)
    if (const auto& value = options.limits.*limit.value)
      require_positive((std::string("limits.") + limit.key).c_str(), *value);
  if (options.limits.settling_time && !options.limits.settling_band)
    throw InputError("limits.settling_time", *options.limits.settling_time,
                     "needs a settling_band");
  for (const Interval& sync : options.sync)
    if (!(sync.from < sync.to))
      throw InputError("sync.to", sync.to, "must be greater than from = " + number(sync.from));
}

Finding saturation_of(const DriveResult& result, double limit) {
  Finding finding = detail::peak_finding("drive/saturation", "torque", result.torque, limit, "");
  finding.broken = !result.saturation.empty();
  if (finding.broken) {
    finding.where = result.saturation.front().from;
    finding.advice = "the drive cannot follow: lower the acceleration or the inertia";
  }
  return finding;
}

Finding integration_of(const Integration& integration) {
  Finding finding;
  finding.rule = "drive/integration";
  finding.quantity = "time";
  finding.where = finding.value = integration.reached;
  finding.broken = true;
  finding.advice = integration.reason;
  return finding;
}

/// The load came to rest too late, or not at all within the standstill.
Finding settling_of(const DriveResult& result, const DriveOptions& options, double end) {
  const double limit = *options.limits.settling_time;
  const double time = result.settling_time.value_or(options.settle);
  Finding finding =
      detail::peak_finding("drive/settling_time", "settling time", {time, end + time}, limit,
                           "take a smoother law, or a shaper for the residual frequency");
  if (result.settling_time) return finding;
  finding.broken = true;
  finding.margin = std::min(finding.margin, 0.0);
  finding.advice = "it did not settle within the standstill that was watched";
  return finding;
}

Report report_of(const DriveResult& result, const Drive& drive, const DriveOptions& options,
                 double end) {
  const DriveLimits& limits = options.limits;
  Report report;
  const auto check = [&](const char* rule, const char* quantity, const Peak& peak,
                         const std::optional<double>& limit, const char* advice) {
    if (limit)
      report.findings.push_back(detail::peak_finding(rule, quantity, peak, *limit, advice));
  };
  const auto given = [](double limit) { return limit > 0 ? std::optional(limit) : std::nullopt; };
  const char* gentler = "lower the acceleration or the inertia";
  const char* rest = "lower the acceleration, or let the axis rest longer";
  const char* slower = "lower the velocity, or choose another ratio of gear";
  const char* follow = "raise the feed-forward or the gains, or lower the jerk";
  check("drive/torque", "torque", result.torque, limits.torque, gentler);
  check("drive/rms_torque", "rms torque", {result.rms_torque, 0}, limits.rms_torque, rest);
  check("drive/rated_torque", "rms torque", {result.rms_torque, 0}, given(drive.motor.rated_torque),
        rest);
  if (drive.motor.thermal_time > 0) check("drive/i2t", "I2t", result.i2t, 1, rest);
  check("drive/current", "current", result.current, limits.current, gentler);
  check("drive/velocity", "motor velocity", result.velocity, limits.velocity, slower);
  check("drive/max_velocity", "motor velocity", result.velocity, given(drive.motor.max_velocity),
        slower);
  check("drive/following_error", "following error", result.following_error, limits.following_error,
        follow);
  check("drive/end_following_error", "following error at the end",
        {result.end_following_error, end}, limits.end_following_error, follow);
  check("drive/sync_following_error", "following error in sync", result.sync_following_error,
        limits.sync_following_error, follow);
  check("drive/residual", "residual vibration", result.residual, limits.residual,
        "take a smoother law, or a shaper for the residual frequency");
  if (limits.settling_time && result.integration.ok())
    report.findings.push_back(settling_of(result, options, end));
  report.findings.push_back(saturation_of(result, drive.motor.torque_limit));
  if (!result.integration.ok()) {  // what was not exceeded by then may have been later
    std::erase_if(report.findings, [](const Finding& f) { return !f.broken; });
    report.findings.push_back(integration_of(result.integration));
  }
  sort(report);
  return report;
}

}  // namespace

void require_valid(const DriveOptions& options, const Drive& drive) {
  require_options(options);
  if (options.limits.current && drive.motor.torque_constant == 0)
    throw InputError("limits.current", *options.limits.current, "needs motor.torque_constant");
}

DriveResult drive_through(const SignalView& reference, const Drive& drive,
                          const DriveOptions& options) {
  require_valid(drive);
  require_valid(options, drive);
  if (reference.over_master())
    throw InputError("axis", "master", "a drive follows a motion over time");
  for (const Interval& sync : options.sync)
    if (!(sync.from >= reference.start() && sync.to <= reference.end()))
      throw InputError("sync.to", sync.to,
                       "must lie within the motion, from " + number(reference.start()) + " to " +
                           number(reference.end()) + " s, as must from");
  DriveResult result = detail::run(reference, drive, options);
  result.report = report_of(result, drive, options, reference.end());
  if (const auto exact = exact_opinion(reference, drive, result, options.tolerance)) {
    result.report.findings.push_back(*exact);
    sort(result.report);
  }
  return result;
}

}  // namespace jounce
