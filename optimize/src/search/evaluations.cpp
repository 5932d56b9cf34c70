// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/search/evaluations.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace jounce::optimize_detail {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Marks an answer with NaN as not possible: NaN compares false, so a solver would treat it as a constraint
/// that is met.
void refuse_not_finite(SearchAnswer& answer) {
  if (!answer.possible) return;
  const auto finite = [](double value) { return std::isfinite(value); };
  const bool objective = finite(answer.objective);
  if (objective && std::all_of(answer.constraints.begin(), answer.constraints.end(), finite))
    return;
  answer.possible = false;
  answer.why =
      std::string(objective ? "a constraint" : "the objective") + " is not a finite number";
}

}  // namespace

bool better(const Evaluation& a, const Evaluation& b) {
  if (a.answer.possible != b.answer.possible) return a.answer.possible;
  if (a.violation != b.violation) return a.violation < b.violation;
  return a.answer.objective < b.answer.objective;
}

bool is_gain(const Evaluations& evaluations, const Evaluation& before, const Evaluation& after) {
  if (!better(after, before)) return false;
  const double tolerance = evaluations.options().tolerance;
  if (before.violation > 0) return after.violation < before.violation * (1 - 1e-3);
  const double gain = before.answer.objective - after.answer.objective;
  return gain > tolerance * (std::abs(after.answer.objective) + tolerance * evaluations.spread());
}

double distance(const Choice& a, const Choice& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

Evaluations::Evaluations(const std::vector<SearchVariable>& variables, const SearchFunction& f,
                         const OptimizeOptions& options, const KeepGoing& keep_going)
    : variables_(variables), f_(f), options_(options), keep_going_(keep_going) {
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const SearchVariable& v = variables[i];
    if (!(v.lower < v.upper)) continue;
    free_.push_back(i);
    start_.push_back((v.start - v.lower) / (v.upper - v.lower));
  }
}

std::vector<double> Evaluations::numbers(const Choice& z) const {
  std::vector<double> x;
  for (const SearchVariable& v : variables_) x.push_back(v.start);
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const SearchVariable& v = variables_[free_[k]];
    // The start and the bounds are exact, free of rounding.
    if (z[k] == start_[k]) continue;
    const double inner = v.lower + z[k] * (v.upper - v.lower);
    x[free_[k]] = z[k] >= 1 ? v.upper : std::clamp(inner, v.lower, v.upper);
  }
  return x;
}

double Evaluations::used() const {
  double share = static_cast<double>(count()) / max_evaluations();
  if (options_.budget.seconds) {
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begun_;
    share = std::max(share, gone.count() / *options_.budget.seconds);
  }
  return share;
}

void Evaluations::require_going() {
  if (ended_ == Ended::no && count() >= max_evaluations()) ended_ = Ended::evaluations;
  // There is always one answer.
  if (ended_ == Ended::no && !all_.empty() && used() >= 1) ended_ = Ended::seconds;
  if (ended_ != Ended::no) throw Stop{};
}

double Evaluations::violation(const SearchAnswer& answer) const {
  double largest = 0;
  for (std::size_t i = 0; i < answer.constraints.size(); ++i)
    largest = std::max(largest, answer.constraints[i] / (i < scales_.size() ? scales_[i] : 1));
  return answer.possible ? largest : HUGE_VAL;
}

const Evaluation& Evaluations::at(const Choice& z) {
  if (!all_.empty() && all_.back().z == z) return all_.back();
  require_going();
  SearchAnswer answer = f_(numbers(z));
  refuse_not_finite(answer);
  assert(!answer.possible || !any_possible() ||
         answer.constraints.size() == best().answer.constraints.size());
  const double missed = violation(answer);
  all_.push_back({z, std::move(answer), missed});
  if (better(all_.back(), all_[best_])) best_ = all_.size() - 1;
  std::optional<double> value;
  if (best().violation == 0) value = best().answer.objective;
  const OptimizeProgress progress{
      .done = std::min(used(), 1.0), .evaluations = count(), .reached = value};
  if (keep_going_ && !keep_going_(progress) && ended_ == Ended::no) ended_ = Ended::cancelled;
  return all_.back();
}

void Evaluations::settle_scales() {
  std::vector<double> objectives;
  std::vector<std::vector<double>> sizes(any_possible() ? best().answer.constraints.size() : 0);
  for (const Evaluation& evaluation : all_) {
    if (!evaluation.answer.possible) continue;
    objectives.push_back(evaluation.answer.objective);
    for (std::size_t i = 0; i < sizes.size(); ++i)
      sizes[i].push_back(std::abs(evaluation.answer.constraints[i]));
  }
  scales_.clear();
  for (const auto& size : sizes) {
    const double usual = median(size);
    const double scale = usual > 0 ? usual : *std::max_element(size.begin(), size.end());
    scales_.push_back(scale > 0 ? scale : 1);
  }
  const double middle = median(objectives);
  for (double& value : objectives) value = std::abs(value - middle);
  spread_ = median(std::move(objectives));
  for (Evaluation& evaluation : all_) evaluation.violation = violation(evaluation.answer);
  const auto first =
      std::min_element(all_.begin(), all_.end(),
                       [](const Evaluation& a, const Evaluation& b) { return better(a, b); });
  best_ = static_cast<std::size_t>(first - all_.begin());
}

const Evaluation& Evaluations::nearest_possible(const Choice& z) const {
  const Evaluation* nearest = &best();
  for (const Evaluation& evaluation : all_)
    if (evaluation.answer.possible && distance(evaluation.z, z) < distance(nearest->z, z))
      nearest = &evaluation;
  return *nearest;
}

}  // namespace jounce::optimize_detail
