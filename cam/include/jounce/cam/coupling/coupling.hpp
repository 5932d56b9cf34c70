// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/cam/algebra/correction.hpp"
#include "jounce/cam/design/placement.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Start mode of a slave on its cam (PMC600 manual 6.2, MC_CamIn StartMode and its codes; the last
/// one is CODESYS').
enum class StartMode : std::uint8_t {
  absolute = 0,          ///< at once: it jumps to the position of the cam
  relative = 1,          ///< at once, with the cam shifted to the position of the slave
  ramp_in = 2,           ///< without a jump, by a correction over time within limits
  ramp_in_pos = 3,       ///< the same, with the correction in the positive direction only
                         ///< (tolerance 1e-9 strokes)
  ramp_in_neg = 4,       ///< the same, in the negative direction only
  ramp_in_distance = 5,  ///< without a jump, by a correction over a distance of the master
};
inline constexpr std::size_t start_mode_count = 6;

/// "absolute", "ramp_in_pos", ...: the words of a spec.
const char* name(StartMode mode);

/// Coupling of a slave to its master by a cam: MC_CamTableSelect and MC_CamIn in one. u is the unit
/// of the slave, m that of the master; times are in s. The cam defines its periodicity: `with(cam,
/// Extrapolation::wrap)` is periodic. A cam that holds or rejects runs once. Only a holding cam may
/// be engaged while the master is outside: the slave waits at the cam's end value.
struct CouplingSpec {
  double master_scaling = 1;    ///< > 0
  double master_offset = 0;     ///< m, added after scaling
  double slave_scaling = 1;     ///< > 0; to negate, mirror the cam
  double slave_offset = 0;      ///< u, added after scaling
  bool master_absolute = true;  ///< false: the master's position at the start counts as 0
  bool slave_absolute = true;   ///< false: the cam is shifted to the slave's position at the start
  StartMode start = StartMode::absolute;
  std::optional<double> velocity_diff = {};  ///< u/s, > 0: limit of a correction; ramp_in...
  std::optional<double> acceleration = {};   ///< u/s^2, > 0: at its start; ramp_in...
  std::optional<double> deceleration = {};   ///< u/s^2, > 0: at its end; default: acceleration
  std::optional<double> jerk = {};           ///< u/s^3, > 0; omitted: the acceleration steps
  std::optional<double> distance = {};       ///< m of master travel, > 0; ramp_in_distance
  std::optional<double> slave_period = {};   ///< u, > 0, of a rotary slave; omitted: linear
  /// m, > 0: a master has jumped if it deviates by more than this from the position that its
  /// velocity predicts, or if it becomes valid again after NaN. A slave with a ramp absorbs the
  /// jump by another correction. Omitted: the slave follows the jump.
  std::optional<double> master_jump = {};
};

/// Throws InputError for a number that is not finite or positive, and for a ramp without its
/// parameters: velocity_diff and acceleration, or distance.
void require_valid(const CouplingSpec& spec);

/// Reason why an engagement is impossible, or `ok`.
enum class CouplingStatus : std::uint8_t {
  ok,
  not_finite,          ///< a state, the master or the time is not finite
  master_outside_cam,  ///< the master is outside a cam that permits no position outside
  would_reverse,       ///< ramp_in_pos, ramp_in_neg: a linear slave would have to reverse
  master_stands,  ///< ramp_in_distance: the slave moves, but the master is at rest
  no_ramp,        ///< no correction within the limits: numbers beyond 1e50
  window_missed,  ///< the master passed an engage position without a cycle in its window
};
const char* name(CouplingStatus status);

/// One sentence for a status, for messages.
const char* explain(CouplingStatus status);

/// A cam with its coupling, checked: immutable.
///
///     CouplingSpec spec{.start = StartMode::ramp_in, .velocity_diff = 100, .acceleration = 1000};
///     const Coupling coupling(design(cam_spec).cam, spec);
///     const Jet master{90, 200, 0, 0};                              // at 90 m with 200 m/s
///     if (!check(coupling, {.position = 5}, master).ok()) ...       // would it jump?
///     const Engagement in = engage(coupling, {.position = 5}, master, 0);
///     const Jet slave = point(coupling, in.engaged, {92, 200, 0, 0}, 0.01);
///
/// The slave's setpoint is the cam at its master, plus the remainder of a correction:
///
///     (1)  y(t) = slave_scaling CAM(X(t)) + n advance + origin + c(t),  X = master_scaling x + ...
///
/// c goes from the difference between slave and cam at the start (position, velocity, acceleration)
/// to rest at zero. Nothing jumps for any motion of the master, except when it enters a cam that
/// begins at a velocity. The slave deviates from the cam by at most velocity_diff, acceleration,
/// deceleration and jerk. Origins, the table of modes and the end of a period:
/// docs/cam/coupling.md. Throws InputError like require_valid.
class Coupling {
 public:
  explicit Coupling(Cam cam, const CouplingSpec& spec = {});

