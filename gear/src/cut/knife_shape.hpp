// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/curve/segment.hpp"

// Parts of a rotary knife's cut; angles in rad.

namespace jounce::gear_detail {

/// Half of the sync zone, from the cut on: how far it goes, and with what it ends.
struct KnifeSync {
  double angle = 0;         ///< angle of the knife
  double length = 0;        ///< length of the web, m
  double velocity = 0;      ///< rad/m, at its end
  double acceleration = 0;  ///< rad/m^2; 0 for surface matching
  double jerk = 0;          ///< rad/m^3; 0 for surface matching
};

/// The zone's own segments.
struct KnifeZone {
  std::vector<Segment> leaving;  ///< from the cut at 0 on
  double strays = 0;             ///< rad, certified, from asin; 0 where it is a line

  /// The same mirrored, up to the next cut at `pitch`.
  [[nodiscard]] std::vector<Segment> entering(double pitch) const;
};
KnifeZone knife_zone(const KnifeSync& sync, bool horizontal, double tolerance);

/// The recovery of `travel` rad that takes over from the zone and hands over to it, over any length.
class KnifeShape {
 public:
  KnifeShape(std::vector<Segment> rise, const KnifeSync& sync, double travel);

  /// Over b, from `start` rad.
  [[nodiscard]] std::vector<Segment> recovery(double b, double start) const;
  /// rad/m in its middle, where it is least or greatest.
  [[nodiscard]] double middle_velocity(double b) const;
  /// The b at which the knife just stands still in the middle.
  [[nodiscard]] double longest() const;

 private:
  /// Coefficients c0 and c1 of (2).
  [[nodiscard]] std::pair<double, double> bend(double b) const;

  std::vector<Segment> rise_;
  KnifeSync sync_;
  double travel_;
  double cv_;        ///< f'(1/2)
  bool jerk_taken_;  ///< the rise starts without jerk, so that the zone's can be taken over
};

}  // namespace jounce::gear_detail
