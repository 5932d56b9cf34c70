// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// A flying shear: a carriage that runs up to moving material, goes along with it while it is cut (or
/// sealed, printed, filled), brakes, and returns for the next piece.
///
///     FlyingShear shear{.cut_length = 1000, .line_speed = 1000, .sync_time = 0.15};     // mm, s
///     shear.limits = {.velocity = 2000, .acceleration = 10000};
///     SyncCam cam = flying_shear(shear);         // periodic over 1000 mm of the line
///     ShearPlan plan = shear_plan(shear);        // 187.5 + 150 + 187.5 + 475; stroke 337.5
///     ShearBound least = least_cut_length(shear);        // 966.4 mm, "return acceleration"
///     ShearBound fastest = greatest_line_speed(shear);   // at this length
///
/// **Vocabulary.** The master m is the material's travel, the slave u the carriage's along its guide.
/// The cam has five intervals: *accelerate*, *sync*, *decelerate*, *return*, *wait* (at home, where
/// `return_length` leaves any). It begins at home at rest, u = 0, and ends there exactly.
///
/// **Omitted values are computed.** The run-up and the braking are as short as the limits allow,
/// times `safety`; the return takes the rest. The default sync is the longest that the stroke and
/// the return allow.
///
/// **Throws** InputError for invalid numbers, and if no such motion is within the limits: it names
/// the binding limit and the least cut length, or the fastest line, that works.
struct FlyingShear {
  double cut_length = 0;  ///< m > 0: one cycle of the master
  double line_speed = 0;  ///< m/s > 0: at which the limits are to hold

  /// Time or distance for which carriage and material are in step. Give one of them, or neither:
  /// then it follows from the stroke.
  std::optional<double> sync_time = {};    ///< s > 0
  std::optional<double> sync_length = {};  ///< m > 0
  std::optional<double> stroke = {};       ///< u > 0: greatest distance from home

  /// m of the line while the carriage runs up, brakes, and returns.
  std::optional<double> acceleration_length = {};
  std::optional<double> deceleration_length = {};  ///< default: acceleration_length
  std::optional<double> return_length = {};

  /// Limits of the carriage over time: u/s, u/s^2, u/s^3. Position limits are not used; set `stroke`.
  Limits limits = {};
  double safety = 1;  ///< >= 1: factor of a run-up that is computed from the limits

  /// The speed of the ramps follows this law from 0 to 1: line (constant acceleration),
  /// simple_sine, poly345, poly4567, ... any symmetric one.
  Law ramp = Law::poly345;
  Law return_law = Law::poly345;  ///< any from rest to rest
  /// Example: scca with straight = 0.5 and shares 0, 1, 0 is the 1/4-1/2-1/4 trapezoid.
  LawForm return_form = {};

  double ratio = 1;  ///< u/m > 0: of the line's travel, e.g. 1000 for m to mm
  double angle = 0;  ///< rad, |angle| < pi/2: between guide and line; not 0: a diagonal saw
};

/// The intervals of the cycle, in m; they sum to cut_length exactly (to the bit).
struct ShearPlan {
  double accelerate = 0;
  double sync = 0;
  double decelerate = 0;
  double back = 0;
  double wait = 0;
  double ratio = 1;   ///< k in u/m: of the carriage along its guide while in step
  double stroke = 0;  ///< u
};

/// Greatest value of a quantity, and the binding limit: "sync velocity", "ramp acceleration", "ramp
/// jerk", "stroke", "return velocity", "return acceleration", "return jerk", "return length", "cut
/// length"; "" if nothing.
struct ShearBound {
  double value = 0;
  std::string quantity = {};
};

ShearPlan shear_plan(const FlyingShear& shear);
SyncCam flying_shear(const FlyingShear& shear);

/// The shear for another cut length, made for the fastest line that this length allows, at most
/// `line_speed`. nullopt if no speed works. Throws InputError if the sync follows from the stroke:
/// at the fastest line it would shrink to zero.
std::optional<SyncCam> fastest_shear(FlyingShear shear, double cut_length);

/// The shortest piece that can be cut at `line_speed`; cut_length is ignored. Infinite if no length
/// works. If the sync follows from the stroke, only longer pieces can be cut: at the bound the sync
/// is zero. Exact: closed form.
ShearBound least_cut_length(const FlyingShear& shear);

/// The fastest line for which `cut_length` is possible, independent of `line_speed`. Infinite
/// without a limit; 0 if no speed works. Bisected to the last digit: every requirement grows with
/// the speed.
ShearBound greatest_line_speed(const FlyingShear& shear);

}  // namespace jounce
