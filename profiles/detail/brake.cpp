#include "jounce/profiles/detail/brake.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::detail {
namespace {

/// A violation by less than this share of the limit is rounding, not a violation.
constexpr double forgiven = 1e-13;

MotionState advance(Profile& profile, const MotionState& s, double t, double jerk) {
  if (!(t > 0)) return s;
  profile.add(t, jerk);
  return {s.position + t * (s.velocity + t * (s.acceleration / 2 + t * (jerk / 6))),
          s.velocity + t * (s.acceleration + t * (jerk / 2)), s.acceleration + t * jerk};
}

MotionState mirrored(const MotionState& s) {
  return {-s.position, -s.velocity, -s.acceleration};
}

/// Bounds towards a violated upper velocity (or, with sign -1, its mirror image), as magnitudes.
struct Seen {
  double sign;
  double vmax, vmin, fall, jerk_up, jerk_down;
};

/// From a velocity that is, or cannot but become, greater than vmax: down to vmax and no lower
/// than that the lower limit can be kept afterwards.
MotionState down(Profile& profile, const MotionState& from, const Seen& b) {
  MotionState s = b.sign > 0 ? from : mirrored(from);
  const double floor = std::min(b.fall, std::sqrt(2 * b.jerk_up * (b.vmax - b.vmin)));
  if (s.acceleration < -floor) {  // too steep for the lower limit: level out first
    s = advance(profile, from, -s.acceleration / b.jerk_up, b.sign * b.jerk_up);
    return {s.position, s.velocity, 0};
  }
  // As if from zero acceleration at this velocity:
  const double top = s.velocity + s.acceleration * s.acceleration / (2 * b.jerk_down);
  const double z = std::min(std::sqrt(2 * b.jerk_down * (top - b.vmax)), floor);
  s = advance(profile, from, (s.acceleration + z) / b.jerk_down, -b.sign * b.jerk_down);
  const double rest = top - b.vmax - z * z / (2 * b.jerk_down);
  s = advance(profile, s, rest / z, 0);
  return {s.position, b.sign * b.vmax, -b.sign * z};
}

}  // namespace

double natural_velocity(const MotionState& s, const Bounds& b) noexcept {
  if (s.acceleration == 0) return s.velocity;
  const double jerk = s.acceleration > 0 ? b.jerk_min : b.jerk_max;
  return s.velocity - s.acceleration * s.acceleration / (2 * jerk);
}

bool is_inside(const MotionState& s, const Bounds& b, double tolerance) noexcept {
  const double v = s.velocity;
  const double a = s.acceleration;
  const double more = 1 + tolerance;
  if (a > b.acceleration_max * more || a < b.acceleration_min * more) return false;
  const double top = b.velocity_max * more;
  const double bottom = b.velocity_min * more;
  if (v > top || v < bottom) return false;
  // natural_velocity(), without its division
  return a > 0 ? a * a <= 2 * -b.jerk_min * (top - v) : a * a <= 2 * b.jerk_max * (v - bottom);
}

MotionState brought_inside(const MotionState& from, const Bounds& b, Profile& profile) noexcept {
  MotionState s = from;
  if (is_inside(s, b, forgiven)) {
    s.acceleration = std::clamp(s.acceleration, b.acceleration_min, b.acceleration_max);
    return s;
  }
  if (s.acceleration > b.acceleration_max) {
    s = advance(profile, s, (s.acceleration - b.acceleration_max) / -b.jerk_min, b.jerk_min);
  } else if (s.acceleration < b.acceleration_min) {
    s = advance(profile, s, (b.acceleration_min - s.acceleration) / b.jerk_max, b.jerk_max);
  }
  s.acceleration = std::clamp(s.acceleration, b.acceleration_min, b.acceleration_max);
  // Twice at most: once to level out, then to come inside.
  for (int i = 0; i < 3 && !is_inside(s, b, forgiven); ++i) {
    if (std::max(s.velocity, natural_velocity(s, b)) > b.velocity_max)
      s = down(profile, s, {1, b.velocity_max, b.velocity_min, -b.acceleration_min, b.jerk_max,
                            -b.jerk_min});
    else
      s = down(profile, s, {-1, -b.velocity_min, -b.velocity_max, b.acceleration_max, -b.jerk_min,
                            b.jerk_max});
  }
  return s;
}

}  // namespace jounce::detail
