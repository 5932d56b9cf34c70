// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"

namespace jounce {

/// A clutch: the ratio changes over a distance of the master. Units: u for the slave, m for the
/// master.
struct RatioChange {
  double at = 0;        ///< m, where the change begins
  double ratio = 1;     ///< u/m, the new ratio; any sign, 0 stops the slave
  double distance = 0;  ///< m, >= 0; 0: at once, so the slave's velocity steps
  Law law = Law::line;  ///< law of the change: a line, or any law from rest to rest
};

/// A phase shift: a move of the slave relative to the gear.
struct PhaseShift {
  double at = 0;           ///< m, where the shift begins
  double shift = 0;        ///< u, any sign
  double distance = 0;     ///< m, > 0: length of the shift
  Law law = Law::poly345;  ///< any law from rest to rest
};

/// The course of a gear along its master: its ratio, changes of the ratio, and phase shifts.
///
///     GearCourse course{.master_end = 200000, .changes = {{0, 0.5, 100000}}};  // Googol example 7-5
///     SyncCam slave = gear_course(course);          // 25000 u at the clutch's end, then 0.5 u/m
///
/// In a clutch of length d from ratio r0 to r1, z is the share of d that the master has passed, and
/// f is the law (from 0 to 1):
///
///     (1)  ratio = r0 + (r1 - r0) f(z)
///     (2)  slave = d (r0 z + (r1 - r0) F(z)),   F(z) the integral of f
///
/// For every symmetric law, such as the line, the slave moves by d (r0 + r1) / 2 in the clutch.
struct GearCourse {
  double master_start = 0;  ///< m, start of the cam
  double master_end = 0;    ///< m, end of the cam; above master_start
  double slave_start = 0;   ///< u, at master_start
  double ratio = 0;         ///< u/m, before the first change; 0: the slave stands still
  /// In order; each begins at the end of the previous one, or later.
  std::vector<RatioChange> changes = {};
  std::vector<PhaseShift> shifts = {};  ///< at any master position, also across clutches and other
                                        ///< shifts
};

/// Returns the exact cam of the slave. A cam that begins and ends at rest holds outside; any other
/// cam refuses. The names of its segments are "hold" (ratio 0), "gear" (constant ratio), "clutch",
/// and "phase" (a shift). The zones are the "gear" segments.
///
/// Throws InputError "master_end", "change[i].at", "change[i].distance" or "shift[i]...." (i from
/// 1) if changes overlap, leave the course, or are out of range. Throws InputError "...law" for a
/// law through points, and for a law that needs velocities (R-U laws).
SyncCam gear_course(const GearCourse& course);

}  // namespace jounce
