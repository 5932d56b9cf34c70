// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <span>

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

/// The motion at t (s); NaN for a time NaN.
inline Jet jet_at(const Profile& move, double t) {
  if (std::isnan(t)) return {t, t, t, t};
  const Motion now = move.at(t);
  return {now.position, now.velocity, now.acceleration, now.jerk};
}

/// Many moves in one shape, with the status of each.
class Moves {
 public:
  /// Returns the profile of a move, empty where there is none. Several threads may call it.
  using ProfileOf = std::function<Profile(std::size_t)>;

  Moves(Broadcast::Shape shape, std::size_t size, ProfileOf profile);

  [[nodiscard]] const Broadcast::Shape& shape() const { return shape_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Profile profile(std::size_t i) const { return profile_(i); }
  [[nodiscard]] MoveStatus status(std::size_t i) const { return status_[i]; }
  /// s; NaN where there is no move.
  [[nodiscard]] std::span<const double> durations() const { return {durations_.get(), size_}; }

  /// Sets status and duration of a move. Two calls for different moves may run in parallel.
  void set(std::size_t i, MoveStatus status, double duration);

 private:
  Broadcast::Shape shape_;
  std::size_t size_;
  ProfileOf profile_;
  std::unique_ptr<MoveStatus[]> status_;
  std::unique_ptr<double[]> durations_;
};

/// Number of threads of a function for many elements: the argument `threads`. Throws InputError unless it is None (all
/// cores) or at least 1; returns 0 for None.
std::size_t threads_of(std::optional<py::ssize_t> threads);

/// Calls body(first, last) for parts of `size` elements, without the GIL. Many elements are divided among the threads;
/// 0: one for each core.
void in_parts(std::size_t size, std::size_t threads,
              const std::function<void(std::size_t, std::size_t)>& body);

/// The word of a status: "too_short", ...
const char* word(MoveStatus status);

/// Throws MoveError of Python.
[[noreturn]] void raise_move_error(MoveStatus status, const std::string& text);

/// Classes Move and Moves, and their functions.
void bind_move(py::module_& m);
void bind_batches(py::module_& m);

}  // namespace jounce::python
