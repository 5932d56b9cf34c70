// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/gear/clutch.hpp"

/// The gear mode of a Googol iDEABOX Pro, with the names of its manual (7.5, I-31, I-111, I-140,
/// I-141). Positions of master and slave are in pulses.
///
///     const Clutch clutch = googol::set_gear_ratio(Gear::ratio(0, 1), {2, 1, 100000});     // example 7-5
namespace jounce::googol {

/// Parameters of GT_SetGearRatio: slave speed = master speed * slaveEven / masterEven.
struct GearRatio {
  std::int64_t master_even = 1;   ///< masterEven, > 0
  std::int64_t slave_even = 1;    ///< slaveEven, any sign
  std::int64_t master_slope = 0;  ///< masterSlope: master travel of the clutch, pulses, >= 0, not 1
};

/// Returns the gear without its clutch. Throws InputError with the key "masterEven" or
/// "masterSlope" for a value that the manual excludes.
Gear gear(const GearRatio& ratio);

/// Returns the change of the ratio from `from` (0: after GT_GearStart) to `ratio`, over the master
/// travel masterSlope. The manual does not define the law of the clutch; Clutch is linear.
Clutch set_gear_ratio(const Gear& from, const GearRatio& ratio);

/// Returns the direction of GT_PrfGear: dir 0: both, 1: positive, -1: negative. Throws InputError
/// with the key "dir" for another value.
DirectionMask prf_gear(int dir);

}  // namespace jounce::googol

/// The gear of an Agito controller (PCSuite IDE manual 4.8).
namespace jounce::agito {

/// Returns the gear of MasterFact: 65536 is 1 : 1, 131072 is 2 : 1. Any whole number is permitted,
/// even a negative one. The controller has no clutch: to change the ratio, a program stops the
/// axis, sets MasterFact, and begins again.
Gear gear(std::int64_t master_fact);

}  // namespace jounce::agito
