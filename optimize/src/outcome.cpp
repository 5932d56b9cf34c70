// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/outcome.hpp"

#include <algorithm>

#include "jounce/profiles/error.hpp"

#include "optimize/src/tolerances.hpp"

namespace jounce {

void require_valid(const OptimizeOptions& options, double greatest_tolerance) {
  if (!(options.tolerance >= optimize_detail::finest_optimum &&
        options.tolerance <= greatest_tolerance))
    throw InputError("tolerance", options.tolerance,
                     "must be between 1e-9 and " + number(greatest_tolerance));
  if (options.starts && *options.starts < 1)
    throw InputError("starts", *options.starts, "must be at least 1");
  if (const auto most = options.budget.evaluations; most && *most < 1)
    throw InputError("max_evaluations", *most, "must be at least 1");
  if (const auto seconds = options.budget.seconds; seconds && !(*seconds > 0))
    throw InputError("seconds", *seconds, "must be greater than 0");
}

const char* name(OptimizeStatus status) {
  switch (status) {
    case OptimizeStatus::optimal:
      return "optimal";
    case OptimizeStatus::converged:
      return "converged";
    case OptimizeStatus::stalled:
      return "stalled";
    case OptimizeStatus::cancelled:
      return "cancelled";
    case OptimizeStatus::infeasible:
      break;
  }
  return "infeasible";
}

std::optional<double> FigureResult::gap() const {
  if (!bound) return std::nullopt;
  return reached > *bound ? (reached - *bound) / reached : 0;
}

}  // namespace jounce
