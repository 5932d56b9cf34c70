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

/// Friction of a body against the frame: viscous friction and dry friction. With increasing speed
/// w, the dry friction falls from its breakaway value to the Coulomb value (Stribeck):
///
///     T_f = b w + sign(w) (T_c + (T_s - T_c) exp(-(w / w_s)^2)),   |T_f| <= T_s at rest
struct Friction {
  double viscous = 0;            ///< b, N m s/rad, >= 0
  double coulomb = 0;            ///< T_c, N m, >= 0
  double breakaway = 0;          ///< T_s, N m, >= coulomb; 0: the same as coulomb
  double stribeck_velocity = 0;  ///< w_s, rad/s, >= 0; 0: the friction falls at once
};

/// A motor. In the comments below, "0: none" means: if the value is 0, the effect is not modeled,
/// or the quantity is not limited.
struct Motor {
  double inertia = 0;         ///< rotor inertia, kg m^2, > 0
  Friction friction = {};     ///< friction of the rotor
  double torque_limit = 0;    ///< peak torque, N m, > 0
  double rated_torque = 0;    ///< continuous torque, N m; 0: none
  double rated_velocity = 0;  ///< greatest speed with the peak torque, rad/s; 0: none
  /// Speed at which the torque is 0, rad/s, > rated_velocity; from rated_velocity, the torque falls
  /// linearly; 0: none.
  double max_velocity = 0;
  double torque_constant = 0;  ///< N m/A; 0: none
  /// Resistance of the winding, ohm; copper loss = resistance * current^2; requires a
  /// torque_constant; 0: none.
  double resistance = 0;
  /// Thermal time constant of the winding, s, for I2t; requires a rated_torque; 0: none.
  double thermal_time = 0;
  double current_lag = 0;  ///< time constant of the current loop, s; 0: none
};

/// A mass of the drive train. The first mass is connected to the motor, each further mass to the
/// previous one. Damping, backlash and an efficiency below 1 require a stiffness.
struct Mass {
  double stiffness = 0;  ///< stiffness of the shaft or belt to the previous mass, N m/rad; 0: rigid
  double damping = 0;    ///< damping of this shaft or belt, N m s/rad, >= 0
  double backlash = 0;   ///< full gap in this connection, rad, >= 0
  double efficiency = 1;   ///< efficiency of the gear in this connection, above 0 up to 1
  double inertia = 0;      ///< kg m^2, > 0
  Friction friction = {};  ///< friction of this mass
  double load_torque = 0;  ///< constant torque against positive motion, N m
  /// Torque that the weight of a horizontal arm exerts against positive motion, N m.
  double gravity_torque = 0;
  double gravity_angle = 0;  ///< angle of the arm from its hanging position, at position 0, rad
  double gravity_ratio = 1;  ///< turns of the arm for each turn of the motor
};

/// A pendulum at the last mass, such as the load of a crane or a liquid that sloshes. The drive
/// must have a mass. The inertia of the pendulum is a share of the inertia of that mass.
struct Pendulum {
  double frequency = 0;  ///< natural frequency while the pivot is held, Hz, > 0
  double damping = 0;    ///< damping ratio, >= 0
  /// Share of the last mass's inertia that belongs to the pendulum, above 0 and below 1.
  double share = 0;
};

/// A position loop (P) and a velocity loop (PI), with feed-forward of velocity and torque.
///
/// With `cycle` > 0, the controller is sampled. At each multiple of the cycle from the start of the
/// reference, the controller reads the reference and the angle of the motor, rounded to encoder
/// counts. The measured velocity is the difference of the angles over one cycle (0 in the first
/// cycle). After `delay`, the controller outputs the torque, and holds it for a cycle. The integral
/// part uses Euler's rule.
struct Controller {
  double position_gain = 0;          ///< K_p, 1/s, > 0
  double velocity_gain = 0;          ///< K_v, N m s/rad, > 0
  double integral_time = 0;          ///< T_i of the velocity loop, s; 0: no integral part
  double velocity_feed_forward = 1;  ///< share of the reference velocity, >= 0; 1: all of it
  /// Share of the torque for the whole inertia at the reference acceleration, >= 0; 1: all of it.
  double torque_feed_forward = 1;
  /// Share of the torque for viscous and Coulomb friction, >= 0; 1: all of it.
  double friction_feed_forward = 0;
  double cycle = 0;           ///< s; 0: a continuous controller
  double delay = 0;           ///< time from the reading to the output of the torque, s, >= 0
  double encoder_counts = 0;  ///< counts in one turn of the motor; requires a cycle; 0: exact
};

