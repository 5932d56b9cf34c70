// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/optimize/problem.hpp"
#include "jounce/profiles/curve/extrema.hpp"

#include "optimize/src/knots/space.hpp"

/// One objective under ceilings that hold everywhere, not only at sampled points.
namespace jounce::optimizer {

/// sign * (f^(order) + lower * f^(order - 1)) <= limit all along the cam; `scale` is what violations are measured in.
struct DerivativeBound {
  std::size_t order = 0;
  double sign = 1;
  double limit = 0;
  double scale = 1;
  double lower = 0;  ///< 1/m; not 0: order >= 1
};

/// What limits per master unit ask for, both signs of a rate.
std::vector<DerivativeBound> ceilings_of(const Limits& limits, const RampedLimits& ramped,
                                         const Space& space);

/// Those of RampedLimits alone: of each limit its four.
std::vector<std::vector<DerivativeBound>> ramped_ceilings(const RampedLimits& ramped);

/// The exact extrema of what a ceiling limits, over one segment of a cam.
Range range_of(const Cam& cam, std::size_t segment, const DerivativeBound& ceiling);

struct Stage {
  const Space& space;
  std::vector<DerivativeBound> ceilings;
  std::optional<double> rms_ceiling;
  std::optional<Objective> objective;  ///< none: the violation of the ceilings
  double insignificant = 0;            ///< a value of the objective that is as good as zero
  double tolerance = 1e-6;
};

/// What a point is worth, by exact extrema.
struct Standing {
  double value = 0;   ///< value of the objective; without one, the violation
  double excess = 0;  ///< worst violation of a ceiling where the cam can change, relative
};

/// How much violation is only rounding; `check` forgives as much.
constexpr double rounding = 1e-12;

/// The cam at z with the exact extrema of every piece.
struct Shape {
  Shape(const Space& space, const Point& z);

  /// Where in its piece an extremum lies, in [0, 1].
  [[nodiscard]] double place(std::size_t piece, const Extremum& e) const;

  /// The exact extrema of what a ceiling limits, over a piece.
  [[nodiscard]] Range range(std::size_t piece, const DerivativeBound& ceiling) const;

  Cam cam;
  std::vector<Ranges> ranges;
};

/// The extremum that a ceiling of this sign meets first.
inline const Extremum& worst(const Range& range, double sign) {
  return sign > 0 ? range.max : range.min;
}

/// By how much a piece breaks the ceiling, relative; <= 0: it does not.
double excess_of(const DerivativeBound& ceiling, const Range& range);

/// 2 or 3 for a peak, nothing for the others.
std::optional<std::size_t> peak_order(const std::optional<Objective>& objective);

Standing standing(const Stage& stage, const Shape& shape);
Standing standing(const Stage& stage, const Point& z);

/// True if a is the better one. A standing without violation comes first. The value decides next, or the violation.
bool stands_before(const Standing& a, const Standing& b);

/// The peak of the segments that no free quantity reaches: nothing below it counts.
double floor_of(const Stage& stage);

}  // namespace jounce::optimizer
