// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/optimize.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "jounce/profiles/error.hpp"

#include "optimize/src/knots/bound.hpp"
#include "optimize/src/knots/convex_bound.hpp"
#include "optimize/src/knots/multi_start.hpp"
#include "optimize/src/search/findings.hpp"
#include "optimize/src/tolerances.hpp"

namespace jounce {
namespace {

using optimize_detail::brief;
using optimize_detail::DerivativeBound;
using optimize_detail::LocalSolution;
using optimize_detail::natural_zero;
using optimize_detail::Point;
using optimize_detail::Space;
using optimize_detail::Subproblem;
using Clock = std::chrono::steady_clock;

/// A significant change of the k-th derivative of this cam.
double natural(const Space& space, std::size_t order) {
  return space.stroke / std::pow(space.length(), static_cast<double>(order));
}

std::size_t order_of(Objective objective) {
  return objective == Objective::peak_jerk ? 3 : 2;
}

/// One call of optimize(): the starts, one objective after the other, and the outcome.
class Search {
 public:
  Search(const CamProblem& problem, const KeepGoing& keep_going)
      : problem_(problem),
        max_evaluations_(problem.options.budget.evaluations.value_or(50000)),
        keep_going_(keep_going),
        space_(problem) {
    const CamDesign given = design(problem.cam);
    for (const Objective objective : problem.minimize) {
      const double value = value_of(objective, given.cam);
      outcome_.figures.push_back({name(objective), value, value, lower_bound(problem, objective)});
    }
    for (Finding finding :
         optimize_detail::limits_of(problem.limits, problem.ramped, given.cam).findings) {
      if (!finding.broken || broken_where_fixed_) continue;
      finding.segment = given.origin[*finding.segment];
      if (!space_.moves[*finding.segment]) broken_where_fixed_ = finding;
    }
    ceilings_ = optimize_detail::ceilings_of(problem.limits, problem.ramped, space_);
  }

  Outcome<CamSpec> run() {
    find_feasible();
    for (std::size_t k = 0;
         k < problem_.minimize.size() && feasible() && !cancelled_ && !out_of_time_; ++k)
      minimize(k);
    finish();
    return std::move(outcome_);
  }

 private:
  [[nodiscard]] bool feasible() const { return !pool_.empty(); }

  [[nodiscard]] int evaluations_left() const { return max_evaluations_ - outcome_.evaluations; }

  /// Called repeatedly while the starts of an objective run.
  bool go_on(std::size_t objective, std::size_t done, std::size_t starts,
             const std::optional<double>& reached) {
    const std::chrono::duration<double> gone = Clock::now() - begin_;
    const auto seconds = problem_.options.budget.seconds;
    if (seconds && gone.count() >= *seconds) out_of_time_ = true;
    if (keep_going_ && !cancelled_) {
      const double tried =
          static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(starts, 1));
      const double stages = static_cast<double>(problem_.minimize.size());
      cancelled_ = !keep_going_({.done = (static_cast<double>(objective) + tried) / stages,
                                 .stage = objective,
                                 .evaluations = outcome_.evaluations,
                                 .reached = reached});
    }
    return !cancelled_ && !out_of_time_;
  }

  /// Runs all starts of a subproblem, each with its share of the remaining evaluations.
  std::vector<LocalSolution> attempted(std::size_t objective, const Subproblem& subproblem,
                                       const std::vector<Point>& starts,
                                       const std::function<bool(const LocalSolution&)>& enough) {
    const auto count = starts.size();
    const bool go = go_on(objective, 0, count, {});
    share_ = go ? std::max(0, evaluations_left()) / static_cast<int>(count) : 0;
    std::vector<LocalSolution> all = optimize_detail::multi_start(
        subproblem, starts,
        {share_,
         [&](std::size_t done, const std::optional<optimize_detail::Merit>& best) {
           const bool known =
               best && subproblem.objective && best->excess <= optimize_detail::rounding_tolerance;
           return go_on(objective, done, count, known ? std::optional(best->value) : std::nullopt);
         },
         enough});
    for (const LocalSolution& attempt : all) outcome_.evaluations += attempt.evaluations;
    return all;
  }

  /// True if an attempt ended for lack of evaluations.
  [[nodiscard]] bool starved(const LocalSolution& attempt) const {
    return !attempt.converged && attempt.evaluations >= share_;
  }

