// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/search.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/src/search/findings.hpp"
#include "optimize/src/search/search_phases.hpp"

namespace jounce {
namespace {

using optimize_detail::brief;
using optimize_detail::Evaluation;
using optimize_detail::Evaluations;
using Status = OptimizeStatus;

constexpr double edge =
    1e-3;  ///< share of the ranges: the outcome reports an impossible choice that is closer
constexpr double near_zero =
    1e-4;  ///< share of a constraint's usual size: a constraint that is closer to 0 is met

void require_valid(const SearchVariable& v, std::size_t i) {
  const std::string key = "variable[" + std::to_string(i + 1) + "].";
  require_finite((key + "lower").c_str(), v.lower);
  require_finite((key + "upper").c_str(), v.upper);
  require_finite((key + "start").c_str(), v.start);
  if (v.lower > v.upper)
    throw InputError(key + "upper", v.upper,
                     "must not be below the lower bound " + number(v.lower));
  if (!std::isfinite(v.upper - v.lower))
    throw InputError(key + "upper", v.upper, "is too far from the lower bound " + number(v.lower));
  if (v.start < v.lower || v.start > v.upper)
    throw InputError(key + "start", v.start,
                     "must be within the bounds " + number(v.lower) + " and " + number(v.upper));
}

void require_valid(const std::vector<SearchVariable>& variables, const OptimizeOptions& options) {
  if (variables.empty()) throw InputError("variable", "", "is missing: give at least one variable");
  for (std::size_t i = 0; i < variables.size(); ++i) require_valid(variables[i], i);
  require_valid(options, 0.01);
  if (const auto most = options.budget.evaluations; most && *most > 1'000'000)
    throw InputError("max_evaluations", *most, "must be at most 1000000");
}

/// The result of the phases of a search.
struct Searched {
  bool settled = false;  ///< no phase gains any more
  optimize_detail::MultiStartCounts counts;
};

Searched searched(Evaluations& evaluations) {
  Searched all;
  try {
    if (evaluations.size() == 0) {
      evaluations.at({});
      all.settled = true;
    } else if (evaluations.size() == 1) {
      search_line(evaluations);
      all.settled = true;
    } else {
      first_evaluations(evaluations);
      if (evaluations.is_global()) all.counts = multi_start(evaluations, 0.5);
      all.settled = polish(evaluations);
    }
  } catch (const optimize_detail::Stop&) {
    all.settled = false;
  }
  return all;
}

/// The reason where no point meets the constraints.
std::string missed(const Evaluations& evaluations) {
  const Evaluation& best = evaluations.best();
  if (!best.answer.possible) return "no point of the search is possible: " + best.answer.why;
  std::size_t worst = 0;
  const auto share = [&](std::size_t i) {
    return best.answer.constraints[i] /
           (i < evaluations.scales().size() ? evaluations.scales()[i] : 1);
  };
  for (std::size_t i = 0; i < best.answer.constraints.size(); ++i)
    if (share(i) > share(worst)) worst = i;
  return "no point of the search meets every constraint: constraint " + std::to_string(worst + 1) +
         " is violated by " + brief(best.answer.constraints[worst]);
}

std::string ending(const Evaluations& evaluations) {
  switch (evaluations.ended()) {
    case Evaluations::Ended::evaluations:
      return "the limit of " + counted(evaluations.count(), "evaluation") + " is reached";
    case Evaluations::Ended::seconds:
      return "the time limit was reached after " + counted(evaluations.count(), "evaluation");
    case Evaluations::Ended::cancelled:
      return "stopped after " + counted(evaluations.count(), "evaluation");
    case Evaluations::Ended::no:
      break;
  }
  return "every step still brought a small improvement";
}

std::string settled_reason(const Evaluations& evaluations, const Searched& how) {
  if (evaluations.size() == 0) return "every variable is fixed";
  if (evaluations.size() == 1)
    return "the best value found in the whole range, of which " +
           std::to_string(std::clamp(evaluations.max_evaluations() / 4, 8, 256) + 1) +
           " places were evaluated; edges are bisected, and the best places refined";
  const std::string local = "no step from the best point improves the figure by more than " +
                            brief(evaluations.options().tolerance) + " of its value; ";
  if (!evaluations.is_global())
    return local + "this is the result of one local search, without proof";
  return local + std::to_string(how.counts.agreeing) + " of " +
         std::to_string(how.counts.searches) + " local searches led to this point, without proof";
}

void judge(const Evaluations& evaluations, const Searched& how, SearchOutcome& outcome) {
  if (evaluations.ended() == Evaluations::Ended::cancelled)
    outcome.status = Status::cancelled;
  else if (!outcome.feasible)
    outcome.status = Status::infeasible;
  else
    outcome.status = how.settled ? Status::converged : Status::stalled;
  if (outcome.feasible)
    outcome.reason = how.settled ? settled_reason(evaluations, how) : ending(evaluations);
  else
    outcome.reason = missed(evaluations) + (how.settled ? "" : "; " + ending(evaluations));
}

/// Adds the reasons that stop further improvement.
void add_reasons(const Evaluations& evaluations, SearchOutcome& outcome) {
  const Evaluation& best = evaluations.best();
  for (std::size_t k = 0; k < evaluations.size(); ++k)
    if (best.z[k] <= evaluations.options().tolerance ||
        best.z[k] >= 1 - evaluations.options().tolerance)
      outcome.at_bound.push_back(evaluations.free()[k]);
  for (std::size_t i = 0; i < evaluations.scales().size(); ++i)
    if (best.answer.possible && best.answer.constraints[i] >= -near_zero * evaluations.scales()[i])
      outcome.met.push_back(i);
  double nearest = edge;
  for (const Evaluation& evaluation : evaluations.all()) {
    const double away = optimize_detail::distance(evaluation.z, best.z);
    if (evaluation.answer.possible || away > nearest) continue;
    nearest = away;
    outcome.beyond = evaluation.answer.why;
  }
}

/// Constraints and variables as findings.
void add_findings(const std::vector<SearchVariable>& variables, SearchOutcome& outcome) {
  for (std::size_t i = 0; i < outcome.answer.constraints.size(); ++i) {
    const double value = outcome.answer.constraints[i];
    const std::string number = std::to_string(i + 1);
    Finding& f = outcome.limits.findings.emplace_back();
    f.rule = "constraint/" + number;
    f.quantity = "constraint " + number;
    f.value = value;
    f.margin = -value;
    f.broken = !(value <= 0);
  }
  for (const std::size_t i : outcome.met) outcome.active.push_back(outcome.limits.findings[i]);
  for (const std::size_t i : outcome.at_bound) {
    Finding& f = outcome.active.emplace_back();
    f.rule = "bound/" + variables[i].name;
    f.quantity = variables[i].name;
    f.value = f.limit = outcome.best[i];
  }
  sort(outcome.limits);
}

/// Evaluates the best once more: the second value counts.
void confirm(const SearchFunction& f, SearchOutcome& outcome) {
  const SearchAnswer again = f(outcome.best);
  ++outcome.evaluations;
  bool met = again.possible && std::isfinite(again.objective);
  for (const double constraint : again.constraints) met = met && constraint <= 0;
  if (outcome.feasible && (!met || again.objective != outcome.answer.objective)) {
    outcome.status = Status::stalled;
    outcome.reason = "the function returns different values for the same point";
  }
  outcome.feasible = met;
  outcome.answer = again;
  outcome.value = again.objective;
}

}  // namespace

SearchOutcome search(const std::vector<SearchVariable>& variables, const SearchFunction& f,
                     const OptimizeOptions& options, const KeepGoing& keep_going) {
  require_valid(variables, options);
  Evaluations evaluations(variables, f, options, keep_going);
  const Searched how = searched(evaluations);
  const Evaluation& best = evaluations.best();
  SearchOutcome outcome;
  outcome.best = evaluations.numbers(best.z);
  outcome.answer = best.answer;
  outcome.feasible = best.violation == 0;
  outcome.evaluations = evaluations.count();
  outcome.starts = how.counts.searches;
  outcome.agreeing = how.counts.agreeing;
  judge(evaluations, how, outcome);
  add_reasons(evaluations, outcome);
  confirm(f, outcome);
  add_findings(variables, outcome);
  return outcome;
}

}  // namespace jounce
