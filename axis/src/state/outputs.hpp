// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "jounce/axis/axis_compare.hpp"
#include "jounce/cam/switches/cam_switches.hpp"
#include "jounce/pvt/live_compare.hpp"
#include "jounce/pvt/live_plane_compare.hpp"

namespace jounce {

/// Inputs of Outputs::step() in one tick. Units: u is the unit of the axis, m the unit of its
/// master.
struct OutputPlaces {
  /// A position and its velocity.
  struct Place {
    double position = std::numeric_limits<double>::quiet_NaN();  ///< NaN: unknown
    double velocity = std::numeric_limits<double>::quiet_NaN();  ///< NaN: unknown
  };
  Place commanded;  ///< setpoint: u, u/s
  /// For a group: length along its path and velocity of the tool, for its position compare: u, u/s.
  Place way;
  Place master;  ///< live master: m, m/s
  /// Position that the drive reports: u, u/s; a NaN velocity is computed from successive positions.
  Place actual;
  /// Setpoints of the two axes of AxisCompare::plane: u, u/s.
  std::array<Place, 2> plane;
};

/// The outputs of an axis that depend on its position: its cam switches and its position compare,
/// computed in each tick from its positions.
///
///     Outputs outputs(switches, compare);
///     outputs.begin();                                   // a motion begins from rest
///     outputs.step({.commanded = {p, v}}, dt);
///     for (const SwitchEdge& edge : outputs.switches().edges()) ...
///
/// step() does not allocate, lock or throw.
class Outputs {
 public:
  /// Throws InputError for invalid switches or an invalid list, and with the key "of" for a compare
  /// of the master.
  Outputs(const AxisSwitches& switches, const AxisCompare& compare);

  /// Announces that the position `what` will be set without motion in the next step; with
  /// SwitchesOf::position, also the actual position. Then no switch and no point is passed. The
  /// output of a switch whose state differs at the new position changes at time 0 of that step.
  void place(SwitchesOf what);
  /// Starts the list of the position compare again. Call when a motion begins from rest.
  void begin();
  /// Computes the outputs of one tick. Call once a tick. `dt` is the time since the previous step,
  /// s.
  void step(const OutputPlaces& places, double dt);

  /// Outputs of the cam switches, with their edges in the last step.
  [[nodiscard]] const SwitchStep& switches() const { return switch_step_; }
  /// Output of the position compare, with its edges in the last step.
  [[nodiscard]] const CompareStep& compare() const { return compare_step_; }

 private:
  [[nodiscard]] OutputPlaces::Place place_of(SwitchesOf of, const OutputPlaces& places,
                                             double dt) const;

  bool has_switches_;
  SwitchesOf switches_of_;
  CamSwitches switches_;
  SwitchesOf compare_of_;
  std::optional<LiveCompare> compare_;
  std::optional<LivePlaneCompare> plane_;
  double last_actual_ = std::numeric_limits<double>::quiet_NaN();
  SwitchStep switch_step_;
  CompareStep compare_step_;
};

}  // namespace jounce
