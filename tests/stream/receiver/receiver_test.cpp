// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/receiver.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "stream/harness.hpp"

namespace jounce::receiver_test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using wire::Refusal;

/// A receiver of the axis "feeder" that one message after another is put to.
class ReceiverTest : public testing::Test {
 protected:
  void put(std::int64_t session, wire::Body body) { put({"feeder", session, std::move(body)}); }
  /// Sends like a streamer that received the challenge when its session began.
  void put(wire::Message message) {
    const auto told = challenges.find(message.session);
    message.challenge = message.session == 0       ? 0
                        : told != challenges.end() ? told->second
                                                   : receiver.challenge();
    receiver.receive(message, now);
    if (message.session == receiver.session() && message.session != 0)
      challenges[message.session] = receiver.challenge();
  }
  void put(const std::vector<wire::Message>& messages) {
    for (const auto& message : messages) put(message);
  }

  std::vector<std::string> events() {
    std::vector<std::string> words;
    while (const auto event = receiver.take_event()) words.push_back(test::word(*event));
    return words;
  }

  /// The last answer of a kind.
  template <class Body>
  Body answer() {
    std::optional<Body> last;
    for (const auto& message : receiver.poll(now))
      if (const auto* body = std::get_if<Body>(&message.body)) last = *body;
    EXPECT_TRUE(last.has_value());
    return last.value_or(Body{});
  }

  /// Downloads and arms the table in session 1; nothing is left to be read.
  void arm() {
    put(test::messages_of(table, 1));
    put(1, wire::Arm{.command = 1, .slave = hash});
    receiver.accept(1, 1);
    ASSERT_TRUE(receiver.armed());
    static_cast<void>(receiver.poll(now));
    static_cast<void>(events());
  }

  Nanos now = 10s;
  Table table = test::sine_table(3000);
  Sha256 hash = content_hash(table, test::move_units);
  std::vector<wire::Message> download = test::messages_of(table, 1);
  Receiver receiver{{.executor = "feeder"}, 77};
  std::map<std::int64_t, std::int64_t> challenges;  // by session
};

TEST_F(ReceiverTest, AcceptsATableAndAcknowledgesIt) {
  put(download[0]);
  auto ack = answer<wire::Ack>();
  EXPECT_EQ(ack.boot, 77);
  EXPECT_EQ(ack.next, 0U);
  EXPECT_EQ(ack.credit, 8U);
  EXPECT_FALSE(ack.complete);
  for (std::size_t i = 1; i + 1 < download.size(); ++i) put(download[i]);
  EXPECT_FALSE(answer<wire::Ack>().complete);
  EXPECT_THAT(events(), IsEmpty()) << "not before the last chunk";
  put(download.back());
  ack = answer<wire::Ack>();
  EXPECT_TRUE(ack.complete);
  EXPECT_EQ(ack.next, 6U);
  EXPECT_THAT(events(), ElementsAre("ready 1"));
  EXPECT_TRUE(test::same(*receiver.store().find(hash)->table, table));
  EXPECT_EQ(receiver.store().bytes(), 3000U * 3 * 8);
}

TEST_F(ReceiverTest, MindsNeitherOrderNorRepetition) {
  put(download[3]);  // before any header
  EXPECT_EQ(answer<wire::Ack>().refusal, Refusal::unknown_session);
  put(download[0]);
  for (std::size_t i = download.size(); i-- > 0;) {
    put(download[i]);
    put(download[i]);
  }
  EXPECT_THAT(events(), ElementsAre("ready 1")) << "once";
}

TEST_F(ReceiverTest, AnswersABatchOnce) {
  put(download[0]);
  put(download[1]);
  put(download[4]);
  const auto answers = receiver.poll(now);
  ASSERT_EQ(answers.size(), 1U);
  const auto& ack = std::get<wire::Ack>(answers[0].body);
  EXPECT_EQ(ack.next, 1U);
  EXPECT_EQ(ack.mask, 0b10U) << "chunk 3";
  EXPECT_THAT(receiver.poll(now), IsEmpty());
}

TEST_F(ReceiverTest, RecognizesATableItHas) {
  arm();
  put(1, wire::Heartbeat{.command = 2, .release = true});
  put(2, std::get<wire::Header>(download[0].body));
  EXPECT_TRUE(answer<wire::Ack>().complete);
  EXPECT_THAT(events(), ElementsAre("released 1", "ready 2"));
}

