// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/gear/follow.hpp"

namespace jounce {

/// A sync point: master and slave reach the two given positions together. If no ratio is given, the
/// ratio at the point is between the mean ratios before and after the point (0 if these differ in
/// sign). At the last point, the slave comes to rest, or a periodic plan begins again. u is the
/// slave's unit, m the master's.
struct FollowPoint {
  double master = 0;                 ///< m
  double slave = 0;                  ///< u
  std::optional<double> ratio = {};  ///< u/m, at the point
};

/// A sync zone: an interval of the master in which the ratio is constant. If the slave's position
/// at `from` is not given, a sync point inside the zone determines it; otherwise, the position
/// follows from a linear ramp of the ratio from the previous point.
struct FollowZone {
  double from = 0;                   ///< m
  double to = 0;                     ///< m
  double ratio = 1;                  ///< u/m
  std::optional<double> slave = {};  ///< u, at `from`
  std::string name = {};             ///< name of the zone in reports
};

/// Form of the motion between points and zones. `smooth`: by a law of jounce/cam/laws/law.hpp that
/// accepts a ratio at both ends, with acceleration 0 at the ends. `table`: by the quadratic pieces
/// of a follow table.
enum class FollowForm { smooth, table };

/// A task for a follow table, described by sync points and zones. Master and slave begin at (0, 0).
///
///     FollowPlan shear{.points = {{10000, 8000}}, .zones = {{0, 1000, 1}, {9000, 10000, 1}},
///                      .periodic = true};                    // Googol example 7-6, region 2
///     const CamSpec smooth = cam_spec(shear);
///     const FollowTable table = follow_table(shear);         // even, normal, ..., even segments
///     const Report report = check(shear);
///
/// **As a table**, a zone is an even segment, so its ratio is exact in spite of rounded numbers.
/// Between two zones, one normal segment is enough if the mean ratio between them is the mean of
/// their ratios. Otherwise two segments are necessary. They meet at the point that minimizes the
/// greater of their slopes (equation (3) in follow_plan.cpp). If the slave would move backwards
/// between the zones, it instead slows down, stands still and speeds up, as gently as possible.
///
/// Throws InputError "point[1].master", "zone[2].from", ... if master positions do not ascend,
/// zones overlap, a point inside a zone contradicts the zone, the ratio at the end of a periodic
/// plan differs from the ratio at its start, or the position of a zone cannot be determined.
/// Source: Googol iDEABOX Pro manual 7.6.2 (sync points and zones; ratios are computed).
struct FollowPlan {
  std::vector<FollowPoint> points = {};
  std::vector<FollowZone> zones = {};
  bool periodic = false;                   ///< true: the plan repeats after its last point or zone
  std::optional<double> start_ratio = {};  ///< u/m; default: the ratio of a zone at 0, otherwise 0
  FollowForm form = FollowForm::smooth;    ///< form of follow() and check()
  Law law = Law::quintic;  ///< law of the smooth form; must accept a ratio at both ends
  /// For the table form: intermediate points are on whole master units (pulses).
  bool whole_master = false;
};

/// Returns the plan in the smooth form.
CamSpec cam_spec(const FollowPlan& plan);

/// Returns the plan in the table form; endless if periodic.
FollowTable follow_table(const FollowPlan& plan);

/// Returns the cam in the form plan.form; its zones have the names of the plan's zones.
SyncCam follow(const FollowPlan& plan);

/// Returns the finding "follow/backwards" for each gap in which the slave moves opposite to the
/// ratios at both ends of the gap, with the place, the speed, and a travel that would suffice. In
/// the table form, also returns the findings of check(FollowSpec), and "follow/whole_master" if a
/// point could not be placed on a whole unit.
Report check(const FollowPlan& plan);

/// Returns the travel of the master after which a periodic plan repeats; nullopt if it is not
/// periodic.
std::optional<double> master_period(const FollowPlan& plan);

}  // namespace jounce
