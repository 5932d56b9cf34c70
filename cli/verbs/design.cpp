// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/io/curve_file.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct DesignArguments {
  std::string spec;
  std::string axis, machine;
  std::string output = "-";
  std::string curve;
  bool json = false;
};

/// The file of one axis: feeder.csv, or of several feeder-x.csv, feeder-y.csv.
std::string file_of(const std::string& path, const std::string& axis, std::size_t axes) {
  if (axes == 1 || path.empty()) return path;
  if (path == "-")
    throw InputError("--output", "",
                     "is missing: each axis needs a file; -o a.csv writes a-" + axis +
                         ".csv and so on, --axis " + axis + " writes one axis only");
  const auto slash = path.find_last_of('/') + 1;  // npos + 1 is 0
  const auto dot = path.find_last_of('.');
  const auto end = dot == std::string::npos || dot <= slash ? path.size() : dot;
  return path.substr(0, end) + "-" + axis + path.substr(end);
}

nlohmann::ordered_json json_of(const Input& input, const Report& report, const std::string& file) {
  const Table& table = input.table.table;
  nlohmann::ordered_json summary{{"table", file},
                                 {"knots", table.size()},
                                 {"rule", name(table.rule())},
                                 {"sha256", hex(content_hash(table, input.labels.units))}};
  if (input.error) {
    summary["error"] = input.error->position;
    summary["error_where"] = input.error->where;
    if (input.binding) {
      summary["error_velocity"] = input.error->velocity;
      summary["binding"] = name(*input.binding);
    }
  }
  summary["broken"] = report.broken();
  for (const Finding& f : report.findings)
    if (is_unlimited(f))
      summary["not_limited"].push_back({{"quantity", f.quantity},
                                        {"unit", input.labels.unit_of(f)},
                                        {"peak", f.value},
                                        {"where", f.where}});
  for (const Residual& r : input.residuals)
    summary["residuals"].push_back({{"frequency", r.mode.frequency},
                                    {"damping", r.mode.damping},
                                    {"before", r.before},
                                    {"after", r.after}});
  return summary;
}

/// What the fewest knots cost the velocity, and why there are no fewer.
std::string fewest_text(const Input& input) {
  const std::string rate = input.labels.over_master ? std::string(OverMaster::names[1])
                                                    : std::string(OverTime::names[1]);
  const char* why = *input.binding == Binding::none ? "two knots do"
                    : *input.binding == Binding::most
                        ? "the smallest error for this number of knots, or close to it"
                    : *input.binding == Binding::tolerance
                        ? "the fewest knots for the tolerance of the position, or close to it"
                        : "the fewest knots for the tolerance of the velocity, or close to it";
  return fmt::format("{}: at most {} {} (certified); {}", rate, rounded(input.error->velocity),
                     input.labels.unit_of(rate), why);
}

void print_text(std::FILE* out, const Input& input, const Report& report) {
  const Table& table = input.table.table;
  const Units& units = input.labels.units;
  fmt::print(out, "{}: {} knots, {}, from {} to {} {}\n", input.name, table.size(),
             name(table.rule()), rounded(table.start()), rounded(table.end()), units.x);
  if (input.error)
    fmt::print(out, "error against the exact curve: at most {} {} (certified), at {} {}\n",
               rounded(input.error->position), units.position, rounded(input.error->where),
               units.x);
  if (input.error && input.binding) fmt::print(out, "{}\n", fewest_text(input));
  for (const Residual& r : input.residuals)
    fmt::print(out, "residual vibration at {} Hz, damping {}: {} {}; without {} {} {}\n",
               rounded(r.mode.frequency), rounded(r.mode.damping), rounded(r.after), units.position,
               input.spec && input.spec->polydyne ? "[polydyne]" : "the operators",
               rounded(r.before), units.position);
  // The table is what was asked for; that it steps, turns back or breaks a limit is not kept quiet.
  if (!report.ok()) fmt::print(out, "jounce check: {}\n", one_line(report, input.labels));
  if (const std::string rest = not_limited_text(report, input.labels); !rest.empty())
    fmt::print(out, "{}\n", rest);
  fmt::print(out, "sha256 {}\n", hex(content_hash(table, units)));
}

/// What is written for one axis.
void add_files(const Input& input, const DesignArguments& options, std::size_t axes,
               std::vector<Output>& files) {
  const std::string table = file_of(options.output, input.axis, axes);
  files.push_back({table, table_text(table, input.table)});
  if (options.curve.empty()) return;
  files.push_back(
      {file_of(options.curve, input.axis, axes),
       std::visit([&](const auto& curve) { return curve_json(curve, input.labels.units); },
                  *input.curve)});
}

int run_design(const DesignArguments& options) {
  const std::vector<Input> inputs = load_program(options.spec, options.machine, options.axis);
  std::vector<Output> files;
  std::vector<Report> reports;
  for (const Input& input : inputs) {
    add_files(input, options, inputs.size(), files);
    reports.push_back(check_all(input));
    add_not_limited(reports.back(), input);
  }
  require_other_file(options.spec, options.output);
  write_files(files);
  std::FILE* out = options.output == "-" ? stderr : stdout;  // the table itself has standard output
  AxisDocuments documents;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Input& input = inputs[i];
    const std::string file = file_of(options.output, input.axis, inputs.size());
    if (options.json)
      documents.emplace_back(input.axis, json_of(input, reports[i], file));
    else
      print_text(out, input, reports[i]);
  }
  if (options.json) fmt::print(out, "{}\n", document_of(std::move(documents)).dump());
  return fine;
}

}  // namespace

void add_design(CommandLine& line) {
  const auto options = std::make_shared<DesignArguments>();
  const Verb verb = line.verb("design", "Make the table of a spec",
                              "jounce design cam.toml -o cam.csv --curve cam.curve.json");
  verb.option("SPEC", options->spec, "Spec to make; - is standard input").required();
  verb.option("-o,--output", options->output,
              "Table to write, CSV or .json; - is standard output. With several axes, a.csv "
              "becomes a-NAME.csv for each");
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.option("--curve", options->curve, "Also write the exact curve, segment by segment (JSON)");
  verb.flag("--json", options->json, "Summary as JSON");
  verb.work([options] { return run_design(*options); });
}

}  // namespace jounce::cli
