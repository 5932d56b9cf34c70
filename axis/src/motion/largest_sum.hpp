// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <deque>
#include <span>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {

/// The largest sum of the magnitudes of steps within one tick. A single step keeps its sign.
class LargestSum {
 public:
  explicit LargestSum(double tick) : window_(tick * (1 - profiles_detail::rounded_input)) {}

  /// Steps ascend.
  void add(const Jump& step) {
    while (!steps_.empty() && step.where >= steps_.front().where + window_) close();
    sum_ += std::abs(step.step);
    steps_.push_back(step);
  }
  /// Returns the sum and its start. No step may follow.
  [[nodiscard]] Jump result() {
    while (!steps_.empty()) close();
    return largest_;
  }

 private:
  /// The sum that begins with the first step is complete.
  void close() {
    const Jump first = steps_.front();
    const bool alone = steps_.size() == 1;
    if (sum_ > std::abs(largest_.step)) largest_ = {alone ? first.step : sum_, first.where};
    sum_ = alone ? 0 : sum_ - std::abs(first.step);
    steps_.pop_front();
  }

  double window_;
  double sum_ = 0;  // sum of the magnitudes of steps_
  std::deque<Jump> steps_;
  Jump largest_;
};

/// Returns the largest sum of these steps, which ascend, and its start.
inline Jump largest_sum(std::span<const Jump> steps, double tick) {
  LargestSum sum(tick);
  for (const Jump& step : steps) sum.add(step);
  return sum.result();
}

}  // namespace jounce
