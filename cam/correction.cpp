#include "jounce/cam/correction.hpp"

#include <cmath>

#include "jounce/cam/followed.hpp"

// Over the master. With s = |u| / L, u the master's way since the start and L the distance,
//
//   (1)  c = (1 - s)^3 q(s),   q = q0 + q1 s + q2 s^2
//
// is zero with two derivatives at s = 1. Let p0, p1, p2 be the first Taylor coefficients of c in s:
// c(0), c'(0) L, c''(0) L^2 / 2, where p1 changes its sign backwards. As (1 - s)^3 = 1 - 3s + 3s^2...,
//
//   (2)  q0 = p0,  q1 = p1 + 3 p0,  q2 = p2 + 3 p1 + 6 p0
//
// and by Leibniz' rule, with r = 1 - s,
//
//   (3)  c'   = r^3 q' - 3 r^2 q
//   (4)  c''  = r^3 q'' - 6 r^2 q' + 6 r q
//   (5)  c''' = -9 r^2 q'' + 18 r q' - 6 q

namespace jounce {

Correction Correction::over_time(const Profile& profile, double start) {
  Correction c;
  c.kind_ = Kind::time;
  c.profile_ = profile;
  c.start_ = start;
  return c;
}

Correction Correction::over_master(const Jet& difference, double origin, double distance) {
  Correction c;
  c.kind_ = Kind::master;
  c.difference_ = difference;
  c.start_ = origin;
  c.distance_ = distance;
  return c;
}

/// Value and derivatives by master, u after the start.
Jet Correction::over_master(double u) const {
  const double L = distance_;
  const double sign = u < 0 ? -1 : 1;
  const double s = std::abs(u) / L;
  if (!(s < 1)) return {};
  const double p0 = difference_[0];
  const double p1 = sign * difference_[1] * L;
  const double p2 = difference_[2] * L * L / 2;
  const double q1 = p1 + 3 * p0;           // (2)
  const double q2 = p2 + 3 * p1 + 6 * p0;  // (2)
  const double q = p0 + s * (q1 + s * q2);
  const double dq = q1 + 2 * q2 * s;
  const double r = 1 - s;
  return {r * r * r * q,                                                   // (1)
          sign / L * (r * r * (r * dq - 3 * q)),                           // (3)
          r * (r * r * 2 * q2 - 6 * r * dq + 6 * q) / (L * L),             // (4)
          sign / (L * L * L) * (-18 * r * r * q2 + 18 * r * dq - 6 * q)};  // (5)
}

Jet Correction::jet(double t, const Jet& master) const {
  if (done(t, master[0])) return {};
  if (kind_ == Kind::master) return chained(over_master(master[0] - start_), master);
  const Motion now = profile_.at(t - start_);
  return {now.position, now.velocity, now.acceleration, now.jerk};
}

bool Correction::done(double t, double master) const {
  if (kind_ == Kind::time) return t - start_ >= profile_.duration();
  return kind_ == Kind::none || std::abs(master - start_) >= distance_;
}

}  // namespace jounce
