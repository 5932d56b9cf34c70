// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "jounce/design/path_text.hpp"
#include "jounce/design/version.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/picture.hpp"
#include "cli/common/tolerance_option.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct DiffArguments {
  std::string before;
  std::string after;
  std::string axis;
  std::vector<std::string> tolerances;
  std::string output;
  bool json = false;
};

void draw(const std::string& path, const std::vector<std::pair<Input, Input>>& all) {
  if (all.size() > 1) throw InputError("--output", path, "shows one axis: name it with --axis");
  const auto& [before, after] = all.front();
  write_picture(path, figure_of(after, before));
}

int run_diff(const DiffArguments& options) {
  std::vector<Input> old = load_axes(options.before, options.axis);
  std::vector<Input> now = load_axes(options.after, options.axis);
  const auto all = with_option_names({"axis"}, [&] {
    return paired_axes(std::move(old), std::move(now), options.before, options.after);
  });
  bool equal = true;
  AxisDocuments documents;
  std::string text;
  for (const auto& [before, after] : all) {
    const Comparison comparison =
        compare(version_of(before, options.before), version_of(after, options.after),
                tolerance_of(options.tolerances, after.labels));
    equal = equal && comparison.equal();
    if (options.json)
      documents.emplace_back(after.axis, Json::parse(to_json(comparison)));
    else
      text += (text.empty() ? "" : "\n") + to_text(comparison);
  }
  const auto& [first, second] = all.front();
  const bool paths = first.plan && second.plan;
  if (paths && !options.json)
    text = path_difference(*second.spec, *first.plan, *second.plan) + "\n" + text;
  if (options.json) {
    auto document = document_of(std::move(documents));
    document["equal"] = equal;
    if (paths)
      document["path"] = {{"durations", {first.plan->duration(), second.plan->duration()}},
                          {"lengths", {first.plan->path().length(), second.plan->path().length()}}};
    text = document.dump(1) + "\n";
  }
  if (!options.output.empty()) draw(options.output, all);
  fmt::print(text_stream({options.output}), "{}", text);
  return equal ? fine : finding;
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
  verb.option("--tolerance", options->tolerances, tolerance_help).one_each();
  verb.option(
      "-o,--output", options->output,
      "Picture of AFTER over a paler BEFORE to write, .svg or .png; - is SVG on standard output");
  verb.flag("--json", options->json, "All results as JSON, numbers with all digits");
  verb.work([options] { return run_diff(*options); });
}

}  // namespace jounce::cli
