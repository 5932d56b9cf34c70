// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/rotary_knife.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/cut/knife_parts.hpp"

// Angles are in rad here. R = D / 2 is the radius of the cutting circle, k the speed ratio, x the
// web since the cut, psi the knife's angle from straight down. The cutting circle touches the
// anvil, on which the web lies.
//
// **The cut.** The tip of the blade is at
//
//     (1)  R sin psi along the web,   R (1 - cos psi) above the anvil
//
// So it enters the top of a web of thickness h, and leaves it, at the angle alpha with
//
//     (2)  R (1 - cos alpha) = h
//
// It moves along the web at R cos(psi) psi'. (Delta counts its contact angle from the horizontal, a
// = pi/2 - alpha. The ratio of the speeds at a + theta is then sin(a + theta), and the web that
// passes until the bottom is R cos a.) "In step" means
//
//     (3)  surface:     R psi' = k             psi = k x / R
//     (4)  horizontal:  R cos(psi) psi' = k    psi = asin(k x / R)
//
// In (3) the tip is slower along the web than required, by the share 1 - cos psi. The half sync
// angle psi_s corresponds to the web length
//
//     (5)  sigma = R psi_s / k,   or   sigma = R sin(psi_s) / k
//
// At the end of the zone, the derivatives psi', psi'' and psi''' with respect to the web are
//
//     (6)  k / R, 0, 0,   or   k / (R c),  k^2 t / (R^2 c^2),  k^3 (1 + 2 s^2) / (R^3 c^5)
//
// where s, c, t are the sine, cosine and tangent of psi_s. At the start of the zone they are the
// same, except for the sign of psi''.
//
// **The recovery** is a symmetric rise f between these states; see knife_shape.hpp. Over b = L - 2
// sigma it gains h = 2 pi / N - 2 psi_s.

