// SPDX-License-Identifier: Apache-2.0
#include "axis/src/homing/home_search.hpp"

#include <cmath>

#include "axis/src/motion/move_plan.hpp"
#include "axis/src/state/supervision.hpp"

namespace jounce {
namespace {

/// Returns the homing of the axis with the changes of the command.
HomingSpec chosen(const command::Home& what, HomingSpec spec) {
  const auto take = [](auto& value, double given) {
    if (!std::isnan(given)) value = given;
  };
  if (what.method != 0) spec.method = what.method;
  take(spec.offset, what.offset);
  take(spec.search_velocity, what.search_velocity);
  take(spec.index_velocity, what.index_velocity);
  take(spec.acceleration, what.acceleration);
  take(spec.timeout, what.timeout);
  take(spec.distance, what.distance);
  return spec;
}

std::optional<Refusal> misses(const HomingSpec& spec, const AxisConfig& config) {
  for (const double velocity : {spec.search_velocity, spec.index_velocity}) {
    MoveDynamics dynamics{.velocity = velocity, .acceleration = spec.acceleration};
    if (const auto no = fill(dynamics, config)) return no;
  }
  if (!(spec.timeout > 0)) return Refusal{Cause::not_positive, spec.timeout, 0, 0};
  if (spec.distance && !(*spec.distance > 0))
    return Refusal{Cause::not_positive, *spec.distance, 0, 0};
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> misplaced_home(const HomingSpec& spec, const Limits& limits) {
  const bool at_negative = spec.method == 1 || spec.method == 17;
  const bool at_positive = spec.method == 2 || spec.method == 18;
  const bool below = limits.position_min && spec.offset < *limits.position_min;
  const bool above = limits.position_max && spec.offset > *limits.position_max;
  if (!(below && !at_negative) && !(above && !at_positive)) return std::nullopt;
  return Refusal{Cause::position_limit, spec.offset,
                 below ? *limits.position_min : *limits.position_max};
}

std::optional<Refusal> home_order_of(const command::Home& what, const AxisConfig& config,
                                     HomeOrder& order) {
  const HomingSpec spec = chosen(what, config.homing);
  const auto method = homing_method(spec.method);
  if (!method) return Refusal{Cause::no_such_method, static_cast<double>(spec.method)};
  if (auto no = misses(spec, config)) return no;
  if (!(std::abs(spec.offset) <= furthest(config)))
    return Refusal{Cause::position_limit, spec.offset, furthest(config)};
  if (const auto no = misplaced_home(spec, config.limits)) return no;
  order = {*method, spec};
  return std::nullopt;
}

HomeSearch::HomeSearch(const AxisConfig& config) : config_(config), unranged_(config) {
  unranged_.limits.position_min = unranged_.limits.position_max = std::nullopt;
}

HomeSearch::Step HomeSearch::step(const Homing::Seen& now) noexcept {
  const double before = homing_->velocity();
  homing_->step(now);
  Step next{.fault = homing_->cause()};
  if (next.fault != Cause::none) next.exceeded = homing_->exceeded();
  next.done = homing_->done();
  if (homing_->velocity() != before) next.velocity = homing_->velocity();
  return next;
}

}  // namespace jounce
