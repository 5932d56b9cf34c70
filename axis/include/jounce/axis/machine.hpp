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
    actual,    ///< actual position of the drive of another axis; lost without a velocity
  };
  What what = What::nothing;
  std::size_t index = 0;  ///< index of the master, or of the axis
};

/// One axis of a machine, fixed when it starts.
struct MachineAxis {
  std::string name;  ///< by which messages find it
  AxisConfig config;
  AxisSwitches switches = {};
  Follow follow = {};
  AxisCompare compare = {};
};

/// The process image of one axis: what passes between it and the world in one tick.
struct AxisImage {
  Command command = {};  ///< in
  Inputs inputs = {};    ///< in; the master is filled in by the machine
  Tick tick = {};        ///< out
};

/// Several axes in one cycle, as a pure function of their commands and inputs: no
/// clock, no thread, no device.
///
///     Machine machine({{.name = "feeder", .config = feeder},
///                      {.name = "knife", .config = knife,
///                       .follow = {.what = Follow::What::setpoint, .index = 0}}});
///     std::vector<AxisImage> images(machine.size());
///     images[0].command = {.kind = Command::Kind::enable};
///     machine.step(0, images);                       // images[i].tick: outputs of axis i
///
/// **Order.** An axis that follows another one's setpoint sees the setpoint of the same tick: so the
/// axes are stepped leaders first, and else as they were declared; images, names and messages keep
/// the declared order. Axes whose setpoints follow each other in a ring are refused.
///
/// A leader that is given another position (set_position, home) takes no follower with it. One that is frozen (an
/// abort, a drive that let go) is lost to its followers in that tick, and one that is disabled as long as it is: its
/// position is then that of its drive. So they brake within their own limits.
///
/// **Groups** (Command::group): what is armed in one group begins in one tick or not at all. It begins in the tick for
/// which the starts of all that are armed in the group were accepted before; otherwise none of it begins. Where
/// one start is refused, or one axis is stopped or halted, fails, or cannot begin, all starts that wait are dropped,
/// later ones are refused, and all motions stop, in that tick or the next one. An axis that has given out only its
/// first point stays there: it has not moved.
///
/// **Masters** come in from outside as one Jet a tick each: m, m/s, m/s^2, m/s^3; NaN: lost. An axis
/// gives its own in u. A setpoint's jerk counts as 0, an actual position's
/// acceleration too.
///
/// step() neither allocates nor frees, locks, logs nor throws.
class Machine {
 public:
  static constexpr std::size_t most_axes = 64;

  /// Throws InputError with the axis's name: no axis or more than 64, a name that is missing or
  /// there twice, periods that differ, a bad configuration or bad switches, an index to nothing, a
  /// ring. `masters`: how many step() will be given.
  explicit Machine(std::vector<MachineAxis> axes, std::size_t masters = 0);

  [[nodiscard]] std::size_t size() const { return axes_.size(); }
  [[nodiscard]] std::size_t masters() const { return masters_; }
  [[nodiscard]] std::int64_t period() const { return axes_.front().config.period; }  ///< ns
  [[nodiscard]] const MachineAxis& axis(std::size_t i) const { return axes_[i]; }

  /// Steps every axis: `images` in the declared order, one per axis. `tick` must be greater than in
  /// the step before.
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
