// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "jounce/executor/detail/cycle.hpp"

namespace jounce::test {

/// Time passes only in sleep_until, which wakes up as late as requested.
class VirtualPacer final : public Pacer {
 public:
  std::int64_t now() override { return now_; }
  void sleep_until(std::int64_t instant) override {
    now_ = std::max(now_, instant) + delay;
    delay = 0;
  }

  std::int64_t delay = 0;

 private:
  std::int64_t now_ = 123'456'789'000;
};

}  // namespace jounce::test
