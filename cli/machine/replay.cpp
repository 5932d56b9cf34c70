// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "jounce/machine/detail/replay_text.hpp"
#include "jounce/profiles/error.hpp"

#include "cli/common/json.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct ReplayArguments {
  std::string file;
  std::string axis;
  std::string plot;
  std::string csv;
  std::optional<std::size_t> last;
  bool json = false;
};

ReplayedFile replayed(const ReplayArguments& options) {
  try {
    return replay_file(options.file, {.axis = options.axis,
                                      .last = options.last,
                                      .csv = options.csv,
                                      .ticks = !options.plot.empty()});
  } catch (const InputError& error) {
    if (error.key() != "axis") throw;
    throw InputError("--axis", options.axis, error.rule()).at(options.file);
  }
}

int run_replay(const ReplayArguments& options) {
  for (const auto& [option, path] : {std::pair{"--plot", options.plot}, {"--csv", options.csv}})
    if (path == "-")
      throw InputError(option, path, "must be a file: the answer is on standard output");
    else if (!path.empty())
      require_other_file(options.file, path, option);
  if (const bool writes = !options.plot.empty() || !options.csv.empty();
      !writes && (!options.axis.empty() || options.last))
    throw InputError(options.last ? "--last" : "--axis", "",
                     "applies to --plot and --csv: add one of them");
  const ReplayedFile file = replayed(options);
  if (!options.plot.empty()) write_picture(options.plot, tick_figure(file.ticks, file.axis), {});
  if (options.json)
    print_json(replay_json(file.replay));
  else
    fmt::print("{}", replay_text(file.replay, options.file));
  if (!file.replay.damage.empty()) return bad_input;
  return file.replay.agrees() ? fine : finding;
}

}  // namespace

void add_replay(CommandLine& line) {
  const auto options = std::make_shared<ReplayArguments>();
  const Verb verb =
      line.verb("replay", "Execute a recorded run again and compare every cycle bit for bit",
                "jounce replay run.lcmlog --plot run.svg --last 2000");
  verb.option("FILE", options->file, "Record of `jounce run --record`, or a black box").required();
  verb.option("--axis", options->axis, "Name of the axis for --plot and --csv; default: the first");
  verb.option("--plot", options->plot,
              "Picture of set and actual position, following error and torque (.svg, .png)")
      .check(output_file({".svg", ".png"}));
  verb.option("--csv", options->csv, "Recorded ticks to write, in the format of `jounce run --log`")
      .check(output_file());
  verb.option("--last", options->last,
              "Number of last cycles to write; default: the last motion for --plot, all for --csv")
      .check(whole(1, 10'000'000));
  verb.flag("--json", options->json, "Result as JSON");
  verb.work([options] { return run_replay(*options); });
}

}  // namespace jounce::cli
