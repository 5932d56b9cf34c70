// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/lossy_transport.hpp"

#include <cmath>
#include <cstring>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "stream/src/transport/memory_transport.hpp"

namespace jounce::lossy_transport_test {
namespace {

using namespace std::chrono_literals;

/// Output of a link for 10 000 numbers sent 1 ms apart.
std::vector<int> sent_through(const LossSpec& spec, bool receiving_side = false) {
  MemoryNetwork network;
  MemoryTransport link(network), other(network);
  Nanos now{};
  LossyTransport lossy(link, spec, [&] { return now; });
  lossy.subscribe("a", 100'000);
  other.subscribe("a", 100'000);
  Transport& in = receiving_side ? static_cast<Transport&>(other) : lossy;
  Transport& out = receiving_side ? static_cast<Transport&>(lossy) : other;
  std::vector<int> numbers;
  for (int i = 0; i < 10'100; ++i, now += 1ms) {
    if (i < 10'000) in.send("a", std::as_bytes(std::span(&i, 1)));
    if (!receiving_side) static_cast<void>(lossy.receive(Nanos{}));
    while (const auto packet = out.receive(Nanos{})) {
      int number = 0;
      std::memcpy(&number, packet->bytes.data(), sizeof number);
      numbers.push_back(number);
    }
  }
  return numbers;
}

/// Within five standard deviations of a binomial distribution of 10 000.
void expect_share(std::size_t count, double share) {
  EXPECT_NEAR(static_cast<double>(count), 1e4 * share, 5 * std::sqrt(1e4 * share * (1 - share)));
}

class LossyBothWays : public testing::TestWithParam<bool> {};

TEST_P(LossyBothWays, PassesEverythingOnUnharmedByDefault) {
  const auto numbers = sent_through({}, GetParam());
  ASSERT_EQ(numbers.size(), 10'000U);
  EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
}

TEST_P(LossyBothWays, LosesItsShare) {
  const auto numbers = sent_through({.lost = 0.2}, GetParam());
  expect_share(numbers.size(), 0.8);
  EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
}

TEST_P(LossyBothWays, DoublesItsShare) {
  expect_share(sent_through({.doubled = 0.3}, GetParam()).size() - 10'000, 0.3);
}

TEST_P(LossyBothWays, ReordersButLosesNothing) {
  const auto numbers = sent_through({.delayed = 0.5, .delay = 20ms}, GetParam());
  EXPECT_FALSE(std::is_sorted(numbers.begin(), numbers.end()));
  EXPECT_EQ(numbers.size(), 10'000U);
  EXPECT_EQ(std::set<int>(numbers.begin(), numbers.end()).size(), 10'000U);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    ASSERT_LE(std::abs(numbers[i] - static_cast<int>(i)), 21) << "nothing is late by more";
}

TEST_P(LossyBothWays, TurnsOneBitOver) {
  // A number that differs in one bit from the one that was sent.
  const auto numbers = sent_through({.corrupted = 0.1}, GetParam());
  ASSERT_EQ(numbers.size(), 10'000U);
  std::size_t harmed = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto difference = static_cast<unsigned>(numbers[i]) ^ static_cast<unsigned>(i);
    if (difference == 0) continue;
    ++harmed;
    EXPECT_EQ(difference & (difference - 1), 0U);
  }
  expect_share(harmed, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Sides, LossyBothWays, testing::Bool(),
                         [](const auto& each) { return each.param ? "Receiving" : "Sending"; });

TEST(LossyTransport, RepeatsItselfBySeed) {
  const LossSpec spec{.seed = 7, .lost = 0.3, .doubled = 0.1, .delayed = 0.2};
  LossSpec other = spec;
  other.seed = 8;
  EXPECT_EQ(sent_through(spec), sent_through(spec));
  EXPECT_NE(sent_through(spec), sent_through(other));
}

TEST(LossyTransport, LosesWhatIsSentWhileItIsCut) {
  using Way = Partition::Way;
  const auto through = [](Way way, bool receiving_side) {
    return sent_through({.partitions = {{2s, 3s, way}, {9s, 20s, way}}}, receiving_side);
  };
  for (const bool receiving_side : {false, true}) {
    const auto numbers = through(Way::both, receiving_side);
    ASSERT_EQ(numbers.size(), 8'000U);
    EXPECT_EQ(numbers[1999], 1999);
    EXPECT_EQ(numbers[2000], 3000) << "from is lost, to is not";
    EXPECT_EQ(numbers.back(), 8999);
    EXPECT_EQ(through(Way::out, receiving_side).size(), receiving_side ? 10'000U : 8'000U);
    EXPECT_EQ(through(Way::in, receiving_side).size(), receiving_side ? 8'000U : 10'000U);
  }
}

TEST(LossyTransport, RejectsAPartitionThatEndsBeforeItBegins) {
  MemoryNetwork network;
  MemoryTransport link(network);
  EXPECT_THROW(LossyTransport(link, {.partitions = {{2s, 1s}}}, [] { return Nanos{}; }),
               InputError);
}

TEST(LossyTransport, RejectsSharesOutOfRange) {
  MemoryNetwork network;
  MemoryTransport link(network);
  const Clock clock = [] { return Nanos{}; };
  EXPECT_THROW(LossyTransport(link, {.lost = 1.1}, clock), InputError);
  EXPECT_THROW(LossyTransport(link, {.delayed = -0.1}, clock), InputError);
  EXPECT_THROW(LossyTransport(link, {.doubled = std::nan("")}, clock), InputError);
}

}  // namespace
}  // namespace jounce::lossy_transport_test
