// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/interrupt.hpp"

#include <gtest/gtest.h>

namespace jounce::interrupt_test {
namespace {

volatile std::sig_atomic_t before = 0;

TEST(Interrupt, TakesTheFirstSignalAndRestoresTheHandler) {
  std::signal(SIGINT, [](int) { before = before + 1; });
  {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt.asked());
    std::raise(SIGINT);
    EXPECT_TRUE(interrupt.asked());
    EXPECT_EQ(before, 0);
  }
  std::raise(SIGINT);
  EXPECT_EQ(before, 1);
  const Interrupt again;
  EXPECT_FALSE(again.asked()) << "the signal of the previous object is over";
  std::raise(SIGTERM);
  EXPECT_TRUE(again.asked());
}

TEST(InterruptDeathTest, TheSecondSignalEndsTheProgram) {
  EXPECT_EXIT(
      {
        const Interrupt interrupt;
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace jounce::interrupt_test
