// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/axis_config.hpp"

#include <string>

#include "jounce/axis/inputs.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/src/homing/homing.hpp"

namespace jounce {
namespace {

double required(const char* key, const std::optional<double>& limit) {
  if (!limit) throw InputError(key, "", "is missing: an axis needs this limit in [limits]");
  return *limit;
}

double stop_limit(const char* key, double value, double limit) {
  if (value == 0) return 2 * limit;
  require_finite(key, value);
  // A table may use its full limit; a stop with hardly more would never end.
  if (value >= 1.1 * limit * (1 - profiles_detail::rounded_input)) return value;
  throw InputError(key, value,
                   "must be at least " + six_digits_up(1.1 * limit) +
                       ", which is 1.1 times limits." +
                       std::string(key).substr(std::string_view("stop_").size()));
}

void not_negative(const char* key, double value) {
  require_finite(key, value);
  if (value < 0) throw InputError(key, value, "must not be negative");
}

HomingSpec resolved(HomingSpec homing, const Limits& limits) {
  if (!homing_method(homing.method))
    throw InputError("homing.method", std::to_string(homing.method),
                     "must be 1 to 14, 17 to 30, 33, 34, 35 or 37 (CiA 402, object 6098h)");
  const auto within = [](const char* key, double& value, double otherwise, double limit) {
    if (value == 0) value = otherwise;
    require_finite(key, value);
    if (!(value > 0)) throw InputError(key, value, "must be greater than 0");
    if (value > limit)
      throw InputError(key, value, "must be at most the limit of the axis, " + number(limit));
  };
  within("homing.search_velocity", homing.search_velocity, *limits.velocity / 10, *limits.velocity);
  within("homing.index_velocity", homing.index_velocity, homing.search_velocity / 4,
         *limits.velocity);
  within("homing.acceleration", homing.acceleration, *limits.acceleration, *limits.acceleration);
  require_finite("homing.offset", homing.offset);
  require_finite("homing.timeout", homing.timeout);
  if (!(homing.timeout > 0))
    throw InputError("homing.timeout", homing.timeout, "must be greater than 0");
  if (homing.distance) require_positive("homing.distance", *homing.distance);
  return homing;
}

}  // namespace

AxisConfig resolved(AxisConfig config) {
  if (config.period <= 0)
    throw InputError("period", std::to_string(config.period), "must be greater than 0 ns");
  if (config.longest_gap < 1)
    throw InputError("longest_gap", std::to_string(config.longest_gap), "must be at least 1 tick");
  require_valid(config.limits);
  require_finite("position", config.position);
  if (const auto& least = config.limits.position_min; least && config.position < *least)
    throw InputError("position", config.position,
                     "must be at least position_min, " + number(*least));
  if (const auto& most = config.limits.position_max; most && config.position > *most)
    throw InputError("position", config.position, "must be at most position_max, " + number(*most));
  required("limits.velocity", config.limits.velocity);
  config.stop_acceleration =
      stop_limit("stop_acceleration", config.stop_acceleration,
                 required("limits.acceleration", config.limits.acceleration));
  if (config.limits.jerk)
    config.stop_jerk = stop_limit("stop_jerk", config.stop_jerk, *config.limits.jerk);
  for (const auto& [key, value] : {std::pair{"abort_acceleration", config.abort_acceleration},
                                   {"limit_acceleration", config.limit_acceleration},
                                   {"modulo", config.modulo},
                                   {"following_error", config.following_error},
                                   {"following_time", config.following_time},
                                   {"in_position", config.in_position},
                                   {"in_position_time", config.in_position_time}})
    not_negative(key, value);
  config.homing = resolved(config.homing, config.limits);
  if (config.registration) {
    const int input = config.registration->input;
    if (input < 1 || input > Triggers::most_inputs)
      throw InputError("registration.input", std::to_string(input), "must be 1 to 4");
    try {
      config.registration = LiveRegistration(*config.registration).spec();
    } catch (const InputError& error) {
      throw InputError("registration." + error.key(), error.value(), error.rule());
    }
  }
  if (config.compensation) {
    try {
      (void)LiveCompensation(*config.compensation, config.modulo);
    } catch (const InputError& error) {
      throw InputError("compensation." + error.key(), error.value(), error.rule());
    }
  }
  if (config.limit_acceleration == 0) config.limit_acceleration = config.stop_acceleration;
  return config;
}

}  // namespace jounce
