// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "jounce/command/state.hpp"
#include "jounce/stream/sender/client.hpp"

/// Calls of an operator: one question or one command, without a streamer.
namespace jounce {

/// Subscribes to the status of an axis and returns the next one; nullopt if none arrives within
/// `timeout`.
std::optional<wire::Status> present_status(Transport& link, const std::string& executor,
                                           Nanos timeout, const std::optional<wire::Key>& key = {},
                                           const Clock& clock = steady_now);

/// Returns the reply to operator_command() as an outcome.
CallOutcome outcome_of(const wire::Reply& reply, const std::string& executor);

/// Sends one command, in a session if the command needs one, and waits for its answer. `at`: tick
/// in which the axis executes it; -1: the next one. Throws InputError for a value out of range, and
/// TransportError.
CallOutcome send_command(Transport& link, const std::string& executor, const ClientCommand& command,
                         std::int64_t at = -1, const std::optional<wire::Key>& key = {});

/// Waits until the axis is at rest: in the state standstill, disabled or error_stop. Returns this
/// state; nullopt if the axis is not at rest within `patience`. The link must have subscribed to
/// the status channel, with capacity 1.
std::optional<State> await_rest(Transport& link, const std::string& executor, Nanos patience,
                                const std::optional<wire::Key>& key = {},
                                const Clock& clock = steady_now);

/// Waits for the end of a homing that the axis has accepted, and keeps the session of the client
/// alive. If `cancelled` returns true, stops the axis once and waits for rest. If the axis is not
/// homed at the end, the outcome is `refused`, with the cause of the fault or stop. The link must
/// have subscribed as for await_rest().
CallOutcome await_home(Transport& link, const std::string& executor, Client& client,
                       const std::function<bool()>& cancelled,
                       const std::optional<wire::Key>& key = {}, const Clock& clock = steady_now);

}  // namespace jounce
