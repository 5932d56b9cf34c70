// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "jounce/spec/spec.hpp"
#include "jounce/study/tune.hpp"

#include "cli/common/folders.hpp"
#include "cli/common/picture.hpp"
#include "cli/common/verb.hpp"
#include "cli/optimize/optimizing.hpp"

namespace jounce::cli {
namespace {

void give_budget(Spec& spec, double seconds) {
  require_positive("--seconds", seconds);
  if (spec.parameters)
    spec.parameters->options.budget.seconds = seconds;
  else
    spec.optimize.seconds = seconds;
}

int run_optimize(const OptimizeArguments& options) {
  for (const std::string& output : {options.table, options.plot})
    require_other_file(options.spec, output);
  require_folders(
      {{"--output", options.output}, {"--table", options.table}, {"--plot", options.plot}});
  if (!options.plot.empty()) require_picture("--plot", options.plot);
  Spec spec = read_spec(options.spec);
  if (std::holds_alternative<PathSpec>(spec.subject) && !spec.parameters)
    spec.parameters = corner_parameters(spec);
  if (options.seconds) give_budget(spec, *options.seconds);
  if (!options.plot.empty() && spec.parts().size() > 1)
    throw InputError("--plot", options.plot,
                     "compares one axis, but this spec has several: draw them with `jounce plot`");
  if (!options.against.empty() && (spec.parameters || spec.optimize.shape.shapes.empty()))
    throw spec.document.located(
        InputError("optimize", "", "--against needs a cam with segments of free shape"));
  if (spec.parameters) return optimize_parameters(options, spec);
  return spec.optimize.shape.shapes.empty() ? optimize_knots(options, spec)
                                            : optimize_shapes(options, spec);
}

}  // namespace

void add_optimize(CommandLine& line) {
  const auto options = std::make_shared<OptimizeArguments>();
  const Verb verb = line.verb(
      "optimize",
      "Find the best values and shapes of the free quantities of a spec, within the limits",
      "jounce optimize cam.toml -o better.toml --table better.csv");
  verb.option("SPEC", options->spec,
              "Spec with [optimize]: a cam with `free` knots or shapes, or any kind with "
              "[[optimize.parameter]]; or a path: its corners; - is standard input")
      .required();
  verb.option("-o,--output", options->output,
              "Optimized spec to write: the same text with new numbers and points");
  verb.option("--table", options->table, "Table of the optimized spec to write, CSV or .json");
  verb.option("--plot", options->plot,
              "Picture to write, .svg or .png: the optimized motion over the given one");
  verb.option("--against", options->against,
              "Drive to optimize for, a spec of kind \"drive\": for minimize = [\"drive "
              "torque\"], \"drive rms torque\", \"drive residual\", \"drive following "
              "error\", \"drive end following error\"");
  verb.option("--seconds", options->seconds,
              "Stop after this number of seconds with the best result so far");
  verb.flag("--json", options->json, "Outcome as JSON");
  verb.work([options] { return run_optimize(*options); });
}

}  // namespace jounce::cli
