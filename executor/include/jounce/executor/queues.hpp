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

#include "jounce/axis/axis.hpp"
#include "jounce/axis/fifo_movement.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

/// A change of the FIFOs of a queue, with a number for its axis: the axis sees it in ticks with
/// Inputs::rows at or above this number.
struct HandedOver {
  static constexpr std::size_t most_rows = 32;
  enum class Kind : std::uint8_t {
    rows,
    queue_switch,  ///< the other bank continues
    clear,         ///< empties the bank
    begin,         ///< the queue is armed, and this bank begins
    end,           ///< no more rows follow
  };
  std::uint64_t movement = 0;
  std::uint64_t number = 0;
  Kind kind = Kind::rows;
  int bank = 0;
  std::vector<SegmentRow> rows = {};  ///< at most `most_rows`
};

/// The movement of a queue, with the FIFOs for its rows.
class QueueMovement {
 public:
  /// Throws InputError for an invalid queue.
  QueueMovement(const wire::Queue& queue, std::uint64_t id, const AxisConfig& config);

  [[nodiscard]] const std::shared_ptr<Movement>& movement() const { return movement_; }
  [[nodiscard]] SegmentFifos& fifos() const { return *fifos_; }
  void choose(int bank) const { choose_(bank); }
  /// Repeats a recorded change; returns false if it is not accepted now.
  [[nodiscard]] bool take(const HandedOver& what) const;

 private:
  std::shared_ptr<Movement> movement_;
  SegmentFifos* fifos_ = nullptr;
  std::function<void(int)> choose_;
};

/// The queues of rows that an axis's owner has opened (protocol page, "Queues"). Arriving rows go
/// into the FIFOs of a movement, which the axis plays at the same time; played rows free their
/// space.
///
/// Every change has a number, and the axis sees it completely from the next tick on. Its motion
/// depends only on the changes and the numbers in its ticks, so a replay of a record of both is
/// identical to the last bit.
class Queues {
 public:
  using Record = std::function<void(const HandedOver&)>;

  /// `last`: the last number, read by the cycle; must outlive this. `record` is called before it is
  /// set.
  explicit Queues(std::atomic<std::uint64_t>& last, Record record = {})
      : last_(last), record_(std::move(record)) {}

  /// Creates the movement, with this id, or rejects the queue and returns false.
  bool open(const QueueOpened& opened, std::uint64_t id, const AxisConfig& config,
            Receiver& receiver);
  /// Passes rows on; rejects a row that violates a rule, which is then never played.
  void take(const RowsArrived& arrived, Receiver& receiver);
  /// The armed movement; null if the queue is not open.
  [[nodiscard]] std::shared_ptr<Movement> movement(std::uint32_t queue) const;
  /// u, required position of the axis; nullopt if rows are relative to the position of the axis.
  [[nodiscard]] std::optional<double> origin(std::uint32_t queue) const;
  /// Selects the bank that it begins with. Not while the axis has it.
  void begin_with(std::uint32_t queue, int bank);
  /// The axis no longer reads it: cuts off rows that were not played to their end.
  void handed_back(std::uint64_t movement) const;
  /// Reports the progress of each.
  void report(const Tick& last, Receiver& receiver) const;

  bool queue_switch(std::uint32_t queue);
  bool clear(std::uint32_t queue, int bank);
  /// Marks the stream as complete; returns false if it has no rows, or does not end at rest.
  bool end(std::uint32_t queue);
  /// The session has ended. The active queue continues with its rows.
  void close() { open_.clear(); }

  /// Waiting rows and capacity of the queue with this movement; 0, 0: none.
  [[nodiscard]] std::array<std::uint32_t, 2> fill(std::uint64_t movement) const;

 private:
  struct Open {
    wire::Queue queue;
    QueueMovement made;
    std::array<std::uint64_t, 2> pushed{};
  };
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

/// Converts to the enumeration of the wire.
wire::Progress on_wire(Progress progress);

}  // namespace jounce
