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

/// Why a drive is not linear: the key of a number that makes it so ("mass[1].backlash"), as numbers()
/// names it; nothing if it is linear. The limits of the motor do not count: a linear drive is solved
/// as if it had none, which holds as long as its torque stays within them.
std::optional<std::string> nonlinearity(const Drive& drive);

/// A mode of the closed loop: one way in which the axis swings or creeps freely.
struct DriveMode {
  double frequency = 0;  ///< Hz, as counted (damped); 0: it creeps
  double damping = 0;    ///< ratio to the critical one; 1 if it creeps; negative: it grows
  double rate = 0;       ///< 1/s, of the decay
  /// Amplitude about its position at the end of the reference, in u at the load: the envelope at
  /// that instant. NaN if two modes are too similar to be separated.
  double residual = 0;
};

/// Exact response of a linear drive to a reference.
struct ExactRun {
  std::vector<DriveSample> samples;  ///< at the requested times
  double rms_torque = 0;             ///< N m, over the reference's duration
  double end_following_error = 0;    ///< u, at the reference's end
};

/// Solves a linear drive along a reference, from rest at its start, like drive_through() but
/// without an integrator:
///
///     const std::vector<double> times = every_millisecond(table);
///     const ExactRun run = exact_run(table, servo_400w(), times);
///     run.samples[250].torque;                                     // N m, at times[250]
///
/// Segments of a curve, polynomials and sines, are outputs of linear systems themselves; the drive
/// and its reference together are z' = M z, solved by exponentials of M (equations at the head of
/// ladder.cpp). A controller with a cycle is solved cycle by cycle, its delay whole or not. No
/// step, no tolerance: the error is rounding, within 1e-11 of the stroke and of the peak torque,
/// 1e-10 with a cycle, as the controller differentiates the angle's last digit (pinned by tests
/// against 30 digits). One second of motion with a thousand outputs takes about 40 us.
///
/// Times ascend, in s on the reference's axis, none before its start; after its end the reference
/// holds. Throws InputError like require_valid(), for a drive that is not linear, for times that do
/// not ascend or begin too early, and for a Table over master position.
ExactRun exact_run(const Trajectory& reference, const Drive& drive, std::span<const double> times);
ExactRun exact_run(const Table& reference, const Drive& drive, std::span<const double> times);

/// The same for an endless reference, such as a cam with a rotating master: one period of the steady
/// state, in which every period is like the one before. The position may advance over a period (a rotary
/// slave); a step of velocity from the period's end to its start is met as such.
///
///     const ExactRun turn = exact_period(period, drive, times);    // times within the period
///
/// Exact as exact_run() is: the start is solved for, x(0) = (I - exp(A T))^-1 c, not waited for
/// (periodic.cpp). The sample at the period's end is the limit from within. Throws InputError like
/// exact_run(), for a controller with a cycle, for times after the period's end, and for loops that
/// do not decay.
ExactRun exact_period(const Trajectory& period, const Drive& drive, std::span<const double> times);

/// The run of drive_through() without an integrator, about ten times as fast: used for the many
/// cases of tolerances and sweeps. Returns nothing if there is no such solution: for a drive that
/// is not linear, for a controller with a cycle, and if the requested torque exceeds the motor's
/// limit at any instant.
///
///     if (const auto run = exact_through(move, drive, {.limits = limits})) use(run->torque);
///
/// Everything in the result except `samples` refers to the whole motion, not to instants. Peaks,
/// the zeros for settling time and frequency, and crossings of a limit are isolated by bounds that
/// hold everywhere (enclosure.cpp), peaks within 1e-11 of their value; work and squared torque are
/// integrals in closed form. Only `i2t` is as in drive_through(): from the mean of T^2 over a step.
/// There is no step size, so `tolerance` affects only the frequency, and `integration` counts the
/// intervals examined. Agrees with drive_through() within 1e-8 in the figures that do not come from
/// parabolas there (pinned by tests).
///
/// Throws InputError like drive_through().
std::optional<DriveResult> exact_through(const Trajectory& reference, const Drive& drive,
                                         const DriveOptions& options = {});

/// All modes of a linear drive whose controller is continuous, fastest last, and the amplitude that
/// the reference leaves in each. Throws InputError like exact_run(), and for a controller with a
/// cycle.
std::vector<DriveMode> free_vibration(const Trajectory& reference, const Drive& drive);

/// The modes alone, nothing left in them.
std::vector<DriveMode> modes(const Drive& drive);

/// A second opinion on a run of drive_through(): the finding "drive/exact", the distance of its samples from
/// the exact solution, as a share of the stroke and of the peak torque, whichever is worse. (A sampled
/// controller differentiates the angle: its share of torque refers to its torque for the whole stroke in
/// one cycle.) Broken beyond a hundred times the tolerance of the run. Nothing for a drive that is not
/// linear, a torque that met its limit, a signal without segments, an integration that failed, a run
/// without samples, and a disagreement in an unstable loop, where rounding grows with the motion.
/// `periodic`: true if the run was a period of the steady state.
std::optional<Finding> exact_opinion(const SignalView& reference, const Drive& drive,
                                     const DriveResult& run, double tolerance = 1e-8,
                                     bool periodic = false);

/// Counters of a response.
enum class DriveOutput {
  torque,           ///< N m, of the motor
  following_error,  ///< u, reference - motor
  load_error,       ///< u, load - reference: after the end, the residual vibration
  load,             ///< u
};

/// The output at given times after the reference's start as a function of the reference: affine in
/// it, so that an optimizer needs it once for every function it composes a shape of. The times
/// ascend from 0; a list of another reference's length is met the same way. Throws InputError as
/// exact_run(), when it is made. `periodic`: as exact_period() has it.
std::function<std::vector<double>(const Trajectory&)> response(const Drive& drive,
                                                               DriveOutput output,
                                                               std::vector<double> times,
                                                               bool periodic = false);

}  // namespace jounce
