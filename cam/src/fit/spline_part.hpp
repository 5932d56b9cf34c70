// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cam/src/fit/refine.hpp"

namespace jounce::cam_detail {

/// Changes a segment to the smoothest curve within the tolerances: a quintic spline through few
/// points, or a quintic. It may begin or end within the dwell or the
/// line beside it.
void spline_part(CamSpec& spec, std::size_t segment, const MeasuredCam& measured);

/// Gives the two ends of a periodic cam the slave position, velocity and acceleration of the
/// smoothest periodic curve within the tolerances.
void close_with_spline(CamSpec& spec, const MeasuredCam& measured);

/// Returns a cam of one quintic spline through few points.
CamSpec one_spline(const MeasuredCam& measured);

}  // namespace jounce::cam_detail
