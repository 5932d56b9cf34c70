// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "jounce/executor/detail/dispatcher.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/cycle/virtual_pacer.hpp"
#include "fuzz/packets.hpp"
#include "stream/harness.hpp"
#include "stream/src/transport/memory_transport.hpp"

namespace jounce::fuzz {
namespace {

using namespace std::chrono_literals;

constexpr double fastest = 1000;  // u/s

/// A linear axis, and a second one behind its setpoint.
std::vector<ExecutorOptions> two_axes() {
  std::vector<ExecutorOptions> axes(2);
  for (auto& axis : axes) {
    axis.axis.limits.velocity = fastest;
    axis.axis.limits.acceleration = 1e5;
    axis.axis.limits.jerk = 1e8;
    axis.axis.limits.position_min = -1e4;
    axis.axis.limits.position_max = 1e4;
    axis.receiver.most_rows = 4096;
    axis.receiver.memory = 100'000;
    axis.adopt_start = true;
  }
  axes[0].receiver.executor = "feeder";
  axes[1].receiver.executor = "knife";
  axes[1].follow = {.what = Follow::What::setpoint, .index = 0};
  return axes;
}

/// An executor whose owner has session, challenge and numbers, and sends anything. For all
/// messages, every setpoint is finite, none is further from the one before than the limits allow,
/// and a disabled axis does not move.
class Owned {
 public:
  Owned() {
    for (const auto& axis : axes_) {
      link_.subscribe(wire::channel(axis.receiver.executor, wire::Lane::reply), 1000);
      link_.subscribe(wire::channel(axis.receiver.executor, wire::Lane::status), 1);
    }
  }

  void turn(Source& source) {
    axis_ = source.below(2);
    switch (source.below(8)) {
      case 0:
        return send(any(source));
      case 1:
        return table(source);
      case 2:
        return rows(source);
      case 3:
        return begin(source);
      case 4:
        return pass(static_cast<int>(source.below(64)));
      default:
        return order(source);
    }
  }

 private:
  struct Last {
    std::int64_t tick = -1;
    double position = 0;  // in the count of the drive
    State state = State::disabled;
  };

  // ---- what is sent -----------------------------------------------------------------------------

  static wire::Body any(Source& source) {
    const auto decoded = wire::decode(packet(source));
    const auto* const message = std::get_if<wire::Message>(&decoded);
    return message != nullptr ? message->body : wire::Body(wire::Heartbeat{});
  }
  static double value(Source& source) {
    constexpr double special[] = {0, 1, -1, 1e-300, 1e300, 1e9, 0.5, 64};
    const std::size_t kind = source.below(4);
    if (kind == 0) return special[source.below(8)];
    return (source.byte() - 128.0) * (kind == 1 ? 1 : 10);
  }
  void order(Source& source) {
    wire::Command order{.kind = sent_commands()[source.below(sent_commands().size())]->kind};
    order.value = values_of(command_of(order.kind));
    for (std::size_t i = 0; i < info(order.kind).fields.size(); ++i)
      if (source.below(2) != 0) order.value[i] = value(source);
    if (source.below(4) == 0) order.at = next_tick_ + static_cast<std::int64_t>(source.byte());
    if (order.kind == CommandKind::gear_in || order.kind == CommandKind::gear_in_pos)
      order.value[1] = 1 + static_cast<double>(source.below(3));
    if (order.kind == CommandKind::combine_axes) order.value[1] = order.value[3] = 1;
    send(order);
    pass(1 + static_cast<int>(source.below(16)));
  }
  void table(Source& source) {
    const bool time = source.below(2) == 0;
    const double reach = value(source);
    sent_ = std::make_shared<const Table>(
        time ? Domain::time : Domain::master, Interpolation::quintic_hermite,
        source.below(2) == 0 ? Extrapolation::hold : Extrapolation::wrap,
        Columns{{0, 0.3, 0.6}, {0, reach, 0}, {0, 0, 0}, {0, 0, 0}});
    for (const auto& message :
         test::messages_of(*sent_, 1, static_cast<std::uint32_t>(source.below(8))))
      if (source.below(8) != 0) send(message.body);
  }
  void rows(Source& source) {
    const auto queue = static_cast<std::uint32_t>(64 + source.below(3));
    const auto mode = source.below(2) == 0 ? wire::QueueMode::dynamic : wire::QueueMode::static_;
    const bool time = source.below(4) != 0;
    send(wire::Queue{.queue = queue,
                     .axis = time ? Domain::time : Domain::master,
                     .units = {time ? "s" : "mm", "mm"},
                     .mode = mode,
                     .capacity = 16,
                     .loops = mode == wire::QueueMode::dynamic ? 1 : 2,
                     .relative = source.below(4) != 0,
                     .lowest = source.below(4) != 0 ? -1e3 : -wire::Queue::no_bound,
                     .highest = source.below(4) != 0 ? 1e3 : wire::Queue::no_bound});
    wire::Rows rows{.queue = queue, .bank = static_cast<std::uint8_t>(source.below(2))};
    if (mode == wire::QueueMode::dynamic) rows.bank = 0;
    Filled& filled = filled_[{axis_, queue, rows.bank}];
    rows.seq = filled.seq;
    rows.first_row = filled.rows;
    constexpr wire::RowOrder orders[] = {wire::RowOrder::linear, wire::RowOrder::quadratic,
                                         wire::RowOrder::cubic, wire::RowOrder::quintic};
    for (std::size_t n = 1 + source.below(12); n > 0; --n) {
      wire::Row row{.order = orders[source.below(4)], .last = source.below(16) == 0};
      row.x_end = filled.x += 0.001 * (1 + static_cast<double>(source.below(64)));
      row.p_end = source.below(4) == 0 ? value(source) : static_cast<double>(source.below(8));
      if (source.below(4) == 0) row.v_end = value(source);
      if (source.below(8) == 0) row.a_end = value(source);
      rows.rows.push_back(row);
    }
    filled.seq += 1;
    filled.rows += rows.rows.size();
    send(rows);
    pass(1);
  }
  void begin(Source& source) {
    wire::Arm arm{.mode = static_cast<wire::ArmMode>(source.below(4))};
    if (arm.mode == wire::ArmMode::queue)
      arm.queue = static_cast<std::uint32_t>(64 + source.below(3));
    else if (sent_)
      arm.slave = content_hash(*sent_, test::move_units);
    if (source.below(2) == 0) arm.coupling.start = StartMode::relative;
    arm.coupling.slave_absolute = source.below(2) == 0;
    send(arm);
    pass(4);
    wire::Start start{.when = static_cast<StartAt>(source.below(3))};
    if (start.when == StartAt::master_position) start.position = value(source);
    send(start);
    pass(1 + static_cast<int>(source.below(64)));
  }
  void send(wire::Body body) {
    std::visit(
        [&](auto& each) {
          if constexpr (requires { each.command = 1; }) each.command = ++number_;
        },
        body);
    const std::string& name = axes_[axis_].receiver.executor;
    const wire::Message message{name, 1, std::move(body), challenge_[axis_]};
    wire::Bytes bytes;
    try {
      bytes = wire::encode(message);
    } catch (const InputError&) {
      return;
    }
    link_.send(wire::channel(name, wire::lane(message.body)), bytes);
  }

