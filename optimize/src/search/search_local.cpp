// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "optimize/src/search/search_shown.hpp"
#include "optimize/src/search/search_steps.hpp"
#include "optimize/src/solvers/local_solver.hpp"

// The local solvers of a search. Trials keeps the best of all evaluated points, by its own evaluation of the
// constraints. The status of NLopt is ignored: it reports success at infeasible ends.
//
// COBYLA needs neither derivatives nor smoothness, but makes small steps in curved valleys. SLSQP with central
// differences follows such valleys. Of eleven test problems COBYLA alone failed on Rosenbrock's in a disc (5 of
// 20 starts). With SLSQP before it, it failed on none.

namespace jounce::optimizer {
namespace {

/// The function of a search in the form of a solver. Values and slopes of one point are computed once.
class Run {
 public:
  Run(Trials& trials, double hair, double difference)
      : trials_(trials), hair_(hair), difference_(difference) {}

  /// Runs a method. `local` has its stopping criteria.
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

/// The best point since evaluation number `from`.
Trial best_since(const Trials& trials, std::size_t from) {
  const auto begin = trials.all().begin() + static_cast<std::ptrdiff_t>(from);
  if (begin == trials.all().end()) return trials.best();
  return *std::min_element(begin, trials.all().end(), better);
}

/// True if a point near the best is better: tries each direction of a turned cross at three distances.
bool probe(Trials& trials) {
  const Trial before = trials.best();
  const std::size_t n = trials.size();
  for (const double radius : {1e-2, 1e-3, 1e-4})
    for (std::size_t k = 0; k < n; ++k)
      for (const double sign : {1.0, -1.0}) {
        Choice z =
            before
                .z;  // half along axis k and half along the next axis, because edges are often parallel to an axis
        z[k] = std::clamp(z[k] + sign * radius, 0.0, 1.0);
        z[(k + 1) % n] = std::clamp(z[(k + 1) % n] + radius / 2, 0.0, 1.0);
        trials.at(z);
      }
  return is_gain(trials, before, trials.best());
}

/// Moves variables that ended next to a bound onto it, where that is no loss.
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
  double step =
      1e-4;  // for the differences of SLSQP: first above the errors of an integration, then finer
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
