// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <span>

#include "axis/src/state/axis_impl.hpp"

// The trigger inputs of an axis: touch probes, and the registration of a motion that follows the
// live master.

namespace jounce {

void MotionAxis::Impl::remember_master() {
  master_seen_.add(dt(), inputs_.master[0], inputs_.master[1]);
}

/// True if the registration corrects the present motion. It does not correct a plan of cuts, whose
/// cutter must stay in step with the web.
bool MotionAxis::Impl::is_registered() const {
  return registration_ && base_ == Base::live && live_->cuts() == nullptr;
}

/// Steps the registration. A correction of the master is added to the input of this tick, so that
/// every part of the axis sees the corrected master.
void MotionAxis::Impl::register_marks() {
  phase_ = {};
  if (!is_registered()) return;
  const LiveRegistrationSpec& spec = registration_->spec();
  std::array<double, Triggers::most_changes> marks{};
  std::size_t count = 0;
  for (const TriggerChange& change : inputs_.feedback.triggers.changes()) {
    if (change.input != spec.input || change.rising != spec.rising) continue;
    const double mark = master_seen_.before(std::isfinite(change.age) ? change.age : 0);
    if (std::isfinite(mark)) marks[count++] = mark;
  }
  const double reported = master_seen_.before(TouchProbes::latest * seconds(config_.period));
  registration_->step(inputs_.master, reported, std::span(marks.data(), count));
  now_.registration = registration_->reading();
  if (spec.add_to != CorrectionOf::master) return;
  phase_ = registration_->correction();
  for (std::size_t k = 0; k < phase_.size(); ++k) inputs_.master[k] += phase_[k];
}

/// Only a registered motion has a corrected master.
void MotionAxis::Impl::end_of_marks() {
  if (is_registered()) return;
  for (std::size_t k = 0; k < phase_.size(); ++k) last_master_[k] -= phase_[k];
}

/// Adds a correction of the slave to its setpoint.
void MotionAxis::Impl::add_correction(Setpoint& next) const {
  if (!is_registered() || registration_->spec().add_to != CorrectionOf::slave) return;
  for (std::size_t k = 0; k < next.slave.size(); ++k)
    next.slave[k] += registration_->correction()[k];
}

/// After the setpoint of this tick: a capture may need its position.
void MotionAxis::Impl::probe() {
  commanded_seen_.add(dt(), now_.position, now_.velocity);
  const double offset = now_.offset - in_feedback_;
  actual_seen_.add(dt(), inputs_.feedback.position + offset, inputs_.feedback.velocity);
  probes_.step(inputs_.feedback, {commanded_seen_, actual_seen_, master_seen_, offset}, dt(),
               config_);
  now_.probe = probes_.now();
}

}  // namespace jounce
