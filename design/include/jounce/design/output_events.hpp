// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"

namespace jounce {

/// A change of one output along the motion of a spec.
struct OutputEvent {
  double time = 0;
  std::string output;  ///< "compare", "output 16", "track 1", "line 12", "M3"
  bool on = false;
  double position =
      0;  ///< position at that time of the axis that the output stands on, or length of the path
};

/// The outputs of a spec along its motion.
struct OutputEvents {
  std::vector<OutputEvent> all;  ///< by time for each kind of output
  std::string time, position;    ///< their units
  Report report;                 ///< broken if a point does not fire, or the device is too slow
  Labels labels;                 ///< labels of the report
};

/// The edges of [compare], or of a cam's [[switch]] while its [master] runs: exact times. Of a path without
/// [compare]: where its lines begin, and the words of a G-code program that move nothing. `axes` are the inputs of
/// one spec (inputs_of). Throws InputError for a table, and for a spec with neither.
OutputEvents output_events(const std::vector<Input>& axes);

/// A line for each edge, and the same as JSON.
std::string to_csv(const OutputEvents& events);
std::string to_json(const OutputEvents& events);

}  // namespace jounce
