// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "jounce/gear/gear.hpp"

namespace jounce {

/// A virtual axis that follows an encoder, such as a handwheel (PMC600 LS_Encoder_SetAxisMove, manual 5.2.4).
struct EncoderFollowSpec {
  std::int64_t numerator = 1;    ///< Ratio_Num, 1 to 10000
  std::int64_t denominator = 1;  ///< Ratio_Denom, 1 to 10000; error 5000 if it is 0
  int filter = 2;                ///< FilterPara, 1 to 100 cycles, larger is smoother; error 5002
};

/// An encoder that is followed, cycle by cycle, in exact counts.
///
///     const EncoderFollow follow({.numerator = 3, .denominator = 2, .filter = 8});
///     EncoderFollow::State state;
///     slave += follow.step(state, encoder_increment);      // deltaPulseUnit
///     follow.add(state, 500, 100);                         // PosAdditive: 500 pulses in 100 cycles
///
/// The filter is the moving average over `filter` cycles: it is the smoothest filter with its
/// delay, (filter - 1) / 2 cycles, and unlike a first order lag it ends. Its sum is kept in whole
/// counts and divided once, so no count is lost: `filter` - 1 cycles after the encoder has stopped,
/// the slave has moved exactly by floor(encoder * ratio) and the pulses of add(). The manual does
/// not define the filter. The caller reports the third error, 5001 (another function block has the
/// axis).
///
/// Pure: `State` is a value; step() and add() do not allocate.
class EncoderFollow {
 public:
  static constexpr int max_filter = 100;

  /// Throws InputError for a value out of range, with the PMC600's number.
  explicit EncoderFollow(const EncoderFollowSpec& spec);

  struct State {
    std::array<std::int64_t, max_filter> window{};  ///< the last `filter` increments
    int next = 0;
    std::int64_t sum = 0;  ///< sum of the window
    Gear::State gear{};
    std::int64_t additive = 0;  ///< pulses still to be added ...
    std::int64_t cycles = 0;    ///< ... in so many cycles
    std::int64_t pulses = 0;    ///< pulses of the last add() ...
    std::int64_t over = 1;      ///< ... in so many cycles
    std::int64_t part = 0;      ///< part of a pulse, in 1/over
  };

  /// Slave pulses in this cycle.
  std::int64_t step(State& state, std::int64_t encoder_increment) const;

  /// PosAdditive_Trig: pulses (not times the ratio) spread evenly over the next `cycles` >= 1 cycles:
  /// floor(k pulses / cycles) after k of them, never a pulse from the line, all after the last. The rest
  /// of an earlier addition is spread with them. Throws InputError "cycles".
  static void add(State& state, std::int64_t pulses, std::int64_t cycles);

 private:
  Gear gear_;  // gear of the window's sum: ratio / filter
  int filter_;
};

}  // namespace jounce
