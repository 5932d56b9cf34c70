#include "jounce/validate/drive.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/detail/drive_run.hpp"

namespace jounce {
namespace {

void require_valid(const DriveOptions& options) {
  require_not_negative("settle", options.settle);
  if (!(options.tolerance >= 1e-12 && options.tolerance <= 1e-3))
    throw InputError("tolerance", options.tolerance, "must be between 1e-12 and 1e-3");
  if (options.max_steps < 1)
    throw InputError("max_steps", std::to_string(options.max_steps), "must be at least 1");
  const DriveLimits& limits = options.limits;
  if (limits.torque) require_positive("limits.torque", *limits.torque);
  if (limits.rms_torque) require_positive("limits.rms_torque", *limits.rms_torque);
  if (limits.following_error) require_positive("limits.following_error", *limits.following_error);
  if (limits.residual) require_positive("limits.residual", *limits.residual);
}

Finding finding_of(const char* rule, const char* quantity, const Peak& peak, double limit,
                   const char* advice) {
  Finding finding;
  finding.rule = rule;
  finding.quantity = quantity;
  finding.where = peak.where;
  finding.value = peak.value;
  finding.limit = std::copysign(limit, peak.value);
  finding.margin = (limit - std::abs(peak.value)) / limit;
  finding.broken = !(std::abs(peak.value) <= limit);
  if (finding.broken) finding.advice = advice;
  return finding;
}

Finding saturation_of(const DriveResult& result, double limit) {
  Finding finding = finding_of("drive/saturation", "torque", result.torque, limit, "");
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

Report report_of(const DriveResult& result, const Drive& drive, const DriveOptions& options) {
  const DriveLimits& limits = options.limits;
  Report report;
  const auto check = [&](const char* rule, const char* quantity, const Peak& peak,
                         const std::optional<double>& limit, const char* advice) {
    if (limit) report.findings.push_back(finding_of(rule, quantity, peak, *limit, advice));
  };
  check("drive/torque", "torque", result.torque, limits.torque,
        "lower the acceleration or the inertia");
  check("drive/rms_torque", "rms torque", {result.rms_torque, 0}, limits.rms_torque,
        "lower the acceleration, or let the axis rest longer");
  check("drive/following_error", "following error", result.following_error, limits.following_error,
        "raise the feed-forward or the gains, or lower the jerk");
  check("drive/residual", "residual vibration", result.residual, limits.residual,
        "take a smoother law, or a shaper for the residual frequency");
  report.findings.push_back(saturation_of(result, drive.motor.torque_limit));
  if (!result.integration.ok()) report.findings.push_back(integration_of(result.integration));
  sort(report);
  return report;
}

}  // namespace

DriveResult drive_through(const SignalView& reference, const Drive& drive,
                          const DriveOptions& options) {
  require_valid(drive);
  if (drive.train.size() != 1 || drive.train[0].stiffness == 0 || drive.pendulum)
    throw InputError("mass", std::to_string(drive.train.size()) + " of them",
                     "must be one elastic mass");
  require_valid(options);
  if (reference.over_master())
    throw InputError("axis", "master", "a drive follows a motion over time");
  DriveResult result = detail::run(reference, drive, options);
  result.report = report_of(result, drive, options);
  return result;
}

}  // namespace jounce
