// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/axis.hpp"

#include "axis/src/state/axis_impl.hpp"

namespace jounce {

MotionAxis::MotionAxis(const AxisConfig& config, const AxisSwitches& switches,
                       const AxisCompare& compare)
    : impl_(std::make_unique<Impl>(config, switches, compare)) {}

MotionAxis::~MotionAxis() = default;
MotionAxis::MotionAxis(MotionAxis&& other) noexcept = default;
MotionAxis& MotionAxis::operator=(MotionAxis&& other) noexcept = default;

Tick MotionAxis::step(std::int64_t tick, const Command& command, const Inputs& inputs) {
  return impl_->step(tick, command, inputs);
}

Jet MotionAxis::compensate(const References& references) {
  return impl_->compensate(references);
}

const AxisConfig& MotionAxis::config() const {
  return impl_->config();
}

State MotionAxis::state() const {
  return impl_->state();
}

std::span<const Jet> MotionAxis::parts() const {
  return impl_->parts();
}

std::span<const Jet> MotionAxis::places() const {
  return impl_->places();
}

}  // namespace jounce
