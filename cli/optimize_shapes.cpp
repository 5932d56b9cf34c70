// Segments of a cam that are free in shape.
#include "jounce/io/make.hpp"
#include "jounce/io/spec_edit.hpp"

#include "optimizing.hpp"
#include "shape_text.hpp"
#include "watched.hpp"

namespace jounce::cli {

int optimize_shapes(const OptimizeOptions& options, const Spec& spec) {
  if (!options.against.empty()) return optimize_against(options, spec);
  const CamShapeProblem problem = make_shape_problem(spec);
  const ShapeWords words(spec);
  const CamShapeOutcome outcome = watched(words, [&](const CamShapeKeepGoing& keep_going) {
    return optimize_cam_shapes(problem, keep_going);
  });
  if (!options.json) print_text(told_on(options), outcome, words);
  return finish(options, spec, json_of(outcome, words),
                outcome.usable() ? std::optional(with_shapes(spec, outcome.best)) : std::nullopt);
}

}  // namespace jounce::cli
