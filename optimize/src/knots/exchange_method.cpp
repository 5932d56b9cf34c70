// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/exchange_method.hpp"

#include <algorithm>

#include "optimize/src/knots/exchange_rows.hpp"
#include "optimize/src/solvers/solve.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr int max_exchange_rounds = 200;
constexpr double slow =
    1e-3;  ///< relative gain of one solution below which another method is tried

/// One attempt, round by round.
class ExchangeRun {
 public:
  ExchangeRun(const Subproblem& subproblem, const Point& start, int max_evaluations,
              const std::function<bool()>& go_on)
      : subproblem_(subproblem),
        go_on_(go_on),
        exchange_(subproblem, start),
        z_(start),
        now_(optimize_detail::merit(subproblem, start)),
        best_{start, now_, false, 0},
        max_evaluations_(max_evaluations),
        held_(!subproblem.space.convex()) {
    least_t_ = floor_of(subproblem) / exchange_.reference();
  }

  [[nodiscard]] const LocalSolution& best() const { return best_; }

  /// One solution and its consequences. Returns false when there is nothing more to do.
  bool step() {
    if (!subproblem_.objective && best_.merit.excess <= rounding_tolerance) {
      best_.converged = true;
      return false;
    }
    const int left = max_evaluations_ - best_.evaluations;
    if (left <= 0 || ++round_ > max_exchange_rounds || !go_on_()) return false;
    const double before = now_.value;
    const Solved solved = solve(program(), z_, t(), std::min(left, patience()), go_on_);
    best_.evaluations += solved.evaluations;
    if (!solved.finite) return false;
    const Shape shape(subproblem_.space, solved.z);
    move_to(solved.z, merit(subproblem_, shape));
    if (exchange_.exchange(shape, z_, solved.t) > 0) return true;
    const bool outside = subproblem_.objective && now_.excess > rounding_tolerance;
    const double gain = (before - now_.value) / exchange_.reference();
    if (gain > slow && !outside) return true;
    if (held_ && (gain <= exchange_.precision() || outside)) {
      held_ = false;
      return true;
    }
    if (outside) return false;
    if (!held_ && descend()) return true;
    if (gain > exchange_.precision()) return true;
    best_.converged = go_on_();
    return false;
  }

 private:
  [[nodiscard]] Program program() const {
    return {subproblem_.space, exchange_.rows(), least_t_, held_};
  }
  /// Evaluations for one solution: a longer run makes no progress.
  [[nodiscard]] int patience() const { return 50 + 10 * static_cast<int>(z_.size()); }
  [[nodiscard]] double t() const { return now_.value / exchange_.reference(); }

  void move_to(const Point& z, const Merit& merit) {
    z_ = z;
    now_ = merit;
    if (is_better(now_, best_.merit)) {
      best_.z = z_;
      best_.merit = now_;
    }
  }

  /// SLSQP finds no descent, which is no proof. The linearized problem decides: either it predicts no gain, or
  /// a short enough step of it must gain.
  bool descend() {
    double radius = 1;
    for (int i = 0; i < 10; ++i, radius /= 4) {
      if (!go_on_()) return false;
      const Solved solved = linear_step(program(), z_, t(), radius);
      best_.evaluations += solved.evaluations;
      const double hoped = t() - solved.t;
      if (!solved.finite || hoped <= exchange_.precision()) return false;
      const Merit there = optimize_detail::merit(subproblem_, solved.z);
      const double gain = t() - there.value / exchange_.reference();
      const double harm =
          subproblem_.objective ? std::max(0.0, there.excess - rounding_tolerance) : 0;
      if (gain - 10 * harm > hoped / 10) {
        move_to(solved.z, there);
        return true;
      }
    }
    return false;
  }

  const Subproblem& subproblem_;
  const std::function<bool()>& go_on_;
  ExchangeRows exchange_;
  Point z_;
  Merit now_;
  LocalSolution best_;
  int max_evaluations_;
  int round_ = 0;
  double least_t_ = 0;
  bool held_;  ///< the masters are held first: the rest is convex
};

}  // namespace

LocalSolution exchange_method(const Subproblem& subproblem, const Point& start, int max_evaluations,
                              const std::function<bool()>& go_on) {
  ExchangeRun run(subproblem, start, max_evaluations, go_on);
  while (run.step()) {
  }
  return run.best();
}

}  // namespace jounce::optimize_detail
