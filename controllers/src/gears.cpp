// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/gears.hpp"

#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {

Gear googol::gear(const GearRatio& ratio) {
  if (ratio.master_even <= 0)
    throw InputError("masterEven", std::to_string(ratio.master_even), "must be greater than 0");
  return Gear::ratio(ratio.slave_even, ratio.master_even);
}

Clutch googol::set_gear_ratio(const Gear& from, const GearRatio& ratio) {
  const auto refuse = [&](const char* rule) {
    throw InputError("masterSlope", std::to_string(ratio.master_slope), rule);
  };
  if (ratio.master_slope < 0)
    refuse("must not be negative: it is a distance, whichever way the master goes (manual I-140)");
  if (ratio.master_slope == 1)
    refuse(
        "must not be 1 (manual I-140): a single pulse is no clutch; 0 changes the ratio at once");
  return {from, gear(ratio), ratio.master_slope};
}

DirectionMask googol::prf_gear(int dir) {
  if (dir < -1 || dir > 1)
    throw InputError("dir", std::to_string(dir), "must be 0 (both), 1 (positive) or -1 (negative)");
  return {static_cast<FollowDirection>(dir)};
}

Gear agito::gear(std::int64_t master_fact) {
  return Gear::ratio(master_fact, 65536);
}

}  // namespace jounce
