// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/boundaries.hpp"

namespace jounce {

/// A cam whose left-out derivatives were chosen for the least max |geo_acceleration|.
struct LeastPeak {
  CamSpec cam;        ///< every derivative filled in
  double peak = 0;    ///< its max |geo_acceleration|, u/m^2, exact
  double bound = 0;   ///< certificate: no choice of what was left out is below, u/m^2
  int solutions = 0;  ///< linear systems solved
};

/// The fill "minimum_peak_acceleration": what the spec leaves out (free_derivatives() in
/// see jounce/cam/design/boundaries.hpp) is chosen for the least max |geo_acceleration| over the whole
/// cam, to 1e-6 of it. That leaves a choice wherever the cam is not at its hardest: of all cams within
/// 1e-6 of the least peak it is the one with the least integral of geo_jerk^2.
///
///     LeastPeak least = filled_for_least_peak(spec);
///     Cam cam = design(least.cam).cam;                 // extrema(cam, 2).peak() is +-least.peak
///
/// A convex problem, imposed at every master position and not at samples (an exchange method, see
/// optimize/src/knots/least_peak.cpp). The certificate follows from the multipliers by weak duality: it holds
/// whether the method has converged or not. Throws InputError as resolved_knots() does.
LeastPeak filled_for_least_peak(const CamSpec& spec);

}  // namespace jounce
