// SPDX-License-Identifier: Apache-2.0
// Streamer and executor together, over links of every quality, in virtual time.
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/stream/detail/sender.hpp"

#include "stream/harness.hpp"

namespace jounce::stream_test {
namespace {

using namespace std::chrono_literals;
using test::plan_of;
using test::sine_table;
using test::World;
using testing::ElementsAre;
using testing::IsEmpty;

void expect_stored(const World& world, const Table& table) {
  const auto stored = world.store().find(content_hash(table, test::move_units));
  ASSERT_TRUE(stored.has_value());
  EXPECT_TRUE(test::same(*stored->table, table)) << "bit for bit";
}

void expect_whole_run(const StreamOutcome& outcome, const World& world, const Table& table) {
  EXPECT_TRUE(outcome.ok()) << name(outcome.error) << ": " << outcome.reason;
  EXPECT_TRUE(outcome.downloaded && outcome.armed && outcome.started);
  EXPECT_EQ(outcome.progress.arrived, outcome.progress.chunks);
  EXPECT_THAT(world.executor->log, ElementsAre("ready 1", "arm 1", "start 1", "released 1"));
  expect_stored(world, table);
}

// ---- a good link --------------------------------------------------------------------------------

class StreamOfKnots : public testing::TestWithParam<std::size_t> {};

TEST_P(StreamOfKnots, ArrivesBitForBitWithoutARepeat) {
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite}) {
    World world;
    const Table table = sine_table(GetParam(), rule);
    const StreamOutcome outcome = world.stream(plan_of(table));
    expect_whole_run(outcome, world, table);
    EXPECT_EQ(outcome.progress.resent, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Knots, StreamOfKnots,
                         testing::Values(2, 5, 400, 401, 533, 534, 800, 801, 100'000),
                         testing::PrintToStringParamName());

TEST(Stream, StopsAtItsGoal) {
  World world;
  const Table table = sine_table(5);
  EXPECT_FALSE(world.stream(plan_of(table, StreamGoal::download)).armed);
  EXPECT_THAT(world.executor->log, ElementsAre("ready 1", "released 1"));
  world.executor->log.clear();
  EXPECT_FALSE(world.stream(plan_of(table, StreamGoal::arm), 2).started);
  EXPECT_THAT(world.executor->log, ElementsAre("ready 2", "arm 2", "released 2"));
}

TEST(Stream, SendsATableThatIsThereOnlyByName) {
  World world;
  const Table table = sine_table(100'000);
  EXPECT_TRUE(world.stream(plan_of(table)).ok());
  const Nanos first = world.now;
  EXPECT_TRUE(world.stream(plan_of(table), 2).ok());
  EXPECT_LT(world.now - first, first / 2);
}

TEST(Stream, TakesTheCallersWordForTheHashButTheExecutorDoesNot) {
  World world;
  StreamPlan plan = plan_of(sine_table(3000));
  plan.tables[0].hash = content_hash(plan.tables[0].table, plan.tables[0].units);
  EXPECT_TRUE(world.stream(plan).ok());
  expect_stored(world, plan.tables[0].table);
  (*plan.tables[0].hash)[31] ^= 1;
  const StreamOutcome outcome = world.stream(plan, 2);
  EXPECT_EQ(outcome.refusal, wire::Refusal::hash_mismatch) << outcome.reason;
  EXPECT_FALSE(outcome.armed);
}

TEST(Stream, BringsCamAndMaster) {
  World world;
  StreamPlan plan{
      .executor = "feeder",
      .tables = {{sine_table(361, Interpolation::quintic_hermite, Domain::master), test::cam_units},
                 {sine_table(2000), {"s", "deg"}}},
      .mode = wire::ArmMode::follow_table};
  EXPECT_TRUE(world.stream(plan).ok());
  EXPECT_THAT(world.executor->log,
              ElementsAre("ready 1", "ready 1", "arm 1", "start 1", "released 1"));
}

// ---- bad links ----------------------------------------------------------------------------------

struct BadLink {
  const char* label;
  LossSpec spec;
};

void PrintTo(const BadLink& link, std::ostream* out) {
  *out << link.label;
}

class StreamOverABadLink : public testing::TestWithParam<BadLink> {};

TEST_P(StreamOverABadLink, LosesNothing) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    World world;
    LossSpec spec = GetParam().spec;
    spec.seed = seed;
    LossyTransport bad(world.link, spec, world.clock);
    const Table table = sine_table(30'000, Interpolation::quintic_hermite);
    StreamOptions many_chunks;
    many_chunks.sender.pace.chunk = 1600;
    const StreamOutcome outcome = stream_tables(bad, plan_of(table), many_chunks, world.clock, 1);
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_whole_run(outcome, world, table);
    if (spec.lost > 0) {
      EXPECT_GT(outcome.progress.resent, 0U);
    }
    if (spec.corrupted > 0) {
      EXPECT_GT(world.executor->pump.rejects()[wire::Reject::wrong_checksum], 0U);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Links, StreamOverABadLink,
    testing::Values(BadLink{"LosesAFifth", {.lost = 0.2}}, BadLink{"LosesHalf", {.lost = 0.5}},
                    BadLink{"DoublesHalf", {.doubled = 0.5}}, BadLink{"DoublesAll", {.doubled = 1}},
                    BadLink{"Reorders", {.delayed = 0.5}},
                    BadLink{"IsSlow", {.delayed = 1, .delay = 80ms}},
                    BadLink{"CorruptsATenth", {.corrupted = 0.1}},
                    BadLink{"DoesEverything",
                            {.lost = 0.15, .doubled = 0.2, .corrupted = 0.1, .delayed = 0.5}}),
    [](const auto& each) { return std::string(each.param.label); });

/// Changes one value of every second chunk and makes the checksum right again: what no checksum
/// can find.
class ForgingTransport : public Transport {
 public:
  explicit ForgingTransport(Transport& link) : link_(link) {}
  void subscribe(const std::string& channel, int capacity) override {
    link_.subscribe(channel, capacity);
  }
  void send(const std::string& /*of the message*/, std::span<const std::byte> bytes) override {
    auto message = std::get<wire::Message>(wire::decode(bytes));
    auto* const chunk = std::get_if<wire::Chunk>(&message.body);
    if (chunk != nullptr && chunk->seq % 2 == 1) chunk->values.back() += 1e-6;
    send_message(link_, message);
  }
  std::optional<Packet> receive(Nanos timeout) override { return link_.receive(timeout); }

 private:
  Transport& link_;
};

TEST(Stream, TheHashFindsWhatTheChecksumCannot) {
  World world;
  ForgingTransport forging(world.link);
  const StreamOutcome outcome =
      stream_tables(forging, plan_of(sine_table(5000)), {}, world.clock, 1);
  EXPECT_EQ(outcome.error, StreamError::refused);
  EXPECT_EQ(outcome.refusal, wire::Refusal::hash_mismatch);
  world.pass(2s);
  EXPECT_THAT(world.executor->log, testing::Not(testing::Contains("ready 1")));
  EXPECT_EQ(world.store().bytes(), 0U);
}

// ---- streamers and executors that go away -------------------------------------------------------

/// A streamer that is not driven to its end.
struct Streamer {
  Streamer(World& in, Table table, std::int64_t session)
      : world(in), link(in.network), sender(plan_of(std::move(table)), session) {
    link.subscribe(wire::channel("feeder", wire::Lane::reply), 64);
  }
  void turn() {
    for (const auto& message : sender.poll(world.now)) send_message(link, message);
    for (Rejects rejects; const auto message = next_message(link, Nanos{}, rejects);)
      sender.receive(*message, world.now);
  }
  /// Until a share of its chunks has arrived.
  void run_until(double share) {
    const auto& progress = sender.outcome().progress;
    for (int i = 0; i < 10'000; ++i) {
      if (static_cast<double>(progress.arrived) >= share * static_cast<double>(progress.chunks))
        return;
      turn();
      world.pass(1ms);
    }
    FAIL() << "no progress";
  }

  World& world;
  MemoryTransport link;
  Sender sender;
};

TEST(Stream, AStreamerThatDiesHalfWayLeavesNothingBehind) {
  World world;
  const Table table = sine_table(50'000);
  {
    Streamer dies(world, table, 1);
    dies.run_until(0.5);
  }
  EXPECT_GT(world.store().bytes(), 0U);
  world.pass(1100ms);
  EXPECT_THAT(world.executor->log, ElementsAre("silent 1"));
  EXPECT_EQ(world.store().bytes(), 0U);
  EXPECT_TRUE(world.stream(plan_of(table), 2).ok());
  EXPECT_THAT(world.executor->log,
              ElementsAre("silent 1", "ready 2", "arm 2", "start 2", "released 2"));
}

TEST(Stream, ASecondStreamerIsRejectedWhileTheFirstLives) {
  World world;
  const Table table = sine_table(50'000);
  Streamer first(world, table, 1);
  first.run_until(0.3);
  world.each_turn = [&] { first.turn(); };
  const StreamOutcome second = world.stream(plan_of(sine_table(10)), 2);
  EXPECT_EQ(second.error, StreamError::refused);
  EXPECT_EQ(second.refusal, wire::Refusal::busy);
  world.pass(5s);
  EXPECT_TRUE(first.sender.at_goal()) << "the first is not disturbed, and holds its session";
  EXPECT_THAT(world.executor->log, ElementsAre("ready 1", "arm 1", "start 1"));
}

TEST(Stream, ADownloadOutlivesARestartOfTheExecutor) {
  World world;
  const Table table = sine_table(50'000);
  Streamer streamer(world, table, 1);
  streamer.run_until(0.5);
  world.boot(101);
  streamer.run_until(1);
  for (int i = 0; i < 100; ++i) {
    streamer.turn();
    world.pass(1ms);
  }
  EXPECT_TRUE(streamer.sender.at_goal());
  EXPECT_THAT(world.executor->log, ElementsAre("ready 1", "arm 1", "start 1"));
  expect_stored(world, table);
}

TEST(Stream, ARestartAfterTheStartIsReported) {
  World world;
  Streamer streamer(world, sine_table(1000), 1);
  for (int i = 0; i < 50; ++i) {
    streamer.turn();
    world.pass(1ms);
  }
  ASSERT_TRUE(streamer.sender.at_goal());
  world.boot(101);
  for (int i = 0; i < 200; ++i) {
    streamer.turn();
    world.pass(1ms);
  }
  EXPECT_EQ(streamer.sender.outcome().error, StreamError::restarted);
  EXPECT_THAT(world.executor->log, IsEmpty());
}

TEST(Stream, AHeldSessionLivesByItsHeartbeats) {
  World world;
  Streamer streamer(world, sine_table(1000), 1);
  for (int i = 0; i < 10'000; ++i) {
    streamer.turn();
    world.pass(1ms);
  }
  EXPECT_TRUE(streamer.sender.at_goal());
  EXPECT_EQ(world.executor->pump.receiver().session(), 1);
}

/// A tap that keeps the messages to an executor.
struct Recorder {
  explicit Recorder(World& world) : link(world.network) {
    link.subscribe(wire::channel("feeder", wire::Lane::table), 100'000);
    link.subscribe(wire::channel("feeder", wire::Lane::command), 100'000);
  }
  std::vector<Packet> packets() {
    std::vector<Packet> all;
    while (auto packet = link.receive(Nanos{})) all.push_back(*std::move(packet));
    return all;
  }
  MemoryTransport link;
};

TEST(Stream, MessagesOfAStaleSessionHaveNoEffect) {
  World world;
  Recorder recorder(world);
  ASSERT_TRUE(world.stream(plan_of(sine_table(1000)), 1).ok());
  const auto stale = recorder.packets();
  ASSERT_GT(stale.size(), 5U);

  // All of it again: before, while and after another session lives.
  MemoryTransport echo(world.network);
  const auto repeat = [&] {
    for (const Packet& packet : stale) echo.send(packet.channel, packet.bytes);
  };
  world.executor->log.clear();
  repeat();
  world.pass(10ms);
  EXPECT_THAT(world.executor->log, IsEmpty());
  world.each_turn = repeat;
  EXPECT_TRUE(world.stream(plan_of(sine_table(2000)), 2).ok());
  EXPECT_THAT(world.executor->log, ElementsAre("ready 2", "arm 2", "start 2", "released 2"));
  world.executor->log.clear();
  world.pass(100ms);
  EXPECT_THAT(world.executor->log, IsEmpty());
}

// ---- named failures -----------------------------------------------------------------------------

TEST(Stream, ReportsThatNoExecutorAnswers) {
  World world;
  world.shut_down();
  const StreamOutcome outcome = world.stream(plan_of(sine_table(5)));
  EXPECT_EQ(outcome.error, StreamError::no_answer);
  EXPECT_LT(world.now, 5100ms);
}

TEST(Stream, ReportsThatTheExecutorEnded) {
  World world;
  StreamOptions options;
  options.progress = [&](const StreamProgress& progress) {
    if (progress.arrived > progress.chunks / 2) world.shut_down();
  };
  EXPECT_EQ(world.stream(plan_of(sine_table(50'000)), 1, options).error, StreamError::contact_lost);
}

TEST(Stream, ReportsThatTheAxisDoesNotDecide) {
  World world;
  world.executor->answers = false;
  const StreamOutcome outcome = world.stream(plan_of(sine_table(5)));
  EXPECT_EQ(outcome.error, StreamError::command_timeout);
  EXPECT_TRUE(outcome.downloaded);
  world.pass(10ms);
  EXPECT_THAT(world.executor->log, ElementsAre("ready 1", "arm 1", "released 1"));
}

TEST(Stream, GivesTheAxissObjectionOn) {
  World world;
  world.executor->objection = "start_position";
  const StreamOutcome outcome = world.stream(plan_of(sine_table(5)));
  EXPECT_EQ(outcome.refusal, wire::Refusal::axis);
  EXPECT_EQ(outcome.cause, 41);
  EXPECT_EQ(outcome.reason, "axis: start_position");
}

TEST(Stream, KeepsToItsTotalTime) {
  World world;
  world.executor->answers = false;
  StreamOptions options;
  options.total = 1s;
  EXPECT_EQ(world.stream(plan_of(sine_table(5)), 1, options).error, StreamError::out_of_time);
  EXPECT_LT(world.now, 1010ms);
}

TEST(Stream, ACancelledStreamStopsWhatItArmed) {
  World world;
  StreamOptions options;
  options.cancelled = [&] { return !world.executor->log.empty(); };
  const StreamOutcome outcome = world.stream(plan_of(sine_table(5)), 1, options);
  EXPECT_TRUE(outcome.ok() && outcome.stopped && !outcome.started);
  EXPECT_EQ(world.executor->log.back(), "released 1");
  EXPECT_THAT(world.executor->log, testing::Contains("stop 1"));
}

TEST(Stream, ACancelledDownloadJustLeaves) {
  World world;
  StreamOptions options;
  options.cancelled = [&] { return world.now > 10ms; };
  const StreamOutcome outcome = world.stream(plan_of(sine_table(100'000)), 1, options);
  EXPECT_FALSE(outcome.downloaded);
  EXPECT_THAT(world.executor->log, ElementsAre("released 1"));
  EXPECT_EQ(world.store().bytes(), 0U);
}

}  // namespace
}  // namespace jounce::stream_test