TEST_F(ReceiverTest, TakesOneTableUnderTwoIndices) {
  put(download[0]);
  put(test::messages_of(table, 1, 5)[0]);
  put(test::messages_of(table, 1, 5));
  put(download);
  EXPECT_THAT(events(), ElementsAre("ready 1", "ready 1"));
  EXPECT_EQ(receiver.store().tables(), 1U);
  EXPECT_EQ(receiver.store().bytes(), 3000U * 3 * 8) << "paid for once";
}

TEST_F(ReceiverTest, IgnoresOtherExecutorsAndOtherWaysRound) {
  wire::Message other = download[0];
  other.executor = "cutter";
  put(other);
  put(1, wire::Ack{.boot = 1});
  put(1, wire::Reply{.boot = 1, .command = 1});
  put(0, wire::Status{});
  put(0, wire::Start{.command = 1});
  EXPECT_THAT(receiver.poll(now), IsEmpty());
  EXPECT_EQ(receiver.session(), 0);
}

// ---- bounds -------------------------------------------------------------------------------------

TEST_F(ReceiverTest, BoundsKnotsBeforeTakingMemory) {
  Receiver small({.executor = "feeder", .most_knots = 2999}, 77);
  download[0].challenge = small.challenge();
  small.receive(download[0], now);
  const auto answers = small.poll(now);
  EXPECT_EQ(std::get<wire::Ack>(answers.at(0).body).refusal, Refusal::too_large);
  EXPECT_EQ(small.store().bytes(), 0U);
}

TEST_F(ReceiverTest, BoundsMemoryOfAllTables) {
  // The default of 2^28 bytes holds two of these and no third: 2^22 knots of 3 columns are 100 MB.
  for (std::uint32_t i = 0; i < 3; ++i) {
    wire::Header header = std::get<wire::Header>(download[0].body);
    header.table = i;
    header.hash[0] = static_cast<std::uint8_t>(i);
    header.knots = 1U << 22U;
    header.chunks = wire::cut(header.rule, header.knots).chunks;
    put(1, header);
    EXPECT_EQ(answer<wire::Ack>().refusal, i < 2 ? Refusal::none : Refusal::out_of_memory);
  }
  now += 2s;
  EXPECT_THAT(receiver.poll(now), IsEmpty());
  EXPECT_EQ(receiver.store().bytes(), 0U) << "a session that ends gives its memory back";
}

TEST_F(ReceiverTest, RejectsAHeaderThatContradictsItself) {
  wire::Header header = std::get<wire::Header>(download[0].body);
  header.chunks += 1;
  put(1, header);
  EXPECT_EQ(answer<wire::Ack>().refusal, Refusal::bad_header);
  EXPECT_EQ(receiver.store().bytes(), 0U);
}

TEST_F(ReceiverTest, RejectsAChunkOfNoKnotsOrTooMany) {
  wire::Header header = std::get<wire::Header>(download[0].body);
  for (const std::uint32_t per_chunk : {0U, 1U + 7680 / 3, UINT32_MAX / 2}) {
    ++header.table;
    header.per_chunk = per_chunk;
    put(1, header);
    EXPECT_EQ(answer<wire::Ack>().refusal, Refusal::bad_header);
  }
}

