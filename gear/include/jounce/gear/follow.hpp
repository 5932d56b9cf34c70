// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/gear/sync_cam.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/pt.hpp"

namespace jounce {

/// Nominal end of a follow table: a checksum for increments that were typed by hand. u is the
/// slave's unit, m the master's.
struct FollowEnd {
  double master = 0;  ///< m
  double slave = 0;   ///< u
};

/// A follow table: a PT table over the master's travel. Within a segment, the slave's ratio (its
/// speed divided by the master's) is linear, so its position is quadratic. PtType lists the types
/// of segments.
struct FollowTable {
  /// Ends of the segments, cumulative from the table's origin. PtPoint::x is the master's travel
  /// (m), PtPoint::position the slave's (u).
  std::vector<PtPoint> segments = {};
  std::int64_t loops = 1;             ///< number of passes; below 1: endless
  std::optional<FollowEnd> end = {};  ///< nominal end, checked by check()
};

/// Follow tables that are played one after another, as a controller does by switching between its
/// FIFOs.
///
///     const FollowTable shear{{{1000, 1000, PtType::continued}, {4000, 3400}, {6000, 4600},
///                              {9000, 7000}, {10000, 8000}}, 0};        // Googol example 7-6
///     const FollowSpec spec{{{{{5000, 2500}}}, shear}};                // synchronize, then repeat
///     const SyncCam slave = follow(spec);
///     const Report report = check(spec);
///
/// **Vocabulary.** A *pass* is one run through a table. The *origin* of a pass is the position of
/// master and slave at its beginning: at the start, at the end of the previous pass, or at the
/// switch to another table. So the slave's position is always continuous, and the positions of
/// every table are relative.
///
/// **The ratio at the beginning of a pass.** If the first segment is `continued`, it begins with
/// the end ratio of the previous pass, of the same or of another table. The first pass of the first
/// table begins with `start_ratio`. If the first segment is `normal`, the ratio begins at 0, so it
/// steps if the previous pass ended at another ratio.
///
/// **Beyond the end.** An endless table repeats and continues from its end: the cam advances, or
/// wraps if the slave returns to its start. There are two exceptions: other tables precede the
/// endless table, or its second pass differs from its first. The cam then contains all passes of
/// the other tables, and one pass of the endless table (two if they differ). It refuses positions
/// beyond its end. A cam without an endless table holds outside if start_ratio is 0; otherwise it
/// refuses. If the last table ends at a nonzero ratio, check() reports this: a controller stops the
/// slave at once, while an axis of Jounce brakes. If the master moves backwards, the slave moves
/// back along the same curve.
///
/// Throws InputError like pt(); if the spec has several tables, the key begins with the table's
/// number. Also throws if the spec has no table, if an endless table is not the last one, or if all
/// passes together have more than 1e6 segments. Source: Googol iDEABOX Pro manual 7.6.
struct FollowSpec {
  std::vector<FollowTable> tables = {};  ///< in the order in which they are played
  double start_ratio = 0;                ///< u/m, ratio of the slave before the first table
};

/// Returns the cam, which begins at the origin of the first table, (0, 0). Its zones are the
/// intervals of constant ratio.
SyncCam follow(const FollowSpec& spec);

/// Returns the ratio at the start and at the end of each segment of the cam of follow().
std::vector<PtRate> follow_ratios(const FollowSpec& spec);

/// Reports features that a controller would play without a message. Each rule reports its worst
/// place (a reversal: the first place) and the number of places. All findings are broken, except
/// the warnings named below. A step of the ratio counts above 1e-9 of the greatest ratio.
/// Finding::segment is a segment of the cam. Throws like follow().
/// - follow/ratio_step: the ratio steps within a table, at an even or a stop segment, or at the
///   start. At the start of an endless table without other passes: a warning.
/// - follow/wrap_step: the ratio steps from the end of a pass to the start of the next.
/// - follow/switch_step: the ratio steps from one table to the next, whose first segment is not
///   continued.
/// - follow/open_end: the last table ends at a nonzero ratio; a controller then stops the slave at
///   once.
/// - follow/reversal: the slave moves against the direction of its segment. If the travel of a
///   segment differs from the travel of its neighbors, the finding names it, because it may be a
///   misprint. Of a chain of reversals, only the first is reported: it causes the others.
/// - follow/wrap_ratio: the ratio of an endless table differs from pass to pass. Broken if the
///   difference grows, a warning if it alternates.
/// - follow/end: the table does not end at its nominal end.
Report check(const FollowSpec& spec);

/// Returns the travel of the master after which the motion of the slave repeats. Returns nullopt if
/// the motion ends, or if the cam refuses positions beyond its end.
std::optional<double> master_period(const FollowSpec& spec);

}  // namespace jounce
