// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Position (u), velocity (u/s) and acceleration (u/s^2) of an axis. u is the axis' unit.
struct MotionState {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;

  bool operator==(const MotionState&) const = default;
};

/// Returns the state of a motion, such as the start of the next move:
///
///     const Bounds axis = within(2, 10, 100);
///     const MoveResult next = move_to(state_of(move.at(0.25)), {.position = 80}, axis);
constexpr MotionState state_of(const Motion& motion) noexcept {
  return {motion.position, motion.velocity, motion.acceleration};
}

/// A motion over time in a compact form of 192 bytes, without memory from the heap. The generators
/// of motions over time return profiles.
///
///     Profile move = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100});
///     double T = move.duration();          // s
///     Motion now = move.at(0.25);          // position, velocity, acceleration, jerk
///     Trajectory curve = move.curve();     // exact, for checks, tables and plots
///
/// **Vocabulary.** A *phase* is a stretch during which the highest derivative of the profile is
/// constant: the jerk (order 3), the acceleration (order 2; it steps between phases), or the
/// velocity (order 1). Phases that do not occur are omitted.
///
/// The motion begins exactly at start() and ends exactly at end(). Either state may be in motion.
/// Outside [0, duration()), at() returns the state at the nearer end, with jerk 0.
class Profile {
 public:
  static constexpr std::size_t capacity = 12;  ///< greatest number of phases

  struct Phase {
    double duration = 0;  ///< > 0, s
    double value = 0;     ///< the highest derivative, signed: u/s^order
  };

  Profile() = default;
  /// A motion without phases, of duration 0; `order` is 1, 2 or 3.
  Profile(const MotionState& start, int order) noexcept
      : start_(start), end_(start), order_(static_cast<std::uint8_t>(order)) {}

  /// Makes a whole motion at once, faster than with add(). Each phase refers to its value by an
  /// index into `values`, counted from 1; index 0 means the value zero. Phases without duration are
  /// omitted. Neighboring phases of equal value stay separate.
  using Values = std::array<double, 4>;
  struct Step {
    double duration;     ///< s
    std::uint8_t value;  ///< index of the value, 0 to 4
  };
  Profile(const MotionState& start, const MotionState& end, int order, const Values& values,
          std::initializer_list<Step> phases) noexcept
      : level_(values), start_(start), end_(end), order_(static_cast<std::uint8_t>(order)) {
    assert(phases.size() <= capacity);
    // Unused entries of duration_ are not read; clearing them (`rep stos`, as GCC would) takes
    // longer than solving for a trapezoid.
    duration_.fill(start.position);
    std::uint8_t n = 0;
    // no branch: which phases occur is unpredictable
    for (const auto& [duration, value] : phases) {
      duration_[n] = duration;
      code_[n] = value;
      n = static_cast<std::uint8_t>(n + (duration > 0 ? 1 : 0));
    }
    count_ = n;
  }

  /// Appends a phase. A phase with duration <= 0 is omitted. A phase with the same value as the
  /// phase before it extends that phase. A profile holds at most `capacity` phases, and at most
  /// four different values besides zero.
  void add(double duration, double value) noexcept { add(duration, value, 0); }
  /// Adds a phase whose value is the sum value + more. The limit of four different values applies
  /// to the terms, not to the sums.
  void add(double duration, double value, double more) noexcept;
  /// Returns this profile with the values of its phases multiplied by a factor, and with the given
  /// start and end.
  [[nodiscard]] Profile scaled(double factor, const MotionState& start,
                               const MotionState& end) const noexcept;
  /// Returns the rest of the motion from time t (s): it begins with the state at t and ends at
  /// end().
  [[nodiscard]] Profile after(double t) const noexcept;
  /// Sets the nominal state at the end of the last phase. At the end, at() and curve() return this
  /// state, so that rounding in the phases has no effect.
  void finish(const MotionState& end) noexcept { end_ = end; }

  /// Order of the highest derivative, 1 to 3.
  [[nodiscard]] int order() const noexcept { return order_; }
  [[nodiscard]] std::size_t phases() const noexcept { return count_; }  ///< number of phases
  [[nodiscard]] Phase phase(std::size_t i) const noexcept {
    return {duration_[i], term(code_[i] % terms) + term(code_[i] / terms)};
  }
  /// Exact states at the start and at the end.
  [[nodiscard]] const MotionState& start() const noexcept { return start_; }
  [[nodiscard]] const MotionState& end() const noexcept { return end_; }
  [[nodiscard]] double duration() const noexcept;  ///< s

  /// Returns the position and its three derivatives at t (s). At a step of the highest derivative,
  /// returns the value after the step. At NaN, all four are NaN.
  [[nodiscard]] Motion at(double t) const noexcept;

  /// Returns this motion as a curve that begins at 0 s and holds outside. Throws InputError if the
  /// duration is 0.
  [[nodiscard]] Trajectory curve() const;

 private:
  static constexpr std::size_t terms = 5;  ///< zero and the four values of Values

  [[nodiscard]] double term(std::size_t i) const noexcept { return i == 0 ? 0 : level_[i - 1]; }
  std::uint8_t term_of(double value) noexcept;

  std::array<double, capacity> duration_{};
  Values level_{};  ///< values of phases, or terms of their sums
  MotionState start_, end_;
  std::array<std::uint8_t, capacity> code_{};  ///< the two terms whose sum is a phase's value
  std::uint8_t count_ = 0;
  std::uint8_t order_ = 3;
};

}  // namespace jounce
