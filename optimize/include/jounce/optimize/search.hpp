// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/optimize/outcome.hpp"

namespace jounce {

/// A number that may vary, lower <= start <= upper. If lower == upper, it is fixed.
struct SearchVariable {
  std::string name = {};  ///< name for messages and findings
  double lower = 0;
  double upper = 0;
  double start = 0;  ///< initial value
};

/// Result for one choice of the numbers. If a choice is not possible (for example a rejected spec),
/// set `possible` to false; do not return a large objective. An answer with NaN or infinity counts
/// as not possible.
struct SearchAnswer {
  double objective = 0;  ///< value to minimize
  /// Values of the constraints, each of which must be <= 0. Their number must be the same in every
  /// possible answer.
  std::vector<double> constraints = {};
  bool possible = true;  ///< false: this choice is not possible
  std::string why = {};  ///< reason why it is not possible, one sentence
};

/// The function that is minimized.
using SearchFunction = std::function<SearchAnswer(const std::vector<double>& x)>;

/// Result of search(). `best` contains the numbers. `status` is never `optimal`, because a search
/// proves nothing. `feasible` is determined by an additional evaluation at the end. `limits` has
/// one finding "constraint/N" for each constraint. `active` has the constraints that are active
/// (within 1e-4 of the median magnitude of the constraint in the first evaluations), and
/// "bound/NAME" for each variable at a bound.
struct SearchOutcome : Outcome<std::vector<double>> {
  SearchAnswer answer = {};  ///< answer of the function at `best`
  /// Indices of the variables at a bound, without fixed variables.
  std::vector<std::size_t> at_bound = {};
  /// Indices of the active constraints (see SearchOutcome).
  std::vector<std::size_t> met = {};
  /// Reason why choices near `best` (within 1e-3 of the ranges) are not possible; "": all are
  /// possible.
  std::string beyond = {};
};

/// Minimizes a function that takes long to compute and has no derivatives, such as a result that
/// depends on the numbers of a spec.
///
///     const auto f = [](const std::vector<double>& x) -> SearchAnswer {
///       return {x[0] + x[1], {1 - x[0] * x[1]}};               // least sum, product at least 1
///     };
///     SearchOutcome best = search({{"a", 0.1, 10, 5}, {"b", 0.1, 10, 5}}, f);
///     if (best.usable()) ...                                   // {1, 1}
///
/// **Several variables.** In the global phase, local searches start from the best of many random
/// points that are far from the paths of earlier searches. The phase ends when no more minima are
/// expected (Boender and Rinnooy Kan), or when half of the evaluations are used. Then the best
/// point is improved until neither a probe in any direction nor a step of the linearized problem
/// gains more than the tolerance. docs/optimize/parameters.md describes the methods and the
/// measurements behind their choice. The search may end early if a constraint leaves only a very
/// narrow feasible set, or if the best point is in a narrow curved valley. If the search detects
/// this, the status is `stalled`.
///
/// **One variable.** The function is computed at up to 257 equally spaced values. Then each end of
/// a feasible range is bisected to 1e-3 of the tolerance, and each minimum is narrowed down to the
/// tolerance. The function need not be monotone or convex. The search can miss a feasible range
/// that is narrower than a 256th of the whole range.
///
/// **Options.** The default budget is 5000 evaluations, the greatest 1000000. The tolerance is at
/// most 0.01, and applies to the objective and to the range of each variable. `starts` is the
/// greatest number of local searches in the global phase; 1 omits this phase.
///
/// **Calls.** The result is deterministic for a seed and a number of evaluations, unless `seconds`
/// or keep_going end the search. `f` is called only in the calling thread, with numbers within
/// their bounds. Exceptions of `f` are rethrown. keep_going is called after each evaluation. Throws
/// InputError (keys `variable[1].lower`, `seconds`, ...) for variables or options out of range, and
/// if there is no variable.
SearchOutcome search(const std::vector<SearchVariable>& variables, const SearchFunction& f,
                     const OptimizeOptions& options = {}, const KeepGoing& keep_going = {});

}  // namespace jounce
