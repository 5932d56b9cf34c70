// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/recording_drive.hpp"

#include "jounce/profiles/error.hpp"

namespace jounce {

RecordingDrive::RecordingDrive(AxisDrive& behind, std::size_t capacity) : behind_(behind) {
  if (capacity == 0) throw InputError("capacity", "0", "must be at least 1");
  kept_.resize(capacity);
}

void RecordingDrive::command(const DriveSetpoint& setpoint) noexcept {
  kept_[count_++ % kept_.size()] = setpoint;
  behind_.command(setpoint);
}

}  // namespace jounce
