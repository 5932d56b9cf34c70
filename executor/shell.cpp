#include "jounce/executor/shell.hpp"

#include <atomic>
#include <csignal>
#include <future>
#include <memory>
#include <thread>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::atomic<int> signals_seen{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler must not wait");

/// Counts SIGINT, SIGTERM and SIGHUP while it lives, and ignores SIGPIPE: neither a closed terminal
/// nor a closed pipe may end the process under a moving axis. SA_RESTART, because LCM's memq does
/// not survive a call that a signal has interrupted.
class SignalWatch {
 public:
  SignalWatch() {
    signals_seen = 0;
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

/// The cyclic thread. Joined by its destructor at the latest.
class CyclicThread {
 public:
  CyclicThread(const ExecutorOptions& options, Mail& mail, int priority)
      : axis_(options.axis, options.switches),
        thread_([this, &mail, priority] { run(mail, priority); }) {}
  ~CyclicThread() { join(); }
  CyclicThread(const CyclicThread&) = delete;
  CyclicThread& operator=(const CyclicThread&) = delete;

  /// What make_realtime() said; waits for it.
  std::string realtime() { return realtime_.get_future().get(); }

  CycleCounts join() {
    running_ = false;
    if (thread_.joinable()) thread_.join();
    return counts_;
  }

 private:
  void run(Mail& mail, int priority) {
    realtime_.set_value(priority > 0 ? make_realtime(priority) : "");
    Cycle cycle(axis_, pacer_, mail);
    while (running_) cycle.once();
    counts_ = cycle.counts();
  }

  MotionAxis axis_;
  MonotonicPacer pacer_;
  std::promise<std::string> realtime_;
  std::atomic<bool> running_{true};
  CycleCounts counts_;
  std::thread thread_;  // last: it uses the others
};

/// When it is time to leave.
class Deadline {
 public:
  explicit Deadline(const RunOptions& run) : run_(run), begin_(steady_now()) {
    if (run.seconds) require_positive("seconds", *run.seconds);
  }

  [[nodiscard]] bool reached(const Tick& last) const {
    const double elapsed = std::chrono::duration<double>(steady_now() - begin_).count();
    const bool ended = last.finished + last.stopped > 0 || last.fault != Cause::none;
    return signals_seen > 0 || (run_.seconds && elapsed >= *run_.seconds) || (run_.once && ended);
  }

 private:
  RunOptions run_;
  Nanos begin_;
};

constexpr Nanos turn_time = std::chrono::milliseconds(2);

void turn_while(Dispatcher& dispatcher, Nanos most, const std::function<bool()>& needed) {
  const Nanos begin = steady_now();
  while (needed() && signals_seen < 2 && steady_now() - begin < most) dispatcher.turn(turn_time);
}

/// Brings the axis to rest, then lets an owner hear the answers that it waits for.
void leave(Dispatcher& dispatcher) {
  using namespace std::chrono_literals;
  dispatcher.retire();
  turn_while(dispatcher, 1h, [&] { return !dispatcher.settled(); });
  turn_while(dispatcher, 2s, [&] { return dispatcher.owned(); });
  turn_while(dispatcher, 100ms, [] { return signals_seen == 0; });
}

/// Communication has failed: without it nobody can stop the axis any more, so it is stopped here.
void stop_alone(Mail& mail) {
  using namespace std::chrono_literals;
  const Nanos begin = steady_now();
  while (!mail.commands.push({.kind = Command::Kind::stop}) && steady_now() - begin < 1s)
    std::this_thread::sleep_for(1ms);
  Tick tick;
  bool at_rest = false;
  while (!at_rest && steady_now() - begin < 60s) {
    std::this_thread::sleep_for(20ms);
    while (mail.ticks.pop(tick))
      at_rest = tick.job == 0 && !tick.waiting && steady_now() - begin > 100ms;
  }
}

}  // namespace

ExecutorSummary run_executor(Transport& link, const ExecutorOptions& options,
                             const RunOptions& run) {
  const Deadline deadline(run);
  const SignalWatch watch;
  const auto mail = std::make_unique<Mail>();
  Dispatcher dispatcher(link, options, *mail);
  CyclicThread cyclic(options, *mail, run.realtime_priority);
  ExecutorSummary summary;
  summary.realtime = cyclic.realtime();
  if (options.notify && !summary.realtime.empty()) options.notify(summary.realtime);

  try {
    while (!deadline.reached(dispatcher.last())) dispatcher.turn(turn_time);
    leave(dispatcher);
  } catch (...) {
    stop_alone(*mail);
    throw;
  }
  summary.cycle = cyclic.join();
  dispatcher.close();

  const Tick& last = dispatcher.last();
  summary.finished = last.finished;
  summary.stopped = last.stopped;
  summary.fault = last.fault;
  summary.position = last.position;
  return summary;
}

}  // namespace jounce
