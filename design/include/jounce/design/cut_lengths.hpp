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

/// A spec of cuts over its cut length, with all other values fixed: the fastest line for
/// each; and the lengths that mean something, master unit.
///
/// A knife's cam has no speed of its own. A shear's run-up and return follow from the line's speed:
/// it is made anew for every one.
struct CutLengths {
  /// The limit is "length" or "reversal", and the speed 0, where no such cut can be made.
  std::function<CutSpeed(double length, const CutLimits&)> fastest;
  /// The shortest cut at that speed, where there is one: of a knife, of those up to the synchronous.
  std::function<std::optional<double>(double speed, const CutLimits&)> shortest;
  struct Mark {
    double length = 0;
    std::string name = {};  ///< "synchronous", "longest without a stop"
  };
  std::vector<Mark> marks = {};
  double turns_back =
      std::numeric_limits<double>::infinity();  ///< longer cuts need a dwell, which is not set
  double from = 0;                              ///< a range that shows all of them
  double to = 0;
};

/// Throws InputError, placed in the document, for a kind that has no cut length, and for a shear
/// whose sync is left to the stroke: at its fastest line nothing would be left of it.
CutLengths cut_lengths(const Spec& spec);

}  // namespace jounce
