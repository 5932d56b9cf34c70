// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "jounce/axis/axis_compare.hpp"
#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/command.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/axis/tick.hpp"
#include "jounce/cam/switches/cam_switches.hpp"
#include "jounce/command/state.hpp"
#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// An axis as a pure state machine: each call of step() computes one tick. It has no clock. step()
/// does not allocate, free, lock, log or throw.
///
///     MotionAxis axis({.limits = {.velocity = 1000, .acceleration = 1e4}});
///     axis.step(0, {command::Enable{}});
///     axis.step(1, {command::Arm{&job}});
///     axis.step(2, {command::Start{}});                  // local time 0: the table's first point
///     Tick now = axis.step(3);                           // bit for bit job.at(0.001)
///
/// **Time** is the number of the tick times the period, so rounding errors do not accumulate. The
/// numbers of the ticks must ascend. If ticks are skipped, the motion skips the same time.
///
/// **Motion.** The axis plays either a movement, or a move that it plans itself from its last
/// setpoint. A movement is a path (whose time the axis can slow down) or a coupling to a live
/// master. A superimposed move is added to either. Rules: docs/executor/axis.md.
///
/// **Slots.** The axis holds two movements, one that it plays and one that is armed. It owns
/// neither. When it reads a movement for the last time, it returns the movement in
/// Tick::handed_back, once.
///
/// **Outputs** (cam switches, position compare) are computed in each tick from the positions of the
/// axis. A new coordinate (set_position), or a new master at the start of a motion, passes no
/// switch and no compare position. A switch whose state differs at the new position changes at time
/// 0 of the tick. Outputs are computed in every state, even if the axis is disabled or in a fault.
///
/// **Drives.** Feedback is in the coordinate of the drive. set_position changes the coordinate of
/// the axis by `offset`, and does not move the drive. While the axis is disabled, its setpoint is
/// the position of the drive, if the drive reports a position; so enabling the axis causes no
/// motion.
///
/// **Homing** (homing.hpp) finds the home position of the machine from the switches and the index
/// that the drive reports. During homing, the position range does not apply, and the axis may stand
/// on a limit switch.
///
/// **Touch probes** (touch_probe.hpp) capture positions at the edges of trigger inputs, in every
/// state.
///
/// **Compensation** (AxisConfig::compensation) adds a correction to the setpoint of the drive,
/// after all checks. The position of the axis, its limits and its outputs do not include the
/// correction; feedback is converted back. The compensation can be switched on and off only while
/// the axis is disabled, so the axis does not move. While the compensation is active, the
/// coordinates of the axis and of its references do not change.
///
/// **Registration** (AxisConfig::registration) corrects every motion that follows the live master
/// by the marks that a trigger input reports. When such a motion begins, the correction begins at
/// 0; if another such motion replaces it, the correction continues. A correction of the master (a
/// phase) is included in Tick::master.
///
/// **Groups.** Inputs::peers states whether a MotionAxis is a group of the machine, or an axis of a
/// group (docs/executor/groups.md). The position of a group is the length along its path. The
/// setpoints for the axes of the group are parts(); in motion, each axis of the group receives its
/// setpoint as Inputs::master.
///
/// **Safety.** When the axis arms a movement, it checks the movement against its limits, for every
/// sender. Before the axis outputs a setpoint in motion, it compares the setpoint with the previous
/// one and with the limits. A fault stays until a reset. docs/executor/axis.md lists the reaction
/// to each fault.
class MotionAxis {
 public:
  /// Throws InputError for an invalid configuration, invalid switches, or an invalid compare list.
  explicit MotionAxis(const AxisConfig& config, const AxisSwitches& switches = {},
                      const AxisCompare& compare = {});
  ~MotionAxis();
  /// Leaves `other` without an axis: only assign to it, or destroy it.
  MotionAxis(MotionAxis&& other) noexcept;
  MotionAxis& operator=(MotionAxis&& other) noexcept;

  /// Executes the command and returns the outputs of this tick. Call once a tick; `tick` must be >=
  /// 0 and greater than in the previous call (asserted).
  Tick step(std::int64_t tick, const Command& command = {}, const Inputs& inputs = {});

  /// Second part of a tick, after step() of every axis of the machine: computes the correction of
  /// the compensation from the setpoints of its references. Returns it as Tick::correction, also
  /// for the next step. Requires AxisConfig::compensation.
  Jet compensate(const References& references);

  /// The configuration with its defaults filled in.
  [[nodiscard]] const AxisConfig& config() const;
  /// State after the last step.
  [[nodiscard]] State state() const;
  /// For a group (AxisGroup in machine.hpp): the setpoints of its axes after the last step: u, u/s,
  /// u/s^2, u/s^3. Empty if the group has not had a path yet.
  [[nodiscard]] std::span<const Jet> parts() const;
  /// For a group: the positions at which its axes must stand when it next begins to move. At rest
  /// with an armed path: the start of this path; otherwise parts().
  [[nodiscard]] std::span<const Jet> places() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce
