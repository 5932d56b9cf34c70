// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/solver/velocity_change.hpp"

#include <algorithm>
#include <cmath>

// Up: the acceleration rises to z, is held for h and falls. With jp and jd its rise and fall,
//
//   (1)  v1 - v0 = (z^2 - a0^2)/(2 jp) + (z^2 - a1^2)/(2 jd) + z h
//
// The acceleration goes up if the bare ramp from a0 to a1 ends below v1; down is the mirror image.
// Without a hold, (1) gives z^2 - a0^2 and z^2 - a1^2 without z. This is needed because z may agree
// with a0 or a1 to its last digits if the jerks are far apart.

namespace jounce::profiles_detail {
namespace {

/// z - a, computed from z^2 - a^2.
double difference(double z, double a, double squares) {
  return z * a > 0 ? squares / (z + a) : z - a;
}

}  // namespace

VelocityChange::VelocityChange(const MotionState& from, double velocity, double acceleration,
                               const Bounds& b) noexcept {
  const double a0 = from.acceleration;
  const double a1 = acceleration;
  const double dv = velocity - from.velocity;
  const double ramp = (a1 - a0) * (a1 + a0) / (2 * (a1 > a0 ? b.jerk_max : b.jerk_min));
  const double scale = std::abs(velocity) + std::abs(from.velocity) + std::abs(ramp);
  const bool up = dv >= ramp;
  const double jp = up ? b.jerk_max : b.jerk_min;
  const double jd = up ? b.jerk_min : b.jerk_max;
  if (std::abs(dv - ramp) <= 0x1p-49 * scale) {  // to rounding, the change is that of the ramp
    first_ = (a1 - a0) / jp;
    last_ = (a1 - a0) / jd;
  } else {
    const double limit = up ? b.acceleration_max : b.acceleration_min;
    const double k = 1 / jp - 1 / jd;
    const double squares = (a0 - a1) * (a0 + a1);
    double from_a0 = (2 * dv + squares / jd) / k;  // z^2 - a0^2
    double from_a1 = (2 * dv + squares / jp) / k;
    double z = std::sqrt((2 * dv + a0 * a0 / jp - a1 * a1 / jd) / k);
    if (z > std::abs(limit)) {
      z = std::abs(limit);
      from_a0 = (z - a0) * (z + a0);
      from_a1 = (z - a1) * (z + a1);
      hold_ = (dv - from_a0 / (2 * jp) + from_a1 / (2 * jd)) / limit;
    }
    z = up ? z : -z;
    first_ = difference(z, a0, from_a0) / jp;
    last_ = -difference(z, a1, from_a1) / jd;
  }
  first_ = std::max(first_, 0.0);
  hold_ = std::max(hold_, 0.0);
  last_ = std::max(last_, 0.0);
  first_jerk_ = jp;
  last_jerk_ = jd;
  const double a = a0 + first_ * jp;
  const double v = from.velocity + first_ * (a0 + first_ * jp / 2);
  const double held = v + hold_ * a;
  distance_ = first_ * (from.velocity + first_ * (a0 / 2 + first_ * (jp / 6))) +
              hold_ * (v + held) / 2 + last_ * (held + last_ * (a / 2 + last_ * (jd / 6)));
}

void VelocityChange::append(Profile& out) const noexcept {
  out.add(first_, first_jerk_);
  out.add(hold_, 0);
  out.add(last_, last_jerk_);
}

MotionState change_velocity(const MotionState& from, double velocity, double acceleration,
                            const Bounds& b, Profile& profile) noexcept {
  const VelocityChange change(from, velocity, acceleration, b);
  change.append(profile);
  return {from.position + change.distance(), velocity, acceleration};
}

}  // namespace jounce::profiles_detail
