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

/// A run as a drive or a measuring device recorded it: one entry a sample, in step with `time`.
struct Recording {
  std::vector<double> time;           ///< s, ascending
  std::vector<double> command;        ///< u, the commanded position
  std::vector<double> position = {};  ///< u, of the motor's encoder; empty: not recorded
  std::vector<double> velocity = {};  ///< u/s, of the motor; empty: not recorded
  std::vector<double> torque = {};    ///< N m, of the motor; empty: not recorded
  std::vector<double> load = {};      ///< u, of an encoder at the last mass; empty: not recorded
};

/// The commanded motion: the C2 cubic spline through the recorded commands, at rest at both ends. The
/// acceleration between two samples is wrong by order (interval / time scale of the motion)^2.
/// Throws InputError for a recording of fewer than four samples, times that do not ascend, or numbers
/// that are not finite (key "time", "command").
Trajectory commanded_motion(const Recording& recording);

/// Numbers to fit, and their start.
struct IdentifySpec {
  Drive drive;                   ///< the start: every number that is not fitted is believed
  std::vector<std::string> fit;  ///< keys of numbers(Drive&): "motor.inertia", "mass[1].stiffness"
  int max_iterations = 50;       ///< >= 1
  double tolerance = 1e-8;       ///< relative, of each integration, in [1e-12, 1e-3]
};

/// A number that was fitted. The interval holds the true number in 95 of 100 recordings, if the model
/// is right and the noise of one sample does not depend on the noise of others.
struct FittedNumber {
  std::string key;
  std::string unit;
  double start = 0;
  double value = 0;
  double low = 0;
  double high = 0;
};

/// Two numbers that the recording hardly separates: the estimates depend on each other.
struct Entangled {
  std::string first;
  std::string second;
  double correlation = 0;  ///< correlation of the estimates' logarithms, -1 to 1
};

/// A statistic against the value that it exceeds in one of a thousand recordings if the model is right.
struct ResidualTest {
  double value = 0;
  double limit = std::numeric_limits<double>::infinity();  ///< infinite: not tested

  [[nodiscard]] bool failed() const { return value > limit; }
};

/// Quality of the fit of one recorded quantity. A residual not above the recording's own resolution, or the
/// integrator's error, is not tested.
struct Explained {
  std::string quantity;  ///< "position", "velocity", "torque", "load"
  double before = 0;     ///< rms of recorded - model with the start's numbers
  double after = 0;      ///< the same with the fitted ones: the noise, if the model is right
  double autocorrelation =
      0;  ///< autocorrelation of neighboring residuals: about 0 for a model that is right
  ResidualTest white = {};   ///< Ljung and Box's Q
  ResidualTest growth = {};  ///< squares of the last third over the first: Goldfeld and Quandt's F
  ResidualTest worsening = {};     ///< squares after the fit over those before it
  std::vector<double> model = {};  ///< the fitted model's, one for each sample
};

/// Result of identify().
struct Identification {
  enum class Status {
    converged,  ///< the fit is a least one, every number is known and the residuals are noise
    misfit,  ///< the fit is a least one, but residuals are not white, or grow: the model is wrong
    not_identifiable,  ///< the recording does not determine some of the numbers: see reason
    stalled,           ///< iterations ran out
    cancelled,         ///< stopped by the caller
    failed,            ///< the model cannot be integrated with the start's numbers
  };
  Status status = Status::failed;
  std::string reason;  ///< one sentence
  Drive drive;         ///< the drive with the fitted numbers
  std::vector<FittedNumber> numbers;
  std::vector<Entangled> entangled;  ///< correlation above 0.95, strongest first
  std::vector<Explained> explained;
  std::vector<std::string> notes;  ///< sentences: residuals that are not white, feed-forward kept
  int iterations = 0;

  [[nodiscard]] bool usable() const {
    return status == Status::converged || status == Status::misfit ||
           status == Status::not_identifiable;
  }
};

const char* name(Identification::Status status);

/// Between two iterations: how many, and the rms residual over that of the start. False stops.
using IdentifyProgress = std::function<bool(int iteration, double share)>;

/// Fits numbers of a drive to a recorded run: weighted least squares of recorded minus model over
/// everything that was recorded, by Gauss and Newton's method as Levenberg and Marquardt damp it, with
/// derivatives from forward sensitivities. Method and source: docs/validate/identification.md.
///
///     Recording run = ...;                              // time, command, position, torque
///     Identification found = identify(run, commanded_motion(run), {servo_400w(), {"mass[1].inertia"}});
///     if (found.usable()) drive_through(table, found.drive);
///
/// **The controller stays as it was.** The numbers of the machine change, the output of the
/// controller does not: if inertia is fitted, torque_feed_forward of the result gives the same
/// feed-forward torque as the start. A friction_feed_forward is rejected if friction is fitted.
///
/// **Positive numbers.** The logarithm is fitted, so no number can change its sign: the start must
/// be greater than 0 (NumberRule::any: not 0), of the right order of magnitude.
///
/// **Weights.** Each quantity counts by the standard deviation of its own noise, estimated from its
/// residuals and improved until it does not change.
///
/// The axis is at rest at the start of `reference`, which has the time axis of the recording.
/// Throws InputError for an unknown key (the message lists the valid ones), a number that cannot be
/// fitted, a malformed recording, and like require_valid(Drive).
Identification identify(const Recording& recording, const SignalView& reference,
                        const IdentifySpec& spec, const IdentifyProgress& keep_going = {});

}  // namespace jounce
