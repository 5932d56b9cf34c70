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

/// A motion, constructed and checked outside the cyclic thread: a table over time, or a cam table
/// over a virtual master whose position is a table over time.
///
///     Job move(1, std::make_shared<Table>(pvt));
///     Job cam(2, std::make_shared<Table>(master), std::make_shared<Table>(cam_table));
///     if (auto refused = admit(cam, config, 0)) std::cerr << refused->text();
///
/// Local time runs from 0 at the start. A time table that wraps repeats until it is stopped; any
/// other ends after one run. A cam table that wraps is periodic in the master.
///
/// `coupling` defines the coupling of a cam (jounce/cam/coupling/coupling.hpp), at local time 0, to
/// a slave at rest at `position`. A ramp can engage an axis that does not stand at the start of the
/// cam; the job then lasts until the ramp is over. admit() rejects a ramp onto a master that
/// repeats: the axis would not return to its start position.
///
/// Throws InputError if the tables are not over time and over master position, in this order, and
/// for a bad coupling.
class Job final : public Movement {
 public:
  /// `tick` is the length of a tick, s: steps closer together count as one.
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

  [[nodiscard]] bool repeats() const { return time_->outside() == Extrapolation::wrap; }
  [[nodiscard]] double start() const { return time_->start(); }  ///< start of the time table, s
  [[nodiscard]] double duration() const {
    return std::max(time_->length(), least_);
  }  ///< duration of one run, s

  /// Returns the point at local time t >= 0, s: bit for bit as the tables give it. After the end of
  /// a job that does not repeat, returns its last point at rest. Never allocates.
  [[nodiscard]] Setpoint at(double t) const;

  /// Extreme values over time of position, velocity, acceleration and jerk. Exact for a table over
  /// time. For a cam over a master: 16 points between any two breaks, refined to the exact peak of
  /// position, velocity and acceleration wherever the next derivative changes sign.
  [[nodiscard]] const Ranges& ranges() const { return ranges_; }

  /// The largest jump of position, velocity and acceleration inside the run, and from its end to
  /// its start if it repeats: the sum of magnitudes of all jumps within one tick, at the start of
  /// that tick.
  [[nodiscard]] const std::array<Jump, 3>& steps() const { return steps_; }

  [[nodiscard]] const Setpoint& first() const { return first_; }
  [[nodiscard]] const Setpoint& last() const { return last_; }

  /// Distance, in master units, by which the master leaves a cam that does not permit it, and the
  /// time; 0: it stays inside.
  [[nodiscard]] const Extremum& master_excess() const { return master_excess_; }

  /// Reason why the cam cannot be coupled there; `ok` if it can, and without a cam.
  [[nodiscard]] CouplingStatus coupled() const { return coupled_; }
  /// True if a ramp engages the cam.
  [[nodiscard]] bool ramps() const { return !in_sync_ || *in_sync_ > start(); }
  /// True if the ramp ends before the job does.
  [[nodiscard]] bool gets_in_sync() const { return in_sync_.has_value(); }

  /// Tolerance for equal positions: 1e-9 of the stroke, and rounding.
  [[nodiscard]] double tolerance() const;

 private:
  void couple(const CouplingSpec& spec, double position, double tick);
  template <Signal S>
  void survey_steps(const S& slave, double tick);
  [[nodiscard]] Jet master(double t, Side side = Side::right) const;
  [[nodiscard]] Setpoint follow(const Jet& x, double t) const;

  std::shared_ptr<const Table> time_;
  std::shared_ptr<const Table> cam_;
  double least_ = 0;  // s of duration, for a ramp
  Engaged engaged_;
  CouplingStatus coupled_ = CouplingStatus::ok;
  std::optional<double> in_sync_;  // in sync of the time table; without a cam its start
  Setpoint first_;
  Setpoint last_;
  Ranges ranges_{};
  std::array<Jump, 3> steps_{};
  int direction_ = 0;
  Extremum master_excess_;
  Progress progress_ = Progress::running;
};

/// Checks a job against an axis in the state `from`: its start, rest at both ends (in a swap: the
/// velocity and acceleration of the previous motion), the position range, velocity, acceleration,
/// jerk, and jumps. Returns nullopt, or the first violated rule. Never allocates: a Job holds all
/// data.
///
/// A jump of the velocity, at an end or between, counts as the acceleration that makes it within
/// one tick. A table of straight lines therefore passes exactly if no tick exceeds the limit. With
/// a jerk limit, the same applies to a jump of the acceleration.
std::optional<Refusal> admit(const Job& job, const AxisConfig& config, const MotionState& from);
/// The same for an axis at rest.
inline std::optional<Refusal> admit(const Job& job, const AxisConfig& config, double position) {
  return admit(job, config, MotionState{position, 0, 0});
}

}  // namespace jounce
