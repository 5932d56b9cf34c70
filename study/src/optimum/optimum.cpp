// SPDX-License-Identifier: Apache-2.0
#include "study/src/optimum/optimum.hpp"

#include "jounce/study/tune.hpp"

namespace jounce {

void prepare_optimum(Spec& spec, std::optional<double> seconds) {
  if (std::holds_alternative<PathSpec>(spec.subject) && !spec.parameters)
    spec.parameters = study_detail::path_parameters(spec);
  if (!seconds) return;
  require_positive("seconds", *seconds);
  if (spec.parameters)
    spec.parameters->options.budget.seconds = seconds;
  else
    spec.optimize.seconds = seconds;
}

SpecOptimum optimum_of(const Spec& spec, const OptimumProgress& keep_going) {
  if (spec.parameters && spec.parameters->refine)
    return study_detail::optimum_of_path(spec, keep_going);
  if (spec.parameters) return study_detail::optimum_of_numbers(spec, keep_going);
  return spec.optimize.shape.shapes.empty() ? study_detail::optimum_of_knots(spec, keep_going)
                                            : study_detail::optimum_of_shapes(spec, keep_going);
}

}  // namespace jounce
