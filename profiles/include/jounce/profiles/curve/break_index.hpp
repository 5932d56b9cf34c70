// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Finds the interval of ascending breaks that contains a position, in nearly constant time. Curve
/// and Table use the index in every evaluation.
///
///     const std::vector<double> breaks{0, 90, 90.5, 360};
///     const BreakIndex index(breaks);
///     std::size_t i = index.find(breaks, 90, Side::right);   // 1: the interval that begins there
///     std::size_t k = index.find(breaks, 90, Side::left);    // 0: the one that ends there
///     std::size_t last = index.find(breaks, 1e9, Side::right);                   // 2: clamped
///
/// **How.** The length from the first to the last break is divided into equal *cells*, two for each
/// interval. The index stores the number of interior breaks before each cell, not the breaks. The
/// index needs 8 bytes for each interval, and no memory for up to `few` intervals. It supports at
/// most 2^32 - 1 breaks.
///
/// **Intervals** are counted from 0. They are half-open: [breaks[i], breaks[i + 1]) for
/// Side::right, (breaks[i], breaks[i + 1]] for Side::left. A position before the first break
/// belongs to the first interval, and a position after the last break to the last interval. The
/// result is exactly the same as from a search through all breaks: find() bisects in a cell with
/// many breaks. Only the constructor throws, and only std::bad_alloc.
class BreakIndex {
 public:
  static constexpr std::size_t few = 4;  ///< up to this number of intervals, no cells are stored
  static constexpr std::size_t per_interval = 2;  ///< cells for each interval

  BreakIndex() = default;
  /// `breaks`: at least two, ascending. Pass the same breaks to find().
  explicit BreakIndex(std::span<const double> breaks);

  /// Returns the index of the interval that contains x. NaN: the last interval.
  [[nodiscard]] std::size_t find(std::span<const double> breaks, double x, Side side) const {
    return side == Side::right ? find<Side::right>(breaks, x) : find<Side::left>(breaks, x);
  }

  /// Returns the index of the first interval that overlaps the cell of x. This index never exceeds
  /// find(x), and is rarely far below it. The function reads no break, so a caller can use the
  /// result to prefetch the breaks.
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
  /// Breaks before each cell, and their total number; empty: one cell.
  std::vector<std::uint32_t> before_;
};

// Every operation of cell() is monotone in x, rounding included. So a break in a cell before the
// cell of x lies before x, and find() compares x only with the breaks in the cell of x.

inline std::size_t BreakIndex::cell(double x) const {
  const double at = (x - start_) * cells_per_unit_;
  return static_cast<std::size_t>(static_cast<std::int64_t>(
      at < last_cell_ ? (at > 0 ? at : 0) : last_cell_));  // NaN: the last cell
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
  // Two steps without a branch, because random positions are unpredictable; more are rarely needed.
  const auto more = [&] { return passed<side>(x, breaks[i + 1]) & (i < last); };
  i += static_cast<std::size_t>(more());
  i += static_cast<std::size_t>(more());
  while (more()) {  // bisection: the result is at least i + 1 and at most last
    const std::size_t middle = i + 1 + (last - i) / 2;
    if (passed<side>(x, breaks[middle]))
      i = middle;
    else
      last = middle - 1;
  }
  return i;
}

}  // namespace jounce
