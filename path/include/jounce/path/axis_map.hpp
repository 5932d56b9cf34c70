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

/// Result of AxisMap::jets() at a point.
enum class MapState : std::uint8_t {
  ok,
  out_of_reach,  ///< no position of the joints moves the tool to this point
  singular,      ///< the velocities of the joints are not determined at this point
};

/// A linear map from the axes to the joints: joint = matrix * point + offset.
struct LinearMap {
  std::vector<Point> rows = {};     ///< rows of the matrix, one for each joint
  std::vector<double> offset = {};  ///< offset of each joint, in its unit; empty: 0
};

/// Proven bounds for one joint over a part of a path; s in [0, 1] is the position in this part.
struct JointBounds {
  double first = 0;  ///< bound of |d joint / ds|
  /// Bound of |8th derivative| / 8!, which bounds the error of a polynomial of degree 7.
  double eighth = 0;
};

/// Inverse kinematics: from the position of the tool, given by the axes of the program, to the
/// positions of the machine's joints.
///
/// A derived class must implement only jets(). A plan then samples how far its fitted joints are
/// from the map (Plan::Given::fit). If the class also implements bounds(), the plan proves a bound
/// of this distance instead.
class AxisMap {
 public:
  /// `axes` is the number of axes that the map uses, from the first one; `joints` is the number of
  /// joints. Throws InputError "joints" if either number exceeds max_axes.
  AxisMap(std::size_t axes, std::size_t joints);
  virtual ~AxisMap();

  [[nodiscard]] std::size_t axes() const { return axes_; }
  [[nodiscard]] std::size_t joints() const { return joints_; }

  /// Computes the joints and their three derivatives from a point and its three derivatives. The
  /// derivatives are with respect to one common parameter. An angle may jump by whole turns
  /// between two calls; plans remove such jumps. A plan rejects a joint that is not finite although
  /// the result is MapState::ok.
  virtual MapState jets(std::span<const Jet> point, std::span<Jet> joints) const = 0;

  /// Period of a joint, in its unit (360 for an angle in deg); 0: not periodic.
  [[nodiscard]] virtual double turn(std::size_t joint) const;

  /// Computes bounds over a part of a path. `point` has one segment for each axis, all over s in
  /// [0, 1]. Returns false if the class has no proof, as the base class does. If the part is too
  /// long for a finite bound, the bound is infinite, and the plan divides the part.
  virtual bool bounds(std::span<const Segment> point, std::span<JointBounds> joints) const;

  /// Computes the position of the tool from the positions of the joints: the forward kinematics.
  /// Returns nullopt if jets() gives other joints for this position (another side of the elbow, two
  /// motors of one axis at different positions), or if the class has no forward kinematics, like
  /// the base class.
  [[nodiscard]] virtual std::optional<Point> tool(std::span<const double> joints) const;

  /// Returns the matrix of a linear map; null for any other map. With a linear map, a plan is exact
  /// on every piece.
  [[nodiscard]] virtual const LinearMap* linear() const;

  /// True if jets() gives these joints at this position of the tool, within rounding and whole
  /// turns.
  [[nodiscard]] bool gives(const Point& tool, std::span<const double> joints) const;

 protected:
  AxisMap(const AxisMap&) = default;
  AxisMap& operator=(const AxisMap&) = default;

 private:
  std::size_t axes_, joints_;
};

/// Returns a linear map of the first `axes` axes. Throws InputError "joints" if there is no row or
/// more than max_axes, and if a number is not finite.
std::shared_ptr<const AxisMap> linear_map(std::size_t axes, LinearMap map);

/// Returns the map in which every axis is a joint.
std::shared_ptr<const AxisMap> identity_map(std::size_t axes);

/// Returns the map of a gantry: joint k follows the axis axis_of[k]. Joints and axes count from 0.
/// Two joints may follow the same axis, as for a beam with two motors.
std::shared_ptr<const AxisMap> gantry_map(std::size_t axes, std::span<const std::size_t> axis_of);

