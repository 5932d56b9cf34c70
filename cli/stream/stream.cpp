// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "cli/common/progress.hpp"
#include "cli/common/verb.hpp"
#include "cli/stream/stream_banks.hpp"
#include "cli/stream/stream_options.hpp"
#include "cli/stream/stream_rolling.hpp"

namespace jounce::cli {
namespace {

using StreamArguments = StreamVerb;

/// True if the start may come later than its acceptance.
bool waits(const StreamArguments& options) {
  return !options.start_at.empty() || options.at_next_cut || !options.swaps.empty();
}

int report(const StreamOutcome& outcome, const StreamArguments& options) {
  if (options.json) {
    const nlohmann::ordered_json document{{"ok", outcome.ok()},
                                          {"error", name(outcome.error)},
                                          {"reason", outcome.reason},
                                          {"downloaded", outcome.downloaded},
                                          {"armed", outcome.armed},
                                          {"started", outcome.started},
                                          {"swaps", outcome.swaps},
                                          {"chunks", outcome.progress.chunks},
                                          {"resent", outcome.progress.resent}};
    fmt::print("{}\n", document.dump(1));
  } else if (outcome.ok()) {
    fmt::print(
        "{} chunks arrived at {}, {} sent again; {}\n", outcome.progress.chunks, options.to,
        outcome.progress.resent,
        outcome.swaps > 0 ? fmt::format("started, {} swaps", outcome.swaps)
        : outcome.started
            ? (options.no_wait && waits(options) ? "accepted, waits for its start" : "started")
        : outcome.armed ? "armed"
                        : "downloaded");
  } else {
    fmt::print(stderr, "jounce: {}\n", said_of(outcome.error, outcome.reason));
  }
  if (outcome.ok()) return fine;
  const bool said_no =
      outcome.error == StreamError::refused || outcome.error == StreamError::dropped;
  return said_no ? finding : fault;
}

/// True if an option applies to whole tables only.
bool is_of_tables(const StreamArguments& options) {
  return !options.swaps.empty() || !options.master.empty() || options.live ||
         options.until != "start";
}

int run_rolling(const StreamArguments& options) {
  if (is_of_tables(options)) {
    throw InputError("--rolling", "",
                     "cannot be combined with --swap, --master, --live and --until: it sends one "
                     "table over time");
  }
  return stream_rolling({.file = options.file,
                         .axis = options.axis,
                         .to = options.to,
                         .ahead = options.capacity,
                         .resume = options.resume,
                         .relative = options.relative,
                         .link = options.link,
                         .json = options.json});
}

int run_banks(const StreamArguments& options) {
  if (options.rolling || is_of_tables(options)) {
    throw InputError("--bank", options.bank,
                     "cannot be combined with --rolling, --swap, --master, --live and --until: it "
                     "fills two banks of rows");
  }
  return stream_banks({.first = options.file,
                       .second = options.bank,
                       .axis = options.axis,
                       .to = options.to,
                       .loops = options.loops,
                       .relative = options.relative,
                       .link = options.link,
                       .json = options.json});
}

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

/// Its tables, passes and event are played by the executor's two banks.
int run_follow(const Input& input, const StreamArguments& options) {
  const bool other = !options.start_at.empty() || options.at_next_cut || options.keep_velocity ||
                     !options.swaps.empty() || options.until != "start" || !options.master.empty();
  if (other)
    throw InputError("FILE", options.file,
                     "is a follow spec, which defines its own start and end: omit --start-at, "
                     "--at-next-cut, --keep-velocity, --swap, --master and --until");
  return stream_follow(input, {.to = options.to,
                               .relative = options.relative,
                               .wait = !options.no_wait,
                               .link = options.link,
                               .json = options.json});
}

int run_stream(const StreamArguments& options) {
  require_live(options);
  if (!options.at.empty() && (!options.start_at.empty() || options.at_next_cut || options.rolling ||
                              !options.bank.empty()))
    throw InputError("--at", options.at,
                     "is a tick: omit --start-at, --at-next-cut, --rolling and --bank");
  if (options.to.find(',') != std::string::npos) return stream_group(options);
  require_name_on_bus("--to", options.to);
  if (!options.bank.empty()) return run_banks(options);
  if (options.rolling) return run_rolling(options);
  Input input = load(options.file, options.axis);
  if (is_live_follow(input, options)) return run_follow(input, options);
  if (options.relative)
    throw InputError("--relative", "",
                     "applies to --rolling, --bank and live follow specs only: other tables begin "
                     "at their first position");
  StreamPlan plan = plan_of(options, options.to, std::move(input));
  Link link(options.link);
  plan.start_tick = tick_of(options, link, options.to);
  StreamOptions stream = stream_options(options, link);
  Progress progress("streaming to " + options.to);
  stream.progress = [&](const StreamProgress& p) {
    progress.show(
        p.chunks == 0 ? 0 : static_cast<double>(p.arrived) / static_cast<double>(p.chunks),
        name(p.stage));
  };
  return report(stream_tables(link.transport(), plan, stream), options);
}

}  // namespace

void add_stream(CommandLine& line) {
  const auto options = std::make_shared<StreamArguments>();
  const Verb verb = line.verb(
      "stream", "Send a table to an executor; the motion starts when the whole table has arrived",
      "jounce stream cam.toml --to feeder\n"
      "jounce stream first.csv --to feeder --swap second.csv    one after the other, in motion\n"
      "jounce stream cam.toml --to knife --live --start-at 250mm   with its live master\n"
      "jounce stream 300.toml --to knife --live --at-next-cut   another length from the next cut "
      "on\n"
      "jounce stream xyz.toml --to x,y,z                        several axes, in the same tick\n"
      "jounce stream long.csv --to feeder --rolling             longer than its memory\n"
      "jounce stream first.csv --to feeder --bank loop.csv --loops 20   two banks, the second 20 "
      "times");
  verb.option("FILE", options->file, "Spec or table; - is standard input").required();
  verb.axis(options->axis);
  verb.option("--to", options->to, "Name of the executor").required();
  verb.option("--master", options->master,
              "Table over time of the master of a cam table; a cam spec has its own [master]");
  verb.flag("--live", options->live, "The cam follows the live master of the axis");
  verb.option("--start-at", options->start_at,
              "With --live: begin when the master passes this position");
  verb.option("--at", options->at, "Begin at this tick of the executor, or after +SECONDS");
  verb.flag("--at-next-cut", options->at_next_cut,
            "With --live: a knife or shear begins at the end of the present pass");
  verb.flag("--keep-velocity", options->keep_velocity,
            "With --live: if the cam ends at a velocity, keep it instead of braking");
  verb.flag("--no-wait", options->no_wait,
            "Return when the start is accepted, before the motion begins");
  verb.option("--swap", options->swaps,
              "Table that continues, in motion, at the end of the table before; repeatable");
  const Option bank = verb.option("--bank", options->bank,
                                  "Static queue of two banks: FILE fills the first, this table the "
                                  "second, which follows at the end of FILE");
  verb.option("--loops", options->loops, "With --bank: number of passes of the second bank")
      .needs(bank)
      .check(whole(1, 1'000'000'000))
      .shown();
  const Option rolling =
      verb.flag("--rolling", options->rolling,
                "Send while the axis plays: for tables longer than the memory of the executor");
  verb.flag("--resume", options->resume, "With --rolling: continue after a buffer underrun")
      .needs(rolling);
  verb.flag("--relative", options->relative,
            "With --rolling, --bank or a live follow spec: begin at the position of the axis "
            "instead of that of the table");
  verb.option(
          "--ahead", options->capacity,
          "With --rolling: number of rows to send before the start; the buffer holds twice as many")
      .needs(rolling)
      .check(whole(2, 1 << 20))
      .shown();
  verb.option("--until", options->until, "Last step: download, arm or start")
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
