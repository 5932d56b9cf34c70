// SPDX-License-Identifier: Apache-2.0
// Keeps executors busy: soak SECONDS LOSS NAME...: each of them plays one of 64 tables, 1 s round,
// and every second another one takes over in motion (protocol page, "Swaps"), commanded over real
// multicast with the share LOSS of packets lost each way, each axis by a thread of its own. No axis
// ever rests.
//
// Beside it, every status is held against this clock and against the table that it names: since the start is at
// a known tick, where the axis has to be in that tick is known too. One line of JSON an axis at the end. Run by
// scripts/soak in a namespace of its own.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/transport/open_transport.hpp"

#include "stream/src/transport/lossy_transport.hpp"

namespace {

using namespace jounce;
using namespace std::chrono_literals;

constexpr const char* url = "udpm://239.255.76.67:7667?ttl=0";
constexpr std::size_t tables = 64;       // tables of a session
constexpr std::int64_t run_up = 10'000;  // ticks, in which all of them are downloaded
constexpr std::int64_t round_ticks = 1000;
const Units units{"s", "mm"};

/// 2 sin w x + c (1 - cos w x)^2 over 1 s: for every c, position, velocity, acceleration and jerk
/// at both ends are the same. So any table can follow any other, at 12.6 mm/s. In one tick the
/// axis's acceleration gives more than that, so the first one may begin from rest.
Table around(double c) {
  constexpr std::size_t knots = 301;
  constexpr double w = 2 * std::numbers::pi;
  Columns columns;
  for (std::size_t i = 0; i < knots; ++i) {
    const double x = static_cast<double>(i) / (knots - 1);
    const double s = std::sin(w * x), k = std::cos(w * x);
    columns.x.push_back(x);
    columns.p.push_back(2 * s + c * (1 - k) * (1 - k));
    columns.v.push_back(w * (2 * k + 2 * c * (1 - k) * s));
    columns.a.push_back(w * w * (-2 * s + 2 * c * (s * s + k - k * k)));
  }
  for (auto* column : {&columns.p, &columns.v, &columns.a}) column->back() = column->front();
  return Table(Domain::time, Interpolation::quintic_hermite, Extrapolation::wrap,
               std::move(columns));
}

/// Result of one axis.
struct Result {
  std::size_t swaps = 0, resent = 0;
  std::string failure = {};
  long statuses = 0, errors = 0, rests = 0;
  std::int64_t finished = 0, late = 0;
  double drift = 0;  // s: the most by which ticks * period left this clock, over 20 statuses
  double off = 0;    // u: greatest distance from the table that its status named
};

/// Its tables, by the first bytes of their hash, as a status names them.
class Tables {
 public:
  explicit Tables(std::size_t axis) {
    for (std::size_t i = 0; i < tables; ++i) {
      items_.push_back({around(0.02 * static_cast<double>(tables * axis + i) - 5), units});
      by_prefix_[prefix(content_hash(items_.back().table, units))] = i;
    }
  }
  [[nodiscard]] const std::vector<StreamPlan::Item>& items() const { return items_; }
  [[nodiscard]] const Table* find(const std::array<std::uint8_t, 8>& first) const {
    const auto it = by_prefix_.find(first);
    return it == by_prefix_.end() ? nullptr : &items_[it->second].table;
  }

 private:
  static std::array<std::uint8_t, 8> prefix(const Sha256& hash) {
    std::array<std::uint8_t, 8> first{};
    std::copy_n(hash.begin(), first.size(), first.begin());
    return first;
  }
  std::vector<StreamPlan::Item> items_;
  std::map<std::array<std::uint8_t, 8>, std::size_t> by_prefix_;
};

class Watch {
 public:
  explicit Watch(std::string executor) : executor_(std::move(executor)) {
    link_.subscribe(wire::channel(executor_, wire::Lane::status), 1);
  }
  wire::Status now() {
    const auto message = next_status(link_, executor_, 2s);
    if (!message) {
      std::fprintf(stderr, "%s is silent\n", executor_.c_str());
      std::exit(1);
    }
    return std::get<wire::Status>(message->body);
  }
  /// Every status until `end`, of a motion that begins at `start`.
  void watch(const Tables& own, std::int64_t start, Nanos end, Result& result) {
    const wire::Status first = now();
    while (steady_now() < end) {
      const wire::Status status = now();
      time(status, result);
      place(status, own, start, result);
      result.errors += status.last_error != 0;
      result.late = status.late_ticks - first.late_ticks;
      result.finished = status.finished - first.finished;
    }
  }