namespace jounce {
namespace {

using gear_detail::Knife;
using gear_detail::KnifeShape;
using gear_detail::KnifeSync;

using std::numbers::pi;

constexpr double finest_matching = 1e-14;  ///< share of the sync angle
constexpr double same_length = 1e-12;      ///< relative

bool is_rise_at_rest(Law law) {
  const Ends ends = info(law).ends;
  return has_own_shape(law) &&
         (ends == Ends::given || ends == Ends::moving || ends == Ends::moving_free);
}

void require_valid(const RotaryKnifeSpec& spec) {
  require_positive("diameter", spec.diameter);
  if (spec.blades < 1) throw InputError("blades", "0", "must be at least 1");
  require_positive("cut_length", spec.cut_length);
  require_positive("turn", spec.turn);
  require_positive("speed_ratio", spec.speed_ratio);
  require_not_negative("thickness", spec.thickness);
  if (!(spec.thickness < spec.diameter / 2))
    throw InputError("thickness", spec.thickness,
                     "must be less than the radius of the knife, " + six_digits(spec.diameter / 2));
  if (!(spec.tolerance >= finest_matching && spec.tolerance <= 1e-3))
    throw InputError("tolerance", spec.tolerance, "must be a share from 1e-14 to 1e-3");
  if (!is_rise_at_rest(spec.law))
    throw InputError("law", name(spec.law),
                     "must be a symmetric law from rest to rest, such as 345");
  if (spec.form.inflection)
    throw InputError("inflection", *spec.form.inflection,
                     "must be left out: the recovery is symmetric about its middle");
}

/// Equation (2), by half the angle: this loses no digits if the web is thin.
double contact_angle(const RotaryKnifeSpec& spec) {
  return 2 * std::asin(std::sqrt(spec.thickness / spec.diameter));
}

/// psi_s as given by the spec.
double half_sync_angle(const RotaryKnifeSpec& spec, double unit) {
  if (spec.sync_angle && spec.sync_length)
    throw InputError("sync_length", *spec.sync_length,
                     "cannot be combined with sync_angle: leave one out");
  const double radius = spec.diameter / 2;
  if (spec.sync_length) {
    require_positive("sync_length", *spec.sync_length);
    const double along = *spec.sync_length / 2 * spec.speed_ratio / radius;
    if (spec.matching == KnifeMatching::surface) return along;
    if (!(along < 1))
      throw InputError("sync_length", *spec.sync_length,
                       "must be less than " + six_digits(spec.diameter / spec.speed_ratio) +
                           ", the distance of the tip from one side of the knife to the other");
    return std::asin(along);
  }
  if (spec.sync_angle) {
    require_positive("sync_angle", *spec.sync_angle);
    return *spec.sync_angle / unit / 2;
  }
  if (!(spec.thickness > 0))
    throw InputError("sync_angle", "",
                     "is missing: give sync_angle or sync_length, or the thickness of the web");
  return contact_angle(spec);
}

/// Equations (5) and (6).
KnifeSync sync_of(const RotaryKnifeSpec& spec, double angle) {
  const double slope = spec.speed_ratio / (spec.diameter / 2);
  if (spec.matching == KnifeMatching::surface) return {angle, angle / slope, slope, 0, 0};
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return {angle, s / slope, slope / c, slope * slope * s / (c * c * c),
          slope * slope * slope * (1 + 2 * s * s) / std::pow(c, 5)};
}

/// The angle whose sync zone is as long as cut_length; infinite if every zone is shorter.
double angle_of_cut(const RotaryKnifeSpec& spec) {
  const double along = spec.cut_length / spec.diameter * spec.speed_ratio;
  if (spec.matching == KnifeMatching::surface) return 2 * along;
  return along < 1 ? 2 * std::asin(along) : std::numeric_limits<double>::infinity();
}

/// Requires that psi_s leaves an angle for the recovery, and that (4) gives an angle. The error
/// names the given key.
void require_room(const RotaryKnifeSpec& spec, double half, double pitch, double unit) {
  const char* key = spec.sync_length ? "sync_length" : spec.sync_angle ? "sync_angle" : "thickness";
  const double given = spec.sync_length.value_or(spec.sync_angle.value_or(spec.thickness));
  if (spec.sync_angle && !(2 * half < pitch)) {
    const double of_cut = angle_of_cut(spec);
    throw InputError(
        key, given,
        "must be less than " + six_digits_down(std::min(pitch, of_cut) * unit) +
            (of_cut < pitch ? ", the angle of a sync zone as long as cut_length: give a smaller "
                              "angle (it must also be less than the angle between two blades)"
                            : ", the angle between two blades: give a smaller angle"));
  }
  if (!(2 * half < pitch))
    throw InputError(key, given,
                     "makes a sync zone of " + six_digits(2 * half * unit) +
                         ", which must be less than the angle between two blades, " +
                         six_digits(pitch * unit) + " (turn / blades)");
  if (spec.matching == KnifeMatching::horizontal && !(half < pi / 2))
    throw InputError(key, given,
                     "makes a sync zone of " + six_digits(2 * half * unit) +
                         ", which must be less than half a turn, " + six_digits(pi * unit) +
                         ", with horizontal matching");
}

}  // namespace

Knife gear_detail::knife_of(const RotaryKnifeSpec& spec) {
  require_valid(spec);
  const double unit = spec.turn / (2 * pi);
  const double pitch = 2 * pi / static_cast<double>(spec.blades);
  const double half = half_sync_angle(spec, unit);
  require_room(spec, half, pitch, unit);
  const KnifeSync sync = sync_of(spec, half);
  if (!(spec.cut_length > 2 * sync.length))
    throw InputError("cut_length", spec.cut_length,
                     "must be longer than the sync zone on the web, " +
                         six_digits_up(2 * sync.length) +
                         ": raise cut_length, or shorten the sync zone" +
                         (spec.sync_angle ? " (sync_angle must be less than " +
                                                six_digits_down(angle_of_cut(spec) * unit) + ")"
                                          : ""));
  return {pitch, spec.thickness > 0 ? contact_angle(spec) : 0, sync,
          KnifeShape(normalized(spec.law, spec.form), sync, pitch - 2 * half), unit};
}

gear_detail::KnifeZone gear_detail::zone_of(const Knife& knife, const RotaryKnifeSpec& spec) {
  return knife_zone(knife.sync, spec.matching == KnifeMatching::horizontal,
                    spec.tolerance * knife.sync.angle);
}

Cam gear_detail::closed(std::vector<Segment> segments, double length, double end) {
  Segment& last = segments.back();
  for (int i = 0; i < 6; ++i) {
    const double missing = length - Cam(segments).end();
    last.length += i == 0 ? missing : 0.75 * missing;  // not all: a tie would round the other way
    last.c[0] += end - value(last, 1);
  }
  return Cam(std::move(segments), 0, Extrapolation::advance);
}

namespace {

/// True if the cut is a straight line; this is possible with surface matching only.
bool is_gear(const RotaryKnifeSpec& spec, double synchronous) {
  return spec.matching == KnifeMatching::surface &&
         std::abs(spec.cut_length - synchronous) <= same_length * synchronous;
}

double synchronous_length(const RotaryKnifeSpec& spec) {
  return pi * spec.diameter / static_cast<double>(spec.blades) / spec.speed_ratio;
}

/// The segments of a cut under construction, each with its name.
struct Parts {
  std::vector<Segment> segments;
  std::vector<std::string> names;

