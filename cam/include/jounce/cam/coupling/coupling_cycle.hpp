// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/cam/coupling/coupling.hpp"
#include "jounce/cam/coupling/passing.hpp"

namespace jounce {

/// A released slave: it keeps its velocity (PMC600 manual 6.2, MC_CamOut).
struct Released {
  double t = 0;     ///< s, time of the release
  Profile profile;  ///< profile of its remaining acceleration
};

/// Releases a slave that moves as `slave` at t: it keeps its velocity. With a jerk limit its
/// acceleration fades, and it returns to that velocity; without one, the acceleration drops to 0.
Released cam_out(const Jet& slave, double t, std::optional<double> jerk = {});

/// The setpoint of a released slave.
Jet point(const Released& released, double t);

/// Result of one cycle.
struct Stepped {
  CouplingStatus status = CouplingStatus::ok;
  Engaged engaged{};     ///< for the next cycle
  Jet slave{};           ///< the setpoint: u, u/s, u/s^2, u/s^3
  bool in_sync = false;  ///< the correction is complete
  bool jumped = false;   ///< the master jumped by more than master_jump
  int periods = 0;  ///< EndOfProfile: ends of the cam passed since the last cycle; backwards: < 0
  double end_time = 0;  ///< s, time of the last of them: (before, now]; backwards, [before, now)
  /// Set when the slave was released: at the exact instant at which the master left a cam that runs
  /// once, or now, if no correction could absorb a jump of the master.
  std::optional<Released> released{};
};

/// One cycle of a coupling: the setpoint of the slave, and the events since the last cycle.
///
///     Engaged state = engage(coupling, slave, master(0), 0).engaged;
///     for (double t = 1e-3; ; t += 1e-3) {
///       const Stepped now = step(coupling, state, {t, master(t)});
///       if (now.periods != 0) ...                      // EndOfProfile, at now.end_time
///       state = now.engaged;
///     }
///
/// Pure, and does not allocate. The samples' times ascend.
///
/// **Master.** For any motion of the master, the slave is on its cam, except for the correction. It
/// accelerates by the chain rule, runs backwards along the same cam, and follows the noise of a
/// measured master times the cam's slope. Filter a measured master, and pass the velocity and
/// acceleration of the filter. With master_jump, `jumped` reports a jump of the master. A slave
/// with a ramp then keeps its motion and ramps in again; any other slave jumps with its master. If
/// the start mode cannot ramp in (`status` has the reason: it would have to reverse, the master is
/// at rest), `ramp_in` does; without dynamics for that, the coupling ends. While the master is NaN
/// (`not_finite`), the slave keeps its position, and the next valid master counts as a jump.
Stepped step(const Coupling& coupling, const Engaged& engaged, const Sample& now);

/// Start condition of a coupling, or of its exchange for another.
struct Trigger {
  enum class When : std::uint8_t {
    now,
    period_end,       ///< at the end of the active cam, in either direction
    master_position,  ///< when the master passes `position`
  };
  When when = When::now;
  double position = 0;  ///< X, within the cam, in every period of a periodic one
  double window = 0;    ///< m of X; 0: at that very instant; otherwise the first cycle within it
};

/// Throws InputError, key `prefix`_position or `prefix`_window ("engage", "disengage"), for a
/// position outside the cam, or a window that is negative or wider than half of it.
void require_valid(const Trigger& trigger, const Cam& cam, const std::string& prefix);

/// Result of a trigger between two cycles.
struct Due {
  CouplingStatus status = CouplingStatus::ok;  ///< window_missed: passed without a cycle in it
  std::optional<Sample> at{};                  ///< the instant; nullopt: not yet
};
Due due(const Trigger& trigger, const Cam& cam, const Placement& placement, const Sample& before,
        const Sample& now);

/// Engages `next` at an instant at which the slave still follows `running`, from its present state.
/// At a period's end a relative cam begins exactly at the end of the previous one, even if that one
/// is open. The next cycle outputs the first new setpoint; there is no output at the instant
/// itself.
Engagement exchange(const Coupling& running, const Engaged& engaged, const Coupling& next,
                    const Sample& at);

}  // namespace jounce
