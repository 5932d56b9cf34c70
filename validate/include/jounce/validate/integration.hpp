// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Outcome of an integration. Only `complete` can be used as a proof.
enum class Ended {
  complete,        ///< the end was reached, in a plausible number of steps
  too_many_steps,  ///< the step count ran out
  not_finite,      ///< the signal, and so the right-hand side, was NaN or infinite
  failed,          ///< the solver gave up; the reason is its own message
};

/// Statistics of an integration. A solver that gives up is an outcome, not an error.
struct Integration {
  Ended ended = Ended::complete;
  double reached = 0;  ///< on the signal's axis; the end of the interval if complete
  long steps = 0;      ///< steps taken
  long restarts = 0;   ///< restarts of the solver, at a jump or an event
  std::string reason;  ///< why not complete, else empty

  [[nodiscard]] bool ok() const { return ended == Ended::complete; }
};

}  // namespace jounce
