// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/ring.hpp"

#include <cstdint>
#include <thread>

#include <gtest/gtest.h>

namespace jounce::ring_test {
namespace {

TEST(Ring, HoldsItsCapacityInOrder) {
  Ring<int, 4> ring;
  int item = 0;
  EXPECT_FALSE(ring.pop(item));
  for (int round = 0; round < 10; ++round) {
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.push(10 * round + i));
    EXPECT_FALSE(ring.push(99));
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(ring.pop(item));
      EXPECT_EQ(item, 10 * round + i);
    }
    EXPECT_FALSE(ring.pop(item));
  }
}

TEST(Ring, TwoThreadsLoseDoubleAndTearNothing) {
  struct Pair {
    std::uint64_t count;
    std::uint64_t check;
  };
  constexpr std::uint64_t items = 200'000;
  constexpr std::uint64_t key = 0x9e3779b97f4a7c15;
  Ring<Pair, 64> ring;
  std::thread producer([&] {
    for (std::uint64_t i = 0; i < items; ++i) {
      while (!ring.push({i, i * key})) std::this_thread::yield();
    }
  });
  std::uint64_t expected = 0;
  std::uint64_t wrong = 0;
  while (expected < items) {
    Pair pair{};
    if (!ring.pop(pair)) {
      std::this_thread::yield();
      continue;
    }
    wrong += pair.count != expected || pair.check != expected * key;
    ++expected;
  }
  producer.join();
  EXPECT_EQ(wrong, 0U);
  Pair rest{};
  EXPECT_FALSE(ring.pop(rest));
}

}  // namespace
}  // namespace jounce::ring_test
