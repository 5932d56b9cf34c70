// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/message/refusal.hpp"
#include "jounce/stream/receiver/challenges.hpp"
#include "jounce/stream/receiver/last_command.hpp"
#include "jounce/stream/receiver/queue_intake.hpp"
#include "jounce/stream/receiver/session.hpp"
#include "jounce/stream/receiver/table_intake.hpp"
#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

struct ReceiverOptions {
  std::string executor;                        ///< the name of this axis
  std::uint32_t most_knots = 1U << 24U;        ///< knots of one table, at most
  std::size_t memory = std::size_t{1} << 28U;  ///< bytes of all tables, complete or in transit
  Nanos session_timeout =
      std::chrono::seconds(1);  ///< silence that ends a session and frees the axis
  Nanos hold_timeout = std::chrono::milliseconds(200);  ///< the same during a hold-to-run jog
  std::uint32_t credit =
      8;  ///< messages of 12.8 KB in transit, 1...64; 8 fit a socket's default buffer
  std::uint32_t most_rows = 1U << 20U;  ///< rows of one bank of a queue, at most
  std::size_t most_queues = 4;          ///< queues of one session, at most
  std::optional<wire::Key> key{};       ///< key that must sign commands; nullopt: no key
};

/// A table is complete and its hash matches. It stays in the store.
struct TableReady {
  std::int64_t session = 0;
  StoredTable table;
};

/// The tables are complete, and their axes and units fit the mode. Requires an answer.
struct ArmRequested {
  std::int64_t session = 0;
  std::int32_t command = 0;
  wire::ArmMode mode = wire::ArmMode::play;
  StoredTable slave;
  std::optional<StoredTable> master;  ///< for follow_table
  CouplingSpec coupling{};            ///< coupling of a slave over master
  CamEnd end = CamEnd::brake;         ///< for follow_input
};

/// The queue is open. Requires an answer.
struct QueueArmRequested {
  std::int64_t session = 0;
  std::int32_t command = 0;
  std::uint32_t queue = 0;
  std::uint8_t bank = 0;  ///< first bank of a static queue
};

/// Follows an accepted arm of the same session; a queue has its prefill. Requires an answer.
struct StartRequested {
  std::int64_t session = 0;
  std::int32_t command = 0;
  std::int64_t tick = -1;  ///< tick of the executor; -1: the next one
  StartAt when = StartAt::tick;
  double position = 0;  ///< position of the master, m, with master_position
};

/// Another command to the axis. Its fields are within their ranges, and every queue that they name
/// is open. Requires an answer.
struct CommandRequested {
  std::int64_t session = 0;  ///< 0: an operator, who may only hold, resume and override
  std::int32_t command = 0;
  std::int64_t at = -1;  ///< tick; -1: the next one
  ClientCommand what{};
};

/// A queue was opened, and rows will follow. Receiver::refuse_queue() may reject it.
struct QueueOpened {
  std::int64_t session = 0;
  wire::Queue queue;
};

/// Rows in order and without gaps, within the free space. Receiver::refuse_row() rejects a row that
/// would violate a limit.
struct RowsArrived {
  std::int64_t session = 0;
  wire::Rows rows;
};

/// A stop or an abort: always execute it. Requires an answer.
struct StopRequested {
  std::int64_t session = 0;  ///< 0: an operator
  std::int32_t command = 0;
  wire::StopMode mode = wire::StopMode::stop;
};

/// The axis has no owner any more. Disarm an armed motion without a start; the axis decides whether
/// a motion continues.
struct SessionEnded {
  enum class Why { released, silent, operator_stop };
  std::int64_t session = 0;
  Why why = Why::released;
};

using StreamEvent =
    std::variant<TableReady, ArmRequested, StartRequested, StopRequested, SessionEnded,
                 QueueArmRequested, CommandRequested, QueueOpened, RowsArrived>;

/// The executor's half of the protocol: a pure state machine without thread, clock or link.
///
///     Receiver receiver({.executor = "feeder"}, random_id());
///     receiver.receive(message, now);                      // each arrived message
///     for (const auto& answer : receiver.poll(now)) ...    // to be sent; calls every few ms
///     while (const auto event = receiver.take_event()) ... // for the axis, in order
///     receiver.accept(arm.session, arm.command);           // the axis's answer
///
/// Any message may be lost, duplicated, delayed or reordered. The receiver checks each: it bounds
/// counts before it allocates memory, computes the hash from the received data, and constructs the
/// table from them. It ignores messages for another executor and messages from executors.
///
/// Its parts keep the state: Session (the owner), Challenges, TableIntake, QueueIntake and one
/// LastCommand each for the session and the operators. The receiver passes messages to them, and
/// knows what is armed.
///
/// **Challenge.** A number that every command must carry. The end of a session and the start of the
/// executor draw a new one, so that older messages have no effect. The refusal `stale_challenge`
/// carries the present one. Operators have no session; they have a separate challenge, which
/// changes with each of their commands.
class Receiver {
 public:
  /// `boot` > 0: a random number, different at every start. Throws InputError for a bad name.
  Receiver(ReceiverOptions options, std::int64_t boot);

