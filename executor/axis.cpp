#include "jounce/executor/axis.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "jounce/executor/job.hpp"

namespace jounce {

MotionAxis::MotionAxis(const AxisConfig& config, const AxisSwitches& switches)
    : config_(resolved(config)),
      has_switches_(!switches.table.switches.empty()),
      switches_of_(switches.of),
      switches_(switches.table) {
  now_.position = config_.position;
}

Tick MotionAxis::step(std::int64_t tick, const Command& command, const Inputs& inputs) {
  assert(tick > last_tick_);
  now_.skipped = tick - last_tick_ - 1;
  now_.tick = tick;
  now_.time = seconds(tick);
  now_.refused.reset();
  now_.handed_back = {};
  obey(command);
  (void)inputs;
  if (start_at_ >= 0 && start_at_ <= tick) start_pending();
  if (moving()) play();
  operate_switches();
  last_tick_ = tick;
  now_.state = state_;
  now_.job = active_ ? active_->id() : 0;
  now_.armed = pending_ ? pending_->id() : 0;
  now_.waiting = start_at_ >= 0;
  return now_;
}

// ---- commands ----------------------------------------------------------------------------------

void MotionAxis::obey(const Command& command) {
  using Kind = Command::Kind;
  switch (command.kind) {
    case Kind::none:
      return;
    case Kind::enable:
      // An axis that was disabled by a fault comes back into it (PMC600 manual 5.1).
      if (state_ == State::disabled)
        state_ = now_.fault == Cause::none ? State::standstill : State::error_stop;
      return;
    case Kind::disable:
      if (moving()) fail(Cause::disabled_in_motion);
      disarm();
      state_ = State::disabled;
      return;
    case Kind::arm:
      return arm(command.movement);
    case Kind::disarm:
      if (start_at_ < 0) disarm();
      return;
    case Kind::start:
      return start(command.at);
    case Kind::stop:
      return stop();
    case Kind::abort:
      return fail(Cause::aborted);
    case Kind::reset:
      now_.fault = Cause::none;
      if (state_ == State::error_stop) state_ = State::standstill;
      return;
    case Kind::set_position:
      return set_position(command.position);
    default:
      return refuse(Cause::no_movement);
  }
}

/// Nothing is obeyed by an axis that is disabled or has a fault.
bool MotionAxis::ready() {
  if (state_ == State::disabled) refuse(Cause::not_enabled);
  if (state_ == State::error_stop) refuse(Cause::in_error);
  return !now_.refused;
}

void MotionAxis::arm(Movement* movement) {
  if (!movement) return refuse(Cause::no_value);
  if (ready()) {
    // What is armed in motion begins where the motion will end, if that is known.
    const auto from = active_ ? active_->end() : MotionState{now_.position, 0, 0};
    if (state_ == State::stopping || !from || (active_ && std::isinf(active_->known()))) {
      refuse(Cause::in_motion);
    } else {
      now_.refused = movement->admit(config_, *from);
    }
  }
  if (now_.refused) return hand_back(movement);
  disarm();
  pending_ = movement;
}

void MotionAxis::start(std::int64_t at) {
  if (!ready()) return;
  if (moving()) return refuse(Cause::in_motion);
  if (!pending_) return refuse(Cause::not_armed);
  if (at >= 0 && at < now_.tick)
    return refuse(Cause::too_late, static_cast<double>(at), static_cast<double>(now_.tick));
  const Cause no = pending_->begin({now_.position, 0, 0}, {});
  if (no != Cause::none) return refuse(no, 0, now_.position);
  start_at_ = at >= 0 ? at : now_.tick;
}

void MotionAxis::start_pending() {
  active_ = pending_;
  pending_ = nullptr;
  origin_ = start_at_;
  start_at_ = -1;
  state_ = active_->synchronized() ? State::synchronized_motion : State::discrete_motion;
  has_master_ = active_->synchronized();
  if (switches_of_ == SwitchesOf::master) switches_.place();
}

void MotionAxis::stop() {
  if (state_ == State::error_stop) return refuse(Cause::in_error);
  disarm();
  if (!moving() || state_ == State::stopping) return;
  stop_from_ = seconds(now_.tick - origin_);
  stop_length_ = stop_duration(active_->peaks(), config_);
  origin_ = now_.tick;
  state_ = State::stopping;
}

void MotionAxis::set_position(double position) {
  if (state_ == State::error_stop) return refuse(Cause::in_error);
  if (moving() || start_at_ >= 0) return refuse(Cause::in_motion);
  if (!std::isfinite(position)) return refuse(Cause::no_value, position);
  now_.position = position;
  if (switches_of_ == SwitchesOf::position) switches_.place();
}

// ---- motion ------------------------------------------------------------------------------------

void MotionAxis::play() {
  // What was left out before the motion began does not count.
  if (std::min(now_.skipped, now_.tick - origin_) >= config_.longest_gap)
    return fail(Cause::stalled);
  const double t = seconds(now_.tick - origin_);
  if (state_ == State::stopping) return slow_down(t);
  move_to(active_->at({t, 0, {}}));
  if (moving() && active_->progress() == Progress::done) {
    ++now_.finished;
    rest();
  }
}

/// t seconds after the stop; the equations are those of stop_duration().
void MotionAxis::slow_down(double t) {
  const double D = stop_length_;
  const double u = t < D ? t / D : 1;
  const double s = stop_from_ + D * u * (1 - u * u * (1 - u / 2));  // (2)
  const double r = (1 - u) * (1 - u) * (1 + 2 * u);                 // (1)
  const double dr = u < 1 ? -6 * u * (1 - u) / D : 0;
  Setpoint point = active_->at({s, 0, {}});
  auto& [p, v, a, j] = point.slave;
  a = a * r * r + v * dr;  // (4)
  v *= r;                  // (3)
  point.master_velocity *= r;
  const bool at_end = active_->progress() == Progress::done;
  move_to(point);
  if (moving() && (u >= 1 || at_end)) {
    ++now_.stopped;
    rest();
  }
}

/// Gives the point out, unless it is one that an admitted job cannot ask for.
void MotionAxis::move_to(const Setpoint& point) {
  const auto& [p, v, a, j] = point.slave;
  const double near = 1e-9;
  const double reach = *config_.limits.velocity * seconds(now_.skipped + 1) * (1 + 1e-9) + near;
  if (!(std::abs(p - now_.position) <= reach)) return fail(Cause::overspeed);
  if ((config_.limits.position_min && p < *config_.limits.position_min - near) ||
      (config_.limits.position_max && p > *config_.limits.position_max + near))
    return fail(Cause::out_of_range);
  now_.master = point.master;
  now_.master_velocity = point.master_velocity;
  now_.position = p;
  now_.velocity = v;
  now_.acceleration = a;
}

void MotionAxis::rest() {
  hand_back(active_);
  active_ = nullptr;
  state_ = State::standstill;
  now_.master_velocity = now_.velocity = now_.acceleration = 0;
}

void MotionAxis::operate_switches() {
  if (!has_switches_) return;
  const double dt = seconds(now_.skipped + 1);
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();  // changes nothing
  if (switches_of_ == SwitchesOf::position)
    now_.switches = switches_.step(now_.position, now_.velocity, dt);
  else
    now_.switches = switches_.step(has_master_ ? now_.master : nowhere, now_.master_velocity, dt);
}

/// The first fault is the one that stays: what follows is its consequence.
void MotionAxis::fail(Cause cause) {
  if (now_.fault == Cause::none) now_.fault = cause;
  const bool enabled = state_ != State::disabled;
  disarm();
  if (active_) rest();
  if (enabled) state_ = State::error_stop;
}

void MotionAxis::disarm() {
  if (pending_) hand_back(pending_);
  pending_ = nullptr;
  start_at_ = -1;
}

void MotionAxis::hand_back(const Movement* movement) {
  // At most three in one step: the one played, the one armed, and the one just refused.
  auto free = std::find(now_.handed_back.begin(), now_.handed_back.end(), nullptr);
  assert(free != now_.handed_back.end());
  *free = movement;
}

void MotionAxis::refuse(Cause cause, double value, double limit) {
  now_.refused = Refusal{cause, value, limit, 0};
}

bool MotionAxis::moving() const {
  return active_ != nullptr;
}

double MotionAxis::seconds(std::int64_t ticks) const {
  return static_cast<double>(ticks * config_.period) / 1e9;
}

const char* name(State state) {
  static constexpr std::array<const char*, states> names{
      "disabled", "standstill", "discrete_motion",   "synchronized_motion",
      "stopping", "error_stop", "continuous_motion", "homing"};
  return names[static_cast<std::size_t>(state)];
}

const char* name(Command::Kind kind) {
  static constexpr std::array<const char*, command_kinds> names{"none",
                                                                "enable",
                                                                "disable",
                                                                "arm",
                                                                "disarm",
                                                                "start",
                                                                "stop",
                                                                "abort",
                                                                "reset",
                                                                "set_position",
                                                                "home",
                                                                "hold",
                                                                "resume",
                                                                "override",
                                                                "finish",
                                                                "move_absolute",
                                                                "move_relative",
                                                                "move_additive",
                                                                "move_superimposed",
                                                                "move_velocity",
                                                                "halt",
                                                                "gear_in",
                                                                "gear_out",
                                                                "cam_out"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace jounce
