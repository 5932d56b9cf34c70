// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// An arm in the field of gravity: torque times sin(angle + ratio * th).
struct Gravity {
  double torque;
  double angle;
  double ratio;
};

/// Rigidly joined masses as one body, with the joint to the body before.
struct Body {
  double inertia = 0;
  double viscous = 0;
  std::vector<Friction> dry = {};  ///< those with dry friction; breakaway filled in
  double load = 0;                 ///< constant torque against positive motion
  std::vector<Gravity> gravity = {};
  double stiffness = 0;  ///< stiffness of the joint; the motor has none
  double damping = 0;
  double half_gap = 0;
  double efficiency = 1;

  [[nodiscard]] bool rubs() const { return !dry.empty() || efficiency < 1; }
};

/// The drive train from the motor on; a pendulum, where there is one, is the last.
std::vector<Body> bodies(const Drive& drive);

/// Coulomb's friction of all bodies, viscous friction of all, inertia of all.
double coulomb(const std::vector<Body>& train);
double viscous(const std::vector<Body>& train);
double inertia(const std::vector<Body>& train);

}  // namespace jounce::validate_detail
