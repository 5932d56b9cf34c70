// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/drive_stepper.hpp"

#include <cassert>
#include <numbers>
#include <variant>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"

#include "validate/src/linear/continuous_stepper.hpp"
#include "validate/src/linear/sampled_stepper.hpp"

namespace jounce {
namespace {

using validate_detail::ContinuousStepper;
using validate_detail::SampledStepper;
using AnyStepper = std::variant<ContinuousStepper, SampledStepper>;

AnyStepper stepper_of(const Drive& drive, double period) {
  require_valid(drive);
  require_positive("period", period);
  const auto key = nonlinearity(drive);
  // An encoder is read at instants. Between them the drive is linear.
  if (key && !(drive.controller.cycle > 0 && *key == "controller.encoder_counts"))
    throw InputError(*key, "not 0",
                     "makes the drive nonlinear: it cannot be simulated in an axis's cycle");
  if (drive.controller.cycle > 0) return SampledStepper(drive, period);
  return ContinuousStepper(drive, period);
}

}  // namespace

struct DriveStepper::Model {
  AnyStepper stepper;
};

DriveStepper::DriveStepper(const Drive& drive, double period)
    : model_(std::make_unique<Model>(Model{stepper_of(drive, period)})),
      period_(period),
      unit_(drive.position_per_rev / (2 * std::numbers::pi)) {
  rest(0);
}

DriveStepper::~DriveStepper() = default;
DriveStepper::DriveStepper(DriveStepper&&) noexcept = default;
DriveStepper& DriveStepper::operator=(DriveStepper&&) noexcept = default;

void DriveStepper::rest(double position) noexcept {
  reference_ = {position, 0, 0, 0};
  periods_ = 0;
  now_ = {};
  if (auto* sampled = std::get_if<SampledStepper>(&model_->stepper)) {
    sampled->rest(position);
    now_ = sampled->sample(unit_);
  } else {
    auto& continuous = std::get<ContinuousStepper>(model_->stepper);
    continuous.rest();
    now_ = continuous.sample(unit_);
  }
  now_.following_error = -now_.motor;
  now_.reference = position;
  now_.motor += position;
  now_.load += position;
}

void DriveStepper::rename(double by) noexcept {
  reference_[0] += by;
  now_.reference += by;
  now_.motor += by;
  now_.load += by;
}

const DriveSample& DriveStepper::step(const Jet& to, int periods) noexcept {
  assert(periods >= 1 && periods <= 1000);
  const validate_detail::SteppedReference reference(reference_, to, periods * period_);
  periods_ += periods;
  reference_ = to;
  double behind = 0;  // zeros of the motor and of the load, u
  if (auto* sampled = std::get_if<SampledStepper>(&model_->stepper)) {
    sampled->step(reference, periods);
    now_ = sampled->sample(unit_);
    behind = sampled->moved();
  } else {
    auto& continuous = std::get<ContinuousStepper>(model_->stepper);
    continuous.step(reference, periods);
    now_ = continuous.sample(unit_);
  }
  now_.time = static_cast<double>(periods_) * period_;
  now_.following_error = behind - now_.motor;
  now_.reference = to[0];
  now_.motor += to[0] - behind;
  now_.load += to[0] - behind;
  return now_;
}

}  // namespace jounce
