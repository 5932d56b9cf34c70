// SPDX-License-Identifier: Apache-2.0
// A table whose hash comes last: situations in which the header with the hash may arrive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/detail/sender.hpp"

#include "stream/harness.hpp"

namespace jounce::late_hash_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using wire::Refusal;

class LateHash : public testing::Test {
 protected:
  void put(const wire::Body& body) {
    receiver.receive({"feeder", 1, body, receiver.challenge()}, now);
  }
  void put_chunks(std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) put(download[i + 1].body);
  }
  /// The answer to the table, the last one.
  wire::Ack ack() {
    std::optional<wire::Ack> newest;
    for (const auto& message : receiver.poll(now))
      if (const auto* body = std::get_if<wire::Ack>(&message.body)) newest = *body;
    EXPECT_TRUE(newest.has_value());
    return newest.value_or(wire::Ack{});
  }
  std::vector<std::string> events() {
    std::vector<std::string> words;
    while (const auto event = receiver.take_event()) words.push_back(test::word(*event));
    return words;
  }

  Nanos now = std::chrono::seconds(10);
  Table table = test::sine_table(3000);
  std::vector<wire::Message> download = test::messages_of(table, 1);
  wire::Header last = std::get<wire::Header>(download[0].body);
  wire::Header first = [this] {
    wire::Header header = last;
    header.hash = {};
    return header;
  }();
  std::size_t chunks = last.chunks;
  Receiver receiver{{.executor = "feeder"}, 77};
};

TEST_F(LateHash, CompletesATableWhenItArrives) {
  put(first);
  put_chunks(0, chunks);
  const wire::Ack all = ack();
  EXPECT_EQ(all.next, chunks);
  EXPECT_FALSE(all.complete);
  EXPECT_THAT(events(), IsEmpty());
  put(last);
  EXPECT_TRUE(ack().complete);
  EXPECT_THAT(events(), ElementsAre("ready 1"));
  EXPECT_TRUE(test::same(*receiver.store().find(last.hash)->table, table));
}

TEST_F(LateHash, MayComeBeforeTheLastChunk) {
  put(first);
  put_chunks(0, chunks - 1);
  put(last);
  EXPECT_FALSE(ack().complete);
  put_chunks(chunks - 1, chunks);
  EXPECT_TRUE(ack().complete);
  EXPECT_THAT(events(), ElementsAre("ready 1"));
}

TEST_F(LateHash, MayComeTwiceAndTheFirstHeaderAfterIt) {
  put(first);
  put_chunks(0, chunks);
  for (const wire::Header& each : {last, last, first}) put(each);
  put_chunks(0, chunks);
  EXPECT_TRUE(ack().complete);
  EXPECT_THAT(events(), ElementsAre("ready 1"));
  EXPECT_EQ(receiver.store().tables(), 1U);
}

TEST_F(LateHash, RejectsTheTableIfItIsWrong) {
  put(first);
  put_chunks(0, chunks);
  last.hash[31] ^= 1;
  put(last);
  EXPECT_EQ(ack().refusal, Refusal::hash_mismatch);
  EXPECT_THAT(events(), IsEmpty());
  EXPECT_EQ(receiver.store().bytes(), 0U) << "its memory is free again";
  put(std::get<wire::Header>(download[0].body));
  put_chunks(0, chunks);
  EXPECT_THAT(events(), IsEmpty()) << "a second hash is another table";
}

TEST_F(LateHash, RejectsASecondOne) {
  put(first);
  put(last);
  static_cast<void>(receiver.poll(now));
  wire::Header other = last;
  other.hash[0] ^= 1;
  put(other);
  EXPECT_EQ(receiver.poll(now).size(), 1U);
  put_chunks(0, chunks);
  EXPECT_THAT(events(), ElementsAre("ready 1")) << "the first one counts";
  EXPECT_TRUE(receiver.store().find(last.hash).has_value());
}

