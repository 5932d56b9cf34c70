// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/optimize/optimize.hpp"

namespace jounce {

/// A number that may be chosen, lower <= start <= upper; lower == upper: it stays.
struct SearchVariable {
  std::string name = {};
  double lower = 0;
  double upper = 0;
  double start = 0;
};

/// Result of one choice of the numbers. An impossible choice (a rejected spec) is reported
/// so, not hidden in a number; an answer with a NaN or an infinity counts as one.
struct SearchAnswer {
  double objective = 0;                  ///< to minimise
  std::vector<double> constraints = {};  ///< each must be <= 0; always as many, if possible
  bool possible = true;
  std::string why = {};  ///< not possible: one sentence
};

using SearchFunction = std::function<SearchAnswer(const std::vector<double>& x)>;

struct SearchOptions {
  std::uint64_t seed = 1;
  bool global = true;                  ///< several basins: look everywhere first
  int max_evaluations = 5000;          ///< in [1, 1000000]
  std::optional<double> seconds = {};  ///< > 0; what is found by then depends on the machine
  double tolerance = 1e-6;  ///< tolerance of the objective and of each range, in [1e-9, 0.01]
};

struct SearchProgress {
  int evaluations = 0;
  std::optional<double> best;  ///< objective of the best choice that meets its constraints
};

struct SearchOutcome {
  Outcome::Status status =
      Outcome::Status::infeasible;  ///< never `optimal`: a search proves nothing
  std::string reason = {};          ///< one sentence
  std::vector<double> best = {};    ///< the best that meets its constraints, or the least violated
  SearchAnswer answer = {};         ///< there
  bool feasible = false;            ///< `best` meets every constraint: asked once more at the end
  std::vector<std::size_t> at_bound =
      {};                                ///< variables that stand at a bound (not those that stay)
  std::vector<std::size_t> active = {};  ///< constraints met to 1e-4 of their usual size
  std::string beyond = {};  ///< why choices within 1e-3 of the ranges from `best` are not possible
  int evaluations = 0;
  int searches = 0;  ///< local ones, of the global phase
  int agreeing = 0;  ///< agreeing of these, that led to where `best` was found

  /// True if `best` can be used.
  [[nodiscard]] bool usable() const { return feasible; }
};

/// Minimises a function that is expensive and has no derivatives: the numbers of a spec, through
/// everything that is computed from them.
///
///     const auto f = [](const std::vector<double>& x) -> SearchAnswer {
///       return {x[0] + x[1], {1 - x[0] * x[1]}};               // least sum, product at least 1
///     };
///     SearchOutcome best = search({{"a", 0.1, 10, 5}, {"b", 0.1, 10, 5}}, f);
///     if (best.usable()) ...                                   // {1, 1}
///
/// **Global phase.** Local searches from the best of random places that are far from where others
/// went, until no more basins are to be expected (Boender and Rinnooy Kan) or half of the
/// evaluations are used. Then, and without it, the best is polished until nothing gains more than the
/// tolerance: no probe in any direction, and no step of the linearized problem. The methods,
/// and the measurements behind their choice: docs/optimize/parameters.md.
///
/// **One variable** is looked at in up to 257 equally spaced places; each edge of a feasible
/// range is bisected to 1e-3 of the tolerance, each dip narrowed down to the tolerance. The search needs
/// neither monotonicity nor convexity; it can miss an island narrower than a 256th of the range.
///
/// **Several variables** with a bound that is feasible only within a hair's breadth, or a best in a
/// narrow curved valley, may end early: the status is `stalled` if that was detected.
///
/// Deterministic for a seed and a number of evaluations, unless `seconds` or keep_going end it. f is
/// called from this thread only, with numbers within their bounds. An exception thrown by f comes out
/// as it is. keep_going is asked after each evaluation; false ends the search with the best so far.
/// Throws InputError (keys `variable[1].lower`, `seconds`, ...) for variables or options out of range.
SearchOutcome search(const std::vector<SearchVariable>& variables, const SearchFunction& f,
                     const SearchOptions& options = {},
                     const std::function<bool(const SearchProgress&)>& keep_going = {});

}  // namespace jounce
