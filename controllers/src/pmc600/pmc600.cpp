// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/pmc600/pmc600.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "jounce/profiles/detail/ramps.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/sequences/splice.hpp"

// An edge of the velocity in the form of sin^2, of height dv and duration T, has the mean
// acceleration dv/T and the peak acceleration pi/2 dv/T:
//
//   (1)  sigmoid: T as in the trapezoid, mean = acceleration
//   (2)  sigmoid_limit: peak = acceleration, mean = 2/pi acceleration

namespace jounce::pmc600 {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double least_velocity = 0.001;  // u/s, of StartVel and EndSecondVel

/// One stretch of a move, between velocities in its direction at its ends.
struct Stretch {
  double from = 0, to = 0;
  double v0 = 0, v1 = 0;
  Dynamics dynamics;
  VelocityMode mode = VelocityMode::trapezoid;
};

Dynamics completed(Dynamics d, VelocityMode mode) {
  require_positive("velocity", d.velocity);
  require_positive("acceleration", d.acceleration);
  require_not_negative("deceleration", d.deceleration);
  if (d.deceleration == 0) d.deceleration = d.acceleration;
  if (mode != VelocityMode::quadratic) return d;
  require_positive("jerk", d.jerk);
  require_not_negative("deceleration_jerk", d.deceleration_jerk);
  if (d.deceleration_jerk == 0) d.deceleration_jerk = d.jerk;
  return d;
}

/// Calls use(up, down) with the laws of the mode.
template <class Use>
auto with_laws(const Dynamics& d, VelocityMode mode, Use use) {
  switch (mode) {
    case VelocityMode::sigmoid:  // (1)
      return use(profiles_detail::SineLaw{d.acceleration},
                 profiles_detail::SineLaw{d.deceleration});
    case VelocityMode::sigmoid_limit:  // (2)
      return use(profiles_detail::SineLaw{2 / pi * d.acceleration},
                 profiles_detail::SineLaw{2 / pi * d.deceleration});
    case VelocityMode::quadratic:
      return use(profiles_detail::JerkLaw{d.acceleration, d.jerk},
                 profiles_detail::JerkLaw{d.deceleration, d.deceleration_jerk});
    case VelocityMode::trapezoid:
      break;
  }
  return use(profiles_detail::JerkLaw{d.acceleration}, profiles_detail::JerkLaw{d.deceleration});
}

Trajectory made(const profiles_detail::RampedMove<profiles_detail::SineLaw>& move, double from,
                double to) {
  return profiles_detail::curve(move, from, to);
}
Trajectory made(const profiles_detail::RampedMove<profiles_detail::JerkLaw>& move, double from,
                double to) {
  return profiles_detail::profile(move, from, to).curve();
}

Trajectory curve(const Stretch& s) {
  return with_laws(s.dynamics, s.mode, [&](const auto& up, const auto& down) {
    const double h = std::abs(s.to - s.from);
    const auto move = profiles_detail::ramped(up, s.v0, down, s.v1, s.dynamics.velocity, h);
    if (!move)
      throw InputError("to", s.to,
                       "is too close to `from`: the move would be too short to compute");
    return made(*move, s.from, s.to);
  });
}

/// The greatest velocity that can be reached from rest over h, resp. from which h suffices to stop.
double reached_over(double h, const Dynamics& dynamics, VelocityMode mode, bool stopping) {
  return with_laws(dynamics, mode, [&](const auto& up, const auto& down) {
    const auto& law = stopping ? down : up;
    return profiles_detail::greatest(dynamics.velocity, h,
                                     [&](double v) { return distance(law, 0, v); });
  });
}

double joint_velocity(double h0, const Dynamics& first, double h1, const Dynamics& second,
                      VelocityMode mode) {
  if (h0 * h1 <= 0) return 0;
  return std::min(reached_over(std::abs(h0), first, mode, false),
                  reached_over(std::abs(h1), second, mode, true));
}

void require_end_velocity(const char* key, double v, double velocity) {
  if (!(v >= least_velocity)) throw InputError(key, v, "must be at least 0.001");
  if (v > velocity) throw InputError(key, v, "must not be above velocity = " + number(velocity));
}

/// The block's own value where it is not above the velocity.
double end_velocity(const char* key, double v, double velocity) {
  if (v == default_end_velocity) return std::min(v, velocity);
  require_end_velocity(key, v, velocity);
  return v;
}

void require_distance(const char* key, double from, double to) {
  require_finite("from", from);
  require_finite(key, to);
  if (from == to)
    throw InputError(
        key, to, "must differ from the position where the move begins: otherwise nothing moves");
}

}  // namespace

Trajectory move_absolute(double from, double to, const Dynamics& dynamics, VelocityMode mode) {
  require_distance("to", from, to);
  return curve({from, to, 0, 0, completed(dynamics, mode), mode});
}

Profile ls_move(const LsMove& move) {
  require_distance("to", move.from, move.to);
  const Dynamics r = completed({.velocity = move.velocity,
                                .acceleration = move.acceleration,
                                .deceleration = move.deceleration},
                               VelocityMode::trapezoid);
  const double v0 = end_velocity("start_velocity", move.start_velocity, move.velocity);
  const double v1 = end_velocity("end_second_velocity", move.end_second_velocity, move.velocity);
  const profiles_detail::JerkLaw up{r.acceleration};
  const profiles_detail::JerkLaw down{r.deceleration};
  const double h = std::abs(move.to - move.from);
  // From the lower of the two, the distance may not suffice for the higher one.
  const bool brakes = v0 > v1;
  const double low = std::min(v0, v1);
  const auto covered = [&](double dv) { return distance(brakes ? down : up, low, dv); };
  if (covered(std::abs(v1 - v0)) <= h)
    return profiles_detail::profile(*profiles_detail::ramped(up, v0, down, v1, r.velocity, h),
                                    move.from, move.to);
  const double dv = profiles_detail::greatest(std::abs(v1 - v0), h, covered);
  profiles_detail::RampedMove<profiles_detail::JerkLaw> ramp{up, down, low, low, 0, 0, 0};
  (brakes ? ramp.v0 : ramp.v1) += dv;
  (brakes ? ramp.dv1 : ramp.dv0) = dv;
  return profiles_detail::profile(ramp, move.from, move.to);
}

Profile ls_move_velocity(double from, double velocity, double acceleration, double start_velocity) {
  require_finite("velocity", velocity);
  if (velocity == 0) throw InputError("velocity", velocity, "must not be 0: nothing would move");
  const double v0 = end_velocity("start_velocity", start_velocity, std::abs(velocity));
  return velocity_ramp({from, std::copysign(v0, velocity), 0}, velocity,
                       Dynamics{.acceleration = acceleration});
}

Trajectory position_to_velocity(const PositionToVelocity& move) {
  const double joint = move.end_pos[0] + (move.relative ? move.from : 0);
  const double to = move.end_pos[1] + (move.relative ? joint : 0);
  require_distance("end_pos[1]", move.from, joint);
  require_distance("end_pos[2]", joint, to);
  const auto dynamics = [&](std::size_t i) {
    return completed({.velocity = move.velocity[i],
                      .acceleration = move.acceleration[i],
                      .deceleration = move.deceleration[i],
                      .jerk = move.jerk[i]},
                     move.mode);
  };
  const Dynamics first = dynamics(0);
  const Dynamics second = dynamics(1);
  const double v = joint_velocity(joint - move.from, first, to - joint, second, move.mode);
  return concatenated(curve({move.from, joint, 0, v, first, move.mode}),
                      curve({joint, to, v, 0, second, move.mode}));
}

}  // namespace jounce::pmc600
