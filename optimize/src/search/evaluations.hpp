// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "jounce/optimize/search.hpp"

namespace jounce::optimize_detail {

/// A choice of the free variables. Each is 0 at its lower bound and 1 at its upper bound.
using Choice = std::vector<double>;

/// One choice and its answer.
struct Evaluation {
  Choice z;
  SearchAnswer answer;
  /// Greatest violation of a constraint, in units of its usual size; 0: none.
  double violation = 0;
};

/// Thrown by Evaluations::at(): the budget is used, or the caller stops the search. It ends the
/// running phase.
struct Stop {};

/// All evaluations of the function of a search. It counts them, keeps the best one, and ends the
/// search in time.
class Evaluations {
 public:
  enum class Ended { no, evaluations, seconds, cancelled };  ///< reason why the search has ended

  Evaluations(const std::vector<SearchVariable>& variables, const SearchFunction& f,
              const OptimizeOptions& options, const KeepGoing& keep_going);

  /// Returns the evaluation of a choice, without calling the function again for the last choice.
  /// Throws Stop.
  const Evaluation& at(const Choice& z);

  /// The initial choice.
  [[nodiscard]] const Choice& start() const { return start_; }
  /// Returns the numbers for the function.
  [[nodiscard]] std::vector<double> numbers(const Choice& z) const;
  /// Number of free variables.
  [[nodiscard]] std::size_t size() const { return free_.size(); }
  /// Indices of the free variables.
  [[nodiscard]] const std::vector<std::size_t>& free() const { return free_; }
  [[nodiscard]] const OptimizeOptions& options() const { return options_; }
  [[nodiscard]] int max_evaluations() const { return options_.budget.evaluations.value_or(5000); }
  /// True if there is a global phase.
  [[nodiscard]] bool is_global() const { return options_.starts != 1; }
  /// All evaluations so far.
  [[nodiscard]] const std::deque<Evaluation>& all() const { return all_; }
  [[nodiscard]] const Evaluation& best() const { return all_[best_]; }
  /// True if an evaluated choice was possible.
  [[nodiscard]] bool any_possible() const { return !all_.empty() && best().answer.possible; }
  [[nodiscard]] int count() const { return static_cast<int>(all_.size()); }
  [[nodiscard]] Ended ended() const { return ended_; }
  /// Share of the evaluations or of the time that is used, whichever is greater.
  [[nodiscard]] double used() const;

  /// Sets the scales: from now on, constraints and objective are measured in units of their usual
  /// sizes, the medians of the evaluations so far.
  void settle_scales();
  /// Usual size of each constraint.
  [[nodiscard]] const std::vector<double>& scales() const { return scales_; }
  [[nodiscard]] double spread() const { return spread_; }  ///< spread of the objective
  /// Returns the possible evaluation nearest to a choice.
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

/// True if a is better. Choices that meet their constraints come first; then the lower objective or
/// violation decides. Choices that are not possible come last.
bool better(const Evaluation& a, const Evaluation& b);

/// True if the gain is large enough for a further step.
bool is_gain(const Evaluations& evaluations, const Evaluation& before, const Evaluation& after);

/// Returns the greatest distance in any variable.
double distance(const Choice& a, const Choice& b);

}  // namespace jounce::optimize_detail
