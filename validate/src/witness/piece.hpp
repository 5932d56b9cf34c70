// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/validate/signal_view.hpp"

namespace jounce::validate_detail {

/// One interval of a signal between two breaks. Every value comes from inside the interval: an
/// integrator that evaluates beyond a break does not see the other side.
struct SignalPiece {
  const SignalView* signal;  ///< the signal
  double begin;              ///< start of the interval
  double end;                ///< end of the interval

  [[nodiscard]] double length() const { return end - begin; }
  /// Returns the signal at x, which is limited to [begin, end]. At both ends, this is the limit
  /// from inside.
  [[nodiscard]] Jet at(double x) const;
};

/// Returns the intervals of a signal, in order, without those that are no longer than `shortest`.
/// The signal must outlive them. Throws InputError if the breaks do not ascend from the signal's
/// start to its end.
std::vector<SignalPiece> pieces(const SignalView& signal, double shortest = 0);

/// The usual size of each quantity of a signal, from its values at the ends of every piece and
/// between them. It is the scale for errors, not a bound.
struct Scales {
  double range = 0;  ///< greatest minus least position
  Jet peak{};        ///< greatest magnitude of position and each derivative
};

/// Returns the scales of a signal.
Scales scales(const std::vector<SignalPiece>& pieces);

}  // namespace jounce::validate_detail
