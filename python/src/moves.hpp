// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/moves/move.hpp"

#include "python/src/numpy/column.hpp"

namespace jounce::python {

/// Bounds whose members are numbers or arrays.
struct BoundsColumns {
  Column velocity_min, velocity_max, acceleration_min, acceleration_max, jerk_min, jerk_max,
      position_min, position_max;

  /// The bounds of one axis. Throws InputError if a member is an array.
  [[nodiscard]] Bounds one() const;
};

/// The state of one axis. Throws InputError (with this key) if a member is an array.
MotionState one(const StateColumns& state, const char* key);

/// Many moves in one shape, with the status of each.
struct Moves {
  Broadcast::Shape shape;
  std::vector<Profile> profiles;   ///< empty profiles where there is no move
  std::vector<MoveStatus> status;  ///< ok where there is one
  std::vector<double> durations;   ///< s; NaN where there is no move
};

/// The word of a status: "too_short", ...
const char* word(MoveStatus status);

/// Throws MoveError of Python.
[[noreturn]] void raise_move_error(MoveStatus status, const std::string& text);

/// Classes Move and Moves, and their functions.
void bind_move(py::module_& m);
void bind_batches(py::module_& m);

}  // namespace jounce::python
