// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/optimize/cam_shape.hpp"

namespace jounce {

/// The load of the slave's motor: section [load]. All values refer to the motor's shaft or to the
/// slave, as their comments state. At the slave position f, the angle of the shaft is theta = 2 pi
/// f / position_per_rev. Let s be the same position in m (for a rotary slave, in rad). Let r be the
/// travel of the slave (m; for a rotary slave, rad) for one radian of the motor.
///
///     (1)  T      = (inertia + mass r^2) theta'' + damping theta' + torque
///                   + r (stiffness s + preload + force + mass gravity)
///                   + coulomb sign(theta') + r lever sin(lever_angle + s)
///     (2)  power  = T theta'
///     (3)  heat   = winding_loss T^2
///     (4)  energy = integral of max(power, 0) - recovered max(-power, 0)
///
/// The first two lines of (1) are linear in f, f', f''.
struct LoadSpec {
  /// Travel in one turn of the motor, in the slave's unit; its sign is the direction of the motor.
  double position_per_rev = 0;
  double inertia = 0;      ///< kg m^2, at the motor
  double damping = 0;      ///< N m s/rad, at the motor
  double torque = 0;       ///< N m, at the motor; constant
  double mass = 0;         ///< kg, moving mass of a linear slave
  double gravity = 0;      ///< m/s^2 along the slave; positive: against its positive direction
  double stiffness = 0;    ///< stiffness of a return spring: N/m; rotary slave: N m/rad
  double preload = 0;      ///< force of the spring at slave position 0: N; rotary slave: N m
  double force = 0;        ///< constant force against the positive direction: N; rotary slave: N m
  double coulomb = 0;      ///< N m, >= 0: dry friction at the motor
  double lever = 0;        ///< N m, weight times length of an arm on a rotary slave
  double lever_angle = 0;  ///< rad, angle of the arm at slave position 0; 0: hanging down
  /// Share of braking energy that is recovered: 0 a braking resistor, 1 a drive without losses.
  double recovered = 0;
  /// W/(N m)^2: resistance / (torque constant)^2; omitted: no heat.
  std::optional<double> winding_loss = {};
  // Limits of the motor, [load.limits]; `jounce check` checks them. Omitted: no limit.
  std::optional<double> peak_torque = {};  ///< N m
  std::optional<double> rms_torque = {};   ///< N m, over the cam
};

/// True if (1) is linear in f, f', f'', that is, if the load has neither dry friction nor a lever.
bool is_linear(const LoadSpec& load);

/// Returns the linear part of the torque (1), N m, as a linear function of the slave's position and
/// its derivatives with respect to the master. The part contains neither dry friction nor the
/// lever. The master runs at `speed` (master units in 1 s). `unit` is the slave's unit.
LinearQuantity torque_of(const LoadSpec& load, double speed, const std::string& unit);
/// Returns the speed of the motor, rad/s, in the same form.
LinearQuantity motor_speed_of(const LoadSpec& load, double speed);

/// Returns the whole torque (1). Its sign is for the direction in which the slave's position grows,
/// even if position_per_rev is negative. So its magnitude equals the magnitude of the motor's
/// torque, and torque times slave velocity has the sign of the power.
LoadTorque load_torque_of(const LoadSpec& load, double speed, const std::string& unit);

/// Returns the energy (4) of a shape over the master, in J.
EnergyOf energy_of(const LoadSpec& load, double speed, const std::string& unit);

/// A figure of [optimize], and how it is printed.
struct ShapeFigureSpec {
  std::string name = {};    ///< name in the spec, such as "motor heating"
  std::string unit = {};    ///< unit of the printed number
  ShapeFigure figure = {};  ///< the figure that is computed
  double factor = 1;     ///< the printed number is factor * value; with `squared`, factor * value^2
  bool squared = false;  ///< true: the value is squared
  bool times_length = false;  ///< true: the printed number is multiplied by `length` of shown()
};

/// Returns the printed number for the computed value of a figure. `length` is the length of the run
/// of free segments, in the unit of the master.
double shown(const ShapeFigureSpec& figure, double value, double length);
/// Returns the computed value for a printed number. Not for a figure with `times_length`, because
/// its number depends on a length.
double computed(const ShapeFigureSpec& figure, double shown);

/// The free shapes of a cam spec, and the objectives for them; see jounce/optimize/cam_shape.hpp.
struct ShapeSpec {
  std::vector<FreeShape> shapes = {};                      ///< the free segments
  std::optional<LoadSpec> load = {};                       ///< [load]
  std::vector<std::vector<WeightedFigure>> minimize = {};  ///< objectives, the most important first
  std::vector<Ceiling> ceilings = {};                      ///< upper limits of figures
  /// The figures of `minimize`, followed by the figures of `ceilings`, in the order of
  /// CamRunOutcome::shape.figures.
  std::vector<ShapeFigureSpec> figures = {};
  /// Lower and upper bounds of quantities over a range of the master.
  std::vector<Corridor> corridors = {};
  /// True: add knots where the highest derivative of the optimum jumps from one of its limits to
  /// the other.
  bool refine = false;
};

}  // namespace jounce
