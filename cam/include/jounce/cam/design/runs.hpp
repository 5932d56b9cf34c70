// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A run of the slave: one interval of the master over which it moves in one direction, or rests.
///
///     for (const CamRun& run : runs(cam))               // rise 0..120, dwell 120..200, fall ..360
///       if (run.kind == CamRun::Kind::dwell) use(run.to - run.from);
///     for (const MasterSpan& at : positions_for(cam, 25)) use(at.from); // 60 and 280
struct CamRun {
  enum class Kind { rise, dwell, fall };
  Kind kind = Kind::dwell;
  double from = 0;  ///< master position, from < to
  double to = 0;
  double slave_from = 0;  ///< slave position at `from`, and at `to`
  double slave_to = 0;
};

/// The runs of a cam, in the order of the master. They meet at the turning points (isolated, not
/// sampled: roots.hpp) and at the ends of the dwells. Travel below 1e-15 of a segment's magnitude
/// counts as standstill. A jump of the position also ends a run.
std::vector<CamRun> runs(const Cam& cam);

/// Master positions at which the slave is at one position: a single one (from == to), or a dwell.
struct MasterSpan {
  double from = 0;
  double to = 0;
};

/// Returns all of them within the cam's interval, ascending; for a cam that wraps, omits the end if
/// the start is included (a dwell across the wrap gives two spans). Throws InputError for a
/// position that is not finite.
std::vector<MasterSpan> positions_for(const Cam& cam, double slave);

}  // namespace jounce
