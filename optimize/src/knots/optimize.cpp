// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/optimize.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "jounce/optimize/bound.hpp"
#include "jounce/optimize/ramped.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/src/knots/convex_bound.hpp"
#include "optimize/src/search/attempts.hpp"
#include "optimize/src/search/findings.hpp"

namespace jounce {
namespace {

using optimizer::Attempt;
using optimizer::brief;
using optimizer::DerivativeBound;
using optimizer::Point;
using optimizer::Space;
using optimizer::Stage;
using Clock = std::chrono::steady_clock;

/// A change of the k-th derivative that this cam would notice.
double natural(const Space& space, std::size_t order) {
  return space.stroke / std::pow(space.length(), static_cast<double>(order));
}

std::size_t order_of(Objective objective) {
  return objective == Objective::peak_jerk ? 3 : 2;
}

/// One call of optimize(): starts, one objective after the other, and the answer.
class Search {
 public:
  Search(const CamProblem& problem, const RampedLimits& ramped, const KeepGoing& keep_going)
      : problem_(problem), ramped_(ramped), keep_going_(keep_going), space_(problem) {
    const CamDesign given = design(problem.cam);
    for (const Objective objective : problem.minimize) {
      const double value = value_of(objective, given.cam);
      outcome_.objectives.push_back({objective, value, value, lower_bound(problem, objective)});
    }
    for (Finding finding : optimizer::limits_of(problem.limits, ramped, given.cam).findings) {
      if (!finding.broken || broken_where_fixed_) continue;
      finding.segment = given.origin[*finding.segment];
      if (!space_.moves[*finding.segment]) broken_where_fixed_ = finding;
    }
    ceilings_ = optimizer::ceilings_of(problem.limits, ramped, space_);
  }

  Outcome run() {
    find_feasible();
    for (std::size_t k = 0;
         k < problem_.minimize.size() && feasible() && !cancelled_ && !out_of_time_; ++k)
      minimise(k);
    finish();
    return std::move(outcome_);
  }

 private:
  [[nodiscard]] bool feasible() const { return !pool_.empty(); }

  [[nodiscard]] int evaluations_left() const {
    return problem_.max_evaluations - outcome_.evaluations;
  }

  /// Asked again and again while the starts of an objective run.
  bool go_on(std::size_t objective, std::size_t done, std::size_t starts,
             const std::optional<double>& reached) {
    const std::chrono::duration<double> gone = Clock::now() - begin_;
    if (problem_.seconds && gone.count() >= *problem_.seconds) out_of_time_ = true;
    if (keep_going_ && !cancelled_) {
      OptimizeProgress progress{objective, done, starts, outcome_.evaluations, reached};
      cancelled_ = !keep_going_(progress);
    }
    return !cancelled_ && !out_of_time_;
  }

  /// All starts of a stage, each with its share of the evaluations that are left.
  std::vector<Attempt> attempted(std::size_t objective, const Stage& stage,
                                 const std::vector<Point>& starts,
                                 const std::function<bool(const Attempt&)>& enough) {
    const auto count = starts.size();
    const bool go = go_on(objective, 0, count, {});
    share_ = go ? std::max(0, evaluations_left()) / static_cast<int>(count) : 0;
    std::vector<Attempt> all = optimizer::attempts(
        stage, starts,
        {share_,
         [&](std::size_t done, const std::optional<optimizer::Standing>& best) {
           const bool known = best && stage.objective && best->excess <= optimizer::rounding;
           return go_on(objective, done, count, known ? std::optional(best->value) : std::nullopt);
         },
         enough});
    for (const Attempt& attempt : all) outcome_.evaluations += attempt.evaluations;
    return all;
  }

  /// Whether more evaluations might have led an attempt further.
  [[nodiscard]] bool starved(const Attempt& attempt) const {
    return !attempt.converged && attempt.evaluations >= share_;
  }

  /// The limits alone, from every start: what keeps them goes into the pool.
  void find_feasible() {
    const Stage stage{space_, ceilings_, {}, {}, 0, problem_.tolerance};
    std::vector<Point> starts;
    for (std::size_t i = 0; i < (space_.convex() ? 1U : static_cast<unsigned>(problem_.starts));
         ++i)
      starts.push_back(optimizer::start_point(space_, problem_.seed, i));
    outcome_.starts = static_cast<int>(starts.size());
    for (const Attempt& attempt : attempted(0, stage, starts, {})) {
      if (attempt.standing.excess <= optimizer::rounding && !broken_where_fixed_)
        pool_.push_back(attempt.z);
      else if (!least_violated_ || attempt.standing.excess < least_violated_->standing.excess)
        least_violated_ = attempt;
    }
    exhausted_ = !feasible() && least_violated_ && starved(*least_violated_);
  }

