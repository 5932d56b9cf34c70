// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/pvt/table.hpp"
#include "jounce/validate/drive.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

/// Returns the key (as in numbers()) of a number that makes the drive nonlinear, such as
/// "mass[1].backlash"; nullopt if the drive is linear. The limits of the motor are ignored: a
/// linear drive is solved without limits, which is correct while the torque is below its limit.
std::optional<std::string> nonlinearity(const Drive& drive);

/// A mode of the closed loop: a free vibration or a free decay of the axis. Unit u: the unit of the
/// reference.
struct DriveMode {
  double frequency = 0;  ///< damped frequency, Hz; 0: no vibration
  double damping = 0;    ///< damping ratio; 1 if there is no vibration; negative: the mode grows
  double rate = 0;       ///< rate of the decay, 1/s
  /// Amplitude (envelope) of the mode at the load, u, at the end of the reference. NaN if two modes
  /// are too similar to be separated.
  double residual = 0;
};

/// Exact response of a linear drive to a reference. Unit u: the unit of the reference.
struct ExactRun {
  std::vector<DriveSample> samples = {};  ///< at the requested times
  double rms_torque = 0;                  ///< rms torque over the reference, N m
  double end_following_error = 0;         ///< following error at the end of the reference, u
};

/// Solves a linear drive along a reference without numerical integration. Like drive_through(), it
/// begins at rest at the start of the reference:
///
///     const std::vector<double> times = every_millisecond(table);
///     const ExactRun run = exact_run(table, servo_400w(), times);
///     run.samples[250].torque;                                     // N m, at times[250]
///
/// **Method.** The segments of a curve, polynomials and sines, are themselves outputs of linear
/// systems. Drive and reference together are a system z' = M z, solved by exponentials of M
/// (ladder.cpp contains the equations). A controller with a cycle is solved cycle by cycle; its
/// delay need not be a multiple of the cycle.
///
/// **Accuracy.** The method has no step size and no tolerance. The error is rounding: up to 1e-11
/// of the stroke and of the peak torque. With a cycle it is 1e-10, because the controller then
/// differentiates the last digit of the angle. (Tests compare with 30 digits.) One second of motion
/// with a thousand outputs takes about 40 us.
///
/// **Times** must ascend, and must not begin before the start of the reference (in s, on its time
/// axis). After its end, the reference holds its last position.
///
/// **Errors.** Throws InputError like require_valid(), for a drive that is not linear, for times
/// that do not ascend or begin too early, and for a Table over a master.
ExactRun exact_run(const Trajectory& reference, const Drive& drive, std::span<const double> times);
ExactRun exact_run(const Table& reference, const Drive& drive, std::span<const double> times);

/// Solves a linear drive for a reference without end, such as a cam on a rotating master. Returns
/// one period of the steady state, in which all periods are equal.
///
///     const ExactRun turn = exact_period(period, drive, times);    // times within the period
///
/// The position may advance over a period (a rotary slave). A step of the velocity from the end of
/// a period to its start is taken into account. The start of the steady state is computed, x(0) =
/// (I - exp(A T))^-1 c, instead of simulating many periods (periodic.cpp). The sample at the end of
/// the period is the limit from within the period. The accuracy is the same as for exact_run().
/// Throws InputError like exact_run(), for a controller with a cycle, for times after the end of
/// the period, and for loops that do not decay.
ExactRun exact_period(const Trajectory& period, const Drive& drive, std::span<const double> times);

/// Returns the result of drive_through() without numerical integration, about ten times as fast.
/// Use it for the many cases of tolerances and sweeps. Returns nullopt if the drive is not linear,
/// if its controller has a cycle, or if the required torque exceeds the limit of the motor at any
/// instant.
///
///     if (const auto run = exact_through(move, drive, {.limits = limits})) use(run->torque);
///
/// All values except `samples` are exact for the whole motion, not only at certain instants. Peaks,
/// crossings of a limit, and the zeros for settling time and frequency are isolated by bounds that
/// hold everywhere (enclosure.cpp); peaks are within 1e-11 of their value. Work and squared torque
/// are integrals in closed form. Only `i2t` is computed as in drive_through(), from the mean of T^2
/// over a step. The method has no step size, so `tolerance` affects only the frequency, and
/// `integration` counts the intervals that were examined. All values agree with drive_through()
/// within 1e-8 (checked by tests), except those that drive_through() computes by parabolas.
///
/// Throws InputError like drive_through(): if `periodic`, also for a drive that is not linear, or a
/// controller with a cycle.
std::optional<DriveResult> exact_through(const Trajectory& reference, const Drive& drive,
                                         const DriveOptions& options = {});

/// Returns all modes of a linear drive with a continuous controller, in ascending order of speed.
/// Each mode has the amplitude that the reference leaves. Throws InputError like exact_run(), and
/// for a controller with a cycle.
std::vector<DriveMode> free_vibration(const Trajectory& reference, const Drive& drive);

/// Returns all modes of a linear drive with a continuous controller; their amplitudes are 0. Throws
/// InputError like free_vibration().
std::vector<DriveMode> modes(const Drive& drive);

/// Compares a run of drive_through() with the exact solution. The finding "drive/exact" gives the
/// greatest difference of the samples, as a share of the stroke or of the peak torque, whichever is
/// larger. The finding is broken if the difference exceeds a hundred times `tolerance`, the
/// tolerance of the run. For a sampled controller, which differentiates the angle, the torque is
/// compared on another scale: the torque that the controller outputs for the whole stroke in one
/// cycle.
///
/// `periodic` is true if the run was a period of the steady state. Returns nullopt for a drive that
/// is not linear, a torque that reached its limit, a signal without segments, a failed integration,
/// and a run without samples. Also returns nullopt for a difference in an unstable loop, where
/// rounding errors grow with the motion.
std::optional<Finding> exact_opinion(const SignalView& reference, const Drive& drive,
                                     const DriveResult& run, double tolerance = 1e-8,
                                     bool periodic = false);

/// An output of a drive. Unit u: the unit of the reference.
enum class DriveOutput {
  torque,           ///< torque of the motor, N m
  following_error,  ///< reference - motor, u
  load_error,       ///< load - reference, u; after the end of the reference: the residual vibration
  load,             ///< position of the load, u
};

/// Returns a function that computes an output at the given times (s after the start, ascending from
/// 0) for any reference, of any duration. The output is an affine function of the reference, so an
/// optimizer needs to compute it only once for each basis function of a shape. `periodic` selects
/// the steady state, as in exact_period(). response() throws InputError like exact_run(), and if
/// `periodic`, for a controller with a cycle. The returned function throws like exact_run() or
/// exact_period().
std::function<std::vector<double>(const Trajectory&)> response(const Drive& drive,
                                                               DriveOutput output,
                                                               std::vector<double> times,
                                                               bool periodic = false);

}  // namespace jounce
