// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/cam/algebra/correction.hpp"
#include "jounce/cam/design/placement.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Start mode: the way in which a slave engages with its cam. Values 0 to 4 are the codes of
/// StartMode of MC_CamIn (PMC600 manual 6.2); value 5 is a mode of CODESYS.
enum class StartMode : std::uint8_t {
  absolute = 0,  ///< at once: the slave jumps to the position of the cam
  relative = 1,  ///< at once: the cam is shifted to the position of the slave
  ramp_in = 2,   ///< without a jump: a correction over time, within limits
  /// Like ramp_in, but the correction moves only in the positive direction (within 1e-9 of the
  /// stroke).
  ramp_in_pos = 3,
  ramp_in_neg = 4,       ///< like ramp_in, but the correction moves only in the negative direction
  ramp_in_distance = 5,  ///< without a jump: a correction over a distance of the master
};
inline constexpr std::size_t start_mode_count = 6;  ///< number of start modes

/// Returns the word of a spec: "absolute", "ramp_in_pos", ...
const char* name(StartMode mode);

/// Coupling of a slave to its master by a cam: MC_CamTableSelect and MC_CamIn in one. u is the unit
/// of the slave, m the unit of the master; times are in s. The policy of the cam determines whether
/// it repeats: a cam that wraps or advances is periodic; a cam that holds or refuses runs once. If
/// the master is outside the interval of a cam, the slave can engage only if the cam holds: the
/// slave then waits at the end value of the cam.
struct CouplingSpec {
  double master_scaling = 1;    ///< > 0
  double master_offset = 0;     ///< m, added after scaling
  double slave_scaling = 1;     ///< > 0; for a negative scale, mirror the cam
                                ///< (mirrored_about_slave() in algebra.hpp)
  double slave_offset = 0;      ///< u, added after scaling
  bool master_absolute = true;  ///< false: the master's position at the engagement counts as 0
  bool slave_absolute = true;   ///< false: the cam is shifted to the slave's position at the
                                ///< engagement
  StartMode start = StartMode::absolute;  ///< default: at once, with a jump
  /// u/s, > 0: limit of a correction's velocity; for ramp_in, ramp_in_pos and ramp_in_neg.
  std::optional<double> velocity_diff = {};
  /// u/s^2, > 0: limit while the correction speeds up; for the same modes.
  std::optional<double> acceleration = {};
  /// u/s^2, > 0: limit while the correction slows down; default: acceleration.
  std::optional<double> deceleration = {};
  /// u/s^3, > 0; omitted: no limit, so the acceleration of the correction steps.
  std::optional<double> jerk = {};
  /// m, > 0: length of the correction in master travel; for ramp_in_distance.
  std::optional<double> distance = {};
  /// u, > 0: period of a rotary slave; omitted: the slave is linear.
  std::optional<double> slave_period = {};
  /// m, > 0. The master has jumped if its position differs by more than this distance from the
  /// position that its velocity predicts, or if its position is valid again after NaN. A slave with
  /// a ramp absorbs the jump by another correction. Omitted: the coupling does not detect jumps,
  /// and the slave follows them.
  std::optional<double> master_jump = {};
};

/// Throws InputError if a number is not finite or not positive, or if a parameter of the ramp is
/// missing: ramp_in, ramp_in_pos and ramp_in_neg need velocity_diff and acceleration;
/// ramp_in_distance needs distance.
void require_valid(const CouplingSpec& spec);

/// The reason why an engagement is impossible, or `ok`.
enum class CouplingStatus : std::uint8_t {
  ok,
  not_finite,          ///< a state, the master or the time is not finite
  master_outside_cam,  ///< the master is outside a cam that refuses positions outside
  /// ramp_in_pos, ramp_in_neg: a linear slave would have to move in the other direction.
  would_reverse,
  /// ramp_in_distance: the slave moves, but the master is at rest, or so slow that no correction
  /// exists.
  master_stands,
  no_ramp,  ///< the limits or the state contain numbers beyond 1e50, so no correction exists
  /// The master passed the position of a Trigger (coupling_cycle.hpp), but no cycle was in the
  /// window around this position.
  window_missed,
};
/// Returns the status as a word: "would_reverse", ...
const char* name(CouplingStatus status);

/// Returns one sentence that explains a status to a user.
const char* explain(CouplingStatus status);

/// A cam with its coupling, checked. Immutable.
///
///     CouplingSpec spec{.start = StartMode::ramp_in, .velocity_diff = 100, .acceleration = 1000};
///     const Coupling coupling(design(cam_spec).cam, spec);
///     const Jet master{90, 200, 0, 0};                              // position 90, velocity 200
///     if (!check(coupling, {.position = 5}, master).ok()) ...       // would it jump?
///     const Engagement in = engage(coupling, {.position = 5}, master, 0);
///     const Jet slave = point(coupling, in.engaged, {92, 200, 0, 0}, 0.01);
///
/// The slave's setpoint is the cam at its master, plus the remainder of a correction:
///
///     (1)  y(t) = slave_scaling CAM(X(t)) + n advance + origin + c(t)
///          X(t) = master_scaling x(t) + master_offset
///
/// x is the master position (with master_absolute = false, since the engagement), n the number of
/// whole periods, and `advance` the change of the slave in each period. `origin` is slave_offset
/// or, for a relative cam, the shift to the slave. With the start modes absolute and relative, c is
/// zero, so the slave may jump at the engagement. With the other start modes, c begins at the
/// difference between slave and cam (position, velocity, acceleration) and ends at rest at zero. A
/// correction over time stays within velocity_diff, acceleration, deceleration and jerk; a
/// correction over the master ends after the given distance. So the slave does not jump at the
/// engagement, for any motion of the master. Two jumps remain with every start mode: the velocity
/// jumps when the master enters a cam that begins with a nonzero velocity, and the position jumps
/// by period_jump() at the end of each period. docs/cam/coupling.md describes the origins, the
/// start modes and the end of a period. Throws InputError like require_valid().
class Coupling {
 public:
  explicit Coupling(Cam cam, const CouplingSpec& spec = {});

