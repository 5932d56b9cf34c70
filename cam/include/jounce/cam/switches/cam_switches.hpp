// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "jounce/cam/switches/cam_switch.hpp"

namespace jounce {
namespace cam_detail {
class SwitchMachine;
}

/// Outputs after a step, and the edges since the previous step.
struct SwitchStep {
  static constexpr std::size_t most_edges = 32;  ///< greatest number of edges that a step returns

  std::uint32_t outputs = 0;  ///< present outputs: bit k - 1 is track k
  std::uint32_t count = 0;    ///< number of edges
  /// Number of edges beyond most_edges (PMC600 error 629); the outputs are valid.
  std::uint32_t lost = 0;
  /// Ascending in time; time in s since the previous step, in [0, dt).
  std::array<SwitchEdge, most_edges> edge{};

  [[nodiscard]] std::span<const SwitchEdge> edges() const { return {edge.data(), count}; }
};

/// The cam switches of an axis, computed cycle by cycle. Definitions: cam_switch.hpp.
///
///     CamSwitches bits({.switches = {{.first_on_position = 30, .last_on_position = 80}}});
///     bits.step(0, 100, 1e-3);                             // initial position: no edges yet
///     for (const SwitchEdge& edge : bits.step(30.05, 100, 1e-3).edges())
///       latch(edge.track, edge.on, edge.time);             // edge.time: s after the previous step
///
/// **Within a cycle**, the axis is assumed to move on the cubic through the positions and
/// velocities at both ends, which is exact for a constant jerk. The edges are computed on this
/// cubic, as in switch_times(). If the cubic is implausible (noise, a jump), a straight line
/// replaces it: the axis then passes every switch between both positions, and the step returns the
/// on edge and the off edge. Velocities of opposite sign at the ends mean that the axis has
/// reversed within the cycle.
///
/// **Accuracy** of the time of an edge, measured with cycles of 1 ms: 1e-12 s at constant
/// acceleration; below 1 us for S-curve, trapezoidal and sinusoidal masters. If the acceleration
/// steps within a cycle dt, T seconds after the axis began to accelerate from rest, the error is at
/// most dt^2 / (32 T).
///
/// **Rotary axes** may have positions that wrap, or positions that continue. Of the positions that
/// differ by whole periods, step() uses the one nearest to the position that the velocities
/// predict.
///
/// step() returns an edge in the step after the edge. If an output terminal switches by time stamp,
/// include one cycle and the delay of the terminal in the compensations.
///
/// step() does not allocate, lock or throw. If the position or the velocity is not finite, the step
/// returns the previous outputs without edges, and its time is added to the next step. The
/// constructor throws like require_valid().
class CamSwitches {
 public:
  explicit CamSwitches(const CamSwitchSpec& spec);
  ~CamSwitches();
  CamSwitches(CamSwitches&& other) noexcept;
  CamSwitches& operator=(CamSwitches&& other) noexcept;

  /// Computes the outputs. Arguments: the present position (u) and velocity (u/s) of the axis, and
  /// the time since the previous step (s, > 0).
  const SwitchStep& step(double position, double velocity, double dt);

  /// Makes the next step move the axis to its position without passing a switch, as after homing or
  /// for a new master. Outputs may change at time 0 of that step. Durations continue.
  void place() { placed_ = false; }

  /// Enables the tracks of the mask from the next step on: bit k - 1 is track k (PLCopen
  /// EnableMask).
  void enable(std::uint32_t mask);

  [[nodiscard]] std::uint32_t outputs() const { return step_.outputs; }

 private:
  void place_at(double position, double velocity);
  void move(double position, double velocity);
  void collect(double dt);
  [[nodiscard]] double reduced(double position) const;

  std::unique_ptr<cam_detail::SwitchMachine> machine_;
  double period_;  // 0: none
  bool known_ = false;
  bool placed_ = false;
  double position_ = 0;  // unreduced
  double local_ = 0;     // reduced into [0, period)
  double velocity_ = 0;
  double elapsed_ = 0;      // time since the last position, s
  std::int64_t turns_ = 0;  // turns by which the frame moves after this step
  SwitchStep step_;
};

}  // namespace jounce
