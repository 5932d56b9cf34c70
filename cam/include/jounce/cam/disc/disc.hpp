// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <optional>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// The follower of a plate cam: a roller on a slide, or at the end of a swinging arm. A roller of
/// radius 0 is a knife edge.
enum class Follower {
  translating,  ///< on a line beside the cam's center, at the distance `offset`
  /// On an arm of `arm_length` whose pivot is `center_distance` from the cam's center.
  oscillating,
};

/// Direction in which the cam turns as the master advances.
enum class Rotation { counterclockwise, clockwise };

/// The geometry of a plate cam. Lengths are in the unit u of the slave.
///
///     Cam cam = design(spec).cam;                   // 360 deg of master, mm of lift
///     Disc disc(cam, {.base_radius = 30, .roller_radius = 8});
///     DiscPoint now = disc.at(90);                  // roller center, contact, pressure angle
///     DiscExtremes worst = extremes(disc);          // exact, with where
///     Report report = check(disc, {.pressure_angle = 0.52});
///     Contour profile = contour(disc, -8, 0.001);   // see disc_contour.hpp
///
/// **Vocabulary.** The *base circle* is the smallest circle of the profile around the cam's center;
/// on it, the slave is at its least position. *Lift* is the slave's position above its least
/// position. The *pitch curve* is the path of the roller's center in the frame of the cam. The
/// *profile* is the curve that the roller touches: it is parallel to the pitch curve, at the
/// distance of the roller's radius. The *pressure angle* is the angle between the normal of the
/// profile, along which the cam pushes, and the direction in which the roller center moves.
///
/// **Frame.** The origin is the cam's center, and the frame shows the cam at master position 0. A
/// translating follower then moves along +y at x = offset. A positive offset lowers the pressure
/// angle of the rise if the cam turns counterclockwise, and raises it if the cam turns clockwise.
/// The pivot of an arm is at (center_distance, 0), with the roller on the +y side; lift turns the
/// arm clockwise, away from the cam.
struct DiscSpec {
  Follower follower = Follower::translating;  ///< kind of follower
  double base_radius = 0;                     ///< u, > 0: radius of the base circle
  double roller_radius = 0;                   ///< u, >= 0
  double offset = 0;                          ///< u, any sign; for a translating follower
  double arm_length = 0;                      ///< u, > 0; for an oscillating follower
  double center_distance = 0;                 ///< u, > 0; for an oscillating follower
  Rotation rotation = Rotation::counterclockwise;
  /// rad of the cam per master unit; the default applies to a master in deg.
  double angle = std::numbers::pi / 180;
  /// rad of the arm per slave unit, for a slave that is the angle of the arm. If omitted, the slave
  /// is the travel of the roller's center along its arc, and the factor is 1 / arm_length.
  std::optional<double> arm_angle = {};
};

/// A point in the plane of the cam, u.
struct Place {
  double x = 0;
  double y = 0;
};

/// The geometry at one position of the master; positions and directions in the frame of the cam.
struct DiscPoint {
  Place center = {};   ///< center of the roller, on the pitch curve
  Place contact = {};  ///< contact point on the profile
  Place normal = {};   ///< unit normal of pitch curve and profile, outwards
  /// rad; positive if the side force on the follower has the direction of the cam's rotation, as on
  /// the rise. The follower jams beyond pi/2.
  double pressure_angle = 0;
  double pitch_curvature = 0;  ///< 1/u; positive where the pitch curve is convex
};

/// A plate cam and its follower: an immutable value.
///
/// The length of the cam must be one turn, or one turn divided by an integer up to 1000 (the number
/// of lobes). The cam must end at its start position, and its position must not step. The disc is
/// periodic, for any policy of the cam outside its interval.
///
/// **Throws** InputError if a length, `angle` or `arm_angle` is not finite or has the wrong sign;
/// if the cam is not as described above ("cam"); if the magnitude of the offset is not less than
/// base radius plus roller radius; and if the arm does not reach the base circle, or swings to 180
/// deg from the line between the centers of cam and arm ("arm_length").
class Disc {
 public:
  Disc(const Cam& cam, const DiscSpec& spec);

