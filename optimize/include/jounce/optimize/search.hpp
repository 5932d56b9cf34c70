// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/optimize/outcome.hpp"

namespace jounce {

/// A number that may be chosen, lower <= start <= upper; lower == upper: it is fixed.
struct SearchVariable {
  std::string name = {};
  double lower = 0;
  double upper = 0;
  double start = 0;
};

/// Result of one choice of the numbers. An impossible choice (a rejected spec) is reported as such,
/// not hidden in a number; an answer with a NaN or an infinity counts as impossible.
struct SearchAnswer {
  double objective = 0;                  ///< to minimize
  std::vector<double> constraints = {};  ///< each must be <= 0; always as many, if possible
  bool possible = true;
  std::string why = {};  ///< not possible: one sentence
};

using SearchFunction = std::function<SearchAnswer(const std::vector<double>& x)>;

/// The result of a search: `best` are the numbers. `status` is never `optimal`: a search proves nothing.
/// `feasible` follows from one more evaluation at the end. `limits` has one finding "constraint/N" for each
/// constraint, `active` those that are met to 1e-4 of their usual size, and "bound/NAME" of the variables at
/// a bound.
struct SearchOutcome : Outcome<std::vector<double>> {
  SearchAnswer answer = {};                ///< answer of the function at `best`
  std::vector<std::size_t> at_bound = {};  ///< variables at a bound, except fixed ones
  std::vector<std::size_t> met = {};       ///< constraints met to 1e-4 of their usual size
  std::string beyond = {};  ///< why choices within 1e-3 of the ranges from `best` are not possible
};

/// Minimizes a function that is expensive and has no derivatives: the numbers of a spec, through
/// everything that is computed from them.
///
///     const auto f = [](const std::vector<double>& x) -> SearchAnswer {
///       return {x[0] + x[1], {1 - x[0] * x[1]}};               // least sum, product at least 1
///     };
///     SearchOutcome best = search({{"a", 0.1, 10, 5}, {"b", 0.1, 10, 5}}, f);
///     if (best.usable()) ...                                   // {1, 1}
///
/// **Global phase.** Local searches start from the best random places that are far from the paths
/// of the others, until no more basins are expected (Boender and Rinnooy Kan) or half of the
/// evaluations are used. Then (or at once, without this phase) the best is polished until nothing
/// gains more than the tolerance: no probe in any direction, and no step of the linearized problem.
/// The methods, and the measurements behind their choice: docs/optimize/parameters.md.
///
/// **One variable** is evaluated at up to 257 equally spaced places; each edge of a feasible range
/// is bisected to 1e-3 of the tolerance, and each minimum is narrowed down to the tolerance. The
/// search does not need monotonicity or convexity; it can miss an island narrower than a 256th of
/// the range.
///
/// **Options.** 5000 evaluations unless stated, 1000000 at most; a tolerance up to 0.01, of the
/// objective and of each range; `starts`: the greatest number of local searches in the global
/// phase; 1 omits that phase.
///
/// **Several variables**: the search may end early if a constraint leaves only a very narrow
/// feasible set, or if the best is in a narrow curved valley. The status is `stalled` if that was
/// detected.
///
/// Deterministic for a seed and a number of evaluations, unless `seconds` or keep_going end it. f
/// is called from this thread only, with numbers within their bounds. Exceptions of f are passed on
/// unchanged. keep_going is called after each evaluation. Throws InputError (keys
/// `variable[1].lower`, `seconds`, ...) for variables or options out of range.
SearchOutcome search(const std::vector<SearchVariable>& variables, const SearchFunction& f,
                     const OptimizeOptions& options = {}, const KeepGoing& keep_going = {});

}  // namespace jounce
