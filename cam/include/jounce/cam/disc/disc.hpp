// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <optional>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// The follower of the plate cam: a roller (radius 0: a knife edge) on a slide, or at the end of
/// a swinging arm.
enum class Follower {
  translating,  ///< along a line `offset` beside the cam's center
  oscillating,  ///< on an arm of `arm_length`, with its pivot `centre_distance` from the center
};

/// Direction of the cam as the master advances.
enum class Rotation { counterclockwise, clockwise };

/// A plate cam's geometry; lengths in the unit u of the slave.
///
///     Cam cam = design(spec).cam;                   // 360 deg of master, mm of lift
///     Disc disc(cam, {.base_radius = 30, .roller_radius = 8});
///     DiscPoint now = disc.at(90);                  // roller center, contact, pressure angle
///     DiscExtremes worst = extremes(disc);          // exact, with where
///     Report report = check(disc, {.pressure_angle = 0.52});
///     Contour profile = contour(disc, -8, 0.001);   // see disc_contour.hpp
///
/// **Vocabulary.** The *base circle* is the smallest circle of the profile about the cam's center,
/// at the least position of the slave; *lift* is the slave's position above that. The *pitch curve*
/// is the path of the roller's center in the frame of the cam; the *profile*, which the roller
/// touches, is parallel to it at the roller's radius. *Pressure angle*: between the normal of the
/// profile, along which the cam pushes, and the direction in which the roller center can move.
///
/// **Frame.** The cam's center is the origin, and the cam is drawn at master 0. The translating
/// follower then moves along +y at x = offset: a positive offset lowers the pressure angle of the
/// rise if the cam turns counterclockwise, and raises it if clockwise. The arm's pivot is at
/// (centre_distance, 0), the roller on the +y side of it; lift turns the arm clockwise, away from
/// the cam.
struct DiscSpec {
  Follower follower = Follower::translating;
  double base_radius = 0;      ///< u, > 0
  double roller_radius = 0;    ///< u, >= 0
  double offset = 0;           ///< u; translating
  double arm_length = 0;       ///< u, > 0; oscillating
  double centre_distance = 0;  ///< u, > 0; oscillating
  Rotation rotation = Rotation::counterclockwise;
  double angle = std::numbers::pi / 180;  ///< rad per master unit: that of a master in deg
  /// rad of the arm per slave unit, for a slave that is an angle; omitted: the slave is the travel
  /// of the roller's center along its arc, 1 / arm_length.
  std::optional<double> arm_angle = {};
};

/// A place in the plane of the cam, u.
struct Place {
  double x = 0;
  double y = 0;
};

/// The cam at one position of the master; positions and directions in the frame of the cam.
struct DiscPoint {
  Place centre;                ///< center of the roller: a point of the pitch curve
  Place contact;               ///< a point of the profile
  Place normal;                ///< normal of both, outwards, of length 1
  double pressure_angle = 0;   ///< rad; > 0 if the side force on the follower is in the direction
                               ///< of the cam's rotation, as on the rise; beyond pi/2 it jams
  double pitch_curvature = 0;  ///< 1/u, > 0 where convex
};

/// A plate cam with its follower: an immutable value.
///
/// The cam must close: its length is a turn, or a turn divided by an integer (the number of lobes),
/// and it ends at its start position. Its extrapolation is ignored: it wraps.
///
/// **Throws** InputError for lengths that are not finite or have the wrong sign, a cam that does
/// not close, an offset that is not less than base + roller radius, and an arm that does not reach
/// the base circle or swings through the line of centers ("arm_length").
class Disc {
 public:
  Disc(const Cam& cam, const DiscSpec& spec);

  /// Over one whole turn, least value 0, wraps.
  [[nodiscard]] const Cam& lift() const { return lift_; }
  [[nodiscard]] const DiscSpec& spec() const { return spec_; }

  /// Position of the roller at lift 0: for a translating follower, the height over the cam's center
  /// (u); for an oscillating one, the angle between the arm and the line of centers (rad).
  [[nodiscard]] double start() const { return start_; }

  /// The point at any master position. At a step of the velocity there are two points, one for each
  /// side.
  [[nodiscard]] DiscPoint at(double master, Side side = Side::right) const;

 private:
  DiscSpec spec_;
  Cam lift_;
  double start_ = 0;
};

/// The ranges over the turn. Nothing is sampled: the search drops an interval only if an enclosure
/// (interval arithmetic, second order) shows that it contains no greater value, and brackets a peak
/// only if the second derivative's enclosure excludes zero. `error`: upper bound of the excess of
/// the true extrema, as a share of the peak; 1e-12 or less unless the cam is degenerate.
struct DiscExtremes {
  Range pressure_angle;   ///< rad: of the rise (max) and the return (min)
  Range pitch_curvature;  ///< 1/u: most convex (max) and most concave (min)
  double error = 0;
};
DiscExtremes extremes(const Disc& disc);

/// An overlap of the profile with itself: the circle of radius `radius` that touches it at master
/// position `circle` covers its point at master position `covered` by `depth` u.
struct Interference {
  double circle = 0;
  double covered = 0;
  double depth = 0;
};

/// Returns the deepest overlap, its depth to 1e-3 of the radius, if a circle rolled around the
/// outside of the profile (radius roller_radius: the roller; a larger one: a cutter) cuts into a
/// distant part of it; nullopt otherwise. Proven by enclosures over all pairs of intervals.
/// Undercuts and narrow hollows (within a quarter turn of the tangent) depend on the curvature
/// alone; this function does not look for them. A clearance below 1e-5 of the radius counts as none.
std::optional<Interference> interference(const Disc& disc, double radius);

/// Limits of the disc; an omitted value is not limited. A profile must always have a radius > 0.
struct DiscLimits {
  std::optional<double> pressure_angle = {};  ///< rad, in (0, pi/2), of rise and return
  std::optional<double> profile_radius = {};  ///< u, least radius of curvature where convex
  std::optional<double> cutter_radius = {};   ///< u: this tool must fit into every hollow
};

/// Pressure angle (in deg), undercut, interference, cutter and corners against the limits, with
/// `where` in master units. Advice names the smallest sufficient base radius, if there is one.
/// Rules: "disc/pressure_angle", "disc/profile_radius", "disc/interference", "disc/cutter_radius",
/// "disc/corner". Throws InputError for a limit out of its range.
Report check(const Disc& disc, const DiscLimits& limits);

/// Returns the least base radius with which the cam keeps the limits on pressure angle and profile
/// radius, with the rest of `spec` unchanged (its base_radius is ignored); nullopt if there is
/// none. The result keeps both limits (exact extrema); a base radius smaller by 1e-9 of it breaks
/// one of them.
/// The search goes up in steps of 2 % (translating) or 1/400 of the reach of the arm (oscillating)
/// and returns the first result: it misses a narrower window further down.
std::optional<double> least_base_radius(const Cam& cam, const DiscSpec& spec,
                                        const DiscLimits& limits);

}  // namespace jounce
