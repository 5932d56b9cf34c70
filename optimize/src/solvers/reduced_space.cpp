// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/reduced_space.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/cam/detail/pivoted_qr.hpp"

#include "optimize/src/solvers/forms.hpp"

namespace jounce::optimize_detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double dependent_equality = 1e-11;  ///< share of the greatest pivot
constexpr double dependent_column = 1e-13;    ///< share of the greatest pivot

MatrixXd dense_rows_of(const std::vector<Form>& forms, std::size_t unknowns) {
  MatrixXd rows = MatrixXd::Zero(static_cast<Index>(forms.size()), static_cast<Index>(unknowns));
  for (std::size_t k = 0; k < forms.size(); ++k)
    for (const Form::Term& t : forms[k].terms)
      rows(static_cast<Index>(k), static_cast<Index>(t.index)) += t.factor;
  return rows;
}

/// Roots of M of (1).
MatrixXd measure(const SplineSpace& space) {
  std::vector<Form> all;
  for (int order = 0; order <= std::min(2, space.degree()); ++order) {
    LinearQuantity q = derivative_of_shape(order);
    for (Form& f : space.squares(q)) all.push_back(scaled(std::move(f), 1 / space.natural(q)));
  }
  return dense_rows_of(all, space.size());
}

}  // namespace

ReducedSpace::ReducedSpace(const SplineSpace& space, const std::vector<Form>& equalities,
                           const Coordinates& near) {
  const auto n = static_cast<Index>(space.size());
  const MatrixXd a = dense_rows_of(equalities, space.size());
  const jounce::cam_detail::PivotedQr qr(a.transpose(), dependent_equality);
  const Index rank = qr.rank();
  const MatrixXd q = qr.q(n);
  const VectorXd start = Eigen::Map<const VectorXd>(near.data(), n);
  // A z = -b with A' P = Q R: R' (Q' z) = -P' b. The rest of Q' z is that of `near`.
  VectorXd turned = q.transpose() * start;
  const VectorXd wanted = qr.permutation().transpose() * -constants_of(equalities);
  const MatrixXd r = qr.r();
  turned.head(rank) =
      r.transpose().template triangularView<Eigen::Lower>().solve(wanted.head(rank));
  z0_ = q * turned;
  contradiction_ = (a * z0_ + constants_of(equalities)).lpNorm<Eigen::Infinity>();
  const MatrixXd free = q.rightCols(n - rank);
  basis_ = MatrixXd::Zero(n, 0);
  inverse_ = MatrixXd::Zero(0, n);
  if (free.cols() == 0) return;  // the ends leave nothing free
  // N' M N = L L', without computing it, which would square its condition. Directions that move nothing are
  // left out.
  const jounce::cam_detail::PivotedQr half(measure(space) * free, dependent_column);
  const Index moving = half.rank();
  const MatrixXd turned_free = (free * half.permutation()).leftCols(moving);
  const MatrixXd upper = half.r();
  basis_ = upper.template triangularView<Eigen::Upper>()
               .transpose()
               .solve(turned_free.transpose())
               .transpose();
  inverse_ = upper * turned_free.transpose();
}

Coordinates ReducedSpace::z(const VectorXd& y) const {
  const VectorXd z = z0_ + basis_ * y;
  return {z.begin(), z.end()};
}

DenseRow ReducedSpace::row(const Form& form) const {
  DenseRow row{form.constant, VectorXd::Zero(size())};
  for (const Form::Term& t : form.terms) {
    row.constant += t.factor * z0_[static_cast<Index>(t.index)];
    if (size() == 0) continue;  // Eigen computes the address of a row of an empty matrix
    row.slope += t.factor * basis_.row(static_cast<Index>(t.index)).transpose();
  }
  return row;
}

VectorXd ReducedSpace::y(const Coordinates& z) const {
  return inverse_ * (Eigen::Map<const VectorXd>(z.data(), static_cast<Index>(z.size())) - z0_);
}

}  // namespace jounce::optimize_detail
