// SPDX-License-Identifier: Apache-2.0
#include "validate/src/drive/drive_report.hpp"

#include <algorithm>
#include <optional>

#include "jounce/validate/loop.hpp"

#include "validate/src/peak_finding.hpp"

namespace jounce::validate_detail {
namespace {

constexpr const char* residual_advice =
    "use a smoother law, or a shaper for the residual frequency";

Finding saturation_of(const DriveResult& result, double limit, bool is_stable) {
  Finding finding = peak_finding("drive/saturation", "torque", result.torque, limit, "");
  finding.broken = !result.saturation.empty();
  if (finding.broken) {
    finding.where = result.saturation.front().from;
    finding.advice = is_stable
                         ? "the drive cannot follow: lower the acceleration or the inertia"
                         : "the loop is unstable: make it stable first, then check the torque";
  }
  return finding;
}

/// The load came to rest too late, or not at all within the standstill.
Finding settling_of(const DriveResult& result, const DriveOptions& options, double end) {
  const double limit = *options.limits.settling_time;
  const double time = result.settling_time.value_or(options.settle);
  Finding finding = peak_finding("drive/settling_time", "settling time", {time, end + time}, limit,
                                 residual_advice);
  if (result.settling_time) return finding;
  finding.broken = true;
  finding.margin = std::min(finding.margin, 0.0);
  finding.advice = residual_advice;
  if (limit > options.settle)
    finding.advice = "simulate a standstill as long as the limit: set settle = " + number(limit);
  return finding;
}

}  // namespace

Report drive_report(const DriveResult& result, const Drive& drive, const DriveOptions& options,
                    double end) {
  const DriveLimits& limits = options.limits;
  Report report;
  const auto check = [&](const char* rule, const char* quantity, const Peak& peak,
                         const std::optional<double>& limit, const char* advice) {
    if (limit) report.findings.push_back(peak_finding(rule, quantity, peak, *limit, advice));
  };
  const auto given = [](double limit) { return limit > 0 ? std::optional(limit) : std::nullopt; };
  const char* gentler = "lower the acceleration or the inertia";
  const char* rest = "lower the acceleration, or lengthen the rest";
  const char* slower = "lower the velocity, or choose another gear ratio";
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
  check("drive/residual", "residual vibration", result.residual, limits.residual, residual_advice);
  if (limits.settling_time && result.integration.ok())
    report.findings.push_back(settling_of(result, options, end));
  const auto unstable = unstable_loop(drive);
  report.findings.push_back(saturation_of(result, drive.motor.torque_limit, !unstable));
  if (!result.integration.ok()) {  // a limit that holds so far may be broken later
    std::erase_if(report.findings, [](const Finding& f) { return !f.broken; });
    report.findings.push_back(integration_finding("drive/integration", "time", result.integration));
  }
  if (unstable) report.findings.push_back(*unstable);
  sort(report);
  return report;
}

}  // namespace jounce::validate_detail
