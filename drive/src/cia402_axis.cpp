// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/cia402_axis.hpp"

#include <cmath>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

double window_of(const Cia402Config& config) {
  require_finite("window", config.window);
  if (config.window < 0) throw InputError("window", config.window, "must not be negative");
  return config.window > 0 ? config.window : config.position_per_rev / 100;
}

}  // namespace

Cia402Axis::Cia402Axis(const Cia402Config& config)
    : increments_(config.increments_per_rev, config.position_per_rev, config.reversed),
      window_(window_of(config)) {}

Feedback Cia402Axis::feedback(const Cia402Inputs& inputs) noexcept {
  const Cia402Status status = status_of(inputs.statusword).value_or(Cia402Status{});
  actual_ = seen_ ? Increments::unwrapped(inputs.position_actual, actual_)
                  : std::int64_t{inputs.position_actual};
  seen_ = true;
  return {
      .position = increments_.position(static_cast<double>(actual_)),
      .velocity = increments_.position(inputs.velocity_actual),
      .torque = inputs.torque_actual / 1000.0,
      .ready = status.state == Cia402State::operation_enabled && status.follows && inputs.mode == 8,
      .fault =
          status.state == Cia402State::fault || status.state == Cia402State::fault_reaction_active};
}

Cia402Outputs Cia402Axis::command(const DriveSetpoint& setpoint,
                                  const Cia402Inputs& inputs) noexcept {
  const Cia402Status status = status_of(inputs.statusword).value_or(Cia402Status{});
  const auto wanted = increments_.of(setpoint.position);
  if (status.state != Cia402State::operation_enabled)
    target_ = actual_;
  else if (wanted)
    target_ = *wanted;
  const double away =
      std::abs(setpoint.position - increments_.position(static_cast<double>(actual_)));
  if (setpoint.reset) resetting_ = reset_cycles;
  if (status.state != Cia402State::fault) resetting_ = 0;
  const Cia402Wish wish{.operate = setpoint.enable,
                        .hold_back = !(away <= window_),
                        .reset = resetting_ > 0,
                        .standing = inputs.velocity_actual == 0};
  if (resetting_ > 0) --resetting_;
  return {.controlword = controlword(status.state, wish),
          .mode = 8,
          .target_position = Increments::wrapped(target_)};
}

}  // namespace jounce
