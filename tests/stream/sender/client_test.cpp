// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/sender/client.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/detail/sender.hpp"
#include "jounce/stream/receiver/receiver_options.hpp"

#include "stream/harness.hpp"

namespace jounce::client_test {
namespace {

using namespace std::chrono_literals;
using test::World;
using testing::ElementsAre;
using wire::Refusal;

const wire::Key key{1, 2, 3};
const wire::Key other_key{1, 2, 4};

ReceiverOptions keyed() {
  ReceiverOptions options;
  options.key = key;
  return options;
}

TEST(Client, SendsCommandsInTheirOrder) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  EXPECT_TRUE(client.enable().ok());
  EXPECT_TRUE(
      client.command(command::MoveAbsolute{.position = 120, .dynamics = {.velocity = 200}}).ok());
  EXPECT_TRUE(client.command(command::Override{0.5}).ok());
  EXPECT_TRUE(client.stop().ok());
  const std::string session = std::to_string(client.session());
  EXPECT_TRUE(client.release().ok());
  EXPECT_THAT(world.executor->log,
              ElementsAre("enable " + session, "move_absolute " + session, "override " + session,
                          "stop " + session, "released " + session));
}

TEST(Client, EachOrderIsGivenOnceOnABadLink) {
  World world;
  LossyTransport bad(world.link,
                     {.seed = 5, .lost = 0.3, .doubled = 0.3, .corrupted = 0.1, .delayed = 0.3},
                     world.clock);
  Client client(bad, "feeder", {}, world.clock);
  std::vector<std::string> told;
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(client.command(command::MoveRelative{.distance = 1}).ok()) << i;
    told.push_back("move_relative " + std::to_string(client.session()));
  }
  EXPECT_EQ(world.executor->log, told);
}

TEST(Client, ReportsWhyTheAxisRejects) {
  World world;
  world.executor->objection = "not_enabled";
  Client client(world.link, "feeder", {}, world.clock);
  const CallOutcome outcome = client.command(command::MoveRelative{.distance = 5});
  EXPECT_EQ(outcome.error, StreamError::refused);
  EXPECT_EQ(outcome.refusal, Refusal::axis);
  EXPECT_EQ(outcome.cause, 41);
  EXPECT_EQ(outcome.reason, "axis: not_enabled");
}

TEST(Client, DoesNotTakeAnAxisThatIsOwned) {
  World world;
  Client owner(world.link, "feeder", {}, world.clock);
  ASSERT_TRUE(owner.enable().ok());
  Client second(world.link, "feeder", {}, world.clock);
  EXPECT_EQ(second.disable().refusal, Refusal::busy);
  EXPECT_TRUE(owner.command(command::MoveRelative{.distance = 5}).ok());
  ASSERT_TRUE(owner.release().ok());
  EXPECT_TRUE(second.disable().ok());
}

TEST(Client, BeginsAnewAfterALongPause) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  ASSERT_TRUE(client.enable().ok());
  const auto before = client.session();
  world.pass(2s);
  EXPECT_TRUE(client.command(command::MoveRelative{.distance = 1}).ok());
  EXPECT_NE(client.session(), before);
}

TEST(Client, ReportsAStopByAnOperatorOnce) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  ASSERT_TRUE(client.enable().ok());
  ASSERT_TRUE(operator_stop(world.link, "feeder", wire::StopMode::stop, 1s, {}, world.clock));
  const std::size_t obeyed = world.executor->log.size();
  const CallOutcome outcome = client.command(command::MoveRelative{.distance = 1});
  EXPECT_EQ(outcome.error, StreamError::stopped);
  EXPECT_EQ(outcome.cause, static_cast<std::int32_t>(Cause::stopped));
  EXPECT_EQ(outcome.reason, "another operator stopped the axis");
  EXPECT_EQ(world.executor->log.size(), obeyed) << "no effect";
  EXPECT_EQ(world.executor->pump.receiver().session(), 0);
  EXPECT_TRUE(client.command(command::MoveRelative{.distance = 1}).ok()) << "the program continues";
}

