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

/// Changes of a compare since the step before.
struct CompareStep {
  static constexpr std::size_t most_edges = 16;

  bool output = false;                        ///< now
  std::uint32_t count = 0;                    ///< count of edges
  std::uint32_t lost = 0;                     ///< edges beyond the capacity; the output is right
  std::array<OutputEdge, most_edges> edge{};  ///< ascending; time: s since the step before, [0, dt)

  [[nodiscard]] std::span<const OutputEdge> edges() const { return {edge.data(), count}; }
};

/// The position compare of an axis, stepped by its cycle: position_compare.hpp tick by tick instead
/// of along a known motion.
///
///     LiveCompare camera({.mode = CompareMode::linear, .points = evenly(10, 1, 11), .pulse = 2e-5});
///     camera.arm();                                        // a motion begins: from the first point
///     for (const OutputEdge& edge : camera.step(position, velocity, 1e-3).edges()) ...
///
/// **Within a cycle** the axis moves by cycle_motion(); crossings are its roots, not samples: as
/// exact as that motion, 1e-12 s at a constant jerk. Times in s, positions in u.
///
/// **Arming** restarts the list, with the output off, from the position in the step before. If a
/// start comes late, or within a cycle, the points passed by the next step fire in that step.
/// Before that, and after the last point, nothing fires. A point at the position of the axis when
/// it is armed fires in that step.
///
/// step() does not allocate, lock or throw. A position that is not finite is none: time passes, and
/// pulses end. A velocity that is not finite is taken from the positions.
class LiveCompare {
 public:
  /// Throws InputError like compared().
  explicit LiveCompare(const PositionCompare& compare);

  void arm();
  /// The axis is elsewhere from the next step on without having moved there: nothing is passed.
  void place() { placed_ = false; }

  /// `position` u and `velocity` u/s of the axis now, `dt` > 0 s after the step before.
  const CompareStep& step(double position, double velocity, double dt);

  /// Points that have fired since it was armed.
  [[nodiscard]] std::size_t fired() const { return next_; }

 private:
  void move(double position, double velocity);
  void fire(double dt);
  [[nodiscard]] std::optional<double> reach(double level);
  std::optional<double> arrive(double s);
  void pass(const ComparePoint& point, double time);
  void end_pulse(double before);
  void emit(double time, bool on);

  PositionCompare compare_;
  bool pulses_;
  bool armed_ = false;
  bool placed_ = false;
  std::size_t next_ = 0;
  Segment piece_;                 // the way since the last given position
  double s_ = 0;                  // part of it searched so far, 0 to 1
  std::optional<double> side_;    // side of the next point, where the axis was last
  std::optional<double> off_in_;  // s after the last step: the end of a pulse
  double position_ = 0, velocity_ = 0;
  double elapsed_ = 0;  // s since then
  std::vector<double> found_;
  CompareStep step_;
};

}  // namespace jounce
