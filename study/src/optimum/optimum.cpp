// SPDX-License-Identifier: Apache-2.0
#include "study/src/optimum/optimum.hpp"

namespace jounce {

SpecOptimum optimum_of(const Spec& spec, const OptimumProgress& keep_going) {
  if (spec.parameters) return study_detail::optimum_of_numbers(spec, keep_going);
  return spec.optimize.shape.shapes.empty() ? study_detail::optimum_of_knots(spec, keep_going)
                                            : study_detail::optimum_of_shapes(spec, keep_going);
}

}  // namespace jounce
