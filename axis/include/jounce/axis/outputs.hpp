// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "jounce/cam/switches/cam_switches.hpp"
#include "jounce/pvt/live_compare.hpp"

namespace jounce {

/// The position compare of an axis: one list, restarted with each motion from rest.
struct AxisCompare {
  SwitchesOf of = SwitchesOf::position;  ///< position, or actual
  std::optional<PositionCompare> list = {};
};

/// Inputs of the outputs in one tick.
struct OutputPlaces {
  struct Place {
    double position = std::numeric_limits<double>::quiet_NaN();  ///< NaN: unknown
    double velocity = std::numeric_limits<double>::quiet_NaN();
  };
  Place commanded;  ///< u, u/s
  Place master;     ///< m, m/s
  Place actual;     ///< u, u/s; computed from positions if the drive reports no velocity
};

/// The outputs of an axis that depend on its position: its cam switches and its position compare,
/// evaluated at the state of each tick.
///
///     Outputs outputs(switches, compare);
///     outputs.begin();                                   // a motion begins from rest
///     outputs.step({.commanded = {p, v}}, dt);
///     for (const SwitchEdge& edge : outputs.switches().edges()) ...
///
/// step() does not allocate, lock or throw.
class Outputs {
 public:
  /// Throws InputError for bad switches or a bad list, "of" for a compare of the master.
  Outputs(const AxisSwitches& switches, const AxisCompare& compare);

  /// Moves the axis, or its master, elsewhere from the next step on, without passing an edge.
  void place(SwitchesOf what);
  void begin();
  void step(const OutputPlaces& places, double dt);

  [[nodiscard]] const SwitchStep& switches() const { return switch_step_; }
  [[nodiscard]] const CompareStep& compare() const { return compare_step_; }

 private:
  [[nodiscard]] OutputPlaces::Place place_of(SwitchesOf of, const OutputPlaces& places,
                                             double dt) const;

  bool has_switches_;
  SwitchesOf switches_of_;
  CamSwitches switches_;
  SwitchesOf compare_of_;
  std::optional<LiveCompare> compare_;
  double last_actual_ = std::numeric_limits<double>::quiet_NaN();
  SwitchStep switch_step_;
  CompareStep compare_step_;
};

}  // namespace jounce
