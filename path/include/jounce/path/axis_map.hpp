// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "jounce/path/point.hpp"
#include "jounce/profiles/curve/segment.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Outcome of a map at a point.
enum class MapState : std::uint8_t {
  ok,
  out_of_reach,  ///< no position of the joints puts the tool there
  singular,      ///< the velocities of the joints are not determined there
};

/// Joints that are linear in the axes: joint = matrix * point + offset. A row for each joint.
struct LinearMap {
  std::vector<Point> rows;
  std::vector<double> offset;  ///< one a joint; empty: 0
};

/// Proven bounds for one joint over a part of a path, by s in [0, 1] over the part.
struct JointBounds {
  double first = 0;   ///< |d joint / ds|
  double eighth = 0;  ///< |8th derivative| / 8!: bounds the error of the polynomial of degree 7
};

/// Inverse kinematics: from the position of the tool to the joints.
///
/// A map of your own needs `jets` only. A plan then samples how far its fitted joints are from the map, and states so
/// (Plan::Given::fit). With `bounds` the plan has a proven bound instead.
class AxisMap {
 public:
  /// `axes`: the first axes of a program that the map reads. Throws InputError "joints" for more axes or joints than
  /// max_axes.
  AxisMap(std::size_t axes, std::size_t joints);
  virtual ~AxisMap();

  [[nodiscard]] std::size_t axes() const { return axes_; }
  [[nodiscard]] std::size_t joints() const { return joints_; }

  /// Joints and their three derivatives from a point and its three derivatives, by any one parameter. An angle may
  /// jump by whole turns between two calls: plans join them.
  virtual MapState jets(std::span<const Jet> point, std::span<Jet> joints) const = 0;

  /// Period of a joint in its unit (360 for an angle in deg); 0: none.
  [[nodiscard]] virtual double turn(std::size_t joint) const;

  /// Bounds over a part of a path: one segment an axis, all over s in [0, 1]. False if nothing is proven, as in the
  /// base class. A part that is too long for a finite bound gets an infinite one: the plan divides it.
  virtual bool bounds(std::span<const Segment> point, std::span<JointBounds> joints) const;

  /// The matrix of a linear map: such a map is exact on every piece.
  [[nodiscard]] virtual const LinearMap* linear() const;

 protected:
  AxisMap(const AxisMap&) = default;
  AxisMap& operator=(const AxisMap&) = default;

 private:
  std::size_t axes_, joints_;
};

/// A linear map of the first `axes` axes. Throws InputError "joints" for no row or more than max_axes, and for
/// numbers that are not finite.
std::shared_ptr<const AxisMap> linear_map(std::size_t axes, LinearMap map);

/// Every axis is a joint.
std::shared_ptr<const AxisMap> identity_map(std::size_t axes);

/// A gantry: joint k follows the axis `axis_of[k]`, counted from 0. Two joints may follow one axis: a beam on two
/// motors.
std::shared_ptr<const AxisMap> gantry_map(std::size_t axes, std::span<const std::size_t> axis_of);

/// CoreXY: two fixed motors and one belt. Joints x + y and x - y; further axes (Z) are joints of their own.
std::shared_ptr<const AxisMap> core_xy_map(std::size_t axes);

/// Side of the straight line from the base to the wrist on which the elbow is, seen from the base.
enum class Elbow : std::uint8_t {
  right,  ///< the second joint is positive
  left,   ///< the second joint is negative
};

/// A SCARA robot with two or three arms (PMC600 manual 7.2.5, SCARA 2-joint and 3-joint). The first joint is at the
/// origin; at 0 its arm points along X, at 90 deg along Y; each arm carries the next. Joints are in deg, Z in its
/// unit.
///
/// Axes of the tool: X, Y; Z if `with_z`; with three arms also C, the direction of the last arm in deg.
/// Joints: one an arm, then Z.
struct ScaraSpec {
  std::vector<double> arms;          ///< two or three lengths, > 0
  Elbow elbow = Elbow::right;        ///< dElbowRight
  std::vector<double> offsets = {};  ///< deg: reading of each joint at the angle 0; empty: 0
  bool with_z = false;
  double offset_z = 0;  ///< reading of the joint Z at Z = 0
};
/// Out of reach beyond the sum of both arms and within their difference. Singular with stretched or folded arms,
/// and at the origin. Throws InputError "arms", "offsets".
std::shared_ptr<const AxisMap> scara_map(const ScaraSpec& spec);

/// A delta robot with three carriages on straight rails (PMC600 manual 7.2.5, linear delta). The rails are at 0,
/// 120 and 240 deg about Z from `first_rail`, counterclockwise from above; carriage i is at
///
///     outer_radius e_i + (distance + joint cos a) Z - joint sin a e_i,    a: rail_angle, e_i: outwards
///
/// so a joint counts upwards along its rail, from the height `distance`. Arms of the given length join the
/// carriages, which are above the tool, to a platform, which keeps its orientation; its joints are `inner_radius`
/// from the tool. Axes X, Y, Z; joints in the same unit.
struct LinearDeltaSpec {
  double outer_radius = 0;  ///< dOuterRadius, >= 0
  double inner_radius = 0;  ///< dInnerRadius, >= 0
  double arm = 0;           ///< dLength, > 0
  double distance = 0;      ///< dDistance: height of the carriages at joint 0
  double rail_angle = 0;    ///< dAxisAngle: deg from Z to the rail, inwards; within (-90, 90)
  double first_rail = 0;    ///< deg from X to the first rail
};
/// Out of reach where an arm is shorter than the distance from its rail; singular where it is perpendicular to the
/// rail. Throws InputError with the name of the parameter.
std::shared_ptr<const AxisMap> linear_delta_map(const LinearDeltaSpec& spec);

/// Joints of a plan: its map, and their limits, one a joint.
struct JointSpace {
  std::shared_ptr<const AxisMap> map;
  std::vector<Limits> limits;
  double tolerance =
      1e-9;  ///< greatest distance of the fitted joints from the map, in their unit, > 0
};

/// Distance of the fitted joints of a plan from its map.
struct MapFit {
  double error = 0;        ///< unit of the joints; 0: a linear map
  bool proven = false;     ///< by an enclosure of the map over each piece; otherwise sampled
  double sample_step = 0;  ///< greatest step of the samples, in q, if it is not proven
  std::size_t pieces = 0;  ///< polynomials of degree 7
};

}  // namespace jounce
