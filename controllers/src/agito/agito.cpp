// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/agito/agito.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "controllers/src/milliseconds.hpp"

namespace jounce::agito {
namespace {

using controllers_detail::ms;

void require_rate(const char* key, double value) {
  if (!(value >= 100 && value <= 2e9))
    throw InputError(key, value, "must be at least 100 and at most 2000000000");
}

void require_speed(const char* key, double value) {
  if (!(std::abs(value) <= 60'000'000))
    throw InputError(key, value, "must be at least -60000000 and at most 60000000");
  if (value == 0) throw InputError(key, value, "must not be 0: nothing would move");
}

void set_jerks(Dynamics& d, int exponent) {
  const double time = jerk_time(exponent);
  if (time == 0) return;
  d.jerk = d.acceleration / time;
  d.deceleration_jerk = d.deceleration / time;
}

/// Dynamics of Stop: Accel applies only while an acceleration is in force, and if it is given.
Dynamics stopping(const Settings& settings) {
  require_rate("decel", settings.decel);
  if (settings.accel != 0) require_rate("accel", settings.accel);
  Dynamics d{.acceleration = settings.accel != 0 ? settings.accel : settings.decel,
             .deceleration = settings.decel};
  set_jerks(d, settings.jerk);
  return d;
}

}  // namespace

double jerk_time(int jerk) {
  if (jerk < 0 || jerk > 9) throw InputError("jerk", jerk, "must be between 0 and 9");
  return jerk == 0 ? 0 : std::ldexp(sample_time, jerk);
}

double resolved(const Target& target, double position) {
  return target.rel_trgt != 0 ? position + target.rel_trgt : target.abs_trgt;
}

Dynamics dynamics(const Settings& settings) {
  require_rate("accel", settings.accel);
  require_rate("decel", settings.decel);
  require_speed("speed", settings.speed);
  Dynamics d{.velocity = std::abs(settings.speed),
             .acceleration = settings.accel,
             .deceleration = settings.decel};
  set_jerks(d, settings.jerk);
  return d;
}

Profile begin(double position, const Target& target, const Settings& settings) {
  return point_to_point(position, resolved(target, position), dynamics(settings));
}

Trajectory begin(const Trajectory& running, double t, const Target& target,
                 const Settings& settings) {
  return with_target(running, t, resolved(target, state_at(running, t).position),
                     dynamics(settings));
}

Profile jog(const MotionState& from, const Settings& settings) {
  return velocity_ramp(from, settings.speed, dynamics(settings));
}

Trajectory stop(const Trajectory& running, double t, const Settings& settings) {
  return with_velocity(running, t, 0, stopping(settings));
}

Trajectory repetitive(double position, const Target& target, const Settings& settings, int strokes,
                      double rpt_wait) {
  require_not_negative("rpt_wait", rpt_wait);
  if (strokes < 1) throw InputError("strokes", strokes, "must be at least 1");
  const double far = resolved(target, position);
  const Trajectory out = point_to_point(position, far, dynamics(settings)).curve();
  const Trajectory back = point_to_point(far, position, dynamics(settings)).curve();
  std::vector<Segment> segments;
  for (int i = 0; i < strokes; ++i) {
    const Trajectory& stroke = i % 2 == 0 ? out : back;
    const double here = i % 2 == 0 ? position : far;
    if (i > 0 && rpt_wait > 0) segments.push_back(line(rpt_wait * ms, here, here));
    segments.insert(segments.end(), stroke.segments().begin(), stroke.segments().end());
  }
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

// A trapezoid over the stroke 2 A whose two halves last 1/4F each and just touch the speed:
//   2 A = Speed / 4F  and  Speed = Accel / 4F,  so  Speed = 8 A F  and  Accel = 32 A F^2.
Settings quasi_sine(double amplitude, double frequency) {
  require_positive("amplitude", amplitude);
  require_positive("frequency", frequency);
  const double accel = 32 * amplitude * frequency * frequency;
  return {.accel = accel, .decel = accel, .speed = 8 * amplitude * frequency};
}

Trajectory with_speed_change(const Trajectory& running, double target, const Settings& settings,
                             const SpeedChange& change) {
  require_finite("position", change.position);
  require_speed("new_speed", change.new_speed);
  if (std::abs(change.direction) > 1)
    throw InputError("direction", change.direction, "must be 1, -1 or 0");
  Settings changed = settings;
  changed.speed = change.new_speed;
  for (const double t : crossings(running, 0, change.position)) {
    const double v = state_at(running, t).velocity;
    if (v != 0 && v * change.direction >= 0)
      return with_target(running, t, target, dynamics(changed));
  }
  return running;
}

}  // namespace jounce::agito