TEST_F(ReceiverTest, GivesCreditByLength) {
  put(test::messages_of(test::sine_table(10'000), 1)[0]);
  EXPECT_EQ(answer<wire::Ack>().credit, 8U);
  wire::Header header =
      std::get<wire::Header>(test::messages_of(test::sine_table(10'000), 1)[0].body);
  header.table = 1;
  header.hash[0] ^= 1;
  header.per_chunk = 4096 / 3;
  header.chunks = wire::cut(header).chunks;
  put(1, header);
  EXPECT_EQ(answer<wire::Ack>().credit, 4U);
}

TEST_F(ReceiverTest, RejectsAnotherTableUnderAnIndexInUse) {
  put(download[0]);
  static_cast<void>(receiver.poll(now));
  put(test::messages_of(test::sine_table(10), 1)[0]);
  EXPECT_EQ(answer<wire::Ack>().refusal, Refusal::bad_header);
  put(download);
  EXPECT_THAT(events(), ElementsAre("ready 1")) << "the first one is not disturbed";
}

TEST_F(ReceiverTest, RejectsAChunkThatContradictsItsHeader) {
  put(download[0]);
  wire::Chunk chunk = std::get<wire::Chunk>(download[2].body);
  chunk.first_knot = 0;
  put(1, chunk);
  std::vector<Refusal> refusals;
  for (const auto& message : receiver.poll(now))
    refusals.push_back(std::get<wire::Ack>(message.body).refusal);
  EXPECT_THAT(refusals, testing::Contains(Refusal::bad_chunk));
}

TEST_F(ReceiverTest, AnswersAFloodOfStrangersWithinBounds) {
  put(download[0]);
  for (int i = 0; i < 10'000; ++i) put(2, std::get<wire::Chunk>(download[1].body));
  EXPECT_LE(receiver.poll(now).size(), 65U);
}

// ---- what arrived is not what was announced -----------------------------------------------------

TEST_F(ReceiverTest, RejectsATableWhoseHashIsWrong) {
  auto& chunk = std::get<wire::Chunk>(download[2].body);
  chunk.values[600] += 1e-9;  // a position; its checksum would be right
  put(download);
  const auto ack = answer<wire::Ack>();
  EXPECT_EQ(ack.refusal, Refusal::hash_mismatch);
  EXPECT_FALSE(ack.complete);
  EXPECT_THAT(events(), IsEmpty());
  EXPECT_EQ(receiver.store().bytes(), 0U);
  put(1, wire::Arm{.command = 1, .slave = hash});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::table_missing);
}

// ---- arm, start, stop ---------------------------------------------------------------------------

TEST_F(ReceiverTest, RejectsToArmBeforeTheTableIsComplete) {
  download.pop_back();
  put(download);
  put(1, wire::Arm{.command = 1, .slave = hash});
  const auto reply = answer<wire::Reply>();
  EXPECT_EQ(reply.outcome, wire::Outcome::refused);
  EXPECT_EQ(reply.refusal, Refusal::table_missing);
  EXPECT_THAT(events(), IsEmpty());
}

TEST_F(ReceiverTest, RejectsToStartWithoutArm) {
  put(download);
  put(1, wire::Start{.command = 1});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::not_armed);
  EXPECT_THAT(events(), ElementsAre("ready 1"));
}

TEST_F(ReceiverTest, RejectsToStartBeforeTheAxisHasAnswered) {
  put(download);
  put(1, wire::Arm{.command = 1, .slave = hash});
  put(1, wire::Start{.command = 2});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::not_armed);
}

TEST_F(ReceiverTest, RejectsAModeThatTheTableDoesNotFit) {
  put(download);
  put(1, wire::Arm{.command = 1, .mode = wire::ArmMode::follow_input, .slave = hash});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::wrong_axis);
  put(1, wire::Arm{.command = 2, .mode = wire::ArmMode::follow_table, .slave = hash});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::table_missing) << "the master table";
  put(1, wire::Arm{.command = 3, .mode = wire::ArmMode::path, .slave = hash});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::wrong_axis) << "a program is a list of numbers";
}

TEST_F(ReceiverTest, HandsTheArmToTheAxisAndItsAnswerBack) {
  put(download);
  put(1, wire::Arm{.command = 1, .slave = hash});
  EXPECT_EQ(answer<wire::Reply>().outcome, wire::Outcome::pending);
  EXPECT_THAT(events(), ElementsAre("ready 1", "arm 1"));
  put(1, wire::Arm{.command = 1, .slave = hash});
  EXPECT_THAT(events(), IsEmpty()) << "repeated";
  receiver.accept(1, 1);
  EXPECT_EQ(answer<wire::Reply>().outcome, wire::Outcome::accepted);
  put(1, wire::Arm{.command = 1, .slave = hash});
  EXPECT_EQ(answer<wire::Reply>().outcome, wire::Outcome::accepted) << "the recorded outcome";
  put(1, wire::Start{.command = 2, .tick = 500});
  const auto event = receiver.take_event();
  ASSERT_TRUE(event.has_value());
  EXPECT_EQ(std::get<StartRequested>(*event).tick, 500);
}

TEST_F(ReceiverTest, GivesTheAxissRejectionOn) {
  put(download);
  put(1, wire::Arm{.command = 1, .slave = hash});
  receiver.refuse(1, 1, "start_position", 41);
  const auto reply = answer<wire::Reply>();
  EXPECT_EQ(reply.refusal, Refusal::axis);
  EXPECT_EQ(reply.cause, 41);
  EXPECT_EQ(reply.reason, "start_position");
  EXPECT_FALSE(receiver.armed());
}

TEST_F(ReceiverTest, NeedsANewArmForASecondStart) {
  arm();
  put(1, wire::Start{.command = 2});
  receiver.accept(1, 2);
  put(1, wire::Start{.command = 3});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::not_armed);
  EXPECT_THAT(events(), ElementsAre("start 1"));
}

