// SPDX-License-Identifier: Apache-2.0
#include "axis/src/probe/registered_master.hpp"

#include <array>
#include <cmath>
#include <span>

#include "axis/src/probe/touch_probe.hpp"

namespace jounce {

RegisteredMaster::RegisteredMaster(const AxisConfig& config) : period_(config.period) {
  if (config.registration) registration_.emplace(*config.registration);
}

void RegisteredMaster::shift(double by) noexcept {
  last_[0] += by;
  history_.shift(by);
  if (registration_) registration_->shift(by);
}

void RegisteredMaster::see(double dt, const Jet& master) noexcept {
  history_.add(dt, master[0], master[1]);
}

Jet RegisteredMaster::corrected(const Jet& master, const Triggers& triggers,
                                bool follows) noexcept {
  phase_ = {};
  if (!registers(follows)) return master;
  const LiveRegistrationSpec& spec = registration_->spec();
  std::array<double, Triggers::most_changes> marks{};
  std::size_t count = 0;
  for (const TriggerChange& change : triggers.changes()) {
    if (change.input != spec.input || change.rising != spec.rising) continue;
    const double mark = history_.before(std::isfinite(change.age) ? change.age : 0);
    if (std::isfinite(mark)) marks[count++] = mark;
  }
  const double reported = history_.before(TouchProbes::latest * seconds(period_));
  registration_->step(master, reported, std::span(marks.data(), count));
  reading_ = registration_->reading();
  if (spec.add_to != CorrectionOf::master) return master;
  phase_ = registration_->correction();
  Jet sum = master;
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += phase_[k];
  return sum;
}

void RegisteredMaster::begin(double master) noexcept {
  if (registration_) registration_->begin(master);
}

void RegisteredMaster::end_tick(const Jet& master, bool follows) noexcept {
  last_ = master;
  if (registers(follows)) return;
  for (std::size_t k = 0; k < phase_.size(); ++k) last_[k] -= phase_[k];
}

void RegisteredMaster::correct_slave(Jet& slave, bool follows) const noexcept {
  if (!registers(follows) || registration_->spec().add_to != CorrectionOf::slave) return;
  for (std::size_t k = 0; k < slave.size(); ++k) slave[k] += registration_->correction()[k];
}

bool RegisteredMaster::fails(bool follows) const noexcept {
  return registers(follows) && registration_->spec().on_loss == MarkLoss::fault &&
         registration_->reading().lost;
}

}  // namespace jounce
