// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/axis/fifo_movement.hpp"
#include "jounce/axis/tick.hpp"
#include "jounce/stream/detail/receiver.hpp"

namespace jounce {

/// A change of the FIFOs of a queue. Each change has a number: the change is visible to the axis in
/// all ticks in which Inputs::rows is at least this number.
struct HandedOver {
  static constexpr std::size_t most_rows = 32;  ///< greatest number of rows in one change
  /// Kind of a change.
  enum class Kind : std::uint8_t {
    rows,          ///< adds rows
    queue_switch,  ///< continues with the other bank
    clear,         ///< empties the bank
    begin,         ///< the queue is armed and will begin with this bank
    end,           ///< ends the stream: no more rows follow
  };
  std::uint64_t movement = 0;         ///< id of the movement of the queue
  std::uint64_t number = 0;           ///< number of the change
  Kind kind = Kind::rows;             ///< kind of the change
  int bank = 0;                       ///< bank that changes, 0 or 1
  std::vector<SegmentRow> rows = {};  ///< added rows, at most `most_rows`
};

/// The movement of a queue, with the FIFOs for its rows.
class QueueMovement {
 public:
  /// Throws InputError for an invalid queue. `id`: id of the movement.
  QueueMovement(const wire::Queue& queue, std::uint64_t id, const AxisConfig& config);

  /// The movement.
  [[nodiscard]] const std::shared_ptr<Movement>& movement() const { return movement_; }
  /// Its FIFOs.
  [[nodiscard]] SegmentFifos& fifos() const { return *fifos_; }
  /// Selects the bank with which the movement begins.
  void choose(int bank) const { choose_(bank); }
  /// Applies a change to the FIFOs: a new change, or a change of a record. Returns false if the
  /// FIFOs do not accept it.
  [[nodiscard]] bool take(const HandedOver& what) const;

 private:
  std::shared_ptr<Movement> movement_;
  SegmentFifos* fifos_ = nullptr;
  std::function<void(int)> choose_;
};

/// The queues of rows that the owner of an axis has opened (see "Queues" in
/// docs/stream-protocol.md). The executor puts the rows that arrive into the FIFOs of a movement,
/// before and while the axis plays the movement. A row frees its space after it was played.
///
/// Each change of the FIFOs has a number, and the whole change is visible to the axis from the next
/// tick on. So the motion depends only on the changes and on Inputs::rows of each tick. A replay of
/// a record that contains both is identical to the last bit.
class Queues {
 public:
  /// Receives each change for the record.
  using Record = std::function<void(const HandedOver&)>;

  /// `last` receives the number of the last change, which the cyclic thread reads; it must outlive
  /// the queues. `record` is called before `last` is set.
  explicit Queues(std::atomic<std::uint64_t>& last, Record record = {})
      : last_(last), record_(std::move(record)) {}

  /// Opens a queue: makes its movement with this id. Returns false if the queue is rejected.
  bool open(const QueueOpened& opened, std::uint64_t id, const AxisConfig& config,
            Receiver& receiver);
  /// Adds the rows that have arrived. The first row that breaks a rule is rejected, and the rows
  /// after it in the message are dropped. Ignores rows for a queue that is not open.
  void take(const RowsArrived& arrived, Receiver& receiver);
  /// Returns the movement of a queue; null if the queue is not open.
  [[nodiscard]] std::shared_ptr<Movement> movement(std::uint32_t queue) const;
  /// Returns the position at which the axis must stand at the start, u (unit of the axis); nullopt
  /// if rows are relative to the position of the axis, or if the queue is not open.
  [[nodiscard]] std::optional<double> origin(std::uint32_t queue) const;
  /// Selects the bank with which a queue begins. Requires that the movement of the queue is neither
  /// armed nor played. Ignored if the queue is not open.
  void begin_with(std::uint32_t queue, int bank);
  /// Drops the rows of this movement that were not played. Call when the axis no longer reads the
  /// movement.
  void handed_back(std::uint64_t movement) const;
  /// Sends the progress of each queue.
  void report(const Tick& last, Receiver& receiver) const;

  /// Continues with the other bank at the end of the pass. Returns false if that is not possible.
  bool queue_switch(std::uint32_t queue);
  /// Empties a bank. Returns false if that is not possible.
  bool clear(std::uint32_t queue, int bank);
  /// Marks a stream as complete. Returns false if it has no rows, or does not end at rest.
  bool end(std::uint32_t queue);
  /// Closes all queues. Call when their session has ended. A queue that is being played continues
  /// with its rows.
  void close() { open_.clear(); }

  /// Returns, for the queue with this movement, the number of rows that wait in both banks and the
  /// capacity of both banks together; 0, 0 if no open queue has the movement.
  [[nodiscard]] std::array<std::uint32_t, 2> fill(std::uint64_t movement) const;

 private:
  struct Open {
    wire::Queue queue = {};
    QueueMovement made;
    std::array<std::uint64_t, 2> pushed{};
    RowLimits limits = {};  // for rows of a stream over time
    RowStart end = {};      // end of its last row
    double rate = 0;        // and the rate there, u/s
  };
  /// The reason why a row is rejected, for a stream over time with its numbers.
  [[nodiscard]] static std::string refusal_of(const Open& open, const SegmentRow& row,
                                              RowRule rule);
  [[nodiscard]] const Open* find(std::uint32_t queue) const;
  [[nodiscard]] static wire::Progress progress(const Open& open, const Tick& last);
  [[nodiscard]] static std::uint64_t held(const Open& open, int bank);

  bool act(std::uint32_t queue, HandedOver::Kind kind, int bank);
  void hand_over(HandedOver what);

  std::map<std::uint32_t, Open> open_;
  std::uint64_t number_ = 0;
  std::atomic<std::uint64_t>& last_;
  Record record_;
};

/// Converts a progress to the enumeration of the wire format.
wire::Progress on_wire(Progress progress);

}  // namespace jounce
