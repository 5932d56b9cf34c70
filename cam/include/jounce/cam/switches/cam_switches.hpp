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
/// **Within a cycle** the axis moves on the cubic through position and velocity at both ends, which
/// is exact for a constant jerk. Its crossings are computed on that cubic, as in switch_times(). If
/// the cubic is implausible (noise, a jump), a straight line replaces it: the axis passes every
/// switch between both positions, and the step returns both edges. Velocities of opposite sign at
/// the ends mean that the axis has reversed within the cycle.
///
/// **Accuracy** of an edge, measured with cycles of 1 ms: 1e-12 s at constant acceleration; below 1
/// us for S-curve, trapezoidal and sinusoidal masters. A step of the acceleration within a cycle dt
/// causes an error of at most dt^2 / (32 T), if the axis has accelerated from rest for T seconds.
///
/// **Rotary axes** may give positions that wrap, or that continue. Of the positions that differ by
/// whole periods, the one nearest to the position predicted by the velocities is used.
///
/// step() returns an edge in the step after the edge. For an output terminal that switches by time
/// stamp, include one cycle and the delay of the terminal in the compensations.
///
/// step() does not allocate, lock or throw. If an argument is not finite, the step changes nothing,
/// and its time is added to the next step. The constructor throws like require_valid().
class CamSwitches {
 public:
  explicit CamSwitches(const CamSwitchSpec& spec);
  ~CamSwitches();
  CamSwitches(CamSwitches&& other) noexcept;
  CamSwitches& operator=(CamSwitches&& other) noexcept;

  /// Computes the outputs. Arguments: the present position (u) and velocity (u/s) of the axis, and
  /// the time since the previous step (s, > 0).
  const SwitchStep& step(double position, double velocity, double dt);

  /// Makes the next step move the axis to its position without motion, as after a new reference or
  /// a new master. The axis passes no switch; outputs may change, at time 0 of that step. Durations
  /// continue.
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
  double elapsed_ = 0;      // since the last position
  std::int64_t turns_ = 0;  // turns by which the frame moves after this step
  SwitchStep step_;
};

}  // namespace jounce
