#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "jounce/executor/axis.hpp"
#include "jounce/executor/fifo_movement.hpp"
#include "jounce/stream/receiver.hpp"

namespace jounce {

/// The queues of rows that an axis's owner has opened (protocol page, "Queues"): what arrives goes
/// into the FIFOs of a movement, which the axis plays meanwhile, and what it has played makes room.
class Queues {
 public:
  /// Makes the movement, under this number, or refuses the queue.
  void open(const QueueOpened& opened, std::uint64_t id, const AxisConfig& config,
            Receiver& receiver);
  /// Hands rows over; one that breaks a rule is refused with it, and never played.
  void take(const RowsArrived& arrived, Receiver& receiver);
  /// What is armed; nothing where the queue is not open.
  [[nodiscard]] std::shared_ptr<Movement> movement(std::uint32_t queue) const;
  /// The bank that it begins with. Not while the axis has it.
  void choose(std::uint32_t queue, int bank) const;
  /// The axis no longer looks at it: what was not played to its end is cut off there.
  void handed_back(std::uint64_t movement) const;
  /// Says how far each has come.
  void report(const Tick& last, Receiver& receiver) const;

  bool queue_switch(std::uint32_t queue);
  bool clear(std::uint32_t queue, int bank);
  /// The owner is gone. What plays goes on with the rows that it has.
  void close() { open_.clear(); }

  /// Rows that wait in the one with this movement, and that it holds; 0, 0: there is none.
  [[nodiscard]] std::array<std::uint32_t, 2> fill(std::uint64_t movement) const;

 private:
  struct Open {
    wire::Queue queue;
    std::shared_ptr<Movement> movement;
    SegmentFifos* fifos = nullptr;
    std::function<void(int)> choose;
    std::array<std::uint64_t, 2> pushed{};
  };
  [[nodiscard]] const Open* find(std::uint32_t queue) const;
  [[nodiscard]] static wire::Progress progress(const Open& open, const Tick& last);
  [[nodiscard]] static std::uint64_t held(const Open& open, int bank);

  std::map<std::uint32_t, Open> open_;
};

/// As it stands on the wire.
wire::Progress on_wire(Progress progress);

}  // namespace jounce
