// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/boundaries.hpp"

namespace jounce {

/// A cam whose omitted derivatives have the values with the least max |geo_acceleration|. u is the
/// unit of the slave, m the unit of the master.
struct LeastPeak {
  CamSpec cam = {};  ///< the cam, with all derivatives
  double peak = 0;   ///< max |geo_acceleration| of the cam, u/m^2, exact
  /// Proven lower bound: no choice of the omitted values has a lower peak, u/m^2.
  double bound = 0;
  int solutions = 0;  ///< number of linear systems that were solved
};

/// Chooses the values that a spec omits (fill "minimum_peak_acceleration"; see free_derivatives()
/// in jounce/cam/design/boundaries.hpp). The result has the least max |geo_acceleration| over the
/// whole cam, to 1e-6 of its value. Of the many cams with this peak, the result is the one with the
/// least integral of geo_jerk^2.
///
///     LeastPeak least = filled_for_least_peak(spec);
///     Cam cam = design(least.cam).cam;                 // extrema(cam, 2).peak() is +-least.peak
///
/// The problem is convex. Its constraints hold at every master position, not at samples (an
/// exchange method, see optimize/src/knots/least_peak.cpp). The bound follows from the multipliers
/// by weak duality, so it is valid even if the method has not converged. Throws InputError like
/// resolved_knots().
LeastPeak filled_for_least_peak(const CamSpec& spec);

}  // namespace jounce
