// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

namespace jounce::optimize_detail {

/// The cones of the slacks of a program: numbers >= 0, then second-order cones { (a, b) : |b| <= a
/// }.
struct ConeShape {
  Eigen::Index linear = 0;               ///< number of numbers >= 0
  std::vector<Eigen::Index> round = {};  ///< number of entries of each cone, including a

  /// The number by which s . y is divided for its mean mu: one for each number and each cone.
  [[nodiscard]] double degree() const {
    return static_cast<double>(linear) + static_cast<double>(round.size());
  }
};

/// Jordan's product of vectors in a product of cones, and its unit. For numbers it is their
/// product; for (a, b) and (c, d) it is (a c + b . d, a d + c b), whose unit is (1, 0).
Eigen::VectorXd unit_of(const ConeShape& shape);
Eigen::VectorXd product(const ConeShape& shape, const Eigen::VectorXd& a, const Eigen::VectorXd& b);
/// Returns the vector whose product with a is p; a must be inside its cones.
Eigen::VectorXd quotient(const ConeShape& shape, const Eigen::VectorXd& p,
                         const Eigen::VectorXd& a);
/// Returns the inverse of a.
Eigen::VectorXd inverse(const ConeShape& shape, const Eigen::VectorXd& a);
/// Returns the longest step, at most 1, for which v + step dv remains in the cones.
double longest(const ConeShape& shape, const Eigen::VectorXd& v, const Eigen::VectorXd& dv);
/// Returns v, moved inside its cones: numbers to at least `least`, cones by 1.
Eigen::VectorXd inside(const ConeShape& shape, Eigen::VectorXd v, double least);

/// The scaling W of Nesterov and Todd (Mathematics of Operations Research 22, 1997) at s and y:
/// symmetric, with W y = W^-1 s. For numbers W^2 = s / y. For a cone, with J = diag(1, -1, ... -1),
///
///     (1)  W^2 = e^2 (2 w w' - J),   W^-2 = (2 (J w)(J w)' - J) / e^2,   w' J w = 1,
///     (2)  w = (s/|s| + J y/|y|) / (2 c),   c^2 = (1 + s' y / (|s| |y|)) / 2,   e^2 = |s| / |y|,   |s|^2 = s' J s
class ConeScaling {
 public:
  ConeScaling(const ConeShape& shape, const Eigen::VectorXd& s, const Eigen::VectorXd& y);

  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& v) const;            ///< W v
  [[nodiscard]] Eigen::VectorXd inverse(const Eigen::VectorXd& v) const;          ///< W^-1 v
  [[nodiscard]] Eigen::VectorXd inverse_squared(const Eigen::VectorXd& v) const;  ///< W^-2 v
  /// The diagonal of W^-2 without the rank-one part of its cones, and with 0 in the place of their
  /// a.
  [[nodiscard]] Eigen::VectorXd diagonal() const;
  /// Returns r of each cone, with 0 in the place of its a: W^-2 = diagonal + r r' for all entries
  /// except the entries of a.
  [[nodiscard]] std::vector<Eigen::VectorXd> rank_ones() const;

 private:
  const ConeShape& shape_;
  Eigen::VectorXd root_;      ///< root of s / y, for the numbers
  std::vector<double> size_;  ///< e
  std::vector<Eigen::VectorXd> w_;
};

}  // namespace jounce::optimize_detail
