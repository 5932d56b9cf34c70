#include "jounce/axis/live_cam.hpp"

#include <cmath>
#include <utility>

#include "jounce/axis/detail/live.hpp"

namespace jounce {

Cause cause_of(CouplingStatus status) {
  switch (status) {
    case CouplingStatus::ok:
      return Cause::none;
    case CouplingStatus::not_finite:
      return Cause::no_master_input;
    case CouplingStatus::master_outside_cam:
      return Cause::master_outside_cam;
    case CouplingStatus::would_reverse:
      return Cause::would_reverse;
    case CouplingStatus::master_stands:
      return Cause::master_stands;
    case CouplingStatus::no_ramp:
    case CouplingStatus::window_missed:
      break;
  }
  return Cause::no_ramp;
}

LiveCam::LiveCam(std::uint64_t id, std::shared_ptr<const Table> cam, const CouplingSpec& spec)
    : Movement(id, Course::live),
      table_(std::move(cam)),
      coupling_(table_->curve<OverMaster>(), spec) {}

Cause LiveCam::begin(const MotionState& axis, const Moment& now) noexcept {
  if (!detail::usable(now.master)) return Cause::no_master_input;
  const Engagement in = engage(coupling_, axis, now.master, now.t);
  if (!in) return cause_of(in.status);
  const double near = 1e-9 * std::abs(coupling_.reach()[0]) + 1e-12 * std::abs(axis.position);
  if (!(std::abs(in.jump.position) <= near)) return Cause::start_position;
  engaged_ = in.engaged;
  released_.reset();
  periods_ = 0;
  progress_ = Progress::engaging;
  cause_ = Cause::none;
  last_ = detail::setpoint(now.master, {axis.position, axis.velocity, axis.acceleration, 0});
  return Cause::none;
}

Setpoint LiveCam::at(const Moment& now) noexcept {
  if (progress_ == Progress::broken) return last_;
  if (released_) return last_ = {last_.master, last_.master_velocity, point(*released_, now.t)};
  if (!detail::usable(now.master)) return break_off(Cause::master_lost);
  const Stepped step = jounce::step(coupling_, engaged_, {now.t, now.master});
  if (step.released && step.jumped) return break_off(cause_of(step.status));
  engaged_ = step.engaged;
  released_ = step.released;
  periods_ += step.periods;
  progress_ = released_ ? Progress::done : step.in_sync ? Progress::running : Progress::engaging;
  const Jet slave = released_ ? step.slave : point(*table_, engaged_, now.master, now.t);
  return last_ = detail::setpoint(now.master, slave);
}

Setpoint LiveCam::break_off(Cause cause) noexcept {
  progress_ = Progress::broken;
  cause_ = cause == Cause::none ? Cause::master_lost : cause;
  return last_;
}

}  // namespace jounce
