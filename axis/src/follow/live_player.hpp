// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"

#include "axis/src/follow/phase_player.hpp"

namespace jounce {

/// Plays a movement that follows a live master. The movement counts time, and the coordinate of the
/// master, from its own start. The player converts between these values and the present values of
/// the axis. It adds the phase shift to the position of the master.
///
///     LivePlayer player(config.period);
///     player.begin(movement, tick);
///     player.shift_master(5);                                        // set_position of the master
///     const Setpoint next = player.at({.t = 0, .master = m}, tick);  // once a tick
///
/// The player does not own the movement. Unit m: the unit of the master.
class LivePlayer {
 public:
  /// `period`: duration of a tick, ns.
  explicit LivePlayer(std::int64_t period) noexcept : period_(period), phase_(period) {}

  /// Begins to play the movement; its time is 0 in this tick. Call Movement::begin() first.
  void begin(Movement& movement, std::int64_t tick) noexcept {
    movement_ = &movement;
    origin_ = tick;
    shift_ = second_shift_ = 0;
    passes_ = 0;
    phase_.end();
  }
  /// Ends the movement, if there is one.
  void end() noexcept {
    movement_ = nullptr;
    phase_.end();
  }
  /// Changes the coordinate of the master, or of the second master, by this distance, m. The slave
  /// does not move.
  void shift_master(double by) noexcept { shift_ += by; }
  void shift_second(double by) noexcept { second_shift_ += by; }
  /// The phase shift of the movement.
  [[nodiscard]] PhasePlayer& phase() noexcept { return phase_; }
  [[nodiscard]] const PhasePlayer& phase() const noexcept { return phase_; }
  /// The sum of these changes since the start of the movement, m.
  [[nodiscard]] double master_shift() const noexcept { return shift_; }

  /// The movement; null: none.
  [[nodiscard]] Movement* movement() const noexcept { return movement_; }
  [[nodiscard]] Movement* operator->() const noexcept { return movement_; }

  /// Returns the setpoint in this tick. `now.t` is in s from the tick. Call once a tick.
  Setpoint at(const Moment& now, std::int64_t tick) noexcept {
    Setpoint next = movement_->at(to_movement(now, tick));
    next.master += shift_;
    return next;
  }

  /// Returns the instant after the previous one and up to `now` at which a pass ends; nullopt if no
  /// pass ends. The time `t` of argument and result is in s from this tick.
  [[nodiscard]] std::optional<Moment> pass_end(const Moment& now,
                                               std::int64_t tick) const noexcept {
    auto at = movement_->pass_end(to_movement(now, tick));
    if (!at) return at;
    at->t -= since(tick);
    add_phase(at->master, -1, tick, at->t);
    at->master[0] += shift_;
    return at;
  }

  /// Adds the events of the follow tables in the last at() to `step`, in times from this tick.
  void add_events(std::int64_t tick, ProfileStep& step) const noexcept {
    for (ProfileEvent event : movement_->events()) {
      event.t -= since(tick);
      event.master += shift_;
      step.add(event);
    }
  }
  /// Adds the end of a pass of a cam, as returned by pass_end(). The position of the master includes
  /// the phase shift, as in the setpoint.
  void add_pass(const Moment& end, std::int64_t tick, ProfileStep& step) noexcept {
    const double phase = phase_.at(tick, end.t)[0];
    step.add({ProfileEvent::Kind::pass_end, ++passes_, end.t, end.master[0] + phase});
  }

 private:
  [[nodiscard]] double since(std::int64_t tick) const noexcept {
    return seconds((tick - origin_) * period_);
  }
  [[nodiscard]] Moment to_movement(Moment now, std::int64_t tick) const noexcept {
    add_phase(now.master, 1, tick, now.t);
    now.t += since(tick);
    now.master[0] -= shift_;
    now.second[0] -= second_shift_;
    return now;
  }
  void add_phase(Jet& master, double sign, std::int64_t tick, double t) const noexcept {
    if (!phase_.shifts()) return;
    const Jet phase = phase_.at(tick, t);
    for (std::size_t k = 0; k < master.size(); ++k) master[k] += sign * phase[k];
  }

  std::int64_t period_;
  Movement* movement_ = nullptr;
  std::int64_t origin_ = 0;  // tick in which the time of the movement is 0
  double shift_ = 0;         // change of the master's coordinate since that tick, m
  double second_shift_ = 0;  // likewise, of the second master
  std::int64_t passes_ = 0;  // number of passes of a cam, since its start
  PhasePlayer phase_;
};

}  // namespace jounce
