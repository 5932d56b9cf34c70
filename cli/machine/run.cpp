// SPDX-License-Identifier: Apache-2.0
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "jounce/base/detail/notice.hpp"
#include "jounce/executor/detail/trace.hpp"
#include "jounce/executor/run_executor.hpp"
#include "jounce/machine/detail/run_text.hpp"
#include "jounce/machine/machine_parts.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/web/page_process.hpp"

#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"

namespace jounce::cli {
namespace {

struct RunArguments {
  MachineOptions machine;
  LinkOptions link;
  RunOptions run;
  std::optional<double> watchdog;
  std::optional<std::uint16_t> web;
  bool json = false;
};

/// The live page of --web: `jounce page` in another process.
std::unique_ptr<web::PageProcess> page_of(const RunArguments& options, const Trace* trace,
                                          const std::vector<ExecutorOptions>& axes) {
  if (trace == nullptr) return nullptr;
  std::vector<std::string> words{"jounce", "page", "--of-run", "--url", options.link.url};
  if (!options.link.key.empty()) words.insert(words.end(), {"--key", options.link.key});
  for (const auto& axis : axes) words.push_back(axis.receiver.executor);
  auto page = std::make_unique<web::PageProcess>(
      *options.web, std::move(words), trace, [](const auto& s) { print_notice("jounce: " + s); });
  fmt::print(stderr, "jounce: live page at {}\n", page->address());
  return page;
}

int run_executor(const RunArguments& options) {
  const std::initializer_list<std::string_view> files{"log", "record", "black_box", "cpu"};
  with_option_names(files, [&] {
    require_cpu(options.run.realtime.cpu);
    require_no_specs(options.machine, options.run.record);
  });
  if (is_open(options.link)) fmt::print(stderr, "jounce: warning: {}\n", unprotected_warning);
  MachineParts parts = machine_parts(options.machine);
  with_option_names(files, [&] { require_no_inputs(options.machine, options.run.record, parts); });
  KeyedLink link = open_link(options.link, true);
  for (ExecutorOptions& axis : parts.axes) axis.receiver.key = link.key();
  const auto trace = options.web ? std::make_unique<Trace>(Trace::of(parts.axes)) : nullptr;
  const auto page = page_of(options, trace.get(), parts.axes);
  RunOptions how = options.run;
  how.trace = trace.get();
  how.up = [&parts, &options] {  // a run without output looks like a program that hangs
    fmt::print(stderr, "jounce: {}\n", up_text(parts.axes, options.machine.enable));
  };
  how.masters = std::move(parts.masters);
  how.watchdog = options.watchdog.value_or(parts.watchdog.value_or(how.watchdog));
  const ExecutorSummary summary = run_executor(link.transport(), parts.axes, how);
  if (options.json)
    print_json(summary_json(summary));
  else
    fmt::print("{}", summary_text(summary));
  const auto missing = missing_parts(summary, options.machine.log);
  for (const std::string& part : missing) fmt::print(stderr, "jounce: {}\n", part);
  if (!missing.empty()) return fault;
  if (summary.has_fault() || !options.run.once || summary.has_played())
    return summary.has_fault() ? finding : fine;
  fmt::print(stderr, "jounce: --once: the run ended before a motion\n");
  return finding;
}

}  // namespace

void add_run(CommandLine& line) {
  const auto options = std::make_shared<RunArguments>();
  options->machine.notify = print_notice;
  const Verb verb = line.verb("run", "Run an executor: receive tables and play them, tick by tick",
                              "jounce run axis.toml --enable --log run.csv --once\n"
                              "jounce run feeder.toml knife.toml --enable --realtime 80 --cpu 1");
  verb.option("SPEC", options->machine.files,
              "One or more specs of kind \"axis\", which run in the same cycle; or one spec of "
              "kind \"machine\", which names its axes")
      .required();
  verb.option("--log", options->machine.log,
              "CSV of the setpoints of each tick; with several axes, run.csv becomes run.NAME.csv "
              "for each")
      .check(output_file());
  verb.option("--record", options->run.record.log,
              "LCM log of all inputs and outputs of the axes, for `jounce replay`")
      .check(output_file());
  const Option black_box =
      verb.option(
              "--black-box", options->run.record.black_box,
              "LCM log in which the last cycles before a fault are written, for `jounce replay`")
          .check(output_file());
  verb.option("--black-box-cycles", options->run.record.black_box_cycles,
              "With --black-box: number of cycles for each axis")
      .needs(black_box)
      .check(whole(1, 1'000'000))
      .shown();
  verb.option("--seconds", options->run.seconds, "End after this number of seconds")
      .check(seconds());
  verb.flag("--once", options->run.once, "End after one motion");
  verb.option("--realtime", options->run.realtime.priority,
              "Real-time priority of the cycle, 1 to 99 (SCHED_FIFO), if the system permits it")
      .check(whole(1, 99));
  verb.option("--cpu", options->run.realtime.cpu,
              "Number of the CPU on which the cycle runs, from 0")
      .check(whole(0, 1023));
  verb.option("--watchdog", options->watchdog,
              "Stop all axes if the communication thread hangs for this number of seconds; 0: "
              "never; default: the value in the machine spec, or 0.5")
      .check(seconds_or_none(0.01, 3600));
  verb.option("--web", options->web,
              "Serve a live page on this port of 127.0.0.1 (0: any free port), like `jounce page`, "
              "in a separate process")
      .check(whole(0, 65535));
  verb.flag("--enable", options->machine.enable,
            "Enable every axis at the start; default: each axis is disabled until `jounce order "
            "NAME enable`");
  verb.flag("--adopt-start", options->machine.adopt_start,
            "At standstill, take the first position of a table as the position of the axis");
  verb.flag(
      "--finish-when-silent", options->machine.finish_when_silent,
      "If the heartbeats of a streamer stop, play its table to the end; default: stop the axis");
  add_link_options(verb, options->link);
  verb.flag("--json", options->json, "Summary as JSON");
  verb.work([options] { return run_executor(*options); });
}

}  // namespace jounce::cli
