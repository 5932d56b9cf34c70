// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "jounce/base/detail/progress_line.hpp"
#include "jounce/design/detail/axes.hpp"
#include "jounce/design/input.hpp"
#include "jounce/plot/optimum_figure.hpp"
#include "jounce/study/optimum.hpp"

#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct OptimizeArguments {
  std::string spec;
  std::string output;
  std::string table;
  std::string plot;
  std::string against;  ///< file of a drive
  bool json = false;
  std::optional<double> seconds = {};  ///< instead of the time budget of the spec
};

SpecOptimum optimum(const OptimizeArguments& options, const Spec& spec) {
  std::optional<Spec> drive;
  if (!options.against.empty()) drive = read_spec(options.against);
  if (drive && !drive->drive)
    throw drive->document.located(InputError("drive", "", "is missing: --against needs a [drive]"));
  WatchedWork work(spec.parameters ? "searching" : "optimizing");
  const auto watch = [&](double done, const std::string& step) { return work.goes_on(done, step); };
  return drive ? optimum_against(spec, *drive, watch) : optimum_of(spec, watch);
}

void write(const OptimizeArguments& options, const Spec& given, const Spec& optimized,
           const std::string& text) {
  std::vector<Output> files;
  std::vector<std::string> read = given.document.all_files();
  read.push_back(options.against);
  if (!options.table.empty()) {
    const std::vector<Input> inputs = inputs_of(optimized, optimized.document.name);
    for (const Input& input : inputs) {
      const std::string file = file_of_axis("--table", options.table, input.axis, inputs.size());
      files.push_back({file, table_text(file, input.table)});
    }
  }
  if (!options.output.empty()) files.push_back({options.output, text});
  if (!options.plot.empty()) write_picture(options.plot, optimum_figure(given, optimized), read);
  write_files(files, read);
}

/// Prints the optimum and the peaks of the optimized spec. Writes the files if it passes the check.
int report(const OptimizeArguments& options, const Spec& given, const SpecOptimum& best,
           std::FILE* out) {
  std::optional<Spec> spec;
  if (best.spec)
    spec = parse_spec(*best.spec, options.output.empty() ? given.document.name : options.output);
  if (options.json)
    print_json(out, spec ? improvement_json(best, given, *spec) : best.json);
  else
    fmt::print(out, "{}{}", best.text, spec ? improvement_text(given, *spec) : "");
  if (!spec) return finding;
  if (const std::string broken = broken_checks(*spec); !broken.empty()) {
    fmt::print(options.json ? stderr : out,
               "no file is written: the result breaks these checks:\n{}", broken);
    return finding;
  }
  write(options, given, *spec, *best.spec);
  return fine;
}

int run_optimize(const OptimizeArguments& options) {
  std::FILE* out = text_stream(options.json, {options.output, options.table, options.plot});
  require_other_file(options.spec, options.output);
  require_other_file(options.spec, options.table, "--table");
  require_other_file(options.spec, options.plot, "--plot");
  Spec spec = read_spec(options.spec);
  with_option_names({"seconds"}, [&] { prepare_optimum(spec, options.seconds); });
  if (!options.plot.empty() && spec.parts().size() > 1)
    throw InputError("--plot", options.plot,
                     "compares one axis, but this spec has several: draw them with `jounce plot`");
  if (!options.against.empty() && !std::holds_alternative<CamSpec>(spec.subject))
    throw InputError("--against", options.against,
                     "applies to a cam with a free shape: optimize this spec without it");
  if (!options.against.empty() && (spec.parameters || spec.optimize.shape.shapes.empty()))
    throw spec.document.located(
        InputError("segment", "", "--against needs a free shape: add free = { shape = 60 }"));
  return report(options, spec, optimum(options, spec), out);
}

}  // namespace

void add_optimize(CommandLine& line) {
  const auto options = std::make_shared<OptimizeArguments>();
  const Verb verb = line.verb(
      "optimize",
      "Find the best values and shapes of the free quantities of a spec, within the limits",
      "jounce optimize cam.toml -o better.toml --table better.csv");
  verb.option("SPEC", options->spec,
              "Spec with [optimize]: a cam with `free` knots or shapes, or a spec of any kind with "
              "[[optimize.parameter]]. A path without [optimize]: its corners are optimized; - is "
              "standard input")
      .required();
  verb.option("-o,--output", options->output,
              "Optimized spec to write: the same text with new numbers and points")
      .check(output_file({".toml"}));
  verb.option("--table", options->table, "Table of the optimized spec to write, CSV or .json")
      .check(output_file({".csv", ".json"}));
  verb.option("--plot", options->plot,
              "Picture to write, .svg or .png: the optimized motion over the given one")
      .check(output_file({".svg", ".png"}));
  verb.option("--against", options->against,
              "Spec of the drive that moves the cam, of kind \"drive\". Required if minimize names "
              "one of its figures: \"drive torque\", \"drive rms torque\", \"drive residual\", "
              "\"drive following error\", \"drive end following error\"");
  verb.option("--seconds", options->seconds,
              "Stop after this number of seconds with the best result so far");
  verb.flag("--json", options->json, "Outcome as JSON");
  verb.work([options] { return run_optimize(*options); });
}

}  // namespace jounce::cli
