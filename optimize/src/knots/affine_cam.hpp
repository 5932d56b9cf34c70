// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/cam/design/boundaries.hpp"

#include "optimize/src/solvers/interior_point.hpp"

namespace jounce::optimize_detail {

/// One free derivative. The solver's variable is (value - given) / unit.
struct Unknown {
  double unit = 1;
  /// Bound, in units: two values for which the peak does not exceed the given one differ by at most
  /// 2 * reach.
  double reach = 1;
};

/// Returns max |geo_acceleration| of the cam.
double peak_of(const CamSpec& spec);

/// A cam as an affine function of its free derivatives. The unit of acceleration is the peak of the
/// given cam, the unit of length its mean segment.
class AffineCam {
 public:
  /// Every derivative of `spec` must be given. `free`: the derivatives of each knot that may
  /// change.
  AffineCam(const CamSpec& spec, const std::vector<FreeDerivatives>& free);

  /// The free derivatives.
  [[nodiscard]] const std::vector<Unknown>& unknowns() const { return unknowns_; }
  /// The peak of the given cam.
  [[nodiscard]] double peak() const { return peak_; }
  /// True if the acceleration of the given cam is only rounding.
  [[nodiscard]] bool straight() const;
  /// True if a free derivative changes the segment.
  [[nodiscard]] bool moves(std::size_t segment) const;
  /// Returns the cam for these values of the variables.
  [[nodiscard]] CamSpec at(const std::vector<double>& x) const;

  /// Returns the second or third derivative at s in [0, 1] of a segment for which moves() is true.
  [[nodiscard]] Form derivative(std::size_t segment, double s, std::size_t order) const;

  /// Returns the integral of f'''^2 over the segments that change, as squares. f'''^2 is a
  /// polynomial of degree 4, for which Gauss's rule with three points is exact.
  [[nodiscard]] std::vector<Form> square_jerk() const;

 private:
  std::optional<std::size_t> add(bool free, double unit, double reach);
  [[nodiscard]] double length(std::size_t segment) const {
    return knots_[segment + 1].master - knots_[segment].master;
  }

  CamSpec spec_;
  std::vector<CamKnot> knots_;
  /// Indices of velocity and acceleration of each knot.
  std::vector<std::array<std::optional<std::size_t>, 2>> index_;
  std::vector<Unknown> unknowns_;
  double peak_ = 0;
  double mean_ = 1;
};

}  // namespace jounce::optimize_detail