  /// Limits, and the objectives before the k-th kept within tolerance.
  [[nodiscard]] Stage stage(std::size_t k) const {
    const double natural_k = natural(space_, order_of(problem_.minimize[k]));
    Stage stage{space_, ceilings_, {}, problem_.minimize[k], 1e-9 * natural_k, problem_.tolerance};
    for (std::size_t i = 0; i < k; ++i) {
      const ObjectiveResult& r = outcome_.objectives[i];
      const std::size_t order = order_of(r.objective);
      // At the bound, the tolerance counts from there, so that `optimal` stays true.
      const double from = at_bound(i, r.reached) ? r.bound : r.reached;
      const double cap = std::max(from * (1 + problem_.tolerance), 1e-9 * natural(space_, order));
      if (r.objective == Objective::rms_acceleration)
        stage.rms_ceiling = cap;
      else
        for (const double sign : {1.0, -1.0}) stage.ceilings.push_back({order, sign, cap, cap});
    }
    return stage;
  }

  void minimise(std::size_t k) {
    const Stage stage = this->stage(k);
    const bool last = k + 1 == problem_.minimize.size();
    std::vector<Attempt> kept;
    for (Attempt& attempt : attempted(k, stage, pool_, [&](const Attempt& each) {
           return last && at_bound(k, each.standing.value);
         })) {
      if (!kept.empty() && attempt.standing.excess > optimizer::rounding) continue;
      kept.push_back(std::move(attempt));
    }
    keep_best(k, std::move(kept));
  }

  /// The pool for the next objective: every distinct point that is as good as the best.
  void keep_best(std::size_t k, std::vector<Attempt> attempts) {
    std::stable_sort(attempts.begin(), attempts.end(), [](const Attempt& a, const Attempt& b) {
      return a.standing.value < b.standing.value;
    });
    const double best = attempts.front().standing.value;
    outcome_.objectives[k].reached = best;
    converged_ = converged_ && attempts.front().converged;
    exhausted_ = exhausted_ || starved(attempts.front());
    pool_.clear();
    for (const Attempt& attempt : attempts)
      if (attempt.standing.value <= best * (1 + problem_.tolerance) && distinct(attempt.z))
        pool_.push_back(attempt.z);
  }

  [[nodiscard]] bool distinct(const Point& z) const {
    return std::none_of(pool_.begin(), pool_.end(), [&](const Point& other) {
      double apart = 0;
      for (std::size_t i = 0; i < z.size(); ++i) apart = std::max(apart, std::abs(z[i] - other[i]));
      return apart < 1e-4;
    });
  }

  [[nodiscard]] bool at_bound(std::size_t k, double reached) const {
    const ObjectiveResult& r = outcome_.objectives[k];
    const double scale = std::max(r.bound, 1e-9 * natural(space_, order_of(r.objective)));
    return reached - r.bound <= problem_.tolerance * scale;
  }

  void finish() {
    const Point z =
        feasible() ? pool_.front()
                   : (least_violated_ ? least_violated_->z : Point(space_.variables.size(), 0.0));
    outcome_.best = optimizer::spec_at(space_, z);
    const CamDesign made = design(outcome_.best);
    for (ObjectiveResult& r : outcome_.objectives) r.reached = value_of(r.objective, made.cam);
    outcome_.limits = optimizer::limits_of(problem_.limits, ramped_, made.cam);
    for (Finding& finding : outcome_.limits.findings)
      if (finding.segment) finding.segment = made.origin[*finding.segment];
    if (feasible() && space_.convex()) prove(z);
    outcome_.active = optimizer::active_findings(space_, ceilings_, z, outcome_.objectives);
    set_status();
  }

  /// Each objective alone, under the limits.
  void prove(const Point& z) {
    for (ObjectiveResult& r : outcome_.objectives) {
      const double natural_r = natural(space_, order_of(r.objective));
      const Stage alone{space_, ceilings_, {}, r.objective, 1e-9 * natural_r, problem_.tolerance};
      r.bound = std::max(r.bound, std::min(optimizer::convex_bound(alone, z), r.reached));
    }
  }

