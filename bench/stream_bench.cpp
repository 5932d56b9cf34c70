// SPDX-License-Identifier: Apache-2.0
// What a transfer costs, beside a sender that takes no care: over UDP multicast, two processes, the
// default socket buffer. To be run in a network namespace of its own: scripts/stream_speed.
//
//     bench_stream [KNOTS [ROUNDS]]
//
// Blind: the same messages, encoded beforehand, are published one after the other; the receiver only
// counts. Its rate is what arrived, by the time from the first call to the last arrival.
// Transfer: stream_tables() from the call until the table is acknowledged as complete: hashed, sent,
// confirmed; the receiver has decoded, hashed and constructed it. And until the session is released.
// Bytes of knots by that time. Then what each side has computed a chunk, all threads and the kernel.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <malloc.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/stream/detail/receiver_pump.hpp"
#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/stream_plan.hpp"
#include "jounce/stream/transport/open_transport.hpp"

#include "stream/src/receiver/assembly.hpp"

namespace {

using namespace jounce;
using namespace std::chrono_literals;

constexpr const char* url = "udpm://239.255.76.67:7667?ttl=0";
const Units units{"s", "mm"};

double seconds(Nanos time) {
  return std::chrono::duration<double>(time).count();
}

Table sine(std::size_t knots, Interpolation rule) {
  Columns columns;
  for (std::size_t i = 0; i < knots; ++i) {
    const double t = 1e-3 * static_cast<double>(i);
    columns.x.push_back(t);
    columns.p.push_back(std::sin(t));
    if (rule != Interpolation::linear) columns.v.push_back(std::cos(t));
    if (rule == Interpolation::quintic_hermite) columns.a.push_back(-std::sin(t));
  }
  return Table(Domain::time, rule, Extrapolation::hold, std::move(columns));
}

/// A process of its own with a pipe from it and one to it, which ends it.
class Child {
 public:
  template <class Work>
  explicit Child(Work work) {
    int from[2], to[2];
    if (pipe(from) != 0 || pipe(to) != 0) std::abort();
    process_ = fork();
    if (process_ == 0) {
      work(from[1], to[0]);
      std::_Exit(0);
    }
    from_ = from[0];
    to_ = to[1];
  }
  double number() const {
    double value = 0;
    if (read(from_, &value, sizeof value) != sizeof value) std::abort();
    return value;
  }
  void end() const {
    if (write(to_, "", 1) != 1) std::abort();
  }
  ~Child() {
    waitpid(process_, nullptr, 0);
    close(from_);
    close(to_);
  }