  [[nodiscard]] const Cam& cam() const { return cam_; }
  [[nodiscard]] const CouplingSpec& spec() const { return spec_; }
  [[nodiscard]] bool periodic() const { return placement_.periodic; }
  /// True if the cam is shifted to the slave: start = relative, or slave_absolute = false.
  [[nodiscard]] bool slave_relative() const;
  /// Placement while not engaged; for a relative cam, relative to 0.
  [[nodiscard]] const Placement& placement() const { return placement_; }
  /// u, jump of the slave's setpoints at each period's end: the scaled stroke of a period, less
  /// whole slave periods, for an absolute slave; a relative one never jumps there.
  [[nodiscard]] double period_jump() const { return period_jump_; }
  /// Stroke, largest slope and curvature of the slave over the master: u, u/m, u/m^2.
  [[nodiscard]] const Jet& reach() const { return reach_; }

 private:
  Cam cam_;
  CouplingSpec spec_;
  Placement placement_;
  double period_jump_ = 0;
  Jet reach_{};
};

/// The state of a coupling: a small value type. engage() creates it, step() advances it
/// (coupling_cycle.hpp).
struct Engaged {
  Placement placement;
  Correction correction;
  double time = 0;    ///< s, of the last cycle
  Jet master{};       ///< the master at that time
  bool lost = false;  ///< the master is NaN; the slave is at rest
};

struct Engagement {
  CouplingStatus status = CouplingStatus::ok;
  Engaged engaged{};
  MotionState jump{};  ///< step of the setpoints, u, u/s, u/s^2: zero with a ramp

  explicit operator bool() const { return status == CouplingStatus::ok; }
};

/// Couples a slave in the given state to a master that moves as [x, x', x'', x'''] at time t, s.
/// Nothing has moved yet. Does not allocate.
Engagement engage(const Coupling& coupling, const MotionState& slave, const Jet& master, double t);

/// The slave's setpoint, [y, y', y'', y'''] by time. Pure: the same master and time, the same
/// point. `cam` may be the cam itself, or a Table of it. `side` as in placed(): at a seam of the
/// cam, the limit from before or from after. Does not allocate.
template <class C>
Jet point(const C& cam, const Engaged& engaged, const Jet& master, double t,
          Side side = Side::right) {
  Jet y = placed(cam, engaged.placement, master, side);
  const Jet c = engaged.correction.jet(t, master);
  for (std::size_t k = 0; k < y.size(); ++k) y[k] += c[k];
  return y;
}
inline Jet point(const Coupling& coupling, const Engaged& engaged, const Jet& master, double t,
                 Side side = Side::right) {
  return point(coupling.cam(), engaged, master, t, side);
}

/// Checks the result of engage() beforehand. Findings: jumps of position, velocity and acceleration
/// ("coupling/start", broken if there is one), a rejection ("coupling/<status>"), the jump at each
/// period's end ("coupling/period"), a master outside that enters the cam where it moves, so that
/// the velocity of the waiting slave jumps ("coupling/enter"), and the ends of a cam that runs
/// once, if it ends at a velocity (check_ends). For a correction it reports the greatest values,
/// with their derivatives over time or master ("coupling/ramp", not broken: over a distance of the
/// master no limit holds). A jump counts beyond 1e-9 of the slave's range and 1e-12 of its
/// position.
Report check(const Coupling& coupling, const MotionState& slave, const Jet& master);

/// The ends at which a cam that runs once moves, by more than 1e-9 of its greatest slope
/// ("coupling/begin", "coupling/end", not broken): the movement selects the behavior of the slave
/// there (jounce/axis/live_cam.hpp: CamEnd).
Report check_ends(const Cam& cam);

}  // namespace jounce
