// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/pvt/segment_fifos.hpp"

/// The PT mode of a Googol iDEABOX Pro, in its own words: pulse and ms.
///
///     PtFifos axis;
///     axis.prf_pt(PtMode::dynamic);
///     while (i < n && axis.pt_space(0) > 0) axis.pt_data(points[i++], 0);   // until both are full
///     axis.pt_start(0, now);
///     every cycle: position = axis.at(t)[0];  and push more points
///
/// Manual 7.4, I-113 to I-120, I-148, I-149; gaps in the manual are decided in
/// docs/decisions/0030-follow-tables.md.
namespace jounce::googol {

/// Why an instruction was refused: the reasons that the manual documents for return code 1.
enum class Refusal : std::uint8_t {
  none,
  bad_argument,  ///< code 7
  wrong_mode,
  moving,
  not_moving,
  in_use,  ///< the FIFO or its stream is being played
  full,
  empty,
  no_master,
};

/// 0 done, 1 conditions not met, 7 bad argument.
int return_code(Refusal refusal);
/// One sentence for people: the reason, and the remedy.
const char* explain(Refusal refusal);

enum class PtMode : std::uint8_t { fixed = 0, dynamic = 1 };  ///< PT_MODE_STATIC, PT_MODE_DYNAMIC

/// True for the number of a FIFO: 0 or 1.
constexpr bool is_fifo(int fifo) {
  return fifo == 0 || fifo == 1;
}

/// Pushes a point by its type: in an empty table or stream the first one is NORMAL and begins at
/// rest. The second: why the point was rejected, in the manual's words.
RowRule push(SegmentFifos& fifos, int fifo, const PtPoint& point);
Refusal refusal_of(RowRule rule);

class PtFifos {
 public:
  PtFifos();

  /// GT_PrfPt: into PT mode; both FIFOs are emptied. moving
  Refusal prf_pt(PtMode mode);
  /// GT_SetPtMemory: 0: 32 segments a FIFO (default), 1: 1024; empties both. wrong_mode, moving
  Refusal set_pt_memory(int memory);
  /// GT_SetPtLoop: 0: endless. No effect in dynamic mode. wrong_mode; bad_argument below 0
  Refusal set_pt_loop(std::int64_t loops);
  /// GT_GetPtLoop: passes done since the start.
  [[nodiscard]] std::int64_t pt_loop() const { return fifos_.passes(); }

  /// GT_PtSpace: segments that can be pushed; of both FIFOs in dynamic mode. 0 in another mode
  [[nodiscard]] std::size_t pt_space(int fifo) const;
  /// GT_PtData. wrong_mode, full; bad_argument: numbers not finite, time that does not ascend,
  /// `continued`, a FIFO other than 0 and 1
  Refusal pt_data(const PtPoint& point, int fifo);
  /// GT_PtClear. wrong_mode, in_use (static: the FIFO that is played; dynamic: while moving)
  Refusal pt_clear(int fifo);
  /// GT_PtStart at `time`, ms, from `position`. wrong_mode, moving, empty; bad_argument if either
  /// is not finite
  Refusal pt_start(int fifo, double time, double position = 0);

  /// Position, pulse, and its derivatives at `time`, ms, which must not decrease from call to call.
  Jet at(double time);
  /// cut_off: both ran empty at a velocity, or the table ended at one: the abnormal stop of 7.4.
  [[nodiscard]] SegmentFifos::State state() const { return fifos_.state(); }

 private:
  void reset();

  SegmentFifos fifos_;
  bool pt_ = false;
  PtMode mode_ = PtMode::fixed;
  std::size_t each_ = 32;
};

}  // namespace jounce::googol
