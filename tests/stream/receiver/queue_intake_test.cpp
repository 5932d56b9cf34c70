// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/queue_intake.hpp"

#include <gtest/gtest.h>

#include "stream/sender/rows.hpp"

namespace jounce::queue_intake_test {
namespace {

using wire::Refusal;

constexpr std::int64_t boot = 5;
constexpr QueueLimits limits{.most_rows = 64, .most_queues = 2, .credit = 8};

wire::Queue numbered(std::uint32_t index, std::uint32_t capacity = 16, std::uint32_t prefill = 2) {
  wire::Queue queue = test::queue_of(capacity, prefill);
  queue.queue = index;
  return queue;
}

/// Message `seq` of a queue, with one row in each message.
wire::Rows one_row(std::uint32_t queue, std::uint32_t seq, bool last = false) {
  return {.queue = queue, .seq = seq, .first_row = seq, .rows = {test::row(seq, last)}};
}

/// An intake with the open queue 64.
QueueIntake opened() {
  QueueIntake queues(limits);
  EXPECT_FALSE(queues.add(numbered(64)));
  EXPECT_TRUE(queues.take_opened());
  static_cast<void>(queues.acks(boot));
  return queues;
}

TEST(QueueIntake, OpensAQueueOnce) {
  QueueIntake queues(limits);
  EXPECT_FALSE(queues.is_open(64));
  EXPECT_FALSE(queues.add(numbered(64)));
  ASSERT_TRUE(queues.take_opened());
  EXPECT_FALSE(queues.take_opened()) << "once";
  EXPECT_TRUE(queues.is_open(64));
  EXPECT_FALSE(queues.add(numbered(64))) << "repeated";
  EXPECT_FALSE(queues.take_opened());
  const auto acks = queues.acks(boot);
  ASSERT_EQ(acks.size(), 1U);
  EXPECT_EQ(acks[0].boot, boot);
  EXPECT_EQ(acks[0].queue, 64U);
  EXPECT_TRUE(queues.acks(boot).empty()) << "each due one once";
}

TEST(QueueIntake, RejectsAnotherQueueOfTheIndex) {
  QueueIntake queues = opened();
  EXPECT_EQ(queues.add(numbered(64, 32)).refusal, Refusal::bad_queue);
  EXPECT_FALSE(queues.take_opened());
  EXPECT_TRUE(queues.accepts(64)) << "the first one is not changed";
}

TEST(QueueIntake, KeepsItsLimits) {
  QueueIntake queues = opened();
  EXPECT_EQ(queues.add(numbered(65, 65)).refusal, Refusal::too_large);
  EXPECT_FALSE(queues.add(numbered(65, 64)));
  EXPECT_EQ(queues.add(numbered(66)).refusal, Refusal::out_of_memory);
  EXPECT_FALSE(queues.is_open(66));
  queues.clear();
  EXPECT_FALSE(queues.add(numbered(66))) << "of the next session";
}

TEST(QueueIntake, RejectsAQueueThatContradictsItself) {
  QueueIntake queues(limits);
  EXPECT_EQ(queues.add(numbered(64, 1)).refusal, Refusal::bad_queue);
  wire::Queue in_degrees = numbered(64);
  in_degrees.units.x = "deg";
  EXPECT_EQ(queues.add(in_degrees).refusal, Refusal::wrong_unit);
  EXPECT_FALSE(queues.is_open(64));
}

TEST(QueueIntake, ReturnsRowsInOrderAndOnce) {
  QueueIntake queues = opened();
  queues.add(one_row(64, 1));
  EXPECT_TRUE(queues.take_rows().empty()) << "message 0 is missing";
  queues.add(one_row(64, 0));
  const auto rows = queues.take_rows();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].seq, 0U);
  EXPECT_EQ(rows[1].seq, 1U);
  EXPECT_TRUE(queues.take_rows().empty());
  queues.add(one_row(64, 0));
  EXPECT_TRUE(queues.take_rows().empty()) << "repeated";
}

TEST(QueueIntake, KeepsTheRowsOfTwoQueuesApart) {
  QueueIntake queues = opened();
  EXPECT_FALSE(queues.add(numbered(65)));
  queues.add(one_row(65, 0));
  const auto rows = queues.take_rows();
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].queue, 65U);
  queues.add(one_row(66, 0));
  EXPECT_TRUE(queues.take_rows().empty()) << "no such queue";
}

TEST(QueueIntake, IsFilledByItsPrefillOrTheLastRow) {
  QueueIntake queues = opened();
  queues.add(one_row(64, 0));
  EXPECT_FALSE(queues.is_filled(64, 0));
  queues.add(one_row(64, 1));
  EXPECT_TRUE(queues.is_filled(64, 0));
  EXPECT_FALSE(queues.is_filled(65, 0)) << "not open";
  EXPECT_FALSE(queues.add(numbered(65)));
  queues.add(one_row(65, 0, true));
  EXPECT_TRUE(queues.is_filled(65, 0));
}

TEST(QueueIntake, AcknowledgesProgressAndRejections) {
  QueueIntake queues = opened();
  queues.add(one_row(64, 0));
  static_cast<void>(queues.acks(boot));
  queues.level(64, {.freed = {1, 0}, .played = 1, .progress = wire::Progress::running});
  auto acks = queues.acks(boot);
  ASSERT_EQ(acks.size(), 1U);
  EXPECT_EQ(acks[0].played, 1);
  queues.refuse(64, {Refusal::bad_row, "leaves the range"}, 3);
  EXPECT_FALSE(queues.accepts(64));
  EXPECT_TRUE(queues.is_open(64));
  acks = queues.acks(boot);
  ASSERT_EQ(acks.size(), 1U);
  EXPECT_EQ(acks[0].row, 3);
  EXPECT_EQ(acks[0].reason, "leaves the range");
  queues.level(65, {});
  queues.refuse(65, {Refusal::bad_row, ""});
  EXPECT_TRUE(queues.acks(boot).empty()) << "no such queue";
}

TEST(QueueIntake, AClearedBankIsEmpty) {
  QueueIntake queues = opened();
  queues.add(one_row(64, 0));
  queues.add(one_row(64, 1));
  ASSERT_TRUE(queues.is_filled(64, 0));
  static_cast<void>(queues.acks(boot));
  queues.clear_bank(64, 0, 2);
  EXPECT_FALSE(queues.is_filled(64, 0));
  EXPECT_EQ(queues.acks(boot).size(), 1U);
}

}  // namespace
}  // namespace jounce::queue_intake_test
