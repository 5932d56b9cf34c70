// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A finished cam with the names of its segments.
struct NamedCam {
  Cam cam;
  /// The name of each segment in reports, such as "2 return": all pieces of one law have the same
  /// name. A segment that was made from another has the name of this other segment.
  std::vector<std::string> names = {};
  /// Bounds of the errors of the position (u, unit of the slave) and of geo_velocity (u/m, m: unit
  /// of the master) that operators with a tolerance cause.
  double error = 0, velocity_error = 0;
};

/// Rule for derivatives that the knots of a cam omit.
enum class Boundaries {
  rest,                       ///< zero, unless a neighbor requires another value
  minimum_jerk,               ///< least rms of geo_jerk: jounce/cam/design/boundaries.hpp
  minimum_peak_acceleration,  ///< least peak of geo_acceleration: jounce/optimize/least_peak.hpp
};

/// Returns the knots with every omitted derivative, chosen by the rule.
CamSpec filled(const CamSpec& cam, Boundaries rule);

/// Designs the cam of the knots. Its names are "1", "2 rise", ... Throws InputError like design().
NamedCam named(const CamSpec& cam, Boundaries rule);

}  // namespace jounce
