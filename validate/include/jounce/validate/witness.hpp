// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/validate/integration.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

struct WitnessOptions {
  double limit = 1e-10;  ///< greatest relative disagreement, > 0
  /// Accept a step of velocity at a break as declared (a linear table, two lines that meet).
  /// Otherwise it counts as an infinite acceleration, and witness/velocity is broken.
  bool velocity_steps = false;
  double tolerance =
      1e-15;  ///< tolerance of the integration of one interval, relative, in [1e-15, 1e-3]
  long max_steps = 50'000'000;  ///< > 0
};

/// Greatest difference of integral and signal, relative to its tolerance.
struct Disagreement {
  double relative = 0;    ///< |integrated - signal| / scale
  double where = 0;       ///< on the signal's axis
  double integrated = 0;  ///< value of the witness there
  double signal = 0;      ///< value of the signal there
  double scale = 0;       ///< range of the position, or peak of the derivative, over the signal
  double limit = 0;       ///< limit of `relative` there: the option, or rounding if larger
};

struct Witness {
  Integration integration;
  Disagreement position;
  Disagreement velocity;
  Disagreement acceleration;
  /// "witness/position", "witness/velocity", "witness/acceleration", and "witness/integration" if
  /// the integration failed.
  Report report;
};

/// The signal's own witness: its jerk alone, integrated three times by an ODE solver that shares no
/// code with it, compared with the acceleration, velocity and position of the signal.
///
///     const Witness proof = witness(cam);      // a Trajectory, a Cam, a Followed, a Table, ...
///     if (!proof.report.ok()) ...
///
/// Position, velocity and acceleration start from those of the signal and are integrated through
/// the whole interval without a reset: any error grows until the end. At a break only the
/// acceleration takes the step that the signal declares. The comparison covers the left limits at
/// every break and four places between two breaks.
///
/// **What it proves**: that the four columns of the signal are derivatives of each other,
/// everywhere and not only at knots. **It does not prove** that they are the intended motion.
///
/// **Accuracy**: laws, S-curves and cams agree within 1e-12, a followed cam within 2e-11 (pinned by
/// tests). The limit is raised to the rounding of the signal's own values and breaks if that is
/// larger: over n cycles by about (2 pi n)^2 of a rounding. Cost: 20 to 100 steps for each interval
/// between breaks, about 2 us each.
///
/// Throws InputError for an option out of range. Does not throw for a signal that is not finite or
/// an integration that fails: see Witness::integration.
Witness witness(const SignalView& signal, const WitnessOptions& options = {});

}  // namespace jounce
