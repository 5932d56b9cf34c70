// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace jounce {

/// The strokes of a repetitive move (command::MoveRepetitive): from one end to the other and back,
/// with a rest between two strokes. u is the unit of the axis.
///
///     Repetition strokes(0, 400, 0.05, 10);   // the first stroke leads from 0 to 400
///     while (strokes.goes_on()) next_target = strokes.turn();
class Repetition {
 public:
  /// The first stroke leads from the position `from` to the position `to`, u. `wait`: rest between
  /// two strokes, s. `strokes`: number of strokes; 0: no limit.
  Repetition(double from, double to, double wait, std::int32_t strokes) noexcept
      : wait_(wait), left_(strokes), next_(from), present_(to) {}

  /// Rest between two strokes, s.
  [[nodiscard]] double wait() const noexcept { return wait_; }
  /// True if another stroke follows the present one.
  [[nodiscard]] bool goes_on() const noexcept { return left_ != 1; }
  /// End of the next stroke, u.
  [[nodiscard]] double next() const noexcept { return next_; }
  /// Begins the next stroke.
  void turn() noexcept {
    const double there = next_;
    next_ = present_;
    present_ = there;
    if (left_ > 1) --left_;
  }
  /// Makes the present stroke the last one.
  void finish() noexcept { left_ = 1; }

 private:
  double wait_;
  std::int32_t left_;  // strokes left, the present one included; 0: no limit
  double next_;
  double present_;
};

}  // namespace jounce
