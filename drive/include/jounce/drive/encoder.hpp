// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "jounce/drive/drive.hpp"

namespace jounce {

/// Errors of a simulated encoder. Unit u: the unit of the position.
struct EncoderErrors {
  /// Size of one count, u: positions are rounded down to a whole number of counts. 0: not rounded.
  double resolution = 0;
  /// Standard deviation of white normal noise, u, added before rounding; 0: none.
  double noise = 0;
  std::uint64_t seed = 1;  ///< seed of the noise
};

/// A simulated encoder: adds noise to a position, then rounds it down to counts. The same seed
/// gives the same noise.
///
///     EncoderReading line({.resolution = 0.05, .noise = 0.01});
///     const double measured = line(actual);                     // each cycle
class EncoderReading {
 public:
  /// Throws InputError for a magnitude that is negative or not finite.
  explicit EncoderReading(const EncoderErrors& errors = {});
  /// Returns the reading for a position, u. NaN stays NaN.
  double operator()(double position) noexcept;

 private:
  double uniform() noexcept;  // in (0, 1)

  EncoderErrors errors_;
  std::uint64_t state_;
};

/// Makes the actual position of a drive available to a second reader, such as an axis that follows
/// the position. The cycle reads the drive once, so both readers get the same value.
///
///     auto observed = std::make_shared<ObservedDrive>(drive);   // the drive of the axis
///     observed->position();                                     // after feedback() in this cycle
class ObservedDrive final : public AxisDrive {
 public:
  /// `drive`: the drive that is read and commanded.
  explicit ObservedDrive(std::shared_ptr<AxisDrive> drive) : drive_(std::move(drive)) {}

  void command(const DriveSetpoint& setpoint) noexcept override { drive_->command(setpoint); }
  [[nodiscard]] Feedback feedback() noexcept override;

  /// Actual position of the last feedback(), u, in the coordinate of the drive; NaN: not available,
  /// or the drive has failed.
  [[nodiscard]] double position() const noexcept { return position_; }

 private:
  std::shared_ptr<AxisDrive> drive_;
  double position_ = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the actual position in a feedback; NaN: the position is not available, or the drive has
/// failed.
double reported_position(const Feedback& feedback);

}  // namespace jounce
