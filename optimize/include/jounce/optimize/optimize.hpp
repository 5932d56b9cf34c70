// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/optimize/outcome.hpp"
#include "jounce/optimize/problem.hpp"

namespace jounce {

/// Minimizes the objectives, one after another, of a cam with free knots, under its limits (method:
/// docs/optimize/README.md). Limits and objectives are exact: they are computed from exact extrema,
/// not from samples. If the given cam satisfies the limits, the result is never worse in the first
/// objective. The result is deterministic. For `keep_going`, see KeepGoing. Throws InputError like
/// require_valid(CamProblem).
///
/// **Outcome.** `limits` is check(best, limits), including the limits of CamProblem::ramped; its
/// segments count from 0 as in the spec. `value` and `bound` belong to the last objective.
Outcome<CamSpec> optimize(const CamProblem& problem, const KeepGoing& keep_going = {});

}  // namespace jounce
