// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/move_plan.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// The move on top of the motion of an axis (MC_MoveSuperimposed). It uses the part of the limits
/// that the motion below leaves, so their sum keeps the limits at any relative phase.
///
///     SuperimposedMove above(config);
///     if (const auto no = above.begin(tick, 5, {.velocity = 20}, below, end)) ...    // rejected
///     above.add_to(setpoint, tick);    // every tick
///     above.clear();                   // another motion has taken over
///
/// The distance of a finished move stays until then. A further one begins from the state of the one
/// in progress. A value type of fixed size; nothing allocates or throws.
class SuperimposedMove {
 public:
  explicit SuperimposedMove(const AxisConfig& config) : config_(config) {}

  /// Begins the move in this tick, or returns the reason to reject it. `below`: the greatest
  /// magnitudes of the motion below. `end`: u, the end of both motions so far; nullopt: unknown.
  std::optional<Refusal> begin(std::int64_t tick, double distance, MoveDynamics dynamics,
                               const Peaks& below, std::optional<double> end) noexcept;
  /// Adds its state in this tick, and finishes it at its end.
  void add_to(Setpoint& next, std::int64_t tick) noexcept;

  /// Brings it to rest from that tick on, or lets it go on; but not before the tick in which it
  /// began. Returns false and changes nothing if that is not possible.
  bool hold(bool on, std::int64_t tick) noexcept;
  [[nodiscard]] bool held() const noexcept { return held_; }

  void clear() noexcept;
  /// Clears the distance of finished moves alone: the motion below now includes it.
  void clear_finished() noexcept { finished_ = 0; }

  [[nodiscard]] bool running() const noexcept { return running_; }
  /// True if it runs, or a finished one has left its distance.
  [[nodiscard]] bool shifts() const noexcept { return running_ || finished_ != 0; }
  [[nodiscard]] double finished() const noexcept { return finished_; }  ///< u
  /// u, at its end, that of finished moves included.
  [[nodiscard]] double distance() const noexcept {
    return finished_ + (running_ ? goal_.value : 0);
  }
  /// u, from that tick to its end; 0: none runs.
  [[nodiscard]] double remaining(std::int64_t tick) const noexcept;
  [[nodiscard]] const MoveDynamics& dynamics() const noexcept { return goal_.dynamics; }
  /// The greatest magnitudes that it may add; 0: none runs.
  [[nodiscard]] Peaks peaks() const noexcept;

 private:
  [[nodiscard]] double time(std::int64_t tick) const noexcept;
  [[nodiscard]] std::optional<Profile> planned(const Motion& from, const Goal& goal,
                                               double factor) const noexcept;

  AxisConfig config_;
  bool running_ = false;
  bool held_ = false;
  Profile profile_;
  Goal goal_;                // u from the start of the first move in progress
  Limits most_;              // limits left by the motion below
  std::int64_t origin_ = 0;  // tick
  double finished_ = 0;      // u
};

}  // namespace jounce