  /// Minimizes the violation of the limits from every start. The pool receives the points that keep the limits.
  void find_feasible() {
    const Subproblem subproblem{space_, ceilings_, {}, {}, 0, problem_.options.tolerance};
    const int count = space_.convex() ? 1 : problem_.options.starts.value_or(8);
    std::vector<Point> starts;
    for (int i = 0; i < count; ++i)
      starts.push_back(
          optimize_detail::start_point(space_, problem_.options.seed, static_cast<std::size_t>(i)));
    outcome_.starts = static_cast<int>(starts.size());
    for (const LocalSolution& attempt : attempted(0, subproblem, starts, {})) {
      if (attempt.merit.excess <= optimize_detail::rounding_tolerance && !broken_where_fixed_)
        pool_.push_back(attempt.z);
      else if (!least_violated_ || attempt.merit.excess < least_violated_->merit.excess)
        least_violated_ = attempt;
    }
    exhausted_ = !feasible() && least_violated_ && starved(*least_violated_);
  }

  /// The limits, and the objectives before the k-th, each kept within the tolerance.
  [[nodiscard]] Subproblem subproblem(std::size_t k) const {
    const double natural_k = natural(space_, order_of(problem_.minimize[k]));
    Subproblem subproblem{space_,
                          ceilings_,
                          {},
                          problem_.minimize[k],
                          natural_zero * natural_k,
                          problem_.options.tolerance};
    for (std::size_t i = 0; i < k; ++i) {
      const FigureResult& r = outcome_.figures[i];
      const Objective objective = problem_.minimize[i];
      const std::size_t order = order_of(objective);
      // At the bound, the tolerance is relative to the bound, so that `optimal` stays true.
      const double from = at_bound(i, r.reached) ? *r.bound : r.reached;
      const double cap =
          std::max(from * (1 + problem_.options.tolerance), natural_zero * natural(space_, order));
      if (objective == Objective::rms_acceleration)
        subproblem.rms_ceiling = cap;
      else
        for (const double sign : {1.0, -1.0})
          subproblem.ceilings.push_back({order, sign, cap, cap});
    }
    return subproblem;
  }

  void minimize(std::size_t k) {
    const Subproblem subproblem = this->subproblem(k);
    const bool last = k + 1 == problem_.minimize.size();
    std::vector<LocalSolution> kept;
    for (LocalSolution& attempt : attempted(k, subproblem, pool_, [&](const LocalSolution& each) {
           return last && at_bound(k, each.merit.value);
         })) {
      if (!kept.empty() && attempt.merit.excess > optimize_detail::rounding_tolerance) continue;
      kept.push_back(std::move(attempt));
    }
    keep_best(k, std::move(kept));
  }

  /// The pool for the next objective: every distinct point that is as good as the best.
  void keep_best(std::size_t k, std::vector<LocalSolution> solutions) {
    std::stable_sort(solutions.begin(), solutions.end(),
                     [](const LocalSolution& a, const LocalSolution& b) {
                       return a.merit.value < b.merit.value;
                     });
    const double best = solutions.front().merit.value;
    outcome_.figures[k].reached = best;
    converged_ = converged_ && solutions.front().converged;
    exhausted_ = exhausted_ || starved(solutions.front());
    pool_.clear();
    for (const LocalSolution& solution : solutions)
      if (solution.merit.value <= best * (1 + problem_.options.tolerance) && distinct(solution.z))
        pool_.push_back(solution.z);
  }

  [[nodiscard]] bool distinct(const Point& z) const {
    return std::none_of(pool_.begin(), pool_.end(), [&](const Point& other) {
      const auto largest = [](double a, double b) { return std::max(a, b); };
      const auto apart = [](double a, double b) { return std::abs(a - b); };
      return std::transform_reduce(z.begin(), z.end(), other.begin(), 0.0, largest, apart) < 1e-4;
    });
  }

  [[nodiscard]] bool at_bound(std::size_t k, double reached) const {
    const double bound = *outcome_.figures[k].bound;
    const double scale =
        std::max(bound, natural_zero * natural(space_, order_of(problem_.minimize[k])));
    return reached - bound <= problem_.options.tolerance * scale;
  }

  void finish() {
    const Point z =
        feasible() ? pool_.front()
                   : (least_violated_ ? least_violated_->z : Point(space_.variables.size(), 0.0));
    outcome_.best = optimize_detail::spec_at(space_, z);
    const CamDesign made = design(outcome_.best);
    for (std::size_t k = 0; k < outcome_.figures.size(); ++k)
      outcome_.figures[k].reached = value_of(problem_.minimize[k], made.cam);
    outcome_.limits = optimize_detail::limits_of(problem_.limits, problem_.ramped, made.cam);
    for (Finding& finding : outcome_.limits.findings)
      if (finding.segment) finding.segment = made.origin[*finding.segment];
    if (feasible() && space_.convex()) prove(z);
    outcome_.feasible = outcome_.limits.ok();
    outcome_.value = outcome_.figures.back().reached;
    outcome_.bound = outcome_.figures.back().bound;
    outcome_.active =
        optimize_detail::active_findings(space_, ceilings_, z, problem_.minimize, outcome_.figures);
    set_status();
  }

