// SPDX-License-Identifier: Apache-2.0
#include "axis/src/state/supervision.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "axis/src/follow/live.hpp"

namespace jounce {

bool Supervision::too_far(double error, double dt, const AxisConfig& config) noexcept {
  const bool outside = config.following_error > 0 && std::abs(error) > config.following_error;
  outside_ = outside ? outside_ + dt : 0;
  return outside && outside_ >= config.following_time;
}

bool Supervision::settled(double error, bool at_rest, double dt,
                          const AxisConfig& config) noexcept {
  const bool inside = at_rest && config.in_position > 0 && std::abs(error) <= config.in_position;
  inside_ = inside ? inside_ + dt : 0;
  return inside && inside_ >= config.in_position_time;
}

double furthest(const AxisConfig& config) noexcept {
  return 0x1p40 * *config.limits.velocity * static_cast<double>(config.period) * 1e-9;
}

Inputs sound(const Inputs& inputs, const AxisConfig& config) noexcept {
  Inputs sound = inputs;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  for (Jet* const master : {&sound.master, &sound.second_master})
    if (!axis_detail::usable(*master)) *master = {unknown, 0, 0, 0};
  Feedback& drive = sound.feedback;
  for (auto [value, most] : {std::pair{&drive.position, furthest(config)},
                             {&drive.sensors.home.edge, furthest(config)},
                             {&drive.sensors.negative.edge, furthest(config)},
                             {&drive.sensors.positive.edge, furthest(config)},
                             {&drive.sensors.index.edge, furthest(config)},
                             {&drive.velocity, most_magnitude},
                             {&drive.torque, most_magnitude}}) {
    if (std::isnan(*value) || std::abs(*value) <= most) continue;
    *value = unknown;
    drive.fault = true;
  }
  Triggers& triggers = drive.triggers;
  if (triggers.count > Triggers::most_changes) triggers.count = 0;
  for (TriggerChange& change : triggers.change) {
    if (!(std::abs(change.position) <= furthest(config))) change.position = unknown;
    if (!(change.age >= 0)) change.age = unknown;
  }
  return sound;
}

Cause check_inputs(const Inputs& inputs) noexcept {
  if (inputs.feedback.fault) return Cause::drive_fault;
  if (!inputs.feedback.ready) return Cause::drive_not_ready;
  return inputs.watchdog ? Cause::watchdog : Cause::none;
}

Reaction reaction_to(Cause fault) noexcept {
  switch (fault) {
    case Cause::disabled_in_motion:
    case Cause::following_error:  // all controllers disable it: Googol 9, HMPL 5.1.1, Agito 5.3
    case Cause::drive_fault:
    case Cause::drive_not_ready:
      return Reaction::power_off;
    case Cause::stalled:  // the drive ran without setpoints: no ramp can correct that
      return Reaction::freeze;
    case Cause::underrun:
    case Cause::watchdog:
    case Cause::axis_fault:
      return Reaction::stop_on_path;
    default:
      return Reaction::brake;
  }
}

}  // namespace jounce
