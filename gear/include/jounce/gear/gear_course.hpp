// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"

namespace jounce {

/// The ratio becomes another one over a distance of the master: a clutch. u/m, m.
struct RatioChange {
  double at = 0;        ///< m, where it begins
  double ratio = 1;     ///< u/m, afterwards; either sign, 0 stops the slave
  double distance = 0;  ///< m, >= 0; 0: at once, the slave's velocity steps
  Law law = Law::line;  ///< by which the ratio goes: a line, or any law from rest to rest
};

/// The slave is moved against its master: a profile laid over the gear.
struct PhaseShift {
  double at = 0;           ///< m, where it begins
  double shift = 0;        ///< u, of either sign
  double distance = 0;     ///< m, > 0, over which it is made
  Law law = Law::poly345;  ///< any law from rest to rest
};

/// Course of a gear along its master: a ratio, changes of it, and shifts of the phase.
///
///     GearCourse course{.master_end = 200000, .changes = {{0, 0.5, 100000}}};   // Googol 7-5
///     SyncCam slave = gear_course(course);          // 25000 u in the clutch, 0.5 u/m from there on
///
/// Let z be the share of the clutch's distance d that has been passed, and f the law (0 to 1). Then
///
///     (1)  ratio = r0 + (r1 - r0) f(z)
///     (2)  slave = d (r0 z + (r1 - r0) F(z)),   F(z) the integral of f
///
/// The slave covers d (r0 + r1) / 2 with every symmetric law, such as the line.
struct GearCourse {
  double master_start = 0;  ///< m
  double master_end = 0;    ///< m, > master_start: as far as the cam goes
  double slave_start = 0;   ///< u, at master_start
  double ratio = 0;         ///< u/m, before the first change; 0: the slave stands still
  std::vector<RatioChange> changes = {};  ///< each begins at the end of the one before, or later
  std::vector<PhaseShift> shifts =
      {};  ///< may lie anywhere, even over each other and over a clutch
};

/// The slave's cam, exactly; a cam that ends at rest holds outside, any other refuses. Segments:
/// "hold" (ratio 0), "gear" (a constant ratio, in step), "clutch", and "phase" for a shift.
///
/// Throws InputError "master_end", "change[i].at", "change[i].distance", "shift[i]...." (counted
/// from 1) for stretches that overlap, leave the course, or are out of range; and "...law" for a
/// law that has no shape of its own or needs velocities (R-U laws).
SyncCam gear_course(const GearCourse& course);

}  // namespace jounce
