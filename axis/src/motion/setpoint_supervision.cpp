// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/setpoint_supervision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axis/src/motion/setpoint_check.hpp"

namespace jounce {

Cause supervise(const MotionState& next, const SupervisedMotion& motion,
                const AxisConfig& rules) noexcept {
  const double joint = motion.joined ? joint_step(rules) : 0;
  const double kinks = motion.path.velocity_step * static_cast<double>(motion.skipped + 2);
  const double checked = motion.open_ended ? 0 : motion.path.velocity;
  const StepAllowance step{motion.dt, kinks + joint, checked};
  const Cause no = check_setpoint(motion.last, next, step, rules);
  const bool supervised = !motion.stops_in_fault && !motion.bounded;
  if (supervised && (no == Cause::none || no == Cause::out_of_range))
    if (const Cause limit = check_range(motion.last, next, rules); limit != Cause::none)
      return limit;
  if (no != Cause::none) return no;
  if (supervised && exceeds_velocity(next, rules)) return Cause::overspeed;
  if (supervised && motion.in_step && exceeds_acceleration(next, rules))
    return Cause::overacceleration;
  if (motion.searches) return Cause::none;
  if (next.velocity > 0 && motion.positive_switch) return Cause::positive_switch;
  if (next.velocity < 0 && motion.negative_switch) return Cause::negative_switch;
  return Cause::none;
}

double excess(Cause wrong, const MotionState& next, const SupervisedMotion& motion,
              const AxisConfig& rules) noexcept {
  const auto& [p, v, a] = next;
  switch (wrong) {
    case Cause::overspeed:
      return std::max(reached_speed(next, rules), std::abs(p - motion.last.position) / motion.dt);
    case Cause::overacceleration:
      return std::abs(a);
    case Cause::jump:
      return std::max(std::abs(a), std::abs(v - motion.last.velocity) / motion.dt);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

double joint_step(const AxisConfig& config) noexcept {
  return *config.limits.acceleration * seconds(config.period);
}

}  // namespace jounce
