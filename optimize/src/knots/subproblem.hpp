// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/optimize/problem.hpp"
#include "jounce/profiles/curve/extrema.hpp"

#include "optimize/src/knots/space.hpp"
#include "optimize/src/tolerances.hpp"

/// One objective under ceilings that hold everywhere, not only at sampled points.
namespace jounce::optimize_detail {

/// A ceiling: sign * (f^(order) + lower * f^(order - 1)) <= limit on the whole cam. Violations are
/// measured in units of `scale`.
struct DerivativeBound {
  std::size_t order = 0;
  double sign = 1;
  double limit = 0;
  double scale = 1;
  double lower = 0;  ///< 1/m (unit of the master); if it is not 0, order >= 1
};

/// Returns the ceilings that limits with respect to the master require, for both signs of each
/// derivative.
std::vector<DerivativeBound> ceilings_of(const Limits& limits, const RampedLimits& ramped,
                                         const Space& space);

/// Returns the ceilings of RampedLimits alone: four for each limit.
std::vector<std::vector<DerivativeBound>> ramped_ceilings(const RampedLimits& ramped);

/// Returns the exact extrema of the limited expression over one segment of a cam.
Range range_of(const Cam& cam, std::size_t segment, const DerivativeBound& ceiling);

/// One objective, with ceilings.
struct Subproblem {
  const Space& space;                     ///< the free quantities
  std::vector<DerivativeBound> ceilings;  ///< ceilings of derivatives
  std::optional<double> rms_ceiling;      ///< ceiling of the rms acceleration; nullopt: none
  std::optional<Objective> objective;     ///< the objective; nullopt: the violation of the ceilings
  double insignificant = 0;               ///< values of the objective below this count as 0
  double tolerance = 1e-6;                ///< relative tolerance
};

/// The exact value and violation of a point.
struct Merit {
  double value = 0;   ///< value of the objective; if there is none, the violation
  double excess = 0;  ///< greatest relative violation of a ceiling where the cam can change
};

/// The cam at z with the exact extrema of every piece.
struct Shape {
  Shape(const Space& space, const Point& z);

  /// Returns the place of an extremum in its piece, 0 to 1.
  [[nodiscard]] double place(std::size_t piece, const Extremum& e) const;

  /// Returns the exact extrema of the limited expression over a piece.
  [[nodiscard]] Range range(std::size_t piece, const DerivativeBound& ceiling) const;

  Cam cam;
  std::vector<Ranges> ranges;
};

/// The extremum that reaches a ceiling of this sign first.
inline const Extremum& worst(const Range& range, double sign) {
  return sign > 0 ? range.max : range.min;
}

/// Returns the relative excess of a piece over the ceiling; <= 0: the ceiling holds.
double excess_of(const DerivativeBound& ceiling, const Range& range);

/// Returns the order of the derivative for a peak, 2 or 3; nullopt for other objectives.
std::optional<std::size_t> peak_order(const std::optional<Objective>& objective);

/// Returns the exact value and violation.
Merit merit(const Subproblem& subproblem, const Shape& shape);
Merit merit(const Subproblem& subproblem, const Point& z);

/// True if a is better. Points without violation come first; then the value or the violation
/// decides.
bool is_better(const Merit& a, const Merit& b);

/// Returns the peak of the segments that no free quantity changes: a lower bound of the objective.
double floor_of(const Subproblem& subproblem);

}  // namespace jounce::optimize_detail
