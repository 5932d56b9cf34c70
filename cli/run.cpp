#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <unistd.h>

#include "jounce/executor/shell.hpp"
#include "jounce/io/make.hpp"
#include "jounce/stream/driver.hpp"

#include "link.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

struct Options {
  std::string axis;
  std::string log;
  LinkOptions link;
  RunOptions run;
  bool adopt_start = false;
  bool json = false;
};

AxisConfig axis_of(const Spec& spec) {
  const auto* axis = std::get_if<AxisSpec>(&spec.subject);
  if (axis == nullptr)
    throw InputError("kind", "",
                     "an executor is configured by a spec of kind \"axis\"; see `jounce new axis`")
        .at(spec.document.name);
  const double unit = seconds_per_unit(spec);
  AxisConfig config;
  config.period = static_cast<std::int64_t>(std::llround(axis->cycle * 1e9));
  config.position = axis->position;
  config.limits = spec.limits;
  for (auto [limit, power] : {std::pair{&config.limits.velocity, 1},
                              {&config.limits.acceleration, 2},
                              {&config.limits.jerk, 3}})
    for (int i = 0; *limit && i < power; ++i) **limit /= unit;
  return config;
}

ExecutorOptions executor_of(const Options& options, const Spec& spec) {
  ExecutorOptions executor;
  executor.axis = axis_of(spec);
  executor.switches = spec.switches;
  executor.units = {spec.master_unit, spec.units.position};
  executor.receiver.executor = spec.name;
  executor.adopt_start = options.adopt_start;
  if (!options.log.empty()) executor.log = options.log;
  executor.notify = [](const std::string& notice) {
    // A terminal that does not take text must not hold up the executor: then it is dropped.
    pollfd out{STDERR_FILENO, POLLOUT, 0};
    if (poll(&out, 1, 0) == 1 && (out.revents & POLLOUT) != 0) fmt::print(stderr, "{}\n", notice);
  };
  return executor;
}

int report(const ExecutorSummary& summary, bool json) {
  if (json) {
    const nlohmann::ordered_json document{
        {"finished", summary.finished},     {"stopped", summary.stopped},
        {"fault", name(summary.fault)},     {"position", summary.position},
        {"ticks", summary.cycle.ticks},     {"late", summary.cycle.late},
        {"skipped", summary.cycle.skipped}, {"latest_ns", summary.cycle.latest_ns},
        {"log_lost", summary.cycle.lost}};
    fmt::print("{}\n", document.dump(1));
  } else {
    fmt::print(
        "{} motions finished, {} stopped; at {}; {} ticks, {} late, the latest by {:.3f} ms\n",
        summary.finished, summary.stopped, number(summary.position), summary.cycle.ticks,
        summary.cycle.late, static_cast<double>(summary.cycle.latest_ns) * 1e-6);
    if (!summary.realtime.empty()) fmt::print("{}\n", summary.realtime);
    if (summary.fault != Cause::none)
      fmt::print("fault: {}: {}\n", name(summary.fault), meaning(summary.fault));
  }
  return summary.fault == Cause::none ? fine : finding;
}

/// Two executors of one name would both play what is sent to it.
void require_alone(Transport& link, const std::string& name) {
  link.subscribe(wire::channel(name, wire::Lane::status), 1);
  if (next_status(link, name, std::chrono::milliseconds(300)))
    throw InputError("name", name, "an executor of this name is running already on this --url");
}

int run(const Options& options) {
  const Spec spec = read_spec(options.axis);
  ExecutorOptions executor;
  try {
    executor = executor_of(options, spec);
    (void)resolved(executor.axis);
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
  require_alone(Link(options.link).transport(), spec.name);
  Link link(options.link);
  const ExecutorSummary summary = run_executor(link.transport(), executor, options.run);
  const int status = report(summary, options.json);
  if (!options.log.empty() && summary.cycle.lost > 0) {
    fmt::print(stderr, "jounce: {} ticks are missing from the log\n", summary.cycle.lost);
    return fault;
  }
  const bool idle = options.run.once && summary.finished + summary.stopped == 0;
  return status == fine && idle ? finding : status;
}

}  // namespace

void add_run(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb =
      add_verb(app, "run", "Run an executor: take tables from a stream and play them, tick by tick",
               "jounce run axis.toml --log run.csv --once");
  verb->add_option("AXIS", options->axis, "Spec of kind \"axis\": limits, cycle, name")->required();
  verb->add_option("--log", options->log, "CSV of what was commanded in each tick");
  verb->add_option("--seconds", options->run.seconds, "End after so many seconds")
      ->check(seconds_option());
  verb->add_flag("--once", options->run.once, "End after one motion");
  verb->add_option("--realtime", options->run.realtime_priority,
                   "SCHED_FIFO priority of the cycle, 1 to 99, where permitted")
      ->check(CLI::Range(1, 99));
  verb->add_flag("--adopt-start", options->adopt_start,
                 "At standstill, a table's first position is where the axis stands");
  add_link_options(*verb, options->link);
  verb->add_flag("--json", options->json, "Summary for machines");
  verb->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace jounce::cli
