// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Position, velocity and acceleration of an axis: u, u/s, u/s^2.
struct MotionState {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;

  bool operator==(const MotionState&) const = default;
};

/// A motion in the compact form that the time generators make: 192 bytes, no heap.
///
///     Profile move = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100});
///     double T = move.duration();          // s
///     Motion now = move.at(0.25);          // position, velocity, acceleration, jerk
///     Trajectory curve = move.curve();     // exact, for checks, tables and plots
///
/// **Vocabulary.** A *phase* is a stretch over which the profile's highest derivative is constant:
/// the jerk (order 3), the acceleration (order 2, which then steps between phases), or the velocity
/// (order 1). Phases that do not occur are omitted.
///
/// The motion begins exactly at start() and ends exactly at end(), which need not be at rest.
/// Outside [0, duration] at() returns the state at that end, with jerk 0.
class Profile {
 public:
  static constexpr std::size_t capacity = 12;

  struct Phase {
    double duration = 0;  ///< > 0, s
    double value = 0;     ///< value of the highest derivative, signed: u/s^order
  };

  Profile() = default;
  /// A motion of no duration yet; order 1, 2 or 3.
  Profile(const MotionState& start, int order) noexcept
      : start_(start), end_(start), order_(static_cast<std::uint8_t>(order)) {}

  /// A whole motion at once, the fastest way to make one. The phases give the index of their value
  /// in `values`, from 1; 0 means zero. Phases without duration are omitted; neighbors of the same
  /// value stay separate.
  using Values = std::array<double, 4>;
  struct Step {
    double duration;
    std::uint8_t value;
  };
  Profile(const MotionState& start, const MotionState& end, int order, const Values& values,
          std::initializer_list<Step> phases) noexcept
      : level_(values), start_(start), end_(end), order_(static_cast<std::uint8_t>(order)) {
    assert(phases.size() <= capacity);
    // Not read before they are set. Clearing them (`rep stos`, as GCC would) takes longer than
    // solving for a trapezoid.
    duration_.fill(start.position);
    std::uint8_t n = 0;
    for (const auto& [duration, value] : phases) {  // no branch: whether a phase occurs is random
      duration_[n] = duration;
      code_[n] = value;
      n = static_cast<std::uint8_t>(n + (duration > 0 ? 1 : 0));
    }
    count_ = n;
  }

  /// Appends a phase. A phase without (or with negative) duration is omitted; one with the value of
  /// its predecessor extends it. At most `capacity` phases, and four different values besides zero.
  void add(double duration, double value) noexcept { add(duration, value, 0); }
  /// The same for a value that is a sum: there may be more such values, but only four different
  /// terms.
  void add(double duration, double value, double more) noexcept;
  /// The same phases with their values times a factor, between two other states.
  [[nodiscard]] Profile scaled(double factor, const MotionState& start,
                               const MotionState& end) const noexcept;
  /// The rest of the motion from t on: begins with the state at t, ends where this one ends.
  [[nodiscard]] Profile after(double t) const noexcept;
  /// Nominal end of the last phase: at() and curve() return it there, so that rounding in
  /// the phases does not show.
  void finish(const MotionState& end) noexcept { end_ = end; }

  [[nodiscard]] int order() const noexcept { return order_; }
  [[nodiscard]] std::size_t phases() const noexcept { return count_; }
  [[nodiscard]] Phase phase(std::size_t i) const noexcept {
    return {duration_[i], term(code_[i] % terms) + term(code_[i] / terms)};
  }
  [[nodiscard]] const MotionState& start() const noexcept { return start_; }
  [[nodiscard]] const MotionState& end() const noexcept { return end_; }
  [[nodiscard]] double duration() const noexcept;

  /// The state at t, with its jerk; right-continuous at steps of the highest derivative.
  [[nodiscard]] Motion at(double t) const noexcept;

  /// The same motion as a curve from 0; outside it holds. Throws InputError for a motion of no
  /// duration.
  [[nodiscard]] Trajectory curve() const;

 private:
  static constexpr std::size_t terms = 5;  ///< zero, and the levels

  [[nodiscard]] double term(std::size_t i) const noexcept { return i == 0 ? 0 : level_[i - 1]; }
  std::uint8_t term_of(double value) noexcept;

  std::array<double, capacity> duration_{};
  Values level_{};  ///< level of which phases have one, or the sum of two
  MotionState start_, end_;
  std::array<std::uint8_t, capacity> code_{};  ///< the two terms whose sum is a phase's value
  std::uint8_t count_ = 0;
  std::uint8_t order_ = 3;
};

}  // namespace jounce
