// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/chebyshev.hpp"

#include <cmath>
#include <numbers>

namespace jounce::optimize_detail {
namespace {

constexpr std::size_t most = 64;
constexpr double lost = 1e-13;

/// (e rho / 2 n)^n.
double left_by(std::size_t n, double rho) {
  const auto count = static_cast<double>(n);
  return std::pow(std::numbers::e * rho / (2 * count), count);
}

}  // namespace

ChebyshevNodes::ChebyshevNodes(double low, double high, double size) {
  std::size_t n = 1;
  if (high > low)
    while (n < most && left_by(n, size * (high - low) / 2) > lost) ++n;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n);
    at_.push_back((low + high) / 2 + (high - low) / 2 * std::cos(angle));
    weight_.push_back((k % 2 == 0 ? 1 : -1) * std::sin(angle));
  }
}

bool ChebyshevNodes::too_few() const {
  return at_.size() >= most;
}

std::vector<double> ChebyshevNodes::shares(double x) const {
  std::vector<double> share(at_.size(), 0);
  for (std::size_t k = 0; k < at_.size(); ++k)
    if (x == at_[k] || at_.size() == 1) {
      share[k] = 1;
      return share;
    }
  double sum = 0;
  for (std::size_t k = 0; k < at_.size(); ++k) sum += share[k] = weight_[k] / (x - at_[k]);
  for (double& each : share) each /= sum;
  return share;
}

}  // namespace jounce::optimize_detail
