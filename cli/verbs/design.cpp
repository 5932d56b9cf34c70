// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "jounce/design/detail/axes.hpp"
#include "jounce/design/detail/design_text.hpp"
#include "jounce/design/detail/file_check.hpp"
#include "jounce/io/detail/curve_file.hpp"

#include "cli/common/input.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct DesignArguments {
  std::string spec;
  std::string axis, machine, over;
  std::string output = "-";
  std::string curve;
  bool json = false;
};

/// Adds the files of one axis.
void add_files(const Input& input, const DesignArguments& options, std::size_t axes,
               std::vector<Output>& files) {
  const std::string table = file_of_axis("--output", options.output, input.axis, axes);
  files.push_back({table, table_text(table, input.table)});
  if (options.curve.empty()) return;
  files.push_back(
      {file_of_axis("--curve", options.curve, input.axis, axes),
       std::visit([&](const auto& curve) { return curve_json(curve, input.labels.units); },
                  *input.curve)});
}

int run_design(const DesignArguments& options) {
  std::FILE* out = text_stream(options.json, {options.output, options.curve});
  const std::vector<Input> inputs =
      over(options.over, load_program(options.spec, options.machine, options.axis));
  std::vector<Output> files;
  std::vector<Report> reports;
  for (const Input& input : inputs) {
    add_files(input, options, inputs.size(), files);
    reports.push_back(check_all(input));
    add_not_limited(reports.back(), input);
  }
  require_other_file(options.spec, options.output);
  write_files(files, files_of(inputs));
  std::vector<std::pair<std::string, std::string>> documents;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Input& input = inputs[i];
    const std::string file = file_of_axis("--output", options.output, input.axis, inputs.size());
    if (options.json)
      documents.emplace_back(input.axis, design_json(input, reports[i], file));
    else
      fmt::print(out, "{}", design_text(input, reports[i], file));
  }
  if (options.json) fmt::print(out, "{}\n", axes_json(documents));
  return FileCheck{reports}.ok() ? fine : finding;
}

}  // namespace

void add_design(CommandLine& line) {
  const auto options = std::make_shared<DesignArguments>();
  const Verb verb =
      line.verb("design", "Make the table of a spec; exit status 1 if it breaks a limit",
                "jounce design cam.toml -o cam.csv --curve cam.curve.json");
  verb.option("SPEC", options->spec, "Spec, or G-code program with --machine; - is standard input")
      .required();
  verb.option("-o,--output", options->output,
              "Table to write, CSV or .json; - is standard output. With several axes, a.csv "
              "becomes a-NAME.csv for each")
      .check(output_file({".csv", ".json"}));
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.over(options->over);
  verb.option("--curve", options->curve,
              "Also write the exact curve to this file, segment by segment (JSON)")
      .check(ends_in({".json"}));
  verb.flag("--json", options->json, "Summary as JSON");
  verb.work([options] { return run_design(*options); });
}

}  // namespace jounce::cli
