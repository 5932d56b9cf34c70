// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <string>

#include "jounce/cam/laws/law.hpp"
#include "jounce/gear/sync_cam.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Component of the blade's velocity that equals the velocity of the web during the cut.
enum class KnifeMatching {
  surface,  ///< the speed on the cutting circle: the knife turns at constant speed (the usual cam)
  horizontal,  ///< the component along the web: angle = asin(x / R), so the tip does not slip
};

/// A rotary knife: a drum with blades that cuts a moving web into pieces of any length.
///
///     RotaryKnifeSpec spec{.diameter = 3, .cut_length = 4.71, .sync_angle = 10 * pi / 180};  // in
///     SyncCam knife = rotary_knife(spec);                  // one cut of 4.71 in; advances
///     RotaryKnifeFigures f = figures(spec);                // f.rho == 0.485454, f.longest == 19.9
///     Motion tip = Followed(knife.cam, web).at(t);         // knife over time
///     Report report = check(spec);                         // does it reverse? slip? touch early?
///
/// **Vocabulary.** The *synchronous length* C is the length of web that passes while the knife
/// turns from one blade to the next at the speed of the web. *Sync* is the interval around the cut
/// in which blade and web are in step: `sync_angle` of the knife, `sync_length` of the web.
/// *Recovery* is the rest of the cycle, in which the knife is faster than the web (cuts shorter
/// than C) or slower (longer cuts). If the cut is longer than *longest*, the knife has to reverse;
/// with `dwell` it stops instead.
///
/// **Frame.** The master is the position of the web, in its unit m, with a cut at 0 and after every
/// cut_length. The slave is the angle of the knife, in its unit u: at 0 a blade points straight
/// down, and each cut advances the knife by turn / blades (Extrapolation::advance). So half of the
/// sync zone lies at the cam's start and half at its end.
///
/// **The blade in the material.** Let h be the `thickness` of the web and R the radius of the
/// cutting circle. The blade enters the web at the *contact angle* alpha before its lowest point:
/// cos(alpha) = 1 - h / R. The sync angle must be at least 2 alpha, which is its default. Only the
/// tip of the blade moves with the web; the blade above the tip is slower. (If two drums meet in
/// the middle of the web, set half the thickness.)
///
/// Sources: rotary-cutter notes of Yaskawa and Delta (constant surface speed; contact angle); the
/// recovery follows Norton, Cam Design and Manufacturing Handbook, ch. 2, and VDI 2143. Derivation:
/// rotary_knife.cpp, docs/gear/rotary-knife.md.
struct RotaryKnifeSpec {
  double diameter = 0;                    ///< m, > 0: diameter of the cutting circle
  std::size_t blades = 1;                 ///< >= 1; evenly spaced
  double cut_length = 0;                  ///< m; above the sync length of the web
  std::optional<double> sync_angle = {};  ///< u, whole zone; give either sync_angle or sync_length
  /// m, whole zone. If both are omitted, the sync angle is twice the contact angle.
  std::optional<double> sync_length = {};
  /// u of one revolution: 360 for deg, pi * diameter for a length on the circle; default: rad.
  double turn = 2 * std::numbers::pi;
  KnifeMatching matching = KnifeMatching::surface;
  /// Blade speed divided by web speed in the sync zone; 1.005 pulls the cut open.
  double speed_ratio = 1;
  double thickness = 0;    ///< m, >= 0, < diameter / 2: thickness of the web
  Law law = Law::poly345;  ///< law of the recovery: a symmetric law from rest to rest
  LawForm form = {};       ///< straight and shares, for a law that takes them
  bool dwell = false;      ///< true: stop between cuts for which the knife would have to reverse
  /// permitted error of horizontal matching, as a share of the sync angle: 1e-14 to 1e-3
  double tolerance = 1e-12;
};

/// Key figures of a rotary knife. Angles in u, lengths in m.
struct RotaryKnifeFigures {
  /// C / speed_ratio: the cut length for which the cam of surface matching is a plain gear.
  double synchronous = 0;
  double contact_angle = 0;    ///< alpha; 0 for a web without thickness
  double sync_angle = 0;       ///< knife angle of the sync zone
  double sync_length = 0;      ///< web length of the sync zone
  double recovery_angle = 0;   ///< knife angle of the recovery
  double recovery_length = 0;  ///< web length of the recovery
  /// Slope at both ends of the recovery divided by its mean slope; 1: a straight line.
  double rho = 0;
  /// Speed in the middle of the recovery (its greatest or least) divided by the speed of the plain
  /// gear; 0 if the knife stops.
  double surface_ratio = 0;
  double longest = 0;  ///< cut length above which the knife reverses or needs a dwell (Lcrit)
  double dwell = 0;    ///< m of web that pass while the knife stands still; 0: the knife does not
                       ///< stop
  /// Greatest slip between blade and web in the sync zone, divided by the web speed.
  double speed_error = 0;
  /// u, certified: deviation from exact horizontal matching; 0 for surface matching.
  double strays = 0;
};

/// Returns the cam of one cut. Its segments are "sync", the segments of the recovery, and "sync";
/// its zones are the sync zones.
///
/// Surface matching is exact; at cut_length = synchronous (to 1e-12) the cam is one straight line.
/// With horizontal matching, the sync zone is a fit within `tolerance`, with a certified error. The
/// recovery begins with the slope and acceleration of the sync zone and, if the law begins without
/// jerk (4567, 56789, ...), with its jerk. The knife reverses if the cut is too long and `dwell` is
/// not set.
///
/// Throws InputError for a value out of range: two sync values; no sync value for a web without
/// thickness; a sync zone that leaves no recovery or (horizontal) reaches 90 deg; a law that is not
/// a symmetric rise from rest to rest.
SyncCam rotary_knife(const RotaryKnifeSpec& spec);

/// Returns the key figures. Throws like rotary_knife().
RotaryKnifeFigures figures(const RotaryKnifeSpec& spec);

/// Returns findings about the knife that do not depend on its limits. "knife/reversal": the least
/// velocity; broken if the knife reverses. "knife/contact", for a web with a thickness: the sync
/// angle; broken if it is less than two contact angles. "knife/slip", for surface matching: the
/// share by which the blade is slower than required where it enters the web; a warning above 1 %,
/// otherwise a note. Throws like rotary_knife().
Report check(const RotaryKnifeSpec& spec);

}  // namespace jounce
