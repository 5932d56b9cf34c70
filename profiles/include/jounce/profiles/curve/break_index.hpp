// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Finds the interval of ascending breaks that contains a position, in constant time. Curve and
/// Table use it before every evaluation.
///
///     const std::vector<double> breaks{0, 90, 90.5, 360};
///     const BreakIndex index(breaks);
///     std::size_t i = index.find(breaks, 90, Side::right);   // 1: the interval that begins there
///     std::size_t k = index.find(breaks, 90, Side::left);    // 0: the one that ends there
///     std::size_t last = index.find(breaks, 1e9, Side::right);                   // 2: clamped
///
/// **Vocabulary.** The breaks' whole length is cut into equal *cells*, two an interval; the index
/// holds the number of interior breaks in the cells before. It does not keep the breaks, which stay
/// with their owner: 8 bytes an interval, none for up to `few` intervals. At most 2^32 - 1 of them.
///
/// **Intervals** are counted from 0, half-open, [breaks[i], breaks[i + 1]) to the right and
/// (breaks[i], breaks[i + 1]] to the left; positions before or after belong to the first and the
/// last. The answer equals that of a search through all breaks, to the bit, for all breaks: cells
/// with many of them are searched by bisection. Throws only std::bad_alloc.
class BreakIndex {
 public:
  static constexpr std::size_t few = 4;
  static constexpr std::size_t per_interval = 2;

  BreakIndex() = default;
  /// `breaks`: at least two, ascending; the same are given to find().
  explicit BreakIndex(std::span<const double> breaks);

  [[nodiscard]] std::size_t find(std::span<const double> breaks, double x, Side side) const {
    return side == Side::right ? find<Side::right>(breaks, x) : find<Side::left>(breaks, x);
  }

  /// The first interval that reaches into x's cell: at most the interval of x, and seldom far from
  /// it. It needs no read of a break, so a caller can prefetch.
  [[nodiscard]] std::size_t near(double x) const { return before_.empty() ? 0 : before_[cell(x)]; }

 private:
  template <Side side>
  [[nodiscard]] static bool passed(double x, double at) {
    return side == Side::right ? x >= at : x > at;
  }
  template <Side side>
  [[nodiscard]] std::size_t find(std::span<const double> breaks, double x) const;
  [[nodiscard]] std::size_t cell(double x) const;

  double start_ = 0;
  double cells_per_unit_ = 0;
  double last_cell_ = 0;
  std::vector<std::uint32_t> before_;  ///< by cell, and one more; empty: one cell
};

// Every step of cell() ascends with x, rounding included. So a break in a cell before that of x
// lies before x, and only the breaks in x's own cell remain to be compared with it.

inline std::size_t BreakIndex::cell(double x) const {
  const double at = (x - start_) * cells_per_unit_;
  return static_cast<std::size_t>(static_cast<std::int64_t>(
      at < last_cell_ ? (at > 0 ? at : 0) : last_cell_));  // NaN: the last
}

template <Side side>
[[gnu::always_inline]] inline std::size_t BreakIndex::find(std::span<const double> breaks,
                                                           double x) const {
  std::size_t i = 0;
  std::size_t last = breaks.size() - 2;
  if (!before_.empty()) {
    const std::size_t k = cell(x);
    i = before_[k];
    last = before_[k + 1];
  }
  // Without a branch, because random positions go either way: two steps, then seldom more.
  const auto more = [&] { return passed<side>(x, breaks[i + 1]) & (i < last); };
  i += static_cast<std::size_t>(more());
  i += static_cast<std::size_t>(more());
  while (more()) {  // by halves: at least i + 1, at most last
    const std::size_t middle = i + 1 + (last - i) / 2;
    if (passed<side>(x, breaks[middle]))
      i = middle;
    else
      last = middle - 1;
  }
  return i;
}

}  // namespace jounce
