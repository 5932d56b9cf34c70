// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/encoder.hpp"

#include <cmath>
#include <numbers>

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

/// Uses splitmix64 (Steele, Lea, Flood 2014), the upper 53 bits.
double EncoderReading::uniform() noexcept {
  state_ += 0x9E3779B97F4A7C15U;
  std::uint64_t z = state_;
  z = (z ^ z >> 30U) * 0xBF58476D1CE4E5B9U;
  z = (z ^ z >> 27U) * 0x94D049BB133111EBU;
  z ^= z >> 31U;
  return (static_cast<double>(z >> 11U) + 0.5) * 0x1p-53;
}

double told_position(const Feedback& feedback) {
  return feedback.fault ? std::numeric_limits<double>::quiet_NaN() : feedback.position;
}

Feedback ObservedDrive::feedback() noexcept {
  const Feedback said = drive_->feedback();
  position_ = told_position(said);
  return said;
}

}  // namespace jounce
