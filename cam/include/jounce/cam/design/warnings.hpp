// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Permitted but possibly unintended features, as findings of Severity::warning; none of them
/// counts as a broken limit.
///
///     CamDesign made = design(spec);
///     Report odd = warnings(made.cam, made.origin);
///
/// For each segment of the design:
///
/// - "warning/overshoot": the slave passes beyond both end positions. value: the position reached,
///   limit: the end position passed. Only a note if the end velocities make it inevitable.
/// - "warning/reversal": the velocity changes sign although both ends move the same way, or one or
///   both rest. value: the greatest velocity backwards, limit: 0. Only a note if the segment ends
///   behind its start, so that it must reverse.
/// - "warning/velocity_overshoot": between rest and a constant velocity (VDI 2143: R-G, G-R) the
///   velocity passes beyond that velocity. value: the velocity reached, limit: the required
///   velocity.
/// - "warning/ripple": the acceleration changes sign, by more than 1e-3 of the cam's peak, although
///   both ends accelerate the same way. In a table this means that the columns are not derivatives
///   of one another. value: the greatest acceleration of the opposite sign to that at the ends,
///   limit: 0.
///
/// The advice for an R-G or G-R quintic names rho = slope times length over stroke and the window
/// without reversal (rho <= 5/2) and without velocity overshoot (rho >= 5/3).
///
/// For each joint, and at the ends of a cam that wraps or holds: "joint/position",
/// "joint/geo_velocity", "joint/geo_acceleration", "joint/geo_jerk" for the lowest derivative that
/// steps (a step of the jerk is only a note). value: the step's size; limit: the tolerance for
/// rounding, 1e-9 of the derivative's peak; for the position, of the travel.
///
/// The margin is minus the excess as a share of the cam's travel, or of the derivative's peak in
/// the cam; excesses up to 1e-9 do not count.
///
/// `origin[i]` is the design's segment of the cam's segment i (CamDesign::origin); omitted: each
/// segment is its own. Findings name the cam's segment that contains the worst position.
Report warnings(const Cam& cam, std::span<const std::size_t> origin = {});

}  // namespace jounce
