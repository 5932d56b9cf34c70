#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/io/curve_file.hpp"
#include "jounce/io/file.hpp"

#include "input.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

struct Options {
  std::string spec;
  std::string output = "-";
  std::string curve;
  bool json = false;
};

void print_summary(const Options& options, const Input& input) {
  std::FILE* out = options.output == "-" ? stderr : stdout;  // the table itself has standard output
  const Table& table = input.table.table;
  const Units& units = input.labels.units;
  if (options.json) {
    nlohmann::ordered_json summary{{"table", options.output},
                                   {"knots", table.size()},
                                   {"rule", name(table.rule())},
                                   {"sha256", hex(content_hash(table, units))}};
    if (input.error) {
      summary["error"] = input.error->position;
      summary["error_where"] = input.error->where;
    }
    fmt::print(out, "{}\n", summary.dump());
    return;
  }
  fmt::print(out, "{}: {} knots, {}, from {} to {} {}\n", input.name, table.size(),
             name(table.rule()), rounded(table.start()), rounded(table.end()), units.x);
  if (input.error)
    fmt::print(out, "error against the exact curve: {} {} at the most (certified), at {} {}\n",
               rounded(input.error->position), units.position, rounded(input.error->where),
               units.x);
  fmt::print(out, "sha256 {}\n", hex(content_hash(table, units)));
}

int run(const Options& options) {
  const Input input = load(options.spec);
  std::vector<Output> files{{options.output, table_text(options.output, input.table)}};
  if (!options.curve.empty())
    files.push_back(
        {options.curve,
         std::visit([&](const auto& curve) { return curve_json(curve, input.labels.units); },
                    input.curve)});
  write_files(files);
  print_summary(options, input);
  return fine;
}

}  // namespace

void add_design(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb = add_verb(app, "design", "Make the table of a spec",
                            "jounce design cam.toml -o cam.csv --curve cam.curve.json");
  verb->add_option("SPEC", options->spec, "Spec to make; - is standard input")->required();
  verb->add_option("-o,--output", options->output,
                   "Table to write, CSV or .json; - is standard output");
  verb->add_option("--curve", options->curve,
                   "Also write the exact curve, segment by segment (JSON)");
  verb->add_flag("--json", options->json, "Summary for machines");
  verb->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace jounce::cli
