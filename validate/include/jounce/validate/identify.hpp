// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// A setpoint that a drive received. Unit u: the unit of the drive's position.
struct RecordedSetpoint {
  double time = 0;          ///< time, s
  double position = 0;      ///< u
  double velocity = 0;      ///< u/s
  double acceleration = 0;  ///< u/s^2
};

/// A recorded run of a drive. Each list has one entry for each sample. Unit u: the unit of the
/// drive's position.
struct Recording {
  std::vector<double> time = {};      ///< time, s, ascending
  std::vector<double> command = {};   ///< commanded position, u
  std::vector<double> position = {};  ///< position of the motor's encoder, u; empty: not recorded
  std::vector<double> velocity = {};  ///< velocity of the motor, u/s; empty: not recorded
  std::vector<double> torque = {};    ///< torque of the motor, N m; empty: not recorded
  /// Position of an encoder at the last mass, u; empty: not recorded.
  std::vector<double> load = {};
  /// All setpoints, ascending, also those without a sample; empty: only `command` is known. The first
  /// one has velocity and acceleration 0, and all samples are between the first and the last one.
  std::vector<RecordedSetpoint> setpoints = {};
};

/// A drive, and the choice of its numbers that are fitted.
struct IdentifySpec {
  Drive drive = {};  ///< start of the fit; the numbers that are not fitted are assumed
                     ///< to be correct
  std::vector<std::string> fit = {};  ///< keys of numbers(): "motor.inertia", "mass[1].stiffness"
  int max_iterations = 50;            ///< greatest number of iterations, >= 1
  double tolerance = 1e-8;            ///< relative tolerance of each integration, 1e-12 to 1e-3
};

/// A number that was fitted. In 95 of 100 recordings its interval contains the true number, if the
/// model is right. If the residuals are correlated over time, the interval allows for this.
struct FittedNumber {
  std::string key = {};   ///< key in numbers()
  std::string unit = {};  ///< unit; "1" for a pure number
  double start = 0;       ///< value at the start of the fit
  double value = 0;       ///< fitted value
  double low = 0;         ///< lower end of the interval
  double high = 0;        ///< upper end of the interval
};

/// Two numbers whose effects in the recording are hardly separable: the estimates depend on each
/// other.
struct Entangled {
  std::string first = {};   ///< key of the first number
  std::string second = {};  ///< key of the second number
  double correlation = 0;   ///< correlation between the logarithms of the two estimates, -1 to 1
};

/// A statistic and its limit. If the model is right, the statistic exceeds the limit in one of a
/// thousand recordings.
struct ResidualTest {
  double value = 0;                                        ///< the statistic
  double limit = std::numeric_limits<double>::infinity();  ///< infinite: not tested

  [[nodiscard]] bool failed() const { return value > limit; }
};

/// Quality of the fit for one recorded quantity. A residual is the recorded value minus the value
/// of the model. Residuals below the resolution of the recording, below the error of the integration,
/// below the error of the interpolation between the recorded commands, or below the effect of the
/// encoder counts on the controller, are not tested.
struct Explained {
  std::string quantity = {};  ///< "position", "velocity", "torque", "load"
  double before = 0;          ///< rms of the residuals at the start of the fit
  double after = 0;  ///< rms of the residuals after the fit: the noise, if the model is right
  /// Correlation of successive residuals; about 0 if the model is right.
  double autocorrelation = 0;
  ResidualTest white = {};  ///< test of whiteness: Q of Ljung and Box
  /// Test of growth: mean square of the last third, divided by the mean square of the first third
  /// (F of Goldfeld and Quandt).
  ResidualTest growth = {};
  /// test of worsening: mean square after the fit, divided by the mean square before the fit
  ResidualTest worsening = {};
  std::vector<double> model = {};  ///< values of the fitted model, one for each sample
};