  void receive(const wire::Message& message, Nanos now);

  /// Ends a session after its timeout, and answers received messages. First receive all messages
  /// that wait on the link, so that they do not count as silence.
  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);
  /// Returns the answers alone: a streamer can then continue while the caller receives more of its
  /// messages.
  [[nodiscard]] std::vector<wire::Message> answers();

  [[nodiscard]] std::optional<StreamEvent> take_event();

  /// The axis's answer to the event of this session and command. An answer after another command or
  /// the end of the session has no effect.
  void accept(std::int64_t session, std::int32_t command);
  /// `cause`: the axis's number of the cause.
  void refuse(std::int64_t session, std::int32_t command, std::string reason,
              std::int32_t cause = 0);

  /// Progress of this queue of the present session: frees space for more rows.
  void level(std::uint32_t queue, const QueueLevel& level);
  /// Rejects this queue, or this row of it (from 0 in its bank).
  void refuse_queue(std::uint32_t queue, wire::Refusal refusal, std::string reason);
  void refuse_row(std::uint32_t queue, std::uint64_t row, std::string reason);

  [[nodiscard]] std::int64_t session() const { return session_.id(); }  ///< 0: the axis is free
  [[nodiscard]] bool armed() const { return armed_; }  ///< a start would be passed to the axis
  [[nodiscard]] const TableStore& store() const { return tables_.store(); }
  [[nodiscard]] const std::string& executor() const { return options_.executor; }
  [[nodiscard]] std::int64_t boot() const { return boot_; }
  /// Challenge of the messages of a session, and of those of an operator.
  [[nodiscard]] std::int64_t challenge() const { return challenges_.session(); }
  [[nodiscard]] std::int64_t operators_challenge() const { return challenges_.operators(); }

  /// Returns the status message of this axis, complete.
  [[nodiscard]] wire::Message status(const wire::Status& status) const;

 private:
  void take(const wire::Header& header) { take_table(header.table, tables_.add(header)); }
  void take(const wire::Chunk& chunk) { take_table(chunk.table, tables_.add(chunk)); }
  void take(const wire::Queue& queue);
  void take(const wire::Rows& rows);
  void take(const wire::Arm& arm);
  void take(const wire::Start& start);
  void take(const wire::Stop& stop);
  void take(const wire::Heartbeat& heartbeat);
  void take(const wire::Command& command);
  template <class Other>
  void take(const Other& /*from an executor*/) {}

  void open(std::int64_t session);
  void end(SessionEnded::Why why);
  void expire(Nanos now);

  void receive_operators(const wire::Message& message);
  void take_table(std::uint32_t table, Refused refused);
  void arm_queue(const wire::Arm& arm);
  [[nodiscard]] Refused misses(const wire::Command& command) const;
  [[nodiscard]] LastCommand* pending(std::int64_t session, std::int32_t command);
  void done(const LastCommand& record);

  void answer_barred(const wire::Message& message, Refused refused);
  void refuse_table(std::int64_t session, std::uint32_t table, Refused refused);
  void refuse_queue_of(std::int64_t session, std::uint32_t queue, Refused refused);
  void refuse_command(std::int64_t session, std::int32_t command, Refused refused);
  void answer_stranger(std::int64_t session, wire::Body body);
  void send(std::int64_t session, wire::Body body);

  ReceiverOptions options_;
  std::int64_t boot_;
  Challenges challenges_;
  Session session_;
  TableIntake tables_;
  QueueIntake queues_;
  LastCommand command_;                      // of the present session, or of the last one
  LastCommand operator_;                     // of session 0
  std::int64_t operators_last_challenge_ = 0;  // of the last command in session 0

  bool armed_ = false;
  std::optional<std::pair<std::uint32_t, std::uint8_t>> armed_queue_;  // queue and bank armed last

  std::vector<wire::Message> outgoing_;
  std::deque<StreamEvent> events_;
};

}  // namespace jounce
