// SPDX-License-Identifier: Apache-2.0
// Queues of rows: what the executor takes in, and a rolling stream through a bad link.
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/detail/row_sender.hpp"
#include "jounce/stream/detail/sender.hpp"

#include "stream/harness.hpp"
#include "stream/sender/rows.hpp"
#include "stream/src/receiver/row_intake.hpp"

namespace jounce::row_test {
namespace {

using namespace std::chrono_literals;
using test::Player;
using test::queue_of;
using test::row;
using test::source_of;
using test::World;
using testing::ElementsAre;
using testing::IsEmpty;
using wire::Refusal;
using wire::Row;
using wire::Rows;

Rows message(std::uint32_t seq, std::size_t first, std::size_t count) {
  Rows rows{.seq = seq, .first_row = first};
  for (std::size_t i = first; i < first + count; ++i) rows.rows.push_back(row(i));
  return rows;
}

std::vector<double> ends(const std::vector<Rows>& taken) {
  std::vector<double> x;
  for (const Rows& rows : taken)
    for (const Row& each : rows.rows) x.push_back(each.x_end);
  return x;
}

// ---- RowIntake ----------------------------------------------------------------------------------

TEST(RowIntake, PutsMessagesInOrderAndTakesEachOnce) {
  RowIntake intake(queue_of(100), 8);
  intake.add(message(1, 2, 1));
  intake.add(message(2, 3, 2));
  EXPECT_THAT(intake.take(), IsEmpty());
  EXPECT_EQ(intake.ack(1).mask[0], 0b11U);
  intake.add(message(0, 0, 2));
  intake.add(message(0, 0, 2));
  intake.add(message(1, 2, 1));
  EXPECT_EQ(ends(intake.take()), ends({message(0, 0, 5)}));
  EXPECT_EQ(intake.ack(1).next[0], 3U);
  EXPECT_EQ(intake.ack(1).space[0], 195U) << "both banks of 100 are one stream";
}

TEST(RowIntake, TakesNoMoreThanThereIsRoomFor) {
  RowIntake intake(queue_of(2), 8);
  intake.add(message(0, 0, 3));
  intake.add(message(1, 3, 2));
  EXPECT_EQ(ends(intake.take()).size(), 3U) << "five rows into four places: not the second message";
  EXPECT_EQ(intake.ack(1).next[0], 1U);
  EXPECT_EQ(intake.ack(1).space[0], 1U);
  EXPECT_TRUE(intake.level({.freed = {2, 0}, .played = 2}));
  EXPECT_FALSE(intake.level({.freed = {2, 0}, .played = 2})) << "no news";
  EXPECT_EQ(intake.ack(1).space[0], 3U);
  intake.add(message(1, 3, 2));
  EXPECT_EQ(intake.ack(1).next[0], 2U);
}

TEST(RowIntake, HoldsNoMoreMessagesThanItsCredit) {
  RowIntake intake(queue_of(1000), 4);
  for (std::uint32_t seq = 1; seq < 10; ++seq) intake.add(message(seq, seq, 1));
  EXPECT_EQ(intake.ack(1).mask[0], 0b111U) << "messages 1 to 3";
}

TEST(RowIntake, NamesTheRowThatItRejects) {
  const auto refused = [](auto change) {
    RowIntake intake(queue_of(100), 8);
    intake.add(message(0, 0, 10));
    static_cast<void>(intake.take());
    Rows rows = message(1, 10, 5);
    change(rows);
    intake.add(rows);
    const auto ack = intake.ack(1);
    EXPECT_THAT(intake.take(), IsEmpty()) << "nothing of that message";
    return std::string(name(ack.refusal)) + " " + std::to_string(ack.row) + " " + ack.reason;
  };
  EXPECT_EQ(refused([](Rows& r) { r.rows[2].x_end = r.rows[1].x_end; }),
            "bad_row 12 row 13 does not end later than the previous row");
  EXPECT_EQ(refused([](Rows& r) { r.rows[0].x_end = 0.01; }),
            "bad_row 10 row 11 does not end later than the previous row");
  EXPECT_EQ(refused([](Rows& r) { r.rows[4].v_end = NAN; }),
            "bad_row 14 row 15 has a value that is not finite");
  EXPECT_EQ(refused([](Rows& r) { r.rows[1].last = true; }),
            "bad_row 12 row 13 follows the last row");
  EXPECT_EQ(refused([](Rows& r) { r.first_row = 9; }),
            "bad_rows -1 message 1 states that 9 rows precede it, but 10 have arrived");
  EXPECT_EQ(refused([](Rows& r) { r.bank = 1; }), "bad_rows -1 a dynamic queue has bank 0 only");
}

TEST(RowIntake, AQuadraticRowMayLeaveAVelocityOpen) {
  RowIntake intake(queue_of(100), 8);
  Rows rows = message(0, 0, 2);
  rows.rows[1].order = wire::RowOrder::quadratic;
  rows.rows[1].v_start = rows.rows[1].v_end = NAN;
  intake.add(rows);
  EXPECT_FALSE(intake.refused());
}

TEST(RowIntake, ABankBeginsAnewAfterAClear) {
  wire::Queue fifo = queue_of(4);
  fifo.mode = wire::QueueMode::static_;
  RowIntake intake(fifo, 8);
  intake.add(message(0, 0, 4));
  Rows other = message(0, 0, 2);
  other.bank = 1;
  intake.add(other);
  EXPECT_EQ(intake.ack(1).space[0], 0U);
  EXPECT_EQ(intake.ack(1).space[1], 2U) << "each bank by itself";
  intake.clear(0, 3);  // messages 1 and 2 are still on their way, and void
  Rows late = message(1, 4, 1);
  intake.add(late);
  EXPECT_EQ(intake.ack(1).next[0], 3U);
  EXPECT_EQ(intake.ack(1).space[0], 4U);
  Rows fresh = message(3, 0, 4);
  fresh.first_row = 6;
  intake.add(fresh);
  EXPECT_FALSE(intake.refused()) << intake.ack(1).reason;
  EXPECT_EQ(intake.ack(1).next[0], 4U);
  EXPECT_EQ(intake.ack(1).space[0], 0U);
}

// ---- a rolling stream ---------------------------------------------------------------------------

void expect_rows(const std::vector<Row>& rows, std::size_t count) {
  ASSERT_EQ(rows.size(), count);
  for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(rows[i], row(i, i + 1 == count)) << "row " << i;
}

TEST(RollingStream, RefillsTwoFifosOfThirtyTwoWhileTheyPlay) {
  // Googol's manual, example 7-4: 126 segments of 16 ms through 2 x 32 places, started when full.
  World world;
  Player player(world, 16ms);
  const RowOutcome outcome =
      stream_rows(world.link, {"feeder", queue_of(32, 64), source_of(126)}, {}, world.clock, 1);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_TRUE(outcome.progress.finished);
  EXPECT_EQ(outcome.progress.played, 126U);
  EXPECT_EQ(outcome.progress.underruns, 0);
  EXPECT_EQ(player.most_waiting, 64U) << "full when it started, and never more";
  EXPECT_EQ(player.starved, 0);
  expect_rows(world.executor->rows, 126);
  EXPECT_EQ(world.executor->log.front(), "queue 1");
  EXPECT_EQ(world.executor->log.back(), "released 1");
}

TEST(RollingStream, StartsWithAllThereIsIfThatIsLessThanThePrefill) {
  World world;
  const Player player(world, 16ms);
  const RowOutcome outcome =
      stream_rows(world.link, {"feeder", queue_of(32, 64), source_of(5)}, {}, world.clock, 1);
  EXPECT_TRUE(outcome.progress.finished) << outcome.reason;
  expect_rows(world.executor->rows, 5);
}

TEST(RollingStream, EveryRowArrivesOnceInOrderOnABadLink) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world;
    Player player(world, 1ms);
    LossyTransport bad(
        world.link, {.seed = seed, .lost = 0.3, .doubled = 0.2, .corrupted = 0.05, .delayed = 0.3},
        world.clock);
    const RowOutcome outcome =
        stream_rows(bad, {"feeder", queue_of(1000, 1500), source_of(5'000)}, {}, world.clock, 1);
    EXPECT_TRUE(outcome.progress.finished) << outcome.reason;
    EXPECT_LE(player.most_waiting, 2000U);
    EXPECT_EQ(player.starved, 0);
    expect_rows(world.executor->rows, 5'000);
  }
}

/// Gives 100 rows, then nothing for a while, then the rest.
RowSource halting_source(World& world, std::size_t count) {
  return [&world, next = std::size_t{0}, count](std::size_t most) mutable {
    std::vector<Row> rows;
    const std::size_t end = world.now < 3s ? 100 : count;
    for (; next < end && rows.size() < most; ++next) rows.push_back(row(next, next + 1 == count));
    return rows;
  };
}

TEST(RollingStream, ReportsASlowSourceAndStops) {
  World world;
  const Player player(world, 10ms);
  const RowOutcome outcome = stream_rows(
      world.link, {"feeder", queue_of(100, 50), halting_source(world, 300)}, {}, world.clock, 1);
  EXPECT_EQ(outcome.error, StreamError::underrun);
  EXPECT_EQ(outcome.progress.underruns, 1);
  EXPECT_EQ(outcome.progress.played, 100U);
  EXPECT_THAT(world.executor->log, testing::Contains("stop 1"));
  EXPECT_EQ(world.executor->log.back(), "released 1") << "the next streamer finds the axis free";
  EXPECT_EQ(world.executor->pump.receiver().session(), 0);
}

TEST(RollingStream, AnExceptionOfTheCallerStopsTheAxisFirst) {
  World world;
  const Player player(world, 10ms);
  RowOptions options;
  options.progress = [&](const RowProgress& now) {
    if (now.played > 50) throw std::runtime_error("of the caller");
  };
  EXPECT_THROW(
      static_cast<void>(stream_rows(world.link, {"feeder", queue_of(100, 50), source_of(5'000)},
                                    options, world.clock, 1)),
      std::runtime_error);
  EXPECT_THAT(world.executor->log, testing::Contains("stop 1"));
}

TEST(RollingStream, ContinuesAfterAnUnderrunIfPermitted) {
  World world;
  const Player player(world, 10ms);
  const RowOutcome outcome = stream_rows(world.link,
                                         {.executor = "feeder",
                                          .queue = queue_of(100, 50),
                                          .rows = halting_source(world, 300),
                                          .resume = true},
                                         {}, world.clock, 1);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_TRUE(outcome.progress.finished);
  EXPECT_EQ(outcome.progress.underruns, 1);
  expect_rows(world.executor->rows, 300);
  EXPECT_THAT(world.executor->log, testing::Contains("reset 1"));
  EXPECT_THAT(world.executor->log, testing::Contains("resume 1"));
}

TEST(RollingStream, ASourceThatDriesUpEndsItThoughItMayResume) {
  World world;
  const Player player(world, 10ms);
  const RowOutcome outcome = stream_rows(world.link,
                                         {.executor = "feeder",
                                          .queue = queue_of(100, 50),
                                          .rows = source_of(100, 300),
                                          .resume = true},
                                         {}, world.clock, 1);
  EXPECT_EQ(outcome.error, StreamError::underrun) << outcome.reason;
  EXPECT_EQ(outcome.progress.underruns, 1);
  EXPECT_LT(world.now, 13s) << "two to play, ten of patience";
}

TEST(RollingStream, ASourceThatNeverFillsThePrefillEndsItUnstarted) {
  World world;
  const Player player(world, 10ms);
  const RowOutcome outcome = stream_rows(
      world.link, {"feeder", queue_of(100, 50), source_of(49, 300)}, {}, world.clock, 1);
  EXPECT_EQ(outcome.error, StreamError::stalled) << outcome.reason;
  EXPECT_FALSE(outcome.progress.started);
  EXPECT_LT(world.now, 11s);
}

TEST(RollingStream, WhatWasStoppedIsNotCalledAnUnderrun) {
  for (const bool resume : {false, true}) {
    for (const bool by_operator : {false, true}) {
      World world;
      const Player player(world, 10ms);
      MemoryTransport other(world.network);
      world.each_turn = [&, turn = world.each_turn] {
        if (world.now < 500ms) return turn();
        if (by_operator) {
          send_message(other, {"feeder", 0, wire::Stop{.command = 9}});
        } else {
          world.executor->pump.receiver().level(
              wire::first_queue, {.freed = {player.played, 0}, .progress = wire::Progress::broken});
        }
      };
      const RowOutcome outcome = stream_rows(world.link,
                                             {.executor = "feeder",
                                              .queue = queue_of(100, 50),
                                              .rows = source_of(5000),
                                              .resume = resume},
                                             {}, world.clock, 1);
      EXPECT_EQ(outcome.error, StreamError::stopped) << outcome.reason;
      EXPECT_EQ(outcome.progress.underruns, 0);
      EXPECT_LT(world.now, 1s);
    }
  }
}

TEST(RollingStream, ARejectedRowStopsItAndIsNamed) {
  World world;
  const Player player(world, 1ms);
  bool refused = false;
  world.each_turn = [&, turn = world.each_turn] {
    turn();
    if (!refused && world.executor->rows.size() > 500) {
      refused = true;
      world.executor->pump.receiver().refuse_row(64, 450, "row 451: velocity 600, limit 500");
    }
  };
  const RowOutcome outcome =
      stream_rows(world.link, {"feeder", queue_of(100, 50), source_of(5000)}, {}, world.clock, 1);
  EXPECT_EQ(outcome.refusal, Refusal::bad_row);
  EXPECT_EQ(outcome.reason, "bad_row: row 451: velocity 600, limit 500");
}

TEST(RollingStream, ARestartEndsIt) {
  World world;
  const Player player(world, 1ms);
  world.each_turn = [&, turn = world.each_turn] {
    if (world.executor->rows.size() > 1000) world.boot(101);
    turn();
  };
  const RowOutcome outcome =
      stream_rows(world.link, {"feeder", queue_of(100, 50), source_of(5000)}, {}, world.clock, 1);
  EXPECT_EQ(outcome.error, StreamError::restarted);
  EXPECT_THAT(world.executor->log, IsEmpty()) << "nothing of it reaches the executor's new life";
}

TEST(RollingStream, NoStartWithoutItsPrefill) {
  Receiver receiver({.executor = "feeder"}, 77);
  const auto put = [&](wire::Body body) {
    receiver.receive({"feeder", 1, std::move(body), receiver.challenge()}, 1s);
    wire::Reply reply;
    for (const auto& message : receiver.poll(1s))
      if (const auto* body_of = std::get_if<wire::Reply>(&message.body)) reply = *body_of;
    return reply;
  };
  put(queue_of(100, 50));
  put(message(0, 0, 49));
  put(wire::Arm{.command = 1, .mode = wire::ArmMode::queue, .queue = 64});
  receiver.accept(1, 1);
  EXPECT_EQ(put(wire::Start{.command = 2}).refusal, Refusal::prefill_missing);
  put(message(1, 49, 1));
  EXPECT_EQ(put(wire::Start{.command = 3}).outcome, wire::Outcome::pending);
  EXPECT_EQ(put(wire::Arm{.command = 4, .mode = wire::ArmMode::queue, .queue = 65}).refusal,
            Refusal::queue_missing);
  EXPECT_EQ(put(wire::Command{.command = 5, .kind = CommandKind::queue_end, .value = {99}}).refusal,
            Refusal::queue_missing);
}

TEST(RollingStream, BoundsQueuesAndTheirRowsBeforeTakingMemory) {
  Receiver receiver({.executor = "feeder", .most_rows = 1000, .most_queues = 2}, 77);
  const auto refusal = [&](const wire::Queue& queue) {
    receiver.receive({"feeder", 1, queue, receiver.challenge()}, 1s);
    Refusal last = Refusal::none;
    for (const auto& message : receiver.poll(1s)) {
      const auto* const ack = std::get_if<wire::QueueAck>(&message.body);
      if (ack != nullptr && ack->queue == queue.queue && ack->refusal != Refusal::none)
        last = ack->refusal;
    }
    return last;
  };
  wire::Queue queue = queue_of(1001);
  EXPECT_EQ(refusal(queue), Refusal::too_large);
  queue.capacity = 1000;
  EXPECT_EQ(refusal(queue), Refusal::none);
  EXPECT_EQ(refusal(queue), Refusal::none) << "the same once more";
  queue.capacity = 999;
  EXPECT_EQ(refusal(queue), Refusal::bad_queue) << "another one under its index";
  queue.queue = 65;
  EXPECT_EQ(refusal(queue), Refusal::none);
  queue.queue = 66;
  EXPECT_EQ(refusal(queue), Refusal::out_of_memory);
  queue.queue = 67;
  queue.prefill = 5000;
  EXPECT_EQ(refusal(queue), Refusal::bad_queue);
  queue = queue_of(10);
  queue.queue = 68;
  queue.units.x = "ms";
  EXPECT_EQ(refusal(queue), Refusal::wrong_unit);
}

// ---- swaps --------------------------------------------------------------------------------------

TEST(Swap, WaitsUntilTheOneBeforeHasTakenPlace) {
  World world;
  const Table a = test::sine_table(100), b = test::sine_table(200);
  const std::vector<Sha256> hashes{content_hash(a, test::move_units),
                                   content_hash(b, test::move_units)};
  StreamPlan plan = test::plan_of(a);
  plan.tables.push_back({b, test::move_units});
  plan.swaps = {{.slave = 1}, {.slave = 0}, {.slave = 0}};
  // An axis whose table ends every 100 ms.
  const std::size_t order[] = {0, 1, 0, 0};
  std::size_t playing = 0, started = 0;
  Nanos swapped{};
  world.each_turn = [&] {
    const auto& starts = world.executor->starts;
    if (starts.size() > started) {
      ASSERT_EQ(starts.size(), started + 1);
      ASSERT_TRUE(started == 0 || playing + 1 == started) << "before the last one took place";
      started = starts.size();
      swapped = world.now;
    }
    if (started > 0 && playing + 1 < started && world.now - swapped > 100ms) playing = started - 1;
    wire::Status status{.next = started > playing + 1 ? wire::Next::waiting : wire::Next::nothing};
    if (started > 0)
      std::copy_n(hashes[order[playing]].begin(), status.table.size(), status.table.begin());
    world.executor->pump.publish(status);
  };
  const StreamOutcome outcome = world.stream(plan);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_EQ(outcome.swaps, 3U);
  ASSERT_EQ(world.executor->starts.size(), 4U);
  EXPECT_EQ(world.executor->starts[0].when, StartAt::tick);
  EXPECT_EQ(world.executor->starts[3].when, StartAt::end_of_table);
}

// An axis in a fault, or stopped by somebody else, never comes to the boundary.
TEST(Swap, EndsWhereTheAxisHasStoppedBeforeIt) {
  World world;
  StreamPlan plan = test::plan_of(test::sine_table(100));
  plan.tables.push_back({test::sine_table(200), test::move_units});
  plan.swaps = {{.slave = 1}};
  world.each_turn = [&] {
    wire::Status status{.state = State::discrete_motion};
    if (!world.executor->starts.empty()) status = {.state = State::error_stop, .last_error = 12};
    world.executor->pump.publish(status);
  };
  const StreamOutcome outcome = world.stream(plan);
  EXPECT_EQ(outcome.error, StreamError::stopped) << outcome.reason;
  EXPECT_EQ(outcome.cause, 12);
}

TEST(Swap, IsCheckedBeforeAnythingIsSent) {
  StreamPlan plan = test::plan_of(test::sine_table(100));
  plan.swaps = {{.slave = 1}};
  EXPECT_THROW(Sender(plan, 1), InputError) << "no such table";
  plan.tables.push_back(
      {test::sine_table(10, Interpolation::linear, Domain::master), test::cam_units});
  EXPECT_THROW(Sender(plan, 1), InputError) << "over master, cannot play by itself";
}

}  // namespace
}  // namespace jounce::row_test
