// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/axis/axis_compare.hpp"

namespace jounce {

/// A part of the configuration of an axis's outputs, as an event of a record. A part is one cam
/// switch, the options of one track, or some points of the position compare.
///
///     for (const RecordedOutput& part : parts_of(0, switches, compare))
///       apply(part, others, other_compare);          // in this order: restores both
struct RecordedOutput {
  static constexpr std::size_t most_points = 64;  ///< greatest number of points in one part
  /// Greatest number of points of a compare in a record.
  static constexpr std::size_t longest = 100'000;
  /// Kind of a part.
  enum class Part : std::uint8_t { cam_switch, track, compare };

  std::size_t axis = 0;                  ///< index of the axis
  Part part = Part::cam_switch;          ///< kind of this part
  SwitchesOf of = SwitchesOf::position;  ///< the position at which the outputs switch
  /// Period of the cam switches in the unit of their position; nullopt: none.
  std::optional<double> period = {};
  CamSwitch cam_switch = {};                  ///< the cam switch
  SwitchTrack track = {};                     ///< the options of a track
  CompareMode mode = CompareMode::fifo_time;  ///< mode of the position compare
  double pulse = 0;                           ///< length of the output pulse, s
  std::int64_t points = 0;                    ///< number of points of the whole list
  std::vector<ComparePoint> some = {};        ///< points of this part
};

/// True if a record can contain the whole position compare, that is, if it has at most `longest`
/// points.
bool recordable(const AxisCompare& compare);

/// Returns the configuration of the outputs of an axis as parts, in the order for apply().
std::vector<RecordedOutput> parts_of(std::size_t axis, const AxisSwitches& switches,
                                     const AxisCompare& compare);

/// Adds a part to the configuration. Returns false while points of the position compare are
/// missing.
bool apply(const RecordedOutput& part, AxisSwitches& switches, AxisCompare& compare);

}  // namespace jounce
