#pragma once

#include "jounce/profiles/limits.hpp"
#include "jounce/validate/integration.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

struct WitnessOptions {
  double limit = 1e-10;  ///< greatest relative disagreement, > 0
  /// Take a step of velocity at a break as declared (a linear table, two lines that meet).
  /// Otherwise it is what it is to a machine, an infinite acceleration, and breaks
  /// witness/velocity.
  bool velocity_steps = false;
  double tolerance = 1e-15;     ///< of the integration of one interval, relative, in [1e-15, 1e-3]
  long max_steps = 50'000'000;  ///< > 0
};

/// Where integral and signal differ most, measured by what they may differ there.
struct Disagreement {
  double relative = 0;    ///< |integrated - signal| / scale
  double where = 0;       ///< on the signal's axis
  double integrated = 0;  ///< what the witness says there
  double signal = 0;      ///< what the signal says
  double scale = 0;       ///< range of the position, or peak of the derivative, over the signal
  double limit = 0;       ///< what `relative` may be there: the option, or rounding if larger
};

struct Witness {
  Integration integration;
  Disagreement position;
  Disagreement velocity;
  Disagreement acceleration;
  /// "witness/position", "witness/velocity", "witness/acceleration", and "witness/integration"
  /// where the integration did not end well.
  Report report;
};

/// The signal's own witness: its jerk alone, integrated three times by an ODE solver that shares no
/// code with it, compared with what the signal says of its acceleration, velocity and position.
///
///     const Witness proof = witness(cam);      // a Trajectory, a Cam, a Followed, a Table, ...
///     if (!proof.report.ok()) ...
///
/// Position, velocity and acceleration start from the signal's and are carried through the whole
/// interval, never reset: what is wrong anywhere grows until the end. At a break the acceleration
/// takes the step that the signal declares there, nothing else does. Compared are the left limits
/// at every break and four places between two breaks.
///
/// **What it proves**: that the four columns of the signal are derivatives of each other,
/// everywhere and not only at knots. **What it does not**: that they are the motion that was
/// wanted.
///
/// **Accuracy**: laws, S-curves and cams agree within 1e-12, a followed cam within 2e-11 (pinned by
/// tests). The limit is raised to the rounding of the signal's own values and breaks where that has
/// grown larger: over n cycles by about (2 pi n)^2 of a rounding. Cost: 20 to 100 steps an interval
/// between breaks, some 2 us each.
///
/// Throws InputError for an option out of range. Does not throw for a signal that is not finite or
/// an integration that fails: see Witness::integration.
Witness witness(const SignalView& signal, const WitnessOptions& options = {});

}  // namespace jounce
