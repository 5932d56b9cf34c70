// SPDX-License-Identifier: Apache-2.0
// The rules of identify().

#include "validate/src/identify/identify_rules.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "jounce/profiles/error.hpp"

#include "validate/src/tolerances.hpp"

namespace jounce::validate_detail {
namespace {

void require_column(const char* key, const std::vector<double>& values, std::size_t samples) {
  if (values.size() != samples)
    throw InputError(key, std::to_string(values.size()) + " samples",
                     "must be as many as those of time, " + std::to_string(samples));
  for (const double value : values) require_finite(key, value);
}

bool of_friction(const std::string& key) {
  return key.find("friction.") != key.npos;
}

/// True for a number that is chosen, not measured: no recording shows its true value.
bool is_setting(const std::string& key) {
  return key.starts_with("controller.") || key == "position_per_rev";
}

void require_can_fit(const Drive& drive, const DriveNumber& number) {
  if (is_setting(number.key))
    throw InputError("fit", number.key, "is a setting: fit numbers of the machine");
  if (*number.value == 0)
    throw InputError(number.key, 0,
                     "cannot be fitted from 0: add a rough value to the spec, in " + number.unit);
  if (of_friction(number.key) && drive.controller.friction_feed_forward != 0)
    throw InputError("controller.friction_feed_forward", drive.controller.friction_feed_forward,
                     "must be 0 where friction is fitted: record the run without it");
}

}  // namespace

const std::vector<double>& recorded(const Recording& recording, std::size_t output) {
  const std::array all{&recording.position, &recording.velocity, &recording.torque,
                       &recording.load};
  return *all[output];
}

void require_times(const Recording& recording) {
  const std::vector<double>& t = recording.time;
  if (t.size() < 4)
    throw InputError("time", std::to_string(t.size()) + " samples", "must be at least four");
  require_column("time", t, t.size());
  require_column("command", recording.command, t.size());
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1]))
      throw InputError("time[" + std::to_string(i + 1) + "]", t[i],
                       "must be greater than " + number(t[i - 1]) + ", the previous sample");
}

namespace {

void require_setpoints(const std::vector<RecordedSetpoint>& all, const std::vector<double>& times) {
  if (all.size() < 2)
    throw InputError("setpoints", std::to_string(all.size()), "must be at least two");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [time, position, velocity, acceleration] = all[i];
    const std::string key = "setpoints[" + std::to_string(i + 1) + "]";
    for (const double value : {time, position, velocity, acceleration})
      require_finite(key.c_str(), value);
    if (i > 0 && !(time > all[i - 1].time))
      throw InputError(key, time, "must be later than " + number(all[i - 1].time) + " s");
  }
  if (all.front().velocity != 0 || all.front().acceleration != 0)
    throw InputError("setpoints[1].velocity", all.front().velocity,
                     "must be 0, with acceleration 0: the recording must begin at standstill");
  if (times.front() < all.front().time || times.back() > all.back().time)
    throw InputError("time", times.front(), "must be between the first and the last setpoint");
}

}  // namespace

void require_valid(const Recording& recording) {
  require_times(recording);
  if (!recording.setpoints.empty()) require_setpoints(recording.setpoints, recording.time);
  bool any = false;
  for (std::size_t k = 0; k < outputs; ++k) {
    const std::vector<double>& values = recorded(recording, k);
    if (values.empty()) continue;
    require_column(quantities[k], values, recording.time.size());
    any = true;
  }
  if (!any)
    throw InputError("position", "", "is missing: a fit needs position, velocity, torque or load");
}

DriveNumber numbered(Drive& drive, const std::string& key) {
  std::string all;
  for (const DriveNumber& number : numbers(drive)) {
    if (number.key == key) return number;
    if (!is_setting(number.key)) all += (all.empty() ? "" : ", ") + number.key;
  }
  throw InputError("fit", key, "names no number of this drive; possible numbers: " + all);
}

void require_valid(const IdentifySpec& spec) {
  jounce::require_valid(spec.drive);
  if (spec.fit.empty()) throw InputError("fit", "", "must name at least one number");
  if (spec.max_iterations < 1)
    throw InputError("max_iterations", std::to_string(spec.max_iterations), "must be at least 1");
  if (!(spec.tolerance >= validate_detail::finest_integration && spec.tolerance <= 1e-3))
    throw InputError("tolerance", spec.tolerance, "must be between 1e-12 and 1e-3");
  Drive copy = spec.drive;
  for (std::size_t i = 0; i < spec.fit.size(); ++i) {
    require_can_fit(spec.drive, numbered(copy, spec.fit[i]));
    if (std::find(spec.fit.begin(), spec.fit.begin() + static_cast<std::ptrdiff_t>(i),
                  spec.fit[i]) != spec.fit.begin() + static_cast<std::ptrdiff_t>(i))
      throw InputError("fit", spec.fit[i], "is named twice");
  }
}

}  // namespace jounce::validate_detail
