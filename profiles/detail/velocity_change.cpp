#include "jounce/profiles/detail/velocity_change.hpp"

#include <cmath>

// Up: the acceleration rises to z, is held for h and falls. With jp and jd its rise and fall,
//
//   (1)  v1 - v0 = (z^2 - a0^2)/(2 jp) + (z^2 - a1^2)/(2 jd) + z h
//
// It goes up if the bare ramp from a0 to a1 ends below v1; down is the mirror image. Without a hold, (1)
// gives z^2 - a0^2 and z^2 - a1^2 without z: where the jerks are far apart, z may agree with one of both to
// its last digits.

namespace jounce::detail {
namespace {

/// z - a, given z^2 - a^2.
double difference(double z, double a, double squares) {
  return z * a > 0 ? squares / (z + a) : z - a;
}

}  // namespace

MotionState change_velocity(const MotionState& from, double velocity, double acceleration,
                            const Bounds& b, Profile& profile) noexcept {
  const double a0 = from.acceleration;
  const double a1 = acceleration;
  const double dv = velocity - from.velocity;
  const double ramp = (a1 - a0) * (a1 + a0) / (2 * (a1 > a0 ? b.jerk_max : b.jerk_min));
  const double scale = std::abs(velocity) + std::abs(from.velocity) + std::abs(ramp);
  double t1 = 0;
  double hold = 0;
  double t2 = 0;
  const bool up = dv >= ramp;
  const double jp = up ? b.jerk_max : b.jerk_min;
  const double jd = up ? b.jerk_min : b.jerk_max;
  if (std::abs(dv - ramp) <= 0x1p-49 * scale) {  // rounding alone keeps it from being the ramp
    t1 = (a1 - a0) / jp;
    t2 = (a1 - a0) / jd;
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
      hold = (dv - from_a0 / (2 * jp) + from_a1 / (2 * jd)) / limit;
    }
    z = up ? z : -z;
    t1 = difference(z, a0, from_a0) / jp;
    t2 = -difference(z, a1, from_a1) / jd;
  }
  MotionState s = from;
  const double times[] = {t1, hold, t2};
  const double jerks[] = {jp, 0, jd};
  for (int i = 0; i < 3; ++i) {
    const double t = times[i];
    if (!(t > 0)) continue;
    profile.add(t, jerks[i]);
    s.position += t * (s.velocity + t * (s.acceleration / 2 + t * (jerks[i] / 6)));
    s.velocity += t * (s.acceleration + t * (jerks[i] / 2));
    s.acceleration += t * jerks[i];
  }
  return {s.position, velocity, acceleration};
}

}  // namespace jounce::detail
