// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/validate/integration.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

/// Friction of a body against the frame: viscous, and dry friction that falls from its breakaway
/// value to Coulomb's as the body picks up speed (Stribeck),
///
///     T_f = b w + sign(w) (T_c + (T_s - T_c) exp(-(w / w_s)^2)),   |T_f| <= T_s at rest
struct Friction {
  double viscous = 0;            ///< b, N m s/rad, >= 0
  double coulomb = 0;            ///< T_c, N m, >= 0
  double breakaway = 0;          ///< T_s, N m, >= coulomb; 0: the same as coulomb
  double stribeck_velocity = 0;  ///< w_s, rad/s, >= 0; 0: falls at once
};

/// 0 in a number that is marked with a star: not modelled, or not limited.
struct Motor {
  double inertia = 0;  ///< kg m^2, > 0
  Friction friction = {};
  double torque_limit = 0;     ///< peak, N m, > 0
  double rated_torque = 0;     ///< * N m, continuous torque
  double rated_velocity = 0;   ///< * rad/s, up to which it has its peak torque
  double max_velocity = 0;     ///< * rad/s, at which the torque is 0: a straight line between
  double torque_constant = 0;  ///< * N m/A
  double resistance = 0;       ///< * ohm: copper loss = resistance times current squared
  double thermal_time = 0;     ///< * s, of the winding: I2t
  double current_lag = 0;      ///< * s, time constant of the current loop
};

/// A mass of the drive train behind the one before (the first behind the motor).
struct Mass {
  double stiffness = 0;   ///< stiffness of the shaft or belt to the mass before, N m/rad; 0: rigid
  double damping = 0;     ///< damping of the same, N m s/rad, >= 0
  double backlash = 0;    ///< backlash of the same, rad, the full gap, >= 0
  double efficiency = 1;  ///< efficiency of the gear between, in (0, 1]
  double inertia = 0;     ///< kg m^2, > 0
  Friction friction = {};
  double load_torque = 0;     ///< N m, constant, against positive motion
  double gravity_torque = 0;  ///< N m, of an arm held horizontally, against positive motion
  double gravity_angle = 0;   ///< rad, of the arm from hanging down, at position 0
  double gravity_ratio = 1;   ///< turns of the arm per turn of the motor
};

/// Hung from the last mass, which it is a share of: a hook's load, or a liquid that sloshes.
struct Pendulum {
  double frequency = 0;  ///< Hz, > 0, held at its pivot
  double damping = 0;    ///< ratio to the critical one, >= 0
  double share = 0;      ///< share of the last mass's inertia, in (0, 1)
};

/// Position loop (P), velocity loop (PI), feed-forwards of the reference.
///
/// With a cycle it is sampled: at every k cycle from the start of the run it reads the motor's angle,
/// rounded to encoder counts, and the reference; takes the angle's difference quotient over one
/// cycle as velocity (0 at the first); gives out the torque, held, `delay` later; then integrates
/// (Euler's rule).
struct Controller {
  double position_gain = 0;          ///< K_p, 1/s, > 0
  double velocity_gain = 0;          ///< K_v, N m s/rad, > 0
  double integral_time = 0;          ///< T_i of the velocity loop, s, >= 0; 0: no integral part
  double velocity_feed_forward = 1;  ///< share of the reference's velocity, >= 0; 1: all of it
  double torque_feed_forward = 1;    ///< share of all inertia times acceleration, >= 0; 1: all
  double friction_feed_forward = 0;  ///< share of all viscous and Coulomb friction, >= 0
  double cycle = 0;                  ///< s, >= 0; 0: continuous
  double delay = 0;                  ///< s, >= 0, from reading to torque
  double encoder_counts = 0;         ///< per revolution of the motor, >= 0; 0: exact
};

/// A servo axis: a motor, a chain of masses that it drives, and the controller. **Every value
/// refers to the motor's shaft**: behind a gear of ratio i, divide inertia, stiffness and damping
/// by i^2 and torques by i. The equations are in docs/validate/drive.md and at the head of
/// drive_model.cpp.
struct Drive {
  Motor motor = {};
  std::vector<Mass> train = {};  ///< empty: a rigid axis
  Controller controller = {};
  std::optional<Pendulum> pendulum = {};
  double position_per_rev = 0;  ///< u/rev, > 0: the signal's position unit per motor revolution
};

