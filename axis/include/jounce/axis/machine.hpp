// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/inputs.hpp"

namespace jounce {

/// The live master of an axis of a machine.
struct Follow {
  enum class What : std::uint8_t {
    nothing,   ///< it has no live master
    master,    ///< one of the machine's masters
    setpoint,  ///< setpoint of another axis in the same tick
    actual,  ///< actual position of the drive of another axis; lost if the drive reports no velocity
  };
  What what = What::nothing;
  std::size_t index = 0;  ///< index of the master, or of the axis
};

/// One axis of a machine. It does not change while the machine runs.
struct MachineAxis {
  std::string name;  ///< its name in messages
  AxisConfig config;
  AxisSwitches switches = {};
  Follow follow = {};
  AxisCompare compare = {};
};

/// The process image of one axis: its inputs and outputs in one tick.
struct AxisImage {
  Command command = {};  ///< in
  Inputs inputs = {};    ///< in; the master is filled in by the machine
  Tick tick = {};        ///< out
};

/// Several axes in one cycle, as a pure function of their commands and inputs: no clock, no thread,
/// no device.
///
///     Machine machine({{.name = "feeder", .config = feeder},
///                      {.name = "knife", .config = knife,
///                       .follow = {.what = Follow::What::setpoint, .index = 0}}});
///     std::vector<AxisImage> images(machine.size());
///     images[0].command = {command::Enable{}};
///     machine.step(0, images);                       // images[i].tick: outputs of axis i
///
/// **Order.** An axis that follows the setpoint of another reads the setpoint of the same tick.
/// Leaders are therefore stepped first, otherwise axes are stepped in declared order; images, names
/// and messages keep the declared order. The constructor rejects axes whose setpoints follow each
/// other in a ring.
///
/// A new position of a leader (set_position, home) does not move its followers. A leader that
/// freezes (an abort, a disabled drive) is lost to its followers in that tick. A disabled leader is
/// lost for as long as it is disabled: its position is then that of its drive. The followers
/// therefore brake within their own limits.
///
/// **Groups** (Command::group): the armed movements of one group begin in one tick or not at all.
/// They begin in that tick if, for each of them, a start in that tick was accepted earlier;
/// otherwise none begins. If a start is rejected, or an axis is stopped or halted, fails, or cannot
/// begin, then all waiting starts are dropped, later ones are rejected, and all motions stop, in
/// that tick or the next. An axis that has output only its first point stays there: it has not
/// moved.
///
/// **Masters** are inputs: one Jet per master and tick, in m, m/s, m/s^2, m/s^3; NaN: lost. An axis
/// that is a master gives its position in its own unit u. The jerk of a setpoint counts as 0, and
/// so does the acceleration of an actual position.
///
/// step() does not allocate, free, lock, log or throw.
class Machine {
 public:
  static constexpr std::size_t most_axes = 64;

  /// Throws InputError with the axis's name: no axis or more than 64, a missing or duplicate name,
  /// different periods, a bad configuration or bad switches, an index out of range, a ring.
  /// `masters`: number of masters passed to step().
  explicit Machine(std::vector<MachineAxis> axes, std::size_t masters = 0);

  [[nodiscard]] std::size_t size() const { return axes_.size(); }
  [[nodiscard]] std::size_t masters() const { return masters_; }
  [[nodiscard]] std::int64_t period() const { return axes_.front().config.period; }  ///< ns
  [[nodiscard]] const MachineAxis& axis(std::size_t i) const { return axes_[i]; }

  /// Steps every axis: `images` in the declared order, one per axis. `tick` must be greater than in
  /// the previous step.
  void step(std::int64_t tick, std::span<AxisImage> images, std::span<const Jet> masters = {});

 private:
  [[nodiscard]] Jet master_of(std::size_t axis, std::span<const AxisImage> images,
                              std::span<const Jet> masters) const;
  [[nodiscard]] double master_offset_of(std::size_t axis, std::span<const AxisImage> images) const;

  std::vector<MachineAxis> axes_;
  std::size_t masters_;
  std::vector<MotionAxis> motion_;
  std::vector<std::size_t> order_;  // order of the steps: leaders first
};

}  // namespace jounce
