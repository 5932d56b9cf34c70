// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/design/design.hpp"

namespace jounce {

/// Rule for derivatives that a cam omits.
///
///     CamSpec spec{.start = {0, 0},
///                  .segments = {{Law::quintic, {90, 30}}, ...}, .periodic = true};
///     Cam smooth = design(filled(spec, Fill::minimum_jerk)).cam;
///
/// An omitted derivative at a knot is *free* if only quintics meet there: both segments beside it,
/// or the only one at an end. Beside a line, a dwell or a rest-to-rest law, it takes the value of
/// that law. The first and last knot of a periodic cam are one: a value given at one of them holds
/// for both, and a value that both omit is chosen once.
enum class Fill {
  rest,          ///< zero unless another rule requires a value, as in resolved_knots()
  minimum_jerk,  ///< least integral of geo_jerk^2 over the whole cam
};

/// "rest", "minimum_jerk": the words of the spec. The third word, "minimum_peak_acceleration", is a
/// convex program: filled_for_least_peak() in jounce/optimize/least_peak.hpp.
const char* name(Fill fill);

/// Derivatives of one knot that a Fill may choose.
struct FreeDerivatives {
  bool geo_velocity = false;
  bool geo_acceleration = false;
};

/// One entry for each knot, start included; for a periodic cam the first and the last are equal.
/// Throws like resolved_knots().
std::vector<FreeDerivatives> free_derivatives(const CamSpec& spec);

/// Returns the spec with every derivative filled in (except an acceleration that an adjacent law
/// defines itself), exact to rounding (a positive definite linear system). Apply design() to it. If
/// a whole cam is one quintic with none of its four derivatives given, the result is the straight
/// line. Throws like resolved_knots().
CamSpec filled(CamSpec spec, Fill how);

}  // namespace jounce
