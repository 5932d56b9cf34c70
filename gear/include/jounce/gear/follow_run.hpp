// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/gear/follow_start.hpp"
#include "jounce/pvt/segment_fifos.hpp"

namespace jounce {

/// Player of follow tables with a live master: its start, direction and progress. A value; the rows
/// are in SegmentFifos, over the master's travel since following began.
///
///     FollowRun run{.event = {FollowEvent::pass, 50000}};
///     if (fifos.take(0)) begin(run, fifos, master_now, slave_now);
///     every cycle: slave = step(run, fifos, before, now)[0];     // samples of the master
///
/// Source: Googol iDEABOX Pro manual 7.6 (GT_SetFollowEvent, GT_PrfFollow).
struct FollowRun {
  FollowStart event = {};
  /// 0: both directions of the master; 1, -1: only that one. While the master runs against it, and
  /// until it is back, the slave stands still.
  int dir = 0;

  bool waiting = false;  ///< for its event
  double slave = 0;      ///< u, its position while it waits
  double origin = 0;     ///< m, the master's position when following began
  double furthest = 0;   ///< m, travel reached in the one direction
};

/// Begins at once, or arms the run for its event. The FIFO was taken before.
void begin(FollowRun& run, SegmentFifos& fifos, double master, double slave);

/// The slave's position and its derivatives by the master, for the master's samples of two cycles.
/// Before the event, after the end, and while the master runs against the only direction: its
/// standing position, with derivatives of 0. A master that is not finite is lost
/// (SegmentFifos::State). Does not allocate.
Jet step(FollowRun& run, SegmentFifos& fifos, const Sample& before, const Sample& now);

}  // namespace jounce