TEST(Client, ReportsThatTheEndOfItsSessionStoppedAMotion) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  ASSERT_TRUE(client.enable().ok());
  const auto session = client.session();
  world.pass(2s);
  world.executor->pump.receiver().stopped_with(session);
  const CallOutcome outcome = client.beat();
  EXPECT_EQ(outcome.error, StreamError::stopped);
  EXPECT_THAT(outcome.reason, testing::HasSubstr("no heartbeat of this program arrived in time"));
  EXPECT_TRUE(client.beat().ok());
}

// After many other sessions, the executor no longer has the reason for the end of a session.
TEST(Client, ReportsTheEndOfASessionThatTheExecutorHasForgotten) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  ASSERT_TRUE(client.enable().ok());
  ASSERT_TRUE(operator_stop(world.link, "feeder", wire::StopMode::stop, 1s, {}, world.clock));
  for (int i = 0; i < 20; ++i) {
    Client other(world.link, "feeder", {}, world.clock);
    ASSERT_TRUE(other.beat().ok());
  }
  EXPECT_EQ(client.enable().error, StreamError::stopped);
  EXPECT_TRUE(client.enable().ok());
}

TEST(Client, ReportsAMotionThatWasCutShortOnce) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  const auto status = [](Cause reason) {
    return wire::Status{.state = State::standstill,
                        .slave_position = 39.7,
                        .reason = static_cast<std::int32_t>(reason),
                        .units = {"s", "mm"}};
  };
  const auto moved = [&] { return client.command(command::MoveRelative{.distance = 1}).ok(); };
  EXPECT_TRUE(client.end_of_motion(status(Cause::stopped)).ok()) << "not a motion of this client";
  for (const Cause cause : {Cause::stopped, Cause::group_stopped, Cause::following_error}) {
    ASSERT_TRUE(moved());
    const CallOutcome outcome = client.end_of_motion(status(cause));
    EXPECT_EQ(outcome.error, StreamError::stopped);
    EXPECT_EQ(outcome.cause, static_cast<std::int32_t>(cause));
    EXPECT_THAT(outcome.reason, testing::StartsWith("the motion ended early, at 39.7 mm: "));
    EXPECT_TRUE(client.end_of_motion(status(cause)).ok()) << "once";
  }
  for (const Cause cause : {Cause::none, Cause::pass_ended, Cause::replaced}) {
    ASSERT_TRUE(moved());
    EXPECT_TRUE(client.end_of_motion(status(cause)).ok()) << name(cause);
  }
  ASSERT_TRUE(moved() && client.stop().ok());
  EXPECT_TRUE(client.end_of_motion(status(Cause::stopped)).ok()) << "its own stop";
  ASSERT_TRUE(moved() && client.command(command::Halt{}).ok());
  EXPECT_TRUE(client.end_of_motion(status(Cause::halted)).ok()) << "its own halt";
  client.adopt_motion();
  EXPECT_FALSE(client.end_of_motion(status(Cause::stopped)).ok());
}

TEST(Client, NeverRepeatsACommandToARestartedExecutor) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  ASSERT_TRUE(client.enable().ok());
  world.boot(101);
  EXPECT_EQ(client.command(command::MoveRelative{.distance = 1}).error, StreamError::restarted);
  EXPECT_TRUE(world.executor->log.empty());
  EXPECT_TRUE(client.command(command::MoveRelative{.distance = 1}).ok()) << "a new session";
  EXPECT_EQ(world.executor->log.size(), 1U);
}

TEST(Client, ReportsThatNoExecutorAnswers) {
  World world;
  world.shut_down();
  Client client(world.link, "feeder", {}, world.clock);
  EXPECT_EQ(client.enable().error, StreamError::no_answer);
  EXPECT_LT(world.now, 2100ms);
}

