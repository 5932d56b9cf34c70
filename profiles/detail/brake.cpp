#include "jounce/profiles/detail/brake.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/velocity_change.hpp"

namespace jounce::detail {
namespace {

/// A violation by less than this share of the limit is rounding, not a violation.
constexpr double forgiven = 1e-13;

MotionState after(Profile& profile, const MotionState& s, double t, double jerk) {
  profile.add(t, jerk);
  return {s.position + t * (s.velocity + t * (s.acceleration / 2 + t * (jerk / 6))),
          s.velocity + t * (s.acceleration + t * (jerk / 2)), s.acceleration + t * jerk};
}

/// The acceleration inside its limits, at once.
MotionState limited(const MotionState& s, const Bounds& b, Profile& profile) {
  const double a = std::clamp(s.acceleration, b.acceleration_min, b.acceleration_max);
  if (a == s.acceleration) return s;
  const double jerk = a < s.acceleration ? b.jerk_min : b.jerk_max;
  MotionState inside = after(profile, s, (a - s.acceleration) / jerk, jerk);
  inside.acceleration = a;
  return inside;
}

/// The greatest acceleration with which the violated velocity limit may be passed, so that the other
/// one can be kept: towards the inside, signed.
double entry(const MotionState& s, const Bounds& b, bool above) {
  const double width = b.velocity_max - b.velocity_min;
  const double limit = above ? b.velocity_max : b.velocity_min;
  const double jerk = above ? b.jerk_min : b.jerk_max;  // towards the inside
  const double back = above ? b.jerk_max : b.jerk_min;  // out of it
  const double most = above ? b.acceleration_min : b.acceleration_max;
  // What the bare ramp arrives with: as if it had set out from zero acceleration.
  const double top = s.velocity - s.acceleration * s.acceleration / (2 * jerk);
  const double arrives = std::sqrt(std::max(2 * jerk * (limit - top), 0.0));
  const double stops = std::sqrt(2 * std::abs(back) * width);
  return std::copysign(std::min({arrives, std::abs(most), stops}), jerk);
}

}  // namespace

bool is_inside(const MotionState& s, const Bounds& b, double tolerance) noexcept {
  const double v = s.velocity;
  const double a = s.acceleration;
  const double more = 1 + tolerance;
  if (a > b.acceleration_max * more || a < b.acceleration_min * more) return false;
  const double top = b.velocity_max * more;
  const double bottom = b.velocity_min * more;
  if (v > top || v < bottom) return false;
  // Where the acceleration comes to zero, without a division:
  return a > 0 ? a * a <= 2 * -b.jerk_min * (top - v) : a * a <= 2 * b.jerk_max * (v - bottom);
}

double natural_velocity(const MotionState& s, const Bounds& b) noexcept {
  if (s.acceleration == 0) return s.velocity;
  const double jerk = s.acceleration > 0 ? b.jerk_min : b.jerk_max;
  return s.velocity - s.acceleration * s.acceleration / (2 * jerk);
}

MotionState brought_inside(const MotionState& from, const Bounds& b, Return way,
                           Profile& profile) noexcept {
  MotionState s = from;
  if (is_inside(s, b, forgiven)) {
    s.acceleration = std::clamp(s.acceleration, b.acceleration_min, b.acceleration_max);
    return s;
  }
  s = limited(s, b, profile);
  // Twice at most: a velocity that falls too fast to be held passes the other limit first.
  for (int i = 0; i < 2 && !is_inside(s, b, forgiven); ++i) {
    const bool above =
        s.velocity > b.velocity_max || (s.velocity >= b.velocity_min && s.acceleration > 0);
    const double limit = above ? b.velocity_max : b.velocity_min;
    const double a = way == Return::level ? 0 : entry(s, b, above);
    // An acceleration that carries the velocity through the limit whatever is done is raised on the
    // way, until it is there.
    const double out = above ? b.jerk_max : b.jerk_min;
    const double ramp = (a - s.acceleration) * (a + s.acceleration) / (2 * out);
    const bool too_steep = above ? s.acceleration < a && s.velocity + ramp < limit
                                 : s.acceleration > a && s.velocity + ramp > limit;
    if (too_steep) {
      const double square = s.acceleration * s.acceleration;
      const double left = square - 2 * out * (s.velocity - limit);
      // What is left by rounding alone is nothing: its root would not be small.
      const bool is_left = left > 0x1p-48 * (square + std::abs(out * limit));
      const double at_limit = is_left ? std::copysign(std::sqrt(left), s.acceleration) : 0;
      s = after(profile, s, (at_limit - s.acceleration) / out, out);
      s.velocity = limit;
      s.acceleration = at_limit;
    } else {
      s = change_velocity(s, limit, a, b, profile);
    }
  }
  return s;
}

}  // namespace jounce::detail
