// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/cam/coupling/coupling.hpp"
#include "jounce/cam/coupling/passing.hpp"

namespace jounce {

/// A slave that was let go: it keeps its velocity (PMC600 manual 6.2, MC_CamOut).
struct Released {
  double t = 0;     ///< s, when
  Profile profile;  ///< profile of its acceleration's end
};

/// Lets a slave go that moves as `slave` does at t: from then on it runs at the velocity it has. With
/// a jerk limit its acceleration fades, and it comes back to that velocity; without, it drops.
Released cam_out(const Jet& slave, double t, std::optional<double> jerk = {});

/// The set-point of a slave that was let go.
Jet point(const Released& released, double t);

/// Result of one cycle.
struct Stepped {
  CouplingStatus status = CouplingStatus::ok;
  Engaged engaged{};     ///< for the next cycle
  Jet slave{};           ///< the set-point: u, u/s, u/s^2, u/s^3
  bool in_sync = false;  ///< nothing is left of the correction
  bool jumped = false;   ///< the master did, by more than master_jump
  int periods = 0;  ///< EndOfProfile: ends of the cam passed since the last cycle, backwards < 0
  double end_time = 0;  ///< s, when the last of them was: (before, now]; backwards, [before, now)
  /// A cam that runs once was left: the slave was let go there, at the very time. Or no correction
  /// could take a jump of the master up: it was let go now, as it moved.
  std::optional<Released> released{};
};

/// One cycle of a coupling: where the slave is now, and what has happened since the last.
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
/// **Master.** For any motion of it, the slave is on its cam, except for the correction: it accelerates by
/// the chain rule, runs backwards along the same cam, and follows the noise of a measured master
/// times the cam's slope. Give a measured master filtered, with the velocity and acceleration of the
/// filter. A master that jumps is announced (`jumped`) where master_jump is set; a slave with a ramp
/// then stays on its way and ramps in again, any other jumps with its master. Where the start mode
/// cannot (`status` has the reason: it would have to reverse, the master stands) `ramp_in` does, and without
/// dynamics for that the coupling ends. While the master is NaN (`not_finite`) the slave
/// stands where it was, and what comes after is a jump.
Stepped step(const Coupling& coupling, const Engaged& engaged, const Sample& now);

/// When a coupling begins, or is exchanged for another.
struct Trigger {
  enum class When : std::uint8_t {
    now,
    period_end,       ///< at the end of the cam that runs, in either direction
    master_position,  ///< when the master passes `position`
  };
  When when = When::now;
  double position = 0;  ///< X, within the cam, in every period of a periodic one
  double window = 0;    ///< m of X; 0: in the very instant; else in the first cycle so near to it
};

/// Throws InputError, key `prefix`_position or `prefix`_window ("engage", "disengage"), for a
/// position outside the cam, or a window that is negative or wider than half of it.
void require_valid(const Trigger& trigger, const Cam& cam, const std::string& prefix);

/// True if the time has come between two cycles.
struct Due {
  CouplingStatus status = CouplingStatus::ok;  ///< window_missed: passed, but by no cycle within
  std::optional<Sample> at{};                  ///< the instant; nothing: not yet
};
Due due(const Trigger& trigger, const Cam& cam, const Placement& placement, const Sample& before,
        const Sample& now);

/// Engages `next` at an instant at which the slave still runs by `running`, from where it has come
/// to: at a period's end a relative cam begins exactly where the other one ends, also if that one
/// is open. The new set-points are the next cycle's: at the instant itself nothing is given out.
Engagement exchange(const Coupling& running, const Engaged& engaged, const Coupling& next,
                    const Sample& at);

}  // namespace jounce
