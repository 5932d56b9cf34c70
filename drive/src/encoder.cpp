// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/encoder.hpp"

#include <cmath>
#include <numbers>

#include "jounce/profiles/detail/random.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

EncoderReading::EncoderReading(const EncoderErrors& errors) : errors_(errors), state_(errors.seed) {
  require_not_negative("resolution", errors.resolution);
  require_not_negative("noise", errors.noise);
}

double EncoderReading::operator()(double position) noexcept {
  if (errors_.noise > 0) {  // Box and Muller (1958)
    const double radius = std::sqrt(-2 * std::log(uniform()));
    position += errors_.noise * radius * std::cos(2 * std::numbers::pi * uniform());
  }
  if (errors_.resolution == 0) return position;
  return errors_.resolution * std::floor(position / errors_.resolution);
}

/// In (0, 1), so that its logarithm is finite.
double EncoderReading::uniform() noexcept {
  return (static_cast<double>(profiles_detail::splitmix64(state_) >> 11U) + 0.5) * 0x1p-53;
}

double reported_position(const Feedback& feedback) {
  return feedback.fault ? std::numeric_limits<double>::quiet_NaN() : feedback.position;
}

Feedback ObservedDrive::feedback() noexcept {
  const Feedback said = drive_->feedback();
  position_ = reported_position(said);
  return said;
}

}  // namespace jounce
