// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "jounce/executor/log.hpp"
#include "jounce/machine/replay_text.hpp"
#include "jounce/profiles/error.hpp"

#include "cli/common/json.hpp"
#include "cli/common/picture.hpp"
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

constexpr std::size_t default_cycles = 5000;  // drawn and listed without --last

void require_others(const ReplayArguments& options) {
  for (const auto& [option, path] : {std::pair{"--plot", options.plot}, {"--csv", options.csv}})
    if (!path.empty()) require_other_file(options.file, path);
  if (!options.plot.empty()) require_picture("--plot", options.plot);
}

/// The axis for --plot and --csv.
RecordedAxis axis_of(const ReplayArguments& options) {
  try {
    return recorded_axis(options.file, options.axis);
  } catch (const InputError& error) {
    if (error.key() != "axis") throw;
    throw InputError("--axis", options.axis, error.rule()).at(options.file);
  }
}

int run_replay(const ReplayArguments& options) {
  require_others(options);
  std::ifstream in(options.file, std::ios::binary);
  if (!in) throw InputError("FILE", options.file, "cannot be read: does the file exist?");
  const bool shown = !options.plot.empty();
  const bool listed = !options.csv.empty();
  RecordedAxis axis;
  if (shown || listed) axis = axis_of(options);
  LastTicks ticks(axis.axis, options.last.value_or(default_cycles));
  // A list of all of them is written as they come: a record may be longer than memory.
  std::optional<TickLog> csv;
  if (listed) csv.emplace(options.csv, axis.units);
  const Replay result = replay(in, options.file, [&](const RecordedCycle& cycle) {
    if (shown || options.last) ticks.add(cycle);
    if (csv && !options.last && cycle.axis == axis.axis) csv->add(cycle.tick);
  });
  if (csv && options.last)
    for (const Tick& tick : ticks.kept()) csv->add(tick);
  if (csv) csv->close();
  if (shown) write_picture(options.plot, tick_figure(ticks.kept(), axis));
  if (options.json)
    print_json(Json::parse(replay_json(result)));
  else
    fmt::print("{}", replay_text(result, options.file));
  const bool box = !result.axes.front().whole;
  return result.same() || (box && !result.difference) ? fine : finding;
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
              "Picture of set and actual position, following error and torque (.svg, .png)");
  verb.option("--csv", options->csv,
              "Recorded ticks to write, in the format of `jounce run --log`");
  verb.option("--last", options->last,
              "Number of last cycles to write; default: 5000 for --plot, all for --csv")
      .check(whole(1, 10'000'000));
  verb.flag("--json", options->json, "Result as JSON");
  verb.work([options] { return run_replay(*options); });
}

}  // namespace jounce::cli
