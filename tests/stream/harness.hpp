// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/detail/receiver_pump.hpp"
#include "jounce/stream/detail/table_store.hpp"
#include "jounce/stream/receiver/receiver_options.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "stream/src/transport/lossy_transport.hpp"
#include "stream/src/transport/memory_transport.hpp"

namespace jounce::test {

using namespace std::chrono_literals;

inline const Units move_units{"s", "mm"};
inline const Units cam_units{"deg", "mm"};

/// One sine over the knots, with exact derivatives by x; neighbours are 1 ms (or 1 unit) apart.
inline Table sine_table(std::size_t knots, Interpolation rule = Interpolation::cubic_hermite,
                        Domain axis = Domain::time, double amplitude = 10) {
  const double step = axis == Domain::time ? 1e-3 : 1;
  const double omega = 6.283185307179586 / (step * static_cast<double>(knots - 1));
  Columns columns;
  for (std::size_t i = 0; i < knots; ++i) {
    const double x = step * static_cast<double>(i);
    columns.x.push_back(x);
    columns.p.push_back(amplitude * std::sin(omega * x));
    if (rule != Interpolation::linear) columns.v.push_back(amplitude * omega * std::cos(omega * x));
    if (rule == Interpolation::quintic_hermite)
      columns.a.push_back(-amplitude * omega * omega * std::sin(omega * x));
  }
  return Table(axis, rule, Extrapolation::wrap, std::move(columns));
}

inline bool same(const Table& a, const Table& b) {
  return a.axis() == b.axis() && a.rule() == b.rule() && a.outside() == b.outside() &&
         a.columns().x == b.columns().x && a.columns().p == b.columns().p &&
         a.columns().v == b.columns().v && a.columns().a == b.columns().a;
}

inline StreamPlan plan_of(Table table, StreamGoal goal = StreamGoal::start) {
  return {.executor = "feeder", .tables = {{std::move(table), move_units}}, .goal = goal};
}

/// The header and the chunks of a table, as a sender would send them.
inline std::vector<wire::Message> messages_of(const Table& table, std::int64_t session,
                                              std::uint32_t index = 0) {
  const auto knots = static_cast<std::uint32_t>(table.size());
  const wire::Cut cut = wire::cut(table.rule(), knots);
  std::vector<wire::Message> messages;
  messages.push_back({"feeder", session,
                      wire::Header{.table = index,
                                   .hash = content_hash(table, move_units),
                                   .axis = table.axis(),
                                   .rule = table.rule(),
                                   .outside = table.outside(),
                                   .units = move_units,
                                   .knots = knots,
                                   .columns = cut.columns,
                                   .per_chunk = cut.per_chunk,
                                   .chunks = cut.chunks}});
  const auto& [x, p, v, a] = table.columns();
  for (std::uint32_t seq = 0; seq < cut.chunks; ++seq) {
    wire::Chunk chunk{.table = index,
                      .seq = seq,
                      .first_knot = seq * cut.per_chunk,
                      .knots = cut.knots_of(seq, knots),
                      .columns = cut.columns};
    for (const auto* column : {&x, &p, &v, &a})
      for (std::uint32_t i = 0; i < chunk.knots && !column->empty(); ++i)
        chunk.values.push_back((*column)[chunk.first_knot + i]);
    messages.push_back({"feeder", session, chunk});
  }
  return messages;
}

/// An event in one word, with its session: "ready 1", "arm 1", "start 1", "stop 1", "abort 1",
/// "released 1", "silent 1", "operator 1", "arm queue 1", "queue 1", "rows 1", "hold 1", ...
inline std::string word(const StreamEvent& event) {
  const auto session = std::to_string(std::visit([](const auto& e) { return e.session; }, event));
  if (std::holds_alternative<TableReady>(event)) return "ready " + session;
  if (std::holds_alternative<ArmRequested>(event)) return "arm " + session;
  if (std::holds_alternative<StartRequested>(event)) return "start " + session;
  if (const auto* stop = std::get_if<StopRequested>(&event))
    return (stop->mode == wire::StopMode::abort ? "abort " : "stop ") + session;
  if (std::holds_alternative<QueueArmRequested>(event)) return "arm queue " + session;
  if (std::holds_alternative<QueueOpened>(event)) return "queue " + session;
  if (std::holds_alternative<RowsArrived>(event)) return "rows " + session;
  if (const auto* order = std::get_if<CommandRequested>(&event))
    return std::string(name(kind_of(order->what))) + " " + session;
  switch (std::get<SessionEnded>(event).why) {
    case SessionEnded::Why::released:
      return "released " + session;
    case SessionEnded::Why::silent:
      return "silent " + session;
    case SessionEnded::Why::operator_stop:
      break;
  }
  return "operator " + session;
}

/// An executor on a link, whose axis obeys at once by default.
class Executor {
 public:
  Executor(Transport& link, const Clock& clock, std::int64_t boot, ReceiverOptions options = {})
      : pump(link, named(std::move(options)), boot, clock) {}

