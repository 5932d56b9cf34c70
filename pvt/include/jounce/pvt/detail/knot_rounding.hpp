// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/pvt/table.hpp"

namespace jounce::pvt_detail {

/// The greatest errors of the derivatives of a table that are caused by rounding its knots. `check`
/// and admit() of an axis compare limits with least_limit(), so both give one answer.
class KnotRounding {
 public:
  /// The greatest share of a limit by which the rounding of knots may exceed it. An axis permits it in
  /// each cycle, too: stop_acceleration is at least 1.1 times the limit of the acceleration.
  static constexpr double greatest_excess = 0.01;

  /// The table must outlive it. `cycle`: of the executor, in the unit of the places of a table over
  /// time.
  explicit KnotRounding(const Table& table, double cycle = 1e-3);

  /// The error of the derivative of this order, 0 to 3, in an interval. An error d of the position
  /// causes an error of 60 d / L^3 of the jerk in a quintic of length L, less in a cubic. A rounded
  /// place x counts as an error v x of the position. A knot beside a shorter interval, of length S,
  /// may have d / S more velocity, which removes the error from that interval (sample_within()) and
  /// causes an error of 36 d / (S L^2) here.
  [[nodiscard]] double of(std::size_t order, std::size_t interval) const;

  /// The least limit that a derivative of order 1 to 3 with this peak keeps in an interval. The error
  /// of the interval does not count, up to a hundredth of the limit. An axis outputs the velocity and
  /// the acceleration of a tick, but not the jerk: over time, the jerk of an interval that is shorter
  /// than a cycle acts by its mean over the cycle, so the hundredth is that of the mean.
  [[nodiscard]] double least_limit(std::size_t order, std::size_t interval, double peak) const;

 private:
  const Table& table_;
  double cycle_;
  double error_ = 0;  ///< rounding of a position
};

}  // namespace jounce::pvt_detail
