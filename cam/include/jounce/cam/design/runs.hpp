// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A run: a maximal interval of the master on which the slave moves in one direction, or rests. u
/// is the slave's unit, m the master's.
///
///     for (const CamRun& run : runs(cam))               // rise 0..120, dwell 120..200, fall ..360
///       if (run.kind == CamRun::Kind::dwell) use(run.to - run.from);
///     for (const MasterSpan& at : positions_for(cam, 25)) use(at.from); // 60 and 280
struct CamRun {
  enum class Kind { rise, dwell, fall };
  Kind kind = Kind::dwell;
  double from = 0;        ///< m, master position at the start; below `to`
  double to = 0;          ///< m, master position at the end
  double slave_from = 0;  ///< u, slave position at `from`
  double slave_to = 0;    ///< u, slave position at `to`
};

/// Returns the runs of a cam, in the order of the master. Successive runs meet at a reversal
/// (an exact root of the derivative, not found by sampling; see roots.hpp), at an end of a dwell,
/// or at a jump of the position. Travel of at most 1e-15 of magnitude(segment) counts as rest.
std::vector<CamRun> runs(const Cam& cam);

/// Master positions at which the slave has a given position: a single position (from == to), or the
/// interval of a dwell.
struct MasterSpan {
  double from = 0;  ///< m
  double to = 0;    ///< m
};

/// Returns all master positions within the cam's interval at which the slave is at `slave`,
/// ascending. For a cam that wraps, the end is omitted if the start is in the result; a dwell
/// across the end gives two spans. Throws InputError if `slave` is not finite.
std::vector<MasterSpan> positions_for(const Cam& cam, double slave);

}  // namespace jounce