TEST_F(ReceiverTest, LetsNoLateStartUndoAStop) {
  arm();
  put(1, wire::Stop{.command = 3});
  receiver.accept(1, 3);
  put(1, wire::Start{.command = 2});  // overtaken by the stop
  EXPECT_THAT(events(), ElementsAre("stop 1"));
  static_cast<void>(receiver.poll(now));
  put(1, wire::Start{.command = 4});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::not_armed);
}

TEST_F(ReceiverTest, IgnoresAnAnswerThatComesTooLate) {
  put(download);
  put(1, wire::Arm{.command = 1, .slave = hash});
  put(1, wire::Stop{.command = 2});
  receiver.accept(1, 1);
  EXPECT_FALSE(receiver.armed());
  EXPECT_EQ(answer<wire::Reply>().outcome, wire::Outcome::pending) << "of the stop";
}

TEST_F(ReceiverTest, ArmsAMasterAndASlaveTable) {
  const Table cam = test::sine_table(361, Interpolation::quintic_hermite, Domain::master);
  const Table master = test::sine_table(50);
  const Units in_degrees{"s", "deg"};
  auto slave = test::messages_of(cam, 1, 0);
  auto driver = test::messages_of(master, 1, 1);
  auto& slave_header = std::get<wire::Header>(slave[0].body);
  auto& driver_header = std::get<wire::Header>(driver[0].body);
  slave_header.units = test::cam_units;
  slave_header.hash = content_hash(cam, test::cam_units);
  driver_header.units = in_degrees;
  driver_header.hash = content_hash(master, in_degrees);
  put(slave);
  put(driver);
  EXPECT_THAT(events(), ElementsAre("ready 1", "ready 1"));
  put(1, wire::Arm{.command = 1,
                   .mode = wire::ArmMode::follow_table,
                   .slave = slave_header.hash,
                   .master = driver_header.hash});
  const auto event = receiver.take_event();
  ASSERT_TRUE(event.has_value());
  const auto& armed = std::get<ArmRequested>(*event);
  EXPECT_TRUE(test::same(*armed.slave.table, cam));
  ASSERT_TRUE(armed.master.has_value());
  EXPECT_TRUE(test::same(*armed.master->table, master));
}

// ---- sessions -----------------------------------------------------------------------------------

TEST_F(ReceiverTest, KeepsAnAxisForItsLiveSession) {
  put(download[0]);
  static_cast<void>(receiver.poll(now));
  put(2, std::get<wire::Header>(download[0].body));
  EXPECT_EQ(answer<wire::Ack>().refusal, Refusal::busy);
  put(2, wire::Start{.command = 1});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::busy);
  put(2, wire::Stop{.command = 1});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::busy);
  EXPECT_THAT(events(), IsEmpty());
  EXPECT_EQ(receiver.session(), 1);
}

TEST_F(ReceiverTest, FreesTheAxisOfASilentSession) {
  put(download[0]);
  put(download[1]);
  now += 1s;
  static_cast<void>(receiver.poll(now));
  EXPECT_EQ(receiver.session(), 1);
  now += 1ns;
  static_cast<void>(receiver.poll(now));
  EXPECT_THAT(events(), ElementsAre("silent 1"));
  EXPECT_EQ(receiver.store().bytes(), 0U);
  put(test::messages_of(table, 2));
  EXPECT_THAT(events(), ElementsAre("ready 2"));
}

TEST_F(ReceiverTest, TakesWaitingForSilenceOnlyAfterHavingListened) {
  put(download[0]);
  now += 5s;         // the communication thread was kept from running
  put(download[1]);  // but this had arrived meanwhile
  static_cast<void>(receiver.poll(now));
  EXPECT_EQ(receiver.session(), 1);
}

