// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Reports features of a cam that are permitted but possibly not intended, as findings of
/// Severity::warning. No finding is broken.
///
///     CamDesign made = design(spec);
///     Report odd = warnings(made.cam, made.origin);
///
/// For each segment of the design (`value` and `limit` are members of the finding):
///
/// - "warning/overshoot": the slave moves beyond both end positions. value: the extreme position;
///   limit: the end position that the slave passes. A note, not a warning, if the end velocities
///   make the overshoot inevitable.
/// - "warning/reversal": the velocity changes sign, although the slave moves in one direction at
///   both ends, or rests at an end. value: the greatest velocity backwards; limit: 0. A note, not a
///   warning, if the segment ends behind its start, so that it must reverse.
/// - "warning/velocity_overshoot": between rest and a constant velocity (VDI 2143: R-G, G-R) the
///   velocity exceeds the constant velocity. value: the peak velocity; limit: the constant
///   velocity.
/// - "warning/ripple": the acceleration changes sign, by more than 1e-3 of the cam's peak, although
///   the slave accelerates in the same direction at both ends. In a table, the cause is that the
///   columns are not derivatives of one another. value: the peak acceleration of the opposite sign;
///   limit: 0.
///
/// The advice for an R-G or G-R quintic uses rho = slope * length / stroke: no reversal for rho <=
/// 5/2, no velocity overshoot for rho >= 5/3.
///
/// For each break of the cam, and for the ends of a cam that wraps, advances or holds, there is one
/// finding, for the lowest derivative that steps: "joint/position", "joint/geo_velocity",
/// "joint/geo_acceleration" or "joint/geo_jerk" (always a note). value: size of the step; limit:
/// tolerance for rounding, 1e-9 of the derivative's peak (for the position: of the travel).
///
/// The margin is the excess over the limit (for a break: the step) with a negative sign, as a share
/// of the cam's travel or of the derivative's peak in the cam. An excess up to 1e-9 does not count
/// (for a ripple: up to 1e-3).
///
/// `origin[i]` is the segment of the design to which segment i of the cam belongs
/// (CamDesign::origin). If `origin` is omitted, each segment of the cam is a segment of the design.
/// Finding::segment is the segment of the cam that contains the worst position.
Report warnings(const Cam& cam, std::span<const std::size_t> origin = {});

}  // namespace jounce
