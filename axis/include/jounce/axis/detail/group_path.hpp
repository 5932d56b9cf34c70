// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/path/point.hpp"

namespace jounce {

/// The path of a group as a movement. The group plays it like a table over time: its setpoint is
/// the path parameter q (path.hpp), and parts() are the setpoints of its axes. along() is the
/// length along the path of the tool if the program has it (GroupProgram::length), otherwise q.
///
///     MotionAxis group(group_config(configs));
///     GroupPath path(1, program);
///     group.step(t, {command::Arm{&path}}, {.peers = Peers::together}); ...
///     const std::span<const Jet> setpoints = group.parts();
///
/// At the original speed, the position, velocity and acceleration of each axis equal the results of
/// Plan::at() bit for bit. A change of the rate (a hold, a stop, an override) changes only the time
/// of the plan, so the axes never leave the path. The slope of the rate is small enough that every
/// axis stays within its stop limits.
///
/// The position of the group counts from the position that begin() gets: the length of the path
/// that the group has already played, if this path continues another one (command::Extend).
///
/// A GroupPath can be played only once. Before its first setpoint, parts() returns the places at
/// which its axes begin.
class GroupPath final : public Movement {
 public:
  /// `id`: id of the motion in Tick::job. The program is shared.
  GroupPath(std::uint64_t id, GroupProgram program);

  /// Returns none, or no_movement if it was played before.
  Cause begin(const MotionState& group, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] double known() const noexcept override { return program_.plan->duration(); }
  [[nodiscard]] double pass() const noexcept override { return program_.plan->duration(); }
  [[nodiscard]] Peaks peaks() const noexcept override { return peaks_; }
  [[nodiscard]] std::span<const Jet> parts() const noexcept override {
    return std::span(parts_).first(program_.axes.size());
  }
  [[nodiscard]] std::span<const PathSwitch> switches(double from,
                                                     double to) const noexcept override;
  [[nodiscard]] PathPlace along(double time) const noexcept override;
  [[nodiscard]] double highest_rate() const noexcept override;
  [[nodiscard]] double rate_slope(double highest) const noexcept override;

 private:
  void seek(double t);

  GroupProgram program_;
  PlanCursor cursor_;
  Peaks peaks_;        // along the path
  double origin_ = 0;  // position of the group at the start of the path
  std::array<Jet, max_axes> parts_{};
  Progress progress_ = Progress::running;
  bool played_ = false;
};

}  // namespace jounce
