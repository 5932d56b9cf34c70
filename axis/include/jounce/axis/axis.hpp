// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "jounce/axis/armed_motion.hpp"
#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/command.hpp"
#include "jounce/axis/group_state.hpp"
#include "jounce/axis/homing.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/axis/live_player.hpp"
#include "jounce/axis/move_goal.hpp"
#include "jounce/axis/move_player.hpp"
#include "jounce/axis/outputs.hpp"
#include "jounce/axis/path_outputs.hpp"
#include "jounce/axis/path_player.hpp"
#include "jounce/axis/position_history.hpp"
#include "jounce/axis/repetition.hpp"
#include "jounce/axis/superimposed_move.hpp"
#include "jounce/axis/supervision.hpp"
#include "jounce/axis/touch_probe.hpp"
#include "jounce/axis/waiting_moves.hpp"
#include "jounce/command/state.hpp"
#include "jounce/path/point.hpp"

namespace jounce {

/// The group of the movement that an axis has armed, and the start of this movement. A group is a
/// set of motions of several axes that start and stop together.
struct GroupStart {
  std::int64_t group = 0;  ///< number of the group; 0: no group
  bool accepted = false;   ///< true if the start of the movement was accepted
  std::int64_t tick = -1;  ///< tick of the start; -1: no tick was given
};

/// The outputs of an axis in one tick. Units: u is the unit of the axis, m the unit of its master.
struct Tick {
  std::int64_t tick = 0;          ///< number of the tick
  double time = 0;                ///< tick * period, s
  State state = State::disabled;  ///< state of the axis
  double master = 0;              ///< position of the master, m
  double master_velocity = 0;     ///< velocity of the master, m/s
  double position = 0;            ///< commanded position (setpoint), u
  double velocity = 0;            ///< commanded velocity, u/s
  double acceleration = 0;        ///< commanded acceleration, u/s^2
  /// Id of the movement that is played; 0: none, or a move that the axis plans.
  std::uint64_t job = 0;
  std::uint64_t armed = 0;             ///< id of the armed movement; 0: none
  bool waiting = false;                ///< true if an accepted start, move or command has not begun
  Progress progress = Progress::done;  ///< progress of the motion that is played
  Cause fault = Cause::none;           ///< the latched fault; none: no fault
  /// The number that exceeded a limit at the fault: the following error (u), the velocity (u/s) of
  /// overspeed, or the acceleration (u/s^2) of overacceleration and jump; NaN: none.
  double fault_value = std::numeric_limits<double>::quiet_NaN();
  std::int64_t skipped = 0;    ///< ticks skipped between the previous step and this one
  std::uint64_t finished = 0;  ///< number of motions that reached their end, so far
  std::uint64_t stopped = 0;   ///< number of motions that a stop brought to rest, so far
  /// Why the last motion ended: a fault, stopped, halted, ...; none: the motion reached its end. After
  /// a start with a live master that was dropped at rest: the reason of the drop.
  Cause reason = Cause::none;
  double override_ = 1;    ///< override factor in effect, 0 to 2
  double rate = 1;         ///< present rate of path time: 1 is the original speed of the path
  double path_time = 0;    ///< time of the path that is played, s; 0: no path
  bool held = false;       ///< true if the motion is held until the command resume
  bool homed = false;      ///< true after homing: the position refers to the home position
  bool power = false;      ///< request to the drive: follow the setpoints
  std::int64_t group = 0;  ///< number of the group of the motion that is played; 0: no group
  GroupStart next{};       ///< group and start of the armed movement
  /// Groups that this axis has broken; 0: none. [0]: the group of its motion, [1]: the group of its
  /// armed movement. An axis breaks a group if a stop, a halt, a fault or a rejected start ends the
  /// motion or the armed movement early. A number stays until the axis arms a movement of that
  /// group again.
  std::array<std::int64_t, 2> broken{};
  bool frozen = false;  ///< true if the velocity fell to 0 at once in this tick, without braking;
                        ///< see `fault`
  /// Sum of all changes by set_position so far, u. The position of the drive is position - offset.
  double offset = 0;
  /// Position that the drive reports, in the coordinate of the axis, u; NaN: unknown.
  double actual_position = std::numeric_limits<double>::quiet_NaN();
  /// Setpoint minus actual position, u; NaN: unknown.
  double following_error = std::numeric_limits<double>::quiet_NaN();
  /// Share of the rated torque; NaN: unknown.
  double torque = std::numeric_limits<double>::quiet_NaN();
  /// True if the axis is at standstill, and the following error has been within the window
  /// AxisConfig::in_position for AxisConfig::in_position_time.
  bool in_position = false;
  SwitchStep switches{};  ///< outputs of the cam switches, with their edges since the previous tick
  /// Output of the position compare, with its edges since the previous tick.
  CompareStep compare{};
  ProfileStep profile{};  ///< events of the cam or the follow tables on the live master
  ProbeStep probe{};      ///< captures of the touch probes in this tick
  RegistrationReading registration{};  ///< state of the registration
  bool compensated = false;            ///< true if the compensation is active
  /// Correction of the compensation and its derivatives, u, u/s, u/s^2; 0 if it is not active. The
  /// drive receives position + correction[0] - offset.
  Jet correction{};
  /// Ratio of the gear that the axis plays, u/m; 0: it plays no gear.
  double ratio = 0;