TEST_F(LateHash, OfATableWithoutRoomMayNameOneThatIsThere) {
  Receiver small{{.executor = "feeder", .memory = 3000 * 4 * sizeof(double) + 4096}, 77};
  const auto put_in = [&](std::int64_t session, const wire::Body& body) {
    small.receive({"feeder", session, body, small.challenge()}, now);
  };
  const auto last_ack = [&] {
    wire::Ack newest;
    for (const auto& message : small.poll(now))
      if (const auto* body = std::get_if<wire::Ack>(&message.body)) newest = *body;
    return newest;
  };
  put_in(1, last);
  for (std::size_t i = 0; i < chunks; ++i) put_in(1, download[i + 1].body);
  ASSERT_TRUE(last_ack().complete);
  const auto played = small.store().find(last.hash);
  ASSERT_TRUE(played);
  wire::Header again = first, named = last;
  again.table = named.table = 1;
  put_in(1, again);
  EXPECT_EQ(last_ack().refusal, Refusal::out_of_memory);
  put_in(1, named);
  EXPECT_TRUE(last_ack().complete);
}

TEST_F(LateHash, BelongsToTheTableThatWasAnnounced) {
  const auto refuses = [&](auto change) {
    wire::Header header = last;
    change(header);
    put(header);
    return ack().refusal == Refusal::bad_header;
  };
  put(first);
  put_chunks(0, chunks);
  static_cast<void>(receiver.poll(now));
  EXPECT_TRUE(refuses([](wire::Header& h) { h.knots += 1; }));
  EXPECT_TRUE(refuses([](wire::Header& h) { h.rule = Interpolation::linear; }));
  EXPECT_TRUE(refuses([](wire::Header& h) { h.outside = Extrapolation::hold; }));
  EXPECT_TRUE(refuses([](wire::Header& h) { h.units.position = "deg"; }));
  EXPECT_TRUE(refuses([](wire::Header& h) { h.units.x = "deg"; }));
  EXPECT_TRUE(refuses([](wire::Header& h) { h.per_chunk -= 1; }));
  EXPECT_THAT(events(), IsEmpty());
  put(last);
  EXPECT_THAT(events(), ElementsAre("ready 1"));
}

TEST_F(LateHash, OfATableThatIsThereNeedsNoMoreChunks) {
  put(last);
  put_chunks(0, chunks);
  const std::size_t bytes = receiver.store().bytes();
  wire::Header again = first;
  again.table = 1;
  put(again);
  EXPECT_EQ(receiver.store().bytes(), 2 * bytes) << "it is under way";
  again.hash = last.hash;
  put(again);
  EXPECT_EQ(receiver.store().bytes(), bytes);
  EXPECT_THAT(events(), ElementsAre("ready 1", "ready 1"));
}

TEST_F(LateHash, ThatNeverComesLeavesNothingBehind) {
  put(first);
  put_chunks(0, chunks);
  put(wire::Arm{.command = 1});
  EXPECT_THAT(events(), IsEmpty()) << "zeros name no table";
  EXPECT_GT(receiver.store().bytes(), 0U);
  now += std::chrono::seconds(2);
  static_cast<void>(receiver.poll(now));
  EXPECT_EQ(receiver.store().bytes(), 0U);
  EXPECT_EQ(receiver.session(), 0);
}

TEST_F(LateHash, OfATableThatIsNoneIsNotAskedFor) {
  auto& values = std::get<wire::Chunk>(download[1].body).values;
  values[1] = values[0];  // x does not ascend
  put(first);
  put_chunks(0, chunks);
  put(last);
  EXPECT_EQ(ack().refusal, Refusal::bad_table);
  EXPECT_EQ(receiver.store().bytes(), 0U);
}

// ---- the streamer -------------------------------------------------------------------------------

