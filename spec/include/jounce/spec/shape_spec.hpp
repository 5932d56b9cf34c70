// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/optimize/cam_shape.hpp"

namespace jounce {

/// Load of the slave's motor, [load], at the motor's shaft, whose angle is theta = 2 pi f /
/// position_per_rev at the slave position f. With r the metres (rotary: radians) of the slave for a
/// radian of the motor, and w the master's speed,
///
///     (1)  torque = (inertia + mass r^2) theta'' + damping theta' + torque
///                   + r (stiffness f + preload + force + mass gravity)
///                   + coulomb sign(theta') + r lever sin(lever_angle + f)
///     (2)  power  = torque theta'
///     (3)  heat   = winding_loss torque^2
///     (4)  energy = integral of power > 0, less the share `recovered` of power < 0
///
/// Its first two lines are linear in f, f', f''.
struct LoadSpec {
  double position_per_rev = 0;  ///< slave's unit for a turn of the motor; its sign is the motor's
  double inertia = 0;           ///< kg m^2, at the motor
  double damping = 0;           ///< N m s/rad, at the motor
  double torque = 0;            ///< N m, at the motor: constant
  double mass = 0;              ///< kg, of a slave that moves straight
  double gravity = 0;           ///< m/s^2 along the slave, against its positive direction
  double stiffness = 0;         ///< stiffness of a return spring: N/m, of a rotary slave N m/rad
  double preload = 0;           ///< its force at slave position 0: N, or N m
  double force = 0;             ///< constant, against the positive direction: N, or N m
  double coulomb = 0;           ///< N m, at the motor: dry friction, >= 0
  double lever = 0;             ///< N m, at a rotary slave: weight times length of its arm
  double lever_angle = 0;       ///< rad, of the arm from hanging down, at slave position 0
  double recovered = 0;         ///< 0 a braking resistor ... 1 a drive without losses
  std::optional<double> winding_loss;  ///< W/(N m)^2: resistance / (torque constant)^2
  // Limits of the motor, [load.limits]: checked by check_load().
  std::optional<double> peak_torque = {};  ///< N m
  std::optional<double> rms_torque = {};   ///< N m, over the cam
};

/// True if (1) is linear in the shape: no dry friction, no lever.
bool is_linear(const LoadSpec& load);

/// The linear part of the torque of (1), and the motor's speed, as quantities of a shape over the master,
/// which runs at `speed` of its units in 1 s; `unit` is the slave's.
LinearQuantity torque_of(const LoadSpec& load, double speed, const std::string& unit);
LinearQuantity motor_speed_of(const LoadSpec& load, double speed);

/// All of (1), counted in the direction in which the slave's position grows: its peak, its rms and its
/// sign against the velocity are those of the motor.
LoadTorque load_torque_of(const LoadSpec& load, double speed, const std::string& unit);

/// (4): J, of a shape over the master.
EnergyOf energy_of(const LoadSpec& load, double speed, const std::string& unit);

/// A figure of [optimize] with the data to print it.
struct ShapeFigureSpec {
  std::string name;    ///< name in the spec: "motor heating"
  std::string unit;    ///< unit of the number that is printed
  ShapeFigure figure;  ///< the computed figure
  double factor = 1;   ///< printed is factor value, or factor value^2
  bool squared = false;
  bool times_length = false;  ///< times the length of the run
};

/// The number that is printed for a figure of a run, and back.
double shown(const ShapeFigureSpec& figure, double value, double length);
double computed(const ShapeFigureSpec& figure, double shown);

/// The free shapes of a cam spec, and the objectives for them.
struct ShapeSpec {
  std::vector<FreeShape> shapes = {};
  std::optional<LoadSpec> load = {};
  std::vector<std::vector<WeightedFigure>> minimize = {};
  std::vector<Ceiling> ceilings = {};
  /// Figures of `minimize`, then of `ceilings`: in the order of CamRunOutcome::figures.
  std::vector<ShapeFigureSpec> figures = {};
  std::vector<Corridor> corridors = {};
  bool refine = false;
};

}  // namespace jounce
