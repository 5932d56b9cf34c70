// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "jounce/optimize/problem.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Result for one objective.
struct ObjectiveResult {
  Objective objective = Objective::peak_acceleration;
  double given = 0;    ///< given of the cam that was given
  double reached = 0;  ///< reached of Outcome::best, exact
  double bound = 0;    ///< proven: no cam within the limits is below, this objective alone

  /// The share of `reached` that at most could still be saved: 0 at the bound, below 1.
  [[nodiscard]] double gap() const;
};

/// Result of optimize().
struct Outcome {
  enum class Status {
    optimal,     ///< every objective is within tolerance of its proven bound
    converged,   ///< no start improves any more; the gaps bound the remaining gain
    stalled,     ///< evaluations ran out, or the solver gave up: the best may still be improved
    cancelled,   ///< stopped by the caller
    infeasible,  ///< no start met the limits; `best` violates them least where it can change
  };

  Status status = Status::infeasible;
  std::string reason;                       ///< one sentence
  CamSpec best;                             ///< the best feasible cam, or the least violated one
  std::vector<ObjectiveResult> objectives;  ///< in the order of CamProblem::minimize
  Report limits;  ///< check(best, limits); segments count from 0 in the spec
  /// Active constraints: limits reached to 1e-6 ("limit/..."), free quantities at a bound
  /// ("bound/..."), and where each peak is attained ("objective/..."). Segments as above.
  std::vector<Finding> active;
  int evaluations = 0;  ///< evaluations of the constraints, with gradients
  int starts = 0;       ///< tried

  /// True if `best` keeps every limit.
  [[nodiscard]] bool usable() const { return limits.ok(); }
};

const char* name(Outcome::Status status);

/// Between two starts.
struct OptimizeProgress {
  std::size_t objective = 0;  ///< index into CamProblem::minimize
  std::size_t start = 0;      ///< start of `starts`, counted from 0
  std::size_t starts = 0;
  int evaluations = 0;            ///< so far
  std::optional<double> reached;  ///< best value of this objective so far
};

/// Return false to stop; the best so far is still answered.
using KeepGoing = std::function<bool(const OptimizeProgress&)>;

/// Minimises the objectives in order under the limits (method: docs/optimize.md). Exact: limits are
/// checked and objectives reported by isolated extrema, not samples. If the given cam keeps the
/// limits, the first objective never gets worse than its. Deterministic. Throws InputError as
/// require_valid(CamProblem) does, and nothing else of its own.
Outcome optimize(const CamProblem& problem, const KeepGoing& keep_going = {});

}  // namespace jounce