  // ---- what happens -----------------------------------------------------------------------------

  void pass(int cycles) {
    for (; cycles > 0; --cycles) {
      cycle_.once();
      dispatcher_.turn(0ns);
      while (const auto packet = link_.receive(0ns)) hear(packet->bytes);
      for (std::size_t i = 0; i < axes_.size(); ++i) watch(dispatcher_.last(i), last_[i]);
      ++next_tick_;
    }
  }
  void hear(std::span<const std::byte> bytes) {
    const auto decoded = wire::decode(bytes);
    const auto* const message = std::get_if<wire::Message>(&decoded);
    require(message != nullptr, "every message of an executor can be decoded");
    if (message->session == 0 && !std::holds_alternative<wire::Status>(message->body)) return;
    for (std::size_t i = 0; i < axes_.size(); ++i)
      if (message->executor == axes_[i].receiver.executor) challenge_[i] = message->challenge;
  }
  static void watch(const Tick& now, Last& last) {
    const double position = now.position - now.offset;
    require(std::isfinite(position) && std::isfinite(now.velocity), "a setpoint is finite");
    if (last.tick >= 0 && now.tick > last.tick) {
      const double rounding =
          1e-12 * (std::abs(now.position) + std::abs(now.offset) + std::abs(last.position));
      const double way = std::abs(position - last.position);
      const double most = fastest * 1e-3 * static_cast<double>(now.tick - last.tick);
      require(way <= most * (1 + 1e-6) + rounding, "no setpoint leaps");
      if (last.state == State::disabled && now.state == State::disabled)
        require(way <= rounding, "who is disabled does not move");
    }
    last = {now.tick, position, now.state};
  }

  struct Filled {
    std::uint32_t seq = 0;
    std::uint64_t rows = 0;
    double x = 0;
  };

  std::vector<ExecutorOptions> axes_ = two_axes();
  MemoryNetwork network_;
  MemoryTransport own_link_{network_};
  MemoryTransport link_{network_};
  test::VirtualPacer pacer_;
  Machine machine_{machine_of(axes_)};
  MachineExchange exchange_{2};
  Dispatcher dispatcher_{own_link_, axes_, exchange_, [this] { return Nanos(pacer_.now()); }};
  Cycle cycle_{machine_, pacer_, exchange_};
  std::array<Last, 2> last_;
  std::array<std::int64_t, 2> challenge_{};
  std::map<std::tuple<std::size_t, std::uint32_t, int>, Filled> filled_;
  std::shared_ptr<const Table> sent_;
  std::size_t axis_ = 0;
  std::int32_t number_ = 0;
  std::int64_t next_tick_ = 0;
};

}  // namespace

void executor(Input input) {
  Source source(input);
  Owned owned;
  for (int i = 0; i < 40 && !source.empty(); ++i) owned.turn(source);
}

}  // namespace jounce::fuzz
