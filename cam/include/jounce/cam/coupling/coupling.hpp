// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/cam/algebra/correction.hpp"
#include "jounce/cam/design/placement.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Start mode of a slave on its cam (PMC600 manual 6.2, MC_CamIn StartMode and its codes; the last one
/// is CODESYS').
enum class StartMode : std::uint8_t {
  absolute = 0,          ///< at once: it jumps to the position of the cam
  relative = 1,          ///< at once, with a cam that is moved to where the slave is
  ramp_in = 2,           ///< without a jump, by a correction over time within limits
  ramp_in_pos = 3,       ///< the same, the correction in the positive direction only (1e-9 strokes
                         ///< of the other one are none)
  ramp_in_neg = 4,       ///< the same, in the negative direction only
  ramp_in_distance = 5,  ///< without a jump, by a correction over a distance of the master
};
inline constexpr std::size_t start_mode_count = 6;

/// "absolute", "ramp_in_pos", ...: the words of a spec.
const char* name(StartMode mode);

/// Coupling of a slave to its master by a cam: MC_CamTableSelect and MC_CamIn in one. u is the
/// unit of the slave, m that of the master; times are in s. Its periodicity is a property of the cam
/// affair: `with(cam, Extrapolation::wrap)` is; one that holds or refuses runs once, and only a holding
/// one may be engaged while the master is outside: the slave waits at the cam's end value.
struct CouplingSpec {
  double master_scaling = 1;    ///< > 0
  double master_offset = 0;     ///< m, added after scaling
  double slave_scaling = 1;     ///< > 0; a negative one: mirror the cam
  double slave_offset = 0;      ///< u, added after scaling
  bool master_absolute = true;  ///< false: the master's position at the start counts as 0
  bool slave_absolute = true;   ///< false: the cam is moved to where the slave is at the start
  StartMode start = StartMode::absolute;
  std::optional<double> velocity_diff = {};  ///< u/s, > 0: most that a correction adds; ramp_in...
  std::optional<double> acceleration = {};   ///< u/s^2, > 0: with which it begins; ramp_in...
  std::optional<double> deceleration = {};   ///< u/s^2, > 0: with which it ends; as acceleration
  std::optional<double> jerk = {};           ///< u/s^3, > 0; left out, its acceleration steps
  std::optional<double> distance = {};       ///< m of master travel, > 0; ramp_in_distance
  std::optional<double> slave_period = {};   ///< u, > 0, of a rotary slave; left out: linear
  /// m, > 0: a master that is further than this from where its velocity puts it has jumped, and a
  /// slave with a ramp takes that up by another correction. So has one that was no number, as soon as
  /// it is one again. Left out: it follows the jump.
  std::optional<double> master_jump = {};
};

/// Throws InputError for a number that is not finite or positive, and for a ramp without what it
/// needs: velocity_diff and acceleration, or distance.
void require_valid(const CouplingSpec& spec);

/// Reason why an engagement is impossible, or `ok`.
enum class CouplingStatus : std::uint8_t {
  ok,
  not_finite,          ///< a state, the master or the time is not finite
  master_outside_cam,  ///< the master is where a refusing cam has no value
  would_reverse,       ///< ramp_in_pos, ramp_in_neg: a linear slave would have to go the other way
  master_stands,  ///< ramp_in_distance: the slave moves, the master that should end that does not
  no_ramp,        ///< no correction within the limits: numbers beyond 1e50
  window_missed,  ///< the master passed an engage position between two cycles, none in its window
};
const char* name(CouplingStatus status);

/// One sentence for a status, for people.
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
/// The slave's set-point is the cam behind its master, and what is left of a correction:
///
///     (1)  y(t) = slave_scaling CAM(X(t)) + n advance + origin + c(t),   X = master_scaling x + ...
///
/// c runs from the difference between slave and cam at the start (position, velocity, acceleration)
/// to rest at zero. So nothing jumps for any motion of the master (except when it enters a cam that begins moving), and the slave deviates from the cam
/// by no more than velocity_diff, acceleration, deceleration and jerk. Origins, the table of modes
/// and what happens at a period's end: docs/cam/coupling.md. Throws InputError as require_valid
/// does.
class Coupling {
 public:
  explicit Coupling(Cam cam, const CouplingSpec& spec = {});

  [[nodiscard]] const Cam& cam() const { return cam_; }
  [[nodiscard]] const CouplingSpec& spec() const { return spec_; }
  [[nodiscard]] bool periodic() const { return placement_.periodic; }
  /// The cam is moved to the slave: start = relative, or slave_absolute = false.
  [[nodiscard]] bool slave_relative() const;
  /// Where it lies while nothing is engaged: relative to 0 where it is relative.
  [[nodiscard]] const Placement& placement() const { return placement_; }
  /// u by which slave set-points jump at each period's end: the scaled stroke of a period, less
  /// whole slave periods, for an absolute slave; a relative one never jumps there.
  [[nodiscard]] double period_jump() const { return period_jump_; }
  /// Stroke, largest slope and curvature as the slave has them over the master: u, u/m, u/m^2.
  [[nodiscard]] const Jet& reach() const { return reach_; }

 private:
  Cam cam_;
  CouplingSpec spec_;
  Placement placement_;
  double period_jump_ = 0;
  Jet reach_{};
};

/// The state of a coupling: small, a value. Made by engage(), carried on by step()
/// (coupling_cycle.hpp).
struct Engaged {
  Placement placement;
  Correction correction;
  double time = 0;    ///< s, of the last cycle
  Jet master{};       ///< then
  bool lost = false;  ///< the master has been no number since; the slave stands
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

/// The slave's set-point, [y, y', y'', y'''] by time. Pure: the same master and time, the same
/// point. `cam` may be the cam itself, or a Table of it. The side as in placed(): at a seam of the
/// cam, where the slave came from or where it goes on. Does not allocate.
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

/// Checks the result of engage() beforehand: jumps of position, velocity and acceleration
/// ("coupling/start", broken where there is one), a refusal ("coupling/<status>"), the jump at each
/// period's end ("coupling/period"), a master outside that comes in where the cam moves, which a slave
/// that waits at rest cannot without a jump in velocity ("coupling/enter"), and the ends of a cam that
/// runs once, where it ends moving (check_ends). For a correction it reports the greatest values, with their derivatives over time or master ("coupling/ramp", not
/// broken: over a distance of the master no limit holds). A jump counts beyond 1e-9 of the slave's range and
/// 1e-12 of its position.
Report check(const Coupling& coupling, const MotionState& slave, const Jet& master);

/// The ends at which a cam that runs once moves, by more than 1e-9 of its greatest slope ("coupling/begin",
/// "coupling/end", not broken): what becomes of the slave there is its player's choice (jounce/axis/live_cam.hpp: CamEnd).
Report check_ends(const Cam& cam);

}  // namespace jounce
