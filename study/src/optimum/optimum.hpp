// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "jounce/optimize/outcome.hpp"
#include "jounce/study/optimum.hpp"

namespace jounce::study_detail {

/// Parts of optimum_of() for the knots of a cam, for segments of free shape, and for
/// [[optimize.parameter]].
SpecOptimum optimum_of_knots(const Spec& spec, const OptimumProgress& keep_going);
SpecOptimum optimum_of_shapes(const Spec& spec, const OptimumProgress& keep_going);
SpecOptimum optimum_of_numbers(const Spec& spec, const OptimumProgress& keep_going);
SpecOptimum optimum_of_path(const Spec& spec, const OptimumProgress& keep_going);

/// The problem of a path without [[optimize.parameter]]: the numbers of its corners, and its timing
/// law, unless the spec already refines it, or it cannot be refined. Throws InputError like
/// corner_parameters() if there is neither.
ParametersSpec path_parameters(const Spec& spec);

/// Returns the callback of an optimizer that reports to `keep_going`. `step(progress)` returns the
/// present step in words.
template <class Step>
KeepGoing reported_to(const OptimumProgress& keep_going, Step step) {
  if (!keep_going) return {};
  return [&keep_going, step = std::move(step)](const OptimizeProgress& progress) {
    return keep_going(progress.done, step(progress));
  };
}

}  // namespace jounce::study_detail
