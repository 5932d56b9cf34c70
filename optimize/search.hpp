#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/optimize/optimize.hpp"

namespace jounce {

/// A number that may be chosen, lower <= start <= upper.
struct SearchVariable {
  std::string name;
  double lower = 0;
  double upper = 0;
  double start = 0;
};

/// What one choice of the numbers gives. A choice that cannot be made at all (a spec refused, a NaN) is
/// said so, not hidden in a number.
struct SearchAnswer {
  double objective = 0;             ///< to minimise
  std::vector<double> constraints;  ///< each must be <= 0; always as many
  bool possible = true;
  std::string why;  ///< not possible, one sentence
};

using SearchFunction = std::function<SearchAnswer(const std::vector<double>& x)>;

struct SearchOptions {
  std::uint64_t seed = 1;
  bool global = true;  ///< several basins: look everywhere first
  int max_evaluations = 5000;
  std::optional<double> seconds = {};
  double tolerance = 1e-6;  ///< relative, of objective and variables
};

struct SearchProgress {
  int evaluations = 0;
  std::optional<double> best;  ///< of a choice that meets its constraints
};

struct SearchOutcome {
  Outcome::Status status =
      Outcome::Status::infeasible;  ///< `optimal` never: a search proves nothing
  std::string reason;               ///< one sentence
  std::vector<double> best;         ///< the best that meets its constraints, or the least violated
  SearchAnswer answer;              ///< there
  std::vector<std::size_t> at_bound;  ///< variables that stand at a bound
  std::vector<std::size_t> active;    ///< constraints within tolerance of 0
  int evaluations = 0;
};

/// Minimises a function that is expensive and has no derivatives: the numbers of a spec, through
/// everything that is computed from them. Deterministic for a seed and a number of evaluations. An
/// exception thrown by f comes out of search() as it is. Throws InputError for variables or options out
/// of range.
SearchOutcome search(const std::vector<SearchVariable>& variables, const SearchFunction& f,
                     const SearchOptions& options = {},
                     const std::function<bool(const SearchProgress&)>& keep_going = {});

}  // namespace jounce
