#include "jounce/executor/drive.hpp"

namespace jounce {

DriveSetpoint drive_setpoint(const Tick& tick, const Command& command, const Tick& before) {
  DriveSetpoint setpoint{.tick = tick.tick,
                         .time = tick.time,
                         .position = tick.position,
                         .velocity = tick.velocity,
                         .acceleration = tick.acceleration,
                         .enable = tick.state != State::disabled,
                         .quick_stop = tick.state == State::error_stop,
                         .reset = command.kind == Command::Kind::reset && !tick.refused};
  // A place is named anew only at rest: then all of the step is the new name.
  if (command.kind == Command::Kind::set_position && !tick.refused)
    setpoint.renamed = tick.position - before.position;
  return setpoint;
}

void NullDrive::command(const DriveSetpoint& setpoint) noexcept {
  position_ = setpoint.position;
  velocity_ = setpoint.velocity;
}

Feedback NullDrive::feedback() noexcept {
  return {.position = position_, .velocity = velocity_};
}

}  // namespace jounce
