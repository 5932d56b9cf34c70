// SPDX-License-Identifier: Apache-2.0
#include "axis/src/probe/touch_probe.hpp"

#include <cmath>
#include <utility>

namespace jounce {
namespace {

bool is_wired(int input, const Feedback& feedback) {
  if (input == home_switch_input) return feedback.sensors.home.wired;
  if (input == index_input) return feedback.sensors.index.wired;
  return (feedback.triggers.wired >> static_cast<unsigned>(input - 1) & 1U) != 0;
}

/// The wired inputs as bits: bit 0 is input 1.
double wired(const Feedback& feedback) {
  unsigned bits = 0;
  for (int input = 1; input <= probe_inputs; ++input)
    if (is_wired(input, feedback)) bits |= 1U << static_cast<unsigned>(input - 1);
  return bits;
}

bool suits(ProbeEdge edge, bool rising) {
  return edge == ProbeEdge::both || (edge == ProbeEdge::rising) == rising;
}

/// x modulo the turn, 0 to turn.
double within_turn(double x, double turn) {
  return x - turn * std::floor(x / turn);
}

bool in_window(const command::TouchProbe& probe, double position, double turn) {
  const bool has_first = std::isfinite(probe.first_position);
  const bool has_last = std::isfinite(probe.last_position);
  if (turn == 0 || !has_first || !has_last) {
    return (!has_first || position >= probe.first_position) &&
           (!has_last || position <= probe.last_position);
  }
  const double from_first = within_turn(position - probe.first_position, turn);
  return from_first <= within_turn(probe.last_position - probe.first_position, turn);
}

/// The refusal of a window that the axis cannot reach.
std::optional<Refusal> against(const command::TouchProbe& what, const AxisConfig& config) {
  if (config.modulo != 0) return std::nullopt;
  if (what.first_position > what.last_position)
    return Refusal{Cause::probe_window, what.first_position, what.last_position};
  const Limits& limits = config.limits;
  if (limits.position_max && what.first_position > *limits.position_max)
    return Refusal{Cause::probe_window, what.first_position, *limits.position_max};
  if (limits.position_min && what.last_position < *limits.position_min)
    return Refusal{Cause::probe_window, what.last_position, *limits.position_min};
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> TouchProbes::start(const command::TouchProbe& what, const Feedback& feedback,
                                          const AxisConfig& config) noexcept {
  if (what.input < 1 || what.input > probe_inputs || !is_wired(what.input, feedback))
    return Refusal{Cause::no_trigger_input, static_cast<double>(what.input), wired(feedback)};
  if (const auto no = against(what, config)) return no;
  probes_[static_cast<std::size_t>(what.input - 1)] = {.what = what, .waits = true};
  now_.waiting = static_cast<std::uint8_t>(now_.waiting | 1U << (what.input - 1));
  return std::nullopt;
}

std::optional<Refusal> TouchProbes::abort(int input) noexcept {
  const bool waits = input >= 1 && input <= probe_inputs &&
                     std::exchange(probes_[static_cast<std::size_t>(input - 1)].waits, false);
  if (!waits) return Refusal{Cause::no_touch_probe};
  now_.waiting = static_cast<std::uint8_t>(now_.waiting & ~(1U << (input - 1)));
  return std::nullopt;
}

void TouchProbes::step(const Feedback& feedback, const Places& places, double dt,
                       const AxisConfig& config) noexcept {
  now_.count = 0;
  const bool home_on = feedback.sensors.home.on;
  if (now_.waiting != 0) {
    for (const TriggerChange& change : feedback.triggers.changes()) {
      const double age = std::isfinite(change.age) ? change.age : 0;
      see(change.input, change.rising, age, change.position, places, config);
    }
    const Sensors& sensors = feedback.sensors;
    if (std::isfinite(sensors.home.edge) || home_on != home_on_)
      see(home_switch_input, home_on, 0, sensors.home.edge, places, config);
    if (std::isfinite(sensors.index.edge))
      see(index_input, true, 0, sensors.index.edge, places, config);
  }
  home_on_ = home_on;
  for (Probe& probe : probes_) probe.since += dt;
}

/// An edge of an input, `age` s before the instant of this tick.
void TouchProbes::see(int input, bool rising, double age, double latched, const Places& places,
                      const AxisConfig& config) noexcept {
  if (input < 1 || input > probe_inputs) return;
  Probe& probe = probes_[static_cast<std::size_t>(input - 1)];
  if (!probe.waits || !suits(probe.what.edge, rising) || age >= probe.since) return;
  Capture capture{.input = static_cast<std::uint8_t>(input), .rising = rising, .age = age};
  capture.commanded = places.commanded.before(age);
  capture.actual = std::isfinite(latched) ? latched + places.offset : places.actual.before(age);
  capture.master = places.master.before(age);
  if (!in_window(probe.what, capture.position(), config.modulo)) return;
  if (now_.count == ProbeStep::most_captures) return;
  now_.capture[now_.count++] = capture;
  ++now_.total;
  if (++probe.made != probe.what.count) return;
  static_cast<void>(abort(input));
}

}  // namespace jounce
