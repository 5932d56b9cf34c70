// SPDX-License-Identifier: Apache-2.0
#include "spec/src/toml/motion_fields.hpp"

#include "jounce/base/units.hpp"

namespace jounce::spec_detail {

std::string MotionFields::unit(int order) const {
  return rate_unit(units_->position, units_->x, order);
}

void MotionFields::need(const char* key, int order, double& value) {
  value = reader_->number(key, unit(order));
}

void MotionFields::need_positive(const char* key, int order, double& value) {
  const auto given = reader_->optional_positive(key, unit(order));
  value = given ? *given : reader_->number(key, unit(order));
}

void MotionFields::may(const char* key, int order, double& value) {
  value = optional(key, order).value_or(value);
}

void MotionFields::may_positive(const char* key, int order, double& value) {
  value = reader_->optional_positive(key, unit(order)).value_or(value);
}

std::optional<double> MotionFields::optional(const char* key, int order) {
  return reader_->optional_number(key, unit(order));
}

std::optional<double> MotionFields::optional_time(const char* key) {
  return reader_->optional_number(key, units_->x);
}

void MotionFields::may_in(const char* key, const char* unit, double& value) {
  value = reader_->optional_number(key, unit).value_or(value);
}

MotionState MotionFields::state(const std::string& prefix) {
  MotionState state;
  may(prefix.c_str(), 0, state.position);
  may((prefix + "_velocity").c_str(), 1, state.velocity);
  may((prefix + "_acceleration").c_str(), 2, state.acceleration);
  return state;
}

void MotionFields::bound(const std::string& key, int order, double& least, double& greatest) {
  const std::string down = key + "_down";
  for (const std::string& each : {key, down}) {
    const auto value = reader_->optional_positive(each.c_str(), unit(order));
    if (!value) continue;
    if (each == key) greatest = *value;
    least = -*value;
  }
}

Bounds MotionFields::bounds() {
  Bounds b;
  bound("velocity", 1, b.velocity_min, b.velocity_max);
  bound("acceleration", 2, b.acceleration_min, b.acceleration_max);
  bound("jerk", 3, b.jerk_min, b.jerk_max);
  may("position_min", 0, b.position_min);
  may("position_max", 0, b.position_max);
  if (!(b.position_min < b.position_max))
    reader_->fail("position_min", number(b.position_min),
                  "must be below position_max = " + number(b.position_max));
  return b;
}

}  // namespace jounce::spec_detail
