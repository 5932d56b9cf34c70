// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Status at the end of an integration. Only a complete integration is a proof.
enum class Ended {
  complete,        ///< the end was reached, in a plausible number of steps
  too_many_steps,  ///< the greatest number of steps was reached
  not_finite,      ///< the signal was NaN or infinite
  failed,          ///< the solver gave up; its message is the reason
};

/// Statistics of an integration. A solver that gives up is reported in this result; it does not
/// throw.
struct Integration {
  Ended ended = Ended::complete;  ///< status at the end
  /// Time or master position that was reached; the end of the interval if complete.
  double reached = 0;
  long steps = 0;           ///< number of steps
  long restarts = 0;        ///< number of restarts of the solver, at a jump or an event
  std::string reason = {};  ///< reason why the integration is not complete; "" if it is complete

  /// True if the integration is complete.
  [[nodiscard]] bool ok() const { return ended == Ended::complete; }
};

}  // namespace jounce
