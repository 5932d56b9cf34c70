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

/// Velocity of the blade that matches the web during the cut.
enum class KnifeMatching {
  surface,     ///< its speed on the cutting circle: the knife turns evenly (the usual cam)
  horizontal,  ///< its speed along the web: angle = asin(x / R), the tip does not slip at all
};

/// A rotary knife: a drum with blades cuts a web that runs beneath it, at any length.
///
///     RotaryKnifeSpec spec{.diameter = 3, .cut_length = 4.71, .sync_angle = 10 * pi / 180};   // in
///     SyncCam knife = rotary_knife(spec);                  // one cut, 4.71 in of web; advances
///     RotaryKnifeFigures f = figures(spec);                // f.rho == 0.485454, f.longest == 19.9
///     Motion tip = Followed(knife.cam, web).at(t);         // knife over time
///     Report report = check(spec, knife.cam);              // does it reverse? slip? touch early?
///
/// **Vocabulary.** The *synchronous length* C is the web that passes in one blade's share of a turn
/// at equal speeds. *Sync*: the interval about the cut in which blade and web are in step, `sync_angle`
/// of the knife, `sync_length` of the web. *Recovery*: the rest of the cut, in which the knife gains
/// (cuts shorter than C) or loses. Cuts beyond the *longest* without a stop would turn the knife
/// back; with `dwell` it stops instead.
///
/// **Frame.** Master: the position of the web, m; there is a cut at 0 and after every cut_length.
/// Slave: the angle of the knife, u; 0 is a blade straight down, and each cut advances it by turn /
/// blades (Extrapolation::advance). So half of the sync zone lies at the cam's start and half at
/// its end.
///
/// **The blade in the material**: a blade reaches the top of a web of `thickness` h at the *contact
/// angle* alpha before the bottom, cos(alpha) = 1 - h / R; the sync angle must be at least 2 alpha,
/// which is its default. Only the tip moves with the web: the blade above it is slower. (Of two
/// drums that meet in the middle of the web, each has half the thickness.)
///
/// Sources: Yaskawa and Delta rotary-cutter notes (constant surface speed; contact angle); the
/// recovery after Norton ch. 2 and VDI 2143. Derived in rotary_knife.cpp, docs/gear/rotary-knife.md.
struct RotaryKnifeSpec {
  double diameter = 0;                     ///< m, of the cutting circle; > 0
  std::size_t blades = 1;                  ///< evenly spaced; >= 1
  double cut_length = 0;                   ///< m, longer than the sync length
  std::optional<double> sync_angle = {};   ///< u, whole zone; or
  std::optional<double> sync_length = {};  ///< m, whole zone; neither: 2 contact angles
  double turn = 2 * std::numbers::pi;      ///< u of one revolution: 360 for deg, pi diameter for m
  KnifeMatching matching = KnifeMatching::surface;
  double speed_ratio =
      1;                 ///< blade speed over web speed in the sync zone: 1.005 pulls the cut open
  double thickness = 0;  ///< m, of the web; >= 0, < diameter / 2
  Law law = Law::poly345;    ///< law of the recovery: a symmetric rise from rest to rest
  LawForm form = {};         ///< straight and shares, for a law that has them
  bool dwell = false;        ///< stop between cuts that would turn the knife back
  double tolerance = 1e-12;  ///< tolerance of horizontal matching, as a share of the sync angle
};

/// Figures of such a spec. Angles in u, lengths in m.
struct RotaryKnifeFigures {
  double synchronous = 0;    ///< C / speed_ratio: with surface matching that cut is a plain gear
  double contact_angle = 0;  ///< 0 for a web without thickness
  double sync_angle = 0;
  double sync_length = 0;
  double recovery_angle = 0;
  double recovery_length = 0;
  double rho = 0;  ///< end slopes of the recovery over its mean slope: 1 is a straight line
  double surface_ratio = 0;  ///< greatest or least speed of the recovery over that of the gear
  double longest = 0;        ///< Lcrit: a longer cut turns the knife back or needs a dwell
  double dwell = 0;          ///< m of web that pass while the knife stands still; 0: no stop
  double speed_error =
      0;  ///< greatest slip of the blade along the web in the sync zone, over the web speed
  double strays = 0;  ///< u, certified: deviation from exact horizontal matching; 0 for surface
};

/// The cam of one cut: segments "sync", those of the recovery, "sync"; its zones are the sync
/// zones.
///
/// Surface matching is exact, and at cut_length = synchronous (to 1e-12) it is one straight line.
/// With horizontal matching the sync zone is a fit, within `tolerance`, certified; the recovery
/// takes over slope and acceleration, and with a law that starts without jerk (4567, 56789, ...)
/// the jerk, too. The knife reverses if the cut is too long and `dwell` is not set.
///
/// Throws InputError for a value out of range: two sync values or none; a sync zone that leaves no
/// recovery or (horizontal) reaches 90 deg; a law that is not a symmetric rise from rest to rest.
SyncCam rotary_knife(const RotaryKnifeSpec& spec);

/// Throws like rotary_knife().
RotaryKnifeFigures figures(const RotaryKnifeSpec& spec);

/// Findings of a knife besides its limits. Possibly broken: "knife/reversal", and "knife/contact",
/// a sync zone of less than two contact angles. Warning: "knife/slip", a blade that is more than 1
/// % slower than requested in the sync zone. Throws like rotary_knife().
Report check(const RotaryKnifeSpec& spec);

}  // namespace jounce
