// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/movement.hpp"
#include "jounce/gear/gear_in.hpp"
#include "jounce/gear/gear_in_pos.hpp"

namespace jounce {

/// MC_GearIn on the axis's live master: from any motion, the slave ramps to k times its master's
/// velocity and then follows in step (jounce/gear/gear_in.hpp).
///
///     LiveGear gear(3, {.numerator = 1, .denominator = 2, .acceleration = 20000});
///     axis.step(t, {.kind = CommandKind::gear_in, .movement = &gear}, inputs);
///
/// Its progress is `engaging` during the ramp, then `running` until the axis leaves the gear;
/// `broken` if the master is lost.
class LiveGear final : public Movement {
 public:
  /// Throws InputError like gear_in().
  LiveGear(std::uint64_t id, const GearInSpec& spec);

  /// Returns no_master_input if the master is not finite or exceeds 1e50.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override;
  [[nodiscard]] bool absolute() const noexcept override { return false; }
  [[nodiscard]] Peaks peaks() const noexcept override;
  /// Returns acceleration_limit or jerk_limit if its ramp would exceed the axis's limits.
  [[nodiscard]] std::optional<Refusal> admit(const AxisConfig& config,
                                             const MotionState& from) const noexcept override;

 private:
  GearInSpec spec_;
  GearedIn gear_;
  Progress progress_ = Progress::engaging;
  Setpoint last_;
};

/// MC_GearInPos on the axis's live master: the slave rests until the master passes the start
/// position, and is in step from the sync position on (jounce/gear/gear_in_pos.hpp). The slave must
/// stand at `slave_start` when it begins.
///
/// Its progress is `waiting`, `engaging`, then `running`, even if the master reverses: if the
/// master turns back before the sync position, the slave moves back with it. This is not a stop or
/// an error (PMC600 error 775 is reported by master_reversed()).
class LiveGearInPos final : public Movement {
 public:
  /// Throws InputError as gear_in_pos() does, also with the key "master_start_distance" if the gear
  /// cannot engage.
  LiveGearInPos(std::uint64_t id, const GearInPosSpec& spec);

  /// Returns no_master_input; or start_position, start_velocity: the axis does not stand at
  /// slave_start.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override;
  /// True if the master moved backwards in this cycle while the gear was engaging.
  [[nodiscard]] bool master_reversed() const noexcept { return reversed_; }

 private:
  GearInPos gear_;
  GearInPosState state_;
  bool reversed_ = false;
  Progress progress_ = Progress::waiting;
  Setpoint last_;
};

}  // namespace jounce
