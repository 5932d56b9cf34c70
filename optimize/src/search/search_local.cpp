// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "optimize/src/search/search_phases.hpp"
#include "optimize/src/search/solver_values.hpp"
#include "optimize/src/solvers/local_solver.hpp"

// The local solvers of a search. Evaluations keeps the best of all evaluated points, by its own
// test of the constraints. The status of NLopt is ignored, because it reports success at infeasible
// points.
//
// COBYLA needs neither derivatives nor smoothness, but makes small steps in curved valleys. SLSQP
// with central differences follows such valleys. Of eleven test problems, COBYLA alone failed on
// one, Rosenbrock's function in a disc (5 of 20 starts). With SLSQP before it, it failed on none.

namespace jounce::optimize_detail {
namespace {

constexpr double least_first_step = 1e-7;  ///< first step of a further attempt

/// The function of a search in the form of a solver. Values and slopes of one point are computed once.
class LocalSearch {
 public:
  LocalSearch(Evaluations& evaluations, double margin, double difference)
      : evaluations_(evaluations), margin_(margin), difference_(difference) {}

  /// Runs a method. `local` has its stopping criteria.
  void from(const Choice& z, LocalProblem local) {
    local.lower = Choice(z.size(), 0.0);
    local.upper = Choice(z.size(), 1.0);
    local.rows = evaluations_.best().answer.constraints.size() + 1;
    local.objective = [&](std::span<const double> x, std::span<double> gradient) {
      const Choice at(x.begin(), x.end());
      const double value = values_at(at).objective;
      for (std::size_t k = 0; k < gradient.size(); ++k) gradient[k] = slopes_at(at)[k].objective;
      return value;
    };
    local.constraints = [&](std::span<const double> x, std::span<double> rows,
                            std::span<double> gradient) {
      const Choice at(x.begin(), x.end());
      std::copy_n(values_at(at).rows.begin(), rows.size(), rows.begin());
      if (gradient.empty()) return;
      for (std::size_t k = 0; k < at.size(); ++k)
        for (std::size_t i = 0; i < rows.size(); ++i)
          gradient[i * at.size() + k] = slopes_at(at)[k].rows[i];
    };
    run_local_solver(local, z);
  }

 private:
  const SolverValues& values_at(const Choice& z) {
    if (z != z_) {
      now_ = solver_values(evaluations_, z, margin_);
      z_ = z;
    }
    return now_;
  }

  const std::vector<SolverValues>& slopes_at(const Choice& z) {
    if (z == slopes_at_) return slopes_;
    slopes_ = slopes(evaluations_, z, margin_, difference_);
    slopes_at_ = z;
    return slopes_;
  }

  Evaluations& evaluations_;
  double margin_;
  double difference_;
  Choice z_, slopes_at_;
  SolverValues now_;
  std::vector<SolverValues> slopes_;
};

/// The best point since evaluation number `from`.
Evaluation best_since(const Evaluations& evaluations, std::size_t from) {
  const auto begin = evaluations.all().begin() + static_cast<std::ptrdiff_t>(from);
  if (begin == evaluations.all().end()) return evaluations.best();
  return *std::min_element(begin, evaluations.all().end(), better);
}

/// True if a point near the best is better: tries each direction of a turned cross at three distances.
bool probe(Evaluations& evaluations) {
  const Evaluation before = evaluations.best();
  const std::size_t n = evaluations.size();
  for (const double radius : {1e-2, 1e-3, 1e-4})
    for (std::size_t k = 0; k < n; ++k)
      for (const double sign : {1.0, -1.0}) {
        Choice z =
            before
                .z;  // half along axis k and half along the next axis, because edges are often parallel to an axis
        z[k] = std::clamp(z[k] + sign * radius, 0.0, 1.0);
        z[(k + 1) % n] = std::clamp(z[(k + 1) % n] + radius / 2, 0.0, 1.0);
        evaluations.at(z);
      }
  return is_gain(evaluations, before, evaluations.best());
}

/// Moves variables that ended next to a bound onto it, where that is no loss.
void settle_at_bounds(Evaluations& evaluations) {
  for (std::size_t k = 0; k < evaluations.size(); ++k) {
    Choice z = evaluations.best().z;
    const double bound = z[k] < 0.5 ? 0.0 : 1.0;
    if (z[k] == bound || std::abs(z[k] - bound) > 10 * evaluations.options().tolerance) continue;
    z[k] = bound;
    evaluations.at(z);
  }
}

/// Runs SLSQP from z, with central differences of this step.
void run_slsqp(Evaluations& evaluations, const Choice& z, double step, int iterations) {
  const double tolerance = evaluations.options().tolerance;
  LocalSearch(evaluations, 1e-3 * tolerance, step)
      .from(z, {.x_absolute = 1e-2 * tolerance, .max_evaluations = iterations});
}

}  // namespace

Evaluation run_cobyla(Evaluations& evaluations, const Choice& z, double radius, double smallest,
                      int max_evaluations) {
  const std::size_t from = evaluations.all().size();
  LocalSearch(evaluations, 0, 0)
      .from(z, {.method = LocalProblem::Method::cobyla,
                .initial_step = radius,
                .x_absolute = smallest,
                .max_evaluations = max_evaluations});
  return best_since(evaluations, from);
}

bool polish(Evaluations& evaluations) {
  const int n = static_cast<int>(evaluations.size());
  const double smallest = 0.1 * evaluations.options().tolerance;
  double radius = 0.1;
  double step =
      1e-4;  // for the differences of SLSQP: first above the errors of an integration, then finer
  for (int round = 0; round < 12; ++round) {
    const Evaluation before = evaluations.best();
    run_slsqp(evaluations, before.z, step, 60);
    run_cobyla(evaluations, evaluations.best().z, radius, smallest, 60 * (n + 2));
    settle_at_bounds(evaluations);
    if (!is_gain(evaluations, before, evaluations.best()) && !probe(evaluations) &&
        !linearized_step(evaluations))
      return true;
    radius = std::max(0.3 * radius, 1e-3);
    step = std::max(0.1 * step, least_first_step);
  }
  return false;
}

}  // namespace jounce::optimize_detail
