// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace jounce {

/// A history of the positions of an axis or of a master in the last cycles. It returns the position
/// at any instant between two of these cycles:
///
///     PositionHistory history;
///     history.add(dt, position, velocity);               // once a cycle
///     const double there = history.before(0.0012);       // 1.2 ms before the last cycle
///
/// Between two cycles, the position moves by cycle_motion(): exact for a constant jerk. If a
/// velocity is NaN, it moves on a straight line. u is the unit of the position.
class PositionHistory {
 public:
  static constexpr std::size_t length = 16;  ///< number of positions

  /// Adds the position (u) and velocity (u/s) of this cycle. `dt`: s since the previous cycle.
  void add(double dt, double position, double velocity) noexcept;
  /// Adds this distance, u, to all positions: the coordinate has changed.
  void shift(double by) noexcept;
  /// Returns the position `age` s (>= 0) before the last cycle, u. NaN: earlier than all positions,
  /// or not known.
  [[nodiscard]] double before(double age) const noexcept;

 private:
  struct Place {
    double dt = std::numeric_limits<double>::infinity();  // s since the previous place
    double position = std::numeric_limits<double>::quiet_NaN();
    double velocity = std::numeric_limits<double>::quiet_NaN();
  };
  [[nodiscard]] const Place& place(std::size_t back) const noexcept {
    return places_[(newest_ + length - back) % length];
  }

  std::array<Place, length> places_{};
  std::size_t newest_ = 0;
};

}  // namespace jounce
