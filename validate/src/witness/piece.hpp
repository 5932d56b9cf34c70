// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/validate/signal_view.hpp"

namespace jounce::validate_detail {

/// One interval of a signal between two breaks, locked: every query is answered from inside it, so an
/// integrator that evaluates beyond a break does not see the other side.
struct SignalPiece {
  const SignalView* signal;
  double begin;
  double end;

  [[nodiscard]] double length() const { return end - begin; }
  /// x is held within [begin, end]; near either end the limit from inside is used.
  [[nodiscard]] Jet at(double x) const;
};

/// Returns the intervals of a signal, in order, without those that are no longer than `shortest`.
/// The signal must outlive them. Throws InputError if the breaks do not ascend from the signal's
/// start to its end.
std::vector<SignalPiece> pieces(const SignalView& signal, double shortest = 0);

/// The size of each quantity of a signal, read at the ends of every piece and between them: the
/// scale that errors are measured against, not a bound.
struct Scales {
  double range = 0;  ///< greatest minus least position
  Jet peak{};        ///< greatest magnitude of position and each derivative
};

Scales scales(const std::vector<SignalPiece>& pieces);

}  // namespace jounce::validate_detail
