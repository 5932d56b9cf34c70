// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// The weight of an arm: a torque of torque * sin(angle + ratio * th), with th the angle of the
/// motor.
struct Gravity {
  double torque;  ///< N m
  double angle;   ///< angle of the arm from its hanging position at th = 0, rad
  double ratio;   ///< turns of the arm for each turn of the motor
};

/// One body: masses that are joined rigidly, with the joint to the previous body.
struct Body {
  double inertia = 0;                 ///< kg m^2
  double viscous = 0;                 ///< viscous friction, N m s/rad
  std::vector<Friction> dry = {};     ///< the dry frictions of its masses, with breakaway set
  double load = 0;                    ///< constant torque against positive motion, N m
  std::vector<Gravity> gravity = {};  ///< the arms of its masses
  double stiffness = 0;               ///< stiffness of the joint, N m/rad; unused for the motor
  double damping = 0;                 ///< damping of the joint, N m s/rad
  double half_gap = 0;                ///< half of the backlash, rad
  double efficiency = 1;              ///< efficiency of the gear in the joint

  /// True if the body has dry friction, or a gear with losses.
  [[nodiscard]] bool rubs() const { return !dry.empty() || efficiency < 1; }
};

/// Returns the bodies from the motor on. A pendulum is the last one.
std::vector<Body> bodies(const Drive& drive);

/// Sums over all bodies: Coulomb friction, viscous friction, inertia.
double coulomb(const std::vector<Body>& train);
double viscous(const std::vector<Body>& train);
double inertia(const std::vector<Body>& train);

}  // namespace jounce::validate_detail
