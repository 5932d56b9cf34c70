// SPDX-License-Identifier: Apache-2.0
// Segments of a cam that are free in shape.
#include "jounce/design/make.hpp"
#include "jounce/spec/detail/edit.hpp"

#include "study/src/optimum/optimum.hpp"
#include "study/src/optimum/shape_text.hpp"

namespace jounce::study_detail {

SpecOptimum optimum_of_shapes(const Spec& spec, const OptimumProgress& keep_going) {
  const CamShapeProblem problem = make_shape_problem(spec);
  const ShapeWords words(spec);
  const CamShapeOutcome outcome = optimize_cam_shapes(
      problem, reported_to(keep_going, [&](const OptimizeProgress& p) { return words.stage(p); }));
  return {.text = text_of(outcome, words),
          .json = json_of(outcome, words).dump(),
          .spec = outcome.usable() ? std::optional(with_shapes(spec, outcome.best)) : std::nullopt};
}

}  // namespace jounce::study_detail
