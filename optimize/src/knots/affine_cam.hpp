// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/cam/design/boundaries.hpp"

#include "optimize/src/solvers/interior_point.hpp"

namespace jounce::optimizer {

/// One free derivative. The solver's variable is (value - given) / unit.
struct Unknown {
  double unit = 1;
  /// Two values whose peaks do not exceed the given one differ by at most 2 reach units.
  double reach = 1;
};

/// max |geo_acceleration| of the cam.
double peak_of(const CamSpec& spec);

/// A cam as an affine function of its free derivatives. The unit of acceleration is the peak of the given cam,
/// the unit of length its mean segment.
class AffineCam {
 public:
  /// Every derivative of `spec` is given; `free` lists those that may change.
  AffineCam(const CamSpec& spec, const std::vector<FreeDerivatives>& free);

  [[nodiscard]] const std::vector<Unknown>& unknowns() const { return unknowns_; }
  [[nodiscard]] double peak() const { return peak_; }
  /// True if the acceleration of the given cam is only rounding.
  [[nodiscard]] bool straight() const;
  /// True if a free derivative changes the segment.
  [[nodiscard]] bool moves(std::size_t segment) const;
  [[nodiscard]] CamSpec at(const std::vector<double>& x) const;

  /// The second or third derivative at s in [0, 1] of a segment that moves.
  [[nodiscard]] Form derivative(std::size_t segment, double s, std::size_t order) const;

  /// The integral of f'''^2 over the segments that move, as squares. f'''^2 is a polynomial of degree 4, for
  /// which Gauss's rule with three points is exact.
  [[nodiscard]] std::vector<Form> square_jerk() const;

 private:
  std::optional<std::size_t> add(bool free, double unit, double reach);
  [[nodiscard]] double length(std::size_t segment) const {
    return knots_[segment + 1].master - knots_[segment].master;
  }

  CamSpec spec_;
  std::vector<CamKnot> knots_;
  std::vector<std::array<std::optional<std::size_t>, 2>>
      index_;  ///< index of velocity, acceleration
  std::vector<Unknown> unknowns_;
  double peak_ = 0;
  double mean_ = 1;
};

}  // namespace jounce::optimizer
