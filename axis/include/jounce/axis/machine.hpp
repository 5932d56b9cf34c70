// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/inputs.hpp"

namespace jounce {

/// The live master that an axis of a machine follows.
struct Follow {
  enum class What : std::uint8_t {
    nothing,   ///< no live master
    master,    ///< one of the machine's masters
    setpoint,  ///< the setpoint of another axis, in the same tick
    actual,    ///< actual position of another axis; lost if its drive reports no velocity
  };
  What what = What::nothing;  ///< kind of the master
  std::size_t index = 0;      ///< index of the master, or of the other axis
  /// The unit of the leader in m, the unit of the master of this axis: 1000 for a leader in m and
  /// m = mm. Position, velocity, acceleration and jerk of the leader are multiplied by it.
  double scale = 1;
};

/// A group: several axes that move together along a planned path (PLCopen part 4).
struct AxisGroup {
  std::vector<std::size_t> axes = {};  ///< indices of its axes, in the order of the path's axes
  /// Greatest distance of an axis from its place on the path at the start of a motion, in the unit
  /// of the axis; at most the distance that the axis covers in one tick at its velocity limit.
  double tolerance = 1e-6;
};

/// One axis of a machine, or one group. It does not change while the machine runs.
struct MachineAxis {
  std::string name = {};       ///< name of the axis in messages
  AxisConfig config = {};      ///< configuration
  AxisSwitches switches = {};  ///< cam switches
  Follow follow = {};          ///< live master
  AxisCompare compare = {};    ///< position compare
  /// A group is a virtual axis: its position is the length along its path. nullopt: a single axis.
  std::optional<AxisGroup> group = {};
  Follow second = {};  ///< second live master, for command::CombineAxes
  /// Indices of the axes that the compensation refers to, in the order of the table; the index of
  /// the axis itself is possible.
  std::vector<std::size_t> references = {};
};

/// The process image of one axis: its inputs and its outputs in one tick.
struct AxisImage {
  Command command = {};  ///< input
  Inputs inputs = {};    ///< input; the machine sets the master
  Tick tick = {};        ///< output
};

/// Several axes that are stepped together, as a pure function of their commands and inputs: no
/// clock, no thread, no device.
///
///     Machine machine({{.name = "feeder", .config = feeder},
///                      {.name = "knife", .config = knife,
///                       .follow = {.what = Follow::What::setpoint, .index = 0}}});
///     std::vector<AxisImage> images(machine.size());
///     images[0].command = {command::Enable{}};
///     machine.step(0, images);                       // images[i].tick: outputs of axis i
///
/// **Order.** An axis that follows the setpoint of another axis (its leader) uses the setpoint of
/// the same tick. Therefore leaders are stepped first; the other axes are stepped in the order in
/// which they are declared. Images, names and messages keep the declared order. The constructor
/// rejects a ring of axes that follow the setpoints of each other.
///
/// **Leaders.** A change of the coordinate of a leader (set_position, home) does not move its
/// followers. If a leader freezes (an abort, a disabled drive), it is lost to its followers in that
/// tick. The leader stays lost while it is disabled, because its position is then the position of
/// its drive. Followers of a lost leader brake within their own limits.
///
/// **Groups** (Arm::group): the armed movements of a group begin in the same tick, or none of them
/// begins. They begin in a tick for which the start of every one of them was accepted. The group
/// ends in the same or the next tick if a start is rejected, or if an axis is stopped or halted,
/// fails, or cannot begin. Then waiting starts are dropped, later starts are rejected, and all
/// motions stop. An axis that has output only its first point has not moved, and stays there.
///
/// **Groups of the machine** (AxisGroup, docs/executor/groups.md). A group plays a GroupPath, and
/// its axes follow it: they begin to move, and come to rest, in the same tick as the group. An axis
/// of an enabled group rejects motions of its own. A stop of an axis in motion stops the group. If
/// an axis of an enabled group can no longer follow (a fault, an abort, a disable), the group stops
/// on its path, with the fault `axis_fault`. A modulo axis without position limits begins where the
/// path begins or whole turns away from it, and keeps this distance in the motion.
///
/// **Compensation.** After all axes have been stepped, each correction is computed from the
/// setpoints of its references in the same tick. So two axes may refer to each other.
///
/// **Masters** are inputs: one Jet for each master and tick, in m (the unit of the master), m/s,
/// m/s^2, m/s^3. NaN: lost. If an axis is a master, m is the unit of that axis. The jerk of an
/// axis's setpoint counts as 0; the acceleration and jerk of an actual position count as 0.
///
/// step() does not allocate, free, lock or log. It throws InputError only for a wrong number of
/// images or masters, before it changes anything.
class Machine {
 public:
  static constexpr std::size_t most_axes = 64;  ///< greatest number of axes

  /// `masters` is the number of masters that step() receives. Throws InputError, with the name of
  /// the axis, for no axis or more than 64 axes, a missing or duplicate name, different periods, an
  /// invalid configuration, invalid switches, an invalid position compare, an index out of range,
  /// an axis that follows itself, a ring of axes that follow the setpoints of each other, an axis
  /// in two groups, an axis of a group that has a live master, and references that do not belong to
  /// the compensation.
  explicit Machine(std::vector<MachineAxis> axes, std::size_t masters = 0);

  [[nodiscard]] std::size_t size() const { return axes_.size(); }  ///< number of axes
  [[nodiscard]] std::size_t masters() const { return masters_; }   ///< number of masters
  /// Duration of a tick, ns.
  [[nodiscard]] std::int64_t period() const { return axes_.front().config.period; }
  /// Returns the axis with this index, as declared.
  [[nodiscard]] const MachineAxis& axis(std::size_t i) const { return axes_[i]; }

  /// Steps every axis. Call once a tick; `tick` must be greater than in the previous call. `images`
  /// has one entry for each axis, in the declared order; `masters` has one for each master.
  void step(std::int64_t tick, std::span<AxisImage> images, std::span<const Jet> masters = {});

 private:
  std::vector<MachineAxis> axes_;
  std::size_t masters_;
  std::vector<MotionAxis> motion_;
  /// The group of an axis, and the place of the axis in it.
  struct Membership {
    std::size_t group = 0;
    std::size_t place = 0;
  };
  void gather(std::size_t group, std::span<AxisImage> images);
  void lead(std::size_t axis, const Membership& in, std::span<AxisImage> images) const;
  void announce_references(std::span<AxisImage> images) const;
  void compensate(std::span<AxisImage> images);

  std::vector<std::optional<Membership>> memberships_;  // one for each axis
  std::vector<std::size_t> order_;  // order of the steps: leaders and groups first
  std::vector<bool> moved_;         // true for a group that moved in the previous tick
  std::vector<double> turns_;       // whole turns between each axis and the path of its group, u
};

}  // namespace jounce
