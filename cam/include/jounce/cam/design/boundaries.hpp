// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/design/design.hpp"

namespace jounce {

/// Rule for derivatives that a cam leaves out.
///
///     CamSpec spec{.start = {0, 0}, .segments = {{Law::quintic, {90, 30}}, ...}, .periodic = true};
///     Cam smooth = design(filled(spec, Fill::minimum_jerk)).cam;
///
/// What a spec leaves out at a knot is *free* if nothing but quintics meet there: both segments
/// beside it, or the only one at an end. Beside a line, a dwell or a rest-to-rest law it is what that
/// law has there. Start and last knot of a periodic cam are one: what one of them gives holds for
/// both, and what both leave out is chosen once.
enum class Fill {
  rest,          ///< zero where nothing else is demanded, as resolved_knots() does
  minimum_jerk,  ///< least integral of geo_jerk^2 over the whole cam
};

/// "rest", "minimum_jerk": the words of the spec. The third one, "minimum_peak_acceleration", is a
/// convex program: filled_for_least_peak() in jounce/optimize/least_peak.hpp.
const char* name(Fill fill);

/// Derivatives of one knot that a Fill may choose.
struct FreeDerivatives {
  bool geo_velocity = false;
  bool geo_acceleration = false;
};

/// One for each knot, start included; of a periodic cam the first and the last are equal. Throws as
/// resolved_knots() does.
std::vector<FreeDerivatives> free_derivatives(const CamSpec& spec);

/// The spec with every derivative filled in (but an acceleration that a law beside it has of its
/// own), exact to rounding (a positive definite linear system).
/// design() of it is that cam. Where a whole cam is one quintic from which all four are left out, it
/// is the straight line. Throws as resolved_knots() does.
CamSpec filled(CamSpec spec, Fill how);

}  // namespace jounce