/// A streamer of a table longer than a window, and what it sends.
class LateHashSender : public testing::Test {
 protected:
  static constexpr Pace pace{.window = 4, .chunk = 300};
  void poll(bool hash = true) {
    for (auto& message : sender.poll(now)) {
      if (const auto* header = std::get_if<wire::Header>(&message.body)) headers.push_back(*header);
      if (!lost(message)) receiver.receive(message, now);
    }
    for (const auto& message : receiver.poll(now)) sender.receive(message, now);
    if (hash) sender.hash();
    now += std::chrono::milliseconds(1);
  }
  bool lost(const wire::Message& message) {
    const auto* const header = std::get_if<wire::Header>(&message.body);
    return header != nullptr && header->has_hash() && lose-- > 0;
  }
  void run(bool hash = true) {
    for (int i = 0; i < 2000 && !sender.at_goal() && !sender.ended(); ++i) poll(hash);
  }

  Nanos now = std::chrono::seconds(10);
  Table table = test::sine_table(3000);
  Sender sender{test::plan_of(table, StreamGoal::download), 1, {.pace = pace}};
  Receiver receiver{{.executor = "feeder"}, 77};
  std::vector<wire::Header> headers;
  int lose = 0;
};

TEST_F(LateHashSender, SendsItAsSoonAsItIsComputed) {
  run();
  EXPECT_TRUE(sender.at_goal()) << sender.outcome().reason;
  ASSERT_GE(headers.size(), 2U);
  EXPECT_FALSE(headers.front().has_hash());
  EXPECT_EQ(headers.back().hash, content_hash(table, test::move_units));
  EXPECT_TRUE(receiver.store().find(headers.back().hash).has_value());
}

TEST_F(LateHashSender, SendsNoMoreOfATableThatTurnsOutToBeThere) {
  run();
  sender.release();
  poll(), poll();
  Sender again(test::plan_of(table, StreamGoal::download), 2, {.pace = pace});
  std::size_t chunks = 0;
  for (int i = 0; i < 100 && !again.at_goal(); ++i) {
    for (const auto& message : again.poll(now)) {
      if (std::holds_alternative<wire::Chunk>(message.body)) ++chunks;
      receiver.receive(message, now);
    }
    for (const auto& message : receiver.poll(now)) again.receive(message, now);
    while (again.hash()) continue;
    now += std::chrono::milliseconds(1);
  }
  EXPECT_TRUE(again.at_goal()) << again.outcome().reason;
  EXPECT_LE(chunks, pace.window);
}

TEST_F(LateHashSender, ComputesItInTheEndWithoutACallOfHash) {
  run(false);
  EXPECT_TRUE(sender.at_goal()) << sender.outcome().reason;
  EXPECT_EQ(headers.back().hash, content_hash(table, test::move_units));
}

TEST_F(LateHashSender, RepeatsItUntilItIsAcknowledged) {
  lose = 5;
  run();
  EXPECT_TRUE(sender.at_goal()) << sender.outcome().reason;
  EXPECT_EQ(sender.outcome().progress.resent, 0U) << "no chunk was missing";
}

TEST_F(LateHashSender, FailsWithANameIfItIsNeverAcknowledged) {
  lose = 1'000'000;
  for (int i = 0; i < 20'000 && !sender.ended(); ++i) poll();
  EXPECT_EQ(sender.outcome().error, StreamError::contact_lost)
      << "it reports nothing else any more";
}

TEST_F(LateHashSender, IgnoresACompletionBeforeItSentTheHash) {
  poll(), poll();
  wire::Ack ack{.boot = receiver.boot(), .complete = true};
  sender.receive({"feeder", 1, ack, receiver.challenge()}, now);
  EXPECT_FALSE(sender.outcome().downloaded);
  run();
  EXPECT_TRUE(sender.outcome().downloaded);
}

TEST_F(LateHashSender, OfATableThatFitsAWindowIsSentAtOnce) {
  Sender small(test::plan_of(test::sine_table(300)), 1, {.pace = pace});
  const auto messages = small.poll(now);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_TRUE(std::get<wire::Header>(messages[0].body).has_hash());
}

}  // namespace
}  // namespace jounce::late_hash_test
