// SPDX-License-Identifier: Apache-2.0
#include "validate/src/linear/linear_system.hpp"

#include <cmath>

namespace jounce::validate_detail {
namespace {

/// x_i = 2^power * (x_i of the scaled system).
void scale_state(LinearSystem& s, Eigen::Index i, int power) {
  const double f = std::ldexp(1.0, power);
  s.a.col(i) *= f;
  s.a.row(i) /= f;
  s.b.row(i) /= f;
  s.c.col(i) *= f;
  s.follows_position(i) /= f;
  s.follows_velocity(i) /= f;
  s.scale(i) *= f;
}

/// The power that makes row and column of a state equal; if one is zero, the other becomes 1.
int power_for(double row, double column) {
  if (row == 0 && column == 0) return 0;
  if (row == 0) return static_cast<int>(std::lround(-std::log2(column)));
  if (column == 0) return static_cast<int>(std::lround(std::log2(row)));
  return static_cast<int>(std::lround(std::log2(row / column) / 2));
}

}  // namespace

LinearSystem balanced(LinearSystem s) {
  constexpr int rounds = 20;  // each round halves the rest; four are usual
  bool changed = true;
  for (int round = 0; changed && round < rounds; ++round) {
    changed = false;
    for (Eigen::Index i = 0; i < s.states(); ++i) {
      const double own = std::abs(s.a(i, i));
      const double column = s.a.col(i).lpNorm<1>() - own;
      const double row = s.a.row(i).lpNorm<1>() - own;
      const int power = power_for(row, column);
      if (power == 0) continue;
      scale_state(s, i, power);
      changed = true;
    }
  }
  return s;
}

double rate(const LinearSystem& system) {
  return system.a.cwiseAbs().rowwise().sum().maxCoeff();
}

}  // namespace jounce::validate_detail
