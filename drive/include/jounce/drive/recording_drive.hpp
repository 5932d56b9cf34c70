// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "jounce/drive/drive.hpp"

namespace jounce {

/// Records the last setpoints for a drive, and passes all setpoints on to the drive:
///
///     NullDrive drive;
///     RecordingDrive recording(drive, 2000);
///     ...
///     for (std::size_t i = 0; i < recording.size(); ++i) look_at(recording[i]);   // oldest first
///
/// The constructor allocates all memory. Read the record only when the cycle does not run.
class RecordingDrive final : public AxisDrive {
 public:
  /// `behind`: the drive, which must outlive this object. `capacity`: number of setpoints that are
  /// kept. Throws InputError for a capacity of 0.
  RecordingDrive(AxisDrive& behind, std::size_t capacity);

  void begin(std::int64_t tick) noexcept override { behind_.begin(tick); }
  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override { return behind_.feedback(); }

  /// Number of setpoints that are kept.
  [[nodiscard]] std::size_t size() const { return count_ < kept_.size() ? count_ : kept_.size(); }
  [[nodiscard]] std::size_t count() const { return count_; }  ///< number of all setpoints so far
  /// Returns a recorded setpoint: i = 0 is the oldest, i = size() - 1 the newest.
  [[nodiscard]] const DriveSetpoint& operator[](std::size_t i) const {
    return kept_[(count_ - size() + i) % kept_.size()];
  }

 private:
  AxisDrive& behind_;
  std::vector<DriveSetpoint> kept_;
  std::size_t count_ = 0;
};

}  // namespace jounce
