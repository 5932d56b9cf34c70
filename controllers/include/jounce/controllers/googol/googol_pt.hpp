// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/pvt/segment_fifos.hpp"

/// The PT mode of a Googol iDEABOX Pro, with the names of its manual. Units: pulse and ms.
///
///     PtFifos axis;
///     axis.prf_pt(PtMode::dynamic);
///     while (i < n && axis.pt_space(0) > 0) axis.pt_data(points[i++], 0);   // until both are full
///     axis.pt_start(0, now);
///     position = axis.at(t)[0];                // every cycle; and push more points
///
/// Manual: 7.4, I-113 to I-120, I-148, I-149. docs/decisions/0030-follow-tables.md defines the
/// behavior that the manual does not define.
namespace jounce::googol {

/// Reason for rejecting an instruction. The return code is 7 for bad_argument, and 1 for all
/// others.
enum class Refusal : std::uint8_t {
  none,
  bad_argument,  ///< a value out of its range
  wrong_mode,    ///< the axis is not in the mode of this instruction
  moving,        ///< the axis moves
  not_moving,    ///< the axis does not move
  in_use,        ///< the FIFO is being played, or belongs to a stream that is being played
  full,          ///< the FIFO has no space
  empty,         ///< the FIFO has no segment
  no_master,     ///< no master was set
};

/// Returns the return code of the instruction. 0: done, 1: a condition is not met, 7: bad argument.
int return_code(Refusal refusal);
/// Returns one sentence: the reason and the remedy.
const char* explain(Refusal refusal);

/// Use of the FIFOs: as two tables (PT_MODE_STATIC), or as one stream (PT_MODE_DYNAMIC).
enum class PtMode : std::uint8_t { fixed = 0, dynamic = 1 };

/// True if the number is a valid FIFO: 0 or 1.
constexpr bool is_fifo(int fifo) {
  return fifo == 0 || fifo == 1;
}

/// Adds a point with its type. The first point of an empty table or stream must have the type
/// `normal`; it begins at rest. Returns none, or the rule that the point breaks.
RowRule push(SegmentFifos& fifos, int fifo, const PtPoint& point);
/// Returns the refusal that an instruction returns for a row that breaks this rule.
Refusal refusal_of(RowRule rule);

/// Two FIFOs of PT segments on one axis. Functions return Refusal::none, or one of the refusals
/// that their comments list. `fifo` is 0 or 1.
class PtFifos {
 public:
  PtFifos();

  /// GT_PrfPt: selects PT mode and empties both FIFOs. Refusal: moving.
  Refusal prf_pt(PtMode mode);
  /// GT_SetPtMemory: selects the number of segments of each FIFO: 0: 32 (default), 1: 1024. Empties
  /// both FIFOs. Refusals: wrong_mode, moving, bad_argument.
  Refusal set_pt_memory(int memory);
  /// GT_SetPtLoop: number of passes; 0: endless. No effect in dynamic mode. Refusals: wrong_mode;
  /// bad_argument below 0.
  Refusal set_pt_loop(std::int64_t loops);
  /// GT_GetPtLoop: number of passes completed since the start.
  [[nodiscard]] std::int64_t pt_loop() const { return fifos_.passes(); }

  /// GT_PtSpace: number of segments that can be added; in dynamic mode, to both FIFOs together. 0
  /// in another mode.
  [[nodiscard]] std::size_t pt_space(int fifo) const;
  /// GT_PtData: adds a point. Refusals: wrong_mode, full; bad_argument: a number that is not
  /// finite, a time that does not ascend, the type `continued`, a FIFO other than 0 and 1.
  Refusal pt_data(const PtPoint& point, int fifo);
  /// GT_PtClear: empties a FIFO. Refusals: wrong_mode; in_use (static mode: this FIFO is being
  /// played; dynamic mode: the axis moves).
  Refusal pt_clear(int fifo);
  /// GT_PtStart: starts at `time`, ms, from `position`, pulse. Refusals: wrong_mode, moving, empty;
  /// bad_argument if `time` or `position` is not finite.
  Refusal pt_start(int fifo, double time, double position = 0);

  /// Returns the position, pulse, and its derivatives at `time`, ms. `time` must not decrease from
  /// call to call.
  Jet at(double time);
  /// State of the FIFOs. `cut_off` is the abnormal stop of manual 7.4: the segments ran out, or the
  /// table ended, at a nonzero velocity.
  [[nodiscard]] SegmentFifos::State state() const { return fifos_.state(); }

 private:
  void reset();

  SegmentFifos fifos_;
  bool pt_ = false;
  PtMode mode_ = PtMode::fixed;
  std::size_t each_ = 32;
};

}  // namespace jounce::googol
