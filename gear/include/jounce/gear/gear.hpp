// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace jounce {

/// An exact electronic gear: slave counts = master counts * numerator / denominator, rounded down.
///
///     const Gear gear = Gear::ratio(4000, 3072);      // reduced to 125/96
///     std::int64_t slave = gear.slave(master);        // from the count itself: cannot drift
///
///     Gear::State state;                               // or from increments, cycle by cycle:
///     slave += gear.advance(state, master_increment); // the remainder is carried
///
/// Both ways agree bit for bit after any number of counts, forward and back and through zero,
/// because the division is an integer one that rounds towards minus infinity. Exact for every
/// 64-bit master count whose slave count fits 64 bits; outside that the result is not
/// defined (asserted in debug builds).
class Gear {
 public:
  /// Throws InputError if the denominator is 0 or less (PMC600 error 675). A numerator of 0 holds
  /// the slave still.
  static Gear ratio(std::int64_t numerator, std::int64_t denominator);

  [[nodiscard]] std::int64_t numerator() const { return numerator_; }
  [[nodiscard]] std::int64_t denominator() const { return denominator_; }

  [[nodiscard]] std::int64_t slave(std::int64_t master) const;

  /// Slave increment for a master increment; `state` carries the remainder of the division.
  struct State {
    std::int64_t remainder =
        0;  ///< in 1/denominator of a slave count, 0 <= remainder < denominator
  };
  std::int64_t advance(State& state, std::int64_t master_increment) const;

 private:
  Gear(std::int64_t numerator, std::int64_t denominator)
      : numerator_(numerator), denominator_(denominator) {}

  std::int64_t numerator_;
  std::int64_t denominator_;
};

}  // namespace jounce