  /// Each objective alone, under the limits.
  void prove(const Point& z) {
    for (std::size_t k = 0; k < outcome_.figures.size(); ++k) {
      FigureResult& r = outcome_.figures[k];
      const double natural_k = natural(space_, order_of(problem_.minimize[k]));
      const Subproblem alone{space_,
                             ceilings_,
                             {},
                             problem_.minimize[k],
                             natural_zero * natural_k,
                             problem_.options.tolerance};
      r.bound = std::max(*r.bound, std::min(optimize_detail::convex_bound(alone, z), r.reached));
    }
  }

  void set_status() {
    bool all_at_bound = true;
    for (std::size_t k = 0; k < outcome_.figures.size(); ++k)
      all_at_bound = all_at_bound && at_bound(k, outcome_.figures[k].reached);
    const auto answer = [&](OptimizeStatus status, std::string reason) {
      outcome_.status = status;
      outcome_.reason = std::move(reason);
    };
    if (!outcome_.limits.ok() && !cancelled_ && !exhausted_ && !out_of_time_)
      answer(OptimizeStatus::infeasible, why_infeasible());
    else if (cancelled_)
      answer(OptimizeStatus::cancelled, "stopped by the caller");
    else if (outcome_.limits.ok() && all_at_bound)
      answer(OptimizeStatus::optimal,
             "every objective is at its proven bound, within the relative tolerance " +
                 brief(problem_.options.tolerance));
    else if (out_of_time_)
      answer(OptimizeStatus::stalled,
             "the time limit of " + brief(*problem_.options.budget.seconds) + " s is reached");
    else if (exhausted_)
      answer(OptimizeStatus::stalled,
             "the limit of " + std::to_string(max_evaluations_) + " evaluations is reached");
    else if (!converged_)
      answer(OptimizeStatus::stalled, "the solver stopped before it converged");
    else
      answer(OptimizeStatus::converged, why_converged());
  }

  [[nodiscard]] std::string why_converged() const {
    std::size_t open = 0;  // the first objective that is above its bound
    while (open + 1 < outcome_.figures.size() && at_bound(open, outcome_.figures[open].reached))
      ++open;
    const FigureResult& r = outcome_.figures[open];
    const std::string gap =
        *r.bound > 0
            ? "at most " + brief(100 * *r.gap()) + " % of " + r.name + " could still be saved"
            : "no lower bound above 0 is known for " + r.name +
                  (space_.convex() ? "" : ": free masters make the problem non-convex") +
                  ", and none follows from the fixed knots alone";
    if (space_.convex())
      return "no other values of the free quantities are better (the problem is convex); " + gap;
    return "none of " + std::to_string(outcome_.starts) + " starts led to an improvement; " + gap;
  }

  [[nodiscard]] std::string why_infeasible() const {
    if (const auto& broken = broken_where_fixed_)
      return "no free quantity changes segment " + std::to_string(*broken->segment + 1) +
             ", where " + optimize_detail::sentence(*broken);
    const auto impossible = [&](Objective objective, const std::optional<double>& limit) {
      return limit &&
             lower_bound(problem_, objective) > *limit * (1 + optimize_detail::rounding_tolerance);
    };
    for (const auto& [objective, limit] :
         {std::pair{Objective::peak_acceleration, problem_.limits.acceleration},
          std::pair{Objective::peak_jerk, problem_.limits.jerk}})
      if (impossible(objective, limit))
        return std::string("no law through the fixed knots can keep the limits: ") +
               name(objective) + " of at least " + brief(lower_bound(problem_, objective)) +
               " is needed, " + brief(*limit) + " allowed";
    const std::string worst = optimize_detail::sentence(outcome_.limits.findings.front());
    if (space_.convex())
      return "no values of the free quantities meet the limits, and the problem is convex: at "
             "best " +
             worst;
    return "none of " + std::to_string(outcome_.starts) + " starts met the limits: at best " +
           worst;
  }

  const CamProblem& problem_;
  int max_evaluations_;
  const KeepGoing& keep_going_;
  Space space_;
  std::vector<DerivativeBound> ceilings_;
  std::vector<Point> pool_;
  std::optional<LocalSolution> least_violated_;
  std::optional<Finding>
      broken_where_fixed_;  ///< a limit that is broken where no free quantity changes the cam
  Outcome<CamSpec> outcome_;
  Clock::time_point begin_ = Clock::now();
  int share_ = 0;  ///< evaluations for each start
  bool cancelled_ = false;
  bool out_of_time_ = false;
  bool exhausted_ = false;
  bool converged_ = true;
};

}  // namespace

Outcome<CamSpec> optimize(const CamProblem& problem, const KeepGoing& keep_going) {
  require_valid(problem);
  return Search(problem, keep_going).run();
}

}  // namespace jounce
