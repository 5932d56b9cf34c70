// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/gear/cut_plan.hpp"
#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// A plan of cuts on the live master of the axis, the web (docs/gear/cuts.md). The axis must stand
/// at the home position of its cutter.
///
///     LiveCuts cuts(7, task, config);
///     axis.step(t, {command::Couple{&cuts}}, inputs);
///     axis.step(t + 1, {command::Cut{.length = 800}}, inputs);
///     axis.step(t + 2, {command::Park{}}, inputs);
///
/// Progress is `waiting` while the cutter rests at home, and `running` otherwise. After park(), it
/// is `done` when the cutter is at home. Progress is `broken` if the web is lost, or moves back
/// beyond the cut before the last one.
///
/// **Park.** While the cutter is in step with the web around a cut, it stays in step. Then it
/// leaves the web and moves home in the shortest time within the limits of the axis. A knife that
/// has left home for a cut, or recovers towards a cut, makes this cut first: on another way home,
/// its blade would pass through the web.
class LiveCuts final : public Movement {
 public:
  /// `id` is the id of the motion in Tick::job. `config`: the axis, with its limits.
  LiveCuts(std::uint64_t id, std::shared_ptr<const CutTask> task, const AxisConfig& config);

  /// Returns none, no_master_input, in_motion, or cutter_away if the axis does not stand at a home
  /// position of the cutter.
  Cause begin(const MotionState& axis, const Moment& now) noexcept override;
  Setpoint at(const Moment& now) noexcept override;
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override { return cause_; }
  [[nodiscard]] double place() const noexcept override { return place_; }
  [[nodiscard]] LiveCuts* cuts() noexcept override { return this; }

  /// Changes the plan. `shift` is added to positions of the web in the answer. Returns nullopt, or
  /// the reason to reject the command; the numbers of the refusal are in m (unit of the web).
  std::optional<Refusal> cut(const command::Cut& what, double shift) noexcept;
  /// Makes no more cuts, and returns the cutter to its home position.
  void park() noexcept;

  [[nodiscard]] const CutPlan& plan() const noexcept { return plan_; }

 private:
  [[nodiscard]] bool leaves(const Moment& now) noexcept;
  Setpoint way_home(const Moment& now) noexcept;

  std::shared_ptr<const CutTask> task_;
  CutPlan plan_;
  Bounds bounds_;
  double near_;       // distance from home at which the plan may begin, u
  double base_ = 0;   // position of the axis at the first cut of a knife, u
  double place_ = 0;  // home position at the start, u
  double web_velocity_ = 0;
  bool parks_ = false;
  std::optional<Profile> home_;  // the way home over time
  double home_start_ = 0;        // s
  Progress progress_ = Progress::waiting;
  Cause cause_ = Cause::none;
  Setpoint last_;
};

}  // namespace jounce
