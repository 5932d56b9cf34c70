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

/// A change of the FIFOs of a queue, with a number of its axis: the axis sees
/// it in the ticks whose Inputs::rows is not less.
struct HandedOver {
  static constexpr std::size_t most_rows = 32;
  enum class Kind : std::uint8_t {
    rows,
    queue_switch,  ///< the other bank goes on
    clear,         ///< empties the bank
    begin,         ///< it is armed, and this bank begins
    end,           ///< no more rows follow
  };
  std::uint64_t movement = 0;
  std::uint64_t number = 0;
  Kind kind = Kind::rows;
  int bank = 0;
  std::vector<SegmentRow> rows = {};  ///< at most `most_rows`
};

/// The movement of a queue, and what its rows go into.
class QueueMovement {
 public:
  /// Throws InputError for what makes no queue.
  QueueMovement(const wire::Queue& queue, std::uint64_t id, const AxisConfig& config);

  [[nodiscard]] const std::shared_ptr<Movement>& movement() const { return movement_; }
  [[nodiscard]] SegmentFifos& fifos() const { return *fifos_; }
  void choose(int bank) const { choose_(bank); }
  /// Again what was handed over once; false where it is not taken now.
  [[nodiscard]] bool take(const HandedOver& what) const;

 private:
  std::shared_ptr<Movement> movement_;
  SegmentFifos* fifos_ = nullptr;
  std::function<void(int)> choose_;
};

/// The queues of rows that an axis's owner has opened (protocol page, "Queues"): what arrives goes
/// into the FIFOs of a movement, which the axis plays at the same time; played rows free their space.
///
/// All that is handed over has a number, and the axis sees it from the next tick on, whole: what it
/// plays depends on the numbers in its ticks alone, and a record of both is replayed to the last bit.
class Queues {
 public:
  using Record = std::function<void(const HandedOver&)>;

  /// `last`: of the numbers, as the cycle reads it; must outlive this. `record` is called before that.
  explicit Queues(std::atomic<std::uint64_t>& last, Record record = {})
      : last_(last), record_(std::move(record)) {}

  /// Makes the movement, under this number, or refuses the queue: false.
  bool open(const QueueOpened& opened, std::uint64_t id, const AxisConfig& config,
            Receiver& receiver);
  /// Hands rows over; one that breaks a rule is refused with it, and never played.
  void take(const RowsArrived& arrived, Receiver& receiver);
  /// The armed movement; nothing if the queue is not open.
  [[nodiscard]] std::shared_ptr<Movement> movement(std::uint32_t queue) const;
  /// u, where the axis must stand for it; nothing where its rows count from where the axis stands.
  [[nodiscard]] std::optional<double> origin(std::uint32_t queue) const;
  /// The bank that it begins with. Not while the axis has it.
  void begin_with(std::uint32_t queue, int bank);
  /// The axis no longer looks at it: what was not played to its end is cut off there.
  void handed_back(std::uint64_t movement) const;
  /// Reports the progress of each.
  void report(const Tick& last, Receiver& receiver) const;

  bool queue_switch(std::uint32_t queue);
  bool clear(std::uint32_t queue, int bank);
  /// The stream is complete: false where it has no rows, or does not end at rest.
  bool end(std::uint32_t queue);
  /// The owner is gone. The playing queue continues with its rows.
  void close() { open_.clear(); }

  /// Rows that wait in the one with this movement, and that it holds; 0, 0: there is none.
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

/// The definition on the wire.
wire::Progress on_wire(Progress progress);

}  // namespace jounce
