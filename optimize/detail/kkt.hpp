#pragma once

#include <vector>

#include <Eigen/Sparse>

#include "jounce/optimize/detail/interior_point.hpp"

namespace jounce::optimizer {

/// The matrix of a Newton step,  K = [ Q + G' D G, A'; A, 0 ],  with G the constraints and A the
/// equalities of a program and Q the second derivative of its squares. The pattern is found and ordered
/// once; with D it is factorised anew.
class Kkt {
 public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  /// `regular`: what may be added to the diagonal where there are equalities; 0: nothing, and rows are
  /// exchanged for stability instead, which takes some five times as long.
  Kkt(const ConvexProgram& program, double regular);

  [[nodiscard]] const Matrix& g() const { return g_; }
  [[nodiscard]] const Matrix& a() const { return a_; }
  /// Q x.
  [[nodiscard]] Vector curved(const Vector& x) const;
  /// The slope at x = 0 and -constant of constraints and equalities.
  [[nodiscard]] const Vector& q() const { return q_; }
  [[nodiscard]] const Vector& h() const { return h_; }
  [[nodiscard]] const Vector& b() const { return b_; }

  bool factorise(const Vector& d);
  /// The solution (x, then multipliers of the equalities) of K v = r.
  [[nodiscard]] Vector solve(const Vector& r) const;

 private:
  void find_pattern(double added);
  void add(std::size_t& next, double value) { k_.valuePtr()[place_[next++]] += value; }
  [[nodiscard]] Vector times(const Vector& v) const;
  [[nodiscard]] Vector back(const Vector& r) const;

  Matrix g_, a_, f_, k_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows_;  ///< G by rows
  Vector q_, h_, b_;
  std::vector<Eigen::Index> place_;  ///< of each contribution, in k_'s values
  std::vector<double> fixed_;        ///< k_ without G' D G, regularised
  Vector regular_;                   ///< what was added to the diagonal
  bool pivoting_ = false;
  Eigen::SimplicialLDLT<Matrix> factor_;
  Eigen::SparseLU<Matrix> pivoted_;
};

}  // namespace jounce::optimizer
