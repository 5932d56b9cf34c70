// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/stream/message/queue.hpp"
#include "jounce/stream/sender/client.hpp"
#include "jounce/stream/sender/row_window.hpp"

namespace jounce {

/// A queue of two banks on an executor's axis, like Googol's static FIFOs: each bank is filled,
/// then played as a whole, `loops` times, and kept until it is cleared.
///
///     StaticQueue fifos(client, {.units = {"s", "mm"}, .mode = wire::QueueMode::static_});
///     fifos.open();
///     fifos.fill(0, catch_up), fifos.fill(1, cycle);   // rows; their x begins at 0 in each bank
///     fifos.arm(), fifos.start();                      // bank 0 plays
///     fifos.switch_over();                             // bank 1 follows at the end of bank 0
///     fifos.clear(0), fifos.fill(0, another);          // meanwhile
///     while (fifos.level()->progress == wire::Progress::running) ...   // keeps the session alive
///
/// Bank: 0 or 1. Each call returns once the executor has accepted or rejected it, like the client's
/// own calls. It belongs to the client's session: the queue ends with that session. Source: Googol,
/// GT_PtData, GT_PtSpace, GT_FollowSwitch, GT_FollowClear (static mode).
class StaticQueue {
 public:
  /// The client must outlive it. Throws InputError for an inconsistent or dynamic queue.
  StaticQueue(Client& client, wire::Queue queue);

  CallOutcome open();
  /// Appends all rows to the bank. `stalled`: the bank has no space for all of them, or the
  /// executor took none within the client's patience, although it answered.
  CallOutcome fill(std::uint8_t bank, const std::vector<wire::Row>& rows);
  CallOutcome arm(std::uint8_t bank = 0);
  CallOutcome start(std::int64_t tick = -1);
  /// Continues with the other bank at the end of the active one.
  CallOutcome switch_over();
  /// Clears a bank that does not play; its x begins at 0 again.
  CallOutcome clear(std::uint8_t bank);

  /// Present progress; nullopt: no answer. Keeps the session alive if called once per second.
  [[nodiscard]] std::optional<wire::QueueAck> level();

 private:
  [[nodiscard]] std::optional<wire::QueueAck> hear(Nanos until);
  [[nodiscard]] CallOutcome unanswered() const;

  Client& client_;
  wire::Queue queue_;
  std::array<RowWindow, 2> banks_;
};

}  // namespace jounce
