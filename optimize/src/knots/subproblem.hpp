// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/optimize/problem.hpp"
#include "jounce/profiles/curve/extrema.hpp"

#include "optimize/src/knots/space.hpp"
#include "optimize/src/tolerances.hpp"

/// One objective under ceilings that hold everywhere, not only at sampled points.
namespace jounce::optimizer {

/// sign * (f^(order) + lower * f^(order - 1)) <= limit on the whole cam. Violations are measured in `scale`.
struct DerivativeBound {
  std::size_t order = 0;
  double sign = 1;
  double limit = 0;
  double scale = 1;
  double lower = 0;  ///< 1/m; not 0: order >= 1
};

/// The bounds that limits per master unit require, both signs of a rate.
std::vector<DerivativeBound> ceilings_of(const Limits& limits, const RampedLimits& ramped,
                                         const Space& space);

/// The bounds of RampedLimits alone: four for each limit.
std::vector<std::vector<DerivativeBound>> ramped_ceilings(const RampedLimits& ramped);

/// The exact extrema of the limited expression over one segment of a cam.
Range range_of(const Cam& cam, std::size_t segment, const DerivativeBound& ceiling);

struct Subproblem {
  const Space& space;
  std::vector<DerivativeBound> ceilings;
  std::optional<double> rms_ceiling;
  std::optional<Objective> objective;  ///< none: the violation of the ceilings
  double insignificant = 0;            ///< values of the objective below this count as zero
  double tolerance = 1e-6;
};

/// The exact value and violation of a point.
struct Merit {
  double value = 0;   ///< value of the objective; without one, the violation
  double excess = 0;  ///< worst violation of a ceiling where the cam can change, relative
};

/// The cam at z with the exact extrema of every piece.
struct Shape {
  Shape(const Space& space, const Point& z);

  /// The place of an extremum in its piece, in [0, 1].
  [[nodiscard]] double place(std::size_t piece, const Extremum& e) const;

  /// The exact extrema of the limited expression over a piece.
  [[nodiscard]] Range range(std::size_t piece, const DerivativeBound& ceiling) const;

  Cam cam;
  std::vector<Ranges> ranges;
};

/// The extremum that meets a ceiling of this sign first.
inline const Extremum& worst(const Range& range, double sign) {
  return sign > 0 ? range.max : range.min;
}

/// The relative excess of a piece over the ceiling; <= 0: it holds.
double excess_of(const DerivativeBound& ceiling, const Range& range);

/// 2 or 3 for a peak, none for the others.
std::optional<std::size_t> peak_order(const std::optional<Objective>& objective);

Merit merit(const Subproblem& subproblem, const Shape& shape);
Merit merit(const Subproblem& subproblem, const Point& z);

/// True if a is better: without violation before with violation, then by value or by violation.
bool is_better(const Merit& a, const Merit& b);

/// The peak of the segments that no free quantity changes: the objective cannot be below.
double floor_of(const Subproblem& subproblem);

}  // namespace jounce::optimizer
