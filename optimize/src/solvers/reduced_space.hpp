// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "optimize/src/program/spline_space.hpp"

namespace jounce::optimize_detail {

/// The affine function constant + slope . y.
struct DenseRow {
  double constant = 0;
  Eigen::VectorXd slope;

  [[nodiscard]] double at(const Eigen::VectorXd& y) const { return constant + slope.dot(y); }
};

/// The splines that meet given equalities, in coordinates y without further conditions and without
/// a preferred direction:
///
///     (1)  z = z0 + N L^-T y,   A N = 0,   N' M N = L L'
///
/// A z + b = 0 are the equalities, which z0 satisfies. M is the mean square of the value and its
/// first two derivatives, each in its natural unit. Without such a whitening SLSQP stops early and
/// reports success.
class ReducedSpace {
 public:
  /// Sets z0 to the solution of the equalities nearest to `near`. Equalities may be redundant.
  ReducedSpace(const SplineSpace& space, const std::vector<Form>& equalities,
               const Coordinates& near);

  /// Number of coordinates y.
  [[nodiscard]] Eigen::Index size() const { return basis_.cols(); }
  /// Distance of z0 from the equalities. If it exceeds rounding, they contradict each other.
  [[nodiscard]] double contradiction() const { return contradiction_; }
  /// Returns (1).
  [[nodiscard]] Coordinates z(const Eigen::VectorXd& y) const;
  /// Returns a form as a function of y.
  [[nodiscard]] DenseRow row(const Form& form) const;
  /// Returns y of the spline nearest to these coordinates.
  [[nodiscard]] Eigen::VectorXd y(const Coordinates& z) const;

 private:
  Eigen::VectorXd z0_;
  Eigen::MatrixXd basis_;    ///< N L^-T
  Eigen::MatrixXd inverse_;  ///< its left inverse, L' N'
  double contradiction_ = 0;
};

}  // namespace jounce::optimize_detail