  /// The lift over one whole turn: least value 0, wraps.
  [[nodiscard]] const Cam& lift() const { return lift_; }
  [[nodiscard]] const DiscSpec& spec() const { return spec_; }

  /// Position of the roller at lift 0. For a translating follower: height above the cam's center,
  /// u. For an oscillating follower: angle between the arm and the line from the pivot to the cam's
  /// center, rad.
  [[nodiscard]] double start() const { return start_; }

  /// Returns the geometry at any master position. Where the velocity steps, each side gives its own
  /// point.
  [[nodiscard]] DiscPoint at(double master, Side side = Side::right) const;

 private:
  DiscSpec spec_;
  Cam lift_;
  double start_ = 0;
};

/// The exact ranges over one turn. Nothing is sampled: the search discards an interval only if an
/// enclosure (interval arithmetic, second order) excludes a greater value. It brackets a peak only
/// if the enclosure of the second derivative excludes zero.
struct DiscExtremes {
  Range pressure_angle = {};   ///< rad: the maximum occurs on the rise, the minimum on the return
  Range pitch_curvature = {};  ///< 1/u: max is the most convex, min the most concave
  /// Bound of the error of the extrema, as a share of the peak; at most 1e-12 unless the cam is
  /// degenerate.
  double error = 0;
};
/// Returns the extremes of pressure angle and curvature over one turn.
DiscExtremes extremes(const Disc& disc);

/// An overlap of the profile with itself: a circle that touches the profile at one place covers the
/// profile at another place.
struct Interference {
  double circle = 0;   ///< master position at which the circle touches
  double covered = 0;  ///< master position of the covered point
  double depth = 0;    ///< u, depth of the covered point inside the circle
};

/// Searches for an overlap: a circle of the given radius rolls around the outside of the profile
/// and cuts into a distant part of it. The circle is the roller (roller_radius) or a larger cutter.
/// Returns the deepest overlap, with its depth to 1e-3 of the radius, or nullopt if the profile has
/// no overlap; enclosures over all pairs of intervals prove the result. A clearance below 1e-5 of
/// the radius counts as an overlap of depth 0. Throws InputError for a radius that is negative or
/// not finite. Undercuts and narrow hollows (within a quarter turn of the tangent) follow from the
/// curvature; this function does not detect them.
std::optional<Interference> interference(const Disc& disc, double radius);

/// Limits of the disc; an omitted limit does not apply. The radius of the profile must always be >
/// 0.
struct DiscLimits {
  std::optional<double> pressure_angle = {};  ///< rad, in (0, pi/2); for rise and return
  /// u, >= 0, least radius of curvature of convex parts.
  std::optional<double> profile_radius = {};
  /// u, >= 0, radius of the cutter, which must fit into every hollow.
  std::optional<double> cutter_radius = {};
};

/// Checks pressure angle (in deg), undercut, interference, cutter and corners against the limits;
/// `where` is a master position. If a larger base radius would suffice, the advice names the
/// smallest one. Throws InputError for a limit out of range. Findings:
/// - "disc/profile_radius": always;
/// - "disc/pressure_angle", "disc/cutter_radius": if the limit is given; for the cutter, only if
///   the profile has a hollow;
/// - "disc/corner": for each step of the velocity;
/// - "disc/interference": for an overlap of the roller or of the cutter. The function searches
///   for an overlap only if no other rule is broken.
Report check(const Disc& disc, const DiscLimits& limits);

/// Returns the least base radius with which the cam satisfies the limits of pressure angle and
/// profile radius; nullopt if no radius does, or if the cam cannot be a disc. spec.base_radius is
/// ignored. Throws InputError for a limit out of range. The extrema at the result are exact. A
/// radius that is smaller than the result by 1e-9 of it breaks one of the limits.
///
/// The search increases the radius in steps and returns the first result. For a translating
/// follower, it begins at 1e-3 of the sum of roller radius, offset and stroke, and never returns
/// less. A step is 2 % (translating), or 1/400 of the reach of the arm (oscillating). The search
/// can therefore miss a narrow range of smaller radii.
std::optional<double> least_base_radius(const Cam& cam, const DiscSpec& spec,
                                        const DiscLimits& limits);

}  // namespace jounce
