// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "jounce/cam/disc/disc.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

// By (1) of disc.cpp and (7) of pitch.hpp, a translating roller keeps |pressure angle| <= A
// if its height at lift 0 is at least
//
//   (1)  d >= max over t of (+-(L' - sigma e) / tan A - L)
//
// This is a maximum of exact curves. The curvature, and all conditions for an arm, have no such
// form. For them the search evaluates the extrema, from the least radius that (1) or the arm
// permits upwards.

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

constexpr double radius_resolution = 2e-10;  ///< share of the radius
/// Share of a step, or of a radius, above a bound that is not permitted itself.
constexpr double just_above = 1e-9;
constexpr double deg = 180 / std::numbers::pi;

void require_valid(const DiscLimits& limits) {
  if (limits.pressure_angle) {
    require_positive("pressure_angle", *limits.pressure_angle);
    if (!(*limits.pressure_angle < std::numbers::pi / 2))
      throw InputError("pressure_angle", *limits.pressure_angle,
                       "must be below a right angle (pi/2 rad)");
  }
  if (limits.profile_radius) require_not_negative("profile_radius", *limits.profile_radius);
  if (limits.cutter_radius) require_not_negative("cutter_radius", *limits.cutter_radius);
}

/// Radius of curvature of the profile at the sharpest convex point of the pitch curve.
double convex_radius(const DiscExtremes& worst, const DiscSpec& spec) {
  return 1 / worst.pitch_curvature.max.value - spec.roller_radius;
}

/// True if base radius `base` keeps the limits.
bool keeps(const Cam& cam, DiscSpec spec, double base, const DiscLimits& limits) {
  spec.base_radius = base;
  try {
    const DiscExtremes worst = extremes(Disc(cam, spec));
    if (limits.pressure_angle &&
        std::abs(worst.pressure_angle.peak().value) > *limits.pressure_angle)
      return false;
    const double radius = convex_radius(worst, spec);
    return radius > 0 && radius >= limits.profile_radius.value_or(0);
  } catch (const InputError&) {  // no such disc: its arm does not reach, or swings too far
    return false;
  }
}

/// Equation (1), as a base radius; 0 if there is no limit.
double least_by_pressure(const Cam& cam, const DiscSpec& spec, const DiscLimits& limits) {
  if (!limits.pressure_angle) return 0;
  const double cot = 1 / std::tan(*limits.pressure_angle);
  const double e = spec.rotation == Rotation::counterclockwise ? spec.offset : -spec.offset;
  const Cam lift = shifted(cam, 0, -extrema(cam, 0).min.value);
  double d = 0;
  for (const double sign : {1.0, -1.0}) {
    const Cam slope = shifted(scaled(derivative(cam), sign * cot / spec.angle), 0, -sign * cot * e);
    d = std::max(d, extrema(sum(slope, scaled(lift, -1.0)), 0).max.value);
  }
  return std::hypot(d, e) - spec.roller_radius;
}

/// Bisects between an insufficient radius and a sufficient one, to rounding; returns the sufficient
/// one.
double boundary(const Cam& cam, const DiscSpec& spec, const DiscLimits& limits, double bad,
                double good) {
  while (good - bad > radius_resolution * good) {
    const double middle = bad + (good - bad) / 2;
    (keeps(cam, spec, middle, limits) ? good : bad) = middle;
  }
  return good;
}

std::optional<double> climb(const Cam& cam, const DiscSpec& spec, const DiscLimits& limits,
                            double from, double to, double factor, double step) {
  double bad = from;
  for (double base = from; base < to; base = base * factor + step) {
    if (keeps(cam, spec, base, limits)) return boundary(cam, spec, limits, bad, base);
    bad = base;
  }
  return std::nullopt;
}

Finding finding(Rule rule, std::string quantity, const Extremum& at, double value, double limit,
                bool least) {
  Finding f;
  f.rule = std::move(rule);
  f.quantity = std::move(quantity);
  f.where = at.where;
  f.value = value;
  f.limit = limit;
  const double room = least ? value - limit : std::abs(limit) - std::abs(value);
  const double scale = std::abs(limit) > 0 ? std::abs(limit) : 1;
  f.margin = room / scale;
  f.broken = room < -rounded_input * scale;
  return f;
}

/// "base_radius = 41.7 is sufficient", rounded up.
std::string advice_of(const Disc& disc, const DiscLimits& limits, const std::string& otherwise) {
  const auto base = least_base_radius(disc.lift(), disc.spec(), limits);
  if (!base) return otherwise;
  const double unit = std::pow(10, std::floor(std::log10(*base)) - 3);
  return "base_radius = " +
         number(std::stod(number(std::ceil(*base / unit)) + "e" +
                          std::to_string(std::lround(std::log10(unit))))) +
         " is sufficient";
}

