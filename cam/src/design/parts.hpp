// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "jounce/cam/design/runs.hpp"

// Parts for the runs of a cam and its inverse.

namespace jounce::cam_detail {

/// A motion below this share of a segment's magnitude is rounding.
constexpr double motion_rounding = 1e-15;
/// A jump, or a velocity, below this share of the greatest magnitude is rounding.
constexpr double joint_rounding = 1e-14;

/// Part of a segment over which the slave moves in one direction.
struct Part {
  double s0 = 0;
  double s1 = 1;
  CamRun::Kind kind = CamRun::Kind::dwell;
};

/// Cuts the segment at the zeros of its velocity; an interval without motion joins the previous
/// part.
std::vector<Part> parts(const Segment& f);

/// The master position at s of a segment, within the cam's breaks.
double master_at(const Cam& cam, std::size_t segment, double s);

/// Greatest magnitude of all segments.
double greatest_magnitude(const Cam& cam);

/// True if the slave's position steps by more than rounding from one run to the next.
bool jumps(const CamRun& before, const CamRun& after, double magnitude);

}  // namespace jounce::cam_detail
