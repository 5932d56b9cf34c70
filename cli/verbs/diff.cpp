// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "jounce/design/files/file_difference.hpp"
#include "jounce/plot/input_figure.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"
#include "cli/verbs/check_run.hpp"

namespace jounce::cli {
namespace {

struct DiffArguments {
  std::string before;
  std::string after;
  std::string axis, machine;
  std::vector<std::string> tolerances;
  std::string output;
  bool json = false;
};

void draw(const std::string& path, const FileDifference& difference) {
  if (difference.axes.size() > 1)
    throw InputError("--output", path, "shows one axis: name it with --axis");
  const auto& [before, after] = difference.axes.front();
  write_picture(path, figure_of(after, before), difference.files());
}

int run_diff(const DiffArguments& options) {
  std::FILE* const out = text_stream(options.json, {options.output});
  const FileDifference difference = with_option_names({"axis", "tolerance"}, [&] {
    std::vector<Input> before = read_program(options.before, options.machine);
    return file_difference(
        std::move(before), read_program(options.after, options.machine), options.before,
        options.after,
        [&](const Labels& labels) { return tolerance_of(options.tolerances, labels); },
        options.axis);
  });
  if (!options.output.empty()) draw(options.output, difference);
  if (options.json)
    print_json(out, to_json(difference));
  else
    fmt::print(out, "{}", to_text(difference));
  return difference.equal() ? fine : finding;
}

}  // namespace

void add_diff(CommandLine& line) {
  const auto options = std::make_shared<DiffArguments>();
  const Verb verb = line.verb(
      "diff", "Show the exact differences of two specs or tables; exit status 1 if there are any",
      "jounce diff cam.toml better.toml --tolerance position=\"1 um\" -o both.svg");
  verb.option("BEFORE", options->before, "Spec or table; - is standard input").required();
  verb.option("AFTER", options->after,
              "Spec or table to compare with BEFORE; numbers are in its units")
      .required();
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.option("--tolerance", options->tolerances, tolerance_help).one_each();
  verb.option("-o,--output", options->output,
              "Picture of AFTER over a paler BEFORE to write, .svg or .png; - is SVG on standard "
              "output")
      .check(output_file());
  verb.flag("--json", options->json, "All results as JSON, numbers with all digits");
  verb.work([options] { return run_diff(*options); });
}

}  // namespace jounce::cli
