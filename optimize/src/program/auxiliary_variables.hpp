// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimize/src/figures/figure_rows.hpp"

/// Numbers that are affine in the coordinates of a spline, in terms of auxiliary unknowns. The
/// derivation is at the head of auxiliary_variables.cpp.
namespace jounce::optimize_detail {

/// y = constant + factor x, where x begins at unknown `first`.
struct Affine {
  Eigen::VectorXd constant;
  Eigen::MatrixXd factor;  ///< one row for each number of y
  std::size_t first = 0;   ///< index of the first unknown
  double natural = 1;      ///< usual size of y

  /// Returns sign * y_i as a form.
  [[nodiscard]] Form row(Eigen::Index i, double sign) const;
};

/// Removes from rows over the coordinates the part that cancels in every spline.
Eigen::MatrixXd without_joints(const Eigen::MatrixXd& rows, const SplineSpace& space);

/// Writes y in auxiliary variables, for which the target of the figure has about size one. Adds the
/// equations between these and the coordinates to the rows. The value, the natural size and the
/// rounding of the rows must be set before.
Affine with_auxiliary_variables(const Affine& y, const Auxiliary& auxiliary, FigureRows& rows);

}  // namespace jounce::optimize_detail
