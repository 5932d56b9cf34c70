#include <algorithm>
#include <csignal>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/io/units.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/driver.hpp"

#include "link.hpp"
#include "progress.hpp"
#include "reference.hpp"
#include "stream_banks.hpp"
#include "stream_rolling.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

struct Options {
  std::string file;
  std::string axis;
  std::string to;
  std::string master;
  bool live = false;
  std::string start_at;
  LinkOptions link;
  std::vector<std::string> swaps;
  std::string bank;
  std::int32_t loops = 1;
  bool rolling = false;
  bool resume = false;
  std::uint32_t capacity = 4096;
  std::string until = "start";
  double patience = 60;
  bool json = false;
};

/// Ctrl-C stops what was armed before the streamer leaves.
volatile std::sig_atomic_t interrupted = 0;

/// Adds what this file plays to the tables of the plan.
SwapPlan add_file(StreamPlan& plan, const std::string& file, const Options& options) {
  Input input = load(file, options.axis);
  const auto coupling = input.spec ? input.spec->coupling : std::nullopt;
  Tables tables = [&] {
    if (options.live) return Tables{input.table, std::nullopt};
    if (options.master.empty()) return executor_tables(input);
    return Tables{input.table, read_table(options.master)};
  }();
  SwapPlan added{.slave = plan.tables.size(), .master = plan.tables.size() + 1};
  plan.tables.push_back({std::move(tables.slave.table), tables.slave.units});
  if (tables.master) {
    plan.tables.push_back({std::move(tables.master->table), tables.master->units});
    added.mode = wire::ArmMode::follow_table;
    added.coupling = coupling.value_or(CouplingSpec{});
  }
  if (options.live) {
    added.mode = wire::ArmMode::follow_input;
    added.coupling = coupling.value_or(CouplingSpec{});
  }
  return added;
}

/// --start-at, in the unit of the master.
double start_of(const Options& options, const std::string& unit) {
  try {
    return quantity(options.start_at, unit);
  } catch (const InputError& error) {
    throw InputError("--start-at", options.start_at, error.rule());
  }
}

StreamPlan plan_of(const Options& options) {
  if (options.live && !options.master.empty())
    throw InputError("--master", options.master, "with --live the axis has a master of its own");
  StreamPlan plan;
  plan.executor = options.to;
  const SwapPlan first = add_file(plan, options.file, options);
  plan.mode = first.mode;
  plan.coupling = first.coupling;
  if (!options.start_at.empty()) {
    plan.when = wire::StartAt::master_position;
    plan.position = start_of(options, plan.tables.front().units.x);
  }
  for (const std::string& file : options.swaps) plan.swaps.push_back(add_file(plan, file, options));
  plan.goal = options.until == "download" ? StreamGoal::download
              : options.until == "arm"    ? StreamGoal::arm
                                          : StreamGoal::start;
  return plan;
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
               : outcome.started ? "started"
               : outcome.armed   ? "armed"
                                 : "downloaded");
  } else {
    fmt::print(stderr, "jounce: {}\n", said_of(outcome.error, outcome.reason));
  }
  if (outcome.ok()) return fine;
  return outcome.error == StreamError::refused ? finding : fault;
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
                       .link = options.link,
                       .json = options.json});
}

int run(const Options& options) {
  require_name_on_bus("--to", options.to);
  if (!options.live && !options.start_at.empty())
    throw InputError("--start-at", options.start_at, "is a position of a live master: with --live");
  if (!options.bank.empty()) return run_banks(options);
  if (options.rolling) return run_rolling(options);
  const StreamPlan plan = plan_of(options);
  Link link(options.link);
  StreamOptions stream;
  stream.key = link.key();
  stream.total = nanos(options.patience);
  // Before the total is over: that nobody answers says more than that time is up.
  stream.sender.patience = std::min(stream.sender.patience, stream.total * 3 / 4);
  interrupted = 0;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  stream.cancelled = [] { return interrupted != 0; };
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
