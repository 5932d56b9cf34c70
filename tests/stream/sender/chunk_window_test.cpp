// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/chunk_window.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stream/harness.hpp"

namespace jounce::chunk_window_test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

wire::Ack ack(std::uint32_t next, std::uint64_t mask = 0, std::uint32_t credit = 8) {
  return {.boot = 1, .next = next, .mask = mask, .credit = credit};
}

/// A window of 4 over 10 chunks that has credit.
ChunkWindow opened() {
  ChunkWindow window(10, {.window = 4});
  window.acknowledge(ack(0), 0ms);
  return window;
}

TEST(ChunkWindow, SendsNothingWithoutCredit) {
  ChunkWindow window(10, {});
  EXPECT_THAT(window.due(0ms), IsEmpty());
  window.acknowledge(ack(0, 0, 2), 0ms);
  EXPECT_THAT(window.due(0ms), ElementsAre(0, 1));
}

TEST(ChunkWindow, KeepsAWindowUnderWay) {
  ChunkWindow window = opened();
  EXPECT_THAT(window.due(0ms), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(window.due(1ms), IsEmpty());
  EXPECT_TRUE(window.acknowledge(ack(2), 1ms));
  EXPECT_THAT(window.due(1ms), ElementsAre(4, 5));
  EXPECT_TRUE(window.acknowledge(ack(6), 2ms));
  EXPECT_THAT(window.due(2ms), ElementsAre(6, 7, 8, 9));
  EXPECT_EQ(window.arrived(), 6U);
  EXPECT_EQ(window.resent(), 0U);
}

TEST(ChunkWindow, FillsAHoleSoon) {
  ChunkWindow window = opened();
  EXPECT_THAT(window.due(0ms), ElementsAre(0, 1, 2, 3));
  window.acknowledge(ack(0, 0b101), 1ms);  // 1 and 3 have arrived
  EXPECT_THAT(window.due(1ms), IsEmpty()) << "they may have been overtaken";
  EXPECT_THAT(window.due(2ms), ElementsAre(0, 2));
  EXPECT_EQ(window.resent(), 2U);
  EXPECT_THAT(window.due(3ms), IsEmpty());
}

TEST(ChunkWindow, AsksASilentReceiverWithOneChunkBeforeItRepeatsAll) {
  ChunkWindow window = opened();
  EXPECT_THAT(window.due(0ms), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(window.due(6ms), ElementsAre(0));
  EXPECT_THAT(window.due(11ms), IsEmpty());
  EXPECT_THAT(window.due(12ms), ElementsAre(1, 2, 3));
  EXPECT_THAT(window.due(18ms), IsEmpty()) << "the patience has doubled twice";
}

TEST(ChunkWindow, RepeatsAllThatTheOneOvertook) {
  ChunkWindow window = opened();
  EXPECT_THAT(window.due(0ms), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(window.due(6ms), ElementsAre(0));
  EXPECT_TRUE(window.acknowledge(ack(1), 7ms));  // the first time they were all lost
  EXPECT_THAT(window.due(7ms), ElementsAre(1, 2, 3, 4));
}

TEST(ChunkWindow, RepeatsMoreAndMoreSlowlyOnASilentLink) {
  ChunkWindow window(1, {});
  window.acknowledge(ack(0), 0ms);
  std::vector<int> instants;
  for (int ms = 0; ms < 500; ++ms)
    if (!window.due(std::chrono::milliseconds(ms)).empty()) instants.push_back(ms);
  // 6 ms doubled each time, up to 100 ms.
  EXPECT_THAT(instants, ElementsAre(0, 6, 18, 42, 90, 186, 286, 386, 486));
}

TEST(ChunkWindow, RepeatsSoonAgainOnceSomethingArrives) {
  ChunkWindow window(10, {.window = 1});
  window.acknowledge(ack(0), 0ms);
  for (const auto instant : {0ms, 6ms, 18ms, 42ms})
    EXPECT_THAT(window.due(instant), ElementsAre(0));
  EXPECT_TRUE(window.acknowledge(ack(1), 50ms));
  EXPECT_THAT(window.due(50ms), ElementsAre(1));
  EXPECT_THAT(window.due(55ms), IsEmpty());
  EXPECT_THAT(window.due(56ms), ElementsAre(1));
}

TEST(ChunkWindow, EstimatesTheRoundTrip) {
  ChunkWindow window(100, {.window = 1});
  window.acknowledge(ack(0), 0ms);
  Nanos now = 0ms;
  for (std::uint32_t seq = 0; seq < 50; ++seq) {
    EXPECT_THAT(window.due(now), ElementsAre(seq));
    now += 40ms;
    window.acknowledge(ack(seq + 1), now);
  }
  EXPECT_THAT(window.due(now), ElementsAre(50));
  EXPECT_THAT(window.due(now + 39ms), IsEmpty()) << "a slow link is no lossy link";
}

TEST(ChunkWindow, IgnoresAcksThatMakeNoSenseOrComeLate) {
  ChunkWindow window = opened();
  EXPECT_THAT(window.due(0ms), ElementsAre(0, 1, 2, 3));
  EXPECT_FALSE(window.acknowledge(ack(11), 1ms));
  EXPECT_TRUE(window.acknowledge(ack(3), 1ms));
  EXPECT_FALSE(window.acknowledge(ack(1), 1ms));
  EXPECT_FALSE(window.acknowledge(ack(3), 1ms));
  EXPECT_EQ(window.arrived(), 3U);
  EXPECT_TRUE(window.acknowledge(ack(10, ~std::uint64_t{0}), 1ms));
  EXPECT_EQ(window.arrived(), 10U);
  EXPECT_THAT(window.due(1s), IsEmpty());
}

}  // namespace
}  // namespace jounce::chunk_window_test
