// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/drive.hpp"

namespace jounce {

DriveSetpoint drive_setpoint(const Tick& tick, const Command& command) {
  return {.tick = tick.tick,
          .time = tick.time,
          .position = tick.position + tick.correction[0] - tick.offset,
          .velocity = tick.velocity + tick.correction[1],
          .acceleration = tick.acceleration + tick.correction[2],
          .enable = tick.power,
          .reset = command.kind() == CommandKind::reset && !tick.refused};
}

void NullDrive::command(const DriveSetpoint& setpoint) noexcept {
  position_ = setpoint.position;
  velocity_ = setpoint.velocity;
}

Feedback NullDrive::feedback() noexcept {
  return {.position = position_, .velocity = velocity_};
}

}  // namespace jounce
