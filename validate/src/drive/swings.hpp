// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace jounce::validate_detail {

/// Counts the zeros of a decaying speed as long as the swings between them are large enough.
class Swings {
 public:
  /// Adds the next value of the speed, in the order of time.
  void see(double speed) { speed_ = std::max(speed_, std::abs(speed)); }
  /// Adds a zero of the speed.
  void zero(double time) {
    zeros_.push_back({time, speed_});
    if (zeros_.size() > 1) fastest_ = std::max(fastest_, speed_);
    speed_ = 0;
  }

  /// Greatest speed between two zeros so far.
  [[nodiscard]] double fastest() const { return fastest_; }

  /// Frequency of the swings in Hz, each swing (half a period) from one zero to the next. It uses
  /// the swings from the first zero on, up to the first one that is slower than `least_speed` or
  /// than 1 % of the fastest. Returns 0 if there are fewer than two. The swing before the first
  /// zero is not used: it began before the watch.
  [[nodiscard]] double frequency(double least_speed) const {
    const double least = std::max(least_speed, 0.01 * fastest_);
    std::size_t swings = 0;
    while (swings + 1 < zeros_.size() && zeros_[swings + 1].speed >= least) ++swings;
    if (swings < 2) return 0;
    return static_cast<double>(swings) / (2 * (zeros_[swings].time - zeros_[0].time));
  }

 private:
  struct Zero {
    double time;
    double speed;  ///< the greatest since the previous zero
  };
  std::vector<Zero> zeros_;
  double speed_ = 0;
  double fastest_ = 0;
};

}  // namespace jounce::validate_detail
