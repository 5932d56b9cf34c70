// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce::cam_detail {

/// One piece of an axis's motion x(s), with its reversals.
struct TurningPiece {
  Segment x, velocity;
  std::vector<double> turns = {};  ///< s in [0, 1], 0 and 1 included

  TurningPiece();
  /// Allocates nothing within the capacity of `turns`, which suffices for degree 3.
  void set(const Segment& motion);
};

/// An interval of a piece over which the compensated position is monotone.
struct MonotonePart {
  double begin = 0, end = 0;  ///< s in [0, 1]; equal: a jump
  double from = 0, to = 0;    ///< positions
  bool forwards = true;       ///< direction of the axis; the direction of y may differ
};

/// The compensated position y = x - c v of one boundary over a piece, in monotone intervals. c has
/// one value for an axis that moves forwards, and another value for an axis that moves backwards.
class SwitchPath {
 public:
  SwitchPath(double forwards, double backwards);

  [[nodiscard]] double forwards() const { return forwards_; }
  [[nodiscard]] double backwards() const { return backwards_; }

  void place(double x, double velocity);
  void begin(const TurningPiece& piece);
  void shift(double distance) { last_ -= distance; }

  [[nodiscard]] std::span<const MonotonePart> parts() const { return parts_; }
  /// The time at which y reaches the target, which lies within the interval: s from the piece's
  /// start.
  [[nodiscard]] double time(const MonotonePart& part, double target) const;
  /// y at the end of the previous piece.
  [[nodiscard]] double last() const { return last_; }

 private:
  void add(const TurningPiece& piece, double begin, double end);

  double forwards_, backwards_;
  Segment ahead_, back_;  // y for either direction
  std::vector<MonotonePart> parts_;
  std::vector<double> turns_;
  double last_ = 0;
};

}  // namespace jounce::cam_detail
