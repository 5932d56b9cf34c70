// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/optimize/outcome.hpp"
#include "jounce/profiles/limits/ramped_limits.hpp"

namespace jounce {

/// Bounds of a free quantity: lower <= value <= upper, both finite.
struct Bound {
  double lower = 0;
  double upper = 0;
};

/// The values at one knot that may change. A value without bounds stays as in the given cam. u is
/// the unit of the slave, m the unit of the master.
struct FreeKnot {
  std::size_t knot = 0;                        ///< 0: start of the cam; i: end of its i-th segment
  std::optional<Bound> master = {};            ///< bounds of the master position, m
  std::optional<Bound> slave = {};             ///< bounds of the slave position, u
  std::optional<Bound> geo_velocity = {};      ///< bounds, u/m
  std::optional<Bound> geo_acceleration = {};  ///< bounds, u/m^2
};

/// Figures to minimize, over the whole cam, with respect to the master (u/m^2, u/m^3).
enum class Objective {
  peak_acceleration,  ///< max |geo_acceleration|
  peak_jerk,          ///< max |geo_jerk|; at a knot, on both sides
  rms_acceleration,   ///< root of (integral of geo_acceleration^2 / length of the cam)
};

/// Returns the name in the spec: "peak geo_acceleration", "peak geo_jerk", "rms geo_acceleration".
const char* name(Objective objective);
/// Returns the objective with this name; nullopt if there is none.
std::optional<Objective> objective_named(std::string_view name);

/// Returns the value of the objective for a cam: from exact extrema, or by a quadrature that is
/// exact up to rounding.
double value_of(Objective objective, const Cam& cam);

/// A cam with free knots, and the objectives for them.
///
///     CamProblem problem{.cam = cam};
///     problem.free = {{.knot = 3, .master = Bound{205, 355}, .geo_velocity = Bound{-3, 3}}};
///     problem.limits = {.velocity = 3, .acceleration = 0.15};
///     problem.minimize = {Objective::peak_acceleration, Objective::peak_jerk};
///     const Outcome<CamSpec> outcome = optimize(problem);
///     if (outcome.usable()) Cam better = design(outcome.best).cam;
///
/// **Order.** The first objective is minimized. Then the second objective is minimized among all
/// cams whose first objective is within `tolerance` (relative) of the value that was reached, and
/// so on. A larger tolerance leaves more freedom for later objectives.
///
/// **Periodic cams.** The first and the last knot are the same knot: if one of them is free, both
/// change by the same amount. The master positions of the first and the last knot are never free.
///
/// **Laws** fix values at their ends:
/// - A polynomial (quintic, septic, nonic) accepts any free quantity.
/// - Next to a law from rest to rest, geo_acceleration is fixed.
/// - Next to a dwell, geo_acceleration, geo_velocity and slave are fixed.
/// - Next to a line or a law from rest to constant velocity, everything is fixed.
///
/// A cam with a law through points cannot be optimized.
struct CamProblem {
  CamSpec cam = {};                 ///< the given cam
  std::vector<FreeKnot> free = {};  ///< the free knots
  Limits limits = {};  ///< limits of the derivatives with respect to the master, over the whole cam
  std::vector<Objective> minimize = {};  ///< objectives, the most important first, no duplicates
  RampedLimits ramped = {};              ///< additional limits
  /// Defaults: 8 starts, of which the given cam is the first, and 50000 evaluations.
  OptimizeOptions options = {};
};

/// Throws InputError (keys like `segment[3].free.master`, `start.free.slave`, `tolerance`) unless
/// the problem is complete and consistent. The problem must have a valid cam and valid limits, an
/// objective, and at least one free quantity. Bounds must be finite, with lower <= upper, and
/// contain the given value. A quantity that a neighboring law fixes must not be free. Master
/// positions must be able to ascend.
void require_valid(const CamProblem& problem);

}  // namespace jounce
