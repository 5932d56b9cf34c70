// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"
#include "jounce/pvt/position_compare.hpp"

namespace jounce {

/// Output after a step, and the edges since the previous step.
struct CompareStep {
  static constexpr std::size_t most_edges = 16;  ///< greatest number of edges that a step returns

  bool output = false;      ///< present output
  std::uint32_t count = 0;  ///< number of edges
  std::uint32_t lost = 0;   ///< number of edges beyond most_edges; the output is correct
  /// Ascending; time in s since the previous step, in [0, dt).
  std::array<OutputEdge, most_edges> edge{};

  [[nodiscard]] std::span<const OutputEdge> edges() const { return {edge.data(), count}; }
};

/// The position compare of an axis, computed cycle by cycle. For a known motion, use
/// position_compare.hpp.
///
///     LiveCompare camera({.mode = CompareMode::linear, .points = evenly(10, 1, 11), .pulse = 2e-5});
///     camera.arm();                                        // a motion begins at the first point
///     for (const OutputEdge& edge : camera.step(position, velocity, 1e-3).edges()) ...
///
/// **Within a cycle**, the axis is assumed to move by cycle_motion(). Crossings are roots of this
/// motion, not samples: exact to 1e-12 s for a constant jerk. Times are in s, positions in u.
///
/// **Arming** starts the list again, with the output off, from the position in the previous step.
/// The points that the axis passes in the next step fire in that step, even if arm() was called
/// within the cycle. A point at the position of the axis fires in the next step as well. No point
/// fires before arming, or after the last point of the list.
///
/// step() does not allocate, lock or throw. If the position is not finite, only time passes, and
/// pulses end. If the velocity is not finite, step() computes it from the positions.
class LiveCompare {
 public:
  /// Throws InputError like compared().
  explicit LiveCompare(const PositionCompare& compare);

  void arm();  ///< restarts the list; see above
  /// Makes the next step move the axis to its position without passing a point.
  void place() { placed_ = false; }

  /// Computes the output. Arguments: the present position (u) and velocity (u/s) of the axis, and
  /// the time since the previous step (s, > 0).
  const CompareStep& step(double position, double velocity, double dt);

  /// Number of points that have fired since arming.
  [[nodiscard]] std::size_t fired() const { return next_; }

 private:
  void move(double position, double velocity);
  void fire(double dt);
  [[nodiscard]] std::optional<double> reach(double level);
  std::optional<double> arrive(double s);
  void pass(const ComparePoint& point, double s, double dt);
  void end_pulse(double before, double dt);
  void emit(double time, bool on, double position);
  [[nodiscard]] double position_at(double time, double dt) const;

  PositionCompare compare_;
  bool pulses_;
  bool armed_ = false;
  bool placed_ = false;
  std::size_t next_ = 0;
  Segment piece_;                 // motion since the last given position
  double s_ = 0;                  // the part of it that has been searched, 0 to 1
  std::optional<double> side_;    // side of the next point on which the axis was last
  std::optional<double> off_in_;  // s after the last step, at which a pulse ends
  double position_ = 0, velocity_ = 0;
  double elapsed_ = 0;  // s since the last given position
  std::vector<double> found_;
  CompareStep step_;
};

}  // namespace jounce
