// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "jounce/command/state.hpp"
#include "jounce/stream/sender/client.hpp"

/// Calls of an operator: each is one query or one command, without a streamer.
namespace jounce {

/// Subscribes to the status of an axis and returns the next one; nullopt if none arrives within
/// `timeout`.
std::optional<wire::Status> present_status(Transport& link, const std::string& executor,
                                           Nanos timeout, const std::optional<wire::Key>& key = {},
                                           const Clock& clock = steady_now);

/// Subscribes to the place of a group on its path and returns the next one; nullopt if none arrives
/// within `timeout`. A single axis sends none.
std::optional<wire::GroupStatus> present_group(Transport& link, const std::string& executor,
                                               Nanos timeout,
                                               const std::optional<wire::Key>& key = {},
                                               const Clock& clock = steady_now);

/// Returns the reply to operator_command() as an outcome.
CallOutcome outcome_of(const wire::Reply& reply, const std::string& executor);

/// Sends one command, in a session if the command needs one, and waits for its answer. `at`: tick
/// in which the axis executes it; -1: the next one. Throws InputError for a value out of range, and
/// TransportError.
CallOutcome send_command(Transport& link, const std::string& executor, const ClientCommand& command,
                         std::int64_t at = -1, const std::optional<wire::Key>& key = {},
                         const Clock& clock = steady_now);

/// Waits until the axis is at rest: in the state standstill, disabled or error_stop. Returns its status;
/// nullopt if the axis is not at rest within `patience`. Status::reason is the cause that ended the last
/// motion early. For the owner of the axis, the function below keeps the session alive.
std::optional<wire::Status> await_rest(Transport& link, const std::string& executor, Nanos patience,
                                       const std::optional<wire::Key>& key = {},
                                       const Clock& clock = steady_now);

/// Options of await_rest() for the owner of an axis.
struct RestOptions {
  Nanos patience = std::chrono::seconds(60);  ///< greatest duration of the call
  /// Returns true to stop the axis; the call then waits for rest. May be empty.
  std::function<bool()> cancelled = {};
  std::optional<wire::Key> key = {};  ///< key of the executor; nullopt: none
};

/// Outcome of await_rest() for the owner of an axis.
struct [[nodiscard]] RestOutcome : CallOutcome {
  std::optional<State> state = {};  ///< state of the axis at rest; nullopt: it is not at rest
  double position = wire::Status::unknown;  ///< place at which the axis rests, u
};

/// Waits until the axis is at rest, and keeps the session of its owner alive. The outcome is ok if the
/// motion that the client commanded last has reached its end, or if the client has stopped or halted
/// it (Client::end_of_motion()). The error is
/// - stopped if the motion was cut short: by an operator, a fault, a stop of its group, the end of the
///   session, or `cancelled`. The reason states why and where.
/// - contact_lost if no status arrives for two seconds; out_of_time after `patience`.
/// - restarted if the executor has restarted.
RestOutcome await_rest(Transport& link, const std::string& executor, Client& client,
                       const RestOptions& options = {}, const Clock& clock = steady_now);

/// Waits for the end of a homing that the axis has accepted, and keeps the session of the client
/// alive. If `cancelled` returns true, stops the axis once and waits for rest. If the axis is not
/// homed at the end, the outcome is `refused`, with the cause of the fault or stop.
CallOutcome await_home(Transport& link, const std::string& executor, Client& client,
                       const std::function<bool()>& cancelled,
                       const std::optional<wire::Key>& key = {}, const Clock& clock = steady_now);

/// Options of execute_command().
struct ExecuteOptions {
  std::int64_t at = -1;  ///< tick in the executor, -1: the next one; not with a homing
  Nanos hold{};          ///< a hold-to-run jog ends after this time; 0: only if cancelled
  std::function<void()> held = {};       ///< called when a hold-to-run jog has begun; may be empty
  std::function<bool()> cancelled = {};  ///< returns true to end the jog or stop the homing; may be
                                         ///< empty
  std::optional<wire::Key> key = {};
};

/// Sends one command and waits for its end. A homing ends when the axis is homed (await_home()); a
/// hold-to-run jog ends when its time is over or it is cancelled. Any other command ends with its
/// answer (send_command()). Throws InputError for a value out of range, and TransportError.
CallOutcome execute_command(Transport& link, const std::string& executor,
                            const ClientCommand& command, const ExecuteOptions& options = {},
                            const Clock& clock = steady_now);

/// Result of stop_axis().
struct [[nodiscard]] StopResult {
  bool confirmed = false;          ///< true if the executor has accepted the stop
  std::optional<State> rest = {};  ///< state of the axis at rest; nullopt: the axis was not at rest
                                   ///< in time
};

/// Stops an axis as an operator, and waits until it is at rest (await_rest()).
StopResult stop_axis(Transport& link, const std::string& executor, wire::StopMode mode,
                     Nanos patience, const std::optional<wire::Key>& key = {},
                     const Clock& clock = steady_now);

/// Returns the tick of an executor that is `seconds` (>= 0) after its present status. Returns
/// nullopt if no status arrives within two seconds.
std::optional<std::int64_t> tick_after(Transport& link, const std::string& executor, double seconds,
                                       const std::optional<wire::Key>& key = {},
                                       const Clock& clock = steady_now);

}  // namespace jounce
