// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

namespace jounce::validate_detail {

// Plain loops: for the ten or twenty states of a drive, the preparation of a general product takes
// longer than the product.

/// Writes the first `rows` numbers of y = p z.
inline void multiply(const Eigen::MatrixXd& p, const double* z, Eigen::Index rows, double* y) {
  std::fill_n(y, rows, 0.0);
  for (Eigen::Index k = 0; k < p.cols(); ++k) {
    const double* column = p.data() + k * p.rows();
    const double factor = z[k];
    for (Eigen::Index i = 0; i < rows; ++i) y[i] += column[i] * factor;
  }
}

/// Returns the numbers of a matrix, column by column.
inline std::vector<double> flat(const Eigen::MatrixXd& m) {
  return {m.data(), m.data() + m.size()};
}

/// Returns a b.
inline Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd c(a.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    multiply(a, b.data() + j * b.rows(), a.rows(), c.data() + j * c.rows());
  return c;
}

/// Returns z' w z.
inline double form(const Eigen::MatrixXd& w, const Eigen::VectorXd& z) {
  double sum = 0;
  for (Eigen::Index j = 0; j < w.cols(); ++j) {
    const double* column = w.data() + j * w.rows();
    double of = 0;
    for (Eigen::Index i = 0; i < w.rows(); ++i) of += column[i] * z[i];
    sum += of * z[j];
  }
  return sum;
}

}  // namespace jounce::validate_detail
