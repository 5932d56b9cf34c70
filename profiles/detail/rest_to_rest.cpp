#include "jounce/profiles/detail/rest_to_rest.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/numeric.hpp"

namespace jounce::detail {
namespace {

/// The same in all units that are powers of two of each other, which std::cbrt alone is not.
double cube_root(double x) {
  const int thirds = (std::ilogb(x) + 3000) / 3 - 1000;
  return std::ldexp(std::cbrt(std::ldexp(x, -3 * thirds)), thirds);
}

}  // namespace

RestToRest::RestToRest(double distance, const Bounds& b) noexcept : d_(std::abs(distance)) {
  const bool up = distance > 0;
  vmax_ = up ? b.velocity_max : -b.velocity_min;
  jp_ = up ? b.jerk_max : b.jerk_min;
  jd_ = up ? b.jerk_min : b.jerk_max;
  p_ = 1 / std::abs(jp_);
  q_ = 1 / std::abs(jd_);
  k_ = p_ + q_;
  const auto half = [this](double limit) {
    return Half{limit, 1 / limit, k_ * limit * limit / 2};
  };
  half_ = {half(up ? b.acceleration_max : -b.acceleration_min),
           half(up ? -b.acceleration_min : b.acceleration_max)};
}

void RestToRest::rise_to(double vp) noexcept {
  vp_ = vp;
  for (Half& h : half_) {
    h.hold = std::max(vp - h.sat, 0.0) * h.per_limit;
    h.z = h.hold > 0 ? h.limit : std::sqrt(2 * vp / k_);
    h.lasts = k_ * h.z + h.hold;
  }
}

/// E, from (1) and what the hold adds to it.
double RestToRest::lost(const Half& h) const noexcept {
  const double at_first = k_ * (k_ + p_) * cube(h.z) / 6;
  return at_first + h.hold * (h.z * h.z * (k_ + p_) + h.hold * h.z) / 2;
}

/// Both accelerations reach z, without a hold.
void RestToRest::pass(double z) noexcept {
  vp_ = k_ * z * z / 2;
  for (Half& h : half_) {
    h.z = z;
    h.hold = 0;
    h.lasts = k_ * z;
  }
}

bool RestToRest::solve_shortest() noexcept {
  if (vmax_ < inf) {
    rise_to(vmax_);
    const double way = vmax_ * (half_[0].lasts + half_[1].lasts) - lost(half_[0]) - lost(half_[1]);
    if (way <= d_) {
      cruise_ = (d_ - way) / vmax_;
      return true;
    }
  }
  const double z = cube_root(3 * d_ / (k_ * (k_ + q_)));
  if (z <= std::min(half_[0].limit, half_[1].limit)) {
    pass(z);
    return true;
  }
  return hold_both((half_[0].limit + half_[1].limit) * q_ / 2, 1);
}

/// (2) of both halves: vp^2 (1/L + 1/L')/2 + sign b vp = sign d + ..., if that is where both hold.
bool RestToRest::hold_both(double b, double sign) noexcept {
  const double a = (half_[0].per_limit + half_[1].per_limit) / 2;
  const double c = d_ + (cube(half_[0].limit) + cube(half_[1].limit)) * (q_ - p_) * k_ / 24;
  const double vp = 2 * c / (b + root(b * b + sign * 4 * a * c));
  if (!(vp >= std::max(half_[0].sat, half_[1].sat))) return false;
  rise_to(vp);
  return true;
}

bool RestToRest::solve_lasting(double t) noexcept {
  if (!pass_in(t) &&
      !hold_both(t - (half_[0].limit + half_[1].limit) * p_ / 2, -1))
    return false;
  cruise_ = t - half_[0].lasts - half_[1].lasts;
  return cruise_ > 0 && vp_ <= vmax_;
}

/// (3) with (1): with g = z/z0, where z0 does without a loss, g^2 - u g^3 = 1.
bool RestToRest::pass_in(double t) noexcept {
  const double z0 = std::sqrt(2 * d_ / (k_ * t));
  const double u = 2 * (k_ + p_) * z0 / (3 * t);
  constexpr double most = 0.36;  // from 0.385 on there is none
  if (!(u < most)) return false;
  double g = 1 + u * (0.5 + u * 0.625);
  for (int i = 0; i < 8; ++i) {
    const double step = (g * g * (1 - u * g) - 1) / (g * (2 - 3 * u * g));
    g -= step;
    if (std::abs(step) <= 1e-9) break;
  }
  if (z0 * g > std::min(half_[0].limit, half_[1].limit)) return false;
  pass(z0 * g);
  return true;
}

double RestToRest::duration() const noexcept {
  return half_[0].lasts + half_[1].lasts + cruise_;
}

Profile RestToRest::profile(const MotionState& from, const MotionState& to) const noexcept {
  const bool cruises = cruise_ > 0;
  const auto& [first, last] = half_;
  return Profile(from, to, 3, {jp_, jd_},
                 {{first.z * p_, 1},
                  {first.hold, 0},
                  {(cruises ? first.z : first.z + last.z) * q_, 2},
                  {cruise_, 0},
                  {cruises ? last.z * q_ : 0, 2},
                  {last.hold, 0},
                  {last.z * p_, 1}});
}

}  // namespace jounce::detail
