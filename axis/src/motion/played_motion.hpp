// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/axis/profile_event.hpp"
#include "jounce/command/cause.hpp"

#include "axis/src/follow/live_player.hpp"
#include "axis/src/motion/armed_motion.hpp"
#include "axis/src/motion/own_move.hpp"
#include "axis/src/motion/path_player.hpp"
#include "axis/src/motion/setpoint_supervision.hpp"
#include "axis/src/motion/superimposed_move.hpp"

namespace jounce {

/// The axis in the present tick, as its motion reads it. u is the unit of the axis, m the unit of its
/// master.
struct MotionNow {
  std::int64_t tick = 0;           ///< the present tick
  std::int64_t last_tick = -1;     ///< the tick before it
  MotionState last = {};           ///< the last setpoint, with the superimposed move
  Moment moment = {};              ///< the masters, at time 0
  const AxisConfig& rules;         ///< limits in effect
  bool searches = false;           ///< a homing is in progress
  bool positive_switch = false;    ///< the positive limit switch is active
  bool negative_switch = false;    ///< the negative limit switch is active
  const Movement* next = nullptr;  ///< the armed movement whose start was accepted; null: none
};

/// The motion of an axis: which player gives its setpoints, how fast, and how the motion ends.
///
///     PlayedMotion motion(config);
///     motion.begin_tick();
///     motion.begin_path(begun, 0, now);                 // a movement begins
///     motion.end_by(Ending::stop);                      // its requested rate is now 0
///     if (motion.on_path()) setpoint = motion.path().play(...);
///     motion.put_out(bare, tick);                       // the setpoint was output
///     motion.rest();
///
/// Always true: one player at most gives the setpoints, and a motion that comes to its end, or is held,
/// requests the rate 0. A superimposed move is added to this motion only.
///
/// A PlayedMotion owns no movement. It does not allocate, lock or throw.
class PlayedMotion {
 public:
  /// The player of the motion, without the superimposed move. group: the group of the axis gives
  /// the setpoints.
  enum class Base : std::uint8_t { rest, path, live, move, group };
  /// Reason for the present stop. table: the movement ended at a nonzero velocity.
  enum class Ending : std::uint8_t { none, stop, release, group, halt, table, fault };

  explicit PlayedMotion(const AxisConfig& config)
      : config_(config), path_(config), live_(config.period), own_(config), above_(config) {}

  // ---- the kind of the motion

  [[nodiscard]] bool moving() const noexcept { return base_ != Base::rest; }
  [[nodiscard]] bool on_path() const noexcept { return base_ == Base::path; }
  [[nodiscard]] bool is_live() const noexcept { return base_ == Base::live; }
  [[nodiscard]] bool is_move() const noexcept { return base_ == Base::move; }
  [[nodiscard]] bool in_group() const noexcept { return base_ == Base::group; }
  /// The players. Only the player of the present kind gives setpoints.
  [[nodiscard]] PathPlayer& path() noexcept { return path_; }
  [[nodiscard]] const PathPlayer& path() const noexcept { return path_; }
  [[nodiscard]] LivePlayer& live() noexcept { return live_; }
  [[nodiscard]] const LivePlayer& live() const noexcept { return live_; }
  [[nodiscard]] OwnMove& own() noexcept { return own_; }
  [[nodiscard]] const OwnMove& own() const noexcept { return own_; }
  [[nodiscard]] SuperimposedMove& above() noexcept { return above_; }
  [[nodiscard]] const SuperimposedMove& above() const noexcept { return above_; }
  /// The movement that is played; null: none.
  [[nodiscard]] Movement* movement() const noexcept {
    return on_path() ? path_.path() : live_.movement();
  }
  /// The plan of cuts that is played; null: none.
  [[nodiscard]] LiveCuts* cuts() const noexcept { return is_live() ? live_->cuts() : nullptr; }
  /// True if the registration may correct the motion (registered_master.hpp).
  [[nodiscard]] bool follows_master() const noexcept { return is_live() && cuts() == nullptr; }
  /// True if the axis follows its master in step: the master alone determines its acceleration.
  [[nodiscard]] bool in_step() const noexcept {
    return is_live() && live_->progress() == Progress::running;
  }
  /// The move passes its target.
  [[nodiscard]] bool passes() const noexcept { return is_move() && own_.passes(); }

  // ---- begin and end

  /// Begins a tick.
  void begin_tick() noexcept { joined_ = false; }
  /// Plays this path. The path began `ahead` s before its tick.
  void begin_path(const ArmedMotion& begun, double ahead, const MotionNow& now) noexcept;
  /// Plays this coupling. Call Movement::begin() first.
  void begin_live(const ArmedMotion& begun, const MotionNow& now) noexcept;
  /// Follows the group of the axis from this tick on.
  void begin_group(std::int64_t tick) noexcept;
  /// Plays the own move, which was planned from the setpoint `last`.
  void begin_move(const MotionState& last) noexcept;
  /// The motion begins in this tick: the axis was at rest.
  void begin_at(std::int64_t tick) noexcept { begun_ = bare_.tick = tick; }
  /// One motion continues another in this tick.
  void join() noexcept { joined_ = true; }
  /// The motion comes to its end for this reason.
  void end_by(Ending ending) noexcept { ending_ = ending; }
  /// A motion that has stopped in a fault goes on, held.
  void go_on_held() noexcept {
    ending_ = Ending::none;
    held_ = moving();
  }
  /// The motion rests: its setpoint stays.
  void rest() noexcept;
  /// The superimposed move continues alone, as a move, after rest(). `held`: it is held. Returns false
  /// if no such move exists.
  bool continue_above(const MotionState& from, const Goal& goal, bool held,
                      const MotionNow& now) noexcept;
  /// The movement ends: returns it; null: there is none.
  Movement* end_movement() noexcept;
  /// The setpoint of this tick was output; `bare` is its state without the superimposed move.
  void put_out(const MotionState& bare, std::int64_t tick) noexcept {
    bare_ = {bare, tick};
    path_.put_out(tick);
  }
  [[nodiscard]] Ending ending() const noexcept { return ending_; }
  [[nodiscard]] bool ends() const noexcept { return ending_ != Ending::none; }
  /// Tick in which the motion began.
  [[nodiscard]] std::int64_t begun() const noexcept { return begun_; }
  /// Tick of the last setpoint.
  [[nodiscard]] std::int64_t put_out_in() const noexcept { return bare_.tick; }

