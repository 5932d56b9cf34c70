// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/base/printable.hpp"
#include "jounce/executor/run_executor.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "cli/common/verb.hpp"
#include "cli/machine/link.hpp"
#include "cli/machine/machine.hpp"
#include "cli/machine/open_network.hpp"
#include "cli/machine/page_process.hpp"

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

void print(const AxisSummary& axis, bool alone) {
  fmt::print("{}{} motions finished, {} stopped; at {:.9g}\n", alone ? "" : axis.name + ": ",
             axis.finished, axis.stopped, axis.position);
  if (axis.fault != Cause::none)
    fmt::print("{}fault: {}: {}\n", alone ? "" : axis.name + ": ", name(axis.fault),
               meaning(axis.fault));
}

std::string within(const Histogram::Counts& counts) {
  const double us = upper_bound(counts, 0.999);
  return std::isinf(us) ? "more than 16384 us" : fmt::format("{} us", us);
}

void print(const ExecutorSummary& summary) {
  for (const AxisSummary& axis : summary.axes) print(axis, summary.axes.size() == 1);
  const CycleCounts& cycle = summary.cycle;
  fmt::print("{} ticks, {} late, by at most {:.3f} ms; 99.9 % woken within {}, computed in {}\n",
             cycle.ticks, cycle.late, static_cast<double>(cycle.latest_ns) * 1e-6,
             within(summary.lateness), within(summary.computing));
  if (!summary.realtime.empty()) fmt::print("{}\n", summary.realtime);
}

nlohmann::ordered_json json_of(const ExecutorSummary& summary) {
  nlohmann::ordered_json axes = nlohmann::ordered_json::array();
  for (const AxisSummary& axis : summary.axes)
    axes.push_back({{"name", axis.name},
                    {"finished", axis.finished},
                    {"stopped", axis.stopped},
                    {"fault", name(axis.fault)},
                    {"position", axis.position}});
  return {{"axes", axes},
          {"realtime", summary.realtime},
          {"ticks", summary.cycle.ticks},
          {"late", summary.cycle.late},
          {"skipped", summary.cycle.skipped},
          {"latest_ns", summary.cycle.latest_ns},
          {"computed_ns", summary.cycle.computed_ns},
          {"lateness_us", summary.lateness},
          {"computing_us", summary.computing},
          {"log_lost", summary.cycle.lost},
          {"record_lost", summary.record_lost}};
}

int report(const ExecutorSummary& summary, bool json) {
  if (json)
    fmt::print("{}\n", json_of(summary).dump(1));
  else
    print(summary);
  const bool faulty = std::any_of(summary.axes.begin(), summary.axes.end(),
                                  [](const AxisSummary& a) { return a.fault != Cause::none; });
  return faulty ? finding : fine;
}

bool logs_are_whole(const RunArguments& options, const ExecutorSummary& summary) {
  bool whole = true;
  if (summary.cycle.lost > 0) {
    fmt::print(stderr, "jounce: {} ticks are missing from the log\n", summary.cycle.lost);
    whole = false;
  }
  for (const AxisSummary& axis : summary.axes) {
    if (!axis.log_truncated) continue;
    fmt::print(stderr, "jounce: the log of {} is cut off: {}.truncated\n", axis.name,
               printable(log_of(options.machine.log, axis.name, summary.axes.size())));
    whole = false;
  }
  return whole;
}

bool has_played(const ExecutorSummary& summary) {
  return std::any_of(summary.axes.begin(), summary.axes.end(),
                     [](const AxisSummary& a) { return a.finished + a.stopped > 0; });
}

bool record_is_whole(const ExecutorSummary& summary) {
  if (summary.record_trouble.empty() && summary.record_lost == 0) return true;
  fmt::print(stderr, "jounce: the record is incomplete: {}\n",
             summary.record_trouble.empty()
                 ? std::to_string(summary.record_lost) + " cycles are missing"
                 : printable(summary.record_trouble));
  return false;
}

/// The live page, where it is asked for: a process of its own.
std::unique_ptr<PageProcess> page_of(const RunArguments& options,
                                     const std::vector<ExecutorOptions>& axes) {
  if (!options.web) return nullptr;
  std::vector<std::string> names;
  for (const auto& axis : axes) names.push_back(axis.receiver.executor);
  auto page = std::make_unique<PageProcess>(*options.web, names, options.link);
  fmt::print(stderr, "jounce: live page at {}\n", page->address());
  return page;
}

/// Prints the axes and their next event: a run without output looks like a program that hangs.
void announce(const std::vector<ExecutorOptions>& axes, bool enabled) {
  std::string names;
  for (const auto& axis : axes) names += (names.empty() ? "" : ", ") + axis.receiver.executor;
  const std::string& first = axes.front().receiver.executor;
  fmt::print(stderr, "jounce: {}: up, {}\n", names,
             enabled ? "enabled" : "disabled; enable it with: jounce order " + first + " enable");
}

