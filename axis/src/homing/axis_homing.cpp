// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "axis/src/state/axis_impl.hpp"

// Homing of an axis (home_search.hpp): the axis plans the motions of the search as moves.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::home(const command::Home& what) {
  if (keeps_coordinate()) return Refusal{Cause::compensation_active};
  HomeOrder order;
  if (auto no = home_order_of(what, config_, order)) return no;
  if (slot_.armed().waiting()) return Refusal{Cause::in_motion};
  if (!has_sensors(order.method, inputs_.feedback.sensors)) return Refusal{Cause::no_sensor};
  state_ = State::homing;
  now_.reason = Cause::none;
  now_.homed = order.method.last == 0;
  if (now_.homed) return rename_to(order.spec.offset);
  home_.begin(order, seen());
  motion_.begin_at(now_.tick);
  MoveDynamics dynamics{.acceleration = order.spec.acceleration,
                        .deceleration = order.spec.acceleration};
  fill(dynamics, config_);
  if (!adopt({Goal::Kind::rest, 0, dynamics}, 1)) fail(Cause::jump);
  return std::nullopt;
}

Homing::Seen MotionAxis::Impl::seen() const {
  const bool at_rest = motion_.is_move() && motion_.own().goal().kind == Goal::Kind::rest &&
                       motion_.own().player().is_over(motion_.put_out_in());
  Sensors sensors = inputs_.feedback.sensors;
  sensors.positive.on = sensors.positive.on || inputs_.positive_switch;
  sensors.negative.on = sensors.negative.on || inputs_.negative_switch;
  return {sensors, inputs_.feedback.position, at_rest, dt()};
}

/// One tick of the search.
void MotionAxis::Impl::seek() {
  const HomeSearch::Step next = home_.step(seen());
  if (next.fault != Cause::none) return fail(next.fault, next.exceeded);
  if (next.done) return find_home();
  if (!next.velocity) return;
  const double velocity = *next.velocity;
  Goal goal{velocity == 0 ? Goal::Kind::rest : Goal::Kind::velocity, velocity,
            motion_.own().goal().dynamics};
  if (velocity != 0) goal.dynamics.velocity = std::abs(velocity);
  if (!adopt(goal, motion_.requested_rate(home_.running()))) fail(Cause::jump);
}

/// The axis stands beyond its home position, which gets its new coordinate.
void MotionAxis::Impl::find_home() {
  const double home = home_.home() + coordinate_.offset();
  const double position = home_.position_at_home();
  if (!std::isfinite(home)) return fail(Cause::home_not_found);  // the drive had no position there
  rest();
  if (const auto no = rename_to(now_.position + (position - home))) now_.refused = no;
  now_.homed = true;
}

}  // namespace jounce