/// Returns the map of CoreXY, a machine with two fixed motors and one belt. The first two joints
/// are x + y and x - y; every further axis (Z) is a joint.
std::shared_ptr<const AxisMap> core_xy_map(std::size_t axes);

/// Side of the elbow: the side of the straight line from the base to the wrist on which the elbow
/// is, seen from the base.
enum class Elbow : std::uint8_t {
  right,  ///< the second joint is positive
  left,   ///< the second joint is negative
};

/// A SCARA robot with two or three arms (PMC600 manual 7.2.5, SCARA 2-joint and 3-joint). The first
/// joint is at the origin. The arm of the first joint points along X at 0 deg and along Y at 90
/// deg. Each arm carries the next joint. Angles of the joints are in deg; the joint Z has the unit
/// of the axis Z.
///
/// Axes of the tool: X, Y; Z if `with_z`; with three arms also C, the direction of the last arm in
/// deg. Joints: one for each arm, then Z.
struct ScaraSpec {
  std::vector<double> arms = {};     ///< lengths of two or three arms, > 0
  Elbow elbow = Elbow::right;        ///< dElbowRight
  std::vector<double> offsets = {};  ///< deg, value of each joint when its arm is at the angle 0;
                                     ///< empty: 0
  bool with_z = false;               ///< true: the robot has a vertical axis Z
  double offset_z = 0;               ///< value of the joint Z at Z = 0
};
/// Returns the map of the robot. A point is out of reach if the end of the second arm would be
/// farther from the origin than the sum of the lengths of the first two arms, or nearer than their
/// difference. The map is singular if the arms are stretched or folded, and at the origin. Throws
/// InputError "arms" or "offsets" for a wrong number of entries or a value out of range.
std::shared_ptr<const AxisMap> scara_map(const ScaraSpec& spec);

/// A delta robot with three carriages on straight rails (PMC600 manual 7.2.5, linear delta). The
/// rails are at 0, 120 and 240 deg around Z from `first_rail`, counterclockwise from above.
/// Carriage i is at
///
///     outer_radius e_i + (distance + joint cos a) Z - joint sin a e_i,    a: rail_angle, e_i: outwards
///
/// So the position of a joint is the distance along its rail, upwards from the height `distance`.
/// The carriages are above the tool. Arms of equal length connect them to a platform, whose
/// orientation is constant. The arms end on the platform at the distance `inner_radius` from the
/// tool. The axes are X, Y, Z; they and the joints have the same unit, u.
struct LinearDeltaSpec {
  double outer_radius = 0;  ///< u, >= 0 (dOuterRadius)
  double inner_radius = 0;  ///< u, >= 0 (dInnerRadius)
  double arm = 0;           ///< u, > 0: length of the arms (dLength)
  double distance = 0;      ///< u, height of the carriages at joint position 0 (dDistance)
  double rail_angle = 0;    ///< deg, from Z to the rail, inwards; within (-90, 90) (dAxisAngle)
  double first_rail = 0;    ///< deg from X to the first rail
};
/// Returns the map of the robot. A point is out of reach if the distance from the platform end of
/// an arm to the rail exceeds the length of the arm. The map is singular if an arm is perpendicular
/// to its rail. Throws InputError with the name of the parameter.
std::shared_ptr<const AxisMap> linear_delta_map(const LinearDeltaSpec& spec);

/// Joints of a plan.
struct JointSpace {
  std::shared_ptr<const AxisMap> map = {};  ///< from the axes of the program to the joints
  std::vector<Limits> limits = {};          ///< limits of the joints, one for each joint
  /// Greatest distance of the fitted joints from the map, in their unit, > 0.
  double tolerance = 1e-9;
};

/// Distance between the fitted joints of a plan and its map.
struct MapFit {
  double error = 0;  ///< unit of the joints; 0 for a linear map
  /// True: the error is a bound, from an enclosure of the map over each piece. False: it is the
  /// greatest error at samples.
  bool proven = false;
  double sample_step = 0;  ///< greatest distance between samples, in q, if the error is not proven
  std::size_t pieces = 0;  ///< number of polynomials (degree 7)
};

}  // namespace jounce
