// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/gear/follow_start.hpp"
#include "jounce/pvt/segment_fifos.hpp"

namespace jounce {

/// State of a slave that plays follow tables over a live master: start event, direction and
/// progress. It can be copied freely. The rows are in SegmentFifos; their x is the master's travel
/// since following began. u is the slave's unit, m the master's.
///
///     FollowRun run{.event = {FollowEvent::pass, 50000}};
///     if (fifos.take(0)) begin(run, fifos, master_now, slave_now);
///     // in each cycle, with the samples of the master in the previous and in this cycle:
///     slave = step(run, fifos, before, now)[0];
///
/// Source: Googol iDEABOX Pro manual 7.6 (GT_SetFollowEvent, GT_PrfFollow).
struct FollowRun {
  FollowStart event = {};  ///< start event
  /// Direction of the master that the slave follows: 1, -1, or 0 for both. With 1 or -1, the slave
  /// stands still while the master moves in the other direction, and until the master is back at
  /// the position at which it turned.
  int dir = 0;

  bool waiting = false;  ///< true while the slave waits for the event
  double slave = 0;      ///< u, position of the slave while it waits
  double origin = 0;     ///< m, position of the master when following began
  double furthest = 0;   ///< m, greatest travel in the direction `dir`
};

/// Begins to follow at once, or waits for the start event `run.event`. Requires a successful
/// fifos.take(). `master` (m) and `slave` (u) are the present positions.
void begin(FollowRun& run, SegmentFifos& fifos, double master, double slave);

/// Returns the slave's position and its derivatives with respect to the master, for the samples of
/// the master in two successive cycles. The slave stands still, with derivatives of 0, before the
/// event, after the end, and while the master moves against `dir`. If the master is not finite
/// while the slave follows, the state of the FIFOs becomes SegmentFifos::State::lost. Does not
/// allocate.
Jet step(FollowRun& run, SegmentFifos& fifos, const Sample& before, const Sample& now);

/// Returns what the first step() after begin() would return, without a change. Returns nullopt
/// while the slave waits for the event, and if the master has passed the end of the first table.
std::optional<Jet> first_step(FollowRun run, const SegmentFifos& fifos, const Sample& now);

}  // namespace jounce