  void add(std::span<const Segment> all, const char* name) {
    segments.insert(segments.end(), all.begin(), all.end());
    names.insert(names.end(), all.size(), name);
  }
};

void add_recovery(Parts& parts, const Knife& knife, double length, bool dwell) {
  const double free = length - 2 * knife.sync.length;
  const double start = knife.sync.angle;
  if (!dwell) return parts.add(knife.shape.recovery(free, start), "recovery");
  const double moving = knife.shape.longest();
  const Cam whole(knife.shape.recovery(moving, start));
  const double middle = knife.pitch / 2;
  const Segment stand = line(free - moving, middle, middle);
  parts.add(between(whole, 0, moving / 2).segments(), "stop");
  parts.add(std::span(&stand, 1), "dwell");
  parts.add(between(whole, moving / 2, moving).segments(), "start");
}

}  // namespace

SyncCam rotary_knife(const RotaryKnifeSpec& spec) {
  const Knife knife = gear_detail::knife_of(spec);
  const double length = spec.cut_length;
  const double turn = spec.turn / static_cast<double>(spec.blades);
  if (is_gear(spec, synchronous_length(spec)))
    return {
        Cam({line(length, 0, turn)}, 0, Extrapolation::advance), {"sync"}, {{0, length, "sync"}}};
  const gear_detail::KnifeZone zone = gear_detail::zone_of(knife, spec);
  Parts parts;
  parts.add(zone.leaving, "sync");
  add_recovery(parts, knife, length, spec.dwell && length > knife.longest());
  parts.add(zone.entering(knife.pitch), "sync");
  for (Segment& segment : parts.segments) segment = scaled(segment, knife.unit);
  const double half = knife.sync.length;
  return {gear_detail::closed(std::move(parts.segments), length, turn),
          std::move(parts.names),
          {{0, half, "sync"}, {length - half, length, "sync"}}};
}

RotaryKnifeFigures figures(const RotaryKnifeSpec& spec) {
  const Knife knife = gear_detail::knife_of(spec);
  const double unit = knife.unit;
  RotaryKnifeFigures f;
  f.synchronous = synchronous_length(spec);
  f.contact_angle = knife.contact * unit;
  f.sync_angle = 2 * knife.sync.angle * unit;
  f.sync_length = 2 * knife.sync.length;
  f.recovery_angle = knife.pitch * unit - f.sync_angle;
  f.recovery_length = spec.cut_length - f.sync_length;
  f.longest = knife.longest();
  f.rho = knife.sync.velocity * f.recovery_length * unit / f.recovery_angle;
  if (spec.dwell) f.dwell = std::max(0.0, spec.cut_length - f.longest);
  f.surface_ratio =
      f.dwell > 0 ? 0 : knife.shape.middle_velocity(f.recovery_length) * spec.diameter / 2;
  const bool slips = spec.matching == KnifeMatching::surface;
  const double s = std::sin(knife.sync.angle / 2);
  f.speed_error = slips ? 2 * s * s : 0;  // 1 - cos
  if (!slips) f.strays = unit * gear_detail::zone_of(knife, spec).strays;
  return f;
}

}  // namespace jounce
