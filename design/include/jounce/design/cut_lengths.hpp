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

/// A spec of cuts over its cut length, with all other values fixed: the fastest line for each; and
/// the characteristic lengths, master unit.
///
/// The cam of a knife does not depend on the speed. The run-up and return of a shear follow from
/// the line speed: its cam is made again for each.
struct CutLengths {
  /// If no such cut is possible, the limit is "length" or "reversal", and the speed 0.
  std::function<CutSpeed(double length, const CutLimits&)> fastest;
  /// The shortest cut at that speed, if there is one; for a knife, among cuts up to the synchronous
  /// length.
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

/// Throws InputError, placed in the document, for a kind without a cut length, and for a shear
/// whose sync follows from the stroke: at its fastest line speed it would be 0.
CutLengths cut_lengths(const Spec& spec);

}  // namespace jounce
