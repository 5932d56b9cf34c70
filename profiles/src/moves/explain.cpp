// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/explain.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// "velocity 12 is above the highest permitted value 10"; "" for a value between its bounds.
std::string outside(const std::string& name, double value, double min, double max) {
  if (value > max)
    return name + " " + six_digits(value) + " is above the highest permitted value " + number(max);
  if (value < min)
    return name + " " + six_digits(value) + " is below the lowest permitted value " + number(min);
  return "";
}

std::string numbers_of(const MotionState& s) {
  return "position " + number(s.position) + ", velocity " + number(s.velocity) + ", acceleration " +
         number(s.acceleration);
}

std::string numbers_of(const Bounds& b) {
  std::string text;
  const auto add = [&](const char* name, double min, double max) {
    if (std::isinf(min) && std::isinf(max)) return;
    text +=
        (text.empty() ? "" : ", ") + std::string(name) + " " + number(min) + " to " + number(max);
  };
  add("velocity", b.velocity_min, b.velocity_max);
  add("acceleration", b.acceleration_min, b.acceleration_max);
  add("jerk", b.jerk_min, b.jerk_max);
  add("position", b.position_min, b.position_max);
  return text;
}

/// The velocity from which the acceleration increases from 0 to that of the target with the
/// greatest jerk.
std::string velocity_before(const MotionState& to, const Bounds& b) {
  const double jerk = to.acceleration > 0 ? b.jerk_max : b.jerk_min;
  const double before = to.velocity - to.acceleration * to.acceleration / (2 * jerk);
  const std::string beyond = outside("velocity", before, b.velocity_min, b.velocity_max);
  if (beyond.empty()) return numbers_of(to);
  return beyond + " before acceleration " + number(to.acceleration) + " at velocity " +
         number(to.velocity);
}

/// The position limits: "stay above position -20".
std::string limits_text(const Bounds& b) {
  const bool below = std::isfinite(b.position_min);
  const bool above = std::isfinite(b.position_max);
  return (below ? "stay above position " + number(b.position_min) : std::string()) +
         (below && above ? " and " : "") +
         (above ? std::string(below ? "" : "stay ") + "below position " + number(b.position_max)
                : std::string());
}

std::string with(const char* sentence, const std::string& numbers) {
  return numbers.empty() ? sentence : sentence + (": " + numbers);
}

}  // namespace

std::string explain(MoveStatus status, const MotionState& from, const MotionState& to,
                    const Bounds& bounds) {
  const char* const sentence = explain(status);
  switch (status) {
    case MoveStatus::not_finite:
      return with(sentence, "start " + numbers_of(from) + "; target " + numbers_of(to));
    case MoveStatus::invalid_bounds: {
      const std::string numbers = numbers_of(bounds);
      const auto is_free = [](double min, double max) {
        return std::isinf(min) && std::isinf(max);
      };
      const bool no_rate = is_free(bounds.velocity_min, bounds.velocity_max) &&
                           is_free(bounds.acceleration_min, bounds.acceleration_max) &&
                           is_free(bounds.jerk_min, bounds.jerk_max);
      return no_rate ? "give at least one of velocity, acceleration and jerk"
                     : with(sentence, numbers);
    }
    case MoveStatus::target_outside: {
      const std::string velocity =
          outside("velocity", to.velocity, bounds.velocity_min, bounds.velocity_max);
      const std::string acceleration = outside("acceleration", to.acceleration,
                                               bounds.acceleration_min, bounds.acceleration_max);
      const bool both = !velocity.empty() && !acceleration.empty();
      return with(sentence, velocity + (both ? ", " : "") + acceleration);
    }
    case MoveStatus::target_unreachable:
      return with(sentence, velocity_before(to, bounds));
    case MoveStatus::position_limit:
      if (const std::string beyond =
              outside("target", to.position, bounds.position_min, bounds.position_max);
          !beyond.empty())
        return with(sentence, beyond);
      return with(sentence, "it begins at position " + number(from.position) + " with velocity " +
                                number(from.velocity) + ", ends at position " +
                                number(to.position) + " with velocity " + number(to.velocity) +
                                ", and must " + limits_text(bounds));
    default:
      return sentence;
  }
}

std::string explain(MoveStatus status, const MotionState& from, const MotionState& to,
                    const Bounds& bounds, double duration) {
  if (status == MoveStatus::not_finite && !(std::abs(duration) <= 1e50))
    return with(explain(status), "duration " + number(duration));
  if (status != MoveStatus::too_short && status != MoveStatus::blocked)
    return explain(status, from, to, bounds);
  const Durations all = durations(from, to, bounds);
  std::string possible = number(all.minimum) + " s";
  for (std::size_t i = 0; i < all.count; ++i)
    possible += " to " + number(all.blocked[i].from) + " s, " + number(all.blocked[i].to) + " s";
  return with(explain(status),
              number(duration) + " s is given; possible durations are " + possible + " and more");
}

}  // namespace jounce
