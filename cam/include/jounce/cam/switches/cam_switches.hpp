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

/// Changes of the switches since the previous step.
struct SwitchStep {
  static constexpr std::size_t most_edges = 32;

  std::uint32_t outputs = 0;  ///< now: bit k - 1 is track k
  std::uint32_t count = 0;    ///< count of edges
  std::uint32_t lost = 0;     ///< edges beyond the capacity (PMC600 error 629); outputs are valid
  std::array<SwitchEdge, most_edges> edge{};  ///< ascending; time: s since that step, [0, dt)

  [[nodiscard]] std::span<const SwitchEdge> edges() const { return {edge.data(), count}; }
};

/// The cam switches of an axis, stepped by its cycle. Definitions: cam_switch.hpp.
///
///     CamSwitches bits({.switches = {{.first_on_position = 30, .last_on_position = 80}}});
///     bits.step(0, 100, 1e-3);                             // initial position: no edges yet
///     for (const SwitchEdge& edge : bits.step(30.05, 100, 1e-3).edges())
///       latch(edge.track, edge.on, edge.time);             // edge.time: s after the previous step
///
/// **Within a cycle** the axis moves on the cubic through position and velocity at both ends (exact
/// for a constant jerk); its crossings are computed on that cubic, like in switch_times(). If the
/// cubic does not fit (noise, a jump), a straight line replaces it: the axis passes every switch in
/// between, and both edges are in that step. Velocities of opposite sign mean that the axis
/// reversed in between.
///
/// **Accuracy** of an edge at 1 ms, measured: on a constant acceleration 1e-12 s; on S-curve,
/// trapezoidal and sinusoidal masters below 1 us. A step of the acceleration within the cycle
/// causes an error of at most dt^2 / (32 T), after T seconds of that acceleration from rest.
///
/// **Rotary axes** may give positions that wrap or that count on: of the positions one period
/// apart, the nearest to the one predicted by the velocities counts.
///
/// An edge is available in the step after it. For an output terminal that switches by time stamp,
/// include a lead of one cycle and its own delay in the compensations.
///
/// step() does not allocate, lock or throw. A step with a number that is not finite changes
/// nothing; its time counts with the next one. The constructor throws like require_valid.
class CamSwitches {
 public:
  explicit CamSwitches(const CamSwitchSpec& spec);
  ~CamSwitches();
  CamSwitches(CamSwitches&& other) noexcept;
  CamSwitches& operator=(CamSwitches&& other) noexcept;

  /// `position` u and `velocity` u/s of the axis now, `dt` > 0 s after the previous step.
  const SwitchStep& step(double position, double velocity, double dt);

  /// Moves the axis elsewhere from the next step on, without motion (a new reference, a new
  /// master): it passes nothing, but outputs may change, at time 0 of that step. Durations
  /// continue.
  void place() { placed_ = false; }

  /// Bit k - 1 enables track k (PLCopen EnableMask), from the next step on.
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
