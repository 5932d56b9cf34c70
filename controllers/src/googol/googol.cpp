// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/googol/googol.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "jounce/profiles/detail/ascending.hpp"
#include "jounce/profiles/detail/ramps.hpp"
#include "jounce/profiles/detail/velocity_ramp.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/sequences/splice.hpp"

// A ramp that changes the velocity by dv, with `percent` of smoothing, p = percent/100, and the
// peak acceleration A (manual 7.7.1). T is its duration, ta that of each jerk phase, te that of
// constant acceleration:
//
//   (1)  T = dv / (A (1 - p/2)),   ta = p T / 2,   te = (1 - p) T
//   (2)  jerk = A / ta = 2 A^2 (1 - p/2) / (p dv)

namespace jounce::googol {
namespace {

void require_move(double from, std::int64_t pos, double vel, double acc, double dec) {
  require_finite("from", from);
  if (pos < -max_position || pos > max_position)
    throw InputError("pos", std::to_string(pos),
                     "must be between -1 073 741 823 and 1 073 741 823");
  require_positive("vel", vel);
  require_positive("acc", acc);
  require_not_negative("dec", dec);
}

void require_distance(double from, std::int64_t pos) {
  if (static_cast<double>(pos) == from)
    throw InputError("pos", std::to_string(pos),
                     "must differ from `from` = " + number(from) + ": there is no move");
}

void require_percent(const char* key, int percent) {
  if (percent < 0 || percent > 100) throw InputError(key, percent, "must be between 0 and 100");
}

/// A speed in the direction of the move, at one of its ends.
void require_end_speed(const char* key, double speed, double vel) {
  require_not_negative(key, speed);
  if (speed > vel) throw InputError(key, speed, "must not be above vel = " + number(vel));
}

double or_else(double value, double fallback) {
  return value == 0 ? fallback : value;
}

double share_jerk(double acc, double share, double dv) {  // (2)
  return share > 0 && dv > 0 ? 2 * acc * acc * (1 - share / 2) / (share * dv) : 0;
}

Dynamics dynamics(const Trap& move) {
  require_move(move.from, move.pos, move.vel, move.acc, move.dec);
  if (move.smooth_time < 0 || move.smooth_time > 50)
    throw InputError("smooth_time", std::to_string(move.smooth_time) + " ms",
                     "must be between 0 and 50 ms");
  Dynamics d{
      .velocity = move.vel, .acceleration = move.acc, .deceleration = or_else(move.dec, move.acc)};
  if (move.smooth_time > 0) {
    d.jerk = d.acceleration / move.smooth_time;
    d.deceleration_jerk = d.deceleration / move.smooth_time;
  }
  return d;
}

Dynamics dynamics(const MoveAbsolute& move) {
  require_move(move.from, move.pos, move.vel, move.acc, move.dec);
  require_percent("percent", move.percent);
  const double share = move.percent / 100.0;
  const double dec = or_else(move.dec, move.acc);
  return {.velocity = move.vel,
          .acceleration = move.acc,
          .deceleration = dec,
          .jerk = share_jerk(move.acc, share, move.vel),
          .deceleration_jerk = share_jerk(dec, share, move.vel)};
}

/// From v0 to v1 at the two ends, in the direction of the move; refused where the distance does not
/// suffice.
template <class Law>
Profile ramped(double from, std::int64_t pos, const Law& up, double v0, const Law& down, double v1,
               double vel, const char* key) {
  const auto to = static_cast<double>(pos);
  const auto move = profiles_detail::ramped(up, v0, down, v1, vel, std::abs(to - from));
  if (!move)
    throw InputError(key, std::max(v0, v1),
                     "cannot be brought to the speed at the other end over this distance");
  return profiles_detail::profile(*move, from, to);
}

void require_valid(const Jog& parameters) {
  require_positive("acc", parameters.acc);
  require_not_negative("dec", parameters.dec);
  if (!(parameters.smooth >= 0 && parameters.smooth < 1))
    throw InputError("smooth", parameters.smooth, "must be at least 0 and below 1");
}

}  // namespace

Profile trap(const Trap& move) {
  const Dynamics d = dynamics(move);
  require_distance(move.from, move.pos);
  require_end_speed("vel_start", move.vel_start, move.vel);
  if (move.vel_start == 0) return point_to_point(move.from, static_cast<double>(move.pos), d);
  constexpr double step = std::numeric_limits<double>::infinity();
  const profiles_detail::JerkLaw up{d.acceleration, or_else(d.jerk, step)};
  const profiles_detail::JerkLaw down{d.deceleration, or_else(d.deceleration_jerk, step)};
  return ramped(move.from, move.pos, up, move.vel_start, down, 0, move.vel, "vel_start");
}

Trajectory trap(const Trajectory& running, double t, const Trap& move) {
  return with_target(running, t, static_cast<double>(move.pos), dynamics(move));
}

// A ramp through rest consists of two, each with its own share. One that begins in the middle of
// another must not take its jerk from what little may be left of it.
Profile jog(const MotionState& from, double vel, const Jog& parameters) {
  require_valid(parameters);
  const double v = from.velocity;
  const bool turns = v * vel < 0;
  double dv_up = std::abs(turns ? vel : vel - v);
  double dv_down = std::abs(turns ? v : vel - v);
  if (from.acceleration != 0) dv_up = dv_down = std::max(std::abs(v), std::abs(vel));
  const double dec = or_else(parameters.dec, parameters.acc);
  const double up = share_jerk(parameters.acc, parameters.smooth, dv_up);
  const double down = share_jerk(dec, parameters.smooth, dv_down);
  return velocity_ramp(from, vel,
                       Dynamics{.acceleration = parameters.acc,
                                .deceleration = dec,
                                .jerk = up,
                                .deceleration_jerk = down});
}

Trajectory jog(double from, std::span<const JogVelocity> velocities, const Jog& parameters) {
  if (velocities.empty())
    throw InputError("velocities", "", "is missing: a jog needs at least one velocity");
  require_finite("velocities[1].vel", velocities[0].vel);
  if (velocities[0].vel == 0)
    throw InputError("velocities[1].vel", 0, "must not be 0: nothing moves before it");
  profiles_detail::require_ascending("velocities", velocities);
  Trajectory running = jog({from, 0, 0}, velocities[0].vel, parameters).curve();
  running = shifted(running, velocities[0].time);
  for (const auto& [time, vel] : velocities.subspan(1))
    running = spliced(running, time, jog(state_at(running, time), vel, parameters));
  return running;
}

Profile move_absolute(const MoveAbsolute& move) {
  return move_absolute_ex({.from = move.from,
                           .pos = move.pos,
                           .vel = move.vel,
                           .acc = move.acc,
                           .dec = move.dec,
                           .percent = move.percent});
}

Trajectory move_absolute(const Trajectory& running, double t, const MoveAbsolute& move) {
  return with_target(running, t, static_cast<double>(move.pos), dynamics(move));
}

Profile move_absolute_ex(const MoveAbsoluteEx& move) {
  require_move(move.from, move.pos, move.vel, move.acc, move.dec);
  require_distance(move.from, move.pos);
  require_percent("percent", move.percent);
  require_percent("acc_start_percent", move.acc_start_percent);
  require_percent("dec_end_percent", move.dec_end_percent);
  require_end_speed("vel_start", move.vel_start, move.vel);
  require_end_speed("vel_end", move.vel_end, move.vel);
  const double share = move.percent / 100.0;
  const profiles_detail::ShareLaw up{move.acc, share, move.acc_start_percent / 100.0};
  const profiles_detail::ShareLaw down{or_else(move.dec, move.acc), share,
                                       move.dec_end_percent / 100.0};
  return ramped(move.from, move.pos, up, move.vel_start, down, move.vel_end, move.vel, "vel_end");
}

Profile move_velocity(const MotionState& from, const MoveVelocity& move) {
  require_finite("vel", move.vel);
  require_positive("acc", move.acc);
  require_not_negative("dec", move.dec);
  require_positive("jerk_begin", move.jerk_begin);
  require_positive("jerk_end", move.jerk_end);
  const bool down = move.direction == Direction::negative ||
                    (move.direction == Direction::current && from.velocity < 0);
  return profiles_detail::velocity_ramp(
      from, down ? -move.vel : move.vel, {move.acc, move.jerk_begin, move.jerk_end},
      {or_else(move.dec, move.acc), move.jerk_begin, move.jerk_end});
}

Trajectory move_velocity(const Trajectory& running, double t, const MoveVelocity& move) {
  return spliced(running, t, move_velocity(state_for(running, t, move.jerk_begin), move));
}

}  // namespace jounce::googol
