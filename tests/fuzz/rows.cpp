// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/pvt/segment_fifos.hpp"
#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/detail/row_sender.hpp"

#include "fuzz/packets.hpp"

namespace jounce::fuzz {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t length = 700;  // rows of the stream
const wire::Queue rows_queue{.units = {"s", "mm"}, .capacity = 64, .prefill = 30};

/// Row i of the stream.
wire::Row row(std::size_t i) {
  const auto n = static_cast<double>(i + 1);
  return {.x_end = 0.01 * n,
          .p_end = std::sin(n),
          .order = wire::RowOrder::linear,
          .last = i + 1 == length};
}

/// A stream of rows with every message lost, passed on or held back, and others' packets in
/// between. The stream arrives in order and each row once, and never exceeds the free space.
class RowConversation {
 public:
  RowConversation() : sender_(plan(), 1) {}

  void turn(Source& source) {
    now_ += source.below(16) == 0 ? Nanos(300ms) : Nanos(1ms);
    switch (source.below(8)) {
      case 0:
        hear(packet(source), source.below(4));
        break;
      case 1:
        if (source.below(8) == 0) sender_.stop(wire::StopMode::stop);
        break;
      case 2:
        play(source.below(40));
        break;
      default:
        pass(source);
    }
    while (const auto event = receiver_.take_event())
      std::visit([&](const auto& e) { take(e); }, *event);
  }

 private:
  RowPlan plan() {
    RowPlan plan{.executor = "feeder", .queue = rows_queue, .rows = {}};
    plan.rows = [this](std::size_t most) {
      std::vector<wire::Row> rows;
      for (; rows.size() < most && given_ < length; ++given_) rows.push_back(row(given_));
      return rows;
    };
    return plan;
  }
  /// A stranger, or a sender that has session and challenge and sends anything.
  void hear(const wire::Bytes& bytes, std::size_t knows) {
    auto decoded = wire::decode(bytes);
    auto* const message = std::get_if<wire::Message>(&decoded);
    if (message == nullptr) return;
    if (knows > 0) message->challenge = receiver_.challenge();
    impostor_ = impostor_ || knows > 0;
    receiver_.receive(*message, now_);
    sender_.receive(*message, now_);
  }
  void pass(Source& source) {
    for (const auto& message : sender_.poll(now_))
      if (source.below(4) != 0) receiver_.receive(message, now_);
    for (const auto& message : receiver_.poll(now_))
      if (source.below(4) != 0) sender_.receive(message, now_);
  }
  void play(std::size_t rows) {
    const std::size_t whole = std::min(arrived_, played_ + rows) / rows_queue.capacity;
    played_ = std::max(played_, whole * rows_queue.capacity);
    receiver_.level(rows_queue.queue, {.freed = {played_, 0},
                                       .played = static_cast<std::int64_t>(played_),
                                       .progress = wire::Progress::running});
  }

  void take(const QueueOpened& e) {
    if (e.queue.queue == rows_queue.queue) arrived_ = played_ = 0;
  }
  void take(const RowsArrived& e) {
    if (impostor_ || e.rows.queue != rows_queue.queue) return;
    require(e.rows.first_row == arrived_, "rows arrive in order, without gaps");
    for (const wire::Row& each : e.rows.rows)
      require(arrived_ < length && each == row(arrived_++), "a row is the one that was sent");
    require(arrived_ <= played_ + 2 * rows_queue.capacity, "no more rows than free places");
  }
  template <class Event>
  void take(const Event& e) {
    if constexpr (requires { e.command; }) receiver_.accept(e.session, e.command);
  }

  Nanos now_{};
  std::size_t given_ = 0, arrived_ = 0, played_ = 0;
  bool impostor_ = false;  // has sent under the session's name: then its rows count as well
  Receiver receiver_{
      {.executor = "feeder", .most_knots = 4000, .memory = 100'000, .most_rows = 4096}, 100};
  RowSender sender_;
};

/// Any rows at all, pushed into the FIFOs that play them. Every accepted row keeps the limits in
/// force at its acceptance.
class AnyRows {
 public:
  AnyRows() {
    fifos_.reset({.each = 16, .total = 32, .stream = false, .limits = {.velocity = 1000}});
  }
  void turn(Source& source) {
    const int bank = static_cast<int>(source.below(2));
    switch (source.below(8)) {
      case 0:
        if (!fifos_.moving()) x_ = 0, static_cast<void>(fifos_.start(bank, 0, 0));
        break;
      case 1:
        fifos_.queue_switch();
        break;
      case 2:
        fifos_.clear(bank);
        break;
      case 3:
        fifos_.set_loops(static_cast<std::int64_t>(source.below(4)));
        break;
      case 4:
      case 5:
        advance(value(source));
        break;
      default:
        push(bank, source);
    }
  }

 private:
  static double value(Source& source) {
    constexpr double special[] = {0, 1e-300, -1e300, 1e300, INFINITY, NAN, 0.5, -1};
    const std::size_t kind = source.below(4);
    if (kind == 0) return special[source.below(8)];
    return (source.byte() - 128.0) * (kind == 1 ? 1 : 1e-3);
  }
  void advance(double by) {
    if (std::isfinite(by)) x_ += std::abs(by);
    const Jet now = fifos_.at(x_);
    if (std::isfinite(x_))
      for (const double each : now) require(std::isfinite(each), "a setpoint is finite");
  }
  void push(int bank, Source& source) {
    constexpr int degrees[] = {1, 2, 3, 5};
    SegmentRow row{.degree = degrees[source.below(4)], .last = source.below(16) == 0};
    row.x_end = value(source);
    row.p_end = value(source);
    row.v_start = value(source);
    row.v_end = value(source);
    row.a_start = value(source);
    row.a_end = value(source);
    static_cast<void>(fifos_.push(bank, row));
  }

  SegmentFifos fifos_{16};
  double x_ = 0;
};

}  // namespace

void rows(Input input) {
  Source source(input);
  if (source.below(2) == 0) {
    RowConversation conversation;
    for (int i = 0; i < 400 && !source.empty(); ++i) conversation.turn(source);
  } else {
    AnyRows any;
    for (int i = 0; i < 400 && !source.empty(); ++i) any.turn(source);
  }
}

}  // namespace jounce::fuzz
