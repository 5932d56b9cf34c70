// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/stream/message/queue.hpp"
#include "jounce/stream/sender/client.hpp"

namespace jounce {

class RowWindow;

/// A queue of two banks on an axis, like the static FIFOs of Googol. Each bank is filled, played as
/// a whole for `loops` passes, and kept until it is cleared.
///
///     StaticQueue fifos(client, {.units = {"s", "mm"}, .mode = wire::QueueMode::static_});
///     fifos.open();
///     fifos.fill(0, catch_up), fifos.fill(1, cycle);   // rows; their x begins at 0 in each bank
///     fifos.arm(), fifos.start();                      // bank 0 plays
///     fifos.switch_over();                             // bank 1 follows at the end of bank 0
///     fifos.clear(0), fifos.fill(0, another);          // meanwhile
///     while (fifos.level()->progress == wire::Progress::running) ...   // keeps the session alive
///
/// `bank` is 0 or 1. Like the calls of Client, each call returns when the executor has accepted or
/// rejected it. The queue belongs to the session of the client, and ends with this session. Source:
/// GT_PtData, GT_PtSpace, GT_FollowSwitch, GT_FollowClear of Googol (static mode).
class StaticQueue {
 public:
  /// `client` must outlive the queue. Throws InputError for an inconsistent or a dynamic queue.
  StaticQueue(Client& client, wire::Queue queue);
  ~StaticQueue();
  StaticQueue(const StaticQueue&) = delete;
  StaticQueue& operator=(const StaticQueue&) = delete;

  /// Opens the queue.
  CallOutcome open();
  /// Appends rows to a bank. The outcome is `stalled` if the bank has no space for all rows, or if
  /// the executor answers but accepts no row within ClientOptions::patience; some of the rows may
  /// then be in the bank.
  CallOutcome fill(std::uint8_t bank, const std::vector<wire::Row>& rows);
  /// Arms the queue. The motion will begin with `bank`.
  CallOutcome arm(std::uint8_t bank = 0);
  /// Starts the motion. `tick`: tick of the executor; -1: the next one.
  CallOutcome start(std::int64_t tick = -1);
  /// Continues with the other bank at the end of the present one.
  CallOutcome switch_over();
  /// Empties a bank that is not being played. In the next rows of the bank, x begins at 0 again.
  CallOutcome clear(std::uint8_t bank);

  /// Returns the present progress; nullopt: no answer. Each call keeps the session alive; the next
  /// one must follow within the executor's timeout, by default 1 s.
  [[nodiscard]] std::optional<wire::QueueAck> level();

 private:
  [[nodiscard]] std::optional<wire::QueueAck> receive(Nanos until);
  [[nodiscard]] CallOutcome unanswered() const;

  Client& client_;
  wire::Queue queue_;
  std::vector<RowWindow> banks_;  // two
};

}  // namespace jounce
