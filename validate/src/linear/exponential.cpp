// SPDX-License-Identifier: Apache-2.0
#include "validate/src/linear/exponential.hpp"

#include <cmath>

#include "validate/src/linear/small_product.hpp"

namespace jounce::validate_detail {

// In powers of M^4 (Paterson & Stockmeyer 1973): six products instead of fifteen.
Eigen::MatrixXd exponential_series(const Eigen::MatrixXd& m) {
  static_assert(exponential_terms == 16);
  const Eigen::MatrixXd m2 = product(m, m);
  const Eigen::MatrixXd m3 = product(m2, m);
  const Eigen::MatrixXd m4 = product(m2, m2);
  // M^k / k! to M^(k+3) / (k+3)!, all times k!
  const auto four = [&](int k) {
    Eigen::MatrixXd sum = m / (k + 1) + m2 / ((k + 1) * (k + 2)) +
                          m3 / static_cast<double>((k + 1) * (k + 2) * (k + 3));
    sum.diagonal().array() += 1;
    return sum;
  };
  Eigen::MatrixXd sum = four(12);
  for (int k = 8; k >= 0; k -= 4)
    sum = four(k) + product(m4, sum) / static_cast<double>((k + 1) * (k + 2) * (k + 3) * (k + 4));
  return sum;
}

Eigen::MatrixXd exponential(const Eigen::MatrixXd& m) {
  const double norm = m.cwiseAbs().rowwise().sum().maxCoeff();
  const int halved = norm > exponential_reach
                         ? static_cast<int>(std::ceil(std::log2(norm / exponential_reach)))
                         : 0;
  Eigen::MatrixXd e = exponential_series(std::ldexp(1.0, -halved) * m);
  for (int i = 0; i < halved; ++i) e = product(e, e);
  return e;
}

}  // namespace jounce::validate_detail
