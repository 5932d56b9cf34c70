// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "jounce/gear/cut_length_map.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// A spec of a rotary knife or a flying shear, as a function of its cut length; all other values of
/// the spec are fixed. Lengths are in the master unit.
///
/// The cam of a rotary knife does not depend on the line speed. The cam of a shear does, because
/// its run-up and its return depend on the speed; so the cam is made again for each speed.
struct CutLengths {
  /// Returns the greatest line speed for a length, and the limit that determines it. If the cut is
  /// impossible, the speed is 0, and the limit is "length", "reversal" or, for a shear, the limit
  /// that no speed satisfies.
  std::function<CutSpeed(double length, const CutLimits&)> fastest = {};
  /// Returns the shortest cut that is possible at a speed; nullopt if no cut is possible. For a
  /// knife, only cuts up to the synchronous length are considered.
  std::function<std::optional<double>(double speed, const CutLimits&)> shortest = {};
  /// A length with a special meaning.
  struct Mark {
    double length = 0;      ///< master unit
    std::string name = {};  ///< "synchronous", "longest without a stop"
  };
  std::vector<Mark> marks = {};  ///< all lengths with a special meaning, ascending
  /// Cuts above this length need a dwell that the spec does not permit.
  double turns_back = std::numeric_limits<double>::infinity();
  double from = 0;  ///< start of a range that contains all `marks`
  double to = 0;    ///< end of this range
};

/// Returns the functions for a spec. Throws InputError, with the place in the document, for a kind
/// of spec without a cut length, and for a shear without sync_time and sync_length. The stroke of
/// such a shear determines its sync (the time in step), so the sync would be 0 at the greatest line
/// speed.
CutLengths cut_lengths(const Spec& spec);

}  // namespace jounce
