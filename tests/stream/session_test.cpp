// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/session.hpp"

#include <gtest/gtest.h>

namespace jounce::session_test {
namespace {

using namespace std::chrono_literals;
using wire::Refusal;

constexpr std::int64_t challenge = 100, next_challenge = 101;
constexpr SessionTimeouts timeouts{.usual = 1s, .hold = 200ms};

wire::Message from(std::int64_t session, wire::Body body, std::int64_t with = challenge) {
  return {"feeder", session, std::move(body), with};
}

/// Session 1, opened at 10 s.
Session opened() {
  Session session(timeouts);
  session.open(1, challenge);
  session.receive(10s);
  return session;
}

TEST(Session, OpensWithAHeaderAQueueOrAHeartbeat) {
  EXPECT_TRUE(opens_session(wire::Header{}));
  EXPECT_TRUE(opens_session(wire::Queue{}));
  EXPECT_TRUE(opens_session(wire::Heartbeat{.command = 1}));
  EXPECT_FALSE(opens_session(wire::Heartbeat{.command = 1, .release = true}));
  EXPECT_FALSE(opens_session(wire::Start{}));
  EXPECT_FALSE(opens_session(wire::Chunk{}));
}

TEST(Session, AFreeAxisAcceptsWhatOpensASession) {
  const Session session(timeouts);
  EXPECT_TRUE(session.is_free());
  EXPECT_FALSE(session.bars(from(1, wire::Header{}), challenge));
  EXPECT_EQ(session.bars(from(1, wire::Start{}), challenge).refusal, Refusal::unknown_session);
  EXPECT_EQ(session.bars(from(1, wire::Header{}, 7), challenge).refusal, Refusal::stale_challenge);
}

TEST(Session, BelongsToOneOwner) {
  const Session session = opened();
  EXPECT_EQ(session.id(), 1);
  EXPECT_FALSE(session.bars(from(1, wire::Start{}), challenge));
  EXPECT_EQ(session.bars(from(2, wire::Header{}), challenge).refusal, Refusal::busy);
  EXPECT_EQ(session.bars(from(2, wire::Stop{}), challenge).refusal, Refusal::busy);
  EXPECT_EQ(session.bars(from(1, wire::Start{}, 7), challenge).refusal, Refusal::stale_challenge);
}

TEST(Session, NeverOpensTwice) {
  Session session = opened();
  session.end();
  EXPECT_TRUE(session.is_free());
  EXPECT_EQ(session.owner(), 1) << "the last one";
  EXPECT_EQ(session.bars(from(1, wire::Header{}, next_challenge), next_challenge).refusal,
            Refusal::session_ended);
  EXPECT_FALSE(session.bars(from(2, wire::Header{}, next_challenge), next_challenge));
}

TEST(Session, TheLastOwnerMayStopUntilThereIsAnother) {
  Session session = opened();
  EXPECT_FALSE(session.is_of_last_owner(from(1, wire::Stop{}))) << "its session has not ended";
  session.end();
  EXPECT_TRUE(session.is_of_last_owner(from(1, wire::Stop{})));
  EXPECT_FALSE(session.bars(from(1, wire::Stop{}), next_challenge));
  EXPECT_TRUE(session.bars(from(1, wire::Start{}), next_challenge)) << "a stop only";
  EXPECT_TRUE(session.bars(from(1, wire::Stop{}, 7), next_challenge)) << "with its challenge only";
  session.open(2, next_challenge);
  EXPECT_EQ(session.bars(from(1, wire::Stop{}), next_challenge).refusal, Refusal::session_ended);
}

// The program of a session must learn of its end even if another program owns the axis by then.
TEST(Session, AnEndedOneIsAnsweredWithTheReasonOfItsEnd) {
  Session session = opened();
  session.end("another operator stopped the axis");
  for (const bool owned : {false, true}) {
    if (owned) session.open(2, next_challenge);
    const Refused no = session.bars(from(1, wire::Heartbeat{.command = 3}), next_challenge);
    EXPECT_EQ(no.refusal, Refusal::session_ended);
    EXPECT_EQ(no.reason, "another operator stopped the axis");
  }
}

TEST(Session, IsSilentAfterItsTimeout) {
  Session session = opened();
  EXPECT_FALSE(session.is_silent(11s));
  EXPECT_TRUE(session.is_silent(11s + 1ns));
  session.receive(11s);
  EXPECT_FALSE(session.is_silent(12s));
  session.end();
  EXPECT_FALSE(session.is_silent(99s)) << "a free axis waits for no one";
}

TEST(Session, AHoldToRunJogShortensTheTimeoutOfThisSession) {
  Session session = opened();
  session.hold();
  EXPECT_FALSE(session.is_silent(10s + 200ms));
  EXPECT_TRUE(session.is_silent(10s + 201ms));
  session.end();
  session.open(2, next_challenge);
  session.receive(20s);
  EXPECT_FALSE(session.is_silent(21s));
}

TEST(Session, RemembersTheLastSixteen) {
  Session session(timeouts);
  for (std::int64_t id = 1; id <= 17; ++id) {
    session.open(id, challenge);
    session.end();
  }
  EXPECT_FALSE(session.bars(from(1, wire::Header{}), challenge));
  for (std::int64_t id = 2; id <= 17; ++id)
    EXPECT_EQ(session.bars(from(id, wire::Header{}), challenge).refusal, Refusal::session_ended);
}

}  // namespace
}  // namespace jounce::session_test
