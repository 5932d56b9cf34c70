// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/algebra/correction.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/cam/coupling/followed.hpp"

// Over the master, with u its travel since the start and L the distance, the correction is the
// quintic with the difference's value and two derivatives at u = 0, and zeros at u = L:
//
//   (1)  c(u) = q(u; d0, d1, d2),         u >= 0
//   (2)  c(u) = q(-u; d0, -d1, d2),       u < 0
//
// Both have the same two derivatives at 0, so c is smooth to the second one everywhere.

namespace jounce {

Correction Correction::over_time(const Profile& profile, double start) {
  Correction c;
  c.kind_ = Kind::time;
  c.profile_ = profile;
  c.start_ = start;
  return c;
}

Correction Correction::over_master(const Jet& d, double origin, double distance) {
  Correction c;
  c.kind_ = Kind::master;
  c.start_ = origin;
  c.distance_ = distance;
  c.ahead_ = quintic(distance, d[0], d[1], d[2], 0, 0, 0);    // (1)
  c.behind_ = quintic(distance, d[0], -d[1], d[2], 0, 0, 0);  // (2)
  return c;
}

/// Value and derivatives with respect to the master, at the distance u from the origin.
Jet Correction::by_master(double u) const {
  if (u >= 0) return evaluate(ahead_, u / distance_);
  const Jet c = evaluate(behind_, -u / distance_);
  return {c[0], -c[1], c[2], -c[3]};
}

bool Correction::finite() const {
  const auto sound = [](const Segment& f) {
    return std::all_of(f.c.begin(), f.c.end(), [](double c) { return std::isfinite(c); });
  };
  const double h = distance_ * distance_ * distance_;  // divisor of the derivatives
  const bool divides = kind_ != Kind::master || (std::isfinite(h) && h > 0);
  return divides && sound(ahead_) && sound(behind_);
}

Cam Correction::curve() const {
  return Cam({reversed(behind_), ahead_}, start_ - distance_, Extrapolation::hold);
}

Jet Correction::jet(double t, const Jet& master) const {
  if (done(t, master[0])) return {};
  if (kind_ == Kind::master) return chained(by_master(master[0] - start_), master);
  const Motion now = profile_.at(t - start_);
  return {now.position, now.velocity, now.acceleration, now.jerk};
}

bool Correction::done(double t, double master) const {
  if (kind_ == Kind::time) return t - start_ >= profile_.duration();
  return kind_ == Kind::none || std::abs(master - start_) >= distance_;
}

}  // namespace jounce
