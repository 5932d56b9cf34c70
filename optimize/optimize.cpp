#include "jounce/optimize/optimize.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/optimize/bound.hpp"
#include "jounce/optimize/detail/findings.hpp"
#include "jounce/optimize/detail/improve.hpp"

namespace jounce {
namespace {

using optimizer::Attempt;
using optimizer::brief;
using optimizer::Ceiling;
using optimizer::Point;
using optimizer::Space;
using optimizer::Stage;

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
  Search(const CamProblem& problem, const KeepGoing& keep_going)
      : problem_(problem), keep_going_(keep_going), space_(problem) {
    const CamDesign given = design(problem.cam);
    for (const Objective objective : problem.minimize) {
      const double value = value_of(objective, given.cam);
      outcome_.objectives.push_back({objective, value, value, lower_bound(problem, objective)});
    }
    for (Finding finding : check(given.cam, problem.limits).findings) {
      if (!finding.broken || broken_where_fixed_) continue;
      finding.segment = given.origin[*finding.segment];
      if (!space_.moves[*finding.segment]) broken_where_fixed_ = finding;
    }
    ceilings_ = optimizer::ceilings_of(problem.limits, space_);
  }

  Outcome run() {
    find_feasible();
    for (std::size_t k = 0; k < problem_.minimize.size() && feasible() && !cancelled_; ++k)
      minimise(k);
    finish();
    return std::move(outcome_);
  }

 private:
  [[nodiscard]] bool feasible() const { return !pool_.empty(); }

  [[nodiscard]] int evaluations_left() const {
    return problem_.max_evaluations - outcome_.evaluations;
  }

  bool go_on(std::size_t objective, std::size_t start, std::size_t starts) {
    if (evaluations_left() <= 0) exhausted_ = true;
    if (keep_going_ && !cancelled_) {
      OptimizeProgress progress{objective, start, starts, outcome_.evaluations, {}};
      if (best_value_) progress.reached = best_value_;
      cancelled_ = !keep_going_(progress);
    }
    return !exhausted_ && !cancelled_;
  }

  /// The limits alone, from every start: what keeps them goes into the pool.
  void find_feasible() {
    const Stage stage{space_, ceilings_, {}, {}, 0, problem_.tolerance};
    const auto starts =
        space_.convex() ? std::size_t{1} : static_cast<std::size_t>(problem_.starts);
    for (std::size_t i = 0; i < starts; ++i) {
      // The given cam is looked at even if there is no time for more.
      const bool go = go_on(0, i, starts);
      if (!go && i > 0) break;
      const Point start = optimizer::start_point(space_, problem_.seed, i);
      const Attempt attempt = optimizer::improve(stage, start, go ? evaluations_left() : 0);
      outcome_.evaluations += attempt.evaluations;
      ++outcome_.starts;
      if (attempt.standing.excess <= optimizer::rounding && !broken_where_fixed_)
        pool_.push_back(attempt.z);
      else if (!least_violated_ || attempt.standing.excess < least_violated_->standing.excess)
        least_violated_ = attempt;
      if (!go) break;
    }
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
    best_value_.reset();
    std::vector<Attempt> attempts;
    for (std::size_t i = 0; i < pool_.size(); ++i) {
      Attempt attempt{pool_[i], optimizer::standing(stage, pool_[i]), false, 0};
      if (go_on(k, i, pool_.size())) {
        attempt = optimizer::improve(stage, pool_[i], evaluations_left());
        outcome_.evaluations += attempt.evaluations;
      }
      if (i > 0 && attempt.standing.excess > optimizer::rounding) continue;  // the first has none
      if (!best_value_ || attempt.standing.value < *best_value_)
        best_value_ = attempt.standing.value;
      attempts.push_back(std::move(attempt));
      if (k + 1 == problem_.minimize.size() && at_bound(k, *best_value_)) break;
    }
    keep_best(k, std::move(attempts));
  }

  /// The pool for the next objective: every distinct point that is as good as the best.
  void keep_best(std::size_t k, std::vector<Attempt> attempts) {
    std::stable_sort(attempts.begin(), attempts.end(), [](const Attempt& a, const Attempt& b) {
      return a.standing.value < b.standing.value;
    });
    const double best = attempts.front().standing.value;
    outcome_.objectives[k].reached = best;
    converged_ = converged_ && attempts.front().converged;
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
    outcome_.limits = check(made.cam, problem_.limits);
    for (Finding& finding : outcome_.limits.findings)
      if (finding.segment) finding.segment = made.origin[*finding.segment];
    outcome_.active = optimizer::active_findings(space_, ceilings_, z, outcome_.objectives);
    set_status();
  }

  void set_status() {
    bool all_at_bound = true;
    for (std::size_t k = 0; k < outcome_.objectives.size(); ++k)
      all_at_bound = all_at_bound && at_bound(k, outcome_.objectives[k].reached);
    const auto answer = [&](Outcome::Status status, std::string reason) {
      outcome_.status = status;
      outcome_.reason = std::move(reason);
    };
    if (!outcome_.limits.ok() && !cancelled_ && !exhausted_)
      answer(Outcome::Status::infeasible, why_infeasible());
    else if (cancelled_)
      answer(Outcome::Status::cancelled, "stopped by the caller");
    else if (outcome_.limits.ok() && all_at_bound)
      answer(Outcome::Status::optimal,
             "every objective is at its proven bound, to a relative " + brief(problem_.tolerance));
    else if (exhausted_)
      answer(Outcome::Status::stalled,
             "the " + std::to_string(problem_.max_evaluations) + " evaluations allowed ran out");
    else if (!converged_)
      answer(Outcome::Status::stalled, "the solver stopped short of convergence");
    else
      answer(Outcome::Status::converged, why_converged());
  }

  [[nodiscard]] std::string why_converged() const {
    const ObjectiveResult& first = outcome_.objectives.front();
    const std::string gap = "at most " + brief(100 * first.gap()) + " % of " +
                            name(first.objective) + " could still be saved";
    if (space_.convex())
      return "no other choice of the free quantities is better (the problem is convex); " + gap;
    return "none of " + std::to_string(outcome_.starts) + " starts led further; " + gap;
  }

  [[nodiscard]] std::string why_infeasible() const {
    if (const auto& broken = broken_where_fixed_)
      return "nothing free changes segment " + std::to_string(*broken->segment + 1) + ", where " +
             optimizer::sentence(*broken);
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
      return "no choice of the free quantities was found that meets the limits, and the problem is "
             "convex: at best " +
             worst;
    return "none of " + std::to_string(outcome_.starts) + " starts met the limits: at best " +
           worst;
  }

  const CamProblem& problem_;
  const KeepGoing& keep_going_;
  Space space_;
  std::vector<Ceiling> ceilings_;
  std::vector<Point> pool_;
  std::optional<Attempt> least_violated_;
  std::optional<double> best_value_;
  std::optional<Finding> broken_where_fixed_;  ///< a limit, where nothing free reaches
  Outcome outcome_;
  bool cancelled_ = false;
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
  require_valid(problem);
  return Search(problem, keep_going).run();
}

}  // namespace jounce
