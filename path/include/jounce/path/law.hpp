// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// One stretch of a timing law; q is the path parameter. docs/path/README.md describes the two
/// kinds of laws.
/// - In a station law, a stretch is a ramp from v0 to a peak, a cruise at the peak, and a ramp to
///   v1. The acceleration is zero at both ends of the stretch.
/// - In a window law, it is one phase of constant jerk, which begins with v0 and `acceleration`
///   (signed).
/// - A rest (dwell) has length 0 and velocity 0.
struct LawInterval {
  double time = 0;                  ///< s, at its start
  double start = 0;                 ///< q at its start
  double length = 0;                ///< in q
  double v0 = 0, peak = 0, v1 = 0;  ///< q/s: at the start, greatest, at the end
  /// q/s^2, > 0, of the first and of the last ramp. In a window law: the acceleration at the start,
  /// signed, and 0.
  double acceleration = 0, deceleration = 0;
  double jerk = 0;           ///< q/s^3, > 0; signed in a window law
  double duration = 0;       ///< s
  std::uint32_t piece = 0;   ///< index of its first piece of the path
  std::uint32_t pieces = 0;  ///< number of pieces; 0: a rest

  /// True for a phase of constant jerk (window law).
  [[nodiscard]] bool is_phase() const { return pieces > 0 && deceleration == 0; }
};

/// The stretches of a timing law in packed form. A stretch usually begins where the previous one ends, and a corner is
/// passed at the velocity at which the line before it ends: only the numbers that do not follow in this way are stored.
/// No bit is lost. Elements are values, so a reference to one is valid only until its iterator moves.
///
/// **Memory.** A ramp needs 50 bytes and a stretch at constant velocity 10; every eighth stretch needs 32 more.
class LawStretches {
  /// The start of a stretch. It is stored for the first stretch of each block.
  struct Block {
    double time = 0, start = 0, v0 = 0;
    std::uint32_t piece = 0;
    std::uint32_t data = 0;  ///< index of the first number of the stretch
  };

 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = LawInterval;
    using difference_type = std::ptrdiff_t;
    using reference = const LawInterval&;
    using pointer = const LawInterval*;

    Iterator() = default;
    reference operator*() const { return now_; }
    pointer operator->() const { return &now_; }
    Iterator& operator++();
    Iterator operator++(int) {
      Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const { return index_ == other.index_; }
    [[nodiscard]] std::size_t index() const { return index_; }
    /// Time of the next stretch, s; infinite for the last one.
    [[nodiscard]] double next_time() const;

   private:
    friend class LawStretches;
    Iterator(const LawStretches& of, std::size_t index, const Block& start)
        : of_(&of),
          index_(index),
          data_(start.data),
          now_{.time = start.time, .start = start.start, .v0 = start.v0, .piece = start.piece} {
      read();
    }
    void read();

    const LawStretches* of_ = nullptr;
    std::size_t index_ = 0;
    std::uint32_t data_ = 0;  ///< index of the first number of the next stretch
    LawInterval now_;
  };

  /// Numbers that are usually stored of a stretch.
  static constexpr std::size_t numbers_of_ramps = 6, numbers_at_constant_velocity = 1;

  /// Reserves memory for so many stretches with so many stored numbers.
  void reserve(std::size_t stretches, std::size_t numbers);
  void push_back(const LawInterval& s);
  /// Gives memory back that is not used, if it is more than an eighth.
  void shrink();

  [[nodiscard]] std::size_t size() const { return given_.size(); }
  [[nodiscard]] bool empty() const { return given_.empty(); }
  [[nodiscard]] Iterator begin() const { return from(0); }
  [[nodiscard]] Iterator end() const;
  [[nodiscard]] Iterator from(std::size_t index) const;
  /// Returns the stretch at time t: the last one that begins at or before it. `block`: its block.
  [[nodiscard]] Iterator at(double t, std::size_t block) const;
  [[nodiscard]] LawInterval operator[](std::size_t index) const { return *from(index); }
  [[nodiscard]] LawInterval front() const { return *begin(); }
  [[nodiscard]] LawInterval back() const { return *from(size() - 1); }
  /// Time at the end of the last stretch, s; 0 if there is none.
  [[nodiscard]] double end_time() const { return end_.time; }
  /// Returns all stretches.
  [[nodiscard]] std::vector<LawInterval> unpacked() const;
  /// Returns the last stretch for which `begins` is true, or the first one. `begins` is true up to a
  /// stretch, and false after it.
  template <class Begins>
  [[nodiscard]] Iterator last_where(Begins begins) const {
    std::size_t low = 0;
    for (std::size_t high = blocks_.size(); high - low > 1;) {
      const std::size_t middle = low + (high - low) / 2;
      (begins(*from(middle * in_a_block)) ? low : high) = middle;
    }
    Iterator last = from(low * in_a_block);
    for (Iterator next = last; ++next != end() && begins(*next);) last = next;
    return last;
  }

  /// bytes
  [[nodiscard]] std::size_t bytes() const {
    return given_.size() * sizeof(std::uint16_t) + blocks_.size() * sizeof(Block) +
           numbers_.size() * sizeof(double);
  }
  [[nodiscard]] std::size_t numbers() const { return numbers_.size(); }

 private:
  friend class TimingLaw;
  static constexpr std::size_t in_a_block = 8;  ///< stretches

  std::vector<std::uint16_t> given_;  ///< for each stretch, the numbers that are stored
  std::vector<Block> blocks_;
  std::vector<double> numbers_;
  Block end_;  ///< the expected start of the next stretch

  void push_unusual(const LawInterval& s);
};

/// A phase of constant jerk.
struct LawPhase {
  double duration = 0;  ///< s
  double position = 0, velocity = 0, acceleration = 0,
         jerk = 0;  ///< at its start: q from the start of the stretch, q/s, q/s^2, q/s^3
};

/// A timing law: q as a function of time. Piecewise cubic, with continuous acceleration.
class TimingLaw {
 public:
  /// Throws InputError for more than 2^32 - 1 stored numbers.
  explicit TimingLaw(LawStretches stretches);
  explicit TimingLaw(const std::vector<LawInterval>& stretches);

  [[nodiscard]] double duration() const { return stretches_.end_time(); }  ///< s
  [[nodiscard]] const LawStretches& stretches() const { return stretches_; }
  /// Returns q and its derivatives at time t (s) in [0, duration()].
  [[nodiscard]] Motion at(double t) const;
  /// Returns the stretch at time t, s.
  [[nodiscard]] LawStretches::Iterator find(double t) const;
  /// Returns q as a curve over time.
  [[nodiscard]] Trajectory curve() const;
  [[nodiscard]] std::size_t bytes() const {
    return stretches_.bytes() + before_.size() * sizeof(std::uint32_t);
  }

 private:
  [[nodiscard]] std::size_t part_at(double t, std::size_t parts) const;

  LawStretches stretches_;
  /// The duration in equal parts: the number of blocks that begin before each part, and before the
  /// end.
  std::vector<std::uint32_t> before_;
  double parts_per_second_ = 0;
};

/// Writes the phases of a stretch to `out` and returns their number, at most seven. Every phase has
/// a duration.
std::size_t phases(const LawInterval& stretch, std::span<LawPhase, 7> out);

}  // namespace jounce
