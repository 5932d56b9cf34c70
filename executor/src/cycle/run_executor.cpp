// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/run_executor.hpp"

#include <atomic>
#include <cmath>
#include <csignal>
#include <future>
#include <memory>
#include <optional>
#include <thread>

#include "jounce/executor/detail/dispatcher.hpp"
#include "jounce/executor/detail/recorder.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/detail/claim.hpp"

#include "executor/src/record/run_record.hpp"
#include "executor/src/server/motion_server.hpp"

namespace jounce {
namespace {

std::atomic<int> signals_seen{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler must not wait");

/// Counts SIGINT, SIGTERM and SIGHUP during its lifetime, and ignores SIGPIPE. The process must not
/// end while an axis moves, because a terminal or a pipe was closed. Handlers use SA_RESTART: LCM's
/// memq fails if a signal interrupts one of its calls.
class SignalWatch {
 public:
  SignalWatch() {
    struct sigaction count {};
    count.sa_handler = [](int) { ++signals_seen; };
    count.sa_flags = SA_RESTART;
    sigaction(SIGINT, &count, &interrupt_);
    sigaction(SIGTERM, &count, &terminate_);
    sigaction(SIGHUP, &count, &hang_up_);
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &pipe_);
  }
  ~SignalWatch() {
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
    sigaction(SIGHUP, &hang_up_, nullptr);
    sigaction(SIGPIPE, &pipe_, nullptr);
  }
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

 private:
  struct sigaction interrupt_ {};
  struct sigaction terminate_ {};
  struct sigaction hang_up_ {};
  struct sigaction pipe_ {};
};

/// The cyclic thread. Its destructor joins it at the latest.
class CyclicThread {
 public:
  CyclicThread(Machine& machine, CycleOptions options, MachineExchange& exchange,
               const RunOptions& run)
      : machine_(machine),
        options_(std::move(options)),
        thread_([this, &exchange, run] { this->run(exchange, run); }) {}
  ~CyclicThread() { join(); }
  CyclicThread(const CyclicThread&) = delete;
  CyclicThread& operator=(const CyclicThread&) = delete;

  /// The result of make_realtime(); waits for it.
  std::string realtime() { return realtime_.get_future().get(); }

  CycleCounts join() {
    running_ = false;
    if (thread_.joinable()) thread_.join();
    return counts_;
  }

 private:
  void run(MachineExchange& exchange, const RunOptions& run) {
    realtime_.set_value(make_realtime(run.realtime));
    const double cycles = std::ceil(run.watchdog * 1e9 / static_cast<double>(machine_.period()));
    options_.patience = static_cast<std::int64_t>(cycles);
    Cycle cycle(machine_, pacer_, exchange, options_);
    while (running_) cycle.once();
    counts_ = cycle.counts();
  }

  Machine& machine_;
  CycleOptions options_;
  MonotonicPacer pacer_;
  std::promise<std::string> realtime_;
  std::atomic<bool> running_{true};
  CycleCounts counts_;
  std::thread thread_;  // last: it uses the others
};

/// Decides when to leave.
class Deadline {
 public:
  explicit Deadline(const RunOptions& run) : run_(run), begin_(steady_now()) {
    if (run.seconds) require_positive("seconds", *run.seconds);
    if (run.watchdog != 0) require_positive("watchdog", run.watchdog);
  }

  [[nodiscard]] bool reached(const Dispatcher& dispatcher) const {
    const double elapsed = std::chrono::duration<double>(steady_now() - begin_).count();
    return signals_seen > 0 || run_.stop.stop_requested() ||
           (run_.seconds && elapsed >= *run_.seconds) ||
           (run_.once && !dispatcher.moving() && has_played(dispatcher));
  }

 private:
  static bool has_played(const Dispatcher& dispatcher) {
    for (std::size_t i = 0; i < dispatcher.size(); ++i) {
      const Tick& last = dispatcher.last(i);
      if (last.finished + last.stopped > 0 || last.fault != Cause::none) return true;
    }
    return false;
  }

