// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jounce/controllers/pmc600/pmc600.hpp"
#include "jounce/profiles/detail/ascending.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/sequences/splice.hpp"

namespace jounce::pmc600 {
namespace {

/// Target of a running motion; nothing for a velocity command, which ends moving.
std::optional<double> target_of(const Trajectory& running) {
  const MotionState last = state_at(running, running.end());
  if (last.velocity != 0) return std::nullopt;
  return last.position;
}

double wanted(const JogInput& input, double velocity) {
  if (input.forward == input.backward) return 0;
  return input.forward ? velocity : -velocity;
}

}  // namespace

Trajectory move_additive(const Trajectory& running, double t, double distance,
                         const Dynamics& dynamics) {
  const double base = target_of(running).value_or(state_at(running, t).position);
  return with_target(running, t, base + distance, dynamics);
}

Trajectory move_superimposed(const Trajectory& running, double t, double distance,
                             const Dynamics& dynamics, std::optional<double> abort) {
  if (abort) require_finite("abort", *abort);
  if (!target_of(running)) return move_additive(running, t, distance, dynamics);
  Trajectory added = shifted(point_to_point(0, distance, dynamics).curve(), t);
  if (abort && *abort <= t) return running;
  if (abort && *abort < added.end()) added = with_velocity(added, *abort, 0, dynamics);
  return superimposed(running, added);
}

Trajectory inch(double from, double distance, const Dynamics& dynamics,
                std::optional<double> released) {
  Trajectory step = point_to_point(from, from + distance, dynamics).curve();
  if (!released || *released >= step.end()) return step;
  require_positive("released", *released);
  return with_velocity(step, *released, 0, dynamics);
}

Trajectory jog(double from, std::span<const JogInput> inputs, const Dynamics& dynamics,
               std::optional<double> max_velocity) {
  require_positive("velocity", dynamics.velocity);
  if (max_velocity) require_positive("max_velocity", *max_velocity);
  if (inputs.empty()) throw InputError("inputs", "", "is missing: a jog needs at least one");
  const double velocity = std::min(dynamics.velocity, max_velocity.value_or(dynamics.velocity));
  const double first = wanted(inputs[0], velocity);
  if (first == 0)
    throw InputError("inputs[1]", "", "must ask for a motion: nothing moves before it");
  profiles_detail::require_ascending("inputs", inputs);
  Trajectory running =
      shifted(velocity_ramp({from, 0, 0}, first, dynamics).curve(), inputs[0].time);
  for (const JogInput& input : inputs.subspan(1))
    running = with_velocity(running, input.time, wanted(input, velocity), dynamics);
  return running;
}

}  // namespace jounce::pmc600
