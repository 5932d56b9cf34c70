#include "jounce/cam/cam_switches.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/cam/detail/switch_machine.hpp"

namespace jounce {
namespace {

/// Whether the cubic with these end velocities goes from 0 to `d` as an axis does: either straight
/// on, monotone by the condition of Fritsch and Carlson (1980) that |v| dt <= 3 |d| at both ends,
/// or with one reversal, for which the mean velocity lies between those at the ends.
bool is_plausible(double d, double v0, double v1, double dt) {
  if ((v0 > 0 && v1 < 0) || (v0 < 0 && v1 > 0))
    return d >= std::min(v0, v1) * dt && d <= std::max(v0, v1) * dt;
  const auto fits = [&](double v) { return v * d >= 0 && std::abs(v) * dt <= 3 * std::abs(d); };
  return fits(v0) && fits(v1);
}

Segment cycle_motion(double x0, double v0, double x1, double v1, double dt) {
  return is_plausible(x1 - x0, v0, v1, dt) ? cubic(dt, x0, v0, x1, v1) : line(dt, x0, x1);
}

/// The way from `from` to `to` on an axis of this period, nearest to what is expected.
double way(double from, double to, double expected, double period) {
  const double d = to - from;
  if (period == 0) return d;
  if (!(std::abs(expected) < 1e6 * period)) expected = 0;  // no velocity of an axis
  return d - period * std::round((d - expected) / period);
}

}  // namespace

CamSwitches::CamSwitches(const CamSwitchSpec& spec) : period_(spec.period.value_or(0)) {
  require_valid(spec);
  machine_ = std::make_unique<detail::SwitchMachine>(spec);
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

/// The piece runs in a frame whose origin is less than a period away, so that a long run loses no
/// digits; the end of one piece, reduced anew from what was given, is the start of the next.
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
