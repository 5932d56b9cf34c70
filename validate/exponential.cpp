#include "jounce/validate/detail/exponential.hpp"

#include <cmath>

namespace jounce::detail {

Eigen::MatrixXd exponential_series(const Eigen::MatrixXd& m) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Identity(m.rows(), m.rows());
  for (int k = exponential_terms - 1; k > 0; --k) {  // Horner: I + M/1 (I + M/2 (I + ...))
    sum = (m * sum / k).eval();
    sum.diagonal().array() += 1;
  }
  return sum;
}

Eigen::MatrixXd exponential(const Eigen::MatrixXd& m) {
  const double norm = m.cwiseAbs().rowwise().sum().maxCoeff();
  const int halved = norm > exponential_reach
                         ? static_cast<int>(std::ceil(std::log2(norm / exponential_reach)))
                         : 0;
  Eigen::MatrixXd e = exponential_series(std::ldexp(1.0, -halved) * m);
  for (int i = 0; i < halved; ++i) e = (e * e).eval();
  return e;
}

}  // namespace jounce::detail
