// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "jounce/design/output_events.hpp"

#include "cli/common/input.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct EventsArguments {
  std::string file;
  std::string output = "-";
  bool json = false;
};

int run_events(const EventsArguments& options) {
  require_other_file(options.file, options.output);
  if (options.json && options.output.ends_with(".csv"))
    throw InputError("--json", "", "cannot be combined with .csv: end the output in .json");
  const bool json = options.json || options.output.ends_with(".json");
  const std::vector<Input> axes = load_axes(options.file);
  if (!axes.front().spec)
    throw InputError("FILE", options.file,
                     "is a table: outputs need a spec with [compare] or [[switch]]");
  const OutputEvents events = output_events(axes);
  write_file(options.output, json ? to_json(events) : to_csv(events), files_of(axes));
  for (const Finding& f : events.report.findings) {
    if (!f.broken) continue;
    fmt::print(stderr, "jounce: {}: {}\n", f.rule.text(), sentence(f, events.labels));
    if (!f.advice.empty()) fmt::print(stderr, "jounce:   {}\n", f.advice);
  }
  return events.report.ok() ? fine : finding;
}

}  // namespace

void add_events(CommandLine& line) {
  const auto options = std::make_shared<EventsArguments>();
  const Verb verb = line.verb(
      "events", "List the exact times at which outputs switch, or the lines of a path begin",
      "jounce events scan.toml -o events.csv");
  verb.option("FILE", options->file,
              "Spec of a motion with [compare], of a path, or of a cam with [[switch]] and "
              "[master]; - is standard input")
      .required();
  verb.option("-o,--output", options->output, "CSV or JSON to write; - is standard output")
      .check(output_file({".csv", ".json"}));
  verb.flag("--json", options->json, "Events as JSON");
  verb.work([options] { return run_events(*options); });
}

}  // namespace jounce::cli
