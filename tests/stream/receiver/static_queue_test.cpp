// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/receiver/static_queue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "stream/sender/rows.hpp"

namespace jounce::static_queue_test {
namespace {

using namespace std::chrono_literals;
using test::World;
using wire::Refusal;

wire::Queue fifos(std::uint32_t capacity) {
  return {.units = {"s", "mm"}, .mode = wire::QueueMode::static_, .capacity = capacity};
}

std::vector<wire::Row> rows_of(std::size_t count) {
  return test::source_of(count)(count);
}

TEST(StaticQueue, FillsArmsStartsSwitchesAndClears) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  StaticQueue queue(client, fifos(500));
  ASSERT_TRUE(queue.open().ok());
  EXPECT_TRUE(queue.fill(0, rows_of(450)).ok());
  EXPECT_TRUE(queue.fill(1, rows_of(3)).ok());
  EXPECT_TRUE(queue.arm().ok());
  EXPECT_TRUE(queue.start().ok());
  EXPECT_TRUE(queue.switch_over().ok());
  EXPECT_TRUE(queue.clear(0).ok());
  EXPECT_TRUE(queue.fill(0, rows_of(500)).ok()) << "as much free space as at first";
  ASSERT_EQ(world.executor->rows.size(), 953U);
  EXPECT_EQ(world.executor->rows[452], test::row(2, true));
  EXPECT_EQ(world.executor->rows[453], test::row(0)) << "from x = 0 again";
  const auto level = queue.level();
  ASSERT_TRUE(level.has_value());
  EXPECT_EQ(level->space[0], 0U);
  EXPECT_EQ(level->space[1], 497U);
}

TEST(StaticQueue, LosesNothingOnABadLink) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world;
    LossyTransport bad(
        world.link, {.seed = seed, .lost = 0.3, .doubled = 0.2, .corrupted = 0.05, .delayed = 0.3},
        world.clock);
    Client client(bad, "feeder", {}, world.clock);
    StaticQueue queue(client, fifos(4000));
    ASSERT_TRUE(queue.open().ok());
    EXPECT_TRUE(queue.fill(0, rows_of(3000)).ok());
    EXPECT_TRUE(queue.arm().ok());
    ASSERT_EQ(world.executor->rows.size(), 3000U);
    for (std::size_t i = 0; i < 3000; ++i)
      ASSERT_EQ(world.executor->rows[i], test::row(i, i == 2999)) << "row " << i;
  }
}

TEST(StaticQueue, ReportsValuesThatDoNotFit) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  StaticQueue queue(client, fifos(16));
  ASSERT_TRUE(queue.open().ok());
  const CallOutcome outcome = queue.fill(0, rows_of(20));
  EXPECT_EQ(outcome.error, StreamError::stalled);
  EXPECT_EQ(outcome.reason, "bank 0 has no space for 4 rows");
}

/// A link on which rows are lost, and nothing else.
class LosesRows : public Transport {
 public:
  explicit LosesRows(Transport& link) : link_(link) {}
  void subscribe(const std::string& channel, int capacity) override {
    link_.subscribe(channel, capacity);
  }
  void send(const std::string& channel, std::span<const std::byte> bytes) override {
    const auto decoded = wire::decode(bytes);
    if (!std::holds_alternative<wire::Rows>(std::get<wire::Message>(decoded).body))
      link_.send(channel, bytes);
  }
  std::optional<Packet> receive(Nanos timeout) override { return link_.receive(timeout); }

 private:
  Transport& link_;
};

TEST(StaticQueue, DoesNotWaitForEverForRowsToBeTaken) {
  World world;
  LosesRows link(world.link);
  Client client(link, "feeder", {.patience = 500ms}, world.clock);
  StaticQueue queue(client, fifos(16));
  ASSERT_TRUE(queue.open().ok());
  const Nanos before = world.now;
  const CallOutcome outcome = queue.fill(0, rows_of(3));
  EXPECT_EQ(outcome.error, StreamError::stalled);
  EXPECT_EQ(outcome.reason, "bank 0 accepted no more rows for 500 ms");
  EXPECT_LT(world.now - before, 600ms);
}

TEST(StaticQueue, IsRejectedByNameAndNeverWaitsForEver) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  StaticQueue huge(client, fifos(1U << 21U));
  EXPECT_EQ(huge.open().refusal, Refusal::too_large);
  EXPECT_THROW(StaticQueue(client, {.units = {"s", "mm"}}), InputError);
  StaticQueue queue(client, fifos(16));
  ASSERT_TRUE(queue.open().ok()) << "the session is still there";
  world.shut_down();
  const Nanos before = world.now;
  EXPECT_EQ(queue.fill(0, rows_of(3)).error, StreamError::no_answer);
  EXPECT_EQ(queue.switch_over().error, StreamError::no_answer);
  EXPECT_FALSE(queue.level().has_value());
  EXPECT_LT(world.now - before, 10s);
}

}  // namespace
}  // namespace jounce::static_queue_test