TEST(Client, RejectsValuesThatNoAxisCanTake) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  EXPECT_THROW(static_cast<void>(client.command(command::Override{2.5})), InputError);
  EXPECT_THROW(static_cast<void>(client.command(command::MoveAbsolute{.position = NAN})),
               InputError);
  EXPECT_THROW(static_cast<void>(client.command(
                   command::MoveRelative{.distance = 1, .dynamics = {.velocity = NAN}})),
               InputError)
      << "not the limit of the axis";
  EXPECT_THROW(static_cast<void>(client.command(
                   command::MoveRelative{.distance = 1, .dynamics = {.velocity = -1}})),
               InputError);
  EXPECT_THROW(static_cast<void>(client.command(command::GearIn{.numerator = 1, .denominator = 0})),
               InputError);
  EXPECT_THROW(Client(world.link, "two words"), InputError);
}

// ---- with a key ---------------------------------------------------------------------------------

TEST(Key, IsNeededForEveryCommand) {
  World world(keyed());
  Client owner(world.link, "feeder", {.key = key}, world.clock);
  EXPECT_TRUE(owner.enable().ok());
  EXPECT_TRUE(owner.release().ok());
  const std::size_t obeyed = world.executor->log.size();
  for (const auto& wrong : {std::optional<wire::Key>{}, std::optional{other_key}}) {
    Client stranger(world.link, "feeder", {.key = wrong}, world.clock);
    const CallOutcome outcome = stranger.enable();
    EXPECT_EQ(outcome.error, StreamError::no_answer);
    EXPECT_FALSE(
        operator_stop(world.link, "feeder", wire::StopMode::abort, 1s, wrong, world.clock));
  }
  EXPECT_EQ(world.executor->log.size(), obeyed);
  EXPECT_GT(world.executor->pump.rejects()[wire::Reject::not_authentic], 100U);
}

TEST(Key, AWholeTableArrives) {
  World world(keyed());
  StreamOptions options;
  options.key = key;
  EXPECT_TRUE(world.stream(test::plan_of(test::sine_table(5000)), 1, options).ok());
  EXPECT_FALSE(world.stream(test::plan_of(test::sine_table(10)), 2).ok()) << "without it";
}

TEST(Key, AnOperatorsStopIsObeyedOnce) {
  World world(keyed());
  EXPECT_TRUE(operator_stop(world.link, "feeder", wire::StopMode::stop, 1s, key, world.clock));
  EXPECT_THAT(world.executor->log, ElementsAre("stop 0"));
}

/// Sends every earlier packet to the executor once more.
void replay(World& world, const std::vector<Packet>& packets) {
  MemoryTransport attacker(world.network);
  for (const Packet& packet : packets) {
    attacker.send(packet.channel, packet.bytes);
    world.pass(1ms);
  }
}

