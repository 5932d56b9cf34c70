// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jounce/gear/gear.hpp"

namespace jounce {

/// A slave that follows several masters at once, each through its own exact gear:
/// slave = floor(sum of master[i] * numerator[i] / denominator[i]), rounded once.
///
///     const std::array gears{Gear::ratio(4, 3), Gear::ratio(-1, 7)};
///     const GearSum sum = GearSum::of(gears);
///     std::int64_t slave = sum.slave(std::array{master, correction});      // from the counts
///     Gear::State state;                                                   // or cycle by cycle
///     slave += sum.advance(state, std::array{master_increment, correction_increment});
///
/// Both ways agree bit for bit, for any number of counts of each master, forward and back. Exact
/// for every 64-bit count whose slave count fits 64 bits (asserted in debug builds; not defined
/// outside). Nothing allocates after of().
class GearSum {
 public:
  /// Throws InputError "gears" if there is none, or if the ratios have no common denominator D with
  /// D and the sum of |ratio| * D below 2^63.
  static GearSum of(std::span<const Gear> gears);

  /// One count for each master, in the order of the gears.
  [[nodiscard]] std::int64_t slave(std::span<const std::int64_t> masters) const;

  /// Slave increment for one increment of each master; `state` carries the remainder of the
  /// division, in 1/denominator() of a slave count.
  std::int64_t advance(Gear::State& state, std::span<const std::int64_t> increments) const;

  [[nodiscard]] std::size_t masters() const { return numerators_.size(); }
  [[nodiscard]] std::int64_t denominator() const { return denominator_; }

 private:
  std::vector<std::int64_t> numerators_;  // over the common denominator
  std::int64_t denominator_ = 1;
};

/// Distance of a counter that wraps at `period` > 0 (a modulo axis, a 32-bit encoder) between
/// two readings in [0, period): the shorter way; exactly half a period counts forwards. Use it as
/// the input of a gear, so that no count is lost at the wrap:
///
///     slave += gear.advance(state, counter_increment(before, now, 360000));
///
/// Right as long as the master goes less than half a period between two readings.
std::int64_t counter_increment(std::int64_t before, std::int64_t now, std::int64_t period);

}  // namespace jounce
