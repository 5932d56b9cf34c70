// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "jounce/cam/design/runs.hpp"

// What the runs of a cam and its inverse are made of.

namespace jounce::detail {

/// A motion that is smaller than this share of a segment's magnitude is rounding.
constexpr double motion_rounding = 1e-15;
/// So is a jump that is smaller than this share of the greatest magnitude, or a velocity.
constexpr double joint_rounding = 1e-14;

/// Part of a segment over which the slave moves one way.
struct Part {
  double s0 = 0;
  double s1 = 1;
  CamRun::Kind kind = CamRun::Kind::dwell;
};

/// The segment cut where its velocity vanishes; what does not move joins the part before.
std::vector<Part> parts(const Segment& f);

/// The master position at s of a segment, within the cam's breaks.
double master_at(const Cam& cam, std::size_t segment, double s);

/// For all segments.
double greatest_magnitude(const Cam& cam);

/// True if the slave's position steps by more than rounding from one run to the next.
bool jumps(const CamRun& before, const CamRun& after, double magnitude);

}  // namespace jounce::detail
