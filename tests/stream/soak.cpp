// Keeps executors busy: soak SECONDS LOSS NAME...: every second another table to each of them, over
// real multicast with so many packets lost each way, each in a thread of its own. Beside it the status
// of each is watched: its ticks against this clock, its faults. One line of JSON an executor at the end.
// Run by scripts/soak in a namespace of its own.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "jounce/stream/driver.hpp"
#include "jounce/stream/lcm_transport.hpp"
#include "jounce/stream/lossy_transport.hpp"

namespace {

using namespace jounce;
using namespace std::chrono_literals;

constexpr const char* url = "udpm://239.255.76.67:7667?ttl=0";

/// From one place to another in 0.6 s by the 3-4-5 polynomial, cut into 300 quintics.
Table step(double from, double to) {
  constexpr std::size_t knots = 301;
  constexpr double T = 0.6;
  const double h = to - from;
  Columns columns;
  for (std::size_t i = 0; i < knots; ++i) {
    const double u = static_cast<double>(i) / (knots - 1);
    columns.x.push_back(T * u);
    columns.p.push_back(from + h * u * u * u * (10 + u * (6 * u - 15)));
    columns.v.push_back(h / T * 30 * u * u * (1 - u) * (1 - u));
    columns.a.push_back(h / (T * T) * 60 * u * (1 - u) * (1 - 2 * u));
  }
  columns.p.back() = to;
  return Table(Axis::time, Rule::quintic_hermite, Outside::hold, std::move(columns));
}

/// What became of one executor.
struct Result {
  long streamed = 0, failed = 0;
  std::string failure;
  long statuses = 0, errors = 0;
  std::int64_t finished = 0, late = 0;
  double drift =
      0;  // s: the most by which ticks * period left this clock, over windows of 20 statuses
  double missed = 0;  // the most that the axis stood beside its table's end, u
};

class Watch {
 public:
  explicit Watch(std::string executor) : executor_(std::move(executor)) {
    link_.subscribe(wire::channel(executor_, wire::Lane::status), 1);
  }
  /// The newest status; its place is compared with the clock.
  wire::Status now(Result& result) {
    const auto message = next_status(link_, executor_, 2s);
    if (!message) {
      std::fprintf(stderr, "%s is silent\n", executor_.c_str());
      std::exit(1);
    }
    const auto status = std::get<wire::Status>(message->body);
    const double clock = std::chrono::duration<double>(steady_now()).count();
    // A status is late by what it waits, never early: of some, the least late tells the time.
    const double ahead = static_cast<double>(status.tick * status.cycle_ns) * 1e-9 - clock;
    best_ = result.statuses++ % window == 0 ? ahead : std::max(best_, ahead);
    if (result.statuses == 1) late_ = status.late_ticks, finished_ = status.finished;
    if (result.statuses == window) first_ = best_;
    if (result.statuses % window == 0)
      result.drift = std::max(result.drift, std::abs(best_ - first_));
    result.errors += status.last_error != 0;
    result.late = status.late_ticks - late_;
    result.finished = status.finished - finished_;
    return status;
  }

 private:
  std::string executor_;
  LcmTransport link_{url};
  static constexpr long window = 20;
  double first_ = 0, best_ = 0;  // s by which the ticks are ahead of this clock
  std::int64_t late_ = 0, finished_ = 0;
};

Result keep_busy(const std::string& executor, std::uint64_t seed, double loss, Nanos end) {
  Result result;
  LcmTransport link(url);
  LossyTransport lossy(link, {.seed = seed, .lost = loss}, steady_now);
  Watch watch(executor);
  double at = watch.now(result).slave_position;
  for (Nanos next = steady_now(); next < end; next += 1s) {
    std::this_thread::sleep_for(next - steady_now());
    const double to = at > 0 ? 0 : 50 + static_cast<double>(result.streamed % 97);
    const StreamOutcome outcome = stream_tables(
        lossy, {.executor = executor, .tables = {{step(at, to), {"s", "mm"}}}}, {}, steady_now);
    if (!outcome.ok()) {
      ++result.failed;
      result.failure = outcome.reason;
      continue;
    }
    ++result.streamed;
    at = to;
    std::this_thread::sleep_for(700ms);
    const wire::Status status = watch.now(result);
    result.missed = std::max(result.missed, std::abs(status.slave_position - at));
  }
  return result;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  const double seconds = std::atof(arguments[1]);
  const double loss = std::atof(arguments[2]);
  const Nanos end = steady_now() + Nanos(static_cast<std::int64_t>(seconds * 1e9));
  std::vector<std::string> names(arguments + 3, arguments + count);
  std::vector<Result> results(names.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < names.size(); ++i)
    threads.emplace_back([&, i] { results[i] = keep_busy(names[i], i + 1, loss, end); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Result& r = results[i];
    std::printf(
        "{\"axis\": \"%s\", \"streamed\": %ld, \"failed\": %ld, \"failure\": \"%s\", "
        "\"finished\": %lld, \"errors\": %ld, \"late\": %lld, \"drift_ms\": %.3f, "
        "\"missed\": %g}\n",
        names[i].c_str(), r.streamed, r.failed, r.failure.c_str(),
        static_cast<long long>(r.finished), r.errors, static_cast<long long>(r.late), r.drift * 1e3,
        r.missed);
  }
}
