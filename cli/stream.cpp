#include <algorithm>
#include <csignal>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/stream/driver.hpp"

#include "link.hpp"
#include "progress.hpp"
#include "reference.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

struct Options {
  std::string file;
  std::string axis;
  std::string to;
  std::string master;
  LinkOptions link;
  std::string until = "start";
  double patience = 60;
  bool json = false;
};

/// Ctrl-C stops what was armed before the streamer leaves.
volatile std::sig_atomic_t interrupted = 0;

StreamPlan plan_of(const Options& options) {
  Input input = load(options.file, options.axis);
  const auto coupling = input.spec ? input.spec->coupling : std::nullopt;
  Tables tables = [&] {
    if (options.master.empty()) return executor_tables(input);
    return Tables{input.table, read_table(options.master)};
  }();
  StreamPlan plan;
  plan.executor = options.to;
  plan.tables.push_back({std::move(tables.slave.table), tables.slave.units});
  if (tables.master) {
    plan.tables.push_back({std::move(tables.master->table), tables.master->units});
    plan.mode = wire::ArmMode::follow_table;
    plan.coupling = coupling.value_or(CouplingSpec{});
  }
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
                                          {"chunks", outcome.progress.chunks},
                                          {"resent", outcome.progress.resent}};
    fmt::print("{}\n", document.dump(1));
  } else if (outcome.ok()) {
    fmt::print("{} chunks arrived at {}, {} sent again; {}\n", outcome.progress.chunks, options.to,
               outcome.progress.resent,
               outcome.started ? "started"
               : outcome.armed ? "armed"
                               : "downloaded");
  } else {
    fmt::print(stderr, "jounce: {}: {}\n", name(outcome.error), outcome.reason);
  }
  if (outcome.ok()) return fine;
  return outcome.error == StreamError::refused ? finding : fault;
}

int run(const Options& options) {
  const StreamPlan plan = plan_of(options);
  Link link(options.link);
  StreamOptions stream;
  stream.total = nanos(options.patience);
  stream.sender.patience = std::min(stream.sender.patience, stream.total);
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

void add_stream(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb = add_verb(
      app, "stream", "Send a table to an executor; nothing moves before all of it has arrived",
      "jounce stream cam.toml --to feeder");
  verb->add_option("FILE", options->file, "Spec or table; - is standard input")->required();
  add_axis_option(verb, options->axis);
  verb->add_option("--to", options->to, "Name of the executor")->required();
  verb->add_option("--master", options->master,
                   "Table over time that drives a cam table; a cam spec has its own [master]");
  verb->add_option("--until", options->until, "How far to go: download, arm or start")
      ->check(CLI::IsMember({"download", "arm", "start"}))
      ->capture_default_str();
  verb->add_option("--patience", options->patience, "Give up after so many seconds")
      ->check(seconds_option())
      ->capture_default_str();
  add_link_options(*verb, options->link);
  verb->add_flag("--json", options->json, "Outcome for machines");
  verb->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace jounce::cli