  std::optional<Refusal> refused{};  ///< reason why the command of this tick was rejected
  std::optional<Refusal> dropped{};  ///< reason why the waiting motion was dropped
  /// For the fault axis_fault: the axis of the group, as in a rejection axis_not_ready.
  std::optional<Refusal> failed_axis{};
  /// Movements that the axis no longer reads: the caller may destroy or reuse them.
  std::array<const Movement*, 3> handed_back{};
};

/// True if the axis moves now, or will move later without a further command. The motion may be a
/// movement, a move that the axis plans itself, or braking in a fault. A held motion counts; a
/// motion at rest after an underrun does not.
bool in_motion(const Tick& tick);

/// An axis as a pure state machine: each call of step() computes one tick. It has no clock. step()
/// does not allocate, free, lock, log or throw.
///
///     MotionAxis axis({.limits = {.velocity = 1000, .acceleration = 1e4}});
///     axis.step(0, {command::Enable{}});
///     axis.step(1, {command::Arm{&job}});
///     axis.step(2, {command::Start{}});                  // local time 0: the table's first point
///     Tick now = axis.step(3);                           // bit for bit job.at(0.001)
///
/// **Time** is the number of the tick times the period, so rounding errors do not accumulate. The
/// numbers of the ticks must ascend. If ticks are skipped, the motion skips the same time.
///
/// **Motion.** The axis plays either a movement, or a move that it plans itself from its last
/// setpoint. A movement is a path (whose time the axis can slow down) or a coupling to a live
/// master. A superimposed move is added to either. Rules: command_table.hpp and
/// docs/executor/axis.md.
///
/// **Slots.** The axis holds two movements, one that it plays and one that is armed. It owns
/// neither. When it reads a movement for the last time, it returns the movement in
/// Tick::handed_back, once.
///
/// **Outputs** (cam switches, position compare) are computed in each tick from its positions. A new
/// coordinate (set_position), or a new master at the start of a motion, passes no switch and no
/// compare position; a switch whose state differs at the new position changes at time 0 of the
/// tick. Outputs are computed in every state, even if the axis is disabled or in a fault.
///
/// **Drives.** Feedback is in the coordinate of the drive. set_position changes the coordinate of
/// the axis by `offset`, and does not move the drive. While the axis is disabled, its setpoint is
/// the position of the drive, if the drive reports a position; so enabling the axis causes no
/// motion.
///
/// **Homing** (homing.hpp) finds the home position of the machine from the switches and the index
/// that the drive reports. During homing, the position range does not apply, and the axis may stand
/// on a limit switch.
///
/// **Touch probes** (touch_probe.hpp) capture positions at the edges of trigger inputs, in every
/// state.
///
/// **Compensation** (AxisConfig::compensation) adds a correction to the setpoint of the drive, after
/// all checks. The position of the axis, its limits and its outputs do not include it; feedback is
/// converted back. It is switched on and off while the axis is disabled, and moves nothing then. While
/// it is active, the coordinates of the axis and of its references do not change.
///
/// **Registration** (AxisConfig::registration) corrects every motion that follows the live master by
/// the marks that a trigger input reports. It begins without a correction when such a motion begins,
/// and continues if another such motion replaces it. A correction of the master (a phase) is included
/// in Tick::master.
///
/// **Groups.** Inputs::peers states whether a MotionAxis is a group of the machine, or an axis of a
/// group (docs/executor/groups.md). The position of a group is the length along its path. The
/// setpoints for the axes of the group are parts(); in motion, each axis of the group receives its
/// setpoint as Inputs::master.
///
/// **Safety.** When the axis arms a movement, it checks the movement against its limits, for every
/// sender. Before the axis outputs a setpoint in motion, it compares the setpoint with the previous
/// one and with the limits. A fault stays until a reset. reaction_to() returns the reaction of the
/// axis to each fault.
class MotionAxis {
 public:
  /// Throws InputError for an invalid configuration, invalid switches, or an invalid compare list.
  explicit MotionAxis(const AxisConfig& config, const AxisSwitches& switches = {},
                      const AxisCompare& compare = {});

