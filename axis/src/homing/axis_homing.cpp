// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "axis/src/state/axis_impl.hpp"

// Homing of an axis. The class Homing computes the velocity, and the axis plans the motion
// to that velocity as for any other move. The position range does not apply: it refers to the home
// position, which is not yet known.

namespace jounce {
namespace {

/// Returns the homing of the axis with the changes of the command.
HomingSpec chosen(const command::Home& what, HomingSpec spec) {
  const auto take = [](auto& value, double given) {
    if (!std::isnan(given)) value = given;
  };
  if (what.method != 0) spec.method = what.method;
  take(spec.offset, what.offset);
  take(spec.search_velocity, what.search_velocity);
  take(spec.index_velocity, what.index_velocity);
  take(spec.acceleration, what.acceleration);
  take(spec.timeout, what.timeout);
  take(spec.distance, what.distance);
  return spec;
}

std::optional<Refusal> misses(const HomingSpec& spec, const AxisConfig& config) {
  for (const double velocity : {spec.search_velocity, spec.index_velocity}) {
    MoveDynamics dynamics{.velocity = velocity, .acceleration = spec.acceleration};
    if (const auto no = fill(dynamics, config)) return no;
  }
  if (!(spec.timeout > 0)) return Refusal{Cause::not_positive, spec.timeout, 0, 0};
  if (spec.distance && !(*spec.distance > 0))
    return Refusal{Cause::not_positive, *spec.distance, 0, 0};
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> misplaced_home(const HomingSpec& spec, const Limits& limits) {
  const bool at_negative = spec.method == 1 || spec.method == 17;
  const bool at_positive = spec.method == 2 || spec.method == 18;
  const bool below = limits.position_min && spec.offset < *limits.position_min;
  const bool above = limits.position_max && spec.offset > *limits.position_max;
  if (!(below && !at_negative) && !(above && !at_positive)) return std::nullopt;
  return Refusal{Cause::position_limit, spec.offset,
                 below ? *limits.position_min : *limits.position_max};
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Home& what) {
  if (keeps_coordinate()) return Refusal{Cause::compensation_active};
  const HomingSpec spec = chosen(what, config_.homing);
  const auto method = homing_method(spec.method);
  if (!method) return Refusal{Cause::no_such_method, static_cast<double>(spec.method)};
  if (auto no = misses(spec, config_)) return no;
  if (!(std::abs(spec.offset) <= furthest(config_)))
    return Refusal{Cause::position_limit, spec.offset, furthest(config_)};
  if (const auto no = misplaced_home(spec, config_.limits)) return no;
  if (armed_.waiting()) return Refusal{Cause::in_motion};
  if (!has_sensors(*method, inputs_.feedback.sensors)) return Refusal{Cause::no_sensor};
  state_ = State::homing;
  now_.reason = Cause::none;
  now_.homed = method->last == 0;
  if (now_.homed) return set_position(spec.offset);
  homing_.emplace(*method, spec, seen());
  begun_ = bare_.tick = now_.tick;
  MoveDynamics dynamics{.acceleration = spec.acceleration, .deceleration = spec.acceleration};
  fill(dynamics, config_);
  if (!adopt({Goal::Kind::rest, 0, dynamics}, 1)) fail(Cause::jump);
  return std::nullopt;
}

Homing::Seen MotionAxis::Impl::seen() const {
  const bool at_rest =
      base_ == Base::move && move_.goal().kind == Goal::Kind::rest && move_.is_over(bare_.tick);
  Sensors sensors = inputs_.feedback.sensors;
  sensors.positive.on = sensors.positive.on || inputs_.positive_switch;
  sensors.negative.on = sensors.negative.on || inputs_.negative_switch;
  return {sensors, inputs_.feedback.position, at_rest, dt()};
}

/// One tick of the search.
void MotionAxis::Impl::seek() {
  const double before = homing_->velocity();
  homing_->step(seen());
  if (homing_->cause() != Cause::none) return fail(homing_->cause(), homing_->exceeded());
  if (homing_->done()) return find_home();
  const double velocity = homing_->velocity();
  if (velocity == before) return;
  Goal goal{velocity == 0 ? Goal::Kind::rest : Goal::Kind::velocity, velocity,
            move_.goal().dynamics};
  if (velocity != 0) goal.dynamics.velocity = std::abs(velocity);
  if (!adopt(goal, requested_rate())) fail(Cause::jump);
}

/// The axis stands beyond its home position, which gets its new coordinate.
void MotionAxis::Impl::find_home() {
  const double home = homing_->home() + now_.offset;
  const double position = homing_->offset();
  if (!std::isfinite(home)) return fail(Cause::home_not_found);  // the drive had no position there
  rest();
  if (const auto no = set_position(now_.position + (position - home))) now_.refused = no;
  now_.homed = true;
}

}  // namespace jounce
