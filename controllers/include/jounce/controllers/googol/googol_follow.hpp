// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/controllers/googol/googol_pt.hpp"
#include "jounce/gear/follow_run.hpp"

/// The follow mode of a Googol iDEABOX Pro, in its own words: pulse.
namespace jounce::googol {

/// Two FIFOs of follow tables on one axis, stepped by its cycle.
///
///     FollowFifos axis;
///     axis.prf_follow(0);
///     axis.set_follow_master(1);
///     axis.follow_data({20000, 10000}, 0);  ...
///     axis.follow_start(0, master_now, slave_now);
///     every cycle: slave = axis.step(before, now)[0];
///     axis.follow_data({20000, 10000, PtType::continued}, 1);  ...    // the other FIFO
///     axis.follow_switch(1);                  // after the pass that is running; then 0 is empty
///
/// Manual 7.6, I-22 to I-30, I-65 to I-68, I-110, I-136 to I-139; gaps in the manual are decided in
/// docs/decisions/0030-follow-tables.md.
class FollowFifos {
 public:
  /// Allocates: dynamic memory is at most `most` segments.
  explicit FollowFifos(std::size_t most = 4096);

  /// GT_PrfFollow: into follow mode, both FIFOs emptied. dir 0: both directions of the master; 1,
  /// -1: only that one: while the master moves backwards, and until it is back, the slave stands.
  /// moving
  Refusal prf_follow(int dir);
  /// GT_SetFollowMaster. wrong_mode, moving; bad_argument below 1
  Refusal set_follow_master(int master);
  /// GT_SetFollowLoop: below 1: endless. wrong_mode
  Refusal set_follow_loop(std::int64_t loops);
  /// GT_GetFollowLoop: passes completed since the start or the last switch.
  [[nodiscard]] std::int64_t follow_loop() const { return fifos_.passes(); }
  /// GT_SetFollowEvent. wrong_mode, moving; bad_argument
  Refusal set_follow_event(const FollowStart& start);
  /// GT_SetFollowMaxSegment: number for both FIFOs together, for memory 2. wrong_mode, moving;
  /// bad_argument below 1 or above the allocated number
  Refusal set_follow_max_segment(std::size_t segments);
  /// GT_SetFollowMemory: 0: 16 a FIFO (default), 1: 512, 2: the value of GT_SetFollowMaxSegment; empties
  /// both. wrong_mode, moving; bad_argument
  Refusal set_follow_memory(int memory);

  /// GT_FollowSpace. 0 in another mode
  [[nodiscard]] std::size_t follow_space(int fifo) const;
  /// GT_FollowData: x is the master's travel from the table's origin. wrong_mode, full; bad_argument;
  /// in_use: it will be emptied by the switch that is queued
  Refusal follow_data(const PtPoint& point, int fifo);
  /// GT_FollowClear. wrong_mode, in_use
  Refusal follow_clear(int fifo);
  /// GT_FollowStart: at once, or armed for the event. wrong_mode, moving, no_master, empty;
  /// bad_argument if a position is not finite
  Refusal follow_start(int fifo, double master, double slave);
  /// GT_FollowSwitch: queued until the pass ends. wrong_mode, not_moving (even while the axis waits
  /// for its event), in_use (already being played), empty
  Refusal follow_switch(int fifo);

  /// The slave's position, pulse, and its derivatives by the master, for the master's samples of
  /// two cycles. Before the event, after the end, and while the master moves against the only
  /// direction: the present position, with derivatives of 0. A master that is not finite is lost
  /// (state()).
  Jet step(const Sample& before, const Sample& now);
  [[nodiscard]] SegmentFifos::State state() const { return fifos_.state(); }
  /// Started, but the event has not come.
  [[nodiscard]] bool waiting() const { return run_.waiting; }

 private:
  enum Memory { small, large, dynamic };

  [[nodiscard]] bool busy() const { return run_.waiting || fifos_.moving(); }
  [[nodiscard]] Refusal when_at_rest() const;
  void reset();

  SegmentFifos fifos_;
  std::size_t most_;
  std::size_t max_segments_ = 0;
  Memory memory_ = small;
  bool follow_ = false;
  int master_ = 0;
  FollowRun run_;
};

}  // namespace jounce::googol