TEST_F(ReceiverTest, ATimedOutSessionGivesWayToTheNextHeader) {
  put(download[0]);
  now += 2s;
  put(2, std::get<wire::Header>(download[0].body));
  EXPECT_EQ(answer<wire::Ack>().refusal, Refusal::stale_challenge) << "of the session that ended";
  put(2, std::get<wire::Header>(download[0].body));
  EXPECT_EQ(receiver.session(), 2);
}

TEST_F(ReceiverTest, AnEndedSessionDoesNothingMore) {
  arm();
  put(1, wire::Heartbeat{.command = 2, .release = true});
  EXPECT_EQ(answer<wire::Reply>().outcome, wire::Outcome::accepted);
  EXPECT_THAT(events(), ElementsAre("released 1"));
  EXPECT_FALSE(receiver.armed());
  put(1, wire::Heartbeat{.command = 2, .release = true});
  EXPECT_EQ(answer<wire::Reply>().outcome, wire::Outcome::accepted) << "its answer was lost";
  put(download[0]);
  EXPECT_EQ(answer<wire::Ack>().refusal, Refusal::session_ended);
  put(1, wire::Start{.command = 3});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::session_ended);
  EXPECT_THAT(events(), IsEmpty());
  EXPECT_EQ(receiver.session(), 0);
}

TEST_F(ReceiverTest, AnArmPendingAtTheEndOfItsSessionIsVoid) {
  put(download);
  put(1, wire::Arm{.command = 1, .slave = hash});
  now += 2s;
  static_cast<void>(receiver.poll(now));
  receiver.accept(1, 1);
  EXPECT_FALSE(receiver.armed());
  EXPECT_THAT(events(), ElementsAre("ready 1", "arm 1", "silent 1"));
}

TEST_F(ReceiverTest, TheLastOwnerMayStillStopItsMotion) {
  arm();
  put(1, wire::Start{.command = 2});
  receiver.accept(1, 2);
  now += 2s;
  static_cast<void>(receiver.poll(now));
  EXPECT_THAT(events(), ElementsAre("start 1", "silent 1"));
  put(1, wire::Stop{.command = 3});
  EXPECT_THAT(events(), ElementsAre("stop 1"));
  receiver.accept(1, 3);
  EXPECT_EQ(answer<wire::Reply>().outcome, wire::Outcome::accepted);
  put(test::messages_of(table, 2));
  static_cast<void>(receiver.poll(now));
  put(1, wire::Stop{.command = 4});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::session_ended)
      << "until somebody else owns the axis";
}

TEST_F(ReceiverTest, AnOperatorsStopEndsAnySession) {
  arm();
  put(0, wire::Stop{.command = 9'000, .mode = wire::StopMode::abort});
  EXPECT_THAT(events(), ElementsAre("abort 0", "operator 1"));
  receiver.accept(0, 9'000);
  const auto answers = receiver.poll(now);
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].session, 0);
  EXPECT_EQ(std::get<wire::Reply>(answers[0].body).outcome, wire::Outcome::accepted);
  put(1, wire::Start{.command = 2});
  EXPECT_EQ(answer<wire::Reply>().refusal, Refusal::session_ended);
  put(0, wire::Stop{.command = 9'000});
  EXPECT_THAT(events(), IsEmpty()) << "repeated";
  put(0, wire::Stop{.command = 17});
  EXPECT_THAT(events(), ElementsAre("stop 0")) << "another operator's, lower number";
}

TEST_F(ReceiverTest, PublishesItsSession) {
  EXPECT_EQ(receiver.status({}).session, 0);
  put(download[0]);
  const wire::Message status = receiver.status({.tick = 5});
  EXPECT_EQ(status.executor, "feeder");
  EXPECT_EQ(status.session, 1);
  EXPECT_EQ(std::get<wire::Status>(status.body).tick, 5);
}

TEST_F(ReceiverTest, RejectsOptionsThatMakeNoSense) {
  EXPECT_THAT([] { Receiver({.executor = "my axis"}, 1); }, testing::Throws<InputError>());
  EXPECT_THAT([] { Receiver({.executor = "a", .credit = 0}, 1); }, testing::Throws<InputError>());
  EXPECT_THAT([] { Receiver({.executor = "a", .credit = 65}, 1); }, testing::Throws<InputError>());
}

}  // namespace
}  // namespace jounce::receiver_test
