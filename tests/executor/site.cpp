// SPDX-License-Identifier: Apache-2.0
#include "executor/site.hpp"

#include <atomic>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/executor/detail/recorder.hpp"
#include "jounce/stream/sender/driver.hpp"

namespace jounce::test {
namespace {

using namespace std::chrono_literals;

std::filesystem::path file_of_its_own() {
  static std::atomic<int> count;
  return std::filesystem::temp_directory_path() /
         ("jounce-site-" + std::to_string(::getpid()) + "-" + std::to_string(++count) + ".lcmlog");
}

CycleOptions cycle_of(const std::vector<ExecutorOptions>& axes,
                      const std::vector<MachineMaster>& masters, RecordBuffer* buffer) {
  CycleOptions options{.record = buffer};
  for (const ExecutorOptions& axis : axes) options.drives.push_back(axis.drive.get());
  for (const MachineMaster& master : masters) options.masters.push_back(master.source.get());
  return options;
}

std::vector<ExecutorOptions> with(Recorder* recorder, std::vector<ExecutorOptions> axes) {
  for (ExecutorOptions& axis : axes) axis.recorder = recorder;
  return axes;
}

executor_detail::RunRecord record_of(const std::filesystem::path& log,
                                     const std::vector<ExecutorOptions>& axes,
                                     const SiteSpec& spec) {
  if (!spec.recorded) return {};
  return executor_detail::record_of({.masters = spec.masters, .record = {.log = log}},
                                    spec.said.empty() ? axes : spec.said);
}

}  // namespace

ExecutorOptions axis_named(const std::string& name, const Limits& limits, const Units& units) {
  ExecutorOptions options;
  options.axis.limits = limits;
  options.units = units;
  options.receiver.executor = name;
  return options;
}

Site::Site(std::vector<ExecutorOptions> of_axes, SiteSpec spec)
    : log_(file_of_its_own()),
      record_(record_of(log_, of_axes, spec)),
      axes(with(record_.recorder.get(), std::move(of_axes))),
      masters(std::move(spec.masters)),
      cycle(machine, pacer, exchange, cycle_of(axes, masters, record_.buffer.get())) {
  network.on_wait = [this](Nanos time) { advance(time); };
}

Site::~Site() {
  std::error_code none;
  std::filesystem::remove(log_, none);
}

void Site::advance(Nanos time) {
  for (const Nanos end = clock() + time; clock() < end;) turn();
}

void Site::turn() {
  if (before) before();
  cycle.once();
  dispatcher.turn(0ns);
  if (after) after();
}

StreamOutcome Site::stream(StreamPlan plan) {
  if (plan.executor.empty()) plan.executor = axes.front().receiver.executor;
  return stream_tables(link, std::move(plan), {}, clock, ++sessions);
}

StreamOutcome Site::play(const Table& table) {
  return stream({.executor = {}, .tables = {{table, {"s", axes.front().units.position}}}});
}

std::string Site::record() {
  advance(20ms);
  dispatcher.turn(0ns);
  dispatcher.close();
  record_.recorder->close();
  EXPECT_EQ(record_.recorder->trouble(), "");
  EXPECT_EQ(record_.recorder->lost(), 0);
  std::ifstream file(log_, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Replay Site::replayed(const std::function<void(const RecordedCycle&)>& each,
                      const std::function<void(const RecordedSight&)>& sight) {
  std::istringstream in(record());
  return replay(in, "site.lcmlog", each, sight);
}

}  // namespace jounce::test
