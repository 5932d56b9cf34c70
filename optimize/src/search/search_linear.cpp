// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "optimize/src/search/search_phases.hpp"
#include "optimize/src/search/solver_values.hpp"
#include "optimize/src/solvers/interior_point.hpp"

// The last test of a search, after all its solvers. With gradients g of the objective and a_i of
// the rows at the best z, the step d of
//
//   (1)  minimize  g . d   subject to  r_i(z) + a_i . d <= 0,   |d_k| <= radius,   0 <= z + d <= 1
//
// is tried at several radii. If the step exceeds a row because the rows are curved, it is corrected
// once with the values of the rows at its end (a second-order correction; J. Nocedal and S. Wright,
// Numerical Optimization, 2006, 18.3):
//
//   (2)  r_i(z) in (1) is replaced by  r_i(z + d) - a_i . d

namespace jounce::optimize_detail {
namespace {

// Steps of the differences that estimate the slopes, relative to the free interval.
constexpr double coarse_difference = 1e-4;
constexpr double fine_difference = 1e-6;
constexpr double acceptable_residual =
    1e-6;  ///< residual of a program whose solution is worth trying

class Linear {
 public:
  Linear(Evaluations& evaluations, Choice z, double margin, double difference)
      : evaluations_(evaluations),
        z_(std::move(z)),
        margin_(margin),
        here_(solver_values(evaluations, z_, margin)),
        slopes_(slopes(evaluations, z_, margin, difference)) {}

  /// Tries (1) and (2) within a radius.
  void attempt(double radius) {
    const auto d = step(here_.rows, radius);
    if (!d) return;
    const SolverValues there = solver_values(evaluations_, moved(*d), margin_);
    if (*std::max_element(there.rows.begin(), there.rows.end()) <= margin_) return;
    std::vector<double> corrected = there.rows;
    for (std::size_t i = 0; i < corrected.size(); ++i)
      for (std::size_t k = 0; k < d->size(); ++k) corrected[i] -= slopes_[k].rows[i] * (*d)[k];
    if (const auto better = step(corrected, radius)) evaluations_.at(moved(*better));
  }

 private:
  [[nodiscard]] Choice moved(const Choice& d) const {
    Choice z = z_;
    for (std::size_t k = 0; k < z.size(); ++k) z[k] = std::clamp(z[k] + d[k], 0.0, 1.0);
    return z;
  }

  [[nodiscard]] std::optional<Choice> step(const std::vector<double>& rows, double radius) const {
    const std::size_t n = z_.size();
    double steepest = 0;
    for (const SolverValues& slope : slopes_)
      steepest = std::max(steepest, std::abs(slope.objective));
    if (!(steepest > 0)) return {};
    ConvexProgram p{Choice(n), {}, {}, {}};
    for (std::size_t k = 0; k < n; ++k) {  // d = radius x
      p.slope[k] = slopes_[k].objective / steepest;
      p.constraints.push_back({-std::min(1.0, (1 - z_[k]) / radius), {{k, 1}}});
      p.constraints.push_back({-std::min(1.0, z_[k] / radius), {{k, -1}}});
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (auto row = row_of(rows[i], i, radius)) p.constraints.push_back(std::move(*row));
    ConvexSolution found = solve(p, Choice(n, 0));
    if (!(found.residual <= acceptable_residual)) return {};
    for (double& each : found.x) each *= radius;
    return found.x;
  }

  /// A row of size one; none where no step within the radius reaches it.
  [[nodiscard]] std::optional<Form> row_of(double value, std::size_t i, double radius) const {
    Form form{value, {}};
    double reach = 0;
    for (std::size_t k = 0; k < slopes_.size(); ++k) {
      form.terms.push_back({k, slopes_[k].rows[i] * radius});
      reach += std::abs(form.terms.back().factor);
    }
    if (value + reach < 0 || !(reach > 0)) return {};
    return scaled(std::move(form), 1 / std::max(reach, std::abs(value)));
  }

  Evaluations& evaluations_;
  Choice z_;
  double margin_;
  SolverValues here_;
  std::vector<SolverValues> slopes_;
};

}  // namespace

bool linearized_step(Evaluations& evaluations) {
  const Evaluation before = evaluations.best();
  if (before.violation > 0) return false;
  for (const double difference : {coarse_difference, fine_difference}) {
    Linear linear(evaluations, before.z, 1e-3 * evaluations.options().tolerance, difference);
    for (const double radius : {0.1, 0.03, 1e-2, 3e-3, 1e-3, 1e-4}) linear.attempt(radius);
    if (is_gain(evaluations, before, evaluations.best())) return true;
  }
  return false;
}

}  // namespace jounce::optimize_detail
