// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"

#include "validate/src/drive/bodies.hpp"
#include "validate/src/drive/drive_report.hpp"
#include "validate/src/drive/drive_run.hpp"
#include "validate/src/linear/course.hpp"
#include "validate/src/linear/periodic.hpp"
#include "validate/src/tolerances.hpp"

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

constexpr std::array<Limit, 3> of_standstill{{
    {"residual", &DriveLimits::residual},
    {"settling_band", &DriveLimits::settling_band},
    {"settling_time", &DriveLimits::settling_time},
}};

void require_options(const DriveOptions& options) {
  require_not_negative("settle", options.settle);
  if (!(options.tolerance >= validate_detail::finest_integration && options.tolerance <= 1e-3))
    throw InputError("tolerance", options.tolerance, "must be between 1e-12 and 1e-3");
  if (options.max_steps < 1)
    throw InputError("max_steps", std::to_string(options.max_steps), "must be at least 1");
  for (const Limit& limit : every_limit)
    if (const auto& value = options.limits.*limit.value)
      require_positive((std::string("limits.") + limit.key).c_str(), *value);
  if (options.limits.settling_time && !options.limits.settling_band)
    throw InputError("limits.settling_time", *options.limits.settling_time,
                     "needs settling_band: add it, or leave settling_time out");
  if (options.periodic)
    for (const Limit& limit : of_standstill)
      if (const auto& value = options.limits.*limit.value)
        throw InputError(std::string("limits.") + limit.key, *value,
                         "needs a standstill after the motion, which a periodic motion does not "
                         "have: leave it out");
  for (const Interval& sync : options.sync)
    if (!(sync.from < sync.to))
      throw InputError("sync.to", sync.to, "must be greater than from = " + number(sync.from));
}

}  // namespace

void require_valid(const DriveOptions& options, const Drive& drive) {
  require_options(options);
  if (options.limits.current && drive.motor.torque_constant == 0)
    throw InputError("limits.current", *options.limits.current,
                     "needs motor.torque_constant: add it, or leave this limit out");
}

void validate_detail::require_within(const DriveOptions& options, double start, double end) {
  for (const Interval& sync : options.sync)
    if (!(sync.from >= start && sync.to <= end))
      throw InputError("sync.to", sync.to,
                       "is the end of an interval from " + number(sync.from) +
                           " s, which must lie within the motion, " + number(start) + " to " +
                           number(end) + " s");
}

namespace {

/// The distance between the state at the end of the period and that at its beginning.
Finding periodic_of(const SignalView& period, const Drive& drive, const std::vector<double>& start,
                    const std::vector<double>& end, double tolerance) {
  const std::size_t angles = 2 * validate_detail::bodies(drive).size();
  double most = 0;
  for (std::size_t i = 0; i < angles; i += 2) most = std::max(most, std::abs(end[i] - start[i]));
  const double stroke = validate_detail::scales(validate_detail::pieces(period)).range;
  Finding finding;
  finding.rule = "drive/periodic";
  finding.quantity = "disagreement";
  finding.unit = "of the range";
  finding.where = period.end();
  finding.value =
      most * drive.position_per_rev / (2 * std::numbers::pi) / validate_detail::usable(stroke);
  finding.limit = 100 * tolerance;
  finding.margin = (finding.limit - finding.value) / finding.limit;
  finding.broken = !(finding.value <= finding.limit);
  if (finding.broken)
    finding.advice =
        "a period does not end in the state of its start: with torque at its limit, there is no "
        "such steady state";
  return finding;
}

/// The run of one period of the steady state, with its own finding.
DriveResult run_periodic(const SignalView& period, const Drive& drive, DriveOptions options) {
  const std::optional<Trajectory> segments = period.trajectory();
  if (!segments)
    throw InputError("periodic", "true",
                     "needs a motion of segments: a cam with a master at constant velocity");
  options.settle = 0;
  const std::vector<double> start = validate_detail::periodic_model_start(*segments, drive);
  validate_detail::DriveRun run = validate_detail::run(period, drive, options, start);
  run.result.report = validate_detail::drive_report(run.result, drive, options, period.end());
  if (run.result.integration.ok())
    run.result.report.findings.push_back(
        periodic_of(period, drive, start, run.state, options.tolerance));
  return std::move(run.result);
}

DriveResult run_once(const SignalView& reference, const Drive& drive, const DriveOptions& options) {
  DriveResult result = validate_detail::run(reference, drive, options).result;
  result.report = validate_detail::drive_report(result, drive, options, reference.end());
  return result;
}

}  // namespace

DriveResult drive_through(const SignalView& reference, const Drive& drive,
                          const DriveOptions& options) {
  require_valid(drive);
  require_valid(options, drive);
  if (reference.over_master())
    throw InputError("axis", "master", "must be time: a drive follows a motion over time");
  validate_detail::require_within(options, reference.start(), reference.end());
  if (options.periodic) {
    validate_detail::require_steady(drive);
    if (auto unstable = validate_detail::without_steady_state(drive, reference.start()))
      return *unstable;
  }
  DriveResult result = options.periodic ? run_periodic(reference, drive, options)
                                        : run_once(reference, drive, options);
  if (const auto exact =
          exact_opinion(reference, drive, result, options.tolerance, options.periodic))
    result.report.findings.push_back(*exact);
  sort(result.report);
  return result;
}

}  // namespace jounce
