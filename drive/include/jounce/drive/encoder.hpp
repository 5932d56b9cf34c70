// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "jounce/drive/drive.hpp"

namespace jounce {

/// Errors of a simulated encoder.
struct EncoderErrors {
  double resolution = 0;   ///< u per count; it rounds down to a count; 0: no rounding
  double noise = 0;        ///< u rms, white and normal, before rounding; 0: none
  std::uint64_t seed = 1;  ///< seed of the noise
};

/// A position as an encoder reports it: adds noise, then rounds to counts. Reproducible for a seed.
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

/// A drive whose actual position has another reader: the cycle reads it once, and both get the same
/// value.
///
///     auto observed = std::make_shared<ObservedDrive>(drive);   // the drive of the axis
///     observed->position();                                     // after feedback() in this cycle
class ObservedDrive final : public AxisDrive {
 public:
  explicit ObservedDrive(std::shared_ptr<AxisDrive> drive) : drive_(std::move(drive)) {}

  void command(const DriveSetpoint& setpoint) noexcept override { drive_->command(setpoint); }
  [[nodiscard]] Feedback feedback() noexcept override;

  /// u, in the drive's coordinate; NaN: not available, or failed.
  [[nodiscard]] double position() const noexcept { return position_; }

 private:
  std::shared_ptr<AxisDrive> drive_;
  double position_ = std::numeric_limits<double>::quiet_NaN();
};

/// Actual position of a drive; NaN: not available, or the drive has failed.
double told_position(const Feedback& feedback);

}  // namespace jounce
