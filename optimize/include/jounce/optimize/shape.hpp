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

/// A linear function of a shape f and its derivatives at a place x: q = by[0] f + by[1] f' + ... +
/// by[5] f^(5) + constant. For example, the torque of a load J a + B v + K s + F is {"torque", {K,
/// B w, J w^2}, F}, if the master turns at w.
struct LinearQuantity {
  std::string name = {};       ///< name for the user: "geo_acceleration", "torque"
  std::array<double, 6> by{};  ///< factors of f, f', ..., f^(5)
  double constant = 0;         ///< constant term
};

/// Returns a derivative of the shape as a quantity: "value" (order 0), "geo_velocity" (1),
/// "geo_acceleration" (2), "geo_jerk" (3), "geo_jounce" (4), "geo_crackle" (5).
LinearQuantity derivative_of_shape(int order);

// ---- figures that can be minimized or limited, over the whole shape ---------------------------

/// Peak max |q| over all x, not only at samples.
struct PeakOf {
  LinearQuantity quantity = {};
};

/// Rms value: root of (integral of q^2 / length). The rms value of the torque determines the heat
/// in a motor.
struct RmsOf {
  LinearQuantity quantity = {};
};

/// Residual vibration: the amplitude, u (unit of the shape), with which a vibration mode oscillates
/// after the end of the shape (Mode, jounce/profiles/vibration/vibration.hpp). The figure is the
/// worst value over a band of frequencies and damping ratios.
struct ResidualOf {
  double low = 0;           ///< lowest frequency, cycles per unit of x
  double high = 0;          ///< highest frequency; equal to low: one frequency
  double damping_low = 0;   ///< lowest damping ratio
  double damping_high = 0;  ///< highest damping ratio
};

/// Peak power max |force * velocity| over all x, not only at samples. Not convex.
struct PowerOf {
  LinearQuantity force = {};
  LinearQuantity velocity = {};
};

/// The torque of a load that the shape f moves, for a torque that is not a linear function of f:
///
///     (1)  T = linear + d/dx (J(x) f') + coulomb sign(f') + gravity sin(angle + turn f)
///
/// All terms have the unit of `linear`: T is in N m if coulomb and gravity are in N m. If the
/// master moves at w (unit of x)/s, J is the inertia in kg m^2 times w^2.
struct LoadTorque {
  std::string name = "torque";  ///< name for the user
  LinearQuantity linear = {};   ///< the linear terms J f'' + B f' + K f + F
  /// J(x) over the interval of the shape, in addition to the constant J of `linear`; no sines.
  std::vector<Segment> inertia = {};
  double coulomb = 0;  ///< dry friction, >= 0
  double gravity = 0;  ///< gravity of a lever: its weight times its length
  double turn = 0;     ///< angle of the lever per unit of the shape, rad/u
  double angle = 0;    ///< angle of the lever at f = 0, rad; at angle 0 it hangs down
};

/// Peak torque max |T| over all x, not only at samples. Where f' changes its sign, T counts on both
/// sides.
struct TorqueOf {
  LoadTorque load = {};
};

/// Rms torque: root of (integral of T^2 / length). It determines the heat in a motor.
struct RmsTorqueOf {
  LoadTorque load = {};
};

/// Energy: the integral over x of the input power T f' where it is positive, minus the share
/// `recovered` of the power where it is negative.
struct EnergyOf {
  LoadTorque load = {};
  double recovered = 0;  ///< 0 (braking resistor) to 1 (drive without losses)
};

/// The greatest |y| in a list of numbers y, such as the torque of a drive at every millisecond. The
/// list must be an affine function of the shape. The optimizer considers only the numbers in the
/// list, not the values between them. Throws InputError for a function that is not affine, a result
/// that is not finite, or a list of varying length.
struct ResponseOf {
  std::string name = {};  ///< name for the user
  /// Computes the list; its length must not vary.
  std::function<std::vector<double>(const Trajectory& shape)> of = {};
};

/// Rms value of a list y like the list of ResponseOf: root of the mean of y^2. Example: the rms
/// torque of a drive.
struct RmsResponseOf {
  std::string name = {};  ///< name for the user
  /// Computes the list; its length must not vary.
  std::function<std::vector<double>(const Trajectory& shape)> of = {};
};

/// Any figure. PowerOf, TorqueOf, RmsTorqueOf and EnergyOf are not convex, see
/// docs/optimize/physics.md.
using ShapeFigure = std::variant<PeakOf, RmsOf, ResidualOf, PowerOf, ResponseOf, TorqueOf,
                                 RmsTorqueOf, EnergyOf, RmsResponseOf>;

