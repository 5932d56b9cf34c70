// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "jounce/optimize/optimize.hpp"

#include "optimize/src/knots/subproblem.hpp"

/// The words and numbers of an outcome.
namespace jounce::optimize_detail {

/// Returns a number with six digits, for sentences.
std::string brief(double value, int digits = 6);

/// Returns "geo_velocity is -2.55 at master 273.6, the limit -2.5".
std::string sentence(const Finding& finding);

/// Returns the same for a broken limit: "...: exceeded by 2e-06 %".
std::string broken_sentence(const Finding& finding);

/// Returns the check of a cam against all limits, with the segments of the curve.
Report limits_of(const Limits& limits, const RampedLimits& ramped, const Cam& cam);

/// Returns Outcome::active for the cam at z. `figures`: results of `minimize`.
std::vector<Finding> active_findings(const Space& space, std::span<const DerivativeBound> ceilings,
                                     const Point& z, std::span<const Objective> minimize,
                                     std::span<const FigureResult> figures);

}  // namespace jounce::optimize_detail
