// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "jounce/design/detail/cut_map.hpp"
#include "jounce/plot/cut_map_figure.hpp"

#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct MapArguments {
  std::string file;
  CutMapTexts texts;
  std::string output = "-";
};

int run_map(const MapArguments& options) {
  require_other_file(options.file, options.output);
  const CutMap map = with_option_names({"from", "to", "line_speed"},
                                       [&] { return cut_map(options.file, options.texts); });
  const bool picture = options.output.ends_with(".svg") || options.output.ends_with(".png");
  if (picture)
    write_picture(options.output, cut_map_figure(map), map.spec.document.files);
  else
    write_file(options.output, to_csv(map), map.spec.document.files);
  return fine;
}

}  // namespace

void add_map(CommandLine& line) {
  const auto options = std::make_shared<MapArguments>();
  const Verb verb = line.verb(
      "map", "Show the greatest line speed for each cut length, and the limit that determines it",
      "jounce map knife.toml --from 100 --to 1000 -o map.png");
  verb.option("FILE", options->file, "Spec of a knife or a shear; - is standard input").required();
  verb.option("--from", options->texts.from,
              "Shortest cut; without --from and --to, the program chooses the range");
  verb.option("--to", options->texts.to, "Longest cut");
  verb.option("--steps", options->texts.steps,
              "Number of lengths from --from to --to, both included")
      .check(whole(2, 100000));
  verb.option("--line-speed", options->texts.line_speed,
              "Speed of the line; default: the velocity of [master], or line_speed of a shear");
  verb.option("-o,--output", options->output, ".csv, .svg or .png; - is CSV on standard output")
      .check(output_file({".csv", ".svg", ".png"}));
  verb.work([options] { return run_map(*options); });
}

}  // namespace jounce::cli
