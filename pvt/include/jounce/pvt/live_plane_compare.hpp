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

/// Throws InputError for a band or a pulse that is not positive, or for no points.
void require_valid(const PlaneCompare& compare);

/// An edge of one output of a LivePlaneCompare.
struct PlaneEdge {
  double time = 0;  ///< s since the previous step
  int output = 0;   ///< number of the output, 1 to 32
  bool on = false;  ///< true: the output goes on
};

/// Outputs after a step, and the edges since the previous step.
struct PlaneStep {
  static constexpr std::size_t most_edges = 32;  ///< greatest number of edges that a step returns

  std::uint32_t outputs = 0;  ///< present outputs: bit k - 1 is the output k
  std::uint32_t count = 0;    ///< number of edges
  std::uint32_t lost = 0;     ///< number of edges beyond most_edges; the outputs are correct
  std::array<PlaneEdge, most_edges> edge{};  ///< ascending in time, in [0, dt)

  [[nodiscard]] std::span<const PlaneEdge> edges() const { return {edge.data(), count}; }
};

/// The position compare of two axes (PlaneCompare), computed cycle by cycle. For known motions, use
/// compared() in position_compare.hpp.
///
///     LivePlaneCompare zones({.x_band = 2, .y_band = 2, .points = {{50, 0, 16}}, .pulse = 1e-3});
///     // the point x = 50, y = 0 switches the output 16
///     zones.arm();                                         // a motion begins at the first point
///     for (const PlaneEdge& edge : zones.step({x, vx}, {y, vy}, 1e-3).edges()) ...
///
/// **Within a cycle**, each axis is assumed to move by cycle_motion(). A point fires at the exact
/// instant at which these motions meet its condition. Points fire in the order of the list, as in
/// LiveCompare. Each output has a pulse of its own; a pulse that begins during another one of the
/// same output extends it.
///
/// step() does not allocate, lock or throw. If a position is not finite, only time passes.
class LivePlaneCompare {
 public:
  /// Position (u) and velocity (u/s) of an axis.
  struct Place {
    double position = 0;
    double velocity = 0;
  };

  /// Throws InputError like compared(), and for an output that is not 1 to 32.
  explicit LivePlaneCompare(const PlaneCompare& compare);

  void arm();  ///< restarts the list
  /// Makes the next step move the axes to their positions without passing a point.
  void place() { placed_ = false; }
  /// Computes the outputs. `dt`: time since the previous step, s, > 0.
  const PlaneStep& step(const Place& x, const Place& y, double dt);

  /// Number of points that have fired since arming.
  [[nodiscard]] std::size_t fired() const { return next_; }

 private:
  [[nodiscard]] std::optional<double> reach(const PlaneCompare::Point& point);
  [[nodiscard]] bool fires(const PlaneCompare::Point& point, double s) const;
  void find(const Segment& f, double level);
  void end_pulses(double before);
  void emit(double time, int output, bool on);

  PlaneCompare compare_;
  bool armed_ = false;
  bool placed_ = false;
  std::size_t next_ = 0;
  Place x_, y_;                        // in the last step
  Segment of_x_, of_y_;                // motions since then
  double elapsed_ = 0;                 // their length, s
  double s_ = 0;                       // the part of them that has been searched, 0 to 1
  std::vector<double> found_, roots_;  // candidates
  std::array<double, 32> off_{};  // s after the last step, at which the pulse of an output ends
  PlaneStep step_;
};

}  // namespace jounce
