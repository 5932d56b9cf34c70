// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"

// Turns extrema into the findings of `check`. A curve gives the extrema of each of its segments; a
// table gives only the extrema that can affect the result.
namespace jounce::profiles_detail {

/// A limit on one derivative, to one side.
struct Bound {
  std::size_t order;  ///< 0: position, ..., 3: jerk
  Rule rule;
  double limit;  ///< in the unit of the derivative
  bool upper;    ///< true: the value must not exceed the limit; false: it must not fall below
  double scale;  ///< the distance from the limit that is a relative margin of 1, in the same unit
};

/// Margin between the limit and the worst value of the range, relative to the bound's scale.
double room_of(const Bound& bound, const Range& range);

/// A value that exceeds the limit by less than this share of the scale counts as equal to the
/// limit, because of rounding.
inline constexpr double forgiven = 1e-12;

/// Collects the ranges of all segments and makes the report.
class LimitCheck {
 public:
  /// `names`: names of the value and its derivatives. `stroke`: range of the position; used only if
  /// needs_stroke().
  LimitCheck(const Limits& limits, const std::array<const char*, 4>& names, double stroke);
  /// True if the position is limited at one end only: the stroke is then the scale of its margin.
  [[nodiscard]] static bool needs_stroke(const Limits& limits) {
    return limits.position_min.has_value() != limits.position_max.has_value();
  }

  /// All bounds, ordered by derivative.
  [[nodiscard]] const std::vector<Bound>& bounds() const { return bounds_; }
  /// Takes the range of the derivative of a bound on a segment from `start` to `end`. Call it in
  /// ascending order of segments. A segment may be omitted if it neither breaks the bound nor comes
  /// closer to it than an earlier segment.
  void consider(std::size_t bound, const Range& range, double start, double end,
                std::size_t segment);
  /// Returns the value closest to a bound, among the values that satisfy it; nullopt if no value
  /// was considered.
  [[nodiscard]] std::optional<double> closest(std::size_t bound) const;

  /// The report on all considered ranges.
  [[nodiscard]] Report report() &&;

 private:
  [[nodiscard]] Finding finding_of(const Bound& bound, const Extremum& worst, std::size_t segment,
                                   bool at_end) const;

  std::array<const char*, 4> names_;
  std::vector<Bound> bounds_;
  std::vector<std::optional<Finding>> closest_;
  std::vector<std::optional<Finding>> broken_;  // the last finding of each bound
  Report report_;
};

/// The interval of a motion, and whether the motion repeats.
struct Ends {
  double start = 0;
  double end = 0;
  bool repeats = false;
};

/// Returns the report of `check_continuity`, from the ranges and the largest step of every order.
Report continuity_report(const Ranges& ranges, const std::array<Jump, 4>& jumps,
                         const std::array<const char*, 4>& names, const Ends& extent, int order,
                         double tolerance);

}  // namespace jounce::profiles_detail
