// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

// The numbers of the pieces of a path for n axes.
//   line     start[n], step[n]
//   arc      center[n], cosine[n], sine[n], drift[n], phase, sweep:
//            center + cosine cos(phase + sweep s) + sine sin(phase + sweep s) + drift s
//   turn     direction before[n], start[n], share, direction after[n]
//   blend    degree, degree + 1 coefficients an axis by s, deviation, distance from the sides
//   curve    degree, degree + 1 coefficients an axis by s
//
// The turns have an array of their own. The direction after a turn is that before the next one, if it is the same.
//
// A step and a direction keep their digits at any distance of the start from 0.
namespace jounce {

class ArcNumbers {
 public:
  ArcNumbers(const double* data, std::size_t n) : data_(data), n_(n) {}
  static constexpr std::size_t count(std::size_t n) { return 4 * n + 2; }
  [[nodiscard]] double center(std::size_t i) const { return data_[i]; }
  [[nodiscard]] double cosine(std::size_t i) const { return data_[n_ + i]; }
  [[nodiscard]] double sine(std::size_t i) const { return data_[2 * n_ + i]; }
  [[nodiscard]] double drift(std::size_t i) const { return data_[3 * n_ + i]; }
  [[nodiscard]] double phase() const { return data_[4 * n_]; }
  [[nodiscard]] double sweep() const { return data_[4 * n_ + 1]; }

 private:
  const double* data_;
  std::size_t n_;
};

class TurnNumbers {
 public:
  TurnNumbers(const double* data, std::size_t n) : data_(data), n_(n) {}
  static constexpr std::size_t count(std::size_t n) { return 3 * n + 1; }
  [[nodiscard]] double before(std::size_t i) const { return data_[i]; }
  [[nodiscard]] double start(std::size_t i) const { return data_[n_ + i]; }
  [[nodiscard]] double share() const { return data_[2 * n_]; }
  [[nodiscard]] double after(std::size_t i) const { return data_[2 * n_ + 1 + i]; }

 private:
  const double* data_;
  std::size_t n_;
};

/// PathPiece::data of a piece whose numbers are appended next. Path rejects more numbers than it can count.
inline std::uint32_t next_index(const std::vector<double>& numbers) {
  return static_cast<std::uint32_t>(numbers.size());
}

/// Appends `count` numbers.
inline void append(std::vector<double>& numbers, const double* from, std::size_t count) {
  numbers.insert(numbers.end(), from, from + count);
}

/// Appends `count` numbers that are then written in place. A copy of a local array would wait until the processor has
/// stored it.
inline double* append_blank(std::vector<double>& numbers, std::size_t count) {
  const std::size_t size = numbers.size();
  numbers.resize(size + count);
  return numbers.data() + size;
}

/// Appends the n numbers before[n] of a turn, unless they are the direction after the last turn. Returns
/// PathPiece::data of the turn.
inline std::uint32_t append_direction(std::vector<double>& turns, const double* before,
                                      std::size_t n) {
  const std::size_t size = turns.size();
  if (size >= n && std::memcmp(turns.data() + size - n, before, n * sizeof(double)) == 0)
    return static_cast<std::uint32_t>(size - n);
  append(turns, before, n);
  return static_cast<std::uint32_t>(size);
}

inline std::size_t polynomial_count(std::size_t n, int degree) {
  return 1 + n * (static_cast<std::size_t>(degree) + 1);
}

}  // namespace jounce
