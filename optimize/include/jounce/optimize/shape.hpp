// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jounce/optimize/outcome.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// q = by[0] f + by[1] f' + ... + by[5] f^(5) + constant: a linear function of a shape f and its
/// derivatives at one place. The torque of a load J a + B v + K s + F behind a master that turns at
/// w is {"torque", {K, B w, J w^2}, F}.
struct LinearQuantity {
  std::string name;  ///< in the user's words: "geo_acceleration", "torque"
  std::array<double, 6> by{};
  double constant = 0;
};

/// f itself (0: "value"), geo_velocity (1), geo_acceleration (2), geo_jerk (3), geo_jounce (4),
/// geo_crackle (5).
LinearQuantity derivative_of_shape(int order);

// ---- what can be minimized or limited: over the whole shape -----------------------------------

/// max |q|, at every place.
struct PeakOf {
  LinearQuantity quantity;
};

/// sqrt(integral of q^2 / length): also motor heating, energy in a winding.
struct RmsOf {
  LinearQuantity quantity;
};

/// The amplitude in u at which a mode (Mode, jounce/profiles/vibration/vibration.hpp) swings after the end,
/// the worst over a band: frequencies in cycles per unit of x, damping ratios.
struct ResidualOf {
  double low = 0;
  double high = 0;  ///< low == high: one frequency
  double damping_low = 0;
  double damping_high = 0;
};

/// max |force * velocity|, at every place: not convex.
struct PowerOf {
  LinearQuantity force;
  LinearQuantity velocity;
};

/// The torque of a load that the shape moves, if it is not linear in the shape f:
///
///     (1)  T = linear + d/dx (J(x) f') + coulomb sign(f') + gravity sin(angle + turn f)
///
/// Units are those of `linear`: T in N m if coulomb and gravity are in N m. An inertia kg m^2
/// behind a master of w (unit of x)/s enters J with the factor w^2.
struct LoadTorque {
  std::string name = "torque";
  LinearQuantity linear = {};  ///< J f'' + B f' + K f + F
  std::vector<Segment> inertia =
      {};              ///< J(x) over the shape's interval, in addition to `linear`; no sines
  double coulomb = 0;  ///< dry friction, >= 0
  double gravity = 0;  ///< gravity of a lever: weight times its length
  double turn = 0;     ///< rad/u
  double angle = 0;    ///< rad, at f = 0; 0: hanging down
};

/// max |T| at every place; at a change of sign of f', on both sides of it.
struct TorqueOf {
  LoadTorque load;
};

/// sqrt(integral of T^2 / length): it determines the heat in the motor.
struct RmsTorqueOf {
  LoadTorque load;
};

/// The integral over x of the input power, T f' > 0, minus the recovered share of the returned
/// power: 0 for a braking resistor, 1 for a drive without losses.
struct EnergyOf {
  LoadTorque load;
  double recovered = 0;  ///< 0...1
};

/// max |y| of a list of numbers y that is any affine function of the shape, such as the torque of a
/// drive at every millisecond. Sampled: only at the places of the list. Throws for a response that
/// is not affine, not finite, or of varying size.
struct ResponseOf {
  std::string name;
  std::function<std::vector<double>(const Trajectory& shape)> of;  ///< always of the same size
};

/// sqrt(mean of y^2) of such a list: the rms torque of a drive.
struct RmsResponseOf {
  std::string name;
  std::function<std::vector<double>(const Trajectory& shape)> of;  ///< always of the same size
};

/// PowerOf, TorqueOf, RmsTorqueOf and EnergyOf are not convex: docs/optimize/physics.md.
using ShapeFigure = std::variant<PeakOf, RmsOf, ResidualOf, PowerOf, ResponseOf, TorqueOf,
                                 RmsTorqueOf, EnergyOf, RmsResponseOf>;

std::string name(const ShapeFigure& figure);

// ---- the problem ------------------------------------------------------------------------------

/// Fixed values at one end; an omitted value is free.
struct ShapeEnd {
  std::optional<double> value = {};         ///< u
  std::optional<double> velocity = {};      ///< u/x
  std::optional<double> acceleration = {};  ///< u/x^2
  std::optional<double> jerk = {};          ///< u/x^3
  std::optional<double> jounce = {};        ///< u/x^4
};

/// A bound that runs straight from its value at `from` to that at `to`.
struct Edge {
  double at_from = 0;
  double at_to = 0;
};

/// A quantity held between two edges over a window of x: a limit, a keep-out zone, a monotone interval
/// (geo_velocity, lower 0), a point to pass within a tolerance (from == to), a interval in step (value,
/// lower == upper: kept exactly).
struct Corridor {
  LinearQuantity quantity;
  double from = 0;
  double to = 0;
  std::optional<Edge> lower = {};
  std::optional<Edge> upper = {};
};

/// A figure that may not exceed a value.
struct Ceiling {
  ShapeFigure figure;
  double at_most = 0;
};

struct WeightedFigure {
  ShapeFigure figure;
  double weight = 1;  ///< weight of figure / (its value for the given shape), > 0
};

/// A free function between two ends, and the objectives for its shape.
///
///     ShapeProblem problem;                                       // rest to rest, 0..1
///     problem.from = {.value = 0, .velocity = 0, .acceleration = 0};
///     problem.to = {.value = 1, .velocity = 0, .acceleration = 0};
///     problem.minimize = {{PeakOf{derivative_of_shape(3)}}};
///     ShapeOutcome best = optimize_shape(problem);                // peak jerk 32: the perfect spline
///
/// The shape is a spline: `pieces` polynomials of `degree`, joined with degree - 1 continuous
/// derivatives. Its knots are equidistant at first; `refine` adds more where the optimum switches.
struct ShapeProblem {
  double begin = 0;
  double end = 1;
  ShapeEnd from = {};
  ShapeEnd to = {};
  bool periodic = false;  ///< derivatives are equal at both ends
  int degree = 5;         ///< 2 to 7
  std::size_t pieces = 100;
  bool refine = false;
  std::vector<Segment> given =
      {};  ///< to start from and compare with; omitted: the smoothest polynomial
  std::vector<WeightedFigure> minimize = {};
  std::vector<Corridor> corridors = {};
  std::vector<Ceiling> ceilings = {};
  /// A figure that is not convex has 3 starts and 2000 evaluations unless stated.
  OptimizeOptions options = {};
};

/// Result of optimize_shape(): `best` is the shape, from `begin` on.
///
/// **Numbers.** A figure is exact (PeakOf, RmsOf), certified to 1e-6 (ResidualOf), or that of its
/// places (ResponseOf). `value` is the weighted sum. `bound` follows by weak duality, for convex
/// problems: no spline over these knots, of up to 1000 times the size of this one in every
/// derivative, has a lower weighted sum. (A spline k times beyond that size could be better by at
/// most k times the distance from the bound to `value`.)
///
/// **Limits.** Corridors and ceilings are checked on the result, independently and exactly; also
/// "fixed/..." and "joint/..." if it misses a fixed value at an end, or a joint.
using ShapeOutcome = Outcome<std::vector<Segment>>;

/// Throws InputError like require_valid(). keep_going is called between two rounds and, with the
/// same number, many times within one.
ShapeOutcome optimize_shape(const ShapeProblem& problem, const KeepGoing& keep_going = {});

void require_valid(const ShapeProblem& problem);

}  // namespace jounce
