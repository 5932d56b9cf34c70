// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace jounce::profiles_detail {

/// Sum of a start and of positive lengths. The summation is compensated (Neumaier), so that even
/// the end of 1e6 segments has no accumulated rounding.
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
