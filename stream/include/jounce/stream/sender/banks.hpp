// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "jounce/stream/receiver/static_queue.hpp"

namespace jounce {

/// The rows of a static queue with two banks: the second, if it has rows, follows at the end of the first.
struct BankPlan {
  wire::Queue queue = {};
  std::vector<wire::Row> first = {};
  std::vector<wire::Row> second = {};
};

struct BankOptions {
  enum class Until { accepted, started, finished };
  Until until = Until::finished;  ///< started: the axis no longer waits for the event of the queue
  std::function<void(const wire::QueueAck&)> progress =
      {};  ///< called ten times a second; may be empty
  std::function<bool()> cancelled =
      {};  ///< true: starts nothing, or stops the axis, and ends; may be empty
};

/// Fills both banks, starts, and waits for the goal. It keeps the session of the client, so the
/// caller releases it.
///
///     Client client(link, "feeder");
///     const CallOutcome outcome = play_banks(client, plan);
///     client.release();
///
/// Throws InputError like StaticQueue, and TransportError.
CallOutcome play_banks(Client& client, const BankPlan& plan, const BankOptions& options = {});

}  // namespace jounce
