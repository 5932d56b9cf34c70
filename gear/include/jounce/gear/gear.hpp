// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// An exact electronic gear: slave counts = master counts * numerator / denominator, rounded down.
///
///     const Gear gear = Gear::ratio(4000, 3072);      // reduced to 125/96
///     std::int64_t slave = gear.slave(master);        // from the count: cannot drift
///
///     Gear::State state;                               // or from increments, each cycle:
///     slave += gear.advance(state, master_increment); // `state` carries the remainder
///
/// The result from counts and the result from increments agree bit for bit after any number of
/// counts, forwards, backwards and through zero, because the integer division rounds towards minus
/// infinity. Exact for every 64-bit master count whose slave count fits in 64 bits. For other
/// counts the result is undefined (asserted in debug builds).
class Gear {
 public:
  /// Returns a gear of the given ratio, reduced. Throws InputError if the denominator is 0 or less
  /// (PMC600 error 675), or if the numerator is -2^63. With a numerator of 0 the slave stands
  /// still.
  static Gear ratio(std::int64_t numerator, std::int64_t denominator);

  [[nodiscard]] std::int64_t numerator() const { return numerator_; }
  [[nodiscard]] std::int64_t denominator() const { return denominator_; }

  /// Returns the slave count for a master count.
  [[nodiscard]] std::int64_t slave(std::int64_t master) const;

  /// State from cycle to cycle.
  struct State {
    /// Remainder of the division, in 1/denominator of a slave count; from 0 to denominator - 1.
    std::int64_t remainder = 0;
  };
  /// Returns the slave increment for a master increment.
  std::int64_t advance(State& state, std::int64_t master_increment) const;

 private:
  Gear(std::int64_t numerator, std::int64_t denominator)
      : numerator_(numerator), denominator_(denominator) {}

  std::int64_t numerator_;
  std::int64_t denominator_;
};

}  // namespace jounce
