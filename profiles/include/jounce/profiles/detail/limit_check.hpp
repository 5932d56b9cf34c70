// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"

// Findings of `check` from extrema: those of a curve, one segment after another, or only the extrema of
// a table that can matter.
namespace jounce::profiles_detail {

/// One bound on one derivative: it must stay below `limit` (upper), or above.
struct Bound {
  std::size_t order;
  Rule rule;
  double limit;
  bool upper;
  double scale;  ///< value of a margin of 1
};

/// Distance from the worst value of a range to a bound, in the bound's scale.
double room_of(const Bound& bound, const Range& range);

/// A limit that is met exactly is met: what may be passed is this share, the rounding of the evaluation.
inline constexpr double forgiven = 1e-12;

class LimitCheck {
 public:
  /// Names of the value and its derivatives; `stroke` is asked for where one end of the position is
  /// limited alone.
  LimitCheck(const Limits& limits, const std::array<const char*, 4>& names, double stroke);
  [[nodiscard]] static bool needs_stroke(const Limits& limits) {
    return limits.position_min.has_value() != limits.position_max.has_value();
  }

  /// Bounds of one derivative stand together.
  [[nodiscard]] const std::vector<Bound>& bounds() const { return bounds_; }
  /// The range of a bound's derivative on a segment that begins at `start`. Segments ascend. A
  /// segment may be left out if it does not break the bound or come closer to it than an earlier
  /// one.
  void consider(std::size_t bound, const Range& range, double start, std::size_t segment);
  /// The value that is closest to a bound and keeps it, if there was one.
  [[nodiscard]] std::optional<double> closest(std::size_t bound) const;

  [[nodiscard]] Report report() &&;

 private:
  [[nodiscard]] Finding finding_of(const Bound& bound, const Extremum& worst,
                                   std::size_t segment) const;

  std::array<const char*, 4> names_;
  std::vector<Bound> bounds_;
  std::vector<std::optional<Finding>> closest_;
  std::vector<std::optional<Finding>> broken_;  // the last of each
  Report report_;
};

/// The independent axis of a motion: its ends, and whether it repeats beyond them.
struct Ends {
  double start = 0;
  double end = 0;
  bool repeats = false;
};

/// The report of `check_continuity` from all ranges and the largest step of every order.
Report continuity_report(const Ranges& ranges, const std::array<Jump, 4>& jumps,
                         const std::array<const char*, 4>& names, const Ends& extent, int order,
                         double tolerance);

}  // namespace jounce::profiles_detail
