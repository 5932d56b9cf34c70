// SPDX-License-Identifier: Apache-2.0
#include "support/loop_limit.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace jounce::loop_limit_test {
namespace {

TEST(LoopLimit, FailsAfterItsRounds) {
  int rounds = 0;
  const auto loop_forever = [&] {
    for (test::LoopLimit loop(3); loop.goes_on();) ++rounds;
  };
  EXPECT_NONFATAL_FAILURE(loop_forever(), "does not occur");
  EXPECT_EQ(rounds, 3);
  for (test::LoopLimit loop(3); rounds < 6 && loop.goes_on();) ++rounds;
  EXPECT_EQ(rounds, 6) << "a condition that occurs is no failure";
}

}  // namespace
}  // namespace jounce::loop_limit_test
