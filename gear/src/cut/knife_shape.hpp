// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

// Parts of the cut of a rotary knife; angles in rad.

namespace jounce::gear_detail {

/// The half of the sync zone after the cut: its size, and the derivatives at its end.
struct KnifeSync {
  double angle = 0;         ///< angle of the knife
  double length = 0;        ///< length of the web, m
  double velocity = 0;      ///< rad/m, at its end
  double acceleration = 0;  ///< rad/m^2; 0 for surface matching
  double jerk = 0;          ///< rad/m^3; 0 for surface matching
};

/// The segments of the sync zone.
struct KnifeZone {
  std::vector<Segment> leaving;  ///< from the cut at 0 on
  double strays = 0;             ///< rad, certified error of the fit of asin; 0 for a line

  /// The segments mirrored: they lead to the next cut at `pitch`.
  [[nodiscard]] std::vector<Segment> entering(double pitch) const;
};
KnifeZone knife_zone(const KnifeSync& sync, bool horizontal, double tolerance);

/// The recovery over `travel` rad. At both ends it has the velocity, acceleration and jerk of the
/// sync zone. It can have any length.
class KnifeShape {
 public:
  KnifeShape(std::vector<Segment> rise, const KnifeSync& sync, double travel);

  /// The recovery over the length b (m), which begins at `start` rad.
  [[nodiscard]] std::vector<Segment> recovery(double b, double start) const;
  /// Number of its segments.
  [[nodiscard]] std::size_t pieces() const { return rise_.size(); }
  /// Start of the segment `i`, as a share of the recovery.
  [[nodiscard]] double from(std::size_t i) const { return from_[i]; }
  /// The segment `i` of the recovery over the length b; does not allocate.
  [[nodiscard]] Segment piece(std::size_t i, double b, double start) const;
  /// Velocity in its middle, rad/m: the least or the greatest velocity.
  [[nodiscard]] double middle_velocity(double b) const;
  /// The length b for which the knife just comes to rest in the middle.
  [[nodiscard]] double longest() const;

 private:
  /// Coefficients c0 and c1 of (2).
  [[nodiscard]] std::pair<double, double> bend(double b) const;

  std::vector<Segment> rise_;
  std::vector<double> from_;  ///< start of each segment of the rise, and 1
  KnifeSync sync_;
  double travel_;
  double cv_;  ///< f'(1/2)
  /// True if the rise starts without jerk, so that the recovery can begin with the jerk of the
  /// zone.
  bool jerk_taken_;
};

}  // namespace jounce::gear_detail
