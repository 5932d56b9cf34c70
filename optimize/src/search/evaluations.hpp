// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "jounce/optimize/search.hpp"

namespace jounce::optimizer {

/// A choice of the free variables, each 0 at its lower bound and 1 at its upper.
using Choice = std::vector<double>;

/// One choice and its answer.
struct Evaluation {
  Choice z;
  SearchAnswer answer;
  double violation = 0;  ///< the largest constraint, in its usual size; 0: all are met
};

/// Thrown out of Evaluations::at(), through the running phase: the budget is spent or the caller stops the search.
struct Stop {};

/// All evaluations of the function of a search: counts them, keeps the best and ends in time.
class Evaluations {
 public:
  enum class Ended { no, evaluations, seconds, cancelled };

  Evaluations(const std::vector<SearchVariable>& variables, const SearchFunction& f,
              const OptimizeOptions& options, const KeepGoing& keep_going);

  /// Evaluates a choice, unless it is the last one. Throws Stop.
  const Evaluation& at(const Choice& z);

  [[nodiscard]] const Choice& start() const { return start_; }
  [[nodiscard]] std::vector<double> numbers(const Choice& z) const;
  [[nodiscard]] std::size_t size() const { return free_.size(); }
  [[nodiscard]] const std::vector<std::size_t>& free() const { return free_; }
  [[nodiscard]] const OptimizeOptions& options() const { return options_; }
  [[nodiscard]] int max_evaluations() const { return options_.budget.evaluations.value_or(5000); }
  /// True if there is a global phase.
  [[nodiscard]] bool is_global() const { return options_.starts != 1; }
  [[nodiscard]] const std::deque<Evaluation>& all() const { return all_; }
  [[nodiscard]] const Evaluation& best() const { return all_[best_]; }
  [[nodiscard]] bool any_possible() const { return !all_.empty() && best().answer.possible; }
  [[nodiscard]] int count() const { return static_cast<int>(all_.size()); }
  [[nodiscard]] Ended ended() const { return ended_; }
  /// The used share of the evaluations or of the time, whichever is greater.
  [[nodiscard]] double used() const;

  /// From here on, constraints and objective are measured by their usual sizes, the medians of the evaluations
  /// so far.
  void settle_scales();
  [[nodiscard]] const std::vector<double>& scales() const { return scales_; }
  [[nodiscard]] double spread() const { return spread_; }  ///< spread of the objective
  [[nodiscard]] const Evaluation& nearest_possible(const Choice& z) const;

 private:
  [[nodiscard]] double violation(const SearchAnswer& answer) const;
  void require_going();

  const std::vector<SearchVariable>& variables_;
  const SearchFunction& f_;
  const OptimizeOptions& options_;
  const KeepGoing& keep_going_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::vector<std::size_t> free_;
  Choice start_;
  std::vector<double> scales_;
  double spread_ = 0;
  std::deque<Evaluation> all_;
  std::size_t best_ = 0;
  Ended ended_ = Ended::no;
};

/// True if a is better. Choices that meet their constraints come before the others, then the lower objective or
/// violation decides. Choices that are not possible come last.
bool better(const Evaluation& a, const Evaluation& b);

/// The largest distance in any variable.
double distance(const Choice& a, const Choice& b);

}  // namespace jounce::optimizer
