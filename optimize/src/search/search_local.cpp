// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "optimize/src/search/search_shown.hpp"
#include "optimize/src/search/search_steps.hpp"
#include "optimize/src/solvers/local_solver.hpp"

// NLopt's part of a search. What NLopt answers is not looked at: Trials keeps the best of all that was asked,
// by its own reading of the constraints (dependencies as measured: infeasible ends are called a success).
//
// COBYLA needs no derivatives and no smoothness, but creeps in curved valleys; SLSQP with central
// differences runs along them. Of eleven test problems COBYLA alone failed on Rosenbrock's in a disc
// (5 of 20 starts), with SLSQP before it on none of them.

namespace jounce::optimizer {
namespace {

/// The function of a search as a solver sees it: values and slopes of one point are computed once.
class Run {
 public:
  Run(Trials& trials, double hair, double difference)
      : trials_(trials), hair_(hair), difference_(difference) {}

  /// Runs a method with its ends set in `local`.
  void from(const Choice& z, LocalProblem local) {
    local.lower = Choice(z.size(), 0.0);
    local.upper = Choice(z.size(), 1.0);
    local.rows = trials_.best().answer.constraints.size() + 1;
    local.objective = [&](std::span<const double> x, std::span<double> gradient) {
      const Choice at(x.begin(), x.end());
      const double value = shown_at(at).objective;
      for (std::size_t k = 0; k < gradient.size(); ++k) gradient[k] = slopes_at(at)[k].objective;
      return value;
    };
    local.constraints = [&](std::span<const double> x, std::span<double> rows,
                            std::span<double> gradient) {
      const Choice at(x.begin(), x.end());
      std::copy_n(shown_at(at).rows.begin(), rows.size(), rows.begin());
      if (gradient.empty()) return;
      for (std::size_t k = 0; k < at.size(); ++k)
        for (std::size_t i = 0; i < rows.size(); ++i)
          gradient[i * at.size() + k] = slopes_at(at)[k].rows[i];
    };
    run_local_solver(local, z);
  }

 private:
  const Shown& shown_at(const Choice& z) {
    if (z != z_) {
      now_ = shown(trials_, z, hair_);
      z_ = z;
    }
    return now_;
  }

  const std::vector<Shown>& slopes_at(const Choice& z) {
    if (z == slopes_at_) return slopes_;
    slopes_ = slopes(trials_, z, hair_, difference_);
    slopes_at_ = z;
    return slopes_;
  }

  Trials& trials_;
  double hair_;
  double difference_;
  Choice z_, slopes_at_;
  Shown now_;
  std::vector<Shown> slopes_;
};

/// Where a run of asking ended: the best since `from`.
Trial best_since(const Trials& trials, std::size_t from) {
  const auto begin = trials.all().begin() + static_cast<std::ptrdiff_t>(from);
  if (begin == trials.all().end()) return trials.best();
  return *std::min_element(begin, trials.all().end(), better);
}

/// Whether something near the best is better: in each direction of a turned cross, at three distances.
bool probe(Trials& trials) {
  const Trial before = trials.best();
  const std::size_t n = trials.size();
  for (const double radius : {1e-2, 1e-3, 1e-4})
    for (std::size_t k = 0; k < n; ++k)
      for (const double sign : {1.0, -1.0}) {
        Choice z = before.z;  // half along axis k, half along the next: edges are often axes
        z[k] = std::clamp(z[k] + sign * radius, 0.0, 1.0);
        z[(k + 1) % n] = std::clamp(z[(k + 1) % n] + radius / 2, 0.0, 1.0);
        trials.at(z);
      }
  return is_gain(trials, before, trials.best());
}

/// Variables that ended beside a bound are put on it where that is no loss.
void settle_at_bounds(Trials& trials) {
  for (std::size_t k = 0; k < trials.size(); ++k) {
    Choice z = trials.best().z;
    const double bound = z[k] < 0.5 ? 0.0 : 1.0;
    if (z[k] == bound || std::abs(z[k] - bound) > 10 * trials.options().tolerance) continue;
    z[k] = bound;
    trials.at(z);
  }
}

}  // namespace

bool is_gain(const Trials& trials, const Trial& before, const Trial& after) {
  if (!better(after, before)) return false;
  const double tolerance = trials.options().tolerance;
  if (before.violation > 0) return after.violation < before.violation * (1 - 1e-3);
  const double gain = before.answer.objective - after.answer.objective;
  return gain > tolerance * (std::abs(after.answer.objective) + tolerance * trials.spread());
}

Trial descend(Trials& trials, const Choice& z, double radius, double smallest, int evaluations) {
  const std::size_t from = trials.all().size();
  Run(trials, 0, 0)
      .from(z, {.method = LocalProblem::Method::cobyla,
                .initial_step = radius,
                .x_absolute = smallest,
                .max_evaluations = evaluations});
  return best_since(trials, from);
}

void slide(Trials& trials, const Choice& z, double step, int iterations) {
  const double tolerance = trials.options().tolerance;
  Run(trials, 1e-3 * tolerance, step)
      .from(z, {.x_absolute = 1e-2 * tolerance, .max_evaluations = iterations});
}

bool polish(Trials& trials) {
  const int n = static_cast<int>(trials.size());
  const double smallest = 0.1 * trials.options().tolerance;
  double radius = 0.1;
  double step = 1e-4;  // of SLSQP's differences: above the noise of an integration, then finer
  for (int round = 0; round < 12; ++round) {
    const Trial before = trials.best();
    slide(trials, before.z, step, 60);
    descend(trials, trials.best().z, radius, smallest, 60 * (n + 2));
    settle_at_bounds(trials);
    if (!is_gain(trials, before, trials.best()) && !probe(trials) && !step_linearly(trials))
      return true;
    radius = std::max(0.3 * radius, 1e-3);
    step = std::max(0.1 * step, 1e-7);
  }
  return false;
}

}  // namespace jounce::optimizer
