// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jounce/axis/movement.hpp"
#include "jounce/cam/coupling/coupling_cycle.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// A cam on the live master of the axis (MC_CamIn). The master may move arbitrarily.
///
///     LiveCam cam(7, knots, {.start = StartMode::ramp_in, .velocity_diff = 100,
///                            .acceleration = 2000});
///     if (const Cause no = cam.begin(state, now); no != Cause::none) ...    // would_reverse, ...
///     const Setpoint point = cam.at(now);                                  // every cycle
///
/// A table with the policy `wrap` or `advance` is periodic; a table with `hold` or `refuse` runs
/// once. For start modes, scaling, offsets and jumps of the master, see
/// jounce/cam/coupling/coupling.hpp and jounce/cam/coupling/coupling_cycle.hpp. In sync, the
/// setpoints are exactly the results of placed() for the table.
///
/// **Progress** is `engaging` until the slave is in sync, then `running`. A cam that runs once is
/// `done` in the tick of its end. If the cam ends at a nonzero velocity, CamEnd selects the
/// behavior. With CamEnd::extend the cam is never `done`: the slave continues at the ratio of the
/// cam's end, and follows the cam again when the master returns. Progress is `broken` if the master
/// is lost (NaN), or if it jumps and no correction can absorb the jump.
class LiveCam final : public Movement {
 public:
  /// `id` is the id of the motion in Tick::job. Throws InputError for a table that is not over a
  /// master, and for an invalid coupling.
  LiveCam(std::uint64_t id, std::shared_ptr<const Table> cam, const CouplingSpec& spec = {},
          CamEnd end = CamEnd::brake);

  /// Returns none, no_master_input, master_outside_cam, would_reverse, master_stands, no_ramp, or
  /// start_position. The last one means that the start mode has no ramp (absolute, relative), and
  /// that the axis does not stand on the cam.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override { return cause_; }
  [[nodiscard]] bool keeps_velocity() const noexcept override {
    return end_ == CamEnd::keep_velocity;
  }
  [[nodiscard]] double place() const noexcept override { return place_; }
  [[nodiscard]] std::optional<MotionState> first_setpoint(
      const Moment& now) const noexcept override;
  [[nodiscard]] bool passes() const noexcept override { return true; }
  [[nodiscard]] std::array<double, 3> slopes() const noexcept override { return slopes_; }
  /// For a cam that repeats, behind a master that does not slow down. No jerk: the axis does not
  /// supervise it.
  [[nodiscard]] Peaks demand(const Moment& start) const noexcept override;
  [[nodiscard]] std::optional<Moment> pass_end(const Moment& now) const noexcept override;

  /// Number of periods of the cam that were completed since the start; a period that is passed
  /// backwards counts -1. (The EndOfProfile of PLCopen marks each completed period.)
  [[nodiscard]] std::int64_t periods() const noexcept { return periods_; }

 private:
  /// The end at which the cam was left, and the motion of the slave from there.
  struct Beyond {
    double side = 0;    // 1: beyond the end, -1: before the start
    double master = 0;  // master position of this end, m
    double slave = 0;   // slave position at this end, u
    double ratio = 0;   // ratio at this end, u/m
  };
  Setpoint break_off(Cause cause) noexcept;
  void extend(double side) noexcept;
  Setpoint beyond(const Moment& now) noexcept;

  std::shared_ptr<const Table> table_;
  Coupling coupling_;
  std::array<double, 3> slopes_;
  Engaged engaged_;
  CamEnd end_;
  std::optional<Released> released_;
  std::optional<Beyond> beyond_;
  double place_ = 0;  // position of the cam at the start, u
  std::int64_t periods_ = 0;
  Progress progress_ = Progress::engaging;
  Cause cause_ = Cause::none;
  Setpoint last_;
};

/// Returns the Cause for a coupling status.
Cause cause_of(CouplingStatus status);

}  // namespace jounce
