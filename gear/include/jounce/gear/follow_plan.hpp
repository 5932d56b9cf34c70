// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/gear/follow.hpp"

namespace jounce {

/// A position-sync point: master and slave arrive there together. If no ratio is given,
/// a ratio between the mean ratios before and after the point is used (0 if these differ in sign). At
/// the last point the slave comes to rest, or a periodic plan begins again.
struct FollowPoint {
  double master = 0;
  double slave = 0;
  std::optional<double> ratio = {};  ///< u/m
};

/// A velocity-sync zone: an interval in which the ratio is exact. The slave's position at `from` is
/// given, or follows from a sync point within the zone, or is the one that a linear ramp of the ratio
/// from the previous point reaches.
struct FollowZone {
  double from = 0;
  double to = 0;
  double ratio = 1;                  ///< u/m
  std::optional<double> slave = {};  ///< at `from`
  std::string name = {};
};

/// Between points and zones: a law of jounce/cam/laws/law.hpp that takes a ratio at both ends, without
/// acceleration there; or the quadratic pieces of a follow table.
enum class FollowForm { smooth, table };

/// Task of a follow table, in the user's terms; master and slave begin at (0, 0).
///
///     FollowPlan shear{.points = {{10000, 8000}}, .zones = {{0, 1000, 1}, {9000, 10000, 1}},
///                      .periodic = true};                    // manual, example 7-6, region 2
///     const CamSpec smooth = cam_spec(shear);
///     const FollowTable table = follow_table(shear);         // even, normal ..., even
///     const Report report = check(shear);
///
/// **As a table**, a zone is an even segment, so that its ratio is exact however the numbers were
/// rounded. Between two zones, one normal segment is enough if the mean ratio there is the mean
/// of both ratios; otherwise there are two, which meet at the point that makes the greater of their
/// slopes least (follow_plan.cpp (3)). If the slave would run backwards in between, it slows down,
/// stands still and speeds up instead, as gently as possible.
///
/// Throws InputError "point[1].master", "zone[2].from", ... if master positions do not ascend, a
/// zone overlaps another, a point within a zone contradicts it, the end's ratio differs from the
/// start's in a periodic plan, or a zone's position cannot be determined. Source: Googol iDEABOX
/// Pro manual 7.6.2 (sync points and zones; ratios are computed).
struct FollowPlan {
  std::vector<FollowPoint> points = {};
  std::vector<FollowZone> zones = {};
  bool periodic = false;
  std::optional<double> start_ratio = {};  ///< default: that of a zone at 0, or else 0
  FollowForm form = FollowForm::smooth;
  Law law = Law::quintic;  ///< law of the smooth form
  bool whole_master =
      false;  ///< table form: intermediate points lie on whole master units (pulses)
};

/// The smooth form.
CamSpec cam_spec(const FollowPlan& plan);

/// The table form: endless if periodic.
FollowTable follow_table(const FollowPlan& plan);

/// The cam of the form chosen, its zones by name.
SyncCam follow(const FollowPlan& plan);

/// "follow/backwards" for each gap in which the slave runs opposite to its ratios at both ends: the
/// place, the speed, and a sufficient travel. For a table also the findings of check(FollowSpec),
/// and "follow/whole_master" if a point could not be placed on a whole unit.
Report check(const FollowPlan& plan);

/// The master position after which a periodic plan repeats.
std::optional<double> master_period(const FollowPlan& plan);

}  // namespace jounce
