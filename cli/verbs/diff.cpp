// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/csv.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/path_text.hpp"
#include "jounce/design/version.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/picture.hpp"
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

/// Reads a tolerance: `1e-6`, a share of every range; `position=0.01`; `position="10 um"`.
void set_tolerance(Tolerance& tolerance, const std::string& text, const Labels& labels) {
  const auto equals = text.find('=');
  const std::string key = text.substr(0, equals);
  const auto& names = labels.over_master ? OverMaster::names : OverTime::names;
  const auto name = std::find(names.begin(), names.end(), key);
  if (equals == std::string::npos) tolerance.share = csv_number(text);
  if (equals == std::string::npos ? !tolerance.share : name == names.end())
    throw InputError("--tolerance", text,
                     std::string("must be a share, or KEY=VALUE with one of ") + names[0] + ", " +
                         names[1] + ", " + names[2] + ", " + names[3]);
  try {
    double value = tolerance.share.value_or(0);
    if (name != names.end()) {
      value = quantity(text.substr(equals + 1), labels.unit_of(key));
      tolerance.of[static_cast<std::size_t>(name - names.begin())] = value;
    }
    require_not_negative("", value);
  } catch (const InputError& error) {
    throw InputError("--tolerance", text, error.rule());
  }
}

/// Pairs of axes of both files: the only axes, or axes of the same name.
std::vector<std::pair<Input, Input>> pairs(const DiffArguments& options) {
  std::vector<Input> before = load_axes(options.before, options.axis);
  std::vector<Input> after = load_axes(options.after, options.axis);
  std::vector<std::pair<Input, Input>> all;
  if (before.size() == 1 && after.size() == 1) {
    all.emplace_back(std::move(before.front()), std::move(after.front()));
    return all;
  }
  for (const auto& [some, others, file] :
       {std::tuple{&before, &after, &options.after}, {&after, &before, &options.before}})
    for (const Input& one : *some)
      if (std::none_of(others->begin(), others->end(),
                       [&](const Input& other) { return other.axis == one.axis; }))
        throw InputError("--axis", "",
                         "is missing: " + *file + " has no axis " +
                             (one.axis.empty() ? "without a name" : one.axis));
  for (Input& one : before) {
    const auto other = std::find_if(after.begin(), after.end(),
                                    [&](const Input& each) { return each.axis == one.axis; });
    all.emplace_back(std::move(one), std::move(*other));
  }
  return all;
}

void draw(const std::string& path, const std::vector<std::pair<Input, Input>>& all) {
  if (all.size() > 1) throw InputError("--output", path, "shows one axis: name it with --axis");
  const auto& [before, after] = all.front();
  write_picture(path, figure_of(after, before));
}

int run_diff(const DiffArguments& options) {
  const auto all = pairs(options);
  bool equal = true;
  AxisDocuments documents;
  std::string text;
  for (const auto& [before, after] : all) {
    Tolerance tolerance;
    for (const auto& one : options.tolerances) set_tolerance(tolerance, one, after.labels);
    const Comparison comparison =
        compare(version_of(before, options.before), version_of(after, options.after), tolerance);
    equal = equal && comparison.equal();
    if (options.json)
      documents.emplace_back(after.axis, nlohmann::ordered_json::parse(to_json(comparison)));
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
  fmt::print(options.output == "-" ? stderr : stdout, "{}", text);
  return equal ? fine : finding;
}

}  // namespace

void add_diff(CommandLine& line) {
  const auto options = std::make_shared<DiffArguments>();
  const Verb verb = line.verb(
      "diff", "Show the exact differences of two specs or tables; exit status 1 if there are any",
      "jounce diff cam.toml better.toml --tolerance position=\"1 um\" -o both.svg");
  verb.option("A", options->before, "Spec or table; - is standard input").required();
  verb.option("B", options->after, "Second spec or table; numbers are in its units").required();
  verb.axis(options->axis);
  verb.option("--tolerance", options->tolerances,
              "Tolerance for equal values: a share of each range (1e-6), or KEY=VALUE for a "
              "quantity (position=0.01), repeatable; default: rounding only")
      .one_each();
  verb.option("-o,--output", options->output,
              "Picture of B over a paler A to write, .svg or .png; - is SVG on standard output");
  verb.flag("--json", options->json, "All results as JSON, numbers with all digits");
  verb.work([options] { return run_diff(*options); });
}

}  // namespace jounce::cli