void add_pressure(Report& report, const Disc& disc, const DiscExtremes& worst,
                  const DiscLimits& limits) {
  if (!limits.pressure_angle) return;
  const Extremum& peak = worst.pressure_angle.peak();
  Finding f = finding("disc/pressure_angle", "pressure angle", peak, peak.value * deg,
                      std::copysign(*limits.pressure_angle * deg, peak.value), false);
  f.unit = "deg";
  if (f.broken)
    f.advice =
        advice_of(disc, limits,
                  "no base radius is sufficient: take a smoother law, or a longer master range");
  report.findings.push_back(std::move(f));
}

/// The convex profile: its radius must be greater than 0, and not below the limit.
void add_radius(Report& report, const Disc& disc, const DiscExtremes& worst,
                const DiscLimits& limits) {
  const Extremum& at = worst.pitch_curvature.max;
  const double radius = convex_radius(worst, disc.spec());
  Finding f = finding("disc/profile_radius", "convex profile radius", at, radius,
                      limits.profile_radius.value_or(0), true);
  if (!(f.limit > 0)) f.margin = radius / (radius + disc.spec().roller_radius);
  f.broken = f.broken || radius <= 0;
  if (f.broken) {
    f.advice = advice_of(disc, limits, "take a smaller roller, or a smoother law");
    if (radius <= 0) f.advice = "the roller undercuts the profile: " + f.advice;
  }
  report.findings.push_back(std::move(f));
}

/// The hollow profile: the cutter must fit. The radius of the profile there is that of the pitch
/// curve plus the roller's, so the roller always fits.
void add_cutter(Report& report, const Disc& disc, const DiscExtremes& worst,
                const DiscLimits& limits) {
  const Extremum& at = worst.pitch_curvature.min;
  if (!limits.cutter_radius || at.value >= 0) return;
  Finding f = finding("disc/cutter_radius", "hollow profile radius", at,
                      disc.spec().roller_radius - 1 / at.value, *limits.cutter_radius, true);
  if (f.broken) f.advice = "use a cutter of at most that radius";
  report.findings.push_back(std::move(f));
}

/// Checks distant intervals, if the curvature permits the check.
void add_interference(Report& report, const Disc& disc, const char* what, double radius) {
  const auto found = interference(disc, radius);
  if (!found) return;
  Finding f;
  f.rule = "disc/interference";
  f.quantity = what;
  f.where = found->circle;
  f.value = found->depth;
  f.margin = -found->depth / radius;
  f.broken = true;
  f.advice = "it also cuts into the profile at " + number(found->covered);
  report.findings.push_back(std::move(f));
}

void add_corner(Report& report, const Disc& disc) {
  Report corner = check_continuity(disc.lift(), 1);
  for (Finding& f : corner.findings) {
    if (f.rule != "continuity/geo_velocity" || !f.broken) continue;
    f.rule = "disc/corner";
    f.advice = "the profile has a corner there, which no roller can follow";
    report.findings.push_back(std::move(f));
  }
}

}  // namespace

std::optional<double> least_base_radius(const Cam& cam, const DiscSpec& spec,
                                        const DiscLimits& limits) {
  require_valid(limits);
  if (spec.follower == Follower::oscillating) {
    const double from =
        std::max(0.0, std::abs(spec.center_distance - spec.arm_length) - spec.roller_radius);
    const double to = spec.center_distance + spec.arm_length - spec.roller_radius;
    const double step = (to - from) / 400;
    return step > 0 ? climb(cam, spec, limits, from + just_above * step, to, 1, step)
                    : std::nullopt;
  }
  const Range travel = extrema(cam, 0);
  const double size =
      spec.roller_radius + std::abs(spec.offset) + travel.max.value - travel.min.value;
  const double from =
      std::max({least_by_pressure(cam, spec, limits) * (1 + rounded_sum), 1e-3 * size,
                (std::abs(spec.offset) - spec.roller_radius) * (1 + just_above)});
  return climb(cam, spec, limits, from, 1e9 * size, 1.02, 0);
}

Report check(const Disc& disc, const DiscLimits& limits) {
  require_valid(limits);
  const DiscExtremes worst = extremes(disc);
  Report report;
  add_pressure(report, disc, worst, limits);
  add_radius(report, disc, worst, limits);
  add_cutter(report, disc, worst, limits);
  add_corner(report, disc);
  if (report.ok()) {
    if (disc.spec().roller_radius > 0)
      add_interference(report, disc, "overlap of the roller", disc.spec().roller_radius);
    if (limits.cutter_radius && *limits.cutter_radius > 0)
      add_interference(report, disc, "overlap of the cutter", *limits.cutter_radius);
  }
  sort(report);
  return report;
}

}  // namespace jounce
