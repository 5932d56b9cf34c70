// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/gear/sync_cam.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/pt.hpp"

namespace jounce {

/// Nominal end of a follow table, as a check sum of increments typed by hand.
struct FollowEnd {
  double master = 0;
  double slave = 0;
};

/// A follow table: PT over master travel. The slave's ratio (its speed over its master's) is linear
/// within a segment, so its position is quadratic; the rules of the types are those of PtType.
struct FollowTable {
  /// Cumulative from the table's origin: x is the master's travel.
  std::vector<PtPoint> segments = {};
  std::int64_t loops = 1;  ///< passes; below 1: endless
  std::optional<FollowEnd> end = {};
};

/// Follow tables one after another, as a controller plays them by switching between its FIFOs.
///
///     const FollowTable shear{{{1000, 1000, PtType::continued}, {4000, 3400}, {6000, 4600},
///                              {9000, 7000}, {10000, 8000}}, 0};        // manual, example 7-6
///     const FollowSpec spec{{{{{5000, 2500}}}, shear}};                 // catch up, then endless
///     const SyncCam slave = follow(spec);
///     const Report report = check(spec);
///
/// **Vocabulary.** A *pass* is one run through a table. Its *origin* is the position of master and
/// slave when it begins: at the start, at the end of the pass before, at the switch of tables. So
/// the slave's position is continuous by construction, and every table is relative.
///
/// **The ratio from pass to pass.** A `continued` first segment begins with the end ratio of the
/// pass before, of another table or of the same one; a `normal` first one begins at 0 in every
/// pass, so its ratio steps if the pass before ended at another ratio. The very first continued
/// segment begins with `start_ratio`.
///
/// **Over the end.** An endless table repeats, and continues from its end (the cam advances; it
/// wraps if the slave comes back). If its first pass differs from the later ones, or other tables
/// precede it, the cam has all passes that differ and one more, and rejects queries beyond. A table
/// that ends at a ratio is a finding: a controller holds the slave there, which stops it at once;
/// an axis of Jounce brakes. Backwards the slave retraces its path as a function of its master's
/// position.
///
/// Throws InputError like pt(), with the table's number before the key if there are several; also
/// for no table, an endless table before another one, more than 1e6 segments in all passes. Source:
/// Googol iDEABOX Pro manual 7.6.
struct FollowSpec {
  std::vector<FollowTable> tables = {};
  double start_ratio = 0;  ///< start ratio of the slave to its master before: u/m
};

/// The cam from the first table's origin (0, 0); zones are intervals of constant ratio.
SyncCam follow(const FollowSpec& spec);

/// Start and end ratio of each segment of the cam that follow() makes.
std::vector<PtRate> follow_ratios(const FollowSpec& spec);

/// Errors that a controller plays without a message. Each rule reports its worst place, with the
/// number of places; steps count above 1e-9 of the greatest ratio:
///
///     follow/ratio_step   the ratio steps within a table: an even or stop segment, or at the start
///     follow/wrap_step    from the end of a pass to the start of the next
///     follow/switch_step  from one table to the next: its first segment is not continued
///     follow/open_end     the last table ends at a ratio: a controller stops the slave at once
///     follow/reversal     the slave runs against its own segment; travel that no neighbor has is
///                         named, for it may be a misprint. The first place of a chain is reported: what
///                         follows in it is its consequence
///     follow/wrap_ratio   in an endless table, the ratio differs from pass to pass: broken if it grows, a
///                         warning if it alternates
///     follow/end          the table does not end at its nominal end
///
/// `segment` is that of the cam. Throws like follow().
Report check(const FollowSpec& spec);

/// The master position after which the slave repeats its motion; nullopt if the motion ends, or
/// rejects queries beyond.
std::optional<double> master_period(const FollowSpec& spec);

}  // namespace jounce
