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

/// Returns the next rows of a stream, at most `most`; empty: none available yet. The last row of
/// all has `last` set.
using RowSource = std::function<std::vector<wire::Row>(std::size_t most)>;

/// A stream of rows: longer than any memory, or computed on the fly.
struct RowPlan {
  std::string executor;  ///< its name
  wire::Queue queue{};   ///< dynamic; over time in s, or over a master
  RowSource rows;
  std::int64_t start_tick = -1;  ///< start tick of the executor; -1: the next one
  bool resume = false;           ///< after an underrun, continues once the prefill has arrived
};

/// The rows of a table, from its first knot on; x and p are relative to it.
RowSource source_of(Table table);

/// A row in its wire format.
wire::Row on_wire(const SegmentRow& row);

/// Range of a table, u, relative to its first knot, as a queue of its rows announces it.
struct Travel {
  double lowest = 0;   ///< <= 0
  double highest = 0;  ///< >= 0
  double net = 0;      ///< displacement at its end
};
/// Exact: the rows' own extrema, as an executor computes them.
Travel travel_of(const Table& table);

/// Progress of a stream of rows.
struct RowProgress {
  std::uint64_t sent = 0;          ///< rows taken from the source
  std::uint64_t acknowledged = 0;  ///< rows acknowledged by the executor
  std::uint64_t played = 0;        ///< rows played to their end
  std::size_t messages = 0;        ///< messages of rows, sent for the first time
  std::size_t resent = 0;          ///< sent again
  int underruns = 0;               ///< stops of the axis for lack of rows
  bool started = false;
  bool all = false;       ///< the executor has the last row
  bool finished = false;  ///< the executor has played the last row
};

/// Outcome of a rolling stream. An underrun is an error unless the plan resumes.
struct RowOutcome : CallOutcome {
  RowProgress progress{};
};

/// The streamer's half of a rolling stream: a pure state machine without thread, clock or link. It
/// opens the queue, fills it up to the prefill (or with all rows), arms, starts, and continues as
/// played rows free space, to the end of the motion.
///
///     RowSender sender({.executor = "feeder", .queue = queue, .rows = next_rows}, random_id());
///     while (!sender.ended()) {
///       for (const auto& message : sender.poll(now)) ...   // to be sent; calls every ms
///       sender.receive(message, now);                      // each arrived message
///     }
///
/// If the source is too slow, the axis stops on the path and within its limits before it runs out
/// of rows: an underrun. The stream then ends with that error, or continues if the plan resumes.
/// The stream also ends if it needs rows and the source has none for `progress_patience`:
/// `underrun` after the start, `stalled` before. If an operator or a fault has stopped the axis,
/// the stream ends as `stopped`, for every plan.
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
  /// True if it has ended, and a failed one has sent its farewell.
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
  bool exhausted_ = false;  // the source has returned its last row
  bool starving_ = false;
  std::uint64_t starved_at_ = 0;  // acknowledged rows at the underrun
  std::vector<wire::Message> outgoing_;
  bool begun_ = false;
  Farewell farewell_;
  Nanos heard_{}, asked_{}, progressed_{};
};

}  // namespace jounce
