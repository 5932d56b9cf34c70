// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

/// The tables over time of PLCopen, as in a Leadshine PMC600 (PMC600 manual, volume 4, 4.1 and
/// 5.2.3; the blocks are from CODESYS): MC_PositionProfile, MC_VelocityProfile,
/// MC_AccelerationProfile. Times are in s, positions in the axis' unit u. The manual calls the
/// tables PVT, but each has only one column in addition to the time.
///
///     using namespace jounce::pmc600;
///     const ProfileTable stages{.points = {{1, 10000}, {2, 40000}, {1, -10000}, {0.5, -5000}},
///                               .is_absolute = false};                     // figure 5.13
///     const Trajectory f = position_profile(stages);                       // 4.5 s, to 35000
///     const Trajectory g = position_profile(stages, PositionRule::linear); // velocity steps
///     const Report report = velocity_steps(g);                             // lists these steps
///
/// The manual states only that the stages are continuous. These functions use the rules of the
/// blocks with the same names in the control software REXYGEN:
///
///     block                  between the points       continuous      begins with
///     MC_PositionProfile     cubic, or linear         velocity        the axis' position and velocity
///     MC_VelocityProfile     velocity linear          velocity        the axis' velocity
///     MC_AccelerationProfile acceleration linear      acceleration    the axis' acceleration
///
/// A *stage* lasts the delta_time of its point and leads to this point. The first stage begins at
/// the state of the axis. In an absolute table, the value at a point is scale * value + offset. In
/// a relative table, it is (value of the axis at Execute) + offset + scale * (sum of the values so
/// far); the offset is therefore applied once, in the first stage.
///
/// **Outside**, the curve holds: the axis stands at the end position. If the table ends in motion,
/// CODESYS puts the axis into error stop unless another block takes over; velocity_steps()
/// (warnings.hpp) reports such an end.
///
/// **Throws** InputError with the number of the controller's error, for tables of positions,
/// velocities and accelerations, in this order: 325, 350, 375 for the number of points; 326, 351,
/// 376 for a stage without duration.
namespace jounce::pmc600 {

/// Greatest number of points in MC_TP_REF, MC_TV_REF, MC_TA_REF.
inline constexpr int most_points = 100;

/// One point: SMC_TP, SMC_TV or SMC_TA.
struct ProfilePoint {
  double delta_time = 0;  ///< s, > 0: duration of the stage to this point
  double value = 0;       ///< position (u), velocity (u/s) or acceleration (u/s^2)
};

/// A table: MC_TP_REF, MC_TV_REF or MC_TA_REF, with the inputs of its block.
struct ProfileTable {
  std::vector<ProfilePoint> points = {};  ///< 1 to most_points
  bool is_absolute = true;  ///< IsAbsolute; false: each value is relative to the previous point
  double scale = 1;         ///< PositionScale, VelocityScale or AccelerationScale; may be negative
  double offset = 0;        ///< Offset, in the unit of the scaled values
  std::optional<int> number_of_pairs = {};  ///< number of points that are played; default: all
  std::optional<int> array_size = {};       ///< ArraySize: at least number_of_pairs, at most 100
  double from = 0;                          ///< u, position of the axis at Execute
  double from_velocity = 0;                 ///< u/s, velocity of the axis at Execute
  double from_acceleration = 0;             ///< u/s^2, acceleration of the axis at Execute; for
                                            ///< MC_AccelerationProfile
};

/// Motion between the points of a position table.
enum class PositionRule {
  /// Continuous velocity, from from_velocity to rest. The velocity at a point is the harmonic mean
  /// of Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5, 1984), 0 at a reversal. No overshoot,
  /// unless from_velocity exceeds 3 times the mean velocity of the first stage.
  cubic,
  /// Constant velocity in every stage, so that the velocity steps at every point (a literal reading
  /// of the manual).
  linear,
};

/// Returns the motion of MC_PositionProfile, MC_VelocityProfile and MC_AccelerationProfile, from 0
/// s.
Trajectory position_profile(const ProfileTable& table, PositionRule rule = PositionRule::cubic);
Trajectory velocity_profile(const ProfileTable& table);
Trajectory acceleration_profile(const ProfileTable& table);

}  // namespace jounce::pmc600
