// SPDX-License-Identifier: Apache-2.0
// A rotary table of 360 deg: which way to a target, also while it turns.
#include <cstdio>
#include <utility>

#include "jounce/profiles/curve/modulo.hpp"

using namespace jounce;

int main() {
  const Turned spot = rolled(360e12 + 90, 360);
  std::printf("%g deg after %.0f turns\n", spot.position, spot.turns);

  const Bounds table = within(720, 7200, 72000);  // deg/s, deg/s^2, deg/s^3
  for (const auto& [name, direction] : {std::pair{"negative", Direction::negative},
                                        {"shortest", Direction::shortest},
                                        {"positive", Direction::positive},
                                        {"current", Direction::current},
                                        {"fastest", Direction::fastest}}) {
    const ModuloTarget at_rest = modulo_target({10, 0, 0}, 240, direction, 360, table);
    const ModuloTarget turning = modulo_target({10, 720, 0}, 240, direction, 360, table);
    std::printf("10 to 240, %s: %+.0f at rest, %+.0f at 720 deg/s\n", name, at_rest.distance,
                turning.distance);
  }
}

// > 90 deg after 1000000000000 turns
// > 10 to 240, negative: -130 at rest, -130 at 720 deg/s
// > 10 to 240, shortest: -130 at rest, -130 at 720 deg/s
// > 10 to 240, positive: +230 at rest, +230 at 720 deg/s
// > 10 to 240, current: -130 at rest, +230 at 720 deg/s
// > 10 to 240, fastest: -130 at rest, +230 at 720 deg/s
