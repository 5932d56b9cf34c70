// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/profiles/detail/ramps.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/detail/velocity_ramp.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/splice.hpp"

// A velocity ramp from (v0, a0) to (v1, 0). If a0 only falls to zero at jerk_end, the velocity
// changes by
//
//   (1)  f = a0 |a0| / (2 je)
//
// so s = sign(v1 - v0 - f) is the sign of the ramp's acceleration. With all quantities multiplied
// by s, the rest of the change is
//
//   (2)  dv = v1 - v0            if a0 > 0, and the acceleration rises on from a0
//        dv = v1 - v0 + a0^2/2je if a0 <= 0, after it has fallen to zero first, a0 = 0 then
//
// and a ramp a0 -> A -> 0 with rise at jb and fall at je changes the velocity by
//
//   (3)  dv = (A^2 - a0^2)/2jb + A^2/2je + A hold,   A <= the limit.
//
// If speeding up and slowing down have separate limits, an acceleration that leads past v1 first
// falls to zero, by (1), under the limits of the direction in which it acts. The rest is one ramp
// (3), or two ramps with a stop between them. An acceleration that slows the axis down and would
// reverse it falls until the axis stops, after
//
//   (4)  t = 2 |v0| / (|a0| + |a1|),   a1^2 = a0^2 - 2 je |v0|
//
// and its rest, a1, speeds the axis up.

namespace jounce {
namespace {

using profiles_detail::RampLimits;
using profiles_detail::rounded_root;

Dynamics completed(Dynamics d) {
  require_positive("acceleration", d.acceleration);
  require_not_negative("deceleration", d.deceleration);
  require_not_negative("jerk", d.jerk);
  require_not_negative("deceleration_jerk", d.deceleration_jerk);
  if (d.deceleration == 0) d.deceleration = d.acceleration;
  if (d.deceleration_jerk == 0) d.deceleration_jerk = d.jerk;
  if (d.jerk == 0 && d.deceleration_jerk > 0)
    throw InputError("jerk", d.jerk, "must be greater than 0 where deceleration_jerk is given");
  return d;
}

// ---- velocity ramps
// ------------------------------------------------------------------------------

/// Phases that are appended to a state, and the state at their end; order 2 or 3.
class Growing {
 public:
  Growing(const MotionState& from, int order) : profile_(from, order), now_(from) {}

  void add(double duration, double value) {
    if (!(duration > 0)) return;
    profile_.add(duration, value);
    const double jerk = profile_.order() == 3 ? value : 0;
    const double a = profile_.order() == 3 ? now_.acceleration : value;
    const double t = duration;
    now_.position += t * (now_.velocity + t * (a / 2 + t * jerk / 6));
    now_.velocity += t * (a + t * jerk / 2);
    now_.acceleration = a + t * jerk;
  }
  [[nodiscard]] const MotionState& now() const { return now_; }
  /// Sets the end velocity, which is known more exactly than as the sum of the phases.
  void reached(double velocity, double acceleration = 0) {
    now_ = {now_.position, velocity, acceleration};
  }
  [[nodiscard]] Profile finished() {
    profile_.finish(now_);
    return profile_;
  }