  // ---- the rate

  /// Holds the motion, or lets it continue. Returns false and changes nothing if it cannot.
  bool hold(bool on, const MotionNow& now) noexcept;
  /// Sets the override. Returns false and changes nothing if the motion cannot take it.
  bool set_factor(double factor, const MotionNow& now) noexcept;
  /// A new motion is not held.
  void let_go() noexcept { held_ = false; }
  [[nodiscard]] bool held() const noexcept { return held_; }
  [[nodiscard]] double factor() const noexcept { return factor_; }
  /// The requested rate of the motion; a path may grant less.
  [[nodiscard]] double requested_rate(bool searches) const noexcept;
  /// The request to the path player.
  [[nodiscard]] PathRequest request(std::int64_t tick, bool searches,
                                    const Movement* next) const noexcept {
    return {tick, requested_rate(searches), above_.peaks(), next};
  }

  // ---- the own move

  /// The conditions under which a move is planned.
  [[nodiscard]] MoveConditions conditions(const MotionNow& now) const noexcept;
  /// Plans the move to this goal from the last setpoint of any motion. Returns false and changes
  /// nothing if no such move exists.
  bool plan(const Goal& goal, double factor, const MotionNow& now) noexcept;
  /// Adds a move that waits for the end of the motion, or returns the reason to reject it.
  std::optional<Refusal> buffer(const BufferedMove& move, const MotionNow& now) noexcept;
  /// Withdraws the waiting moves. Returns false if it is too late.
  bool withdraw(const MotionNow& now) noexcept { return own_.withdraw(planned(), conditions(now)); }
  /// Changes the velocity of the move, or returns the reason to reject the command.
  std::optional<Refusal> change(const command::ChangeVelocity& what, const MotionNow& now) noexcept;
  /// Position from which an additive move counts, u.
  [[nodiscard]] double additive_start(double position) const noexcept;

  // ---- a move and a phase shift on top

  /// Begins a superimposed move, or returns the reason to reject it.
  std::optional<Refusal> superimpose(double distance, const MoveDynamics& dynamics,
                                     const MotionNow& now) noexcept;
  /// Begins to shift the phase of the coupling, or returns the reason to reject the command.
  std::optional<Refusal> shift_phase(double target, const MoveDynamics& dynamics,
                                     const MotionNow& now) noexcept;

  /// Cuts, or parks the cutter. Returns the reason to reject the command.
  std::optional<Refusal> cut(const command::Cut& what) noexcept;
  std::optional<Refusal> park() noexcept;

  // ---- the setpoint

  /// The setpoint of a coupling, and its events. `profile`: the events of the previous tick.
  Cause advance_live(Setpoint& next, ProfileStep& profile, bool master_moved,
                     const MotionNow& now) noexcept;
  /// The state in which the motion will come to rest, or in which a pass of it ends; nullopt: not
  /// available.
  [[nodiscard]] std::optional<MotionState> expected_end(double position) const noexcept;
  /// True if it is held on its path, or stopped there by an underrun and reset: the armed movement
  /// may begin from here.
  [[nodiscard]] bool stands(std::int64_t tick, double velocity) const noexcept;
  /// True if only the first point of the path was output, at the position of the axis.
  [[nodiscard]] bool unplayed(double velocity) const noexcept {
    return on_path() && path_.unplayed() && velocity == 0 && !above_.running();
  }
  /// True for braking in a fault, whose setpoints are not checked.
  [[nodiscard]] bool brakes_in_fault() const noexcept {
    return is_move() && ending_ == Ending::fault;
  }
  /// The motion, for the check of its next setpoint. `skipped`: ticks that were skipped.
  [[nodiscard]] SupervisedMotion supervised(std::int64_t skipped,
                                            const MotionNow& now) const noexcept;

 private:
  [[nodiscard]] const TimedState* planned() const noexcept { return is_move() ? &bare_ : nullptr; }
  bool replan(const MotionNow& now) noexcept;
  bool replan_path(const MotionNow& now) noexcept;
  bool replan_move(const MotionNow& now) noexcept;
  void begin(Base base, const ArmedMotion& begun, std::int64_t tick) noexcept;
  [[nodiscard]] Peaks beneath(const MotionNow& now) const noexcept;
  [[nodiscard]] bool inside_as_a_whole(bool searches) const noexcept;

  AxisConfig config_;
  Base base_ = Base::rest;
  PathPlayer path_;
  LivePlayer live_;
  OwnMove own_;
  SuperimposedMove above_;
  Ending ending_ = Ending::none;
  double factor_ = 1;  // override
  bool held_ = false;
  std::int64_t begun_ = 0;
  TimedState bare_;      // the last output setpoint, without the superimposed move
  bool joined_ = false;  // one motion continues another in this tick
};

}  // namespace jounce
