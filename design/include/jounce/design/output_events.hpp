// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"

namespace jounce {

/// A change of one output during the motion of a spec.
struct OutputEvent {
  double time = 0;          ///< time of the change
  std::string output = {};  ///< "compare", "output 16", "track 1", "line 12", "M3"
  bool on = false;          ///< true: the output goes on
  /// Position at this time: of the axis to which the output belongs; for a compare in a plane, of
  /// its first axis; for [[switch]] with `of` = "master", of the master; for a path, the length
  /// along it.
  double position = 0;
};

/// The changes of all outputs of a spec during its motion.
struct OutputEvents {
  std::vector<OutputEvent> all = {};     ///< in order of time
  std::string time = {}, position = {};  ///< units of time and position
  /// For [compare]: a broken finding for each point that does not fire, and a broken finding if the
  /// compare hardware is too slow.
  Report report = {};
  Labels labels = {};  ///< names and units for the report
};

/// Returns the edges of the outputs of a spec, at exact times. With [compare], these are the edges
/// of the compare output; for a cam, the edges of [[switch]] while its [master] moves; for a path
/// without [compare], the starts of its lines, and the G-code words that move no axis. `axes` are
/// all inputs of one spec (inputs_of()). Throws InputError for a table, and for a spec without
/// outputs.
OutputEvents output_events(const std::vector<Input>& axes);

/// Return the edges as CSV (one line for each), and as JSON.
std::string to_csv(const OutputEvents& events);
std::string to_json(const OutputEvents& events);

}  // namespace jounce
