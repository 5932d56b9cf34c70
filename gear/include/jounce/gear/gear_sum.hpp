// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jounce/gear/gear.hpp"

namespace jounce {

/// A slave that follows the sum of several masters, each through its own exact gear: slave =
/// floor(sum of master[i] * numerator[i] / denominator[i]), rounded once.
///
///     const std::array gears{Gear::ratio(4, 3), Gear::ratio(-1, 7)};
///     const GearSum sum = GearSum::of(gears);
///     std::int64_t slave = sum.slave(std::array{master, correction});      // from counts
///     Gear::State state;                                                   // or from increments
///     slave += sum.advance(state, std::array{master_increment, correction_increment});
///
/// The result from counts and the result from increments agree bit for bit, for any number of
/// counts of each master, forwards and backwards. Exact for 64-bit counts whose slave count fits in
/// 64 bits. For other counts the result is undefined (asserted in debug builds). Only of()
/// allocates.
class GearSum {
 public:
  /// Makes the sum. Throws InputError "gears" if there is no gear, or if there is no common
  /// denominator D for which D and the sum of |ratio| * D are below 2^63.
  static GearSum of(std::span<const Gear> gears);

  /// Returns the slave count for one count of each master, in the order of the gears. Throws
  /// InputError for a wrong number of masters, as does advance().
  [[nodiscard]] std::int64_t slave(std::span<const std::int64_t> masters) const;

  /// Returns the slave increment for one increment of each master. `state` carries the remainder of
  /// the division, in 1/denominator() of a slave count.
  std::int64_t advance(Gear::State& state, std::span<const std::int64_t> increments) const;

  [[nodiscard]] std::size_t masters() const { return numerators_.size(); }  ///< number of masters
  [[nodiscard]] std::int64_t denominator() const { return denominator_; }   ///< common denominator

 private:
  std::vector<std::int64_t> numerators_;  // over the common denominator
  std::int64_t denominator_ = 1;
};

/// Returns the distance between two readings, both in [0, period), of a counter that wraps at
/// `period` > 0 (a modulo axis, a 32-bit encoder). The distance is the shorter way; exactly half a
/// period counts forwards. Use it as the input of a gear, so that no count is lost when the counter
/// wraps:
///
///     slave += gear.advance(state, counter_increment(before, now, 360000));
///
/// Correct if the counter moves by less than half a period between two readings.
std::int64_t counter_increment(std::int64_t before, std::int64_t now, std::int64_t period);

}  // namespace jounce
