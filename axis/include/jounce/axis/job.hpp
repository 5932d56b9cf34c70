// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/cam/coupling/coupled.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// A motion that is made and checked outside the cyclic thread: a table over time, or a cam over a
/// virtual master whose position is a table over time.
///
///     Job move(1, std::make_shared<Table>(pvt));
///     Job cam(2, std::make_shared<Table>(master), std::make_shared<Table>(cam_table));
///     if (auto refused = admit(cam, config, 0)) std::cerr << refused->text();
///
/// The time of a job is 0 at its start. A table over time with the policy `wrap` repeats until the
/// axis stops; any other table ends after one pass. A cam with the policy `wrap` is periodic in the
/// master.
///
/// `coupling` couples the cam (jounce/cam/coupling/coupling.hpp) at time 0 to a slave at rest at
/// `position`. With a ramp, the axis need not stand at the start of the cam, and the job lasts at
/// least until the ramp ends. If the master table repeats, admit() rejects a ramp, because the axis
/// would not return to its start position.
///
/// On a modulo axis (`slave_period` of the coupling), a table over time without a cam begins at the
/// position that differs from its first point by whole turns and is nearest to the axis.
///
/// The constructor throws InputError if `time` is not over time or has the policy `advance`, if
/// `cam` is not over the position of a master, and for an invalid coupling. Units: u is the unit of
/// the axis, m the unit of the master.
class Job final : public Movement {
 public:
  /// `id` is the id of the motion in Tick::job. `time` is the table over time: the position of the
  /// axis or, with a cam, the position of the master. `tick` is the length of a tick, s; several
  /// jumps within one tick count as one. `position` is the start position of the slave, u.
  Job(std::uint64_t id, std::shared_ptr<const Table> time,
      std::shared_ptr<const Table> cam = nullptr, double tick = 1e-3,
      const CouplingSpec& coupling = {}, double position = 0);

  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] bool synchronized() const noexcept override { return cam_ != nullptr; }
  [[nodiscard]] double known() const noexcept override;
  [[nodiscard]] double pass() const noexcept override { return duration(); }
  [[nodiscard]] Peaks peaks() const noexcept override;
  [[nodiscard]] int direction() const noexcept override { return direction_; }
  [[nodiscard]] std::optional<MotionState> end() const noexcept override;
  [[nodiscard]] std::optional<Refusal> admit(const AxisConfig& config,
                                             const MotionState& from) const noexcept override;

  /// True if the table over time repeats.
  [[nodiscard]] bool repeats() const { return time_->outside() == Extrapolation::wrap; }
  /// First time of the table over time, s.
  [[nodiscard]] double start() const { return time_->start(); }
  /// Duration of one pass, s.
  [[nodiscard]] double duration() const { return std::max(time_->length(), least_); }

  /// Returns the point at time t >= 0 of the job, s, exactly as the tables give it. After the end
  /// of a job that does not repeat, returns its last point, at rest. Never allocates.
  [[nodiscard]] Setpoint at(double t) const;

  /// Extreme values over time of position, velocity, acceleration and jerk. For a table over time
  /// they are exact. For a cam, each interval between two breaks is sampled at 17 points. The peaks
  /// of position, velocity and acceleration are then refined where the next derivative changes
  /// sign, and the peaks of the jerk around samples that exceed their neighbors.
  [[nodiscard]] const Ranges& ranges() const { return ranges_; }

  /// The peak in the interval that requires the greatest limit, and this limit: without the
  /// rounding of knots, as pvt_detail::KnotRounding counts it.
  struct Required {
    Extremum peak = {};
    double limit = 0;
  };
  /// The limits that the job requires for velocity, acceleration and jerk, u/s, u/s^2, u/s^3.
  [[nodiscard]] const std::array<Required, 3>& required() const { return required_; }

  /// The largest jumps of position, velocity and acceleration in a pass and, if the job repeats,
  /// from the end of a pass to the start of the next. The magnitudes of all jumps within one tick
  /// are added; `where` is then the start of that tick.
  [[nodiscard]] const std::array<Jump, 3>& steps() const { return steps_; }

  /// The first point.
  [[nodiscard]] const Setpoint& first() const { return first_; }
  /// The last point.
  [[nodiscard]] const Setpoint& last() const { return last_; }

  /// Greatest distance (m) by which the master leaves a cam that refuses positions outside, and its
  /// time. 0: the master stays inside the cam.
  [[nodiscard]] const Extremum& master_excess() const { return master_excess_; }

  /// The reason why the coupling is not possible from this position; `ok` if it is possible, or if
  /// the job has no cam.
  [[nodiscard]] CouplingStatus coupled() const { return coupled_; }
  /// True if a ramp couples the axis to the cam.
  [[nodiscard]] bool ramps() const { return !in_sync_ || *in_sync_ > start(); }
  /// True if the slave is in sync before the job ends.
  [[nodiscard]] bool gets_in_sync() const { return in_sync_.has_value(); }

  /// Tolerance for equal positions, u: 1e-9 of the stroke, plus rounding.
  [[nodiscard]] double tolerance() const;
  /// The whole turns by which the job is shifted if it begins at this position, u; 0 on a linear
  /// axis, and with a cam.
  [[nodiscard]] double turns_to(double position) const;

 private:
  void couple(const CouplingSpec& spec, double position, double tick);
  template <Signal S>
  void survey_steps(const S& slave, double tick);
  [[nodiscard]] Jet master(double t, Side side = Side::right) const;
  [[nodiscard]] Setpoint follow(const Jet& x, double t) const;

  std::shared_ptr<const Table> time_;
  std::shared_ptr<const Table> cam_;
  double least_ = 0;  // least duration, for a ramp, s
  Engaged engaged_;
  CouplingStatus coupled_ = CouplingStatus::ok;
  std::optional<double> in_sync_;  // path time from which the slave is in sync, s
  Setpoint first_;
  Setpoint last_;
  Ranges ranges_{};
  std::array<Required, 3> required_;
  std::array<Jump, 3> steps_{};
  int direction_ = 0;
  Extremum master_excess_;
  Progress progress_ = Progress::running;
  double turn_ = 0;   // length of a turn of a modulo axis, u; 0: none
  double shift_ = 0;  // whole turns since begin(), u
};

/// Checks a job against an axis in the state `from`: the start position, rest at both ends, the
/// position range, velocity, acceleration, jerk, and jumps. If the job takes over from a previous
/// motion, it must begin with the velocity and acceleration of this motion instead of at rest.
/// Returns nullopt, or the first broken rule. Never allocates.
///
/// Values may exceed their limits by 1e-9 of the limit. In the jerk of a table over time, the
/// effect of the rounding of its knots does not count. (This effect is the rounding divided by the
/// cube of the distance between two knots.) The jerk of a cam may exceed its limit by 1e-6 of the
/// limit.
///
/// A jump of the velocity counts as the acceleration that causes this change within one tick. So a
/// table of straight lines is admitted exactly if no tick exceeds the acceleration limit. With a
/// jerk limit, a jump of the acceleration counts as the jerk that causes this change within one
/// tick.
std::optional<Refusal> admit(const Job& job, const AxisConfig& config, const MotionState& from);
/// Checks a job against an axis at rest at `position`, u.
inline std::optional<Refusal> admit(const Job& job, const AxisConfig& config, double position) {
  return admit(job, config, MotionState{position, 0, 0});
}

}  // namespace jounce
