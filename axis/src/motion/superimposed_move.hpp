// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/moves/profile.hpp"

#include "axis/src/motion/move_plan.hpp"

namespace jounce {

/// A move that is added to the motion of an axis (MC_MoveSuperimposed). It uses the part of the
/// limits that the motion of the axis (the *motion below*) does not need. So the sum of the two
/// motions stays within the limits, whenever the move begins. u is the unit of the axis.
///
///     SuperimposedMove above(config);
///     if (const auto no = above.begin(tick, 5, {.velocity = 20}, below, end)) ...    // rejected
///     above.add_to(setpoint, tick);    // every tick
///     above.clear();                   // another motion has taken over
///
/// The distance of a finished move remains added until clear(). A move that begins during another
/// one begins from the present state of the other one. A SuperimposedMove has a fixed size, and
/// copies are independent. It does not allocate or throw.
class SuperimposedMove {
 public:
  /// `config`: the configuration of the axis.
  explicit SuperimposedMove(const AxisConfig& config) : config_(config) {}

  /// Begins the move in this tick. Returns nullopt, or the reason to reject the move. `distance` is
  /// in u. `below` has the greatest magnitudes of the motion below. `end` is the end position (u)
  /// of the motion below, including the superimposed moves so far; nullopt: unknown.
  std::optional<Refusal> begin(std::int64_t tick, double distance, MoveDynamics dynamics,
                               const Peaks& below, std::optional<double> end) noexcept;
  /// Adds the state of the move in this tick to the setpoint of the motion below. Call once a tick.
  /// Finishes the move at its end.
  void add_to(Setpoint& next, std::int64_t tick) noexcept;

  /// Brings the move to rest from the given tick on (`on` = true), or lets it continue (false). A
  /// tick before the beginning of the move counts as the tick of its beginning. Returns false and
  /// changes nothing if the change is not possible.
  bool hold(bool on, std::int64_t tick) noexcept;
  /// True if the move is held.
  [[nodiscard]] bool held() const noexcept { return held_; }

  /// Removes the move and the distance of finished moves. Call when another motion has taken over.
  void clear() noexcept;
  /// Removes only the distance of finished moves. Call when the motion below includes this
  /// distance.
  void clear_finished() noexcept { finished_ = 0; }

  /// True if a move is in progress.
  [[nodiscard]] bool running() const noexcept { return running_; }
  /// True if the move shifts the setpoint: it is in progress, or the distance of a finished one
  /// remains.
  [[nodiscard]] bool shifts() const noexcept { return running_ || finished_ != 0; }
  /// Distance of finished moves, u.
  [[nodiscard]] double finished() const noexcept { return finished_; }
  /// Distance at the end of the present move, u, including the distance of finished moves.
  [[nodiscard]] double distance() const noexcept {
    return finished_ + (running_ ? goal_.value : 0);
  }
  /// Returns the distance from the given tick to the end of the move, u; 0 if no move is in
  /// progress.
  [[nodiscard]] double remaining(std::int64_t tick) const noexcept;
  /// Dynamics of the move, with their defaults filled in.
  [[nodiscard]] const MoveDynamics& dynamics() const noexcept { return goal_.dynamics; }
  /// Greatest magnitudes that the move may add; 0 if no move is in progress.
  [[nodiscard]] Peaks peaks() const noexcept;

 private:
  [[nodiscard]] double time(std::int64_t tick) const noexcept;
  [[nodiscard]] std::optional<Profile> planned(const Motion& from, const Goal& goal,
                                               double factor) const noexcept;

  AxisConfig config_;
  bool running_ = false;
  bool held_ = false;
  Profile profile_;
  Goal goal_;                // goal, u, relative to the start of the first move in progress
  Limits most_;              // limits that the motion of the axis leaves
  std::int64_t origin_ = 0;  // tick
  double finished_ = 0;      // distance of the finished moves, u
};

}  // namespace jounce
