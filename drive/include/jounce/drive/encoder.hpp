// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "jounce/drive/drive.hpp"

namespace jounce {

/// Errors of a simulated encoder.
struct EncoderErrors {
  double resolution = 0;   ///< u of a count, to which it rounds down; 0: none
  double noise = 0;        ///< u rms, white and normal, before it counts; 0: none
  std::uint64_t seed = 1;  ///< seed of the noise
};

/// A position as an encoder reports it: noise, then counts. The same everywhere for a seed.
///
///     EncoderReading line({.resolution = 0.05, .noise = 0.01});
///     const double measured = line(actual);                     // each cycle
class EncoderReading {
 public:
  /// Throws InputError for a magnitude that is negative or not finite.
  explicit EncoderReading(const EncoderErrors& errors = {});
  /// NaN stays NaN.
  double operator()(double position) noexcept;

 private:
  double uniform() noexcept;  // in (0, 1)

  EncoderErrors errors_;
  std::uint64_t state_;
};

/// A drive whose actual position somebody else reads, too: the cycle asks it once and both see the same.
///
///     auto observed = std::make_shared<ObservedDrive>(drive);   // is the axis's drive from now on
///     observed->position();                                     // after its feedback() in this cycle
class ObservedDrive final : public AxisDrive {
 public:
  explicit ObservedDrive(std::shared_ptr<AxisDrive> drive) : drive_(std::move(drive)) {}

  void command(const DriveSetpoint& setpoint) noexcept override { drive_->command(setpoint); }
  [[nodiscard]] Feedback feedback() noexcept override;

  /// u, as the drive counts; NaN: not available, or failed.
  [[nodiscard]] double position() const noexcept { return position_; }

 private:
  std::shared_ptr<AxisDrive> drive_;
  double position_ = std::numeric_limits<double>::quiet_NaN();
};

/// Actual position of a drive; NaN: not available, or failed with an old value.
double told_position(const Feedback& feedback);

}  // namespace jounce
