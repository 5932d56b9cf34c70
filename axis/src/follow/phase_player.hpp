// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// The motion that a phase shift is added to, at the beginning of the shift. u is the unit of the
/// slave, m the unit of its master.
struct PhaseBase {
  /// Greatest magnitudes of the derivatives of the slave with respect to its master: u/m, u/m^2,
  /// u/m^3.
  std::array<double, 3> slopes{};
  Jet master{};  ///< the live master: m, m/s, m/s^2, m/s^3
  Peaks
      other{};  ///< greatest magnitudes of further motions of the slave, such as a superimposed one
};

/// Plays the phase shift of a coupling (MC_PhasingAbsolute, MC_PhasingRelative): a move that is
/// added to the position of the master. With x the master, s the phase shift, and k1, k2, k3 the
/// greatest slopes of the slave over its master, the slave needs at most
///
///     (1)  velocity       k1 w                                     with w = |x'| + |s'|
///     (2)  acceleration   k1 (|x''| + |s''|) + k2 w^2
///     (3)  jerk           k1 (|x'''| + |s'''|) + 3 k2 w (|x''| + |s''|) + k3 w^3
///
/// A shift begins only if these magnitudes, plus those of PhaseBase::other, are within the limits
/// of the axis. They apply to the present motion of the master. A value of the dynamics that is not
/// given is the greatest one that (1) to (3) permit; if the slave has a curved cam, the velocity
/// leaves half of the acceleration limit to the shift itself.
///
///     PhasePlayer phase(config.period);
///     if (const auto no = phase.begin(tick, 5, {.velocity = 20}, base, config)) ...   // rejected
///     const Jet s = phase.at(tick);                                                  // each cycle
///     phase.end();                                                    // the coupling has ended
///
/// A PhasePlayer has a fixed size, and copies are independent. It does not allocate or throw.
class PhasePlayer {
 public:
  /// `period`: duration of a tick, ns.
  explicit PhasePlayer(std::int64_t period) noexcept : period_(period) {}

  /// Begins to shift the phase to `target`, m, in this tick; a shift in progress is replaced.
  /// Returns nullopt, or the reason to reject the shift, with numbers in units of the axis.
  std::optional<Refusal> begin(std::int64_t tick, double target, const MoveDynamics& dynamics,
                               const PhaseBase& base, const AxisConfig& config) noexcept;
  /// Ends the coupling: the phase shift is 0 again.
  void end() noexcept { shifts_ = false; }

  /// Returns the phase shift and its derivatives at `t` s after the tick: m, m/s, m/s^2, m/s^3.
  [[nodiscard]] Jet at(std::int64_t tick, double t = 0) const noexcept;
  /// True if the phase shift has begun, since the beginning of the coupling.
  [[nodiscard]] bool shifts() const noexcept { return shifts_; }
  /// True if the phase shift changes in this tick.
  [[nodiscard]] bool moves(std::int64_t tick) const noexcept;
  /// Returns the greatest magnitudes that the shift adds to the slave; 0 if it does not change.
  [[nodiscard]] Peaks peaks(std::int64_t tick) const noexcept;

 private:
  [[nodiscard]] double time(std::int64_t tick) const noexcept;

  std::int64_t period_;
  bool shifts_ = false;
  Profile profile_;          // m
  std::int64_t origin_ = 0;  // tick of the start
  Peaks added_;              // by the shift in progress: u/s, u/s^2, u/s^3
};

}  // namespace jounce
