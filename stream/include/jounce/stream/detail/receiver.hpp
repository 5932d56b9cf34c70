// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jounce/stream/detail/queue_level.hpp"
#include "jounce/stream/detail/table_store.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/receiver/receiver_options.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Event: a table is complete, and its hash matches. The table stays in the store.
struct TableReady {
  std::int64_t session = 0;  ///< session of the sender
  StoredTable table = {};    ///< the table
};

/// Event: an arm of complete tables whose variables and units fit the mode. Requires an answer.
struct ArmRequested {
  std::int64_t session = 0;                  ///< session of the sender
  std::int32_t command = 0;                  ///< number of the command; answer with it
  wire::ArmMode mode = wire::ArmMode::play;  ///< the motion that the axis plays
  StoredTable slave = {};                    ///< table of the slave
  std::optional<StoredTable> master = {};    ///< table of the master, for follow_table
  CouplingSpec coupling{};                   ///< coupling of a slave's table over a master
  CamEnd end = CamEnd::brake;                ///< for follow_input: behavior at the end of the cam
};

/// Event: an arm of a queue that is open and was not rejected. Requires an answer.
struct QueueArmRequested {
  std::int64_t session = 0;  ///< session of the sender
  std::int32_t command = 0;  ///< number of the command; answer with it
  std::uint32_t queue = 0;   ///< index of the queue
  std::uint8_t bank = 0;     ///< for a static queue: the bank that is played first
};

/// Event: a start after an accepted arm of the same session. A queue has the rows that its start
/// needs. Requires an answer.
struct StartRequested {
  std::int64_t session = 0;      ///< session of the sender
  std::int32_t command = 0;      ///< number of the command; answer with it
  std::int64_t tick = -1;        ///< tick of the start; -1: the next one
  StartAt when = StartAt::tick;  ///< condition of the start
  double position = 0;  ///< position of the master, m (unit of the master), for master_position
};

/// Event: another command to the axis. Its fields are within their ranges, and every queue that it
/// names is open. Requires an answer.
struct CommandRequested {
  std::int64_t session = 0;  ///< 0: an operator, who may only hold, resume and override
  std::int32_t command = 0;  ///< number of the command; answer with it
  std::int64_t at = -1;      ///< tick of the execution; -1: the next one
  ClientCommand what{};      ///< the command
};

/// Event: a queue was opened, and rows will follow. Call refuse_queue() to reject the queue.
struct QueueOpened {
  std::int64_t session = 0;  ///< session of the sender
  wire::Queue queue = {};    ///< the queue
};

/// Event: rows in their order, without gaps, that fit into the free space. Call refuse_row() to
/// reject a row that breaks a limit.
struct RowsArrived {
  std::int64_t session = 0;  ///< session of the sender
  wire::Rows rows = {};      ///< the rows
};

/// Event: a stop or an abort, which must always be executed. Requires an answer.
struct StopRequested {
  std::int64_t session = 0;                    ///< 0: an operator
  std::int32_t command = 0;                    ///< number of the command; answer with it
  wire::StopMode mode = wire::StopMode::stop;  ///< stop or abort
};

/// Event: the session of the axis has ended. The axis must disarm an armed motion without a start.
/// The axis decides whether a motion in progress continues.
struct SessionEnded {
  enum class Why { released, silent, operator_stop };
  std::int64_t session = 0;  ///< the session
  Why why = Why::released;   ///< reason for the end of the session
};

/// Any event of a receiver.
using StreamEvent =
    std::variant<TableReady, ArmRequested, StartRequested, StopRequested, SessionEnded,
                 QueueArmRequested, CommandRequested, QueueOpened, RowsArrived>;

/// The executor's half of the protocol for one axis, as a pure state machine without thread, clock
/// or link.
///
///     Receiver receiver({.executor = "feeder"}, random_id());
///     receiver.receive(message, now);                      // each arrived message
///     for (const auto& answer : receiver.poll(now)) ...    // send each one; poll every few ms
///     while (const auto event = receiver.take_event()) ... // for the axis, in order
///     receiver.accept(session, arm.command);               // the axis's answer
///
/// Any message may be lost, duplicated, delayed or reordered. The receiver checks each message. It
/// checks counts before it allocates memory, and it computes hashes and makes tables only from
/// received data. It ignores messages for other executors and messages from executors.
///
/// **Challenge.** A challenge is a number that every command must contain. The receiver draws a new
/// one when the executor starts and when a session ends, so that older messages have no effect. The
/// refusal `stale_challenge` contains the present challenge. Operators have no session; they have a
/// separate challenge, which changes with each of their commands. In two cases, a stop does not
/// need the newest challenge: while the axis is free, the last owner may stop it with the challenge
/// of its session; and without a key, an operator may stop it with the challenge 0.
class Receiver {
 public:
  /// `boot` > 0: a random number, different at each start. Throws InputError for an invalid name,
  /// and for a credit outside 1 to 64.
  Receiver(ReceiverOptions options, std::int64_t boot);
  ~Receiver();
  /// Leaves `other` without an axis: only assign to it, or destroy it.
  Receiver(Receiver&& other) noexcept;
  Receiver& operator=(Receiver&& other) noexcept;

  /// Processes a message that has arrived at the time `now`.
  void receive(const wire::Message& message, Nanos now);

  /// Ends a session that has timed out, and returns the answers to received messages. Before this
  /// call, receive all messages that wait on the link; otherwise they would count as silence.
  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);
  /// Returns only the answers, and does not end a session. Call it while messages still wait on the
  /// link, so that a streamer need not wait.
  [[nodiscard]] std::vector<wire::Message> answers();

  /// Returns the next event for the axis; nullopt: none.
  [[nodiscard]] std::optional<StreamEvent> take_event();

  /// Answers an event: the axis has accepted the command. No effect if another command has
  /// followed, or if the session has ended. `note`: a remark for the operator, sent as the reason
  /// of the reply; at most wire::reason_bytes.
  void accept(std::int64_t session, std::int32_t command, std::string note = {});
  /// Answers an event: the axis has rejected the command. `cause`: number of the Cause; 0: none.
  void refuse(std::int64_t session, std::int32_t command, std::string reason,
              std::int32_t cause = 0);

  /// Reports the progress of a queue of the present session, which frees space for more rows.
  void level(std::uint32_t queue, const QueueLevel& level);
  /// Rejects a queue.
  void refuse_queue(std::uint32_t queue, wire::Refusal refusal, std::string reason);
  /// Rejects a row of a queue. `row`: index in its bank, from 0.
  void refuse_row(std::uint32_t queue, std::uint64_t row, std::string reason);

  /// Reports that the end of this session has stopped the axis in motion. Later messages of the session
  /// are then answered with Cause::stopped, as after a stop by an operator.
  void stopped_with(std::int64_t session);

  [[nodiscard]] std::int64_t session() const;  ///< 0: the axis is free
  /// True if an arm was accepted, until the next arm, an accepted start, a stop, or the end of the
  /// session. Only then is a start passed to the axis.
  [[nodiscard]] bool armed() const;
  /// The complete tables.
  [[nodiscard]] const TableStore& store() const;
  /// Name of the axis.
  [[nodiscard]] const std::string& executor() const;
  /// The number of this start of the executor.
  [[nodiscard]] std::int64_t boot() const;
  /// The challenge that messages of the session must contain, and the challenge for messages of an
  /// operator.
  [[nodiscard]] std::int64_t challenge() const;
  [[nodiscard]] std::int64_t operators_challenge() const;

  /// Returns the status as a message: with name, session and challenge.
  [[nodiscard]] wire::Message status(const wire::Status& status) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce
