// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// Returns the sentence of explain(status), completed with the numbers of the rejected move: a
/// value and its bound, or the requested duration and the possible ones.
///
///     const MoveResult move = move_to(from, to, bounds);
///     if (!move) throw std::runtime_error(explain(move.status, from, to, bounds));
///
/// The numbers in the sentence have the units of the arguments.
std::string explain(MoveStatus status, const MotionState& from, const MotionState& to,
                    const Bounds& bounds);

/// Like explain() above, for a move with a required duration, in s.
std::string explain(MoveStatus status, const MotionState& from, const MotionState& to,
                    const Bounds& bounds, double duration);

}  // namespace jounce
