// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <utility>

#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/cut_map.hpp"
#include "jounce/plot/cut_map_figure.hpp"

#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct MapArguments {
  std::string file;
  std::string from;
  std::string to;
  std::size_t steps = 91;
  std::string line_speed;
  std::string output = "-";
};

double option(const char* name, const std::string& text, const std::string& unit, double fallback) {
  if (text.empty()) return fallback;
  const double value = under_option(name, [&] { return quantity(text, unit); });
  require_positive(name, value);
  return value;
}

std::optional<double> line_speed(const Spec& spec, const MapArguments& options) {
  if (options.line_speed.empty()) return std::nullopt;
  return option("--line-speed", options.line_speed, rate_unit(spec.units.x, spec.time_unit, 1), 0);
}

CutMap map_of(const MapArguments& options) {
  Spec spec = parse_spec(read_file(options.file), options.file);
  CutLengths cuts = cut_lengths(spec);
  const double from = option("--from", options.from, spec.units.x, cuts.from);
  const double to = option("--to", options.to, spec.units.x, cuts.to);
  if (!(to > from)) throw InputError("--to", to, "must be greater than --from, " + number(from));
  const CutLimits limits = cut_limits(spec, line_speed(spec, options));
  return cut_map(std::move(spec), std::move(cuts), limits, from, to, options.steps);
}

int run_map(const MapArguments& options) {
  require_other_file(options.file, options.output);
  const CutMap map = map_of(options);
  const bool picture = options.output.ends_with(".svg") || options.output.ends_with(".png");
  if (picture)
    write_picture(options.output, cut_map_figure(map));
  else
    write_file(options.output, to_csv(map));
  return fine;
}

}  // namespace

void add_map(CommandLine& line) {
  const auto options = std::make_shared<MapArguments>();
  const Verb verb = line.verb(
      "map", "Show the greatest line speed for each cut length, and the limit that determines it",
      "jounce map knife.toml --from 100 --to 1000 -o map.png");
  verb.option("FILE", options->file, "Spec of a knife or a shear; - is standard input").required();
  verb.option("--from", options->from,
              "Shortest cut; without --from and --to, the program chooses the range");
  verb.option("--to", options->to, "Longest cut");
  verb.option("--steps", options->steps, "Number of lengths from --from to --to, both included")
      .check(whole(2, 100000));
  verb.option("--line-speed", options->line_speed,
              "Speed of the line; default: the velocity of [master], or line_speed of a shear");
  verb.option("-o,--output", options->output, ".csv, .svg or .png; - is CSV on standard output")
      .check(ends_in({".csv", ".svg", ".png"}));
  verb.work([options] { return run_map(*options); });
}

}  // namespace jounce::cli
