// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "jounce/axis/axis_compare.hpp"
#include "jounce/axis/detail/path_clock.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/cam/switches/cam_switches.hpp"
#include "jounce/path/point.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/pvt/live_compare.hpp"

#include "axis/src/group/path_outputs.hpp"
#include "axis/src/group/path_way.hpp"
#include "axis/src/state/outputs.hpp"

namespace jounce {

/// Everything that an axis or a group outputs at positions: cam switches, position compare, the
/// outputs of the path of a group, and the setpoints of the axes of a group.
///
///     AxisOutputs outputs(switches, compare);
///     outputs.begin_tick();
///     outputs.put_out(*path, clock.at(tick), dt, is_group);      // if a path was played
///     outputs.step({.commanded = {p, v}}, ...);                  // once a tick
///     outputs.get_switches(tick.switches);
///
/// Always true: the outputs belong to setpoints that were output. A position that changes without motion
/// passes no switch and no point. The functions do not allocate, lock or throw.
class AxisOutputs {
 public:
  /// Throws InputError like Outputs.
  AxisOutputs(const AxisSwitches& switches, const AxisCompare& compare)
      : outputs_(switches, compare),
        plane_axes_(compare.plane_axes),
        compares_way_(compare.list.has_value()) {}

  /// Begins a tick: no edges.
  void begin_tick() noexcept { path_outputs_.step(); }
  /// A motion begins from rest: the list of the position compare starts again.
  void begin() { outputs_.begin(); }
  /// The axis gets another position without motion.
  void rename() { outputs_.place(SwitchesOf::position); }
  /// The master gets another position without motion.
  void rename_master() { outputs_.place(SwitchesOf::master); }
  /// Another movement begins. `has_master`: its setpoints have a master.
  void enter(bool has_master) {
    has_master_ = has_master;
    rename_master();
  }

  // ---- the path of a group

  /// The path of a group begins from rest.
  void begin_path() noexcept { way_.reset(); }
  /// The setpoint of the path at this time was output. `dt`: time since the previous step, s.
  void put_out(const Movement& path, const PathTime& time, double dt, bool is_group) noexcept;
  /// The path continues as this one, whose path time is lower by `shift`, s.
  void continue_as(const Movement& path, double shift) noexcept;
  /// Another path of the group takes over from this one at the path time `boundary`, s.
  void leave(const Movement& path, double boundary) noexcept {
    if (compares_way_) way_.leave(path, boundary);
  }
  /// The setpoints of the axes of the group; empty before its first path.
  [[nodiscard]] std::span<const Jet> parts() const noexcept {
    return std::span(parts_).first(part_count_);
  }

  // ---- the outputs of a tick

  /// The positions of this tick, and the state of the axis.
  struct Places {
    OutputPlaces::Place commanded = {};  ///< setpoint
    OutputPlaces::Place actual = {};     ///< actual position, from the drive
    OutputPlaces::Place master = {};     ///< master of the movement that was entered
    bool is_group = false;               ///< a group: compares the length along its path
    bool on_path = false;                ///< the group plays its path
    bool disabled = false;               ///< a disabled group switches the outputs of its path off
  };
  /// Computes the outputs of this tick. `dt`: time since the previous step, s.
  void step(const Places& at, double dt);

  /// Sets `now` to the outputs, with their edges in the last step.
  void get_switches(SwitchStep& now) const noexcept {
    now = outputs_.switches();
    path_outputs_.add_to(now);
  }
  /// The output of the position compare, with its edges in the last step.
  [[nodiscard]] const CompareStep& compare() const { return outputs_.compare(); }

 private:
  Outputs outputs_;
  PathOutputs path_outputs_;
  PathWay way_;  // length of the path of a group, for the position compare
  std::array<std::size_t, 2> plane_axes_;
  bool compares_way_;
  bool has_master_ = false;  // true from the start of a cam to the next table without a cam
  std::array<Jet, max_axes> parts_{};
  std::size_t part_count_ = 0;
};

}  // namespace jounce
