// Segments of a cam that are free in shape.
#include <fmt/format.h>

#include "jounce/io/make.hpp"
#include "jounce/io/spec_edit.hpp"

#include "optimizing.hpp"
#include "shape_text.hpp"
#include "verb.hpp"
#include "watched.hpp"

namespace jounce::cli {

int optimize_shapes(const OptimizeOptions& options, const Spec& spec) {
  if (!options.against.empty()) return optimize_against(options, spec);
  const CamShapeProblem problem = make_shape_problem(spec);
  const ShapeWords words(spec);
  const CamShapeOutcome outcome = watched(words, [&](const CamShapeKeepGoing& keep_going) {
    return optimize_cam_shapes(problem, keep_going);
  });
  std::FILE* out = told_on(options);
  if (options.json)
    fmt::print(out, "{}\n", json_of(outcome, words).dump(1));
  else
    print_text(out, outcome, words);
  if (!outcome.usable()) return finding;
  return write_optimized(options, spec, with_shapes(spec, outcome.best));
}

}  // namespace jounce::cli
