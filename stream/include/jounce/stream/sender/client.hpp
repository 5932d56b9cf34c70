// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "jounce/command/commands.hpp"
#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/outcome.hpp"
#include "jounce/stream/transport/link.hpp"

namespace jounce {

class CommandSlot;

/// Options of a client.
struct ClientOptions {
  std::optional<wire::Key> key{};            ///< key of the executor; nullopt: none
  Nanos patience = std::chrono::seconds(2);  ///< greatest duration of a call
  /// Time between two repetitions of a command without an answer.
  Nanos repeat = std::chrono::milliseconds(20);
};

/// Sends commands to an axis of an executor, one call after another, like the function blocks of
/// PLCopen. jounce/command/commands.hpp contains the commands.
///
///     Client client(link, "feeder");
///     if (const auto outcome = client.enable(); !outcome.ok()) return outcome.reason;
///     const command::MoveAbsolute move{.position = 120, .dynamics = {.velocity = 200}};
///     if (const auto outcome = client.command(move); !outcome.ok()) return outcome.reason;
///     if (const auto rest = await_rest(link, "feeder", client); !rest.ok())  // operate.hpp
///       return rest.reason;                                     // for example, it was stopped
///
/// A call returns when the axis has accepted or rejected the command; the motion may not have ended
/// yet. A call throws only InputError, for a value that is out of range for any axis, and
/// TransportError. Units are the units of the axis and of its master.
///
/// **Session.** The first call opens a session: from then on, the client owns the axis. If another
/// program owns the axis, the call is rejected with Refusal::busy. If no call is made for the session
/// timeout of the axis (by default one second), the session ends, and a motion in progress is stopped
/// before its end. So call beat() several times a second while the axis moves, or await_rest().
/// release() ends the session, and the motion continues to its end.
///
/// **Stops.** If an operator stops the axis, or if the end of the session stops a motion, the next call
/// has no effect and returns StreamError::stopped, once. The program must decide whether to continue:
/// the call after it opens a new session. If the session ends while the axis is at rest, the next call
/// opens a new session at once.
///
/// **The destructor** releases the session, and waits for the answer for at most 0.2 s. If it runs
/// because an exception leaves the scope, or after abandon(), it does not release: the motion is
/// stopped when the session times out.
///
/// **Threads.** Use a client and its link in one thread only: replies that another thread takes
/// from the link are lost, and both calls end with StreamError::no_answer.
///
/// If the executor restarts, the next call returns StreamError::restarted and has no effect,
/// because the state of the axis may have changed. The call after it opens a new session.
class Client {
 public:
  /// Subscribes to the replies. `link` must outlive the client. Throws InputError for an invalid
  /// name.
  Client(Transport& link, std::string executor, ClientOptions options = {},
         Clock clock = steady_now);
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  CallOutcome enable() { return command(command::Enable{}); }
  CallOutcome disable() { return command(command::Disable{}); }
  CallOutcome reset() { return command(command::Reset{}); }
  CallOutcome hold() { return command(command::Hold{}); }
  CallOutcome resume() { return command(command::Resume{}); }
  /// Sends a heartbeat. `patience`: see request().
  CallOutcome beat(Nanos patience = Nanos::max()) { return request(wire::Heartbeat{}, patience); }
  /// Sends a heartbeat in the present session, but never opens a new session. If the executor has
  /// ended the session, for example because an operator has stopped the axis, the error is
  /// StreamError::stopped.
  CallOutcome keep(Nanos patience = Nanos::max());
  /// Stops the axis and ends its motion.
  CallOutcome stop(wire::StopMode mode = wire::StopMode::stop);

  CallOutcome gear_out() { return command(command::GearOut{}); }
  CallOutcome cam_out() { return command(command::CamOut{}); }

  /// Sends any command to the axis. `at`: tick in which the axis executes it; -1: the next one.
  /// Throws InputError for a value out of range, and for NaN: a value that is not given is
  /// as_configured.
  CallOutcome command(const ClientCommand& command, std::int64_t at = -1);

  /// Sends any message of a client, in the present session or in a new one. Use a Heartbeat to keep
  /// the session alive. The call waits for the answer for at most `patience`, and never longer than
  /// ClientOptions::patience.
  CallOutcome request(const wire::Body& body, Nanos patience = Nanos::max());

  /// Ends the session. A motion continues.
  CallOutcome release();
  /// Forgets the session without a message: when it times out, a motion in progress is stopped.
  void abandon() { session_ = 0; }

  /// Treats the present motion as one that this client has commanded: for a motion of another session,
  /// such as that of stream_tables().
  void adopt_motion() { awaits_end_ = true; }
  /// Returns how the motion that this client commanded last has ended; `status` is that of the axis at
  /// rest. The outcome is ok if the motion has reached its end, or if this client has stopped or halted
  /// it. Otherwise the error is StreamError::stopped, with the cause and the place; the next call is
  /// ok, until another motion is commanded.
  CallOutcome end_of_motion(const wire::Status& status);

  /// The present session; 0: none yet.
  [[nodiscard]] std::int64_t session() const { return session_; }

 private:
  friend class StaticQueue;

  CallOutcome open(Nanos patience = Nanos::max());
  void send(wire::Body body);
  [[nodiscard]] std::optional<wire::Message> receive(Nanos timeout);
  CallOutcome ask(const wire::Body& body, Nanos patience = Nanos::max());
  CallOutcome ended(const CallOutcome& refused);

  Transport& link_;
  std::string executor_;
  ClientOptions options_;
  Clock clock_;
  Rejects rejects_;
  std::unique_ptr<CommandSlot> slot_;
  std::int64_t session_ = 0;
  std::int64_t challenge_ = 0;
  std::int64_t boot_ = 0;
  bool awaits_end_ = false;  ///< this client has commanded a motion, whose end is unknown
  int exceptions_;           ///< exceptions in flight when the client was made
};

}  // namespace jounce