/// Permitted values of a number of a drive, always finite.
enum class NumberRule { any, not_negative, positive, share /**< in (0, 1] */ };

/// A number of a drive by its name in specs, tolerances and identification.
struct DriveNumber {
  std::string key;          ///< "motor.inertia", "mass[1].stiffness", "motor.friction.coulomb"
  std::string unit;         ///< "kg m^2", "1": a pure number, "u/rev"
  double* value = nullptr;  ///< points into the drive, which must outlive this
  NumberRule rule = NumberRule::any;
};

/// Every number that the drive has; masses are counted from 1.
std::vector<DriveNumber> numbers(Drive& drive);

/// An axis of the size of a 400 W servo: 3.8 N m peak, a load of five times the motor's inertia on
/// a shaft that resonates near 80 Hz against a held motor, loops tuned for it by hand. The numbers
/// are round and of that order of magnitude; they are not a product's data sheet. Unit: degrees of
/// the motor shaft.
Drive servo_400w();

/// A motor of the 400 W class by its data sheet: Wittenstein premo SP, stator 2D at 320 V (operating
/// manual 4022-D045530, revision 02, table Tbl-16): inertia 0.83 kg cm^2, stall torque 1.46 N m at
/// 4.04 A, peak 5.53 N m, 0.52 N m/A, 3.72 ohm between terminals, no-load speed 7023 1/min, greatest
/// power 2.49 kW, thermal time constant 17.4 min. From these: the peak torque is there up to 450 rad/s
/// (power / torque), and copper loss is 1.5 times 3.72 ohm times the square of the rms current. No
/// load, no friction (the sheet gives none); loops for a load of the motor's own inertia. Unit:
/// degrees.
Drive wittenstein_premo_2d();

/// Throws InputError, with the number's key, for a value out of range.
void require_valid(const Drive& drive);

/// Limits of the axis; an omitted value is not limited. All > 0.
struct DriveLimits {
  std::optional<double> torque = {};                ///< N m, peak
  std::optional<double> rms_torque = {};            ///< N m
  std::optional<double> current = {};               ///< A, peak; needs a torque_constant
  std::optional<double> velocity = {};              ///< rad/s, of the motor
  std::optional<double> following_error = {};       ///< u
  std::optional<double> end_following_error = {};   ///< u
  std::optional<double> sync_following_error = {};  ///< u, within DriveOptions::sync
  std::optional<double> residual = {};              ///< u
  std::optional<double> settling_band = {};         ///< u, about the reference's end
  std::optional<double> settling_time = {};  ///< s, until the load stays within; needs the band
};

/// An interval of time, s.
struct Interval {
  double from = 0;
  double to = 0;
};

struct DriveOptions {
  double settle = 0.2;      ///< s of standstill after the reference's end, >= 0
  std::size_t samples = 0;  ///< for plots: equally spaced over reference and standstill
  DriveLimits limits = {};
  std::vector<Interval> sync = {};  ///< intervals in sync; within the reference
  double tolerance = 1e-8;          ///< relative, of the integration, in [1e-12, 1e-3]
  long max_steps = 10'000'000;      ///< > 0
  /// The reference is one period of an endless motion, such as that of a cam with a rotating master: the run is
  /// one period of the steady state, without a standstill (`settle` is not used). For linear drives.
  bool periodic = false;
};

/// The same for options that go with a valid drive: keys "settle", "limits.torque", ...
void require_valid(const DriveOptions& options, const Drive& drive);

/// A signed value at its largest magnitude, and when.
struct Peak {
  double value = 0;
  double where = 0;  ///< s
};

/// The torque stood at its limit over an interval of time, entered and left at these instants.
struct Saturation {
  double from = 0;        ///< s
  double to = 0;          ///< s
  int sign = 0;           ///< 1: at the upper limit, -1: at the lower
  bool envelope = false;  ///< at its start, the motor's speed permitted less than the peak torque
};

struct DriveSample {
  double time = 0;             ///< s
  double reference = 0;        ///< u
  double motor = 0;            ///< u
  double load = 0;             ///< u
  double torque = 0;           ///< N m, of the motor
  double following_error = 0;  ///< u, reference - motor
  double velocity = 0;         ///< rad/s, of the motor
};

/// Work over reference and standstill, J.
struct DriveEnergy {
  double driving = 0;      ///< mechanical, out of the motor, >= 0
  double regenerated = 0;  ///< mechanical, back into the motor, >= 0
  double copper = 0;       ///< lost in the winding, if its resistance is given
};

