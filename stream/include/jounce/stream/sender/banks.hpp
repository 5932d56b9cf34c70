// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "jounce/stream/receiver/static_queue.hpp"

namespace jounce {

/// The rows of a static queue with two banks. If the second bank has rows, it follows at the end of
/// the first one.
struct BankPlan {
  wire::Queue queue = {};              ///< the queue, see StaticQueue
  std::vector<wire::Row> first = {};   ///< rows of bank 0
  std::vector<wire::Row> second = {};  ///< rows of bank 1; may be empty
  std::string remark = {};             ///< remark for the user: what to consider; may be empty
};

/// Options of play_banks().
struct BankOptions {
  /// The goal: the start is accepted, the motion has begun, or the motion has ended.
  enum class Until { accepted, started, finished };
  /// `started`: the axis no longer waits for the event of the queue.
  Until until = Until::finished;
  /// Called ten times a second; may be empty.
  std::function<void(const wire::QueueAck&)> progress = {};
  /// Returns true to cancel: the motion is not started, or the axis is stopped. May be empty.
  std::function<bool()> cancelled = {};
};

/// Fills both banks, starts the motion, and waits for the goal. Uses the session of the client, and
/// does not release it.
///
///     Client client(link, "feeder");
///     const CallOutcome outcome = play_banks(client, plan);
///
/// Throws InputError like StaticQueue, and TransportError.
CallOutcome play_banks(Client& client, const BankPlan& plan, const BankOptions& options = {});

}  // namespace jounce
