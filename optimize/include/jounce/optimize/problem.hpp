// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/optimize/outcome.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Bounds of a free quantity: lower <= value <= upper, both finite.
struct Bound {
  double lower = 0;
  double upper = 0;
};

/// The quantities of one knot that may be changed; an omitted one stays as in the cam.
struct FreeKnot {
  std::size_t knot = 0;  ///< 0: the start of the cam; i: the end of its i-th segment
  std::optional<Bound> master;
  std::optional<Bound> slave;
  std::optional<Bound> geo_velocity;
  std::optional<Bound> geo_acceleration;
};

/// Figures to minimize, over the whole cam and per master unit (u/m^2, u/m^3).
enum class Objective {
  peak_acceleration,  ///< max |geo_acceleration|
  peak_jerk,          ///< max |geo_jerk|, both sides of every knot
  rms_acceleration,   ///< sqrt(integral of geo_acceleration^2 / length of the cam)
};

/// "peak geo_acceleration", "peak geo_jerk", "rms geo_acceleration": the words of the spec.
const char* name(Objective objective);
std::optional<Objective> objective_named(std::string_view name);

/// The objective's value for a cam: exact extrema, respectively a quadrature exact to rounding.
double value_of(Objective objective, const Cam& cam);

/// The slave's limits behind a master that also accelerates. With ramp = a / w^2, a the master's greatest
/// acceleration and w its speed,
///
///     |f''| + ramp |f'| <= limits.acceleration,   |f'''| + 3 ramp |f''| <= limits.jerk
///
/// hold over the whole cam, as in greatest_master_velocity()
/// (jounce/cam/coupling/master_limits.hpp).
struct RampedLimits {
  double ramp = 0;     ///< 1/m, >= 0; 0: no limits of this kind
  Limits limits = {};  ///< per master unit: acceleration and jerk alone are used
};

/// A cam with free quantities, and the objectives for them.
///
///     CamProblem problem{.cam = cam};
///     problem.free = {{.knot = 3, .master = Bound{205, 355}, .geo_velocity = Bound{-3, 3}}};
///     problem.limits = {.velocity = 3, .acceleration = 0.15};
///     problem.minimize = {Objective::peak_acceleration, Objective::peak_jerk};
///     const Outcome<CamSpec> outcome = optimize(problem);
///     if (outcome.usable()) Cam better = design(outcome.best).cam;
///
/// **Order.** The first objective is minimized; then the second among the cams whose first is
/// within `tolerance` (relative) of what was reached; and so on. A larger tolerance gives the later
/// objectives more slack.
///
/// **Periodic cams.** Start and last knot are one: whichever of the two is named, both change by
/// the same amount. The masters of the two ends are never free.
///
/// **Laws.** A polynomial (quintic, septic, nonic) takes any free quantity at its ends. Beside a law
/// that runs from rest to rest geo_acceleration is fixed, beside a dwell also geo_velocity and slave,
/// beside a line or an R-U law everything. A cam with a law through points is not optimized.
struct CamProblem {
  CamSpec cam;
  std::vector<FreeKnot> free;
  Limits limits;                    ///< per master unit; hold over the whole cam
  std::vector<Objective> minimize;  ///< most important first; no duplicates
  RampedLimits ramped = {};         ///< hold as well
  /// 8 starts, of which the given cam is the first, and 50000 evaluations unless stated.
  OptimizeOptions options = {};
};

/// Throws InputError (keys like `segment[3].free.master`, `start.free.slave`, `tolerance`) unless
/// the problem is well posed: a valid cam and limits, something free, each bound finite with
/// lower <= upper and around the given value, nothing free that a law beside it fixes, masters that
/// can be put in ascending order, an objective.
void require_valid(const CamProblem& problem);

}  // namespace jounce
