// Streams over a real link, each side with its own transport and thread: see real_stream.sh.
//
//     real_stream no-route URL    where there is no route for multicast: expects the advice
//     real_stream stream URL      expects whole streams, on a good link and on a lossy one
#include <atomic>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "jounce/stream/open_transport.hpp"

#include "stream/harness.hpp"

namespace jounce {
namespace {

using namespace std::chrono_literals;

int expect_advice(const std::string& url) {
  try {
    (void)open_transport(url);
  } catch (const TransportError& error) {
    std::printf("%s\n", error.what());
    return std::string(error.what()).find("ip route add 224.0.0.0/4 dev lo") == std::string::npos;
  }
  std::printf("a link without a route\n");
  return 1;
}

/// An executor in its own thread, as long as it lives.
class ExecutorThread {
 public:
  explicit ExecutorThread(const std::string& url)
      : link_(open_transport(url)),
        executor_(*link_, steady_now, random_id()),
        thread_([this] { run(); }) {}
  ~ExecutorThread() { join(); }
  ExecutorThread(const ExecutorThread&) = delete;
  ExecutorThread& operator=(const ExecutorThread&) = delete;

  /// Ends the thread; then the executor may be looked at.
  const test::Executor& join() {
    quit_ = true;
    if (thread_.joinable()) thread_.join();
    return executor_;
  }

 private:
  void run() {
    while (!quit_) {
      executor_.pump.run(2ms);
      executor_.turn();
      executor_.pump.publish({.state = wire::AxisState::standstill});
    }
  }

  std::unique_ptr<Transport> link_;
  test::Executor executor_;
  std::atomic<bool> quit_ = false;
  std::thread thread_;
};

bool has_status(Transport& link) {
  link.subscribe(wire::channel("feeder", wire::Lane::status), 1);
  Rejects rejects;
  for (const Nanos begin = steady_now(); steady_now() - begin < 5s;) {
    const auto message = next_message(link, 10ms, rejects);
    if (message && std::holds_alternative<wire::Status>(message->body)) return true;
  }
  return false;
}

int stream_once(const std::string& url, const char* label, std::size_t knots, const LossSpec& spec) {
  ExecutorThread executor(url);
  const auto link = open_transport(url);
  LossyTransport lossy(*link, spec, steady_now);
  const Table table = test::sine_table(knots, Rule::quintic_hermite);
  const Nanos begin = steady_now();
  const StreamOutcome outcome = stream_tables(lossy, test::plan_of(table), {}, steady_now, 1);
  const double seconds = std::chrono::duration<double>(steady_now() - begin).count();
  const bool status = has_status(*link);

  const test::Executor& after = executor.join();
  const auto stored = after.pump.receiver().store().find(content_hash(table, test::move_units));
  const bool whole = stored && test::same(*stored->table, table);
  std::printf("%s: %zu knots, %.1f MB in %.3f s, %zu of %zu chunks resent, %s%s%s\n", label, knots,
              static_cast<double>(knots) * 32e-6, seconds, outcome.progress.resent,
              outcome.progress.chunks, outcome.ok() ? "ok" : outcome.reason.c_str(),
              whole ? "" : ", not whole", status ? "" : ", no status");
  return outcome.ok() && outcome.started && whole && status ? 0 : 1;
}

}  // namespace
}  // namespace jounce

int main(int count, char** arguments) {
  if (count != 3) return 2;
  const std::string url = arguments[2];
  if (std::string(arguments[1]) == "no-route") return jounce::expect_advice(url);
  return jounce::stream_once(url, "good link", 500'000, {}) +
         jounce::stream_once(url, "lossy link", 100'000,
                             {.seed = 1, .lost = 0.05, .doubled = 0.05});
}
