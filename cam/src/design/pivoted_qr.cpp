// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/detail/pivoted_qr.hpp"

#include <Eigen/QR>

namespace jounce::cam_detail {

struct PivotedQr::Factors {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
};

PivotedQr::PivotedQr(const Eigen::MatrixXd& a)
    : factors_(new Factors{Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(a)}) {}

PivotedQr::PivotedQr(const Eigen::MatrixXd& a, double threshold) : PivotedQr(a) {
  factors_->qr.setThreshold(threshold);
}

PivotedQr::~PivotedQr() = default;

Eigen::Index PivotedQr::rank() const {
  return factors_->qr.rank();
}

Eigen::MatrixXd PivotedQr::q(Eigen::Index columns) const {
  return factors_->qr.householderQ() * Eigen::MatrixXd::Identity(factors_->qr.rows(), columns);
}

Eigen::MatrixXd PivotedQr::r() const {
  return factors_->qr.matrixR().topLeftCorner(rank(), rank()).triangularView<Eigen::Upper>();
}

const PivotedQr::Permutation& PivotedQr::permutation() const {
  return factors_->qr.colsPermutation();
}

Eigen::VectorXd PivotedQr::solve(const Eigen::VectorXd& b) const {
  return factors_->qr.solve(b);
}

}  // namespace jounce::cam_detail
