// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace jounce::profiles_detail {

/// A sum of positive lengths from a start, compensated (Neumaier), so that also 1e6 segments end at
/// the exact place.
class CompensatedSum {
 public:
  explicit CompensatedSum(double start = 0) : total_(start) {}

  void add(double length) {
    const double next = total_ + length;
    lost_ += std::abs(total_) >= length ? (total_ - next) + length : (length - next) + total_;
    total_ = next;
  }
  [[nodiscard]] double value() const { return total_ + lost_; }

 private:
  double total_;
  double lost_ = 0;
};

}  // namespace jounce::profiles_detail