/// A spec is not lost to a log of the same name.
void require_other_files(const RunArguments& options) {
  const RecorderOptions& record = options.run.record;
  for (const std::string& spec : options.machine.files) {
    require_other_file(spec, options.machine.log, "--log");
    if (record.log) require_other_file(spec, record.log->string(), "--record");
    if (record.black_box) require_other_file(spec, record.black_box->string(), "--black-box");
  }
}

/// Neither is any other file that these name.
void require_no_inputs(const RunArguments& options, const std::vector<ExecutorOptions>& axes) {
  const RecorderOptions& record = options.run.record;
  if (!options.machine.log.empty())
    for (const auto& axis : axes)
      require_not_read(log_of(options.machine.log, axis.receiver.executor, axes.size()), "--log");
  if (record.log) require_not_read(record.log->string(), "--record");
  if (record.black_box) require_not_read(record.black_box->string(), "--black-box");
}

bool has_its_names(const ExecutorSummary& summary) {
  if (summary.lost_name.empty()) return true;
  fmt::print(stderr,
             "jounce: name_taken: another executor on this --url has the name {}: this executor "
             "stopped its axes and ended\n",
             summary.lost_name);
  return false;
}

int run_executor(const RunArguments& options) {
  require_other_files(options);
  if (is_open(options.link)) fmt::print(stderr, "jounce: warning: {}\n", open_warning);
  auto [axes, masters, watchdog] = parts_of(options.machine);
  require_no_inputs(options, axes);
  (void)Machine(machine_of(axes), masters.size());
  Link link(options.link);
  for (ExecutorOptions& axis : axes) axis.receiver.key = link.key();
  const auto page = page_of(options, axes);
  RunOptions how = options.run;
  how.up = [&axes = axes, &options] { announce(axes, options.machine.enable); };
  how.masters = std::move(masters);
  how.watchdog = options.watchdog.value_or(watchdog.value_or(how.watchdog));
  const ExecutorSummary summary = run_executor(link.transport(), axes, how);
  const int status = report(summary, options.json);
  if (!has_its_names(summary)) return fault;
  if (!options.machine.log.empty() && !logs_are_whole(options, summary)) return fault;
  if (!record_is_whole(summary)) return fault;
  const bool idle = options.run.once && !has_played(summary);
  return status == fine && idle ? finding : status;
}

}  // namespace

void add_run(CommandLine& line) {
  const auto options = std::make_shared<RunArguments>();
  const Verb verb = line.verb("run", "Run an executor: receive tables and play them, tick by tick",
                              "jounce run axis.toml --enable --log run.csv --once\n"
                              "jounce run feeder.toml knife.toml --enable --realtime 80 --cpu 1");
  verb.option("SPEC", options->machine.files,
              "Specs of kind \"axis\" (limits, cycle, name), which run in one cycle; or one spec "
              "of kind \"machine\", which names them")
      .required();
  verb.option("--log", options->machine.log,
              "CSV of the setpoints of each tick; with several axes, run.csv becomes run.NAME.csv "
              "for each");
  verb.option("--record", options->run.record.log,
              "LCM log of all inputs and outputs of the axes, for `jounce replay`");
  verb.option("--black-box", options->run.record.black_box,
              "Folder for the last cycles before a fault");
  verb.option("--black-box-cycles", options->run.record.black_box_cycles,
              "Number of these cycles for each axis")
      .check(whole(1, 1'000'000))
      .shown();
  verb.option("--seconds", options->run.seconds, "End after this number of seconds")
      .check(seconds());
  verb.flag("--once", options->run.once, "End after one motion");
  verb.option("--realtime", options->run.realtime.priority,
              "SCHED_FIFO priority of the cycle, 1 to 99, if permitted")
      .check(whole(1, 99));
  verb.option("--cpu", options->run.realtime.cpu, "CPU of the cycle, zero-based")
      .check(whole(0, 1023));
  verb.option("--watchdog", options->watchdog,
              "Stop all axes if the communication thread hangs for this number of seconds; 0: "
              "never; default: the value in the machine spec, or 0.5")
      .check([](const std::string& text) -> std::string {
        const double value = number_in(text).value_or(-1);
        return value == 0 || (value >= 0.01 && value <= 3600) ? "" : "must be 0.01 to 3600, or 0";
      });
  verb.option("--web", options->web,
              "Serve a live page on this port of 127.0.0.1 (0: any free port), like `jounce page`, "
              "in a separate process")
      .check(whole(0, 65535));
  verb.flag(
      "--enable", options->machine.enable,
      "Enable every axis at the start; default: each axis is disabled until the command enable");
  verb.flag("--adopt-start", options->machine.adopt_start,
            "At standstill, take the first position of a table as the position of the axis");
  verb.flag("--finish-when-silent", options->machine.finish_when_silent,
            "Play a table to its end when the heartbeat of its streamer is missing; default: stop");
  add_link_options(verb, options->link);
  verb.flag("--json", options->json, "Summary as JSON");
  verb.work([options] { return run_executor(*options); });
}

}  // namespace jounce::cli
