// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/solver/rest_to_rest.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/numeric.hpp"

namespace jounce::profiles_detail {
RestToRest::RestToRest(double distance, const Bounds& b) noexcept : d_(std::abs(distance)) {
  // For a downward motion the limits are exchanged.
  const bool down = distance < 0;
  const Vector2 velocity = pair(b.velocity_max, b.velocity_min, down);
  const Vector2 jerk = pair(b.jerk_max, b.jerk_min, down);
  vmax_ = std::abs(velocity[0]);
  jp_ = jerk[0];
  jd_ = jerk[1];
  const Vector2 rates = magnitude(jerk);
  const Vector2 per_rate = 1 / rates;
  p_ = per_rate[0];
  q_ = per_rate[1];
  k_ = p_ + q_;
  twice_per_k_ = 2 * rates[0] / (rates[0] + rates[1]) * rates[1];
  limit_ = magnitude(pair(b.acceleration_max, b.acceleration_min, down));
  per_limit_ = 1 / limit_;
  sat_ = k_ * limit_ * limit_ / 2;
}

void RestToRest::rise_to(double vp) noexcept {
  vp_ = vp;
  z_ = least(limit_, every<Vector2>(std::sqrt(vp * twice_per_k_)));
  hold_ = greatest(vp - sat_, Vector2{}) * per_limit_;
  lasts_ = k_ * z_ + hold_;
}

/// The loss E, by (1) and the part for the hold.
Vector2 RestToRest::lost() const noexcept {
  const Vector2 at_first = k_ * (k_ + p_) * (z_ * z_ * z_) / 6;
  return at_first + hold_ * (z_ * z_ * (k_ + p_) + hold_ * z_) / 2;
}

/// Both accelerations reach z, without a hold.
void RestToRest::pass(double z) noexcept {
  vp_ = k_ * z * z / 2;
  z_ = every<Vector2>(z);
  hold_ = Vector2{};
  lasts_ = k_ * z_;
}

bool RestToRest::solve_shortest() noexcept {
  if (vmax_ < inf) {
    rise_to(vmax_);
    const Vector2 less = lost();
    const double way = vmax_ * (lasts_[0] + lasts_[1]) - less[0] - less[1];
    if (way <= d_) {
      cruise_ = (d_ - way) / vmax_;
      return true;
    }
  }
  const double kk = k_ * (k_ + q_);
  const double cubed = 3 * d_ / kk;
  if (!(cubed > 1e-290)) return false;  // too near to the least double
  const double z = cube_root_in_units(cubed, kk / (3 * d_));
  if (z <= std::min(limit_[0], limit_[1])) {
    pass(z);
    return true;
  }
  return hold_both((limit_[0] + limit_[1]) * q_ / 2, 1);
}

/// Equation (2) for both halves: vp^2 (1/L + 1/L')/2 + sign b vp = sign d + ..., if both halves
/// hold.
bool RestToRest::hold_both(double b, double sign) noexcept {
  const double a = (per_limit_[0] + per_limit_[1]) / 2;
  const double c = d_ + (cube(limit_[0]) + cube(limit_[1])) * (q_ - p_) * k_ / 24;
  const double vp = 2 * c / (b + root(b * b + sign * 4 * a * c));
  if (!(vp >= std::max(sat_[0], sat_[1]))) return false;
  rise_to(vp);
  return true;
}

bool RestToRest::solve_lasting(double t) noexcept {
  if (!pass_in(t) && !hold_both(t - (limit_[0] + limit_[1]) * p_ / 2, -1)) return false;
  cruise_ = t - lasts_[0] - lasts_[1];
  return cruise_ > 0 && vp_ <= vmax_;
}

/// Equation (3) with (1). With g = z/z0, where z0 is z without a loss: g^2 - u g^3 = 1.
bool RestToRest::pass_in(double t) noexcept {
  const double z0 = std::sqrt(2 * d_ / (k_ * t));
  const double u = 2 * (k_ + p_) * z0 / (3 * t);
  constexpr double most = 0.36;  // for 0.385 and more there is no solution
  if (!(u < most)) return false;
  double g = 1 + u * (0.5 + u * 0.625);
  for (int i = 0; i < 8; ++i) {
    const double step = (g * g * (1 - u * g) - 1) / (g * (2 - 3 * u * g));
    g -= step;
    if (std::abs(step) <= 1e-9) break;
  }
  if (z0 * g > std::min(limit_[0], limit_[1])) return false;
  pass(z0 * g);
  return true;
}

double RestToRest::duration() const noexcept {
  return lasts_[0] + lasts_[1] + cruise_;
}

Profile RestToRest::profile(const MotionState& from, const MotionState& to) const noexcept {
  const bool cruises = cruise_ > 0;
  const double first = z_[0];
  const double last = z_[1];
  return Profile(from, to, 3, {jp_, jd_},
                 {{first * p_, 1},
                  {hold_[0], 0},
                  {(cruises ? first : first + last) * q_, 2},
                  {cruise_, 0},
                  {cruises ? last * q_ : 0, 2},
                  {hold_[1], 0},
                  {last * p_, 1}});
}

}  // namespace jounce::profiles_detail
