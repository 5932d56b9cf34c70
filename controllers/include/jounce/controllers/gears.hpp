// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/gear/clutch.hpp"

/// The gear mode of a Googol iDEABOX Pro in its own words: pulses of the master and the slave. Manual
/// 7.5, I-31, I-111, I-140, I-141.
///
///     const Clutch clutch = googol::set_gear_ratio(Gear::ratio(0, 1), {2, 1, 100000});     // example 7-5
namespace jounce::googol {

/// GT_SetGearRatio: slave speed = master speed * slaveEven / masterEven.
struct GearRatio {
  std::int64_t master_even = 1;  ///< masterEven, > 0
  std::int64_t slave_even = 1;   ///< slaveEven, of either sign
  std::int64_t master_slope =
      0;  ///< masterSlope: the master's way through the clutch; not 1, not negative
};

/// Throws InputError "masterEven", "masterSlope" for a value that the manual excludes.
Gear gear(const GearRatio& ratio);

/// Changes the ratio from `from` (0: GT_GearStart) to `ratio`, over masterSlope. The law inside the
/// clutch is not in the manual: linear, see Clutch.
Clutch set_gear_ratio(const Gear& from, const GearRatio& ratio);

/// GT_PrfGear: dir 0 both, 1 positive, -1 negative. Throws InputError "dir".
DirectionMask prf_gear(int dir);

}  // namespace jounce::googol

/// The gear of an Agito controller (PCSuite manual 4.8).
namespace jounce::agito {

/// MasterFact: 65536 is 1 : 1, and 131072 and 196608 are 2 and 3. Any whole number, even a negative
/// one. Without a clutch: stop, set it, begin.
Gear gear(std::int64_t master_fact);

}  // namespace jounce::agito