/// A servo axis: a motor, a chain of masses that the motor drives, and a controller. **All values
/// refer to the motor shaft**: for a part behind a gear of ratio i, divide inertia, stiffness and
/// damping by i^2 and torques by i. docs/validate/drive.md and drive_model.cpp contain the
/// equations.
struct Drive {
  Motor motor = {};                       ///< the motor
  std::vector<Mass> train = {};           ///< the masses, from the motor on; empty: a rigid axis
  Controller controller = {};             ///< the controller
  std::optional<Pendulum> pendulum = {};  ///< pendulum at the last mass; nullopt: none
  /// Travel of the axis in one turn of the motor, u (unit of the reference), > 0.
  double position_per_rev = 0;
};

/// Permitted values of a number of a drive. All numbers must be finite.
enum class NumberRule { any, not_negative, positive, share /**< in (0, 1] */ };

/// A number of a drive, with the name by which specs, tolerances and identification refer to it.
struct DriveNumber {
  std::string key = {};     ///< "motor.inertia", "mass[1].stiffness", "motor.friction.coulomb"
  std::string unit = {};    ///< "kg m^2", "u/rev", or "1" for a pure number
  double* value = nullptr;  ///< points into the drive, which must outlive this object
  NumberRule rule = NumberRule::any;  ///< permitted values
};

/// Returns all numbers of a drive. Masses are counted from 1.
std::vector<DriveNumber> numbers(Drive& drive);

/// Returns an example: an axis of the size of a 400 W servo. Its peak torque is 3.8 N m. Its load
/// has five times the inertia of the motor, on a shaft that resonates near 80 Hz if the motor is
/// held. Its loops are tuned by hand. The numbers are round and typical; they do not describe a
/// product. The unit of the position is a degree of the motor shaft.
Drive servo_400w();

/// Returns a motor of the 400 W class with the values of its data sheet: Wittenstein premo SP,
/// stator 2D at 320 V (operating manual 4022-D045530, revision 02, table Tbl-16).
///
/// - Data: inertia 0.83 kg cm^2, stall torque 1.46 N m at 4.04 A, peak torque 5.53 N m, 0.52 N m/A,
///   3.72 ohm between terminals, no-load speed 7023 1/min, greatest power 2.49 kW, thermal time
///   constant 17.4 min.
/// - Derived values: the peak torque is available up to 450 rad/s (power / torque); the copper loss
///   is 1.5 * 3.72 ohm * (rms current)^2.
/// - The drive has no load and no friction, because the data sheet gives none. Its loops are tuned
///   for a load with the inertia of the motor.
///
/// Unit of the position: degrees.
Drive wittenstein_premo_2d();

/// Throws InputError, with the key of the number, for a value that is out of range or that requires
/// another value.
void require_valid(const Drive& drive);

/// Limits for the result of drive_through(), each > 0. A value that is not given is not limited. u
/// is the unit of the reference.
struct DriveLimits {
  std::optional<double> torque = {};           ///< peak torque of the motor, N m
  std::optional<double> rms_torque = {};       ///< rms torque of the motor, N m
  std::optional<double> current = {};          ///< peak current, A; requires a torque_constant
  std::optional<double> velocity = {};         ///< speed of the motor, rad/s
  std::optional<double> following_error = {};  ///< greatest following error, u
  /// Following error at the end of the reference, u.
  std::optional<double> end_following_error = {};
  /// Greatest following error within DriveOptions::sync, u.
  std::optional<double> sync_following_error = {};
  std::optional<double> residual = {};  ///< greatest residual vibration after the end, u
  /// Half of the width of the band around the end position of the reference, u.
  std::optional<double> settling_band = {};
  /// Time until the load stays within the settling band, s; requires the band.
  std::optional<double> settling_time = {};
};

