// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "jounce/pvt/segment_row.hpp"
#include "jounce/stream/sender/command_slot.hpp"
#include "jounce/stream/sender/farewell.hpp"
#include "jounce/stream/sender/row_window.hpp"
#include "jounce/stream/sender/sender.hpp"

namespace jounce {

/// Gives the next rows of a stream, at most so many: none if there are none yet. The last one of
/// all has `last` set.
using RowSource = std::function<std::vector<wire::Row>(std::size_t most)>;

/// A stream of rows: longer than any memory, or computed on the fly.
struct RowPlan {
  std::string executor;  ///< its name
  wire::Queue queue{};   ///< dynamic; over time in s, or over a master
  RowSource rows;
  std::int64_t start_tick = -1;  ///< start tick of the executor; -1: the next one
  bool resume = false;           ///< after an underrun, goes on once the prefill is there again
};

/// The rows of a table, from its first knot on: x and p count from there.
RowSource source_of(Table table);

/// A row as it stands on the wire.
wire::Row on_wire(const SegmentRow& row);

/// Range of a table, u, relative to its first knot, as a queue of its rows announces it.
struct Travel {
  double lowest = 0;   ///< <= 0
  double highest = 0;  ///< >= 0
  double net = 0;      ///< at its end
};
/// Exact: the rows' own extrema, as an executor computes them.
Travel travel_of(const Table& table);

/// Progress of a stream of rows.
struct RowProgress {
  std::uint64_t sent = 0;          ///< rows handed over by the source
  std::uint64_t acknowledged = 0;  ///< acknowledged of those, with the executor
  std::uint64_t played = 0;        ///< played of those, played to their end
  std::size_t messages = 0;        ///< messages of rows, sent for the first time
  std::size_t resent = 0;          ///< sent again
  int underruns = 0;               ///< times that the axis had to stop for want of rows
  bool started = false;
  bool all = false;       ///< the executor has the last row
  bool finished = false;  ///< and has played it
};

struct RowOutcome {
  StreamError error = StreamError::none;  ///< underrun, unless the plan resumes
  wire::Refusal refusal = wire::Refusal::none;
  std::int32_t cause = 0;  ///< the axis's own number where it refused
  std::string reason{};    ///< in words; may be empty
  RowProgress progress{};

  [[nodiscard]] bool ok() const { return error == StreamError::none; }
};

/// The streamer's half of a rolling stream: a pure state machine without thread, clock or link. It
/// opens the queue, fills it up to the prefill (or with all there is), arms, starts, and goes on
/// and continues as played rows free space, to the end of the motion.
///
///     RowSender sender({.executor = "feeder", .queue = queue, .rows = next_rows}, random_id());
///     while (!sender.ended()) {
///       for (const auto& message : sender.poll(now)) ...   // to be sent; calls every ms
///       sender.receive(message, now);                      // each arrived message
///     }
///
/// Where the source does not keep up, the axis stops on the path and within its limits before it
/// runs out of rows: an underrun. Then the stream ends with that error, or continues if the plan has
/// so. A source that has no more rows for `progress_patience`, though they are waited for, ends it,
/// too: `underrun` of what has started, `stalled` before. Where an operator has stopped the axis, or
/// a fault has, the stream ends as `stopped`, for every plan.
class RowSender {
 public:
  /// Throws InputError for a plan that cannot be sent.
  RowSender(RowPlan plan, std::int64_t session, SenderOptions options = {});

  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);
  void receive(const wire::Message& message, Nanos now);

  /// Stops the axis, and ends.
  void stop(wire::StopMode mode);
  void fail(StreamError error, std::string reason);

  [[nodiscard]] bool ended() const { return stage_ == Stage::ended; }
  /// It has ended, and a failed one has sent its farewell.
  [[nodiscard]] bool done() const { return ended() && farewell_.over(); }
  [[nodiscard]] const RowOutcome& outcome() const { return outcome_; }

 private:
  enum class Stage {
    opening,
    filling,
    arming,
    starting,
    playing,
    resetting,
    resuming,
    stopping,
    releasing,
    ended
  };

  void take(const wire::QueueAck& ack, std::int64_t challenge, Nanos now);
  void take(const wire::Reply& reply, std::int64_t challenge, Nanos now);
  template <class Other>
  void take(const Other& /*not for a streamer*/, std::int64_t /*challenge*/, Nanos /*now*/) {}

  [[nodiscard]] bool hear(std::int64_t boot, Nanos now);
  void fill(Nanos now);
  void go_on();
  void watch(const wire::QueueAck& ack);
  void enter(Stage stage, wire::Body command);
  void accepted();
  void refused(wire::Refusal refusal, const std::string& reason, std::int32_t cause);
  [[nodiscard]] bool may_move() const;
  void check_patience(Nanos now);
  void send(wire::Body body, Nanos now);
  [[nodiscard]] bool is_filled() const;
  [[nodiscard]] bool waits_for_rows() const;

  RowPlan plan_;
  std::int64_t session_;
  SenderOptions options_;
  RowOutcome outcome_;
  Stage stage_ = Stage::opening;
  RowWindow window_;
  CommandSlot command_;
  std::int64_t challenge_ = 0;
  std::int64_t boot_ = 0;   // 0: no message yet
  bool exhausted_ = false;  // the source has given its last row
  bool starving_ = false;
  std::uint64_t starved_at_ = 0;  // rows that were acknowledged then
  std::vector<wire::Message> outgoing_;
  bool begun_ = false;
  Farewell farewell_;
  Nanos heard_{}, asked_{}, progressed_{};
};

}  // namespace jounce