TEST(Key, NothingThatWasRecordedHasAnyEffectAgain) {
  for (const bool with_key : {true, false}) {
    World world(with_key ? keyed() : ReceiverOptions{});
    const auto used = with_key ? std::optional{key} : std::nullopt;
    MemoryTransport tap(world.network);
    for (const auto lane : {wire::Lane::table, wire::Lane::command, wire::Lane::reply})
      tap.subscribe(wire::channel("feeder", lane), 100'000);
    Client client(world.link, "feeder", {.key = used}, world.clock);
    ASSERT_TRUE(client.enable().ok());
    ASSERT_TRUE(client.command(command::MoveRelative{.distance = 100}).ok());
    const auto held = operator_command(
        world.link, "feeder", wire::Command{.kind = CommandKind::hold}, 1s, used, world.clock);
    ASSERT_EQ(held.outcome, wire::Outcome::accepted);
    ASSERT_TRUE(client.release().ok());
    std::vector<Packet> recorded;
    while (auto packet = tap.receive(Nanos{})) recorded.push_back(*std::move(packet));
    ASSERT_GT(recorded.size(), 8U);

    // Into the free axis, in any order; beside the next session; after a restart.
    const std::size_t obeyed = world.executor->log.size();
    replay(world, recorded);
    std::reverse(recorded.begin(), recorded.end());
    replay(world, recorded);
    EXPECT_EQ(world.executor->log.size(), obeyed);
    Client next(world.link, "feeder", {.key = used}, world.clock);
    ASSERT_TRUE(next.enable().ok());
    replay(world, recorded);
    EXPECT_EQ(world.executor->log.size(), obeyed + 1);
    world.boot(101);
    replay(world, recorded);
    EXPECT_TRUE(world.executor->log.empty());
    EXPECT_EQ(world.executor->pump.receiver().session(), 0);
  }
}

TEST(Key, NobodysRepetitionKeepsADeadStreamersSessionAlive) {
  World world(keyed());
  MemoryTransport tap(world.network);
  tap.subscribe(wire::channel("feeder", wire::Lane::table), 1000);
  tap.subscribe(wire::channel("feeder", wire::Lane::command), 1000);
  Sender sender(test::plan_of(test::sine_table(100)), 1);
  world.link.subscribe(wire::channel("feeder", wire::Lane::reply), 64);
  Rejects rejects;
  const auto go = [&](Nanos time) {
    for (const Nanos end = world.now + time; world.now < end; world.pass(1ms)) {
      for (const auto& message : sender.poll(world.now)) send_message(world.link, message, key);
      while (const auto message = next_message(world.link, Nanos{}, rejects, key))
        sender.receive(*message, world.now);
    }
  };
  go(3s);
  ASSERT_TRUE(sender.at_goal()) << "it plays, and heartbeats hold the session";
  ASSERT_EQ(world.executor->pump.receiver().session(), 1);
  std::vector<Packet> recorded;
  while (auto packet = tap.receive(Nanos{})) recorded.push_back(*std::move(packet));
  MemoryTransport attacker(world.network);
  for (const Nanos end = world.now + 2s; world.now < end; world.pass(10ms))
    for (const Packet& packet : recorded) attacker.send(packet.channel, packet.bytes);
  EXPECT_EQ(world.executor->log.back(), "silent 1");
}

TEST(Key, AForgedAnswerIsIgnored) {
  World world(keyed());
  world.executor->answers = false;
  MemoryTransport attacker(world.network);
  Client client(world.link, "feeder", {.key = key, .patience = 200ms}, world.clock);
  // For every number and every session, a packet without the key does not count.
  world.each_turn = [&] {
    for (int number = 1; number < 4; ++number)
      send_message(
          attacker,
          {"feeder", client.session(),
           wire::Reply{.boot = 100, .command = number, .outcome = wire::Outcome::accepted}, 1});
  };
  EXPECT_EQ(client.enable().error, StreamError::command_timeout);
}

TEST(Key, AMessageIsNotItsOwnAnswer) {
  // Types have one direction each, and a signature covers the type.
  World world(keyed());
  MemoryTransport mirror(world.network);
  for (const auto lane : {wire::Lane::command, wire::Lane::reply})
    mirror.subscribe(wire::channel("feeder", lane), 1000);
  Client client(world.link, "feeder", {.key = key}, world.clock);
  ASSERT_TRUE(client.enable().ok());
  const std::size_t obeyed = world.executor->log.size();
  while (const auto packet = mirror.receive(Nanos{})) {
    mirror.send(wire::channel("feeder", wire::Lane::command), packet->bytes);
    mirror.send(wire::channel("feeder", wire::Lane::reply), packet->bytes);
    if (world.now > 1s) break;
    world.pass(1ms);
  }
  EXPECT_EQ(world.executor->log.size(), obeyed);
}

TEST(Client, ReleasesItsSessionAtItsEnd) {
  World world;
  std::string session;
  {
    Client client(world.link, "feeder", {}, world.clock);
    ASSERT_TRUE(client.enable().ok());
    session = std::to_string(client.session());
  }
  EXPECT_THAT(world.executor->log, ElementsAre("enable " + session, "released " + session));
  Client next(world.link, "feeder", {}, world.clock);
  EXPECT_TRUE(next.disable().ok()) << "the axis is free";
}

TEST(Client, DoesNotReleaseItsSessionForAnException) {
  World world;
  try {
    Client client(world.link, "feeder", {}, world.clock);
    ASSERT_TRUE(client.enable().ok());
    throw std::runtime_error("of the caller");
  } catch (const std::runtime_error&) {
  }
  ASSERT_EQ(world.executor->log.size(), 1U);
  EXPECT_THAT(world.executor->log[0], testing::StartsWith("enable "));
}

}  // namespace
}  // namespace jounce::client_test