  void set_status() {
    bool all_at_bound = true;
    for (std::size_t k = 0; k < outcome_.objectives.size(); ++k)
      all_at_bound = all_at_bound && at_bound(k, outcome_.objectives[k].reached);
    const auto answer = [&](Outcome::Status status, std::string reason) {
      outcome_.status = status;
      outcome_.reason = std::move(reason);
    };
    if (!outcome_.limits.ok() && !cancelled_ && !exhausted_ && !out_of_time_)
      answer(Outcome::Status::infeasible, why_infeasible());
    else if (cancelled_)
      answer(Outcome::Status::cancelled, "stopped by the caller");
    else if (outcome_.limits.ok() && all_at_bound)
      answer(Outcome::Status::optimal,
             "every objective is at its proven bound, to a relative " + brief(problem_.tolerance));
    else if (out_of_time_)
      answer(Outcome::Status::stalled,
             "the time limit of " + brief(*problem_.seconds) + " s is reached");
    else if (exhausted_)
      answer(Outcome::Status::stalled, "the limit of " + std::to_string(problem_.max_evaluations) +
                                           " evaluations is reached");
    else if (!converged_)
      answer(Outcome::Status::stalled, "the solver stopped before it converged");
    else
      answer(Outcome::Status::converged, why_converged());
  }

  [[nodiscard]] std::string why_converged() const {
    std::size_t open = 0;  // the first objective that is above its bound
    while (open + 1 < outcome_.objectives.size() &&
           at_bound(open, outcome_.objectives[open].reached))
      ++open;
    const ObjectiveResult& r = outcome_.objectives[open];
    const std::string gap =
        r.bound > 0 ? "at most " + brief(100 * r.gap()) + " % of " + name(r.objective) +
                          " could still be saved"
                    : std::string("no bound above 0 is known for ") + name(r.objective) +
                          (space_.convex() ? "" : ": free masters make the problem non-convex") +
                          ", and none follows from the fixed knots alone";
    if (space_.convex())
      return "no other values of the free quantities are better (the problem is convex); " + gap;
    return "none of " + std::to_string(outcome_.starts) + " starts led to an improvement; " + gap;
  }

  [[nodiscard]] std::string why_infeasible() const {
    if (const auto& broken = broken_where_fixed_)
      return "no free quantity changes segment " + std::to_string(*broken->segment + 1) +
             ", where " + optimizer::sentence(*broken);
    const auto impossible = [&](Objective objective, const std::optional<double>& limit) {
      return limit && lower_bound(problem_, objective) > *limit * (1 + optimizer::rounding);
    };
    for (const auto& [objective, limit] :
         {std::pair{Objective::peak_acceleration, problem_.limits.acceleration},
          std::pair{Objective::peak_jerk, problem_.limits.jerk}})
      if (impossible(objective, limit))
        return std::string("no law through the fixed knots can keep the limits: ") +
               name(objective) + " of at least " + brief(lower_bound(problem_, objective)) +
               " is needed, " + brief(*limit) + " allowed";
    const std::string worst = optimizer::sentence(outcome_.limits.findings.front());
    if (space_.convex())
      return "no values of the free quantities meet the limits, and the problem is convex: at "
             "best " +
             worst;
    return "none of " + std::to_string(outcome_.starts) + " starts met the limits: at best " +
           worst;
  }

  const CamProblem& problem_;
  const RampedLimits& ramped_;
  const KeepGoing& keep_going_;
  Space space_;
  std::vector<DerivativeBound> ceilings_;
  std::vector<Point> pool_;
  std::optional<Attempt> least_violated_;
  std::optional<Finding> broken_where_fixed_;  ///< a limit, where nothing free reaches
  Outcome outcome_;
  Clock::time_point begin_ = Clock::now();
  int share_ = 0;  ///< evaluations for each start
  bool cancelled_ = false;
  bool out_of_time_ = false;
  bool exhausted_ = false;
  bool converged_ = true;
};

}  // namespace

double ObjectiveResult::gap() const {
  return reached > bound ? (reached - bound) / reached : 0;
}

const char* name(Outcome::Status status) {
  switch (status) {
    case Outcome::Status::optimal:
      return "optimal";
    case Outcome::Status::converged:
      return "converged";
    case Outcome::Status::stalled:
      return "stalled";
    case Outcome::Status::cancelled:
      return "cancelled";
    case Outcome::Status::infeasible:
      break;
  }
  return "infeasible";
}

Outcome optimize(const CamProblem& problem, const KeepGoing& keep_going) {
  return optimize(problem, RampedLimits{}, keep_going);
}

Outcome optimize(const CamProblem& problem, const RampedLimits& ramped,
                 const KeepGoing& keep_going) {
  require_valid(problem);
  require_not_negative("ramp", ramped.ramp);
  require_valid(ramped.limits);
  return Search(problem, ramped, keep_going).run();
}

}  // namespace jounce
