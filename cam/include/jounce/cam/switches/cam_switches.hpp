// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "jounce/cam/switches/cam_switch.hpp"

namespace jounce {
namespace detail {
class SwitchMachine;
}

/// Changes of the switches since the step before.
struct SwitchStep {
  static constexpr std::size_t most_edges = 32;

  std::uint32_t outputs = 0;  ///< now: bit k - 1 is track k
  std::uint32_t count = 0;    ///< count of edges
  std::uint32_t lost = 0;     ///< edges beyond the capacity (PMC600 error 629); outputs are right
  std::array<SwitchEdge, most_edges> edge{};  ///< ascending; time: s since the step before, [0, dt)

  [[nodiscard]] std::span<const SwitchEdge> edges() const { return {edge.data(), count}; }
};

/// The cam switches of an axis, stepped by its cycle. See cam_switch.hpp for what they mean.
///
///     CamSwitches bits({.switches = {{.first_on_position = 30, .last_on_position = 80}}});
///     bits.step(0, 100, 1e-3);                              // where the axis is: no edges yet
///     for (const SwitchEdge& edge : bits.step(30.05, 100, 1e-3).edges())
///       latch(edge.track, edge.on, edge.time);              // edge.time: s after the step before
///
/// **Within a cycle** the axis is taken to move on the cubic through position and velocity at both
/// ends (exact for a constant jerk), and its crossings are found on that as switch_times() does. A
/// position that such a cubic cannot reach in order (noise, a jump) is reached on a straight line:
/// every switch on the way is passed, and both its edges are in that step. Velocities of opposite
/// sign are believed: the axis turned round in between.
///
/// **Accuracy** of an edge at 1 ms, measured: on a constant acceleration 1e-12 s; on S-curve,
/// trapezoidal and sinusoidal masters below 1 us. What costs time is a step of the acceleration
/// within the cycle: at most dt^2 / (32 T) after T seconds of that acceleration from rest.
///
/// **Rotary axes** may give positions that wrap or that count on: of the positions one period apart
/// the one counts that lies nearest to where the velocities lead.
///
/// An edge is known in the step after it. An output terminal that switches by time stamp wants a
/// lead of one cycle and its own delay in the compensations.
///
/// step() neither allocates, locks nor throws. A step with a number that is not finite changes
/// nothing; its time is counted with the next one. The constructor throws as require_valid does.
class CamSwitches {
 public:
  explicit CamSwitches(const CamSwitchSpec& spec);
  ~CamSwitches();
  CamSwitches(CamSwitches&& other) noexcept;
  CamSwitches& operator=(CamSwitches&& other) noexcept;

  /// `position` u and `velocity` u/s of the axis now, `dt` > 0 s after the step before.
  const SwitchStep& step(double position, double velocity, double dt);

  /// The axis is elsewhere from the next step on without having moved there (a new reference, a
  /// new master): nothing is passed, but outputs may change, at time 0 of that step. Durations run
  /// on.
  void place() { placed_ = false; }

  /// Bit k - 1 enables track k (PLCopen EnableMask), from the next step on.
  void enable(std::uint32_t mask);

  [[nodiscard]] std::uint32_t outputs() const { return step_.outputs; }

 private:
  void place_at(double position, double velocity);
  void move(double position, double velocity);
  void collect(double dt);
  [[nodiscard]] double reduced(double position) const;

  std::unique_ptr<detail::SwitchMachine> machine_;
  double period_;  // 0: none
  bool known_ = false;
  bool placed_ = false;
  double position_ = 0;  // like given
  double local_ = 0;     // reduced into [0, period)
  double velocity_ = 0;
  double elapsed_ = 0;      // since the last position
  std::int64_t turns_ = 0;  // by which the frame moves on after this step
  SwitchStep step_;
};

}  // namespace jounce
