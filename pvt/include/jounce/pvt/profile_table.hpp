// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

/// The time tables of PLCopen as a Leadshine PMC600 has them (PMC600 manual, volume 4, 4.1 and 5.2.3; the blocks are
/// CODESYS's): MC_PositionProfile, MC_VelocityProfile, MC_AccelerationProfile, in s and u. 5.2.3 calls them PVT; none
/// of them has more than one column in addition to the time.
///
///     using namespace jounce::pmc600;
///     const ProfileTable stages{.points = {{1, 10000}, {2, 40000}, {1, -10000}, {0.5, -5000}},
///                               .is_absolute = false};                     // figure 5.13
///     const Trajectory f = position_profile(stages);                       // 4.5 s, to 35000
///     const Trajectory g = position_profile(stages, PositionRule::linear); // steps of velocity
///     const Report report = velocity_steps(g);                             // ... as they are named
///
/// The manual states only that the stages are continuous. Here:
///
///     block                  between the points       continuous      begins with
///     MC_PositionProfile     cubic, or linear         velocity        the axis' position and velocity
///     MC_VelocityProfile     velocity linear          velocity        the axis' velocity
///     MC_AccelerationProfile acceleration linear      acceleration    the axis' acceleration
///
/// like REXYGEN's blocks of the same names. Every stage lasts its point's delta_time; the first
/// leads from the axis' state to point 1. Absolute: a knot's value is scale * value + offset.
/// Relative: it is the axis' value at Execute + offset + scale * (sum of the values so far). So the
/// offset shifts the whole curve once, in the first stage, not at every point.
///
/// **Outside** it holds: the axis stands at the end position. If the table ends moving, CODESYS
/// puts the axis into errorstop unless another block takes over; velocity_steps (warnings.hpp)
/// names it.
///
/// **Throws** InputError, naming the controller's error: 325, 350, 375 for the number of points; 326,
/// 351, 376 for a stage of no time.
namespace jounce::pmc600 {

inline constexpr int most_points =
    100;  ///< most points of the array in MC_TP_REF, MC_TV_REF, MC_TA_REF

/// SMC_TP, SMC_TV, SMC_TA.
struct ProfilePoint {
  double delta_time = 0;  ///< s, > 0: from the point before
  double value = 0;       ///< position, u; velocity, u/s; acceleration, u/s^2
};

/// MC_TP_REF, MC_TV_REF, MC_TA_REF with the block's inputs.
struct ProfileTable {
  std::vector<ProfilePoint> points = {};
  bool is_absolute = true;  ///< IsAbsolute; else each value counts from the one before
  double scale = 1;         ///< PositionScale, ...; may be negative
  double offset = 0;        ///< Offset, in the unit of the scaled value
  std::optional<int> number_of_pairs = {};  ///< number of played points; default: all
  std::optional<int> array_size = {};       ///< ArraySize, at least number_of_pairs, at most 100
  double from = 0;                          ///< u: the axis at Execute
  double from_velocity = 0;                 ///< u/s
  double from_acceleration = 0;             ///< u/s^2: for MC_AccelerationProfile
};

/// Interpretation of a position table.
enum class PositionRule {
  /// Velocity continuous, from from_velocity to rest, and no overshoot except for a from_velocity
  /// of more than 3 times the first stage's mean: the harmonic mean of Fritsch and Butland (SIAM J.
  /// Sci. Stat. Comput. 5, 1984), 0 at a reversal.
  cubic,
  /// The literal one: constant velocity in every stage, which steps at every point.
  linear,
};

Trajectory position_profile(const ProfileTable& table, PositionRule rule = PositionRule::cubic);
Trajectory velocity_profile(const ProfileTable& table);
Trajectory acceleration_profile(const ProfileTable& table);

}  // namespace jounce::pmc600
