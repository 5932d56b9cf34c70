// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/cia402_axis.hpp"

#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

double window_of(const Cia402Config& config) {
  require_finite("window", config.window);
  if (config.window < 0) throw InputError("window", config.window, "must not be negative");
  return config.window > 0 ? config.window : config.position_per_rev / 100;
}

int probes_of(const Cia402Config& config) {
  if (config.touch_probes < 0 || config.touch_probes > 2)
    throw InputError("touch_probes", std::to_string(config.touch_probes), "must be 0, 1 or 2");
  return config.touch_probes;
}

/// Touch probe function (0x60B8): probe enabled, continuous, rising and falling edge. The bits of
/// probe 2 are 8 higher.
constexpr std::uint16_t both_edges = 0b11'0011;
constexpr unsigned second_probe = 8;

/// Bit of a capture in the status (0x60B9): 1, 2 for probe 1, and 9, 10 for probe 2.
constexpr unsigned status_bit(unsigned capture) {
  return (capture / 2) * second_probe + 1 + capture % 2;
}

}  // namespace

Cia402Axis::Cia402Axis(const Cia402Config& config)
    : increments_(config.increments_per_rev, config.position_per_rev, config.reversed),
      window_(window_of(config)),
      probes_(probes_of(config)) {}

/// Reports new captures, first rising, then falling. The first cycle only shows what is old.
void Cia402Axis::see_probes(const Cia402Inputs& inputs, Triggers& triggers) noexcept {
  triggers.wired = static_cast<std::uint8_t>((1U << static_cast<unsigned>(probes_)) - 1);
  for (unsigned capture = 0; capture < 2U * static_cast<unsigned>(probes_); ++capture) {
    const auto input = static_cast<std::uint8_t>(capture / 2 + 1);
    const bool rising = capture % 2 == 0;
    const auto bit = static_cast<std::uint16_t>(1U << status_bit(capture));
    const bool stored = (inputs.touch_probe_status & bit) != 0 && (probe_status_ & bit) == 0;
    const bool counted = inputs.touch_probe_count[capture] != probe_count_[capture];
    if (!seen_ || !(stored || counted)) continue;
    const std::int64_t latched =
        Increments::unwrapped(inputs.touch_probe_position[capture], actual_);
    triggers.change[triggers.count++] = {
        .input = input,
        .rising = rising,
        .position = increments_.position(static_cast<double>(latched))};
    const auto on = static_cast<std::uint8_t>(1U << (input - 1U));
    probe_on_ = static_cast<std::uint8_t>(rising ? probe_on_ | on : probe_on_ & ~on);
  }
  triggers.on = probe_on_;
  probe_status_ = inputs.touch_probe_status;
  probe_count_ = inputs.touch_probe_count;
}

Feedback Cia402Axis::feedback(const Cia402Inputs& inputs) noexcept {
  const Cia402Status status = status_of(inputs.statusword).value_or(Cia402Status{});
  actual_ = seen_ ? Increments::unwrapped(inputs.position_actual, actual_)
                  : std::int64_t{inputs.position_actual};
  Triggers triggers;
  see_probes(inputs, triggers);
  seen_ = true;
  return {
      .position = increments_.position(static_cast<double>(actual_)),
      .velocity = increments_.position(inputs.velocity_actual),
      .torque = inputs.torque_actual / 1000.0,
      .ready = status.state == Cia402State::operation_enabled && status.follows && inputs.mode == 8,
      .fault =
          status.state == Cia402State::fault || status.state == Cia402State::fault_reaction_active,
      .triggers = triggers};
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
          .target_position = Increments::wrapped(target_),
          .touch_probe = static_cast<std::uint16_t>(
              (probes_ > 0 ? both_edges : 0) | (probes_ > 1 ? both_edges << second_probe : 0))};
}

}  // namespace jounce