  RunOptions run_;
  Nanos begin_;
};

constexpr Nanos turn_time = std::chrono::milliseconds(2);

void turn_while(Dispatcher& dispatcher, Nanos most, const std::function<bool()>& needed) {
  const Nanos begin = steady_now();
  while (needed() && signals_seen < 2 && steady_now() - begin < most) dispatcher.turn(turn_time);
}

/// Brings the axis to rest, then sends an owner its pending answers.
void leave(Dispatcher& dispatcher) {
  using namespace std::chrono_literals;
  dispatcher.retire();
  turn_while(dispatcher, 1h, [&] { return !dispatcher.settled(); });
  turn_while(dispatcher, 2s, [&] { return dispatcher.owned(); });
  turn_while(dispatcher, 100ms, [] { return signals_seen == 0; });
}

/// Communication has failed: no client can stop the axes any more, so this function stops them.
void stop_alone(MachineExchange& exchange) {
  using namespace std::chrono_literals;
  const Nanos begin = steady_now();
  for (auto& axis : exchange.axes)
    while (!axis->commands.push({command::Stop{}}) && steady_now() - begin < 1s)
      std::this_thread::sleep_for(1ms);
  for (auto& axis : exchange.axes) {
    Tick tick;
    bool at_rest = false;
    while (!at_rest && steady_now() - begin < 60s) {
      std::this_thread::sleep_for(20ms);
      ++exchange.cycle.alive;
      while (axis->ticks.pop(tick)) at_rest = !in_motion(tick) && steady_now() - begin > 100ms;
    }
  }
}

CycleOptions cycle_of(const std::vector<ExecutorOptions>& axes, const RunOptions& run,
                      RecordBuffer* buffer) {
  CycleOptions options{.record = buffer};
  for (const auto& axis : axes) options.drives.push_back(axis.drive.get());
  for (const auto& master : run.masters) options.masters.push_back(master.source.get());
  return options;
}

AxisSummary summary_of(const MotionServer& server) {
  const Tick& last = server.last();
  return {.name = server.options().receiver.executor,
          .finished = last.finished - server.ended_with_group(),
          .stopped = last.stopped,
          .fault = last.fault,
          .position = last.position,
          .unit = server.options().units.position,
          .log_truncated = server.log_truncated()};
}

/// Claims the names of the axes over the link.
Claim claimed(Transport& link, const std::vector<ExecutorOptions>& axes) {
  std::vector<std::string> names;
  for (const auto& axis : axes) names.push_back(axis.receiver.executor);
  Claim claim(std::move(names), random_id());
  if (claim_names(link, claim, axes.front().receiver.key, steady_now)) return claim;
  throw InputError("name", *claim.lost(),
                   "another executor on this --url has this name: end that `jounce run`, or give "
                   "the axis another "
                   "name");
}

}  // namespace

ExecutorSummary run_executor(Transport& link, const std::vector<ExecutorOptions>& of_axes,
                             const RunOptions& run) {
  static_cast<void>(Deadline(run));  // throws for bad options
  std::vector<ExecutorOptions> axes = of_axes;
  Claim claim = claimed(link, axes);
  const Deadline deadline(run);
  signals_seen = 0;
  std::optional<SignalWatch> watch;
  if (run.handle_signals) watch.emplace();
  const executor_detail::RunRecord recording = executor_detail::record_of(run, axes);
  for (auto& axis : axes) {
    axis.recorder = recording.recorder.get();
    axis.trace = run.trace;
  }
  Machine machine(machine_of(axes), run.masters.size());
  MachineExchange exchange(machine.size(), machine.masters());
  Dispatcher dispatcher(link, axes, exchange, steady_now, run.masters, std::move(claim));
  CyclicThread cyclic(machine, cycle_of(axes, run, recording.buffer.get()), exchange, run);
  ExecutorSummary summary;
  summary.realtime = cyclic.realtime();

  try {
    if (axes.front().notify && !summary.realtime.empty()) axes.front().notify(summary.realtime);
    if (run.up) run.up();
    while (!deadline.reached(dispatcher) && dispatcher.lost_name().empty())
      dispatcher.turn(turn_time);
    summary.lost_name = dispatcher.lost_name();
    leave(dispatcher);
  } catch (...) {
    stop_alone(exchange);
    throw;
  }
  summary.cycle = cyclic.join();
  dispatcher.close();
  if (recording.recorder) {
    recording.recorder->close();
    summary.record_trouble = recording.recorder->trouble();
    summary.record_lost = recording.recorder->lost();
  }
  summary.lateness = exchange.cycle.lateness.counts();
  summary.computing = exchange.cycle.computing.counts();
  for (std::size_t i = 0; i < dispatcher.size(); ++i)
    summary.axes.push_back(summary_of(dispatcher.server(i)));
  return summary;
}

}  // namespace jounce
