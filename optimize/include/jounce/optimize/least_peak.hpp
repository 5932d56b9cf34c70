// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/boundaries.hpp"

namespace jounce {

/// A cam whose omitted derivatives were chosen for the least max |geo_acceleration|.
struct LeastPeak {
  CamSpec cam;        ///< every derivative filled in
  double peak = 0;    ///< its max |geo_acceleration|, u/m^2, exact
  double bound = 0;   ///< certificate: no choice of the omitted values has a lower peak, u/m^2
  int solutions = 0;  ///< linear systems solved
};

/// The fill "minimum_peak_acceleration": chooses the values that the spec omits (free_derivatives()
/// in jounce/cam/design/boundaries.hpp) for the least max |geo_acceleration| over the whole cam, to
/// 1e-6 of it. Away from the peak this leaves a choice: of all cams within 1e-6 of the least peak,
/// the result has the least integral of geo_jerk^2.
///
///     LeastPeak least = filled_for_least_peak(spec);
///     Cam cam = design(least.cam).cam;                 // extrema(cam, 2).peak() is +-least.peak
///
/// A convex problem, solved with constraints at every master position, not at samples (an exchange
/// method, see optimize/src/knots/least_peak.cpp). The certificate follows from the multipliers by
/// weak duality: it holds even if the method has not converged. Throws InputError like
/// resolved_knots().
LeastPeak filled_for_least_peak(const CamSpec& spec);

}  // namespace jounce