 private:
  pid_t process_ = 0;
  int from_ = 0, to_ = 0;
};

void put(int to, double value) {
  if (write(to, &value, sizeof value) != sizeof value) std::abort();
}

bool got(int from) {
  pollfd descriptor{from, POLLIN, 0};
  return poll(&descriptor, 1, 0) == 1;
}

struct Blind {
  double rate = 0;  // bytes of knots per second that arrived
  double share = 0;
};

Blind blind(const Table& table) {
  const StreamPlan::Item item{table, units};
  const wire::Header header = header_of(item, 0, Pace{}.chunk);
  std::vector<wire::Bytes> packets;
  for (std::uint32_t seq = 0; seq < header.chunks; ++seq)
    packets.push_back(wire::encode({"bench", 1, chunk_of(table, header, seq)}));
  const std::string channel = wire::channel("bench", wire::Lane::table);

  const Child child([&](int out, int in) {
    const auto bus = open_transport(url);
    Transport& link = *bus;
    link.subscribe(channel, 1'000'000);
    put(out, 0);
    double count = 0;
    Nanos last{};
    while (!got(in)) {
      while (link.receive(1ms)) {
        last = steady_now();
        ++count;
      }
    }
    put(out, count);
    put(out, seconds(last));
  });
  const auto bus = open_transport(url);
  Transport& link = *bus;
  static_cast<void>(child.number());
  const Nanos begin = steady_now();
  for (const auto& packet : packets) link.send(channel, packet);
  usleep(200'000);
  child.end();
  const double count = child.number();
  const double time = child.number() - seconds(begin);
  const double bytes = static_cast<double>(bytes_of(header)) / header.chunks;
  return {count * bytes / time, count / header.chunks};
}

/// The processor time of this process so far, s: all its threads, and the kernel for it.
double computed() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto of = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return of(usage.ru_utime) + of(usage.ru_stime);
}

struct Transfer {
  double complete = 0,
         released = 0;  // bytes of knots per second, until acknowledged, until released
  double resent = 0;    // share of the chunks
  double sending = 0, receiving = 0;  // s computed a chunk
};

Transfer transfer(const Table& table, bool hashed) {
  const Child child([&](int out, int in) {
    const auto bus = open_transport(url);
    Transport& link = *bus;
    ReceiverPump pump(link, {.executor = "bench"}, random_id());
    put(out, 0);
    const double before = computed();
    while (!got(in)) {
      pump.run(2ms);
      while (pump.receiver().take_event()) {
      }
    }
    put(out, computed() - before);
  });
  const auto bus = open_transport(url);
  Transport& link = *bus;
  static_cast<void>(child.number());
  StreamPlan plan{.executor = "bench", .tables = {{table, units}}, .goal = StreamGoal::download};
  const wire::Header header = header_of(plan.tables[0], 0);
  const auto bytes = static_cast<double>(bytes_of(header));
  if (hashed) plan.tables[0].hash = content_hash(table, units);
  Nanos complete{};
  StreamOptions options;
  options.progress = [&](const StreamProgress& progress) {
    if (complete == Nanos{} && progress.stage != StreamStage::downloading) complete = steady_now();
  };
  const double before = computed();
  const Nanos begin = steady_now();
  const StreamOutcome outcome = stream_tables(link, std::move(plan), options);
  const double released = seconds(steady_now() - begin);
  const double sending = computed() - before;
  child.end();
  const double receiving = child.number();
  if (!outcome.ok() || !outcome.downloaded) {
    std::printf("failed: %s\n", outcome.reason.c_str());
    std::exit(1);
  }
  const auto chunks = static_cast<double>(outcome.progress.chunks);
  return {.complete = bytes / seconds(complete - begin),
          .released = bytes / released,
          .resent = static_cast<double>(outcome.progress.resent) / chunks,
          .sending = sending / chunks,
          .receiving = receiving / chunks};
}

template <class Round>
double median(const std::vector<Round>& rounds, double Round::*member) {
  std::vector<double> values;
  for (const Round& round : rounds) values.push_back(round.*member);
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print(const char* label, double delivered, const std::vector<Transfer>& transfers) {
  const double rate = median(transfers, &Transfer::complete);
  std::printf(
      "  %s: %4.0f MB/s complete = %2.0f %%, %4.0f MB/s released, %.2f %% sent again; computed a "
      "chunk: sender %.0f us, receiver %.0f us\n",
      label, rate * 1e-6, 100 * rate / delivered, median(transfers, &Transfer::released) * 1e-6,
      100 * median(transfers, &Transfer::resent), 1e6 * median(transfers, &Transfer::sending),
      1e6 * median(transfers, &Transfer::receiving));
}

void run(const char* rule_name, const Table& table, int rounds) {
  std::vector<Blind> blinds;
  std::vector<Transfer> transfers, hashed;
  for (int i = 0; i < rounds; ++i) {
    blinds.push_back(blind(table));
    transfers.push_back(transfer(table, false));
    hashed.push_back(transfer(table, true));
  }
  const double delivered = median(blinds, &Blind::rate);
  std::printf("%s, %zu knots: blind %.0f MB/s delivered, %.0f %% of it\n", rule_name, table.size(),
              delivered * 1e-6, 100 * median(blinds, &Blind::share));
  print("transfer", delivered, transfers);
  print("its hash known before", delivered, hashed);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  // Large blocks go back to the kernel. Else a receiver would inherit with the fork what tables before
  // have left in the heap, and copy each page of it: a process of its own has nothing of the kind.
  mallopt(M_MMAP_THRESHOLD, 1 << 17);
  const std::size_t knots = count > 1 ? std::stoul(arguments[1]) : 1'000'000;
  const int rounds = count > 2 ? std::stoi(arguments[2]) : 7;
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite})
    run(name(rule), sine(knots, rule), rounds);
}
