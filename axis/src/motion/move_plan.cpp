// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/move_plan.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/motion/setpoint_check.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_digit;
using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

constexpr double passing_resolution = 1e-6;  ///< relative, of a bisection

/// Checks one number of the dynamics against its limit; a missing number becomes the limit.
std::optional<Refusal> fill(double& value, double limit, Cause cause) {
  if (std::isnan(value)) value = limit;
  if (!(value > 0)) return Refusal{Cause::not_positive, value, 0};
  if (value > limit) return Refusal{cause, value, limit};
  return std::nullopt;
}

std::optional<Refusal> fill(MoveDynamics& d, double velocity, double acceleration,
                            double deceleration, double jerk) {
  for (const auto& refused : {fill(d.velocity, velocity, Cause::velocity_limit),
                              fill(d.acceleration, acceleration, Cause::acceleration_limit),
                              fill(d.deceleration, deceleration, Cause::acceleration_limit),
                              fill(d.jerk, jerk, Cause::jerk_limit)})
    if (refused) return refused;
  return std::nullopt;
}

/// The position range, extended to the position of the axis: an axis outside may return.
void keep_range(Bounds& bounds, double position, const Limits& limits) {
  if (limits.position_min) bounds.position_min = std::min(*limits.position_min, position);
  if (limits.position_max) bounds.position_max = std::max(*limits.position_max, position);
}

/// The position of rest after braking with `deceleration`; the jerk does not matter for a sign.
double stopping_point(const MotionState& from, const MoveDynamics& d) {
  return from.position + from.velocity * std::abs(from.velocity) / (2 * d.deceleration);
}

/// True if a move to the target slows down on its way up. An axis that stops exactly at the target
/// continues: rounding does not reverse it.
bool brakes_upwards(const MotionState& from, double target, const MoveDynamics& d) {
  const double rounding = rounded_sum * (std::abs(from.position) + std::abs(target));
  const double beyond = target - stopping_point(from, d);
  return std::abs(beyond) > rounding ? beyond > 0 : from.velocity >= 0;
}

Bounds towards(const MotionState& from, double target, const MoveDynamics& d, double velocity) {
  Bounds bounds = within(velocity, d.acceleration, d.jerk);
  if (brakes_upwards(from, target, d))
    bounds.acceleration_min = -d.deceleration;
  else
    bounds.acceleration_max = d.deceleration;
  return bounds;
}

/// The jerk of a move. Until the acceleration is 0, the velocity changes by a^2 / (2j). If the jerk
/// of the command is too low to keep the velocity within its limit, or to stop without reversal, it
/// is raised, at most to the jerk of a stop: the limits of the axis take precedence.
double jerk_for(const MotionState& from, const Goal& goal, const AxisConfig& config) {
  const auto& [p, v, a] = from;
  const double along = std::copysign(v, v * a);  // > 0: it speeds up
  const bool braking = goal.kind == Goal::Kind::rest && along < 0;
  const double room = braking ? -along : std::max(*config.limits.velocity - along, 0.0);
  const double most = config.limits.jerk ? config.stop_jerk : Bounds::none;
  if (a == 0) return goal.dynamics.jerk;
  return std::max(goal.dynamics.jerk, std::min(a * a / (2 * room) * (1 + rounded_input), most));
}

/// True if a motion does not reverse.
bool straight(const Profile& profile, double way) {
  const double near =
      rounded_sum * (std::abs(profile.start().velocity) + std::abs(profile.end().velocity));
  const auto [slowest, fastest] = velocities(profile);
  return (way > 0 ? slowest : -fastest) >= -near;
}

/// Joins two profiles, up to the end state of the second; nullopt if a profile cannot hold all
/// their phases, or the magnitudes differ too much.
std::optional<Profile> joined(const Profile& first, const Profile& second, const MotionState& end) {
  if (first.phases() + second.phases() > Profile::capacity) return std::nullopt;
  Profile both(first.start(), second.order());
  std::array<double, 4> values{};
  std::size_t known = 0;
  for (const Profile* part : {&first, &second})
    for (std::size_t i = 0; i < part->phases(); ++i) {
      const auto [duration, value] = part->phase(i);
      const auto* const last = values.begin() + known;
      const bool is_new = value != 0 && std::find(values.cbegin(), last, value) == last;
      if (is_new && known == values.size()) return std::nullopt;
      if (is_new) values[known++] = value;
      both.add(duration, value);
    }
  both.finish(end);
  return both;
}

