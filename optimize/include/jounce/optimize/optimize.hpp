// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/optimize/outcome.hpp"
#include "jounce/optimize/problem.hpp"

namespace jounce {

/// Minimizes the objectives in order under the limits (method: docs/optimize.md). Exact: limits are
/// checked and objectives reported by isolated extrema, not samples. If the given cam keeps the
/// limits, the first objective is never worse than that of the given cam. Deterministic. Throws
/// InputError like require_valid(CamProblem).
///
/// **Outcome.** `limits` is check(best, limits) with those of CamProblem::ramped; segments count from 0 in the
/// spec. `value` and `bound` are those of the last objective.
Outcome<CamSpec> optimize(const CamProblem& problem, const KeepGoing& keep_going = {});

}  // namespace jounce
