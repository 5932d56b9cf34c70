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
/// f / position_per_rev. Let r be the travel of the slave (m; for a rotary slave, rad) for one
/// radian of the motor.
///
///     (1)  torque = (inertia + mass r^2) theta'' + damping theta' + torque
///                   + r (stiffness f + preload + force + mass gravity)
///                   + coulomb sign(theta') + r lever sin(lever_angle + f)
///     (2)  power  = torque theta'
///     (3)  heat   = winding_loss torque^2
///     (4)  energy = integral of power > 0, less the share `recovered` of power < 0
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
  std::optional<double> winding_loss;
  // Limits of the motor, [load.limits]: checked by check_load().
  std::optional<double> peak_torque = {};  ///< N m
  std::optional<double> rms_torque = {};   ///< N m, over the cam
};

/// True if (1) is linear in f, f', f'', that is, if the load has neither dry friction nor a lever.
bool is_linear(const LoadSpec& load);

/// Returns the linear part of the torque of (1), as a quantity of a shape over the master. The
/// master runs at `speed` (master units in 1 s). `unit` is the slave's unit.
LinearQuantity torque_of(const LoadSpec& load, double speed, const std::string& unit);
/// Returns the speed of the motor, as a quantity of a shape over the master, like torque_of().
LinearQuantity motor_speed_of(const LoadSpec& load, double speed);

/// Returns the whole torque of (1), positive in the direction in which the slave's position grows.
/// So its peak, its rms value, and its sign relative to the velocity are those of the motor.
LoadTorque load_torque_of(const LoadSpec& load, double speed, const std::string& unit);

/// Returns the energy (4) of a shape over the master, in J.
EnergyOf energy_of(const LoadSpec& load, double speed, const std::string& unit);

/// A figure of [optimize], and how it is printed.
struct ShapeFigureSpec {
  std::string name;      ///< name in the spec, such as "motor heating"
  std::string unit;      ///< unit of the printed number
  ShapeFigure figure;    ///< the figure that is computed
  double factor = 1;     ///< the printed number is factor * value; with `squared`, factor * value^2
  bool squared = false;  ///< true: the value is squared
  bool times_length = false;  ///< true: the printed number is multiplied by the length of the run
};

/// Convert the computed value of a figure, for a run of this length, to the printed number, and
/// back.
double shown(const ShapeFigureSpec& figure, double value, double length);
double computed(const ShapeFigureSpec& figure, double shown);

/// The free shapes of a cam spec, and the objectives for them; see jounce/optimize/cam_shape.hpp.
struct ShapeSpec {
  std::vector<FreeShape> shapes = {};                      ///< the free segments
  std::optional<LoadSpec> load = {};                       ///< [load]
  std::vector<std::vector<WeightedFigure>> minimize = {};  ///< objectives, the most important first
  std::vector<Ceiling> ceilings = {};                      ///< upper limits of figures
  /// The figures of `minimize`, followed by those of `ceilings`, in the order of
  /// CamRunOutcome::figures.
  std::vector<ShapeFigureSpec> figures = {};
  std::vector<Corridor> corridors = {};  ///< corridors for quantities
  bool refine = false;                   ///< true: add knots where the highest derivative of the
                                         ///< optimum switches
};

}  // namespace jounce
