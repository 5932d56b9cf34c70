// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"

namespace jounce {

/// An indexer: a turntable or a feed that moves by the same distance again and again, and stands
/// still in between.
///
///     Indexer table{.distance = 45, .cycle = 2000, .motion = 400};    // deg, over ms of a master
///     SyncCam cam = indexer(table);                                   // 45 deg per cycle, endless
///     Indexer ring{.distance = 45, .cycle = 360, .motion = 120, .count = 8};   // eight in a cycle
///
/// **Vocabulary.** Each of the `count` equal parts of the cycle is: stand for `before`, move by
/// `distance` over `motion`, stand for what is left. The cam advances (Extrapolation::advance): every cycle
/// goes on by count * distance, exactly. The intervals in which it stands are its zones, "dwell".
///
/// A jaw that goes along with the film and comes back is a FlyingShear; a rotating one is the rotary
/// knife's geometry.
///
/// **Throws** InputError for numbers that are not finite or positive, a motion that does not fit
/// into its part of the cycle, and a law that does not go from rest to rest.
struct Indexer {
  double distance = 0;  ///< u, not 0; its sign is the direction
  double cycle = 0;     ///< m > 0
  double motion = 0;    ///< m > 0, of each index
  double before = 0;    ///< m >= 0, of dwell before each index
  int count = 1;        ///< >= 1: indexes a cycle
  Law law = Law::poly345;
  LawForm form = {};
};

SyncCam indexer(const Indexer& spec);

}  // namespace jounce