/// A move that passes its target faster than its own velocity: it moves at its own velocity first
/// and speeds up as late as possible. Its ramp ends at the target. With w the distance of the ramp:
///
///     (1)  from -> (target - w, own velocity) -> (target, velocity there)
///
/// If the distance is too short for (1), it speeds up throughout.
std::optional<Profile> speed_up(const MotionState& from, const Goal& goal, const MoveDynamics& d,
                                double own, const AxisConfig& config) {
  const double way = std::copysign(1.0, goal.through);
  const MotionState there{goal.value, goal.through, 0};
  const MoveResult ramp =
      move_velocity({0, way * own, 0}, goal.through, within(Bounds::none, d.acceleration, d.jerk));
  if (!ramp) return std::nullopt;
  const MotionState knee{goal.value - ramp.profile.end().position, way * own, 0};
  const auto to = [&](const MotionState& target, double velocity) {
    Bounds bounds = towards(from, target.position, d, velocity);
    keep_range(bounds, from.position, config.limits);
    return move_to(from, target, bounds);
  };
  if (const MoveResult first = to(knee, own); first && straight(first.profile, way))
    if (auto whole = joined(first.profile, ramp.profile, there)) return whole;
  const MoveResult move = to(there, std::abs(goal.through));
  return move ? std::optional(move.profile) : std::nullopt;
}

/// Returns true if the halves of a motion meet in the middle: the first is computed from its start,
/// the second back from its end (Profile::at). They do not meet if the accelerations differ by many
/// orders of magnitude: a double then has too few digits for the durations.
bool halves_meet(const Profile& motion, const AxisConfig& config) {
  const double middle = motion.duration() / 2;
  const Motion one = motion.at(std::nextafter(middle, 0));
  const Motion other = motion.at(middle);
  const double dt = static_cast<double>(config.period) * 1e-9;
  const double dv = 0.01 * *config.limits.acceleration * dt;
  const double dp = dv * dt + rounded_digit * std::abs(one.position);
  return std::abs(other.position - one.position) <= dp &&
         std::abs(other.velocity - one.velocity) <= dv;
}

double wanted_at_passing(double previous, double next, BufferMode mode) {
  switch (mode) {
    case BufferMode::aborting:
    case BufferMode::buffered:
      return 0;
    case BufferMode::blending_previous:
      return previous;
    case BufferMode::blending_next:
      return next;
    case BufferMode::blending_high:
      return std::max(previous, next);
    case BufferMode::blending_low:
      break;
  }
  return std::min(previous, next);
}

/// A motion that ends at rest at the end of the range that this stop exceeds: it reverses and
/// returns. The end is found from the extreme positions of the stop and not from the sign of the
/// velocity, because the acceleration may still reverse the motion. Returns no value if that end
/// has no limit or there is no such motion.
std::optional<Profile> rest_at_limit(const MotionState& from, const Profile& stop,
                                     const MoveDynamics& d, const AxisConfig& config) {
  const auto [lowest, highest] = positions(stop);
  const auto beyond = [](double way) { return std::max(way, 0.0); };
  const auto& [low, high, v, a, j] = config.limits;
  const double above = high ? beyond(highest - std::max(*high, from.position)) : 0;
  const double below = low ? beyond(std::min(*low, from.position) - lowest) : 0;
  const auto limit = above > below ? high : low;
  if (!limit) return std::nullopt;
  Bounds bounds = within(*config.limits.velocity, d.deceleration, d.jerk);
  keep_range(bounds, from.position, config.limits);
  const MoveResult move = move_to(from, {*limit, 0, 0}, bounds);
  return move ? std::optional(move.profile) : std::nullopt;
}

std::optional<Profile> to_position(const MotionState& from, const Goal& goal, const MoveDynamics& d,
                                   double own, const AxisConfig& config) {
  if (std::abs(goal.through) > own) return speed_up(from, goal, d, own, config);
  Bounds bounds = towards(from, goal.value, d, own);
  keep_range(bounds, from.position, config.limits);
  const MoveResult move = move_to(from, {goal.value, goal.through, 0}, bounds);
  return move ? std::optional(move.profile) : std::nullopt;
}

/// The limit for a change of velocity: the acceleration to speed up, the deceleration to slow down,
/// the smaller of both to reverse.
double change_of_velocity(double from, double to, const MoveDynamics& d) {
  if (from * to < 0) return std::min(d.acceleration, d.deceleration);
  return std::abs(to) > std::abs(from) ? d.acceleration : d.deceleration;
}

}  // namespace

std::optional<Refusal> fill(MoveDynamics& d, const AxisConfig& config) noexcept {
  const Limits& most = config.limits;
  return fill(d, *most.velocity, *most.acceleration, *most.acceleration,
              most.jerk.value_or(Bounds::none));
}

std::optional<Refusal> fill_stop(MoveDynamics& d, const AxisConfig& config) noexcept {
  return fill(d, *config.limits.velocity, config.stop_acceleration, config.stop_acceleration,
              config.limits.jerk ? config.stop_jerk : Bounds::none);
}

std::optional<Profile> plan(const MotionState& from, const Goal& goal, double factor,
                            const AxisConfig& config) noexcept {
  if (!(factor > 0) && goal.kind != Goal::Kind::rest) {
    MoveDynamics own;
    return fill(own, config) ? std::nullopt : plan(from, {Goal::Kind::rest, 0, own}, 1, config);
  }
  MoveDynamics d = goal.dynamics;
  d.jerk = jerk_for(from, goal, config);
  const double most = *config.limits.velocity;
  if (goal.kind == Goal::Kind::position) {
    const auto motion = to_position(from, goal, d, std::min(d.velocity * factor, most), config);
    return motion && halves_meet(*motion, config) ? motion : std::nullopt;
  }
  const double velocity =
      goal.kind == Goal::Kind::velocity ? std::clamp(goal.value * factor, -most, most) : 0;
  const MoveResult move = move_velocity(
      from, velocity, within(Bounds::none, change_of_velocity(from.velocity, velocity, d), d.jerk));
  if (!move) return std::nullopt;
  if (velocity != 0 || stays_inside(move.profile, config)) return move.profile;
  const auto inside = rest_at_limit(from, move.profile, d, config);
  return inside ? inside : move.profile;
}

