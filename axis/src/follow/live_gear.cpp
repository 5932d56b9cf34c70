// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/live_gear.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/axis/axis_config.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/src/follow/gear_ramp.hpp"
#include "axis/src/follow/live.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

/// Cause of a broken gear: its only failure is a lost master.
Cause lost(Progress progress) {
  return progress == Progress::broken ? Cause::master_lost : Cause::none;
}

bool usable(const MotionState& s) {
  return axis_detail::usable({s.position, s.velocity, s.acceleration, 0});
}

}  // namespace

LiveGear::LiveGear(std::uint64_t id, const GearInSpec& spec)
    : Movement(id, Course::live), spec_(spec), gear_(gear_in(spec, MotionState{}, Jet{}, 0)) {}

// gear_in() throws for a bad spec, which the constructor has checked, and for results that are not
// finite, which usable() prevents.
Cause LiveGear::begin(const MotionState& axis, const Moment& now) noexcept {
  if (!axis_detail::usable(now.master) || !usable(axis)) return Cause::no_master_input;
  try {
    gear_ = gear_in(spec_, axis, now.master, now.t);
  } catch (const InputError&) {
    return Cause::no_ramp;
  }
  progress_ = Progress::engaging;
  last_ = axis_detail::setpoint(now.master, {axis.position, axis.velocity, axis.acceleration, 0});
  return Cause::none;
}

Setpoint LiveGear::at(const Moment& now) noexcept {
  if (!axis_detail::usable(now.master)) progress_ = Progress::broken;
  if (progress_ == Progress::broken) return last_;
  progress_ = in_gear(gear_, now.t) ? Progress::running : Progress::engaging;
  return last_ = axis_detail::setpoint(now.master, point(gear_, now.master, now.t));
}

Cause LiveGear::cause() const noexcept {
  return lost(progress_);
}

Peaks LiveGear::peaks() const noexcept {
  return progress_ == Progress::engaging ? axis_detail::ramp_peaks(spec_) : Peaks{};
}

std::optional<Refusal> LiveGear::admit(const AxisConfig& config,
                                       const MotionState& /*from*/) const noexcept {
  return axis_detail::against_ramp(spec_, config);
}

LiveGearInPos::LiveGearInPos(std::uint64_t id, const GearInPosSpec& spec)
    : Movement(id, Course::live), gear_(gear_in_pos(spec)) {
  if (!gear_)
    throw InputError("master_start_distance", spec.master_start_distance, explain(gear_.status));
}

Cause LiveGearInPos::begin(const MotionState& axis, const Moment& now) noexcept {
  if (!axis_detail::usable(now.master) || !usable(axis)) return Cause::no_master_input;
  const double stroke = std::abs(gear_.slave_sync - gear_.slave_start);
  const double near = rounded_input * stroke + rounded_sum * std::abs(gear_.slave_start);
  if (axis.velocity != 0) return Cause::in_motion;
  if (!(std::abs(axis.position - gear_.slave_start) <= near)) return Cause::start_position;
  state_ = {};
  reversed_ = false;
  progress_ = Progress::waiting;
  last_ = axis_detail::setpoint(now.master, {gear_.slave_start, 0, 0, 0});
  return Cause::none;
}

Setpoint LiveGearInPos::at(const Moment& now) noexcept {
  if (!axis_detail::usable(now.master)) progress_ = Progress::broken;
  if (progress_ == Progress::broken) return last_;
  const GearInPosStep done = step(gear_, state_, now.master);
  state_ = done.state;
  reversed_ = done.status == GearInPosStatus::master_reversed;
  progress_ = done.in_sync      ? Progress::running
              : done.start_sync ? Progress::engaging
                                : Progress::waiting;
  return last_ = axis_detail::setpoint(now.master, done.slave);
}

Cause LiveGearInPos::cause() const noexcept {
  return lost(progress_);
}

}  // namespace jounce
