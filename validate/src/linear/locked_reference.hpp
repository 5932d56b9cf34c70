// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "validate/src/drive/drive_model.hpp"
#include "validate/src/drive/switches.hpp"
#include "validate/src/witness/piece.hpp"
#include "validate/src/witness/solver.hpp"

namespace jounce::validate_detail {

/// The reference for a solver whose time 0 is the start of the reference. It is locked to one piece
/// at a time.
class LockedReference {
 public:
  /// `before`: the motion of the axis before the first piece.
  LockedReference(double origin, const SignalPiece& first, const Jet& before)
      : origin_(origin), piece_(first), before_(before) {}

  /// Returns the reference at t. Keeps the last result, because right-hand side, Jacobian and
  /// events use the same instants.
  const Jet& at(double t) {
    if (t != asked_) jet_ = piece_.at(origin_ + (asked_ = t));
    return jet_;
  }

  /// Locks the reference to the piece, and notifies solver and switches. Returns true if the solver
  /// must restart: at the start, at a step of the reference, when the solver's own step has become
  /// too long, and when the friction feed-forward changes its sign. At a step of the reference the
  /// deviations step with it: the axis itself continues without a step.
  bool enter(const SignalPiece& piece, const Scales& size, DriveModel& model, Switches& switches,
             OdeSolver& solver);
  /// Stores the values at the end of the piece, from which the next one steps.
  void leave() { before_ = piece_.at(piece_.end); }

 private:
  double origin_;
  SignalPiece piece_;
  Jet before_;
  Jet jet_{};
  double asked_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace jounce::validate_detail
