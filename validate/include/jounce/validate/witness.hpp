// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/validate/integration.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

/// Options of witness().
struct WitnessOptions {
  double limit = 1e-10;  ///< greatest permitted relative difference, > 0
  /// True: accept a step of the velocity at a break (a linear table, two lines that meet). False:
  /// such a step counts as an infinite acceleration, and the finding witness/velocity is broken.
  bool velocity_steps = false;
  /// Relative tolerance of the integration of one interval, 1e-15 to 1e-3.
  double tolerance = 1e-15;
  long max_steps = 50'000'000;  ///< greatest number of steps, > 0
};

/// Greatest difference between the integral and the signal, as a share of a scale.
struct Disagreement {
  double relative = 0;    ///< |integrated - signal| / scale
  double where = 0;       ///< time or master position of this difference
  double integrated = 0;  ///< value of the integral there
  double signal = 0;      ///< value of the signal there
  double scale = 0;  ///< over the whole signal: range of the position, or peak of the derivative
  /// Limit of `relative` at this place: the greater of the limit of the options and rounding.
  double limit = 0;
};

/// Result of witness().
struct Witness {
  Integration integration = {};    ///< statistics of the integration
  Disagreement position = {};      ///< difference of the position
  Disagreement velocity = {};      ///< difference of the velocity
  Disagreement acceleration = {};  ///< difference of the acceleration
  /// Findings "witness/position", "witness/velocity", "witness/acceleration", and
  /// "witness/integration" if the integration failed.
  Report report = {};
};

/// Verifies a signal by an independent integration: an ODE solver integrates the jerk of the signal
/// three times, and the results are compared with the acceleration, velocity and position of the
/// signal. The integration shares no code with the signal.
///
///     const Witness proof = witness(cam);      // a Trajectory, a Cam, a Followed, a Table, ...
///     if (!proof.report.ok()) ...
///
/// **Method.** The integration begins with position, velocity and acceleration of the signal, and
/// runs through the whole interval without a reset, so any error grows until the end. At a break,
/// only the acceleration gets the step of the signal. The results are compared at the left limit of
/// every break, and at four places between two breaks.
///
/// **What it proves**: position, velocity, acceleration and jerk of the signal are derivatives of
/// each other, everywhere and not only at knots. **It does not prove** that they are the intended
/// motion.
///
/// **Accuracy.** Laws, S-curves and cams agree within 1e-12, a followed cam within 2e-11 (checked
/// by tests). If the rounding of the signal's own values and breaks exceeds the limit, the limit is
/// raised to this rounding: over n cycles, to about (2 pi n)^2 roundings. The integration takes 20
/// to 100 steps for each interval between breaks, about 2 us each.
///
/// **Errors.** Throws InputError for an option out of range. A signal that is not finite, or an
/// integration that fails, does not throw: see Witness::integration.
Witness witness(const SignalView& signal, const WitnessOptions& options = {});

}  // namespace jounce