 private:
  Profile profile_;
  MotionState now_;
};

/// Keys with the prefix of the ramp; they are made, with an allocation, only for an error.
struct RampKeys {
  const char *acceleration, *jerk_begin, *jerk_end;
};

void require_valid(const RampKeys& keys, const RampLimits& limits, bool jerk_limited) {
  require_positive(keys.acceleration, limits.acceleration);
  for (const auto& [key, jerk] :
       {std::pair{keys.jerk_begin, limits.jerk_begin}, {keys.jerk_end, limits.jerk_end}}) {
    require_not_negative(key, jerk);
    if ((jerk > 0) != jerk_limited)
      throw InputError(key, jerk, "must be limited at both ends of both ramps, or at none");
  }
}

void require_valid(const RampLimits& up, const RampLimits& down) {
  const bool jerk = up.jerk_begin > 0;
  require_valid({"up.acceleration", "up.jerk_begin", "up.jerk_end"}, up, jerk);
  require_valid({"down.acceleration", "down.jerk_begin", "down.jerk_end"}, down, jerk);
  const bool same_ends = up.jerk_begin == up.jerk_end && down.jerk_begin == down.jerk_end;
  const bool same_ramps = up.jerk_begin == down.jerk_begin && up.jerk_end == down.jerk_end;
  if (!same_ends && !same_ramps)
    throw InputError(
        "down.jerk_end", down.jerk_end,
        "may differ from jerk_begin or from the jerk of the acceleration ramp, but not from both");
}

double fall_alone(double a0, const RampLimits& limits) {  // (1)
  return a0 * std::abs(a0) / (2 * limits.jerk_end);
}

/// Appends a ramp by (2), (3) to v1 with one set of limits.
void add_jerk_ramp(Growing& motion, double v1, const RampLimits& limits) {
  const auto [limit, jb, je] = limits;
  const double left = v1 - motion.now().velocity - fall_alone(motion.now().acceleration, limits);
  const double s = left < 0 ? -1 : 1;
  double a0 = s * motion.now().acceleration;
  double dv = s * (v1 - motion.now().velocity);
  if (a0 < 0) {
    motion.add(-a0 / je, s * je);
    dv += a0 * a0 / (2 * je);
    a0 = 0;
  }
  if (a0 > limit) {
    motion.add((a0 - limit) / je, -s * je);
    dv -= (a0 - limit) * (a0 + limit) / (2 * je);
    a0 = limit;
  }
  const double free = std::sqrt(std::max(0.0, (2 * dv + a0 * a0 / jb) / (1 / jb + 1 / je)));
  const double peak = std::clamp(free, a0, limit);
  const double edges = (peak - a0) * (peak + a0) / (2 * jb) + peak * peak / (2 * je);
  motion.add((peak - a0) / jb, s * jb);
  if (free > limit) motion.add((dv - edges) / limit, 0);
  motion.add(peak / je, -s * je);
  motion.reached(v1);
}

void add_step_ramp(Growing& motion, double v1, const RampLimits& limits) {
  const double dv = v1 - motion.now().velocity;
  motion.add(std::abs(dv) / limits.acceleration, std::copysign(limits.acceleration, dv));
  motion.reached(v1);
}

/// Appends a ramp to v1 in one direction.
void add_ramp(Growing& motion, double v1, const RampLimits& limits) {
  limits.jerk_end > 0 ? add_jerk_ramp(motion, v1, limits) : add_step_ramp(motion, v1, limits);
}

/// Appends the phase of (4), if it applies.
void add_fall_to_rest(Growing& motion, const RampLimits& down) {
  const auto [p, v0, a0] = motion.now();
  const double left = a0 * a0 - 2 * down.jerk_end * std::abs(v0);
  if (!(v0 * a0 < 0 && left > 0)) return;
  const double a1 = std::copysign(std::sqrt(left), a0);
  motion.add(2 * std::abs(v0) / std::abs(a0 + a1), -std::copysign(down.jerk_end, a0));
  motion.reached(0, a1);
}

/// Appends the fall of the present acceleration by (1), if the velocity would otherwise pass v1.
void add_fall(Growing& motion, double v1, const RampLimits& up, const RampLimits& down) {
  if (motion.now().acceleration == 0) return;
  add_fall_to_rest(motion, down);
  const auto [p, v0, a0] = motion.now();
  const RampLimits& own = a0 * v0 < 0 ? down : up;
  const double v = v0 + fall_alone(a0, own);
  if ((v1 - v) * a0 >= 0) return;
  motion.add(std::abs(a0) / own.jerk_end, -std::copysign(own.jerk_end, a0));
  motion.reached(v);
}

/// Appends a change to v1 from any state; speeding up and slowing down have separate limits.
void add_change(Growing& motion, double v1, const RampLimits& up, const RampLimits& down) {
  if (up == down) return add_ramp(motion, v1, up);
  add_fall(motion, v1, up, down);
  if (motion.now().velocity * v1 < 0) add_ramp(motion, 0, down);
  add_ramp(motion, v1, std::abs(v1) > std::abs(motion.now().velocity) ? up : down);
}

// ---- position moves in flight
// --------------------------------------------------------------------

/// The bounds by these dynamics for an axis that moves upwards (direction 1) or downwards (-1).
Bounds bounds(const Dynamics& d, double direction) {
  Bounds b = within(d.velocity, d.acceleration);
  if (d.jerk > 0) {
    b.jerk_max = std::max(d.jerk, d.deceleration_jerk);
    b.jerk_min = -b.jerk_max;
  }
  (direction > 0 ? b.acceleration_min : b.acceleration_max) =
      direction > 0 ? -d.deceleration : d.deceleration;
  return b;
}

Profile solved_change(const MoveResult& move) {
  if (!move)
    throw InputError("running", "", std::string("cannot be changed: ") + explain(move.status));
  return move.profile;
}

/// For two different jerks: a ramp to one velocity towards the target, and from there a ramp to
/// rest, each with its own jerk; or only the ramp to rest. nullopt if this does not end at the
/// target.
std::optional<Profile> in_two_ramps(const MotionState& from, double target, const Dynamics& d) {
  const RampLimits up{d.acceleration, d.jerk, d.jerk};
  const RampLimits down{d.deceleration, d.deceleration_jerk, d.deceleration_jerk};
  const double h = std::abs(target - from.position);
  const double s = target < from.position ? -1 : 1;
  const auto motion = [&](double peak, double cruise) {
    Growing result({0, s * from.velocity, s * from.acceleration}, 3);
    add_change(result, peak, up, down);
    result.add(cruise, 0);
    add_change(result, 0, up, down);
    return result;
  };
  const auto covered = [&](double peak) { return motion(peak, 0).now().position; };
  const double rounding = rounded_root * std::max({std::abs(from.position), std::abs(target), h});
  const auto made = [&](double peak, double cruise) {
    Growing result = motion(peak, cruise);
    return result.finished().scaled(s, from, {target, 0, 0});
  };
  if (from.velocity != 0 && std::abs(covered(0) - h) <= rounding) return made(0, 0);
  const double left_alone =
      s * from.velocity +
      fall_alone(s * from.acceleration, from.velocity * from.acceleration < 0 ? down : up);
  if (s * from.velocity < 0 || left_alone < 0) return std::nullopt;
  // Below the velocity at which the acceleration alone falls to zero, the distance does not
  // increase with the peak.
  const double low = std::min(left_alone, d.velocity);
  if (covered(low) > h + rounding) return std::nullopt;
  const double rise =
      profiles_detail::greatest(d.velocity - low, h, [&](double x) { return covered(low + x); });
  const double rest = h - covered(low + rise);
  return made(low + rise, rest > rounding ? rest / (low + rise) : 0);
}

/// A motion from a state to rest at the target: one profile, or two if the axis must reverse.
std::vector<Profile> approach(const MotionState& from, double target, const Dynamics& d) {
  if (d.jerk != d.deceleration_jerk)
    if (const auto profile = in_two_ramps(from, target, d)) return {*profile};
  const double heading = from.velocity != 0 ? from.velocity : target - from.position;
  const double direction = heading < 0 ? -1 : 1;
  const Bounds limits = bounds(d, direction);
  const MotionState to{target, 0, 0};
  if (d.acceleration == d.deceleration) return {solved_change(move_to(from, to, limits))};
  Profile halt = solved_change(stop(from, limits));
  const double rest = halt.end().position;
  const double beyond = (target - rest) * direction;
  const double rounding =
      rounded_root * std::max({std::abs(from.position), std::abs(target), std::abs(rest)});
  if (beyond > rounding) return {solved_change(move_to(from, to, limits))};
  if (beyond < -rounding) return {halt, point_to_point(rest, target, d)};
  halt.finish(to);
  return {halt};
}

}  // namespace

Profile point_to_point(double from, double to, const Dynamics& dynamics) {
  const Dynamics d = completed(dynamics);
  if (d.jerk == 0) return trapezoid({from, to, d.velocity, d.acceleration, d.deceleration});
  return s_curve(
      {from, to, d.velocity, d.acceleration, d.deceleration, d.jerk, d.deceleration_jerk});
}

Profile profiles_detail::velocity_ramp(const MotionState& from, double velocity,
                                       const RampLimits& up, const RampLimits& down) {
  require_finite("from.position", from.position);
  require_finite("from.velocity", from.velocity);
  require_finite("from.acceleration", from.acceleration);
  require_finite("velocity", velocity);
  require_valid(up, down);
  const bool jerk = up.jerk_begin > 0;
  MotionState start = from;
  if (!jerk) start.acceleration = 0;
  Growing motion(start, jerk ? 3 : 2);
  add_change(motion, velocity, up, down);
  if (!std::isfinite(motion.now().position) || !std::isfinite(motion.finished().duration()))
    throw InputError("velocity", velocity,
                     "cannot be reached: the time or the position would not be finite");
  return motion.finished();
}

Profile velocity_ramp(const MotionState& from, double velocity, const Dynamics& dynamics) {
  const Dynamics d = completed(dynamics);
  return profiles_detail::velocity_ramp(from, velocity, {d.acceleration, d.jerk, d.jerk},
                                        {d.deceleration, d.deceleration_jerk, d.deceleration_jerk});
}

Trajectory with_target(const Trajectory& running, double t, double target,
                       const Dynamics& dynamics) {
  require_positive("velocity", dynamics.velocity);
  require_finite("target", target);
  const Dynamics d = completed(dynamics);
  return spliced(running, t, approach(state_for(running, t, d.jerk), target, d));
}

Trajectory with_velocity(const Trajectory& running, double t, double velocity,
                         const Dynamics& dynamics) {
  return spliced(running, t,
                 velocity_ramp(state_for(running, t, dynamics.jerk), velocity, dynamics));
}

}  // namespace jounce