/// Result of identify().
struct Identification {
  /// Status of a fit.
  enum class Status {
    converged,  ///< the fit is a minimum, all numbers are determined, and the residuals are noise
    misfit,     ///< the fit is a minimum, but the residuals are not white, or grow: the model is
                ///< wrong
    not_identifiable,  ///< the recording does not determine some of the numbers: see `reason`
    stalled,           ///< the greatest number of iterations was reached
    cancelled,         ///< stopped by the progress function
    failed,            ///< the model cannot be integrated at the start of the fit
  };
  Status status = Status::failed;          ///< status
  std::string reason = {};                 ///< reason for the status, one sentence
  Drive drive = {};                        ///< the drive with the fitted numbers
  std::vector<FittedNumber> numbers = {};  ///< the fitted numbers
  /// Inertia (kg m^2) that the torque feed-forward of the recorded controller used; nullopt: it was
  /// not fitted, and that of the spec is assumed.
  std::optional<FittedNumber> feed_forward = {};
  std::vector<Entangled> entangled =
      {};  ///< pairs with a correlation above 0.95, the strongest first
  std::vector<Explained> explained = {};  ///< quality of the fit of each recorded quantity
  /// Sentences for the user, for example on residuals that are not white, or on an unchanged
  /// feed-forward.
  std::vector<std::string> notes = {};
  int iterations = 0;  ///< number of iterations

  /// True if there are fitted numbers.
  [[nodiscard]] bool usable() const {
    return status == Status::converged || status == Status::misfit ||
           status == Status::not_identifiable;
  }
};

/// Returns the name of a status.
const char* name(Identification::Status status);

/// Receives the number of iterations so far, and the rms residual as a share of the rms residual at
/// the start. To stop the fit, return false.
using IdentifyProgress = std::function<bool(int iteration, double share)>;

/// Fits numbers of a drive to a recorded run. The method is weighted least squares of the residuals
/// of all recorded quantities, by Gauss and Newton with the damping of Levenberg and Marquardt;
/// derivatives come from forward sensitivities. docs/validate/identification.md describes the
/// method and its sources.
///
///     const Recording run = read_recording("run.csv", servo_400w(), "mm");
///     Identification found = identify(run, {servo_400w(), {"mass[1].inertia"}});
///     if (found.usable()) drive_through(table, found.drive);
///
/// **Controller.** The fit changes the numbers of the machine, but not the output of the
/// controller. If an inertia is fitted, and torque and motion (position, velocity or load) are
/// recorded, the inertia that the torque feed-forward of the recorded controller used is fitted, too
/// (`feed_forward`), unless the recording then determines fewer numbers. Otherwise it is the one at
/// the start: torque_feed_forward times the inertia of the spec. torque_feed_forward of the result
/// has this torque with the fitted inertia. If friction is fitted, a friction_feed_forward is
/// rejected.
///
/// **Sampled controllers.** A linear drive is computed with its sampled controller, but without
/// the encoder counts, if all samples are at its cycles. Otherwise a continuous controller with one
/// cycle more delay takes its place.
///
/// **Positive numbers.** The logarithm of a number is fitted, so the sign of the number cannot
/// change. Its start must be greater than 0 (for NumberRule::any: not 0) and have the right order
/// of magnitude.
///
/// **Weights.** Each quantity is weighted by the standard deviation of its own noise. The fit
/// estimates this deviation from the residuals, and repeats the estimate until it no longer
/// changes.
///
/// **Reference.** The commanded motion is the curve that the simulated drive of an executor follows
/// between the setpoints (drive_stepper.hpp). Without `setpoints`, it is the cubic spline through the
/// recorded commands, with continuous acceleration, at rest at both ends. Between two samples, the
/// acceleration of the spline has an error of the order (sampling interval / time scale of the
/// motion)^2. If the exact motion is known, use the second function: `reference` has the same time
/// axis as the recording, and the axis is at rest at the start of `reference`.
///
/// **Errors.** Throws InputError for an unknown key (the message lists the valid ones), a number
/// that cannot be fitted or is named twice, an empty `fit`, an option out of range, an invalid
/// recording, setpoints that begin in motion, a recording without position, velocity, torque and
/// load, a reference that is over a master or begins after the first sample, and like
/// require_valid(Drive).
Identification identify(const Recording& recording, const IdentifySpec& spec,
                        const IdentifyProgress& keep_going = {});
Identification identify(const Recording& recording, const SignalView& reference,
                        const IdentifySpec& spec, const IdentifyProgress& keep_going = {});

}  // namespace jounce
