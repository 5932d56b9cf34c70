// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/switches/cam_switches.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/profiles/curve/cycle_motion.hpp"

#include "cam/src/switches/switch_machine.hpp"

namespace jounce {
namespace {

/// The distance from `from` to `to` on an axis with this period: the one nearest to the expected
/// distance.
double way(double from, double to, double expected, double period) {
  const double d = to - from;
  if (period == 0) return d;
  if (!(std::abs(expected) < 1e6 * period)) expected = 0;  // implausible as a velocity
  return d - period * std::round((d - expected) / period);
}

}  // namespace

CamSwitches::CamSwitches(const CamSwitchSpec& spec) : period_(spec.period.value_or(0)) {
  require_valid(spec);
  machine_ = std::make_unique<cam_detail::SwitchMachine>(spec);
  step_.outputs = machine_->outputs();
}

CamSwitches::~CamSwitches() = default;
CamSwitches::CamSwitches(CamSwitches&& other) noexcept = default;
CamSwitches& CamSwitches::operator=(CamSwitches&& other) noexcept = default;

void CamSwitches::enable(std::uint32_t mask) {
  machine_->enable(mask);
}

const SwitchStep& CamSwitches::step(double position, double velocity, double dt) {
  assert(dt > 0);
  elapsed_ += dt;
  step_.count = step_.lost = 0;
  if (!std::isfinite(position) || !std::isfinite(velocity)) return step_;
  if (placed_)
    move(position, velocity);
  else
    place_at(position, velocity);
  collect(dt);
  position_ = position;
  velocity_ = velocity;
  elapsed_ = 0;
  return step_;
}

void CamSwitches::place_at(double position, double velocity) {
  local_ = reduced(position);
  machine_->place(local_, velocity);
  if (!known_) machine_->settle();
  machine_->wait(elapsed_);
  placed_ = known_ = true;
}

/// Starts a piece in a frame whose origin is less than a period away, so a long run loses no
/// digits. The end of a piece, reduced from the given position, is the start of the next piece.
void CamSwitches::move(double position, double velocity) {
  const double d = way(position_, position, (velocity_ + velocity) / 2 * elapsed_, period_);
  machine_->begin(cycle_motion(local_, velocity_, local_ + d, velocity, elapsed_));
  const double next = reduced(position);
  turns_ = period_ > 0 ? std::llround((local_ + d - next) / period_) : 0;
  local_ = next;
}

void CamSwitches::collect(double dt) {
  const double skipped = elapsed_ - dt;
  while (const auto edge = machine_->next()) {
    if (step_.count == SwitchStep::most_edges) {
      ++step_.lost;
      continue;
    }
    const double time = std::max(edge->time - skipped, 0.0);
    step_.edge[step_.count++] = {std::min(time, std::nextafter(dt, 0)), edge->track, edge->on};
  }
  machine_->shift(turns_);
  turns_ = 0;
  step_.outputs = machine_->outputs();
}

double CamSwitches::reduced(double position) const {
  return period_ > 0 ? wrapped(position, 0, period_) : position;
}

}  // namespace jounce
