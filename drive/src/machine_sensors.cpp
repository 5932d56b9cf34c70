// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/machine_sensors.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::optional<SimulatedSwitch> simulated(const std::string& key,
                                         const std::optional<MachineSwitch>& spec) {
  if (!spec) return std::nullopt;
  try {
    return SimulatedSwitch(*spec);
  } catch (const InputError& error) {
    throw InputError(key + "." + error.key(), error.value(), error.rule());
  }
}

/// True if the motion from one position to another passes `place`; a position that is just reached
/// counts as passed upwards.
bool passes(double place, double from, double to) {
  return (from < place) != (to < place);
}

}  // namespace

SimulatedSwitch::SimulatedSwitch(const MachineSwitch& spec) : spec_(spec) {
  require_finite("position", spec.position);
  if (!(spec.width > 0)) throw InputError("width", spec.width, "must be greater than 0");
  require_not_negative("bounce", spec.bounce);
}

bool SimulatedSwitch::at(double position) const noexcept {
  const bool inside = position >= spec_.position && position < spec_.position + spec_.width;
  return inside != spec_.inverted;
}

Sensor SimulatedSwitch::step(double from, double to, double dt) noexcept {
  Sensor now{.wired = true, .on = at(to)};
  for (const double edge : {spec_.position, spec_.position + spec_.width})
    if (passes(edge, from, to) && !(std::abs(now.edge - from) <= std::abs(edge - from)))
      now.edge = edge;
  if (std::isfinite(now.edge)) {
    bouncing_ = spec_.bounce;
    flipped_ = false;
    return now;
  }
  bouncing_ = std::max(bouncing_ - dt, 0.0);
  const bool before = std::exchange(flipped_, bouncing_ > 0 && !flipped_);
  if (flipped_ != before) now.edge = to;
  now.on = now.on != flipped_;
  return now;
}

double index_between(const MachineIndex& index, double from, double to) noexcept {
  const double before = std::floor((from - index.offset) / index.period);
  const double after = std::floor((to - index.offset) / index.period);
  if (before == after) return none;
  return index.offset + index.period * (after > before ? before + 1 : before);
}

DriveOnMachine::DriveOnMachine(std::shared_ptr<AxisDrive> drive, const MachineSensorsSpec& spec,
                               double period)
    : drive_(std::move(drive)),
      spec_(spec),
      period_(period),
      home_(simulated("machine.home_switch", spec.home)),
      negative_(simulated("machine.negative_switch", spec.negative)),
      positive_(simulated("machine.positive_switch", spec.positive)) {
  require_finite("machine.encoder_offset", spec.encoder_offset);
  if (!spec.index) return;
  require_positive("machine.index.period", spec.index->period);
  require_finite("machine.index.offset", spec.index->offset);
}

Feedback DriveOnMachine::feedback() noexcept {
  Feedback said = drive_->feedback();
  const double to = said.position + spec_.encoder_offset;
  const double from = last_.value_or(to);
  last_ = to;
  Sensors& sensors = said.sensors;
  sensors.home = latched(home_, from, to);
  sensors.negative = latched(negative_, from, to);
  sensors.positive = latched(positive_, from, to);
  sensors.index.wired = spec_.index.has_value();
  if (spec_.index)
    sensors.index.edge = index_between(*spec_.index, from, to) - spec_.encoder_offset;
  return said;
}

/// Converts to the coordinate of the encoder.
Sensor DriveOnMachine::latched(std::optional<SimulatedSwitch>& of, double from,
                               double to) noexcept {
  if (!of) return {};
  Sensor sensor = of->step(from, to, period_);
  sensor.edge -= spec_.encoder_offset;
  return sensor;
}

}  // namespace jounce
