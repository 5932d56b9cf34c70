// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A knot: the point at which two segments of a cam meet, or one end of the cam. Derivatives are
/// with respect to the master's position. The adjacent laws determine an omitted derivative; if
/// they leave it free, it is zero, or chosen as in boundaries.hpp. u is the slave's unit, m the
/// master's.
struct CamKnot {
  double master = 0;                            ///< m, master position
  double slave = 0;                             ///< u, slave position
  std::optional<double> geo_velocity = {};      ///< u/m
  std::optional<double> geo_acceleration = {};  ///< u/m^2
  /// u/m^3; permitted only beside a law with a given jerk (takes_jerk()); omitted: 0 for such a
  /// law.
  std::optional<double> geo_jerk = {};
};

/// A condition at a point inside a segment, for laws through points. Splines accept positions only.
/// The law `hermite` accepts slave, geo_velocity and geo_acceleration at each point, and geo_jerk
/// at all points or at none. A point at an end of the segment supplies the derivatives that the
/// knot omits, and geo_jerk.
struct CamPoint {
  double master = 0;                            ///< m, master position
  std::optional<double> slave = {};             ///< u, slave position
  std::optional<double> geo_velocity = {};      ///< u/m
  std::optional<double> geo_acceleration = {};  ///< u/m^2
  std::optional<double> geo_jerk = {};          ///< u/m^3; also at the ends of the segment
  double tolerance = 0;  ///< u, >= 0: permitted deviation of the slave; for quintic_spline only
};

/// The curve of the law `b_spline`, whose degree is values.size() - knots.size() - 1, from 1 to 11.
/// Without inner knots, it is a Bezier curve.
struct ControlShape {
  /// u, control values; the first and the last are the slave positions of the segment's ends.
  std::vector<double> values = {};
  /// m, inner knots, ascending. A knot that occurs k times has k - 1 fewer continuous derivatives.
  std::vector<double> knots = {};
};

/// One segment: its law and the knot at its end. It begins at the end of the previous segment.
struct CamSegment {
  Law law = Law::quintic;
  CamKnot end = {};
  std::string name = {};  ///< name in reports; may be empty
  LawForm form = {};      ///< shape parameters of the law
  /// Points, for polynomial, cubic_spline, quintic_spline and hermite; masters ascend.
  std::vector<CamPoint> points = {};
  ControlShape control = {};  ///< for b_spline
};

/// A cam as an engineer specifies it: a start knot and a list of segments.
struct CamSpec {
  CamKnot start = {};
  std::vector<CamSegment> segments = {};
  /// True: periodic, with the last knot equal to the first. False: the cam holds its end values.
  bool periodic = false;
  /// Period of a rotary slave, u, for a periodic cam. The cam then ends a whole number of turns
  /// from its start and continues from there (Extrapolation::advance).
  std::optional<double> slave_period = {};
  /// True: two adjoining lines may have different velocities, for a controller that joins positions
  /// by straight lines. check_continuity() (limits/limits.hpp) reports the step.
  bool velocity_steps = false;
};

/// A cam made from a spec.
struct CamDesign {
  Cam cam;
  /// For each segment of the cam: index of its segment in the spec (a law may need several).
  std::vector<std::size_t> origin = {};
};

/// Returns all knots of the spec, start included, with every derivative filled in. Each value comes
/// from the first of these sources that gives one:
/// - the knot;
/// - an adjacent line, dwell or law from rest, which requires the value;
/// - an adjacent law that determines the value (the reversal of a sine, the end of a spline), if
///   the neighbor accepts it;
/// - zero.
///
/// The first and the last knot of a periodic cam are the same knot. A law between different states
/// (R-U: rest to reversal) has its rest at the end whose acceleration is zero. If the law accepts
/// an inflection, and the knot of its reversal gives an acceleration, the acceleration determines
/// the inflection. A law from a constant velocity to a reversal (G-U) has its reversal at the end
/// whose velocity is zero.
///
/// Throws InputError if
/// - there is no segment, a number is not finite, a position is above 1e100 in magnitude, or master
///   positions do not ascend;
/// - a derivative contradicts an adjacent law (by more than 1e-9 of the slope), or the two ends
///   of a dwell have different positions;
/// - a knot gives a jerk, but no adjacent law has a given jerk;
/// - a law does not accept its form or its points, a point is outside its segment, or a reversal
///   meets a rest;
/// - no inflection gives the requested acceleration;
/// - slave_period is given for a cam that is not periodic, or the slave does not end on a whole
///   turn.
std::vector<CamKnot> resolved_knots(const CamSpec& spec);

/// Makes the exact cam. Throws like resolved_knots(), and for points from which the law makes no
/// curve (spline.hpp, hermite.hpp, polynomial.hpp).
CamDesign design(const CamSpec& spec);

/// Returns the pieces of each segment of the spec, which are linear in the values at its knots
/// (law.hpp). Exception: the values may also determine the orientation or the inflection of a law.
/// Throws like resolved_knots(), and for a law through points.
std::vector<std::vector<LawPiece>> shapes(const CamSpec& spec);

/// Returns the transition of a segment of the spec (counted from 0) in the notation of VDI 2143:
/// "R-G", "U-R", ... The letters follow from the values of the cam, to 1e-9 of their peaks in the
/// segment: R velocity and acceleration 0, G velocity without acceleration, U acceleration without
/// velocity, B velocity and acceleration.
std::string transition(const CamDesign& made, std::size_t segment);

}  // namespace jounce
