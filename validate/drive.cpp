#include "jounce/validate/drive.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/detail/drive_report.hpp"
#include "jounce/validate/detail/drive_run.hpp"
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

}  // namespace

void require_valid(const DriveOptions& options, const Drive& drive) {
  require_options(options);
  if (options.limits.current && drive.motor.torque_constant == 0)
    throw InputError("limits.current", *options.limits.current, "needs motor.torque_constant");
}

void detail::require_within(const DriveOptions& options, double start, double end) {
  for (const Interval& sync : options.sync)
    if (!(sync.from >= start && sync.to <= end))
      throw InputError("sync.to", sync.to,
                       "must lie within the motion, from " + number(start) + " to " + number(end) +
                           " s, as must from");
}

DriveResult drive_through(const SignalView& reference, const Drive& drive,
                          const DriveOptions& options) {
  require_valid(drive);
  require_valid(options, drive);
  if (reference.over_master())
    throw InputError("axis", "master", "a drive follows a motion over time");
  detail::require_within(options, reference.start(), reference.end());
  DriveResult result = detail::run(reference, drive, options);
  result.report = detail::drive_report(result, drive, options, reference.end());
  if (const auto exact = exact_opinion(reference, drive, result, options.tolerance)) {
    result.report.findings.push_back(*exact);
    sort(result.report);
  }
  return result;
}

}  // namespace jounce
