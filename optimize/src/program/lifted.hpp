// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "optimize/src/figures/figure_rows.hpp"

/// Numbers that are affine in the coordinates of a spline, and unknowns of their own for them. The
/// derivation stands at the head of lifted.cpp.
namespace jounce::optimizer {

/// y = constant + factor x, where x begins at unknown `first`.
struct Affine {
  Eigen::VectorXd constant;
  Eigen::MatrixXd factor;  ///< a row for each number of y
  std::size_t first = 0;
  double natural = 1;

  /// sign * y_i.
  [[nodiscard]] Form row(Eigen::Index i, double sign) const;
};

/// Rows over the coordinates as they are within the joints: what these cancel is taken off.
Eigen::MatrixXd without_joints(const Eigen::MatrixXd& rows, const SplineSpace& space);

/// y in unknowns of the figure's own, which what the figure is to be is of about size one in: what ties them
/// to the coordinates goes into the rows. Needs the rows' value, natural and nothing.
Affine lifted(const Affine& y, const Lift& lift, FigureRows& rows);

}  // namespace jounce::optimizer
