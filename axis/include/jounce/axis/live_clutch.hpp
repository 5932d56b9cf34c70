// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/movement.hpp"

namespace jounce {

/// A gear on the live master of the axis whose ratio changes over a distance of the master (GearIn
/// with a clutch; Googol GT_SetGearRatio with masterSlope, manual 7.5). With x the travel of the
/// master since the start, d the length of the clutch, z = |x| / d, and r0 and r1 the ratios,
///
///     (1)  ratio = r0 + (r1 - r0) f(z)                f = 10 z^3 - 15 z^4 + 6 z^5
///     (2)  slave = sign(x) d (r0 z + (r1 - r0) F(z))  F = 5/2 z^4 - 3 z^5 + z^6
///
/// So velocity and acceleration of the slave do not step, and the slave moves by d (r0 + r1) / 2 in
/// the clutch, as in Googol's example 7-5. If the master reverses in the clutch, the slave moves
/// back along the same curve. When the master has passed the clutch, the ratio stays r1, in both
/// directions.
///
/// r0 is the ratio of the gear that this one replaces, or 0 for an axis at rest. u is the unit of
/// the axis, m the unit of its master.
///
///     LiveClutch gear(3, 0.5, 100000);
///     axis.step(t, {command::Couple{&gear}}, inputs);
///
/// Progress is `engaging` in the clutch, then `running`; `broken` if the master is lost.
class LiveClutch final : public Movement {
 public:
  /// `id` is the id of the motion in Tick::job. `ratio`: r1, u/m. `distance`: d, m. Throws
  /// InputError "clutch" unless the distance is positive and at most 1e50.
  LiveClutch(std::uint64_t id, double ratio, double distance);

  /// Returns none; no_master_input; or in_motion if the axis moves, and does not follow its master
  /// at a constant ratio.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override;
  [[nodiscard]] bool absolute() const noexcept override { return false; }
  [[nodiscard]] double ratio() const noexcept override { return to_; }
  [[nodiscard]] std::array<double, 3> slopes() const noexcept override;
  [[nodiscard]] Peaks demand(const Moment& start) const noexcept override;

 private:
  double to_;                      // r1, u/m
  double distance_;                // m
  double from_ = 0;                // r0, u/m
  double master_ = 0, slave_ = 0;  // start of the clutch; after the clutch: its end
  Progress progress_ = Progress::engaging;
  Setpoint last_;
};

}  // namespace jounce
