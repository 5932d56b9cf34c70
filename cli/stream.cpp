#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/driver.hpp"

#include "progress.hpp"
#include "stream_banks.hpp"
#include "stream_options.hpp"
#include "stream_rolling.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

using Options = StreamVerb;

/// Whether the start may come later than it is accepted.
bool waits(const Options& options) {
  return !options.start_at.empty() || options.at_next_cut || !options.swaps.empty();
}

int report(const StreamOutcome& outcome, const Options& options) {
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
    fmt::print("{} chunks arrived at {}, {} sent again; {}\n", outcome.progress.chunks, options.to,
               outcome.progress.resent,
               outcome.swaps > 0 ? fmt::format("started, {} swaps", outcome.swaps)
               : outcome.started ? (options.no_wait && waits(options) ? "accepted, waits for its start"
                                                                      : "started")
               : outcome.armed   ? "armed"
                                 : "downloaded");
  } else {
    fmt::print(stderr, "jounce: {}\n", said_of(outcome.error, outcome.reason));
  }
  if (outcome.ok()) return fine;
  const bool said_no =
      outcome.error == StreamError::refused || outcome.error == StreamError::dropped;
  return said_no ? finding : fault;
}

/// Whether something is asked for that only whole tables know.
bool is_of_tables(const Options& options) {
  return !options.swaps.empty() || !options.master.empty() || options.live ||
         options.until != "start";
}

int run_rolling(const Options& options) {
  if (is_of_tables(options)) {
    throw InputError("--rolling", "",
                     "streams one table over time: without --swap, --master, --live and --until");
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

int run_banks(const Options& options) {
  if (options.rolling || is_of_tables(options)) {
    throw InputError(
        "--bank", options.bank,
        "fills two banks of rows: without --rolling, --swap, --master, --live, --until");
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

/// What needs a live master, where there is none.
void require_live(const Options& options) {
  if (options.live) return;
  if (!options.start_at.empty())
    throw InputError("--start-at", options.start_at, "is a position of a live master: with --live");
  if (options.at_next_cut)
    throw InputError("--at-next-cut", "", "is where a cam behind a live master ends: with --live");
  if (options.keep_velocity)
    throw InputError("--keep-velocity", "", "is of a cam behind a live master: with --live");
}

/// Its tables, passes and event are played by the executor's two banks.
int run_follow(const Input& input, const Options& options) {
  const bool other = !options.start_at.empty() || options.at_next_cut || options.keep_velocity ||
                     !options.swaps.empty() || options.until != "start" || !options.master.empty();
  if (other)
    throw InputError("FILE", options.file,
                     "is a follow spec, which says itself when it begins and how it ends: without "
                     "--start-at, --at-next-cut, --keep-velocity, --swap, --master and --until");
  return stream_follow(input, {.to = options.to,
                               .relative = options.relative,
                               .wait = !options.no_wait,
                               .link = options.link,
                               .json = options.json});
}

int run(const Options& options) {
  require_live(options);
  if (!options.at.empty() && (!options.start_at.empty() || options.at_next_cut ||
                              options.rolling || !options.bank.empty()))
    throw InputError("--at", options.at,
                     "is a tick: without --start-at, --at-next-cut, --rolling and --bank");
  if (options.to.find(',') != std::string::npos) return stream_group(options);
  require_name_on_bus("--to", options.to);
  if (!options.bank.empty()) return run_banks(options);
  if (options.rolling) return run_rolling(options);
  Input input = load(options.file, options.axis);
  if (is_live_follow(input, options)) return run_follow(input, options);
  if (options.relative)
    throw InputError("--relative", "",
                     "is for --rolling, --bank and live follow specs: a whole table begins at its "
                     "first position");
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
  const auto options = std::make_shared<Options>();
  const Verb verb = line.verb(
      "stream", "Send a table to an executor; nothing moves before all of it has arrived",
      "jounce stream cam.toml --to feeder\n"
      "jounce stream first.csv --to feeder --swap second.csv    one after the other, in motion\n"
      "jounce stream cam.toml --to knife --live --start-at 250mm behind its live master\n"
      "jounce stream 300.toml --to knife --live --at-next-cut   another length from the next cut on\n"
      "jounce stream xyz.toml --to x,y,z                        several axes: all in one tick, or none\n"
      "jounce stream long.csv --to feeder --rolling             longer than its memory\n"
      "jounce stream first.csv --to feeder --bank loop.csv --loops 20   two banks, the second 20 "
      "times");
  verb.option("FILE", options->file, "Spec or table; - is standard input").required();
  verb.axis(options->axis);
  verb.option("--to", options->to, "Name of the executor").required();
  verb.option("--master", options->master,
              "Table over time that drives a cam table; a cam spec has its own [master]");
  verb.flag("--live", options->live,
            "The cam follows the axis's live master, as its executor is configured");
  verb.option("--start-at", options->start_at,
              "With --live: begin where the master passes this position");
  verb.option("--at", options->at, "Begin at this tick of the executor, or after +SECONDS");
  verb.flag("--at-next-cut", options->at_next_cut,
            "With --live: a knife or shear takes over where the cam that plays ends its pass");
  verb.flag("--keep-velocity", options->keep_velocity,
            "With --live: where the cam ends at a velocity the axis keeps it, instead of braking");
  verb.flag("--no-wait", options->no_wait,
            "Return once the start is accepted, not when it has taken place");
  verb.option("--swap", options->swaps,
              "Table that takes over where the one before ends, in motion; may be repeated");
  const Option bank = verb.option(
      "--bank", options->bank,
      "Static queue of two banks: FILE fills one, this the other, which follows where FILE ends");
  verb.option("--loops", options->loops, "With --bank: how often the second bank is played")
      .needs(bank)
      .check(whole(1, 1'000'000'000))
      .shown();
  const Option rolling =
      verb.flag("--rolling", options->rolling,
                "Send while it plays, to its end: for tables longer than the executor's memory");
  verb.flag("--resume", options->resume,
            "With --rolling: go on after the axis had to stop for want of rows")
      .needs(rolling);
  verb.flag("--relative", options->relative,
            "With --rolling, --bank or a live follow spec: from where the axis stands, wherever the "
            "table begins");
  verb.option("--ahead", options->capacity,
              "With --rolling: rows to begin with; twice as many may wait")
      .needs(rolling)
      .check(whole(2, 1 << 20))
      .shown();
  verb.option("--until", options->until, "How far to go: download, arm or start")
      .check(one_of({"download", "arm", "start"}))
      .shown();
  verb.option("--patience", options->patience, "Give up after so many seconds")
      .check(seconds())
      .shown();
  add_link_options(verb, options->link);
  verb.flag("--json", options->json, "Outcome for machines");
  verb.work([options] { return run(*options); });
}

}  // namespace jounce::cli
