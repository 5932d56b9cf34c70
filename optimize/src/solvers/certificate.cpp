// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/certificate.hpp"

#include <algorithm>
#include <cmath>

// Let y >= 0 be the multipliers of the constraints, v those of the equalities, and w those of the
// forms of a round constraint (|forms| <= most). For every feasible x
//
//   (1)  objective(x) >= L(x) = slope . x + sum squares(x)^2 + sum y constraints(x) + sum v equalities(x)
//                               + w . forms(x) - |w| most
//
// and L is convex. With x0 the solution and r the gradient of L there,
//
//   (2)  L(x) >= L(x0) + r . (x - x0) >= L(x0) - sum |r_j| range_j.
//
// r is zero except for rounding. The range does not restrict the result: because the objective is
// convex, a point k times outside the range that were lower by e would imply a point inside it that
// is lower by e / k.

namespace jounce::optimize_detail {

double norm(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double each : numbers) sum += each * each;
  return std::sqrt(sum);
}

double weak_bound(const ConvexProgram& p, const ConvexSolution& found,
                  const std::vector<double>& range) {
  double bound = 0;
  std::vector<double> r = p.slope;
  for (std::size_t j = 0; j < r.size(); ++j) bound += p.slope[j] * found.x[j];
  const auto add = [&](const Form& form, double multiplier) {
    for (const Form::Term& t : form.terms) r[t.index] += multiplier * t.factor;
  };
  for (const Form& f : p.squares) {
    const double value = f.at(found.x);
    bound += value * value;
    add(f, 2 * value);
  }
  const auto dual = [&](const std::vector<Form>& forms, const std::vector<double>& multipliers,
                        double least) {
    for (std::size_t k = 0; k < forms.size(); ++k) {
      const double y = std::max(multipliers[k], least);
      bound += y * forms[k].at(found.x);
      add(forms[k], y);
    }
  };
  dual(p.constraints, found.multipliers, 0);
  dual(p.equalities, found.equal_multipliers, -HUGE_VAL);
  for (std::size_t k = 0; k < p.round.size(); ++k) {
    dual(p.round[k].forms, found.round_multipliers[k], -HUGE_VAL);
    bound -= norm(found.round_multipliers[k]) * p.round[k].most;
  }
  for (std::size_t j = 0; j < r.size(); ++j) bound -= std::abs(r[j]) * range[j];
  return bound;
}

}  // namespace jounce::optimize_detail
