// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/run_executor.hpp"

#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/detail/sender.hpp"
#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/transport/link.hpp"

#include "axis/tables.hpp"
#include "stream/src/transport/memory_transport.hpp"

namespace jounce::run_executor_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

const Units over_time{.x = "s", .position = "mm"};

ExecutorOptions options() {
  ExecutorOptions options;
  options.axis.limits = limits(1000, 1e5);
  // The machine that runs the tests may be busy: no gap shall be a fault here.
  options.axis.longest_gap = 1'000'000;
  options.receiver.executor = "feeder";
  return options;
}

/// A streamer that has its turn whenever the executor waits for the link.
struct Streamer {
  Streamer(MemoryNetwork& network, const Table& table)
      : link(network), sender({.executor = "feeder", .tables = {{table, over_time}}}, 1) {
    link.subscribe(wire::channel("feeder", wire::Lane::reply), 64);
    network.on_wait = [this](Nanos) { turn(); };
  }

  void turn() {
    std::this_thread::sleep_for(1ms);
    for (const auto& message : sender.poll(steady_now())) send_message(link, message);
    Rejects rejects;
    while (const auto message = next_message(link, 0ns, rejects))
      sender.receive(*message, steady_now());
    if (!sender.at_goal()) return;
    if (at_goal) at_goal();
    at_goal = nullptr;
    if (release) sender.release();
  }

  MemoryTransport link;
  Sender sender;
  bool release = true;
  std::function<void()> at_goal;
};

TEST(RunExecutor, PlaysOneJobAndLeaves) {
  MemoryNetwork network;
  MemoryTransport link(network);
  Streamer streamer(network, *there_and_back(0, 5, 0.1, Extrapolation::hold));
  const ExecutorSummary summary = run_executor(link, {options()}, {.seconds = 60, .once = true});
  EXPECT_EQ(summary.axes.at(0).finished, 1U);
  EXPECT_EQ(summary.axes.at(0).stopped, 0U);
  EXPECT_EQ(summary.axes.at(0).fault, Cause::none);
  EXPECT_EQ(summary.axes.at(0).position, 0);
  EXPECT_GE(summary.cycle.ticks + summary.cycle.skipped, 100);
  EXPECT_EQ(summary.cycle.lost, 0);
  EXPECT_TRUE(streamer.sender.outcome().started);
  EXPECT_EQ(streamer.sender.outcome().error, StreamError::none);
}

TEST(RunExecutor, ASignalStopsTheMotionFirst) {
  for (const int signal : {SIGTERM, SIGINT}) {
    MemoryNetwork network;
    MemoryTransport link(network);
    Streamer streamer(network, *there_and_back(0, 5, 0.5, Extrapolation::wrap));
    streamer.at_goal = [signal] { std::raise(signal); };
    const ExecutorSummary summary = run_executor(link, {options()}, {.seconds = 60});
    EXPECT_EQ(summary.axes.at(0).finished, 0U);
    EXPECT_EQ(summary.axes.at(0).stopped, 1U);
    EXPECT_EQ(summary.axes.at(0).fault, Cause::none);
  }
}

TEST(RunExecutor, AnotherProgramEndsItAndKeepsItsSignals) {
  MemoryNetwork network;
  MemoryTransport link(network);
  Streamer streamer(network, *there_and_back(0, 5, 0.5, Extrapolation::wrap));
  std::stop_source source;
  struct sigaction before {
  }, during{};
  sigaction(SIGINT, nullptr, &before);
  streamer.at_goal = [&] {
    sigaction(SIGINT, nullptr, &during);
    source.request_stop();
  };
  const ExecutorSummary summary = run_executor(
      link, {options()}, {.seconds = 60, .stop = source.get_token(), .handle_signals = false});
  EXPECT_EQ(during.sa_handler, before.sa_handler);
  EXPECT_EQ(summary.axes.at(0).stopped, 1U) << "the motion is stopped first";
  EXPECT_EQ(summary.axes.at(0).fault, Cause::none);
}

TEST(RunExecutor, EndsWithItsTimeAndReportsWhatItWasGranted) {
  MemoryNetwork network;
  network.on_wait = [](Nanos time) { std::this_thread::sleep_for(time); };
  MemoryTransport link(network);
  ExecutorOptions given = options();
  std::vector<std::string> notices;
  given.notify = [&](const std::string& notice) { notices.push_back(notice); };
  const ExecutorSummary summary =
      run_executor(link, {given}, {.seconds = 0.02, .realtime = {.priority = 1}});
  EXPECT_EQ(summary.axes.at(0).finished, 0U);
  EXPECT_THAT(summary.realtime, ::testing::HasSubstr("SCHED_FIFO"));
  EXPECT_THAT(notices, ::testing::ElementsAre(summary.realtime));
}

TEST(RunExecutor, ACpuThatDoesNotExistIsRejected) {
  EXPECT_NO_THROW(require_cpu(-1));
  EXPECT_THROW(require_cpu(1'000'000), InputError);
}

TEST(RunExecutor, BadOptionsAreBadInput) {
  MemoryNetwork network;
  MemoryTransport link(network);
  EXPECT_THROW(run_executor(link, {options()}, {.seconds = 0.0}), InputError);
  ExecutorOptions bad = options();
  bad.receiver.executor = "no blanks";
  EXPECT_THROW(run_executor(link, {bad}, {.seconds = 0.01}), InputError);
  bad = options();
  bad.axis.limits.velocity.reset();
  EXPECT_THROW(run_executor(link, {bad}, {.seconds = 0.01}), InputError);
}

}  // namespace
}  // namespace jounce::run_executor_test