/// An interval of time, s.
struct Interval {
  double from = 0;
  double to = 0;
};

/// Options of drive_through().
struct DriveOptions {
  double settle = 0.2;  ///< standstill after the end of the reference, s, >= 0
  /// Number of samples, equally spaced over reference and standstill; for plots.
  std::size_t samples = 0;
  DriveLimits limits = {};  ///< limits for the findings
  /// Intervals in which the slave is in step; each has from < to and is within the reference.
  std::vector<Interval> sync = {};
  double tolerance = 1e-8;      ///< relative tolerance of the integration, 1e-12 to 1e-3
  long max_steps = 10'000'000;  ///< greatest number of steps of the integration, > 0
  /// True: the reference is one period of a motion without end, such as a cam on a rotating master.
  /// The run is one period of the steady state, without a standstill (`settle` is not used, and
  /// limits that need a standstill are rejected). For linear drives only.
  bool periodic = false;
};

/// Throws InputError for an option out of range. `drive` must be valid. Keys: "settle",
/// "limits.torque", ...
void require_valid(const DriveOptions& options, const Drive& drive);

/// A signed value at the time at which its magnitude is greatest.
struct Peak {
  double value = 0;  ///< the value
  double where = 0;  ///< time, s
};

/// A period in which the torque was at its limit.
struct Saturation {
  double from = 0;  ///< start, s
  double to = 0;    ///< end, s
  int sign = 0;     ///< 1: at the upper limit, -1: at the lower limit
  /// True: the torque at the start was limited by the speed of the motor, to less than the peak
  /// torque.
  bool envelope = false;
};

/// The state of a drive at one instant. Unit u: the unit of the reference.
struct DriveSample {
  double time = 0;             ///< time, s
  double reference = 0;        ///< position of the reference, u
  double motor = 0;            ///< position of the motor, u
  double load = 0;             ///< position of the last mass, u
  double torque = 0;           ///< torque of the motor, N m
  double following_error = 0;  ///< reference - motor, u
  double velocity = 0;         ///< speed of the motor, rad/s
};

/// Energy over the reference and the standstill, J.
struct DriveEnergy {
  double driving = 0;      ///< mechanical work of the motor on the machine, >= 0
  double regenerated = 0;  ///< mechanical work of the machine on the motor, >= 0
  double copper = 0;       ///< loss in the winding; 0 without a resistance
};

