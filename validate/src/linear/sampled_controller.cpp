// SPDX-License-Identifier: Apache-2.0
#include "validate/src/linear/sampled_controller.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jounce::validate_detail {

SampledController::SampledController(DriveModel& model)
    : model_(model),
      cycle_(model.drive().controller.cycle),
      delay_(model.drive().controller.delay),
      count_(model.drive().controller.encoder_counts > 0
                 ? 2 * std::numbers::pi / model.drive().controller.encoder_counts
                 : 0) {
  due_.reserve(static_cast<std::size_t>(std::min(delay_ / cycle_, 1e6)) + 2);
}

double SampledController::next() const {
  const double sample = samples_ * cycle_;
  return due_.empty() ? sample : std::min(sample, due_.front().time);
}

void SampledController::act(double t, double slack, const Jet& r, std::span<double> y) {
  if (samples_ * cycle_ <= t + slack) read(r, y);
  while (!due_.empty() && due_.front().time <= t + slack) {
    model_.hold(due_.front().torque);
    model_.mode().torque = due_.front().limited;
    due_.erase(due_.begin());
  }
}

void SampledController::read(const Jet& r, std::span<double> y) {
  const Controller& c = model_.drive().controller;
  const double reference = model_.radians_per_unit() * r[0];
  const double exact = reference + y[0];
  const double angle = count_ > 0 ? std::round(exact / count_) * count_ : exact;
  const double speed = samples_ > 0 ? (angle - angle_) / cycle_ : 0;
  angle_ = angle;
  model_.mode().feed = (r[1] > 0) - (r[1] < 0);
  const double w_r = model_.radians_per_unit() * r[1];
  const double e = model_.velocity_error(r, angle - reference, speed - w_r);
  double& z = y[model_.integral()];
  const double asked = model_.asked(r, e, z);
  const double w = model_.motor_speed(r, y.data());
  const double given = std::clamp(asked, model_.limit(-1, w), model_.limit(1, w));
  if (c.integral_time > 0) z += cycle_ * (c.velocity_gain * e + given - asked) / c.integral_time;
  due_.push_back({samples_ * cycle_ + delay_, given, (asked > given) - (asked < given)});
  samples_ += 1;
}

}  // namespace jounce::validate_detail