/// Solves v + a t + j t^2 / 2 = 0 in each phase: the points of reversal.
std::array<double, 2> positions(const Profile& profile) noexcept {
  double low = std::min(profile.start().position, profile.end().position);
  double high = std::max(profile.start().position, profile.end().position);
  const auto see = [&](double p) {
    low = std::min(low, p);
    high = std::max(high, p);
  };
  double begin = 0;
  for (std::size_t i = 0; i < profile.phases(); ++i) {
    const auto [p, v, a, unused] = profile.at(begin);
    const auto [T, value] = profile.phase(i);
    const double j = profile.order() == 3 ? value : 0;
    const double b = profile.order() == 3 ? a : value;
    see(p);
    const double root = b * b - 2 * j * v;
    if (root >= 0) {
      const double q = -(b + std::copysign(std::sqrt(root), b));
      for (const double t : {q / j, 2 * v / q})
        if (t > 0 && t < T) see(p + t * (v + t * (b / 2 + t * j / 6)));
    }
    begin += T;
  }
  return {low, high};
}

Peaks peaks(const Profile& profile) noexcept {
  const auto [low, high] = velocities(profile);
  Peaks most{.velocity = std::max(high, -low)};
  double t = 0;
  for (std::size_t i = 0; i < profile.phases(); ++i) {
    const auto [T, value] = profile.phase(i);
    double& highest = profile.order() == 3 ? most.jerk : most.acceleration;
    highest = std::max(highest, std::abs(value));
    most.acceleration = std::max(most.acceleration, std::abs(profile.at(t).acceleration));
    t += T;
  }
  return most;
}

std::array<double, 2> velocities(const Profile& profile) noexcept {
  const double v0 = profile.start().velocity;
  const double v1 = profile.end().velocity;
  double low = std::min(v0, v1);
  double high = std::max(v0, v1);
  double t = 0;
  for (std::size_t i = 0; i < profile.phases(); ++i) {
    const auto [p, v, a, unused] = profile.at(t);
    const auto [T, value] = profile.phase(i);
    const double j = profile.order() == 3 ? value : 0;  // at() may still return the previous phase
    const bool turns = j * a < 0 && std::abs(a) < std::abs(j) * T;  // the acceleration has a zero
    const double extreme = turns ? v - a * a / (2 * j) : v;
    low = std::min({low, v, extreme});
    high = std::max({high, v, extreme});
    t += T;
  }
  return {low, high};
}

double passing_velocity(const MotionState& from, const Goal& goal, const Goal& next,
                        BufferMode mode, double factor, const AxisConfig& config) noexcept {
  if (goal.kind != Goal::Kind::position || !(factor > 0)) return 0;
  const double way = goal.value < from.position ? -1 : 1;
  const double on = next.kind == Goal::Kind::velocity ? next.value : next.value - goal.value;
  if (!(way * on > 0)) return 0;
  const auto fits = [&](double velocity) {
    Goal first = goal;
    first.through = way * velocity;
    const auto to = plan(from, first, factor, config);
    if (!to || !straight(*to, way)) return false;
    const MotionState there{goal.value, first.through, 0};
    if (gentlest_stop(there, config) != Stop::soft) return false;
    const auto further = plan(there, next, factor, config);
    return further && straight(*further, way);
  };
  const double wanted =
      std::min(factor * wanted_at_passing(goal.dynamics.velocity, next.dynamics.velocity, mode),
               *config.limits.velocity);
  if (wanted == 0 || fits(wanted)) return way * wanted;
  double low = 0;
  for (double high = wanted; high - low > passing_resolution * wanted;) {
    const double middle = (low + high) / 2;
    (fits(middle) ? low : high) = middle;
  }
  return way * low;
}

std::optional<double> target_of(double position, Direction direction, const MotionState& from,
                                const MoveDynamics& d, const AxisConfig& config) noexcept {
  const bool against = (direction == Direction::positive && position < from.position) ||
                       (direction == Direction::negative && position > from.position);
  if (config.modulo == 0) return against ? std::nullopt : std::optional(position);
  // Beyond that, modulo_target() could not count the turns.
  if (!(std::abs(from.position) < 0x1p50 * config.modulo)) return std::nullopt;
  const Bounds bounds = within(d.velocity, std::min(d.acceleration, d.deceleration), d.jerk);
  const ModuloTarget target = modulo_target(from, position, direction, config.modulo, bounds);
  if (target.status != MoveStatus::ok) return std::nullopt;
  return target.position;
}

}  // namespace jounce