  /// Executes the command and returns the outputs of this tick. Call once a tick; `tick` must be >=
  /// 0 and greater than in the previous call (asserted).
  Tick step(std::int64_t tick, const Command& command = {}, const Inputs& inputs = {});

  /// Second part of a tick, after step() of every axis of the machine: computes the correction of the
  /// compensation from the setpoints of its references. Returns it as Tick::correction, also for the
  /// next step. Requires AxisConfig::compensation.
  Jet compensate(const References& references);

  /// The configuration with its defaults filled in.
  [[nodiscard]] const AxisConfig& config() const { return config_; }
  /// State after the last step.
  [[nodiscard]] State state() const { return state_; }
  /// For a group (AxisGroup in machine.hpp): the setpoints of its axes after the last step: u, u/s,
  /// u/s^2, u/s^3. Empty if it had no path yet.
  [[nodiscard]] std::span<const Jet> parts() const;
  /// For a group: the positions at which its axes must stand when it next begins to move. At rest
  /// with an armed path: the start of this path; otherwise parts().
  [[nodiscard]] std::span<const Jet> places() const;

 private:
  /// Reason to reject a command; nullopt: accepted.
  using Rejection = std::optional<Refusal>;

  /// The player of the motion, without the superimposed move. group: the group of the axis gives
  /// the setpoints.
  enum class Base : std::uint8_t { rest, path, live, move, group };
  /// Reason for the present stop. table: the movement ended at a nonzero velocity.
  enum class Ending : std::uint8_t { none, stop, release, group, halt, table, fault };

  // axis.cpp: one tick
  void take(const Inputs& inputs);
  void see_renamed(const Inputs& before);
  void watch();
  void play();
  Cause advance(Setpoint& next);
  Cause advance_live(Setpoint& next);
  Cause advance_move(Setpoint& next);
  [[nodiscard]] Cause judge(const Setpoint& next) const;
  [[nodiscard]] double excess(Cause wrong, const Setpoint& next) const;
  [[nodiscard]] double joint_step() const;
  [[nodiscard]] bool in_step() const;
  [[nodiscard]] bool inside_as_a_whole() const;
  void give_out(const Setpoint& next);
  void operate_outputs();
  void report();
  void hand_back(const Movement* movement);
  void drop(const Refusal& why);
  [[nodiscard]] bool moving() const { return base_ != Base::rest; }
  [[nodiscard]] bool on_path() const { return base_ == Base::path; }
  [[nodiscard]] Movement* active() const;
  [[nodiscard]] MotionState last() const;
  [[nodiscard]] Moment moment() const { return {0, dt(), inputs_.master, inputs_.second_master}; }
  [[nodiscard]] double dt() const { return seconds((now_.skipped + 1) * config_.period); }
  [[nodiscard]] double requested_rate() const;
  [[nodiscard]] PathRequest request() const;