  void turn() {
    pump.run(Nanos{});
    while (const auto event = pump.receiver().take_event()) {
      log.push_back(word(*event));
      std::visit([&](const auto& e) { answer(e); }, *event);
    }
  }

  ReceiverPump pump;
  std::vector<std::string> log;
  std::vector<wire::Row> rows;         ///< that arrived, of all queues
  std::vector<StartRequested> starts;  ///< that were asked for
  bool queue_armed = false, queue_started = false;
  bool answers = true;    ///< otherwise it leaves commands without an outcome
  std::string objection;  ///< rejection of an arm or an order by the axis; empty: accepted

 private:
  static ReceiverOptions named(ReceiverOptions options) {
    options.executor = "feeder";
    return options;
  }
  void answer(const ArmRequested& e) {
    if (!answers) return;
    if (objection.empty())
      pump.receiver().accept(e.session, e.command);
    else
      pump.receiver().refuse(e.session, e.command, objection, 41);
  }
  void answer(const StartRequested& e) {
    queue_started |= queue_armed;
    starts.push_back(e);
    if (answers) pump.receiver().accept(e.session, e.command);
  }
  void answer(const StopRequested& e) {
    if (answers) pump.receiver().accept(e.session, e.command);
  }
  void answer(const QueueArmRequested& e) {
    queue_armed = true;
    if (answers) pump.receiver().accept(e.session, e.command);
  }
  void answer(const CommandRequested& e) {
    if (!answers) return;
    if (objection.empty())
      pump.receiver().accept(e.session, e.command);
    else
      pump.receiver().refuse(e.session, e.command, objection, 41);
  }
  void answer(const QueueOpened& /*e*/) {}
  void answer(const RowsArrived& e) {
    rows.insert(rows.end(), e.rows.rows.begin(), e.rows.rows.end());
  }
  void answer(const TableReady& /*e*/) {}
  void answer(const SessionEnded& /*e*/) {}
};

/// One streamer's link and one executor, on a network of memory in virtual time: wherever the
/// streamer would wait, at most a millisecond passes and the executor has its turn.
class World {
 public:
  explicit World(ReceiverOptions options = {}) : options_(std::move(options)) {
    boot(100);
    network.on_wait = [this](Nanos longest) {
      now += std::min<Nanos>(longest, 1ms);
      if (executor) executor->turn();
      if (each_turn) each_turn();
    };
  }

  /// A new executor without memory, as after a restart.
  void boot(std::int64_t number) {
    executor.reset();
    executor_link = std::make_unique<MemoryTransport>(network);
    executor = std::make_unique<Executor>(*executor_link, clock, number, options_);
  }

  void shut_down() {
    executor.reset();
    executor_link.reset();
  }

  /// Lets time pass, and the executor have its turns.
  void pass(Nanos time) {
    for (const Nanos end = now + time; now < end;) network.on_wait(1ms);
  }

  [[nodiscard]] const TableStore& store() const { return executor->pump.receiver().store(); }

  StreamOutcome stream(StreamPlan plan, std::int64_t session = 1,
                       const StreamOptions& options = {}) {
    return stream_tables(link, std::move(plan), options, clock, session);
  }

  Nanos now{};
  Clock clock = [this] { return now; };
  MemoryNetwork network;
  MemoryTransport link{network};
  std::unique_ptr<MemoryTransport> executor_link;
  std::unique_ptr<Executor> executor;
  std::function<void()> each_turn;

 private:
  ReceiverOptions options_;
};

}  // namespace jounce::test
