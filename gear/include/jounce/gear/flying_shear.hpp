// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// A flying shear: a carriage that accelerates to the speed of moving material, moves with it while
/// it cuts (or seals, prints, fills), brakes, and returns for the next piece.
///
///     FlyingShear shear{.cut_length = 1000, .line_speed = 1000, .sync_time = 0.15};     // mm, s
///     shear.limits = {.velocity = 2000, .acceleration = 10000};
///     SyncCam cam = flying_shear(shear);         // periodic over 1000 mm of the line
///     ShearPlan plan = shear_plan(shear);        // lengths 187.5, 150, 187.5, 475; stroke 337.5
///     ShearBound least = least_cut_length(shear);        // 966.4 mm, "return acceleration"
///     ShearBound fastest = greatest_line_speed(shear);   // at this length
///
/// **Vocabulary.** The master is the travel of the material, in its unit m. The slave is the travel
/// of the carriage along its guide, in its unit u. The cam has five intervals: *accelerate*,
/// *sync*, *decelerate*, *return*, and *wait* at home if `return_length` leaves a part of the
/// cycle. The cam begins at home (position 0) at rest, and ends exactly at home.
///
/// **Omitted values are computed.** Accelerating and braking take the shortest lengths that the
/// limits permit, times `safety`. The return takes the rest of the cycle. If sync_time and
/// sync_length are omitted, the sync is the longest that the stroke and the return permit.
///
/// **Throws** InputError for invalid numbers, and if no such motion is within the limits. The
/// message of the latter error names the limit, and the least cut length or the fastest line that
/// is possible.
struct FlyingShear {
  double cut_length = 0;  ///< m, > 0: one cycle of the master
  double line_speed = 0;  ///< m/s, > 0: line speed at which the limits must hold

  /// Time or distance for which carriage and material are in step. Give at most one of them; if
  /// both are omitted, `stroke` is required, and the sync is as long as the stroke and the return
  /// permit.
  std::optional<double> sync_time = {};    ///< s, > 0
  std::optional<double> sync_length = {};  ///< m, > 0
  std::optional<double> stroke = {};       ///< u, > 0: limit of the distance from home

  /// Travel of the line (m) while the carriage accelerates, brakes, and returns. If
  /// acceleration_length is omitted, it is computed from the limits, and the limit of the
  /// acceleration or of the jerk is required.
  std::optional<double> acceleration_length = {};
  std::optional<double> deceleration_length = {};  ///< default: acceleration_length
  std::optional<double> return_length = {};

  /// Limits of the carriage over time: u/s, u/s^2, u/s^3. Position limits are not used; set
  /// `stroke`.
  Limits limits = {};
  /// >= 1: multiplies the lengths of ramps that are computed from the limits
  double safety = 1;  ///< >= 1: factor of ramp lengths that are computed from the limits

  /// Law of the carriage's speed in both ramps, from 0 to 1: line (constant acceleration),
  /// simple_sine, poly345, poly4567, ...; any symmetric law.
  Law ramp = Law::poly345;
  Law return_law = Law::poly345;  ///< law of the return: any law from rest to rest
  /// Shape of the return law. Example: scca with straight = 0.5 and shares 0, 1, 0 is the
  /// 1/4-1/2-1/4 trapezoid.
  LawForm return_form = {};

  /// u/m, > 0: converts the line's travel to the slave's unit, such as 1000 for a line in meters
  /// and a carriage in mm.
  double ratio = 1;
  /// rad, |angle| < pi/2: angle between guide and line; not 0 for a diagonal saw.
  double angle = 0;
};

/// The intervals of the cycle, in m; their sum is exactly cut_length.
struct ShearPlan {
  double accelerate = 0;
  double sync = 0;
  double decelerate = 0;
  double back = 0;  ///< the return
  double wait = 0;
  /// u/m: travel of the carriage per travel of the line in the sync zone, FlyingShear::ratio /
  /// cos(angle).
  double ratio = 1;
  double stroke = 0;  ///< u, greatest distance from home
};

/// A bound, and the limit that determines it: "sync velocity", "ramp acceleration", "ramp jerk",
/// "stroke", "return velocity", "return acceleration", "return jerk", "return length", "cut
/// length"; "" if no limit does.
struct ShearBound {
  double value = 0;           ///< m or m/s
  std::string quantity = {};  ///< the limit
};

/// Returns the intervals of the cycle. Throws InputError as described for FlyingShear.
ShearPlan shear_plan(const FlyingShear& shear);
/// Returns the cam of one cycle. Throws InputError as described for FlyingShear.
SyncCam flying_shear(const FlyingShear& shear);

/// Returns the cam for another cut length, at the fastest line speed that this length permits, but
/// at most `line_speed`. Returns nullopt if no speed is possible. Throws InputError if the stroke
/// determines the sync, because the sync would then shrink to zero at the fastest speed.
std::optional<SyncCam> fastest_shear(FlyingShear shear, double cut_length);

/// Returns the least cut length (m) that is possible at `line_speed`; shear.cut_length is not used.
/// Returns infinity if no length is possible. If the stroke determines the sync, the sync is zero
/// at the bound, so only longer pieces can be cut. Exact: closed form.
ShearBound least_cut_length(const FlyingShear& shear);

/// Returns the greatest line speed (m/s) at which `cut_length` is possible; shear.line_speed must
/// be > 0: the search begins at this speed, but the result does not depend on it. Returns infinity
/// if nothing limits the speed, and 0 if no speed is possible. Every requirement grows with the
/// speed, so bisection finds the bound to the last digit.
ShearBound greatest_line_speed(const FlyingShear& shear);

}  // namespace jounce