  [[nodiscard]] const Cam& cam() const { return cam_; }
  [[nodiscard]] const CouplingSpec& spec() const { return spec_; }
  [[nodiscard]] bool periodic() const { return placement_.periodic; }
  /// True if the cam is shifted to the slave: start = relative, or slave_absolute = false.
  [[nodiscard]] bool slave_relative() const;
  /// Placement of the cam before the engagement. For a relative cam, master and slave are assumed
  /// at 0.
  [[nodiscard]] const Placement& placement() const { return placement_; }
  /// Jump of the slave's setpoint at the end of each period, u. For an absolute slave with a cam
  /// that wraps: n slave_period - d. Here d is the last minus the first position of the cam,
  /// scaled, and n is the whole number for which the jump is smallest (without a slave_period: 0).
  /// Otherwise 0.
  [[nodiscard]] double period_jump() const { return period_jump_; }
  /// Width of the range of the slave's position, greatest slope, and greatest second derivative
  /// with respect to the master: u, u/m, u/m^2. The last entry is not used.
  [[nodiscard]] const Jet& reach() const { return reach_; }

 private:
  Cam cam_;
  CouplingSpec spec_;
  Placement placement_;
  double period_jump_ = 0;
  Jet reach_{};
};

/// The state of a coupling. engage() creates it; step() returns the next state
/// (coupling_cycle.hpp). The state is small, and copies are independent.
struct Engaged {
  Placement placement = {};    ///< placement of the cam since the engagement
  Correction correction = {};  ///< present correction
  double time = 0;             ///< s, time of the last cycle
  Jet master{};  ///< position of the master at that time, and its derivatives with respect to time
  bool lost = false;  ///< true while the master is NaN; the slave is then at rest
};

/// Result of engage() and of exchange() (coupling_cycle.hpp).
struct Engagement {
  CouplingStatus status = CouplingStatus::ok;
  Engaged engaged{};   ///< state after the engagement; valid if the status is ok
  MotionState jump{};  ///< step of the setpoints at the engagement: u, u/s, u/s^2; zero with a ramp

  explicit operator bool() const { return status == CouplingStatus::ok; }
};

/// Engages a slave in the given state. `master` is the position of the master and its derivatives
/// with respect to time, at time t (s). Returns the new state; sends no setpoint. Does not
/// allocate.
Engagement engage(const Coupling& coupling, const MotionState& slave, const Jet& master, double t);

/// Returns the setpoint of the slave and its derivatives with respect to time. A pure function of
/// its arguments. `cam` is the cam, or a Table of it. `side` has the meaning of placed(): at the
/// boundary between two periods it selects the limit from before or from after. Does not allocate.
template <class C>
Jet point(const C& cam, const Engaged& engaged, const Jet& master, double t,
          Side side = Side::right) {
  Jet y = placed(cam, engaged.placement, master, side);
  const Jet c = engaged.correction.jet(t, master);
  for (std::size_t k = 0; k < y.size(); ++k) y[k] += c[k];
  return y;
}
/// Like point() above, with the cam of the coupling.
inline Jet point(const Coupling& coupling, const Engaged& engaged, const Jet& master, double t,
                 Side side = Side::right) {
  return point(coupling.cam(), engaged, master, t, side);
}

/// Predicts the result of engage(). Findings:
/// - "coupling/start": jumps of position, velocity and acceleration; broken if there is a jump;
/// - "coupling/<status>": engage() would return this status; broken, and the only finding;
/// - "coupling/period": the jump at the end of each period; broken if there is a jump;
/// - "coupling/enter": for a master outside the cam, the velocity of the cam where the master
///   enters; broken if it is not 0, because the velocity of the waiting slave would jump;
/// - "coupling/end": a cam that runs once ends at a nonzero velocity (see check_ends()); never
///   broken;
/// - "coupling/ramp": the greatest values of a correction and of its derivatives with respect to
///   time or master. Never broken: a correction over the master has no limits.
///
/// A jump counts if it exceeds 1e-9 of the slave's range and 1e-12 of its position.
Report check(const Coupling& coupling, const MotionState& slave, const Jet& master);

/// Reports the ends at which a cam that runs once has a slope greater than 1e-9 of its greatest
/// slope. The rules are "coupling/begin" and "coupling/end"; they are never broken. CamEnd in
/// jounce/axis/live_cam.hpp selects the behavior of the slave at such an end.
Report check_ends(const Cam& cam);

}  // namespace jounce
