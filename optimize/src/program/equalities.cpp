// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/equalities.hpp"

#include <cmath>

namespace jounce::optimize_detail {

double worst_equality(const ShapeModel& model, const Coordinates& z) {
  double worst = 0;
  for (const Form& f : model.equalities) {
    const double residual = std::abs(f.at(z));
    if (!(residual <= worst)) worst = residual;
    if (std::isnan(residual)) break;
  }
  return worst;
}

Coordinates as_fixed(const ShapeModel& model, Coordinates z) {
  constexpr int rounds = 4;
  constexpr double pull =
      1e-5;  // the nearest solution to z, by least squares, because an equality may be listed twice
  double worst = worst_equality(model, z);
  for (int round = 0; round < rounds && worst > 0; ++round) {
    ConvexProgram step{std::vector<double>(z.size(), 0), {}, {}, {}};
    for (const Form& f : model.equalities) {  // in units of the residual, to keep its digits
      step.squares.push_back(f);
      step.squares.back().constant = f.at(z) / worst;
    }
    for (std::size_t k = 0; k < z.size(); ++k) step.squares.push_back({0, {{k, pull}}});
    const std::vector<double> d = solve(step, Coordinates(z.size(), 0)).x;
    Coordinates moved = z;
    for (std::size_t k = 0; k < z.size(); ++k) moved[k] += worst * d[k];
    for (const Form& f : model.equalities)
      if (f.terms.size() == 1) moved[f.terms[0].index] = -f.constant / f.terms[0].factor;
    const double now = worst_equality(model, moved);
    if (!(now < worst)) break;
    z = std::move(moved);
    worst = now;
  }
  return z;
}

}  // namespace jounce::optimize_detail
