// SPDX-License-Identifier: Apache-2.0
// Segments of a cam that are free in shape.
#include "jounce/design/make.hpp"
#include "jounce/spec/edit.hpp"

#include "cli/optimize/optimizing.hpp"
#include "cli/optimize/shape_text.hpp"
#include "cli/optimize/watched.hpp"

namespace jounce::cli {

int optimize_shapes(const OptimizeArguments& options, const Spec& spec) {
  if (!options.against.empty()) return optimize_against(options, spec);
  const CamShapeProblem problem = make_shape_problem(spec);
  const ShapeWords words(spec);
  const CamShapeOutcome outcome = watched(
      "optimizing", [&](const OptimizeProgress& p) { return words.stage(p); },
      [&](const KeepGoing& keep_going) { return optimize_cam_shapes(problem, keep_going); });
  if (!options.json) print_text(text_stream(options), outcome, words);
  return finish(options, spec, json_of(outcome, words),
                outcome.usable() ? std::optional(with_shapes(spec, outcome.best)) : std::nullopt);
}

}  // namespace jounce::cli