  // axis_commands.cpp: commands
  void obey(const Command& command);
  Rejection take_up(const Command& command);
  [[nodiscard]] bool needs_home(const Command& command) const;
  Rejection act(const command::None& /*none*/) { return std::nullopt; }
  Rejection act(const command::Enable& /*on*/) { return power(true); }
  Rejection act(const command::Disable& /*off*/) { return power(false); }
  Rejection act(const command::Arm& what);
  Rejection act(const command::Disarm& what);
  Rejection act(const command::Start& what);
  Rejection act(const command::Stop& what) { return end_motion(Ending::stop, what.dynamics); }
  Rejection act(const command::Abort& /*now*/) {
    fail(Cause::aborted);
    return std::nullopt;
  }
  Rejection act(const command::Reset& what);
  Rejection act(const command::SetPosition& what);
  Rejection act(const command::Home& what);
  Rejection act(const command::Hold& /*on*/) { return hold(true); }
  Rejection act(const command::Resume& /*off*/) { return hold(false); }
  Rejection act(const command::Override& what);
  Rejection act(const command::Finish& what);
  Rejection act(const command::MoveAbsolute& what) { return move_or_buffer(what); }
  Rejection act(const command::MoveRelative& what) { return move_or_buffer(what); }
  Rejection act(const command::MoveAdditive& what);
  Rejection act(const command::MoveSuperimposed& what);
  Rejection act(const command::MoveVelocity& what) { return move_or_buffer(what); }
  Rejection act(const command::Halt& what) { return end_motion(Ending::halt, what.dynamics); }
  Rejection act(const command::Couple& what);
  Rejection act(const command::GearOut& /*out*/) { return decouple(); }
  Rejection act(const command::CamOut& /*out*/) { return decouple(); }
  Rejection act(const command::TouchProbe& what) {
    return probes_.start(what, inputs_.feedback, config_);
  }
  Rejection act(const command::AbortTrigger& what) { return probes_.abort(what.input); }
  Rejection act(const command::EnableCompensation& /*on*/) { return set_compensation(true); }
  Rejection act(const command::DisableCompensation& /*off*/) { return set_compensation(false); }
  Rejection act(const command::Cut& what);
  Rejection act(const command::Park& it);
  Rejection act(const command::Release& /*it*/) { return end_motion(Ending::release); }
  Rejection act(const command::Extend& what);
  Rejection power(bool on);
  Rejection set_position(double position);
  Rejection end_motion(Ending ending, const MoveDynamics& asked = {});
  void break_groups();
  void stop_with_group();
  Rejection hold(bool on);
  Rejection replan();

  // axis_group.cpp: a group, and an axis of a group
  [[nodiscard]] Cause against_group(CommandKind kind) const;
  [[nodiscard]] Rejection against_axes() const;
  [[nodiscard]] Rejection against_reset() const;
  [[nodiscard]] Refusal axis_refusal(Cause cause) const;
  [[nodiscard]] Rejection against_extension(const command::Extend& what) const;
  void follow_group();
  Cause advance_group(Setpoint& next) const;
  void keep_parts();
  [[nodiscard]] bool is_group() const { return is_of_group(inputs_.peers); }

  // axis_registration.cpp: positions of the last ticks, touch probes, registration
  void remember_master();
  void register_marks();
  void end_of_marks();
  void add_correction(Setpoint& next) const;
  void probe();

  // axis_compensation.cpp: the compensation, and feedback in the coordinate of the axis
  Rejection set_compensation(bool on);
  void see_feedback();
  [[nodiscard]] bool keeps_coordinate() const;
  void rename(double by);

  // axis_phasing.cpp: the phase shift of a coupling
  Rejection act(const command::PhasingAbsolute& what);
  Rejection act(const command::PhasingRelative& what);
  Rejection shift_phase(double target, const MoveDynamics& dynamics);

  // axis_strokes.cpp: repetitive moves, and changes of the velocity of a move
  Rejection act(const command::MoveRepetitive& what);
  Rejection act(const command::ChangeVelocity& what);
  Cause begin_strokes();
  [[nodiscard]] bool repeats() const;
  Rejection change_velocity(double velocity, const TimedState& from, double ahead);
  void change_if_passed();

  // axis_homing.cpp: the search for the home position
  void seek();
  void find_home();
  [[nodiscard]] Homing::Seen seen() const;
  /// The limits in effect; during homing, without the position range.
  [[nodiscard]] const AxisConfig& rules() const { return homing_ ? unranged_ : config_; }

  // axis_starts.cpp: armed movements and their starts
  void disarm();
  void begin_due();
  [[nodiscard]] std::optional<Moment> begins_at();
  [[nodiscard]] std::optional<Moment> crossing() const;
  [[nodiscard]] std::optional<Refusal> against_demand(const Moment& start) const;
  [[nodiscard]] std::optional<Refusal> against_jump() const;
  [[nodiscard]] double followed_ratio() const;
  [[nodiscard]] Refusal begin_refusal(Cause no, const MotionState& state) const;
  [[nodiscard]] std::optional<Refusal> against_switch(const Movement& path) const;
  void begin_pending(const Moment& at);
  void enter(const ArmedMotion& begun);
  [[nodiscard]] std::optional<MotionState> state_at(const Moment& at, Cause& no);
  [[nodiscard]] std::optional<MotionState> expected_end() const;
  [[nodiscard]] bool stands() const;
  [[nodiscard]] State playing_state() const;

