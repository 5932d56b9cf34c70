// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/axis/outputs.hpp"

namespace jounce {

/// A part of the configuration of an axis's outputs, in a record: one cam switch, the options of
/// one track, or some points of its position compare.
///
///     for (const RecordedOutput& part : parts_of(0, switches, compare)) write(part);
///     apply(part, switches, compare);                // once each, in this order: restores both
struct RecordedOutput {
  static constexpr std::size_t most_points = 64;   ///< in one part
  static constexpr std::size_t longest = 100'000;  ///< longest list of points in a record
  enum class Part : std::uint8_t { cam_switch, track, compare };

  std::size_t axis = 0;
  Part part = Part::cam_switch;
  SwitchesOf of = SwitchesOf::position;
  std::optional<double> period = {};  ///< period of the switches
  CamSwitch cam_switch = {};
  SwitchTrack track = {};
  CompareMode mode = CompareMode::fifo_time;
  double pulse = 0;         ///< s
  std::int64_t points = 0;  ///< points of the whole list
  std::vector<ComparePoint> some = {};
};

/// True if the record has all of it: a compare of more than `longest` points is not recorded.
bool recordable(const AxisCompare& compare);

std::vector<RecordedOutput> parts_of(std::size_t axis, const AxisSwitches& switches,
                                     const AxisCompare& compare);

/// Adds a part. Returns false while points of the compare are missing.
bool apply(const RecordedOutput& part, AxisSwitches& switches, AxisCompare& compare);

}  // namespace jounce
