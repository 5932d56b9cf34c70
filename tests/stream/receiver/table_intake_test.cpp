// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/table_intake.hpp"

#include <gtest/gtest.h>

#include "stream/harness.hpp"

namespace jounce::table_intake_test {
namespace {

constexpr std::int64_t boot = 5;

struct Sent {
  explicit Sent(std::uint32_t index, std::size_t knots = 1000)
      : messages(test::messages_of(test::sine_table(knots), index)) {}

  const wire::Header& header() const { return std::get<wire::Header>(messages.front().body); }
  const wire::Chunk& chunk(std::size_t seq) const {
    return std::get<wire::Chunk>(messages.at(seq + 1).body);
  }

  std::vector<wire::Message> messages;
};

/// Adds all chunks; returns the table that the last one completes.
std::optional<StoredTable> send(TableIntake& tables, const Sent& sent) {
  EXPECT_FALSE(tables.add(sent.header()));
  for (std::size_t i = 0; i < sent.header().chunks; ++i) {
    EXPECT_FALSE(tables.take_ready());
    EXPECT_FALSE(tables.add(sent.chunk(i)));
  }
  return tables.take_ready();
}

constexpr TableLimits limits{.most_knots = 2000, .memory = 200'000, .credit = 8};

TEST(TableIntake, StoresATableWhoseHashMatches) {
  TableIntake tables(limits);
  const Sent sent(1);
  const auto ready = send(tables, sent);
  ASSERT_TRUE(ready);
  EXPECT_EQ(ready->hash, sent.header().hash);
  EXPECT_FALSE(tables.take_ready()) << "once";
  EXPECT_EQ(tables.store().tables(), 1U);
  const auto acks = tables.acks(boot);
  ASSERT_EQ(acks.size(), 1U);
  EXPECT_TRUE(acks[0].complete);
  EXPECT_EQ(acks[0].boot, boot);
  EXPECT_TRUE(tables.acks(boot).empty()) << "each due one once";
}

TEST(TableIntake, FindsAStoredTableByItsHeader) {
  TableIntake tables(limits);
  send(tables, Sent(1));
  tables.clear();
  EXPECT_FALSE(tables.add(Sent(2).header()));
  EXPECT_TRUE(tables.take_ready()) << "the store outlives the session";
  EXPECT_EQ(tables.store().tables(), 1U);
}

TEST(TableIntake, RejectsAnIndexTwiceAndAChunkThatContradicts) {
  TableIntake tables(limits);
  const Sent sent(1);
  EXPECT_FALSE(tables.add(sent.header()));
  EXPECT_FALSE(tables.add(sent.header())) << "repeated";
  EXPECT_EQ(tables.add(Sent(1, 500).header()).refusal, wire::Refusal::bad_header);
  wire::Chunk chunk = sent.chunk(0);
  chunk.first_knot += 1;
  EXPECT_EQ(tables.add(chunk).refusal, wire::Refusal::bad_chunk);
  chunk.table = 9;
  EXPECT_FALSE(tables.add(chunk)) << "it has overtaken its header";
}

TEST(TableIntake, ATableBeyondTheLimitsIsRejectedInItsAcknowledgment) {
  TableIntake tables(limits);
  EXPECT_FALSE(tables.add(Sent(1, 2001).header()));
  TableIntake small({.most_knots = 2000, .memory = 1000, .credit = 8});
  EXPECT_FALSE(small.add(Sent(1).header()));
  const auto many = tables.acks(boot);
  const auto large = small.acks(boot);
  ASSERT_TRUE(many.size() == 1 && large.size() == 1);
  EXPECT_EQ(many[0].refusal, wire::Refusal::too_large);
  EXPECT_EQ(large[0].refusal, wire::Refusal::out_of_memory);
}

TEST(TableIntake, TheEndOfASessionReturnsTheMemoryInTransit) {
  TableIntake tables(limits);
  EXPECT_FALSE(tables.add(Sent(1).header()));
  EXPECT_GT(tables.store().bytes(), 0U);
  tables.clear();
  EXPECT_EQ(tables.store().bytes(), 0U);
  EXPECT_TRUE(tables.acks(boot).empty());
}

}  // namespace
}  // namespace jounce::table_intake_test
