// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/design/design.hpp"

namespace jounce {

/// Rule for derivatives that a cam spec omits at its knots.
///
///     CamSpec spec{.start = {0, 0},
///                  .segments = {{Law::quintic, {90, 30}}, ...}, .periodic = true};
///     Cam smooth = design(filled(spec, Fill::minimum_jerk)).cam;
///
/// An omitted derivative at a knot is *free* if only quintics meet at the knot. If the knot belongs
/// to a line, a dwell or a law from rest to rest, the derivative has the value that this law
/// requires. The first and the last knot of a periodic cam are the same knot: a value given for one
/// of them applies to both, and a value that both omit is chosen once.
enum class Fill {
  rest,          ///< zero, unless an adjacent law requires another value (as in resolved_knots())
  minimum_jerk,  ///< the values with the least integral of geo_jerk^2 over the whole cam
};

/// Returns the word of the spec: "rest" or "minimum_jerk". For the third word of the spec,
/// "minimum_peak_acceleration", see filled_for_least_peak() in jounce/optimize/least_peak.hpp.
const char* name(Fill fill);

/// Free derivatives of one knot: the derivatives that a Fill may choose.
struct FreeDerivatives {
  bool geo_velocity = false;
  bool geo_acceleration = false;
};

/// Returns the free derivatives of every knot, start included. For a periodic cam, the first and
/// the last entry are equal. Throws like resolved_knots().
std::vector<FreeDerivatives> free_derivatives(const CamSpec& spec);

/// Returns the spec with every derivative filled in, except an acceleration that an adjacent law
/// determines. Exact to rounding (the solution of a linear system). Pass the result to design(). If
/// the cam is a single quintic without given derivatives, the result is the straight line. Throws
/// like resolved_knots().
CamSpec filled(CamSpec spec, Fill how);

}  // namespace jounce
