// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/live_combination.hpp"

#include <cmath>

#include "jounce/axis/axis_config.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/src/follow/gear_ramp.hpp"
#include "axis/src/follow/live.hpp"

namespace jounce {
namespace {

GearInSpec of_ratio_one(GearInSpec ramp) {
  ramp.numerator = ramp.denominator = 1;
  return ramp;
}

/// The sum of the masters, u, and its derivatives.
Jet sum_of(const CombinedRatios& ratios, const Moment& now) {
  Jet sum{};
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] = ratios.first * now.master[k] + ratios.second * now.second[k];
  return sum;
}

bool are_usable(const CombinedRatios& ratios, const Moment& now) {
  return axis_detail::usable(now.master) && axis_detail::usable(now.second) &&
         axis_detail::usable(sum_of(ratios, now));
}

}  // namespace

LiveCombination::LiveCombination(std::uint64_t id, const CombinedRatios& ratios,
                                 const GearInSpec& ramp)
    : Movement(id, Course::live),
      ratios_(ratios),
      ramp_(of_ratio_one(ramp)),
      gear_(gear_in(ramp_, MotionState{}, Jet{}, 0)) {}

// See LiveGear::begin() for the exceptions of gear_in().
Cause LiveCombination::begin(const MotionState& axis, const Moment& now) noexcept {
  const Jet state{axis.position, axis.velocity, axis.acceleration, 0};
  if (!are_usable(ratios_, now) || !axis_detail::usable(state)) return Cause::no_master_input;
  try {
    gear_ = gear_in(ramp_, axis, sum_of(ratios_, now), now.t);
  } catch (const InputError&) {
    return Cause::no_ramp;
  }
  progress_ = Progress::engaging;
  last_ = axis_detail::setpoint(now.master, state);
  return Cause::none;
}

Setpoint LiveCombination::at(const Moment& now) noexcept {
  if (!are_usable(ratios_, now)) progress_ = Progress::broken;
  if (progress_ == Progress::broken) return last_;
  progress_ = in_gear(gear_, now.t) ? Progress::running : Progress::engaging;
  return last_ = axis_detail::setpoint(now.master, point(gear_, sum_of(ratios_, now), now.t));
}

Cause LiveCombination::cause() const noexcept {
  return progress_ == Progress::broken ? Cause::master_lost : Cause::none;
}

Peaks LiveCombination::peaks() const noexcept {
  return progress_ == Progress::engaging ? axis_detail::ramp_peaks(ramp_) : Peaks{};
}

Peaks LiveCombination::demand(const Moment& start) const noexcept {
  return {.velocity = std::abs(sum_of(ratios_, start)[1])};
}

std::optional<Refusal> LiveCombination::admit(const AxisConfig& config,
                                              const MotionState& /*from*/) const noexcept {
  return axis_detail::against_ramp(ramp_, config);
}

}  // namespace jounce
