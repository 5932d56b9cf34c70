// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/gear/rotary_knife.hpp"
#include "jounce/profiles/curve/curve.hpp"

#include "gear/src/cut/knife_shape.hpp"

namespace jounce::gear_detail {

/// The numbers of a rotary knife; angles in rad.
struct Knife {
  double pitch = 0;  ///< angle between two blades
  double contact = 0;
  KnifeSync sync = {};
  KnifeShape shape;
  double unit = 1;  ///< u per rad

  /// Lcrit: the longest cut without a stop.
  [[nodiscard]] double longest() const { return 2 * sync.length + shape.longest(); }
};

/// Returns the numbers of a knife. Throws InputError like rotary_knife().
Knife knife_of(const RotaryKnifeSpec& spec);

/// Returns the half of the sync zone after a cut, within the tolerance of the spec.
KnifeZone zone_of(const Knife& knife, const RotaryKnifeSpec& spec);

/// The cam whose last break is exactly at `length`, and whose last value is exactly `end`;
/// otherwise a million cuts would drift. The correction is within the rounding of the joints.
Cam closed(std::vector<Segment> segments, double length, double end);

}  // namespace jounce::gear_detail
