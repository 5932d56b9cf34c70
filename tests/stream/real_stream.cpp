// SPDX-License-Identifier: Apache-2.0
// Streams over a real link, each side with its own transport and thread: see real_stream.sh.
//
//     real_stream no-route URL    where there is no route for multicast: expects the advice
//     real_stream stream URL      expects whole streams, on a good link and on a lossy one
//     real_stream once URL LABEL KNOTS [ends]
//                                 expects a whole stream; with `ends` that, or a named error and nothing wrong stored
//     real_stream relayed URL EXECUTORS_URL LABEL KNOTS
//                                 the same between two links that something joins: expects a whole stream
//     real_stream lcm URL         expects that LCM's own library sends to a link and receives from it
#include <atomic>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <lcm/lcm-cpp.hpp>

#include "jounce/stream/receiver/receiver_options.hpp"
#include "jounce/stream/transport/open_transport.hpp"

#include "stream/harness.hpp"

namespace jounce {
namespace {

using namespace std::chrono_literals;

/// Patience of both sides: a machine under load stretches a cut of the link.
constexpr Nanos patience = 10s;

int expect_advice(const std::string& url) {
  try {
    (void)open_transport(url);
  } catch (const TransportError& error) {
    std::printf("%s\n", error.what());
    return std::string(error.what()).find("ip route add 239.255.76.67/32 dev eth1") ==
           std::string::npos;
  }
  std::printf("a link without a route\n");
  return 1;
}

/// An executor in its own thread, as long as it lives.
class ExecutorThread {
 public:
  explicit ExecutorThread(const std::string& url)
      : link_(open_transport(url)),
        executor_(*link_, steady_now, random_id(), options()),
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
  static ReceiverOptions options() {
    ReceiverOptions options;
    options.session_timeout = patience;
    return options;
  }
  void run() {
    while (!quit_) {
      executor_.pump.run(2ms);
      executor_.turn();
      executor_.pump.publish({.state = State::standstill});
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

/// A streamer's link, and the executor's.
struct Urls {
  Urls(const std::string& both) : streamer(both), executor(both) {}
  Urls(std::string its, std::string executors)
      : streamer(std::move(its)), executor(std::move(executors)) {}
  std::string streamer, executor;
};

int stream_once(const Urls& url, const std::string& label, std::size_t knots, const LossSpec& spec,
                bool may_end = false) {
  ExecutorThread executor(url.executor);
  const auto link = open_transport(url.streamer);
  LossyTransport lossy(*link, spec, steady_now);
  const Table table = test::sine_table(knots, Interpolation::quintic_hermite);
  const Nanos begin = steady_now();
  StreamOptions options;
  options.sender.patience = options.sender.command_patience = patience;
  const StreamOutcome outcome = stream_tables(lossy, test::plan_of(table), options, steady_now);
  const double seconds = std::chrono::duration<double>(steady_now() - begin).count();
  const bool status = has_status(*link);

  const test::Executor& after = executor.join();
  const auto stored = after.pump.receiver().store().find(content_hash(table, test::move_units));
  const bool whole = stored && test::same(*stored->table, table);
  std::printf("%s: %zu knots, %.1f MB in %.3f s, %zu of %zu chunks resent, %s%s%s\n", label.c_str(),
              knots, static_cast<double>(knots) * 32e-6, seconds, outcome.progress.resent,
              outcome.progress.chunks, outcome.ok() ? "ok" : name(outcome.error),
              whole ? "" : ", not whole", status ? "" : ", no status");
  const bool right = outcome.ok() ? outcome.started && whole : may_end && (!stored || whole);
  return right && (status || may_end) ? 0 : 1;
}

/// A message that LCM's library has received, with its channel.
struct Heard {
  std::string channel;
  std::vector<std::byte> bytes;

  static void on_message(const lcm::ReceiveBuffer* buffer, const std::string& channel,
                         Heard* heard) {
    const auto* const data = static_cast<const std::byte*>(buffer->data);
    *heard = {channel, {data, data + buffer->data_size}};
  }
};

/// A short message and the longest of the protocol, in both directions.
int beside_lcm(const std::string& url) {
  lcm::LCM theirs(url + "?ttl=0");
  const auto ours = open_transport(url);
  ours->subscribe("JOUNCE2.*.table", 10);
  Heard heard;
  theirs.subscribeFunction(".*command", &Heard::on_message, &heard);
  int wrong = 0;
  for (const std::size_t size : {std::size_t{1}, std::size_t{61'540}}) {
    std::vector<std::byte> bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * 7);
    theirs.publish("JOUNCE2.feeder.table", bytes.data(), static_cast<unsigned>(size));
    const auto packet = ours->receive(5s);
    wrong += !packet || packet->channel != "JOUNCE2.feeder.table" || packet->bytes != bytes;
    ours->send("JOUNCE2.feeder.command", bytes);
    wrong += theirs.handleTimeout(5000) <= 0 || heard.channel != "JOUNCE2.feeder.command" ||
             heard.bytes != bytes;
  }
  std::printf("beside LCM's own library: %d wrong\n", wrong);
  return wrong;
}

}  // namespace
}  // namespace jounce

int main(int count, char** arguments) {
  const bool once = count >= 5 && std::string(arguments[1]) == "once";
  const bool relayed = count == 6 && std::string(arguments[1]) == "relayed";
  if (count != 3 && !once && !relayed) return 2;
  const std::string url = arguments[2];
  if (std::string(arguments[1]) == "no-route") return jounce::expect_advice(url);
  if (relayed)
    return jounce::stream_once({url, arguments[3]}, arguments[4], std::stoul(arguments[5]), {});
  if (once) return jounce::stream_once(url, arguments[3], std::stoul(arguments[4]), {}, count > 5);
  if (std::string(arguments[1]) == "lcm") return jounce::beside_lcm(url);
  return jounce::stream_once(url, "good link", 500'000, {}) +
         jounce::stream_once(url, "lossy link", 100'000,
                             {.seed = 1, .lost = 0.05, .doubled = 0.05});
}
