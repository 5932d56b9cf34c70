// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "jounce/gear/gear.hpp"

namespace jounce {

/// A virtual axis that follows an encoder, such as a handwheel (PMC600 manual 5.2.4:
/// LS_Encoder_SetAxisMove). The manual defines its parameters and error numbers.
struct EncoderFollowSpec {
  std::int64_t numerator = 1;    ///< Ratio_Num, 1 to 10000
  std::int64_t denominator = 1;  ///< Ratio_Denom, 1 to 10000; 0 is error 5000
  /// FilterPara, 1 to 100 cycles, a larger value is smoother; out of range is error 5002.
  int filter = 2;
};

/// Follows an encoder cycle by cycle, in exact counts.
///
///     const EncoderFollow follow({.numerator = 3, .denominator = 2, .filter = 8});
///     EncoderFollow::State state;
///     slave += follow.step(state, encoder_increment);      // returns deltaPulseUnit
///     follow.add(state, 500, 100);                        // PosAdditive: 500 pulses in 100 cycles
///
/// The filter is the moving average over `filter` cycles, with a delay of (filter - 1) / 2 cycles.
/// (The manual does not define its filter; of all filters with this delay, the moving average is
/// the smoothest, and unlike a first-order lag it ends.) The sum of the window is kept in whole
/// counts and divided once, so no count is lost: `filter` - 1 cycles after the encoder has stopped,
/// the slave has moved by exactly floor(encoder * ratio), plus the pulses of add(). The caller must
/// report error 5001 (another function block controls the axis).
///
/// `State` is a value; step() and add() do not allocate.
class EncoderFollow {
 public:
  static constexpr int max_filter = 100;  ///< greatest filter, cycles

  /// Throws InputError for a value out of range, with the error number of the PMC600 if it has one.
  explicit EncoderFollow(const EncoderFollowSpec& spec);

  /// State from cycle to cycle.
  struct State {
    std::array<std::int64_t, max_filter> window{};  ///< the last `filter` increments
    int next = 0;                                   ///< index of the oldest increment
    std::int64_t sum = 0;                           ///< sum of the window
    Gear::State gear{};                             ///< remainder of the gear
    std::int64_t additive = 0;                      ///< pulses of add() that remain...
    std::int64_t cycles = 0;                        ///< number of cycles in which `additive` will
                                                    ///< be added
    std::int64_t pulses = 0;                        ///< pulses of the last add()...
    std::int64_t over = 1;  ///< number of cycles over which `pulses` are spread
    std::int64_t part = 0;  ///< remainder of a pulse, in 1/over
  };

  /// Returns the pulses of the slave in this cycle, for the increment of the encoder (counts).
  std::int64_t step(State& state, std::int64_t encoder_increment) const;

  /// Adds pulses to the slave (PosAdditive_Trig), independent of the ratio, spread evenly over the
  /// next `cycles` >= 1 cycles. After k of these cycles, floor(k pulses / cycles) pulses have been
  /// added, so the motion is always less than one pulse from a straight line. Pulses that remain
  /// from an earlier add() are spread together with the new ones. Throws InputError "cycles".
  static void add(State& state, std::int64_t pulses, std::int64_t cycles);

 private:
  Gear gear_;  // applied to the sum of the window: ratio / filter
  int filter_;
};

}  // namespace jounce