  // axis_path.cpp: motion along a path, and the change to another path
  Cause advance_path(Setpoint& next);
  bool replan_path();
  Rejection start_at_end();
  Rejection start_at_pass_end();
  [[nodiscard]] Rejection against_swap() const;
  Cause swap_at_boundary();
  void swap_at_master(double s);
  void swap(double boundary, MotionState end);

  // axis_moves.cpp: moves that the axis plans
  Rejection move_or_buffer(const BufferedMove& what);
  Rejection move(const BufferedMove& what);
  Rejection take_over(const Goal& goal);
  Rejection superimpose(double distance, const MoveDynamics& dynamics);
  Rejection decouple();
  [[nodiscard]] MoveRules move_rules() const;
  [[nodiscard]] Peaks beneath() const;
  bool go(const Goal& goal);
  bool adopt(const Goal& goal, double factor);
  bool plan_from(const TimedState& from, const Goal& goal, double factor, double ahead = 0);
  bool replan_move();
  void brake(double deceleration);
  void leave(Goal::Kind kind);

  // axis_cut.cpp: act() of Cut and Park

  // axis_buffer.cpp: commands that wait for a tick, and moves that wait for the present motion
  Rejection postpone(const Command& command);
  void obey_due();
  void forget_later();
  Rejection buffer(const BufferedMove& move);
  [[nodiscard]] double through(const MotionState& from, const Goal& goal, double factor) const;
  [[nodiscard]] bool passes() const;
  Cause pass_target();
  Rejection take_back_next();
  void begin_next();
  void forget(const WaitingMoves& moves);
  void forget_next();

  // axis_ends.cpp: the end of a motion
  void conclude();
  void rest();
  [[nodiscard]] Cause reason_to_rest() const;
  void freeze();
  void cut_off();
  void fail(Cause cause, double value = std::numeric_limits<double>::quiet_NaN());
  void drop_movement();

  AxisConfig config_;
  AxisConfig unranged_;  // config_ without the position range
  State state_ = State::disabled;
  std::int64_t last_tick_ = -1;
  Inputs inputs_;
  Jet last_master_ = Inputs{}.master;  // last value of the live master
  Supervision windows_;

  ArmedMotion armed_;
  std::int64_t group_ = 0;  // group of the motion
  GroupState groups_;

  Base base_ = Base::rest;
  PathPlayer path_;
  LivePlayer live_;
  MovePlayer move_;
  SuperimposedMove above_;                         // superimposed on the motion
  WaitingMoves next_;                              // moves that wait for the end of the motion
  std::optional<Command> later_;                   // the command that waits for its tick
  std::optional<Repetition> repetition_;           // strokes of the move
  std::optional<command::ChangeVelocity> change_;  // waits until the move passes its position

  Ending ending_ = Ending::none;
  double factor_ = 1;  // override
  bool held_ = false;
  std::int64_t begun_ = 0;             // tick at which the motion began
  TimedState bare_;                    // the last output setpoint, without the superimposed move
  bool joint_ = false;                 // true if one motion continues another in this tick
  std::array<Jet, max_axes> parts_{};  // setpoints of the axes of a group
  std::size_t part_count_ = 0;

  std::optional<Homing> homing_;  // the homing in progress, until the axis is at rest

  TouchProbes probes_;
  PositionHistory commanded_seen_, actual_seen_, master_seen_;
  std::optional<LiveRegistration> registration_;
  Jet phase_{};  // correction of the master that inputs_.master includes
  std::optional<LiveCompensation> compensation_;
  double in_feedback_ = 0;  // correction that the feedback of this tick includes

  bool has_master_ = false;  // true from the start of a cam to the next table without a cam
  std::array<std::size_t, 2> plane_axes_;
  Outputs outputs_;
  PathOutputs path_outputs_;  // outputs of the path of a group
  Tick now_;
};

}  // namespace jounce
