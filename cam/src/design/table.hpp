// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/laws/spline.hpp"

#include "cam/src/design/least_energy.hpp"

namespace jounce::cam_detail {

/// Throws InputError unless there are at least `least` points, all finite, masters ascending, and
/// the tolerances zero or, if allowed, finite and >= 0.
void require_points(const std::vector<SplinePoint>& points, std::size_t least, bool tolerances);

/// Throws InputError for a derivative at an end other than SplineEnds::natural, and for one that is
/// not finite.
void require_ends(const SplineSpec& spec);

/// Fixes the derivatives that the end gives and frees the others.
void give(EnergyKnot& knot, const SplineEnd& end);

}  // namespace jounce::cam_detail
