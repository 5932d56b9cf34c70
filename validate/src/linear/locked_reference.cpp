// SPDX-License-Identifier: Apache-2.0
#include "validate/src/linear/locked_reference.hpp"

#include "validate/src/linear/course.hpp"

namespace jounce::validate_detail {

bool LockedReference::enter(const SignalPiece& piece, const Scales& size, DriveModel& model,
                            Switches& switches, OdeSolver& solver) {
  piece_ = piece;
  asked_ = std::numeric_limits<double>::quiet_NaN();
  const Jet r = piece.at(piece.begin);
  const bool first = solver.integration().restarts == 0;
  const double cap = longest_step * piece.length();
  const int feed = model.mode().feed;
  solver.limit_step(cap);
  switches.begin(r, size.peak[1]);
  if (!first && !steps(before_, r, size) && !(solver.next_step() > 2 * cap) &&
      feed == model.mode().feed)
    return false;
  model.shift(before_, r, solver.state().data());
  return true;
}

}  // namespace jounce::validate_detail
