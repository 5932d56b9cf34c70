// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "jounce/profiles/curve/jet.hpp"
#include "jounce/pvt/compensation.hpp"

namespace jounce {

/// Setpoints of the references of a compensation in one tick, in their units: u, u/s, u/s^2; the
/// jerk is 0. A position on a modulo axis is within the turn.
using References = std::array<Jet, Compensation::most_references>;

/// Correction table of an axis (SetupComp, SetupComp2D and SetupComp3D of HIWIN HIMC).
struct AxisCompensation {
  CompensationSpec table = {};  ///< the table; values in u, the unit of the axis
  /// Index of the reference that is the corrected axis itself; nullopt: none is.
  std::optional<std::size_t> own = {};
};

/// The compensation of an axis while it runs (HMPL manual 14.1): the drive receives the setpoint
/// plus the correction at the setpoints of the references.
///
///     LiveCompensation screw({.table = {{{-100, 200, 5}}, values}, .own = 0}, 0);
///     screw.set(true);
///     screw.see(references);                     // setpoints of this tick
///     Jet c = screw.correction();                // added to the setpoint of the drive
///     double x = screw.position_of(drive);       // x + c(x) = drive
///
/// No function allocates or throws after the construction.
class LiveCompensation {
 public:
  /// Greatest slope of the correction with respect to the position of the corrected axis. Within
  /// it, each position of the drive belongs to one position of the axis.
  static constexpr double most_slope = 0.5;

  /// `modulo`: length of one turn of the corrected axis, u; 0: a linear axis. Throws InputError
  /// like Compensation, and for a table that is steeper than most_slope. On a modulo axis, also
  /// throws if the grid of the own reference leaves the turn, or if the corrections at its two ends
  /// differ.
  LiveCompensation(const AxisCompensation& spec, double modulo);

  /// True if the correction is active.
  [[nodiscard]] bool active() const { return active_; }
  void set(bool active) { active_ = active; }

  /// Takes the setpoints of the references in this tick.
  void see(const References& references) { references_ = references; }
  /// The correction at these setpoints, and its derivatives, u, u/s, u/s^2; 0 while it is not
  /// active. At a grid line of a linear table, the cell that begins there gives the derivatives.
  [[nodiscard]] Jet correction() const;
  /// Position of the axis at which its drive, with the correction, stands at `drive`, u. Uses the
  /// setpoints of the other references that were seen last.
  [[nodiscard]] double position_of(double drive) const;

 private:
  [[nodiscard]] double at(double position) const;

  Compensation table_;
  std::optional<std::size_t> own_;
  double modulo_;
  References references_{};
  bool active_ = false;
};

}  // namespace jounce
