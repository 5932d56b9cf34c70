// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/controllers/googol/googol_pt.hpp"
#include "jounce/gear/follow_run.hpp"

/// The follow mode of a Googol iDEABOX Pro, with the names of its manual. Positions are in pulses.
namespace jounce::googol {

/// Two FIFOs of follow tables on one axis. Call step() in each cycle of the axis.
///
///     FollowFifos axis;
///     axis.prf_follow(0);
///     axis.set_follow_master(1);
///     axis.follow_data({20000, 10000}, 0);  ...
///     axis.follow_start(0, master_now, slave_now);
///     slave = axis.step(before, now)[0];      // every cycle
///     axis.follow_data({20000, 10000, PtType::continued}, 1);  ...    // the other FIFO
///     axis.follow_switch(1);                  // after the pass that is running; then 0 is empty
///
/// Functions return Refusal::none, or one of the refusals that their comments list. `fifo` is 0
/// or 1. Manual: 7.6, I-22 to I-30, I-65 to I-68, I-110, I-136 to I-139.
/// docs/decisions/0030-follow-tables.md defines the behavior that the manual does not define.
class FollowFifos {
 public:
  /// Allocates memory for `most` segments, the greatest value of set_follow_max_segment().
  explicit FollowFifos(std::size_t most = 4096);

  /// GT_PrfFollow: selects follow mode and empties both FIFOs. With `dir` 0, the slave follows both
  /// directions of the master; with 1 or -1, only this direction: while the master moves in the
  /// other direction, the slave rests until the master is back. Refusals: moving, bad_argument.
  Refusal prf_follow(int dir);
  /// GT_SetFollowMaster: number of the master. Refusals: wrong_mode, moving; bad_argument below 1.
  Refusal set_follow_master(int master);
  /// GT_SetFollowLoop: number of passes; below 1: endless. Refusal: wrong_mode.
  Refusal set_follow_loop(std::int64_t loops);
  /// GT_GetFollowLoop: number of passes completed since the start or the last switch.
  [[nodiscard]] std::int64_t follow_loop() const { return fifos_.passes(); }
  /// GT_SetFollowEvent: start condition. Refusals: wrong_mode, moving, bad_argument.
  Refusal set_follow_event(const FollowStart& start);
  /// GT_SetFollowMaxSegment: number of segments of both FIFOs together, for memory 2. Refusals:
  /// wrong_mode, moving; bad_argument below 1 or above the allocated number.
  Refusal set_follow_max_segment(std::size_t segments);
  /// GT_SetFollowMemory: selects the number of segments of each FIFO: 0: 16 (default), 1: 512, 2:
  /// as set by set_follow_max_segment(). Empties both FIFOs. Refusals: wrong_mode, moving,
  /// bad_argument.
  Refusal set_follow_memory(int memory);

  /// GT_FollowSpace: number of segments that can be added. 0 in another mode.
  [[nodiscard]] std::size_t follow_space(int fifo) const;
  /// GT_FollowData: adds a segment. `x` of the point is the master travel from the origin of the
  /// table. Refusals: wrong_mode, full, bad_argument; in_use if a queued switch will empty this
  /// FIFO.
  Refusal follow_data(const PtPoint& point, int fifo);
  /// GT_FollowClear: empties a FIFO. Refusals: wrong_mode, in_use.
  Refusal follow_clear(int fifo);
  /// GT_FollowStart: starts at once, or waits for the event. `master` and `slave` are the present
  /// positions. Refusals: wrong_mode, moving, no_master, empty; bad_argument if a position is not
  /// finite.
  Refusal follow_start(int fifo, double master, double slave);
  /// GT_FollowSwitch: switches to this FIFO at the end of the pass. Refusals: wrong_mode;
  /// not_moving (even while the axis waits for its event); in_use (this FIFO is being played);
  /// empty.
  Refusal follow_switch(int fifo);

  /// Computes one cycle. Call once in each cycle. `before` and `now` are the master in the previous
  /// and in the present cycle. Returns the position of the slave, pulse, and its derivatives with
  /// respect to the master position. Before the event, after the end, and while the master moves
  /// against the selected direction, the position stays and the derivatives are 0. If the master is
  /// not finite, state() becomes `lost`.
  Jet step(const Sample& before, const Sample& now);
  /// State of the FIFOs.
  [[nodiscard]] SegmentFifos::State state() const { return fifos_.state(); }
  /// True if the motion was started and waits for its event.
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
