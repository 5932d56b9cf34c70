// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/movement.hpp"
#include "jounce/gear/gear_in.hpp"

namespace jounce {

/// The ratios of an axis to its two masters, each in the unit of the axis per unit of the master.
struct CombinedRatios {
  double first = 1;
  double second = 1;  ///< negative: subtracts the motion of the second master
};

/// A gear on the sum of the two live masters of the axis (MC_CombineAxes):
///
///     (1)  slave = first x1 + second x2 + constant
///
/// The slave engages like a LiveGear: it ramps to the velocity of the sum, then follows in step.
///
///     LiveCombination both(3, {.first = 1, .second = -0.5}, {.acceleration = 20000});
///     axis.step(t, {command::Couple{&both}}, inputs);    // Inputs::master, Inputs::second_master
///
/// Progress is as for a LiveGear; `broken` if one of the masters is lost.
class LiveCombination final : public Movement {
 public:
  /// `id` is the id of the motion in Tick::job. `ramp`: its dynamics; the ratio in it is not used.
  /// Throws InputError like gear_in().
  LiveCombination(std::uint64_t id, const CombinedRatios& ratios, const GearInSpec& ramp);

  /// Returns the same reasons as LiveGear::begin().
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override;
  [[nodiscard]] bool absolute() const noexcept override { return false; }
  /// The ratio to the first master: a phase shift applies to this master.
  [[nodiscard]] double ratio() const noexcept override { return ratios_.first; }
  [[nodiscard]] Peaks peaks() const noexcept override;
  [[nodiscard]] Peaks demand(const Moment& start) const noexcept override;
  /// Returns a refusal, acceleration_limit or jerk_limit, if the ramp would exceed the limits of
  /// the axis.
  [[nodiscard]] std::optional<Refusal> admit(const AxisConfig& config,
                                             const MotionState& from) const noexcept override;

 private:
  CombinedRatios ratios_;
  GearInSpec ramp_;
  GearedIn gear_;  // ratio 1, on the sum
  Progress progress_ = Progress::engaging;
  Setpoint last_;
};

}  // namespace jounce
