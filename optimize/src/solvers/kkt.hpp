// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "optimize/src/solvers/cone_scaling.hpp"
#include "optimize/src/solvers/interior_point.hpp"
#include "optimize/src/solvers/sparse_factor.hpp"

namespace jounce::optimize_detail {

/// The matrix of a Newton step,  K = [ Q + G' W^-2 G, A'; A, 0 ].  G are the constraints (the round
/// ones last), A the equalities of a program, and Q the second derivative of its squares. The
/// pattern is analyzed and ordered once; the matrix is factorized again for each W. The rank-one
/// part of a cone would fill the matrix, and is treated separately by the formula of Sherman,
/// Morrison and Woodbury.
class Kkt {
 public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  /// `regular`: number that may be added to the diagonal if there are equalities. 0: none; rows are
  /// then exchanged for stability, which takes about five times as long.
  Kkt(const ConvexProgram& program, double regular);

  /// G and A.
  [[nodiscard]] const Matrix& g() const { return g_; }
  [[nodiscard]] const Matrix& a() const { return a_; }
  /// Returns Q x.
  [[nodiscard]] Vector curved(const Vector& x) const;
  /// q: the slope at x = 0. h and b: -constant of the constraints and of the equalities.
  [[nodiscard]] const Vector& q() const { return q_; }
  [[nodiscard]] const Vector& h() const { return h_; }
  [[nodiscard]] const Vector& b() const { return b_; }

  [[nodiscard]] const ConeShape& cones() const { return cones_; }

  /// Factorizes K for this W. Returns false if K is singular.
  bool factorize(const ConeScaling& w);
  /// Returns the solution of K v = r: x, then the multipliers of the equalities.
  [[nodiscard]] Vector solve(const Vector& r) const;

 private:
  void find_pattern(double added);
  void add(std::size_t& next, double value) { k_.valuePtr()[place_[next++]] += value; }
  [[nodiscard]] Vector times(const Vector& v) const;
  [[nodiscard]] Vector back(const Vector& r) const;

  void factorize_rank_ones();

  ConeShape cones_;
  Matrix g_, a_, f_, k_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows_;  ///< G by rows
  Vector q_, h_, b_;
  std::vector<Eigen::Index> place_;  ///< place of each contribution, in k_'s values
  std::vector<double> fixed_;        ///< k_ without G' D G, regularized
  Vector regular_;                   ///< numbers added to the diagonal
  std::vector<Vector> u_;            ///< K = (factorized part) + sum u u'
  Eigen::MatrixXd solved_u_;         ///< (factorized part)^-1 u, as columns
  Eigen::MatrixXd small_;            ///< 1 + u' (...)^-1 u
  SparseFactor factor_;
};

}  // namespace jounce::optimize_detail
