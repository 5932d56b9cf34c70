// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/sender/row_plan.hpp"
#include "jounce/stream/sender/stream_outcome.hpp"
#include "jounce/stream/sender/stream_plan.hpp"
#include "jounce/stream/transport/link.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Options of stream_tables().
struct StreamOptions {
  SenderOptions sender = {};                    ///< times of the streamer
  Nanos total = std::chrono::seconds(60);       ///< time limit of the whole call
  Nanos period = std::chrono::milliseconds(1);  ///< longest wait for messages
  std::function<void(const StreamProgress&)> progress =
      {};  ///< called in each iteration; may be empty
  /// Returns true to cancel: the armed motion is stopped, and the call ends. May be empty.
  std::function<bool()> cancelled = {};
  std::optional<wire::Key> key{};  ///< key of the executor; nullopt: none
};

/// Sends the tables and reaches the goal of the plan, then releases the session; a motion continues. Returns
/// within options.total, in any state of the link, plus the time of a few last messages that free the axis.
/// Throws InputError for a plan that cannot be sent or armed, and TransportError. If a function of the options
/// throws, the motion is stopped as if `cancelled` returned true, and the exception is rethrown.
StreamOutcome stream_tables(Transport& link, StreamPlan plan, const StreamOptions& options = {},
                            const Clock& clock = steady_now, std::int64_t session = random_id());

/// Options of stream_rows().
struct RowOptions {
  SenderOptions sender = {};                    ///< times of the streamer
  Nanos period = std::chrono::milliseconds(1);  ///< longest wait for messages
  std::function<void(const RowProgress&)> progress =
      {};  ///< called in each iteration; may be empty
  /// Returns true to cancel: the axis is stopped, and the call ends. May be empty.
  std::function<bool()> cancelled = {};
  std::optional<wire::Key> key{};  ///< key of the executor; nullopt: none
};

/// Sends the rows and waits for the end of the motion, without a time limit. Returns earlier after an error.
/// Throws InputError for a plan that cannot be sent, and TransportError. If the source of the rows or a function of
/// the options throws, the axis is stopped, and the exception is rethrown.
RowOutcome stream_rows(Transport& link, RowPlan plan, const RowOptions& options = {},
                       const Clock& clock = steady_now, std::int64_t session = random_id());

/// Greatest duration of a call of an operator, by default.
inline constexpr Nanos operator_patience = std::chrono::seconds(2);

/// Sends a command of an operator, who needs no session: a Stop, or a Command to hold, resume or
/// override. The function sets the number of the command, and repeats the command until the
/// executor answers, for at most `patience`. Returns the reply; without an answer, its outcome is
/// `pending`.
wire::Reply operator_command(Transport& link, const std::string& executor, wire::Body body,
                             Nanos patience = operator_patience,
                             const std::optional<wire::Key>& key = {},
                             const Clock& clock = steady_now);

/// Stops an axis as an operator, without a session; this ends the session of the axis. The function
/// repeats the stop until the executor answers, for at most `patience`. Returns true if the
/// executor has confirmed the stop.
bool operator_stop(Transport& link, const std::string& executor, wire::StopMode mode,
                   Nanos patience = operator_patience, const std::optional<wire::Key>& key = {},
                   const Clock& clock = steady_now);

/// Returns the present status of an axis: subscribes to its status channel with capacity 1, drops
/// the messages that wait on the link, then waits for the next status, for at most `timeout`.
/// Returns nullopt if none arrives.
std::optional<wire::Message> next_status(Transport& link, const std::string& executor,
                                         Nanos timeout, const std::optional<wire::Key>& key = {},
                                         const Clock& clock = steady_now);

}  // namespace jounce
