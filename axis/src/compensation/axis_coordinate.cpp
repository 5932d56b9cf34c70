// SPDX-License-Identifier: Apache-2.0
#include "axis/src/compensation/axis_coordinate.hpp"

#include <cassert>
#include <cmath>

namespace jounce {

AxisCoordinate::AxisCoordinate(const AxisConfig& config) {
  if (config.compensation) compensation_.emplace(*config.compensation, config.modulo);
}

double AxisCoordinate::actual(double drive, bool disabled) noexcept {
  const double place = drive + offset_;
  in_feedback_ = correction_[0];
  if (compensation_ && disabled && std::isfinite(place))
    in_feedback_ = place - compensation_->position_of(place);
  return place - in_feedback_;
}

void AxisCoordinate::remember(double dt, double position, double velocity,
                              const Feedback& feedback) noexcept {
  commanded_.add(dt, position, velocity);
  actual_.add(dt, feedback.position + from_drive(), feedback.velocity);
}

void AxisCoordinate::move_by(double by) noexcept {
  offset_ += by;
  rename(by);
}

std::optional<Refusal> AxisCoordinate::against_switch(bool on, bool homed) const noexcept {
  if (compensates() == on)
    return Refusal{on ? Cause::compensation_active : Cause::compensation_inactive};
  if (on && !homed) return Refusal{Cause::not_homed};
  return std::nullopt;
}

double AxisCoordinate::switch_compensation(bool on, double position) noexcept {
  const double output = position + in_feedback_;
  compensation_->set(on);
  const double there = compensation_->position_of(output);
  rename(there - position);
  correction_ = {output - there, 0, 0, 0};
  return there - position;
}

const Jet& AxisCoordinate::compensate(const References& references) noexcept {
  assert(compensation_);
  compensation_->see(references);
  correction_ = compensation_->correction();
  return correction_;
}

void AxisCoordinate::rename(double by) noexcept {
  commanded_.shift(by);
  actual_.shift(by);
}

}  // namespace jounce
