// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/auxiliary_variables.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/cam/detail/pivoted_qr.hpp"

#include "optimize/src/solvers/sparse_factor.hpp"

// The values at many instants, or of many modes, are affine in the coordinates z of a spline
// (spline_space.hpp): y = y(0) + R z with rows R. To change one coordinate alone makes separate
// pieces, not a spline. The effect of the jumps of the position between pieces cancels in any
// spline. Rows a of R are therefore replaced by their projection onto the splines, for which the
// equalities E z = 0 hold at the joints:
//
//   (1)  a <- a - E' (E E')^-1 E a
//
// (With a basis of splines instead, the effect of a jump of the highest derivative at the end would lose all
// digits.)
//
// Many instants may depend on a few numbers: a vibration after the end depends on the state there,
// which is four or five numbers. A narrow ceiling over all instants has almost no interior, and
// each of its planes contains all coordinates. With R = Q T, where Q has r orthonormal columns
// (Householder with pivots: the rows of T decrease), and with unknowns v in the unit u of the
// figure,
//
//   (2)  u v = T z + Q' y(0),    y = u Q v + (1 - Q Q') y(0)
//
// a ceiling has size one in v however low it is, and its planes have r numbers. Entries of T below
// `row_rounding` of its largest row are rounding. If no |y_i| is above the figure F, then v = Q' y / u
// has
//
//   (3)  |v_k| <= |y| / u <= F sqrt(rows) / u

namespace jounce::optimize_detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double row_rounding = 1e-13;
constexpr double steepest = 1e7;  ///< greatest slope of (2) in v

/// A figure of almost nothing is measured in its natural size.
double unit_of(const Auxiliary& auxiliary, const FigureRows& rows) {
  const double unit =
      auxiliary.at_most ? *auxiliary.at_most : std::abs(rows.value(auxiliary.given));
  return unit > rows.nothing * rows.natural ? unit : rows.natural;
}

}  // namespace

Form Affine::row(Index i, double sign) const {
  Form form{sign * constant[i], {}};
  for (Index k = 0; k < factor.cols(); ++k)
    if (factor(i, k) != 0)
      form.terms.push_back({first + static_cast<std::size_t>(k), sign * factor(i, k)});
  return form;
}

/// (1), for every row.
MatrixXd without_joints(const MatrixXd& rows, const SplineSpace& space) {
  const std::vector<Form> joints = space.joints();
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < joints.size(); ++i)
    for (const Form::Term& t : joints[i].terms)
      entries.emplace_back(static_cast<int>(i), static_cast<int>(t.index), t.factor);
  Eigen::SparseMatrix<double> e(static_cast<Index>(joints.size()), rows.cols());
  e.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> square = e * e.transpose();
  SparseFactor solver(SparseFactor::Method::cholesky);
  solver.find_pattern(square);
  solver.factorize(square);
  MatrixXd left = rows.transpose();
  for (int round = 0; round < 2; ++round) left -= e.transpose() * solver.solve(MatrixXd(e * left));
  return left.transpose();
}

/// (2).
Affine with_auxiliary_variables(const Affine& y, const Auxiliary& auxiliary, FigureRows& rows) {
  const double unit = unit_of(auxiliary, rows);
  const jounce::cam_detail::PivotedQr qr(y.factor, row_rounding);
  const Index rank = qr.rank();
  const MatrixXd q = qr.q(rank);
  const MatrixXd t = q.transpose() * y.factor;
  const VectorXd c = q.transpose() * y.constant;
  for (Index k = 0; k < rank; ++k) {
    const double size = std::max(t.row(k).lpNorm<Eigen::Infinity>() / steepest, unit);
    Form form{c[k] / size, {{auxiliary.first + static_cast<std::size_t>(k), -unit / size}}};
    for (Index j = 0; j < t.cols(); ++j)
      form.terms.push_back({static_cast<std::size_t>(j), t(k, j) / size});
    rows.definitions.push_back(std::move(form));
  }
  rows.auxiliary_share = std::sqrt(static_cast<double>(q.rows())) / unit;
  return {y.constant - q * c, unit * q, auxiliary.first, y.natural};
}

}  // namespace jounce::optimize_detail
