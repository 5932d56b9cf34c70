// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "jounce/profiles/error.hpp"

#include "cli/common/verb.hpp"
#include "cli/machine/streaming.hpp"

namespace jounce::cli {
namespace {

/// Rejects options that need a live master, if there is none.
void require_live(const StreamArguments& options) {
  if (options.live) return;
  if (!options.start_at.empty())
    throw InputError("--start-at", options.start_at, "is a position of a live master: add --live");
  if (options.at_next_cut)
    throw InputError("--at-next-cut", "", "applies to a cam with a live master: add --live");
  if (options.keep_velocity)
    throw InputError("--keep-velocity", "", "applies to a cam with a live master: add --live");
}

int run_stream(const StreamArguments& options) {
  require_live(options);
  if (!options.at.empty() && (!options.start_at.empty() || options.at_next_cut || options.rolling ||
                              !options.bank.empty()))
    throw InputError("--at", options.at,
                     "is a tick: omit --start-at, --at-next-cut, --rolling and --bank");
  if (options.to.find(',') != std::string::npos) return stream_group(options);
  require_name_on_bus("--to", options.to);
  if (!options.bank.empty()) return stream_banks(options);
  return options.rolling ? stream_rolling(options) : stream_table(options);
}

}  // namespace

void add_stream(CommandLine& line) {
  const auto options = std::make_shared<StreamArguments>();
  const Verb verb = line.verb(
      "stream", "Send a table to an executor; the motion starts when the whole table has arrived",
      "jounce stream cam.toml --to feeder\n"
      "jounce stream first.csv --to feeder --swap second.csv    one after the other, in motion\n"
      "jounce stream cam.toml --to knife --live --start-at 250mm   with its live master\n"
      "jounce stream 300.toml --to knife --live --at-next-cut   another length from the next cut\n"
      "jounce stream xyz.toml --to x,y,z                        several axes in the same cycle\n"
      "jounce stream square.toml --to plotter                   a path, to a group of axes\n"
      "jounce stream long.csv --to feeder --rolling             for a table beyond its memory\n"
      "jounce stream first.csv --to feeder --bank loop.csv --loops 20   two banks, the second 20 "
      "times");
  verb.option("FILE", options->file, "Spec, table or G-code; - is standard input").required();
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.option("--to", options->to,
              "Name of the axis or group, or of several axes (x,y,z): each plays its own table, or "
              "all play the only table")
      .required();
  verb.option("--master", options->master,
              "For a cam table: table over time of its master; a cam spec has its own [master]");
  verb.flag("--live", options->live, "The cam follows the live master of the axis");
  verb.option("--start-at", options->start_at,
              "With --live: begin when the master passes this position");
  verb.option("--at", options->at, "Begin at this tick of the executor, or after +SECONDS");
  verb.flag("--at-next-cut", options->at_next_cut,
            "With --live: begin at the end of the present pass, a cut of a knife or a shear");
  verb.flag("--keep-velocity", options->keep_velocity,
            "With --live: if the cam ends at a nonzero velocity, keep it instead of braking");
  verb.flag("--no-wait", options->no_wait,
            "Return when the start is accepted, before the motion begins");
  verb.option("--swap", options->swaps,
              "Table that follows the previous one without a stop; repeatable");
  const Option bank =
      verb.option("--bank", options->bank,
                  "Table that follows at the end of FILE and can repeat (--loops). The executor "
                  "holds FILE in its first bank, and this table in its second");
  verb.option("--loops", options->loops,
              "With --bank: number of times that the second bank is played, each time from the "
              "position that it reached before")
      .needs(bank)
      .check(whole(1, 1'000'000'000))
      .shown();
  const Option rolling = verb.flag("--rolling", options->rolling,
                                   "Send the table row by row while the axis plays it: for tables "
                                   "that exceed the memory of the executor");
  verb.flag("--resume", options->resume,
            "With --rolling: continue after each buffer underrun, instead of ending")
      .needs(rolling);
  verb.flag("--relative", options->relative,
            "With --rolling, --bank or a live follow spec: begin at the present position of the "
            "axis instead of the first position of the table");
  verb.option(
          "--ahead", options->capacity,
          "With --rolling: number of rows to send before the start; the buffer holds twice as many")
      .needs(rolling)
      .check(whole(2, 1 << 20))
      .shown();
  verb.option("--until", options->until, "Return after this step: download, arm or start")
      .check(one_of({"download", "arm", "start"}))
      .shown();
  verb.option("--patience", options->patience, "Give up after this number of seconds")
      .check(seconds())
      .shown();
  add_link_options(verb, options->link);
  verb.flag("--json", options->json, "Outcome as JSON");
  verb.work([options] { return run_stream(*options); });
}

}  // namespace jounce::cli
