// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/himc/himc.hpp"

#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "controllers/src/milliseconds.hpp"

namespace jounce::himc {
namespace {

using controllers_detail::ms;

void require_valid(const AxisProfile& axis) {
  require_positive("velocity", axis.velocity);
  for (const auto& [key, value] : {std::pair{"acceleration", axis.acceleration},
                                   {"acceleration_time", axis.acceleration_time},
                                   {"deceleration", axis.deceleration},
                                   {"deceleration_time", axis.deceleration_time}})
    require_not_negative(key, value);
  if (axis.acceleration > 0 && axis.acceleration_time > 0)
    throw InputError("acceleration", axis.acceleration,
                     "cannot be combined with acceleration_time: give one of the two");
  if (!(axis.acceleration > 0 || axis.acceleration_time > 0))
    throw InputError("acceleration", axis.acceleration,
                     "must be greater than 0: give it, or acceleration_time");
  if (axis.deceleration > 0 && axis.deceleration_time > 0)
    throw InputError("deceleration", axis.deceleration,
                     "must not be given together with deceleration_time");
  if (!(axis.smoothing_time >= 0 && axis.smoothing_time <= 500))
    throw InputError("smoothing_time", axis.smoothing_time, "must be between 0 and 500 ms");
  if (!(axis.velocity_scale > 0 && axis.velocity_scale <= 100))
    throw InputError("velocity_scale", axis.velocity_scale, "must be above 0, and at most 100 %");
}

double rate(double given, double time, double velocity) {
  return time > 0 ? velocity / (time * ms) : given;
}

double signed_velocity(int direction, const Dynamics& d) {
  if (direction != 1 && direction != -1)
    throw InputError("direction", direction, "must be 1 or -1");
  return direction * d.velocity;
}

/// A number of a filter within [least, most], and the error of the controller where it is not.
void require_within(const char* key, double value, double least, double most,
                    const std::string& filter, const char* error) {
  if (value >= least && value <= most) return;
  throw InputError(key, value,
                   "must be from " + number(least) + " to " + number(most) + " for " + filter +
                       " (HIMC error " + error + ")");
}

}  // namespace

Dynamics dynamics(const AxisProfile& axis) {
  require_valid(axis);
  Dynamics d;
  d.velocity = axis.velocity * (axis.velocity_scale / 100);
  d.acceleration = rate(axis.acceleration, axis.acceleration_time, axis.velocity);
  d.deceleration = rate(axis.deceleration, axis.deceleration_time, axis.velocity);
  if (d.deceleration == 0) d.deceleration = d.acceleration;
  if (axis.smoothing_time > 0) {
    d.jerk = d.acceleration / (axis.smoothing_time * ms);
    d.deceleration_jerk = d.deceleration / (axis.smoothing_time * ms);
  }
  return d;
}

Profile move_abs(double from, double to, const AxisProfile& axis) {
  return point_to_point(from, to, dynamics(axis));
}

Trajectory move_abs(const Trajectory& running, double t, double to, const AxisProfile& axis) {
  return with_target(running, t, to, dynamics(axis));
}

Profile move_vel(const MotionState& from, int direction, const AxisProfile& axis) {
  const Dynamics d = dynamics(axis);
  return velocity_ramp(from, signed_velocity(direction, d), d);
}

Trajectory move_vel(const Trajectory& running, double t, int direction, const AxisProfile& axis) {
  const Dynamics d = dynamics(axis);
  return with_velocity(running, t, signed_velocity(direction, d), d);
}

Trajectory stop(const Trajectory& running, double t, const AxisProfile& axis) {
  return with_velocity(running, t, 0, dynamics(axis));
}

void require_in_shape(const ShaperSpec& shaper, FilterOf of) {
  const bool group = of == FilterOf::group;
  const std::string filter = group ? "a group's InShape" : "an axis's InShape";
  if (shaper.kind == ShaperKind::ei)
    throw InputError("kind", "\"ei\"", "must be zv (NORMAL) or zvd (ROBUST) for " + filter);
  require_within("frequency", shaper.mode.frequency, group ? 3 : 1.5, 300, filter,
                 group ? "0x82gg0118" : "0x83aa047e");
  require_within("damping", shaper.mode.damping, 0, 0.3, filter,
                 group ? "0x82gg010e" : "0x83aa0474");
}

void require_vsf(const NotchSpec& notch) {
  require_within("frequency", notch.frequency, 0.1, 200, "VSF", "0x83aa047e");
  require_within("damping", notch.damping, 0.7, 1.5, "VSF", "0x83aa0474");
}

}  // namespace jounce::himc
