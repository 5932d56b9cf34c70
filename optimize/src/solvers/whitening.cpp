// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/whitening.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::optimize_detail {

Whitening::Whitening(const Program& program, const Point& z0)
    : z0_(z0), n_(z0.size()), factor_(n_ * n_) {
  const auto knots = separated_knots(program.space, z0);
  std::vector<double> g(n_);
  for (const Row& row : program.rows) {
    std::fill(g.begin(), g.end(), 0.0);
    evaluate(program, row, knots, g);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        at(i, j) += g[i] * g[j] / static_cast<double>(program.rows.size());
  }
  for (std::size_t i = 0; i < n_; ++i) {
    const Variable& v = program.space.variables[i];
    const double width = (v.upper - v.lower) / v.scale;
    at(i, i) += 1 / (width * width);  // (1); also keeps H definite
  }
  cholesky();
}

Point Whitening::z(std::span<const double> y) const {
  Point z(y.begin(), y.end());
  for (std::size_t i = n_; i-- > 0;) {
    for (std::size_t k = i + 1; k < n_; ++k) z[i] -= at(k, i) * z[k];
    z[i] /= at(i, i);
  }
  for (std::size_t i = 0; i < n_; ++i) z[i] += z0_[i];
  return z;
}

void Whitening::turn(std::span<double> g) const {
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t k = 0; k < i; ++k) g[i] -= at(i, k) * g[k];
    g[i] /= at(i, i);
  }
}

void Whitening::cholesky() {
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k < j; ++k) at(i, j) -= at(i, k) * at(j, k);
      at(i, j) = i == j ? std::sqrt(at(i, i)) : at(i, j) / at(j, j);
    }
}

}  // namespace jounce::optimize_detail
