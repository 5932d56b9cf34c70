// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/disc/disc.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/disc/pitch.hpp"

// The geometry is derived in pitch.hpp. The position at lift 0, with prime radius R = base
// radius + roller radius, is:
//
//   (1)  d = sqrt(R^2 - e^2)                            height of a translating roller
//   (2)  cos psi0 = (l^2 + c^2 - R^2) / (2 l c)         angle of the arm to the line of centers

namespace jounce {
namespace {

using profiles_detail::rounded_input;

constexpr double turn = 2 * std::numbers::pi;
constexpr double largest_length = 1e12;     ///< greatest length
constexpr double least_prime_share = 1e-6;  ///< share of the stroke for the least prime radius

/// Equation (1).
double start_height(const DiscSpec& spec, double travel) {
  const double prime = spec.base_radius + spec.roller_radius;
  if (!(prime >= least_prime_share * travel))
    throw InputError("base_radius", spec.base_radius,
                     "is too small: base_radius + roller_radius must be at least " +
                         six_digits(least_prime_share * travel) + ", a millionth of the stroke");
  if (!(std::abs(spec.offset) < prime))
    throw InputError("offset", spec.offset,
                     "must be less than " + six_digits(prime) + ", base_radius + roller_radius");
  return std::sqrt((prime - spec.offset) * (prime + spec.offset));
}

/// Equation (2).
double start_angle(const DiscSpec& spec, double travel) {
  const double prime = spec.base_radius + spec.roller_radius;
  const double l = spec.arm_length;
  const double c = spec.center_distance;
  if (!(std::abs(c - l) < prime && prime < c + l))
    throw InputError(
        "arm_length", l,
        "does not reach the base circle: base_radius + roller_radius = " + six_digits(prime) +
            " must lie between " + six_digits(std::abs(c - l)) + " and " + six_digits(c + l) +
            ", the difference and the sum of arm length and center distance");
  // Computed from the half angle, because an arc cosine loses half of the digits near a stretched
  // or folded arm.
  const double start = 2 * std::atan2(std::sqrt((prime - (c - l)) * (prime + (c - l))),
                                      std::sqrt(((c + l) - prime) * ((c + l) + prime)));
  const double swing = cam_detail::arm_angle(spec) * travel;
  if (!(start + swing < std::numbers::pi))
    throw InputError("arm_length", l,
                     "lets the arm swing to " + six_digits((start + swing) * 360 / turn) +
                         " deg from the line of centers, which must stay below 180 deg: shorten "
                         "the stroke or the arm");
  return start;
}

}  // namespace

void cam_detail::require_lengths(const DiscSpec& spec) {
  for (const auto& [key, value] : {std::pair{"base_radius", spec.base_radius},
                                   {"roller_radius", spec.roller_radius},
                                   {"offset", spec.offset},
                                   {"arm_length", spec.arm_length},
                                   {"center_distance", spec.center_distance}})
    if (std::abs(value) > largest_length)
      throw InputError(key, value,
                       "must be at most " + six_digits(largest_length) + " in magnitude");
  require_positive("base_radius", spec.base_radius);
  require_not_negative("roller_radius", spec.roller_radius);
  require_positive("angle", spec.angle);
  if (spec.follower == Follower::translating) return require_finite("offset", spec.offset);
  require_positive("arm_length", spec.arm_length);
  require_positive("center_distance", spec.center_distance);
  if (spec.arm_angle) require_positive("arm_angle", *spec.arm_angle);
}

double cam_detail::start_of(const DiscSpec& spec, double travel) {
  return spec.follower == Follower::translating ? start_height(spec, travel)
                                                : start_angle(spec, travel);
}

namespace {

/// The cam repeated until the turn is full, with least value 0.
Cam whole_turn(const Cam& cam, double angle) {
  const double lobes = turn / (cam.length() * angle);
  const double whole = std::round(lobes);
  if (!(whole >= 1 && whole <= 1000 && std::abs(lobes - whole) <= rounded_input * whole))
    throw InputError(
        "cam", six_digits(cam.length() * angle * 360 / turn) + " deg long",
        "must be 360 deg long, or 360 deg divided by a whole number, to become a disc");
  const Range travel = extrema(cam, 0);
  const double step = cam.jet(cam.end(), Side::left)[0] - cam.jet(cam.start())[0];
  if (std::abs(step) > rounded_input * (travel.max.value - travel.min.value))
    throw InputError("cam", "",
                     "cannot become a disc: the slave must end where it begins, but its end is " +
                         six_digits(step) + " beyond its start: change the last knot");
  const Jump jump = largest_jump(cam, 0);
  if (std::abs(jump.step) > rounded_input * (travel.max.value - travel.min.value))
    throw InputError("cam", six_digits(jump.step),
                     "is a step of the slave at master " + six_digits(jump.where) +
                         ", which no disc can have: remove it");
  const Cam lift = with(shifted(cam, 0, -travel.min.value), Extrapolation::wrap);
  return repeated(lift, static_cast<int>(whole));
}

/// A Range, computed as the greatest value of g and of -g, with the greater error of both.
struct Both {
  Range range;
  double error;
};
template <class Function>
Both range_of(const Disc& disc, double scale, Function g) {
  const auto greatest = [&](double sign) {
    return cam_detail::maximum(
        disc.lift(), disc.spec().angle,
        [&](const cam_detail::SegmentPart& over) {
          return sign * g(cam_detail::pitch(disc, over));
        },
        scale);
  };
  const cam_detail::Certified max = greatest(1);
  cam_detail::Certified min = greatest(-1);
  min.extremum.value = -min.extremum.value;
  const double peak = std::max({std::abs(max.extremum.value), std::abs(min.extremum.value), scale});
  return {{min.extremum, max.extremum}, std::max(max.excess, min.excess) / peak};
}

}  // namespace

Disc::Disc(const Cam& cam, const DiscSpec& spec)
    : spec_((cam_detail::require_lengths(spec), spec)), lift_(whole_turn(cam, spec.angle)) {
  start_ = cam_detail::start_of(spec, extrema(lift_, 0).max.value);
}

DiscPoint Disc::at(double master, Side side) const {
  double x = wrapped(master, lift_.start(), lift_.length());
  if (side == Side::left && x == lift_.start()) x = lift_.end();
  const Jet f = lift_.jet(x, side);
  cam_detail::Taylor<4> lift;
  double factor = 1;
  for (std::size_t k = 0; k < 3; ++k, factor /= spec_.angle * static_cast<double>(k))
    lift.c[k] = cam_detail::Interval(f[k] * factor);
  const cam_detail::Pitch p = cam_detail::pitch(spec_, start_, lift);
  const auto place = [&](const auto& a) {
    const auto b = cam_detail::seen_from_cam(a.template to<0>(),
                                             cam_detail::Taylor<0>(spec_.angle * master), p.sigma);
    return Place{b.x.c[0].middle(), b.y.c[0].middle()};
  };
  DiscPoint point;
  point.center = place(p.center);
  point.contact = place(p.parallel(-spec_.roller_radius));
  point.normal = place(p.normal());
  point.pressure_angle = std::atan2(p.across().c[0].middle(), p.along().c[0].middle());
  point.pitch_curvature = p.curvature().c[0].middle();
  return point;
}

DiscExtremes extremes(const Disc& disc) {
  const double prime = disc.spec().base_radius + disc.spec().roller_radius;
  Both tangent =
      range_of(disc, 1e-3, [](const cam_detail::Pitch& p) { return p.across() / p.along(); });
  const Both curvature =
      range_of(disc, 1 / prime, [](const cam_detail::Pitch& p) { return p.curvature(); });
  for (Extremum* e : {&tangent.range.min, &tangent.range.max}) e->value = std::atan(e->value);
  return {tangent.range, curvature.range, std::max(tangent.error, curvature.error)};
}

}  // namespace jounce