/// Returns the name of a figure: "peak geo_jerk", ...
std::string name(const ShapeFigure& figure);

// ---- the problem ------------------------------------------------------------------------------

/// Fixed values at one end of a shape. A value that is not given is free.
struct ShapeEnd {
  std::optional<double> value = {};         ///< u
  std::optional<double> velocity = {};      ///< u/x
  std::optional<double> acceleration = {};  ///< u/x^2
  std::optional<double> jerk = {};          ///< u/x^3
  std::optional<double> jounce = {};        ///< u/x^4
};

/// A bound that is linear in x, between two values.
struct Edge {
  double at_from = 0;  ///< bound at the start of the corridor
  double at_to = 0;    ///< bound at the end of the corridor
};

/// A quantity that must stay between two bounds, or on one side of a single bound, over a range of
/// x. Examples: a limit; a keep-out zone; a monotone interval (geo_velocity with lower 0); a point
/// to be passed within a tolerance (from == to); an interval in step (value with lower == upper,
/// which is satisfied exactly).
struct Corridor {
  LinearQuantity quantity = {};    ///< the quantity
  double from = 0;                 ///< start of the range, x
  double to = 0;                   ///< end of the range, x
  std::optional<Edge> lower = {};  ///< nullopt: no lower bound
  std::optional<Edge> upper = {};  ///< nullopt: no upper bound
};

/// A figure that must not exceed a value.
struct Ceiling {
  ShapeFigure figure = {};
  double at_most = 0;  ///< the greatest permitted value
};

/// A figure in a weighted sum.
struct WeightedFigure {
  ShapeFigure figure = {};
  /// The weight, > 0. The sum adds weight * (value of the figure) / (value of the
  /// figure for the given shape).
  double weight = 1;
};

/// A free function between two ends, and the objectives for its shape.
///
///     ShapeProblem problem;                                       // rest to rest, 0..1
///     problem.from = {.value = 0, .velocity = 0, .acceleration = 0};
///     problem.to = {.value = 1, .velocity = 0, .acceleration = 0};
///     problem.minimize = {{PeakOf{derivative_of_shape(3)}}};
///     ShapeOutcome best = optimize_shape(problem);                // peak jerk about 32 u/x^3
///
/// The shape is a spline: `pieces` polynomials of `degree`, with degree - 1 continuous derivatives
/// between them. Initially, their knots are equally spaced. u is the unit of the values of the
/// shape.
struct ShapeProblem {
  double begin = 0;          ///< start, x
  double end = 1;            ///< end, x
  ShapeEnd from = {};        ///< fixed values at the start
  ShapeEnd to = {};          ///< fixed values at the end
  bool periodic = false;     ///< true: all derivatives are equal at both ends
  int degree = 5;            ///< 2 to 7
  std::size_t pieces = 100;  ///< number of polynomials
  /// True: add knots where the highest derivative of the optimum jumps from one of its limits to
  /// the other.
  bool refine = false;
  /// Shape to start from and to compare with; empty: the smoothest polynomial.
  std::vector<Segment> given = {};
  std::vector<WeightedFigure> minimize = {};  ///< objective: the weighted sum of these figures
  std::vector<Corridor> corridors = {};       ///< constraints at each x
  std::vector<Ceiling> ceilings = {};         ///< constraints on figures
  /// Defaults for a figure that is not convex: 3 starts and 2000 evaluations.
  OptimizeOptions options = {};
};

/// Result of optimize_shape(). `best` is the shape, from `begin` on.
///
/// **Values.** Figures are exact (PeakOf, RmsOf), certified to 1e-6 (ResidualOf), or computed from
/// a list (ResponseOf). `value` is the weighted sum. For a convex problem, `bound` follows by weak
/// duality: no spline over these knots has a lower weighted sum, unless one of its derivatives
/// exceeds 1000 times the same derivative of the result. (A spline that exceeds this by a factor k
/// can be better by at most k times the difference between `bound` and `value`.)
///
/// **Limits.** Corridors and ceilings are checked on the result, independently and exactly.
/// `limits` also has findings "fixed/..." if the result differs from a fixed value at an end, and
/// "joint/..." if a break between pieces is not smooth.
using ShapeOutcome = Outcome<std::vector<Segment>>;

/// Optimizes a shape. keep_going is called between two rounds, and many times within a round.
/// Throws InputError like require_valid().
ShapeOutcome optimize_shape(const ShapeProblem& problem, const KeepGoing& keep_going = {});

/// Throws InputError unless the problem is complete and consistent.
void require_valid(const ShapeProblem& problem);

}  // namespace jounce
