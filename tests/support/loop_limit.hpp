// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

namespace jounce::test {

/// Limits the rounds of a loop that waits for a condition. The test fails at the limit.
///
///     for (LoopLimit loop; tick.velocity != 0 && loop.goes_on();) tick = bench.step();
class LoopLimit {
 public:
  explicit LoopLimit(int most = 100'000) : left_(most) {}

  /// Returns false, and fails the test, if the loop has had all its rounds.
  [[nodiscard]] bool goes_on() {
    if (left_-- > 0) return true;
    ADD_FAILURE() << "the condition for which the loop waits does not occur";
    return false;
  }

 private:
  int left_;
};

}  // namespace jounce::test
