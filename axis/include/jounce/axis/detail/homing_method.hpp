// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/axis/inputs.hpp"

namespace jounce {

/// A homing method of CiA 402 (object 6098h): the home position and the search for it.
struct HomingMethod {
  Sensor Sensors::*sensor = nullptr;  ///< switch to search for; null: the method uses no switch
  int search = 0;                     ///< first direction of the search for the switch: -1 or 1
  bool leaves = false;  ///< true: home is the place where the switch goes off; false: where it goes
                        ///< on
  /// Direction in which the axis passes home, -1 or 1; 0: home is the present position.
  int last = 0;
  bool index = false;  ///< true: home is the first index after the edge, in the direction `last`
};

/// Returns the method with this number of CiA 402; nullopt if the number has no method. Numbers: 1
/// to 14, switch and index; 17 to 30, the same switches without the index; 33 and 34, the next
/// index; 35 and 37, the present position.
std::optional<HomingMethod> homing_method(int number) noexcept;

/// True if the machine has the sensors that the method needs.
bool has_sensors(const HomingMethod& method, const Sensors& sensors) noexcept;

}  // namespace jounce
