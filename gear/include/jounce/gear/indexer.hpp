// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"

namespace jounce {

/// An indexer: a turntable or a feed that repeatedly moves by the same distance, with a stop after
/// each motion. u is the slave's unit, m the master's.
///
///     Indexer table{.distance = 45, .cycle = 2000, .motion = 400};    // deg, over ms of a master
///     SyncCam cam = indexer(table);                                   // 45 deg per cycle, endless
///     Indexer ring{.distance = 45, .cycle = 360, .motion = 120, .count = 8};  // 8 motions
///
/// **Vocabulary.** A cycle consists of `count` equal parts. In each part, the slave stands still
/// over the master distance `before`, moves by `distance` over the master distance `motion`, and
/// stands still for the rest of the part. The cam advances (Extrapolation::advance): each cycle
/// moves the slave by exactly count * distance. The zones are the intervals without motion; their
/// name is "dwell".
///
/// For a jaw that moves along with the film and returns, see FlyingShear; for a rotating jaw, see
/// the rotary knife.
///
/// **Throws** InputError for a number that is not finite, or is outside the range that its comment
/// gives; for a motion that does not fit into its part of the cycle; and for a law that does not go
/// from rest to rest.
struct Indexer {
  double distance = 0;  ///< u, not 0; the sign is the direction
  double cycle = 0;     ///< m, > 0: length of a cycle of the master
  double motion = 0;    ///< m, > 0: length of one motion
  double before = 0;    ///< m, >= 0: length of the dwell before each motion
  int count = 1;        ///< >= 1: number of motions in a cycle
  Law law = Law::poly345;
  LawForm form = {};
};

/// Returns the cam of one cycle.
SyncCam indexer(const Indexer& spec);

}  // namespace jounce