/// Result of drive_through(). Unit u: the unit of the reference. The *end* is the end of the
/// reference.
struct DriveResult {
  Integration integration = {};    ///< statistics of the integration
  Peak torque = {};                ///< peak torque of the motor, N m
  double rms_torque = 0;           ///< rms torque, N m, over the reference without the standstill
  Peak current = {};               ///< peak current, A; 0 without a torque_constant
  double rms_current = 0;          ///< rms current, A
  Peak velocity = {};              ///< peak speed of the motor, rad/s
  Peak following_error = {};       ///< greatest following error (reference - motor), u
  double end_following_error = 0;  ///< following error at the end, u
  Peak sync_following_error = {};  ///< greatest following error within DriveOptions::sync, u
  Peak residual = {};              ///< greatest deviation load - reference after the end, u
  double residual_frequency = 0;   ///< frequency of the load's vibration after the end, Hz; 0: none
  /// Time from the end until the load stays within the band, s; nullopt: no band is given, or the
  /// load did not settle.
  std::optional<double> settling_time = {};
  /// Periods in which the following error exceeds its limit, if a limit is given. Their ends are
  /// zeros of the solver's dense output. A period shorter than half a step is detected by the
  /// vertex of a parabola.
  std::vector<Interval> beyond_following_error = {};
  Peak swing = {};  ///< greatest deviation of the pendulum from the load, u
  /// Greatest thermal load h of the winding, which is cold at the start: h' = ((T /
  /// rated_torque)^2 - h) / thermal_time. 1 is the limit.
  Peak i2t = {};
  DriveEnergy energy = {};                  ///< work and loss
  long impacts = 0;                         ///< number of impacts in connections with backlash
  std::vector<Saturation> saturation = {};  ///< periods at the torque limit
  std::vector<DriveSample> samples = {};    ///< samples, if requested
  /// Findings:
  /// - "drive/torque", "drive/rms_torque", "drive/current", "drive/velocity",
  ///   "drive/following_error", "drive/end_following_error", "drive/sync_following_error",
  ///   "drive/residual", "drive/settling_time": for each limit that is given;
  /// - "drive/i2t", "drive/rated_torque" (rms torque), "drive/max_velocity": if the motor has these
  ///   values;
  /// - "drive/saturation": always; broken if the torque reached its limit;
  /// - "drive/stability": broken if the loop is unstable (loop.hpp); otherwise absent;
  /// - "drive/exact": if there are samples and exact_opinion() (linear_drive.hpp) returns a
  ///   finding;
  /// - "drive/integration": if the integration failed. Then a limit that was not exceeded before
  ///   the failure has no finding.
  Report report = {};
};

/// Moves a drive along a reference over time, from rest at its start, then holds the end position
/// of the reference.
///
///     Drive drive = servo_400w();
///     drive.position_per_rev = 10;                                 // mm: a screw of 10 mm pitch
///     const DriveResult run = drive_through(table, drive, {.limits = {.following_error = 0.5}});
///     if (!run.report.ok()) ...
///
/// **Reference.** The signal that the executor interpolates: a Table over time, a Trajectory, or a
/// Followed made from the curve of a table. The axis begins at rest at the first position of the
/// reference, in equilibrium. Constant loads twist the shafts; the integral part (without one, a
/// position error) holds their torque; where there is a gap (backlash), the masses begin in contact,
/// not in the middle. A velocity at the start or end of the reference acts as a step of the
/// velocity.
///
/// **Method.** Saturation, backlash, dry friction and the direction of the power through a gear are
/// modes of the model. The switch from one mode to another is found as a root, and the integration
/// restarts at this root. The thermal load follows from the integral of T^2 in each step; it is
/// exact except for changes of T within a step, which is much shorter than thermal_time.
///
/// **Accuracy.** Motor and load are within 1e-9 of the stroke of the exact solution, the rms torque
/// within 1e-6 of its value. (Tests compare with matrix exponentials; usual errors are 2e-11 of the
/// stroke, or 1e-8 if a move ends before the loop can follow.) Peaks are computed by parabolas
/// through the steps of the solver, within 1e-4 of their value. The frequency is computed from the
/// zeros of the load's velocity, while the vibration is at least 1 % of its peak.
///
/// **Periodic.** One period is integrated from the exact steady state (exact_period() in
/// linear_drive.hpp). The finding "drive/periodic" gives the difference between the end and the
/// start of the period, as a share of the stroke or of the peak torque. The rule is broken if the
/// difference exceeds a hundred tolerances. The rule is also broken if the torque reaches its
/// limit, because the initial state is computed without this limit.
///
/// **Errors.** Throws InputError for a drive, an option or a limit out of range, and for a Table
/// over a master. If `periodic`, also throws for a signal without segments, a nonlinear drive, and
/// a controller with a cycle, and like exact_period(). A failed integration is not an exception:
/// see DriveResult::integration. A periodic run of an unstable loop is also a failed integration,
/// and its only finding is "drive/stability".
DriveResult drive_through(const SignalView& reference, const Drive& drive,
                          const DriveOptions& options = {});

/// Deleted: a Cam is not a motion over time. Combine it with a motion of its master first
/// (Followed).
DriveResult drive_through(const Cam& reference, const Drive& drive,
                          const DriveOptions& options = {}) = delete;

}  // namespace jounce
