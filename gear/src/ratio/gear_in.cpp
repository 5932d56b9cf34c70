// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear_in.hpp"

#include <algorithm>
#include <string>

#include "jounce/gear/gear.hpp"
#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/dynamics.hpp"
#include "jounce/profiles/sequences/splice.hpp"

// Let P be the ramp from the slave's state to the velocity w = k x0' of the gear with a steady
// master, and s = t - t0. Then
//
//   (2)  c(s) = P(s) - w s
//
// in (1) of the header. With a jerk limit, P begins with the acceleration y0'' - k x0'', so the sum
// begins with y0''.

namespace jounce {
namespace {

void require_rate(const char* key, double value, bool may_be_zero, int code) {
  const bool fits = value > 0 || (may_be_zero && value == 0);
  if (fits && value <= 1e50) return;
  throw InputError(key, value,
                   std::string("must be ") + (may_be_zero ? "0 or more" : "greater than 0") +
                       ", and finite (PMC600 error " + std::to_string(code) + ")");
}

Dynamics dynamics(const GearInSpec& spec) {
  require_rate("acceleration", spec.acceleration, false, 676);
  require_rate("deceleration", spec.deceleration, true, 677);
  require_rate("jerk", spec.jerk, true, 679);
  return {.acceleration = spec.acceleration, .deceleration = spec.deceleration, .jerk = spec.jerk};
}

/// The correction c of (2), which begins at t.
Trajectory correction(const GearedIn& gear, double t) {
  const Trajectory ramp = gear.ramp.curve();
  const double T = ramp.end();
  return shifted(sum(ramp, Trajectory({line(T, 0, -gear.velocity * T)}, 0, Extrapolation::hold)),
                 t);
}

}  // namespace

GearedIn gear_in(const GearInSpec& spec, const MotionState& slave, const Jet& master, double t) {
  const Gear gear = Gear::ratio(spec.numerator, spec.denominator);
  const Dynamics limits = dynamics(spec);
  require_finite("t", t);
  for (const double x : master) require_finite("master", x);
  for (const double y : {slave.position, slave.velocity, slave.acceleration})
    require_finite("slave", y);
  GearedIn made;
  made.ratio = static_cast<double>(gear.numerator()) / static_cast<double>(gear.denominator());
  made.time = t;
  made.master = master[0];
  made.slave = slave.position;
  made.velocity = made.ratio * master[1];
  const double acceleration = spec.jerk > 0 ? slave.acceleration - made.ratio * master[2] : 0;
  made.ramp = velocity_ramp({0, slave.velocity, acceleration}, made.velocity, limits);
  return made;
}

Jet point(const GearedIn& gear, const Jet& master, double t) {
  const double T = gear.ramp.duration();
  const double s = std::clamp(t - gear.time, 0.0, T);
  const Motion p = gear.ramp.at(s);
  const double k = gear.ratio;
  const double y =
      gear.slave + k * (master[0] - gear.master) + (p.position - gear.velocity * s);  // (1), (2)
  if (in_gear(gear, t)) return {y, k * master[1], k * master[2], k * master[3]};
  return {y, k * master[1] + (p.velocity - gear.velocity), k * master[2] + p.acceleration,
          k * master[3] + p.jerk};
}

bool in_gear(const GearedIn& gear, double t) {
  return t - gear.time >= gear.ramp.duration();
}

Trajectory gear_in(const GearInSpec& spec, double slave, const Trajectory& master, double t) {
  if (!(t >= master.start() && t < master.end()))
    throw InputError("t", t,
                     "must lie in the motion of the master, from " + number(master.start()) +
                         " to before " + number(master.end()));
  const Trajectory rest = between(master, t, master.end());
  const GearedIn gear = gear_in(spec, MotionState{slave, 0, 0}, rest.jet(t), t);
  Trajectory y = shifted(scaled(rest, gear.ratio), 0, slave - gear.ratio * gear.master);
  if (gear.ramp.duration() > 0) y = superimposed(y, correction(gear, t));
  if (t == master.start()) return y;
  const Trajectory standing({line(t - master.start(), slave, slave)}, master.start());
  return spliced(standing, t, y);
}

}  // namespace jounce
