// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/hash.hpp"
#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/detail/sender.hpp"

#include "fuzz/packets.hpp"
#include "stream/harness.hpp"

namespace jounce::fuzz {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t memory = 100'000;

/// Both ends, with every message that they send each other lost, passed on or held back, and others'
/// packets in between.
class Conversation {
 public:
  void turn(Source& source) {
    now_ += source.below(16) == 0 ? Nanos(700ms) : Nanos(1ms);
    switch (source.below(8)) {
      case 0:
      case 1:
        hear(packet(source), source.below(2) == 0);
        break;
      case 2:
        answer(source.below(2) == 0);
        break;
      case 3:
        if (sender_.at_goal()) sender_.release();
        break;
      case 4:
        sender_.stop(source.below(2) == 0 ? wire::StopMode::stop : wire::StopMode::abort);
        break;
      default:
        pass(source);
    }
    while (const auto event = receiver_.take_event())
      std::visit([&](const auto& e) { take(e); }, *event);
    require(receiver_.store().bytes() <= memory, "the memory of tables is bounded");
  }

 private:
  /// A stranger, or a sender that has the executor's last message.
  void hear(const wire::Bytes& bytes, bool knows) {
    auto decoded = wire::decode(bytes);
    auto* const message = std::get_if<wire::Message>(&decoded);
    if (message == nullptr) return;
    if (knows) message->challenge = receiver_.challenge();
    receiver_.receive(*message, now_);
    sender_.receive(*message, now_);
  }
  void pass(Source& source) {
    for (const auto& message : sender_.poll(now_))
      if (source.below(4) != 0) receiver_.receive(message, now_);
    for (const auto& message : receiver_.poll(now_))
      if (source.below(4) != 0) sender_.receive(message, now_);
  }
  void answer(bool yes) {
    if (yes) receiver_.accept(session_, command_);
    if (!yes) receiver_.refuse(session_, command_, "no", 41);
  }

  void take(const TableReady& e) {
    require(content_hash(*e.table.table, e.table.units) == e.table.hash, "a table has its hash");
  }
  void take(const ArmRequested& e) {
    require(receiver_.store().find(e.slave.hash).has_value(), "what is armed is stored");
    session_ = e.session;
    command_ = e.command;
  }
  template <class Other>
  void take(const Other& /*event*/) {}

  Nanos now_{};
  Receiver receiver_{{.executor = "feeder", .most_knots = 4000, .memory = memory}, 100};
  Sender sender_{test::plan_of(test::sine_table(1200)), 1};
  std::int64_t session_ = 0;
  std::int32_t command_ = 0;
};

}  // namespace

void session(Input input) {
  Source source(input);
  Conversation conversation;
  for (int i = 0; i < 400 && !source.empty(); ++i) conversation.turn(source);
}

}  // namespace jounce::fuzz
