// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/movement.hpp"
#include "jounce/gear/gear_in.hpp"
#include "jounce/gear/gear_in_pos.hpp"

namespace jounce {

/// A gear on the live master of the axis (MC_GearIn). From any motion, the slave ramps to the
/// velocity of its master times the ratio, then follows in step (jounce/gear/gear_in.hpp).
///
///     LiveGear gear(3, {.numerator = 1, .denominator = 2, .acceleration = 20000});
///     axis.step(t, {command::Couple{&gear}}, inputs);
///
/// Progress is `engaging` during the ramp, then `running` until the axis leaves the gear. Progress
/// is `broken` if the master is lost.
class LiveGear final : public Movement {
 public:
  /// `id` is the id of the motion in Tick::job. Throws InputError like gear_in().
  LiveGear(std::uint64_t id, const GearInSpec& spec);

  /// Returns none; no_master_input if a number of the master or of the axis is not finite or
  /// exceeds 1e50; or no_ramp if no ramp to the velocity of the gear exists.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override;
  [[nodiscard]] bool absolute() const noexcept override { return false; }
  [[nodiscard]] double ratio() const noexcept override { return gear_.ratio; }
  [[nodiscard]] Peaks peaks() const noexcept override;
  /// Returns a refusal, acceleration_limit or jerk_limit, if the ramp would exceed the limits of
  /// the axis.
  [[nodiscard]] std::optional<Refusal> admit(const AxisConfig& config,
                                             const MotionState& from) const noexcept override;

 private:
  GearInSpec spec_;
  GearedIn gear_;
  Progress progress_ = Progress::engaging;
  Setpoint last_;
};

/// A gear in position on the live master of the axis (MC_GearInPos). The slave rests until the
/// master passes the start position. From the sync position on, the slave is in step
/// (jounce/gear/gear_in_pos.hpp). When the movement begins, the slave must stand at `slave_start`.
///
/// Progress is `waiting`, `engaging`, then `running`. If the master turns back before the sync
/// position, the slave moves back with the master. Progress then stays `engaging`, and
/// master_reversed() returns true (PMC600 error 775).
class LiveGearInPos final : public Movement {
 public:
  /// `id` is the id of the motion in Tick::job. Throws InputError like gear_in_pos(), and with the
  /// key "master_start_distance" if the gear cannot engage.
  LiveGearInPos(std::uint64_t id, const GearInPosSpec& spec);

  /// Returns none, no_master_input, in_motion if the axis moves, or start_position if it does not
  /// stand at slave_start.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] double ratio() const noexcept override { return gear_.ratio; }
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override;
  /// True if the master moved backwards in this cycle, while the gear was engaging.
  [[nodiscard]] bool master_reversed() const noexcept { return reversed_; }

 private:
  GearInPos gear_;
  GearInPosState state_;
  bool reversed_ = false;
  Progress progress_ = Progress::waiting;
  Setpoint last_;
};

}  // namespace jounce
