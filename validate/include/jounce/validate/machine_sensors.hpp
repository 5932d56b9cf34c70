// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

namespace jounce {

/// A switch of a simulated machine: on from `position` (inclusive) for `width`.
struct MachineSwitch {
  double position = 0;                                     ///< u, of the machine
  double width = std::numeric_limits<double>::infinity();  ///< u, > 0; infinite: to the end
  bool inverted = false;                                   ///< off there, and on everywhere else
  double bounce = 0;  ///< s, time for which its contact bounces after each edge
};

/// The index of a simulated encoder: one pulse at `offset` and every `period` from there.
struct MachineIndex {
  double period = 0;  ///< u, > 0
  double offset = 0;  ///< u, of the machine
};

/// The sensors of a simulated machine.
struct MachineSensorsSpec {
  double encoder_offset = 0;  ///< u: position of the machine at encoder count 0
  std::optional<MachineSwitch> home = {};
  std::optional<MachineSwitch> negative = {};  ///< limit switches
  std::optional<MachineSwitch> positive = {};
  std::optional<MachineIndex> index = {};
};

/// The limit switches of a machine: on at a position and beyond.
constexpr MachineSwitch negative_switch(double position, double bounce = 0) {
  return {.position = position, .inverted = true, .bounce = bounce};
}
constexpr MachineSwitch positive_switch(double position, double bounce = 0) {
  return {.position = position, .bounce = bounce};
}

}  // namespace jounce
