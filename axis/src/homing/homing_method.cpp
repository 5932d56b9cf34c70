// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/detail/homing_method.hpp"

#include <array>
#include <cstddef>

namespace jounce {
namespace {

constexpr HomingMethod leaving(Sensor Sensors::*sensor, int search, int last) {
  return {sensor, search, true, last, false};
}

constexpr HomingMethod entering(Sensor Sensors::*sensor, int search, int last) {
  return {sensor, search, false, last, false};
}

/// Methods 17 to 30. A home switch is on either from one position to the end of the travel (19 to
/// 22) or in an interval (23 to 30).
constexpr std::array<HomingMethod, 14> by_edge{{
    leaving(&Sensors::negative, -1, 1),
    leaving(&Sensors::positive, 1, -1),
    leaving(&Sensors::home, 1, -1),
    entering(&Sensors::home, 1, 1),
    leaving(&Sensors::home, -1, 1),
    entering(&Sensors::home, -1, -1),
    leaving(&Sensors::home, 1, -1),
    entering(&Sensors::home, 1, 1),
    entering(&Sensors::home, 1, -1),
    leaving(&Sensors::home, 1, 1),
    leaving(&Sensors::home, -1, 1),
    entering(&Sensors::home, -1, -1),
    entering(&Sensors::home, -1, 1),
    leaving(&Sensors::home, -1, -1),
}};

}  // namespace

std::optional<HomingMethod> homing_method(int number) noexcept {
  constexpr int with_index = 1;
  constexpr int without = 17;
  const auto count = static_cast<int>(by_edge.size());
  const auto at = [&](int first) { return by_edge[static_cast<std::size_t>(number - first)]; };
  if (number >= without && number < without + count) return at(without);
  if (number >= with_index && number < with_index + count) {
    HomingMethod method = at(with_index);
    method.index = true;
    return method;
  }
  if (number == 33 || number == 34)
    return HomingMethod{.last = number == 33 ? -1 : 1, .index = true};
  if (number == 35 || number == 37) return HomingMethod{};
  return std::nullopt;
}

bool has_sensors(const HomingMethod& method, const Sensors& sensors) noexcept {
  return (method.sensor == nullptr || (sensors.*method.sensor).wired) &&
         (!method.index || sensors.index.wired);
}

}  // namespace jounce
