// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/pvt/table.hpp"

namespace jounce::pvt_detail {

/// The greatest errors of the derivatives of a table that are caused by rounding its knots. `check`
/// and admit() of an axis compare limits with least_limit(), so both give the same result.
class KnotRounding {
 public:
  /// The greatest share of a limit by which the rounding of knots may exceed it. An axis permits
  /// this excess in each cycle, too, because its stop_acceleration is at least 1.1 times the limit
  /// of the acceleration.
  static constexpr double greatest_excess = 0.01;

  /// The table must outlive the object. `cycle`: cycle of the executor, in the unit of x of a table
  /// over time.
  explicit KnotRounding(const Table& table, double cycle = 1e-3);

  /// Returns the error of the derivative of this order, 0 to 3, in an interval. An error d of the
  /// position causes an error of 60 d / L^3 of the jerk in a quintic of length L, and less in a
  /// cubic. The rounding of x counts as an error of the position: velocity times rounding. The
  /// velocity of a knot beside a shorter interval, of length S, may be changed by d / S to remove
  /// the error from that interval (sample_within()). This change causes an error of 36 d / (S L^2)
  /// in the jerk of the longer interval.
  [[nodiscard]] double of(std::size_t order, std::size_t interval) const;

  /// Returns the least limit that a derivative of order 1 to 3 with this peak satisfies in an
  /// interval. The derivative may exceed the limit by the error of the interval, but at most by a
  /// hundredth of the limit. In each tick, an axis outputs the velocity and the acceleration, but
  /// not the jerk. So in a table over time, the jerk of an interval that is shorter than a cycle
  /// counts by its mean over the cycle: this mean may exceed the limit by a hundredth.
  [[nodiscard]] double least_limit(std::size_t order, std::size_t interval, double peak) const;

 private:
  const Table& table_;
  double cycle_;
  double error_ = 0;  ///< rounding of a position
};

}  // namespace jounce::pvt_detail
