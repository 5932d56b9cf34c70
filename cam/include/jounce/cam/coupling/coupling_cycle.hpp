// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/cam/coupling/coupling.hpp"
#include "jounce/cam/coupling/passing.hpp"

namespace jounce {

/// A slave after its release (PMC600 manual 6.2, MC_CamOut): it continues at its velocity. u is the
/// slave's unit.
struct Released {
  double t = 0;          ///< s, time of the release
  Profile profile = {};  ///< motion from the release on, until the acceleration is zero
};

/// Releases a slave at time t (s): it continues at its velocity. `slave` is its position and
/// derivatives with respect to time. With a jerk limit (u/s^3), the acceleration falls to zero, and
/// the slave then returns to the velocity that it had at the release. Without a jerk limit, the
/// acceleration is zero at once.
Released cam_out(const Jet& slave, double t, std::optional<double> jerk = {});

/// Returns the setpoint of a released slave at t (s), and its derivatives with respect to time.
Jet point(const Released& released, double t);

/// Result of one cycle.
struct Stepped {
  /// ok; not_finite; or the reason why the start mode could not ramp in.
  CouplingStatus status = CouplingStatus::ok;
  Engaged engaged{};     ///< state for the next cycle
  Jet slave{};           ///< setpoint: u, u/s, u/s^2, u/s^3
  bool in_sync = false;  ///< true if the correction is complete
  bool jumped = false;   ///< true if the master has jumped by more than master_jump
  /// Number of period ends that the master has passed since the last cycle (EndOfProfile); negative
  /// if the master moves backwards. For a cam that runs once: 1 when the master leaves the cam at
  /// its end, -1 at its start.
  int periods = 0;
  /// s, time of the last of these period ends: in (before, now], or in [before, now) if the master
  /// moves backwards.
  double end_time = 0;
  /// Set if the slave was released. The release is at the exact instant at which the master left a
  /// cam that runs once, or now if no correction could absorb a jump of the master.
  std::optional<Released> released{};
};

/// Computes one cycle of a coupling: the setpoint of the slave, and the events since the last
/// cycle.
///
///     Engaged state = engage(coupling, slave, master(0), 0).engaged;
///     for (double t = 1e-3; ; t += 1e-3) {
///       const Stepped now = step(coupling, state, {t, master(t)});
///       if (now.periods != 0) ...                      // EndOfProfile, at now.end_time
///       state = now.engaged;
///     }
///
/// A pure function; does not allocate. Requires ascending times.
///
/// **Master.** For any motion of the master, the slave is on its cam, except for the correction.
/// The chain rule gives the acceleration of the slave. If the master moves backwards, the slave
/// moves backwards along the same cam. The slave follows the noise of a measured master, multiplied
/// by the slope of the cam.
/// Therefore filter a measured master, and pass the velocity and acceleration of the filter.
///
/// **Jumps of the master.** If master_jump is given, `jumped` reports a jump. A slave with a ramp
/// then continues its motion and ramps in again; any other slave jumps with the master. If the
/// start mode cannot ramp in, because the slave would have to reverse or the master is at rest,
/// ramp_in replaces it and `status` has the reason. If no limits for ramp_in are given, the
/// coupling ends.
///
/// **Invalid master.** While the master is NaN (status `not_finite`), the slave keeps its position.
/// If master_jump is given, the next valid master counts as a jump; otherwise the slave jumps to
/// its cam.
Stepped step(const Coupling& coupling, const Engaged& engaged, const Sample& now);

/// The condition on which a coupling engages, or replaces another one.
struct Trigger {
  enum class When : std::uint8_t {
    now,              ///< at once
    period_end,       ///< at the end of the active cam, in either direction
    master_position,  ///< when the master passes the position `position`
  };
  When when = When::now;
  /// The master's position X on the cam; for a periodic cam, this position in every period.
  double position = 0;
  /// m, for master_position; 0: at the exact instant; > 0: in the first cycle within this distance
  /// of X.
  double window = 0;
};

/// Throws InputError with the key `prefix`_position or `prefix`_window (prefix: "engage",
/// "disengage") if the position of a master_position is outside the cam (both ends are inside), or
/// if the window is negative, NaN or wider than half of the cam.
void require_valid(const Trigger& trigger, const Cam& cam, const std::string& prefix);

/// Result of due().
struct Due {
  /// window_missed: the master passed the window without a cycle in it.
  CouplingStatus status = CouplingStatus::ok;
  std::optional<Sample> at{};  ///< time and master at the instant of the trigger; nullopt: not yet
};
/// Returns the instant between two cycles at which a trigger fires, if it does. If the master is at
/// the position in the present cycle (to 1e-12 of the cam's length), the trigger fires in this
/// cycle.
Due due(const Trigger& trigger, const Cam& cam, const Placement& placement, const Sample& before,
        const Sample& now);

/// Engages `next` at the instant `at`, from the state in which the slave follows `running` at this
/// instant. At the end of a period, a relative cam begins exactly at the end of the previous cam,
/// even if the previous cam does not end at its start position. The function returns no setpoint
/// for the instant itself: the next cycle sends the first new setpoint.
Engagement exchange(const Coupling& running, const Engaged& engaged, const Coupling& next,
                    const Sample& at);

}  // namespace jounce
