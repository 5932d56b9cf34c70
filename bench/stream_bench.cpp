// What a transfer costs, beside a sender that takes no care: over UDP multicast, two processes, the
// default socket buffer. To be run in a network namespace of its own: scripts/stream_speed.
//
//     bench_stream [KNOTS [ROUNDS]]
//
// Blind: the same messages, encoded beforehand, are published one after the other; the receiver only
// counts. Its rate is what arrived, by the time between the first and the last arrival.
// Transfer: stream_tables() from call to return, which has hashed, sent, confirmed and released; the
// receiver has decoded, hashed and constructed the table. Bytes of knots by that time.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jounce/stream/assembly.hpp"
#include "jounce/stream/driver.hpp"
#include "jounce/stream/lcm_transport.hpp"
#include "jounce/stream/stream_plan.hpp"

namespace {

using namespace jounce;
using namespace std::chrono_literals;

constexpr const char* url = "udpm://239.255.76.67:7667?ttl=0";
const Units units{"s", "mm"};

double seconds(Nanos time) {
  return std::chrono::duration<double>(time).count();
}

Table sine(std::size_t knots, Rule rule) {
  Columns columns;
  for (std::size_t i = 0; i < knots; ++i) {
    const double t = 1e-3 * static_cast<double>(i);
    columns.x.push_back(t);
    columns.p.push_back(std::sin(t));
    if (rule != Rule::linear) columns.v.push_back(std::cos(t));
    if (rule == Rule::quintic_hermite) columns.a.push_back(-std::sin(t));
  }
  return Table(Axis::time, rule, Outside::hold, std::move(columns));
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

void tell(int to, double value) {
  if (write(to, &value, sizeof value) != sizeof value) std::abort();
}

bool told(int from) {
  pollfd descriptor{from, POLLIN, 0};
  return poll(&descriptor, 1, 0) == 1;
}

struct Blind {
  double rate = 0;  // bytes of knots per second that arrived
  double share = 0;
};

Blind blind(const Table& table) {
  const StreamPlan::Item item{table, units};
  const wire::Header header = header_of(item, 0);
  std::vector<wire::Bytes> packets;
  for (std::uint32_t seq = 0; seq < header.chunks; ++seq)
    packets.push_back(wire::encode({"bench", 1, chunk_of(table, header, seq)}));
  const std::string channel = wire::channel("bench", wire::Lane::table);

  const Child child([&](int out, int in) {
    LcmTransport link(url);
    link.subscribe(channel, 1'000'000);
    tell(out, 0);
    double count = 0;
    Nanos first{}, last{};
    while (!told(in)) {
      while (link.receive(1ms)) {
        last = steady_now();
        if (count++ == 0) first = last;
      }
    }
    tell(out, count);
    tell(out, seconds(last - first));
  });
  LcmTransport link(url);
  static_cast<void>(child.number());
  for (const auto& packet : packets) link.send(channel, packet);
  usleep(200'000);
  child.end();
  const double count = child.number();
  const double time = child.number();
  const double bytes = static_cast<double>(bytes_of(header)) / header.chunks;
  return {count * bytes / time, count / header.chunks};
}

struct Transfer {
  double rate = 0;
  double resent = 0;  // share of the chunks
};

Transfer transfer(const Table& table) {
  const Child child([&](int out, int in) {
    LcmTransport link(url);
    ReceiverPump pump(link, {.executor = "bench"}, random_id());
    tell(out, 0);
    while (!told(in)) {
      pump.run(2ms);
      while (pump.receiver().take_event()) {
      }
    }
  });
  LcmTransport link(url);
  static_cast<void>(child.number());
  const StreamPlan plan{
      .executor = "bench", .tables = {{table, units}}, .goal = StreamGoal::download};
  const double bytes = static_cast<double>(bytes_of(header_of(plan.tables[0], 0)));
  const Nanos begin = steady_now();
  const StreamOutcome outcome = stream_tables(link, plan);
  const double time = seconds(steady_now() - begin);
  child.end();
  if (!outcome.ok() || !outcome.downloaded) {
    std::printf("failed: %s\n", outcome.reason.c_str());
    std::exit(1);
  }
  return {bytes / time, static_cast<double>(outcome.progress.resent) /
                            static_cast<double>(outcome.progress.chunks)};
}

template <class Round>
double median(const std::vector<Round>& rounds, double Round::*member) {
  std::vector<double> values;
  for (const Round& round : rounds) values.push_back(round.*member);
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void run(const char* rule_name, const Table& table, int rounds) {
  std::vector<Blind> blinds;
  std::vector<Transfer> transfers;
  for (int i = 0; i < rounds; ++i) {
    blinds.push_back(blind(table));
    transfers.push_back(transfer(table));
  }
  const double delivered = median(blinds, &Blind::rate);
  const double rate = median(transfers, &Transfer::rate);
  std::printf(
      "%-16s %8zu knots: blind %5.0f MB/s delivered (%3.0f %% of it), transfer %5.0f MB/s "
      "= %3.0f %%, all of it, %.2f %% sent again\n",
      rule_name, table.size(), delivered * 1e-6, 100 * median(blinds, &Blind::share), rate * 1e-6,
      100 * rate / delivered, 100 * median(transfers, &Transfer::resent));
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  const std::size_t knots = count > 1 ? std::stoul(arguments[1]) : 1'000'000;
  const int rounds = count > 2 ? std::stoi(arguments[2]) : 7;
  for (const Rule rule : {Rule::linear, Rule::cubic_hermite, Rule::quintic_hermite})
    run(name(rule), sine(knots, rule), rounds);
}