struct DriveResult {
  Integration integration;
  Peak torque;                     ///< N m
  double rms_torque = 0;           ///< N m, over the reference's duration (the standstill excluded)
  Peak current;                    ///< A, if a torque_constant is given
  double rms_current = 0;          ///< A
  Peak velocity;                   ///< rad/s, of the motor
  Peak following_error;            ///< u, reference - motor
  double end_following_error = 0;  ///< u, at the reference's end
  Peak sync_following_error;       ///< u, within DriveOptions::sync
  Peak residual;                   ///< u, load - reference, after the reference's end
  double residual_frequency = 0;   ///< Hz, of the load after the end; 0: it does not swing
  std::optional<double> settling_time = {};  ///< s after the end; none: no band, or not settled
  /// Intervals with a following error above its limit, if one is given: entered and left at zeros of the
  /// solver's dense output. An excursion and return within half a step is seen by its parabola's vertex.
  std::vector<Interval> beyond_following_error = {};
  Peak swing;  ///< u, pendulum - load
  /// Peak share of the winding's thermal limit, from cold: h' = ((T / rated)^2 - h) / thermal_time.
  Peak i2t;
  DriveEnergy energy;
  long impacts = 0;  ///< number of impacts on a flank of a joint with backlash
  std::vector<Saturation> saturation;
  std::vector<DriveSample> samples;
  /// "drive/torque", "drive/rms_torque", "drive/current", "drive/velocity",
  /// "drive/following_error", "drive/end_following_error", "drive/sync_following_error",
  /// "drive/residual", "drive/settling_time" against the limits given; "drive/i2t",
  /// "drive/rated_torque" (rms) and "drive/max_velocity" if the motor has these; always
  /// "drive/saturation", broken if the torque limit was reached at all; "drive/stability", broken,
  /// if the loop is unstable (loop.hpp); "drive/exact" if there are samples and exact_opinion()
  /// returns a finding; and "drive/integration" if the integration failed: limits not exceeded up
  /// to then have no finding.
  Report report;
};

/// Drives the axis along a reference over time, from rest at its start, then holds its end.
///
///     Drive drive = servo_400w();
///     drive.position_per_rev = 10;                                 // mm: a screw of 10 mm pitch
///     const DriveResult run = drive_through(table, drive, {.limits = {.following_error = 0.5}});
///     if (!run.report.ok()) ...
///
/// The reference is the signal that the executor will interpolate: a Table over time, a Trajectory,
/// a Followed made from a table's curve. The axis begins at rest at the reference's first position,
/// in equilibrium: the constant loads twist the shafts, the integral part (without one, a position
/// error) holds their torque, and no load is in the middle of a gap. A reference that starts or
/// ends moving acts as a step of velocity.
///
/// Saturation, backlash, dry friction and the power's direction through a gear are modes, switched
/// by root finding; the integration restarts at each switch. The thermal share follows from the
/// integral of T^2 step by step, exact except for changes of T within a step much shorter than
/// thermal_time.
///
/// **Accuracy**: motor and load within 1e-9 of the stroke of the exact solution (pinned by tests
/// against matrix exponentials; 2e-11 is usual, 1e-8 if a move ends before the loop can follow),
/// rms torque within 1e-6 of its value. Peaks come from parabolas through the solver's own steps,
/// within 1e-4 of their value. The frequency comes from the zeros of the load's velocity, as long
/// as it swings by at least 1 % of its peak.
///
/// `periodic`: one period is integrated from the exact steady state (exact_period()); the finding
/// "drive/periodic" has the distance of its end from its start, as a share of stroke or peak
/// torque, and is broken beyond a hundred tolerances. It is broken if the torque reaches its limit,
/// because the initial state is that of a stronger motor.
///
/// Throws InputError for a drive, option or limit out of range, for a Table over master position,
/// and, if periodic, for a signal without segments and like exact_period(). A failed integration is
/// no exception: see DriveResult::integration.
DriveResult drive_through(const SignalView& reference, const Drive& drive,
                          const DriveOptions& options = {});

/// A Cam is not a motion over time: give it a master first (Followed).
DriveResult drive_through(const Cam& reference, const Drive& drive,
                          const DriveOptions& options = {}) = delete;

}  // namespace jounce
