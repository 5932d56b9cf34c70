// SPDX-License-Identifier: Apache-2.0
#include "axis/src/homing/homing.hpp"

#include <cmath>
#include <limits>

namespace jounce {
namespace {

int sign(double x) {
  return (x > 0) - (x < 0);
}

}  // namespace

Homing::Homing(const HomingMethod& method, const HomingSpec& spec, const Seen& now) noexcept
    : method_(method), spec_(spec), position_(now.position) {
  if (method.sensor == nullptr) return;
  on_ = (now.sensors.*method.sensor).on;
  if (on_) side_ = 0;
}

void Homing::step(const Seen& now) noexcept {
  elapsed_ += now.dt;
  observe(now);
  cause_ = check(now);
  if (cause_ != Cause::none) return;
  if (velocity_ != 0) return move(now);
  if (now.at_rest && quiet_ >= settle) proceed(now);
}

/// Updates the state of the switch, and the side of it on which the axis is now.
void Homing::observe(const Seen& now) noexcept {
  if (const int way = sign(now.position - position_); way != 0) heading_ = way;
  position_ = now.position;
  change_.reset();
  quiet_ += now.dt;
  if (method_.sensor == nullptr) return;
  const Sensor& sensor = now.sensors.*method_.sensor;
  if (std::isfinite(sensor.edge))
    change_ = sensor.edge;
  else if (sensor.on != on_)
    change_ = now.position;  // for a drive without a latch
  on_ = sensor.on;
  if (!change_) return;
  quiet_ = 0;
  side_ = on_ ? 0 : heading_;
}

Cause Homing::check(const Seen& now) const noexcept {
  if (now.sensors.negative.on && now.sensors.positive.on) return Cause::both_switches;
  if (elapsed_ > spec_.timeout) return Cause::home_timeout;
  if (velocity_ == 0) return Cause::none;
  if (spec_.distance && std::abs(now.position - from_) > *spec_.distance)
    return phase_ == Phase::index ? Cause::index_not_found : Cause::search_distance;
  const Cause limit = limit_ahead(now.sensors, velocity_);
  if (phase_ != Phase::seek) return limit;
  return limit != Cause::none && turned_ ? Cause::home_not_found : Cause::none;
}

double Homing::exceeded() const noexcept {
  switch (cause_) {
    case Cause::home_timeout:
      return spec_.timeout;
    case Cause::search_distance:
    case Cause::index_not_found:
      return spec_.distance.value_or(std::numeric_limits<double>::quiet_NaN());
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

/// The fault of the active limit switch in this direction, unless the search is for that switch.
Cause Homing::limit_ahead(const Sensors& sensors, double velocity) const noexcept {
  const bool up = velocity > 0;
  Sensor Sensors::*const limit = up ? &Sensors::positive : &Sensors::negative;
  if (limit == method_.sensor || !(sensors.*limit).on) return Cause::none;
  return up ? Cause::positive_switch : Cause::negative_switch;
}

/// Selects the next motion from rest.
void Homing::proceed(const Seen& now) noexcept {
  const double fast = spec_.search_velocity;
  const double slow = spec_.index_velocity;
  if (phase_ == Phase::last) {
    phase_ = Phase::done;
  } else if (method_.sensor == nullptr) {
    begin(Phase::index, method_.last * slow, now);
  } else if (!side_) {
    if (!turned_ && limit_ahead(now.sensors, method_.search) != Cause::none) turn_round();
    begin(Phase::seek, method_.search * fast, now);
  } else if (*side_ == wanted_side()) {
    begin(Phase::edge, method_.last * slow, now);
  } else if (method_.leaves) {
    begin(Phase::place, -*side_ * slow, now);
  } else {
    begin(Phase::place, -method_.last * fast, now);
  }
}

void Homing::begin(Phase phase, double velocity, const Seen& now) noexcept {
  phase_ = phase;
  velocity_ = velocity;
  from_ = now.position;
}

/// Ends the present motion once it has reached its purpose.
void Homing::move(const Seen& now) noexcept {
  if (phase_ == Phase::seek && !side_ && limit_ahead(now.sensors, velocity_) != Cause::none)
    return turn_round();
  if (phase_ == Phase::seek && side_) velocity_ = 0;
  if (phase_ == Phase::place && side_ == wanted_side()) velocity_ = 0;
  if (phase_ == Phase::edge && change_ && heading_ != method_.last) {
    velocity_ = 0;  // the machine still came from the other side: that was another edge
  } else if (phase_ == Phase::edge && change_) {
    home_ = *change_;
    if (!method_.index) return find(home_);
    begin(Phase::index, velocity_, now);
  }
  if (phase_ != Phase::index) return;
  const double index = now.sensors.index.edge;
  const bool before = (index - home_) * method_.last < 0;  // in the cycle of the edge
  if (std::isfinite(index) && !before) find(index);
}

void Homing::turn_round() noexcept {
  turned_ = true;
  method_.search = -method_.search;
  velocity_ = 0;
}

void Homing::find(double position) noexcept {
  home_ = position;
  phase_ = Phase::last;
  velocity_ = 0;
}

}  // namespace jounce
