// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/stream/detail/receiver.hpp"

#include "stream/src/message/refusal.hpp"
#include "stream/src/receiver/challenges.hpp"
#include "stream/src/receiver/last_command.hpp"
#include "stream/src/receiver/queue_intake.hpp"
#include "stream/src/receiver/session.hpp"
#include "stream/src/receiver/table_intake.hpp"

namespace jounce {

/// The parts of a receiver. See Receiver.
class Receiver::Impl {
 public:
  Impl(ReceiverOptions options, std::int64_t boot);
  void receive(const wire::Message& message, Nanos now);
  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);
  [[nodiscard]] std::vector<wire::Message> answers();
  [[nodiscard]] std::optional<StreamEvent> take_event();
  void accept(std::int64_t session, std::int32_t command, std::string note);
  void refuse(std::int64_t session, std::int32_t command, std::string reason, std::int32_t cause);
  void level(std::uint32_t queue, const QueueLevel& level);
  void refuse_queue(std::uint32_t queue, wire::Refusal refusal, std::string reason);
  void refuse_row(std::uint32_t queue, std::uint64_t row, std::string reason);
  void stopped_with(std::int64_t session) { session_.stopped(session); }
  [[nodiscard]] std::int64_t session() const { return session_.id(); }
  [[nodiscard]] bool armed() const { return armed_; }
  [[nodiscard]] const TableStore& store() const { return tables_.store(); }
  [[nodiscard]] const std::string& executor() const { return options_.executor; }
  [[nodiscard]] std::int64_t boot() const { return boot_; }
  [[nodiscard]] std::int64_t challenge() const { return challenges_.session(); }
  [[nodiscard]] std::int64_t operators_challenge() const { return challenges_.operators(); }
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
  LastCommand command_;   // newest command of the present session, or of the last one
  LastCommand operator_;  // newest command of session 0
  std::int64_t operators_last_challenge_ = 0;  // challenge of the last command in session 0

  bool armed_ = false;
  std::optional<std::pair<std::uint32_t, std::uint8_t>> armed_queue_;  // queue and bank armed last

  std::vector<wire::Message> outgoing_;
  std::deque<StreamEvent> events_;
};

}  // namespace jounce