 private:
  /// A status is late by its delay, never early: the least late of several gives the time.
  void time(const wire::Status& status, Result& result) {
    const double clock = std::chrono::duration<double>(steady_now()).count();
    const double ahead = static_cast<double>(status.tick * status.cycle_ns) * 1e-9 - clock;
    best_ = result.statuses++ % window == 0 ? ahead : std::max(best_, ahead);
    if (result.statuses == window) first_ = best_;
    if (result.statuses % window == 0)
      result.drift = std::max(result.drift, std::abs(best_ - first_));
  }
  static void place(const wire::Status& status, const Tables& own, std::int64_t start,
                    Result& result) {
    if (status.tick <= start) return;
    const Table* const table = own.find(status.table);
    if (status.state != State::discrete_motion || table == nullptr) {
      ++result.rests;
      return;
    }
    const double x = static_cast<double>((status.tick - start) % round_ticks) * 1e-3;
    result.off = std::max(result.off, std::abs(status.slave_position - table->jet(x)[0]));
  }

  std::string executor_;
  std::unique_ptr<Transport> bus_ = open_transport(url);
  Transport& link_ = *bus_;
  static constexpr long window = 20;
  double first_ = 0, best_ = 0;  // s by which the ticks are ahead of this clock
};

/// Streams all tables of the axis, starts the first one at `start`, and swaps to the next one every second.
void swap(const std::string& executor, std::size_t axis, const Tables& own, double loss,
          std::int64_t start, std::size_t swaps, Result& result) {
  const auto bus = open_transport(url);
  Transport& link = *bus;
  LossyTransport lossy(link, {.seed = axis + 1, .lost = loss}, steady_now);
  StreamPlan plan{.executor = executor, .tables = own.items(), .start_tick = start};
  for (std::size_t i = 1; i <= swaps; ++i)
    plan.swaps.push_back({.slave = i % tables, .when = StartAt::end_of_table});
  StreamOptions options;
  options.total = 1000h;
  const StreamOutcome outcome = stream_tables(lossy, std::move(plan), options);
  result.swaps = outcome.swaps;
  result.resent = outcome.progress.resent;
  if (!outcome.ok()) result.failure = std::string(name(outcome.error)) + " " + outcome.reason;
}

Result keep_busy(const std::string& executor, std::size_t axis, double loss, Nanos end) {
  Result result;
  const Tables own(axis);
  Watch watch(executor);
  const std::int64_t start = watch.now().tick + run_up;
  const double left = std::chrono::duration<double>(end - steady_now()).count();
  const auto swaps = static_cast<std::size_t>(std::max(left - run_up * 1e-3 - 3, 1.0));
  std::thread streamer([&] { swap(executor, axis, own, loss, start, swaps, result); });
  Result seen;
  watch.watch(own, start, end, seen);
  streamer.join();
  seen.swaps = result.swaps;
  seen.resent = result.resent;
  seen.failure = result.failure;
  const auto bus = open_transport(url);
  Transport& link = *bus;
  if (!operator_stop(link, executor, wire::StopMode::stop)) seen.failure += " cannot be stopped";
  return seen;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  const double seconds = std::atof(arguments[1]);
  const double loss = std::atof(arguments[2]);
  const Nanos end = steady_now() + Nanos(static_cast<std::int64_t>(seconds * 1e9));
  const std::vector<std::string> names(arguments + 3, arguments + count);
  std::vector<Result> results(names.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < names.size(); ++i)
    threads.emplace_back([&, i] { results[i] = keep_busy(names[i], i, loss, end); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Result& r = results[i];
    std::printf(
        "{\"axis\": \"%s\", \"swaps\": %zu, \"resent\": %zu, \"failure\": \"%s\", \"finished\": "
        "%lld, "
        "\"statuses\": %ld, \"errors\": %ld, \"rests\": %ld, \"late\": %lld, \"drift_ms\": %.3f, "
        "\"off\": %g}\n",
        names[i].c_str(), r.swaps, r.resent, r.failure.c_str(), static_cast<long long>(r.finished),
        r.statuses, r.errors, r.rests, static_cast<long long>(r.late), r.drift * 1e3, r.off);
  }
}
