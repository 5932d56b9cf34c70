// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "jounce/axis/axis.hpp"

#include "axis/src/compensation/axis_coordinate.hpp"
#include "axis/src/homing/home_search.hpp"
#include "axis/src/motion/later_command.hpp"
#include "axis/src/motion/played_motion.hpp"
#include "axis/src/motion/start_slot.hpp"
#include "axis/src/probe/registered_master.hpp"
#include "axis/src/probe/touch_probe.hpp"
#include "axis/src/state/axis_outputs.hpp"
#include "axis/src/state/supervision.hpp"

namespace jounce {

/// The state machine of an axis: its states, its faults, and the order of its parts in a tick. Each part
/// owns its own state (docs/decisions/0183-parts-of-the-axis.md). The functions are listed by the source
/// that defines them. See MotionAxis.
class MotionAxis::Impl {
 public:
  Impl(const AxisConfig& config, const AxisSwitches& switches, const AxisCompare& compare);

  Tick step(std::int64_t tick, const Command& command, const Inputs& inputs);
  Jet compensate(const References& references);
  [[nodiscard]] const AxisConfig& config() const { return config_; }
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] std::span<const Jet> parts() const { return outputs_.parts(); }
  [[nodiscard]] std::span<const Jet> places() const;

 private:
  /// Reason to reject a command; nullopt: accepted.
  using Rejection = std::optional<Refusal>;
  using Ending = PlayedMotion::Ending;

  // axis.cpp: one tick
  void take(const Inputs& inputs);
  void see_renamed(const Inputs& before);
  void watch();
  void play();
  Cause advance(Setpoint& next, const MotionNow& now);
  Cause advance_live(Setpoint& next, const MotionNow& now);
  Cause advance_move(Setpoint& next, const MotionNow& now);
  void give_out(const Setpoint& next);
  void operate_outputs();
  void report();
  void hand_back(const Movement* movement);
  void drop(const Refusal& why);
  [[nodiscard]] bool miss_event(Cause wrong, const Setpoint& next);
  [[nodiscard]] bool moving() const { return motion_.moving(); }
  [[nodiscard]] bool on_path() const { return motion_.on_path(); }
  [[nodiscard]] MotionState last() const;
  [[nodiscard]] Moment moment() const { return {0, dt(), inputs_.master, inputs_.second_master}; }
  [[nodiscard]] MotionNow present() const;
  [[nodiscard]] PathRequest request() const {
    return motion_.request(now_.tick, home_.running(), slot_.waiting());
  }
  [[nodiscard]] double dt() const { return seconds((now_.skipped + 1) * config_.period); }

  // axis_commands.cpp: commands
  void obey(const Command& command);
  Rejection take_up(const Command& command);
  [[nodiscard]] bool needs_home(const Command& command) const;
  Rejection execute(const AxisCommand& command);
  Rejection reset();
  Rejection set_position(const command::SetPosition& what);
  Rejection override_by(double factor);
  Rejection finish();
  Rejection extend(const command::Extend& what);
  Rejection power(bool on);
  Rejection rename_to(double position);
  Rejection end_motion(Ending ending, const MoveDynamics& asked = {});
  void break_groups();
  void stop_with_group();
  Rejection hold(bool on);

  // axis_group.cpp: a group, and an axis of a group
  [[nodiscard]] Cause against_compensation(CommandKind kind) const;
  [[nodiscard]] Rejection against_peers() const;
  void follow_group();
  Cause advance_group(Setpoint& next) const;
  [[nodiscard]] bool is_group() const { return is_of_group(inputs_.peers); }

  // axis_coordinate_commands.cpp: coordinates of the axis and of its master, compensation, touch probes
  Rejection set_compensation(bool on);
  void see_feedback();
  [[nodiscard]] bool keeps_coordinate() const;
  void probe();

  // axis_homing.cpp: the search for the home position
  Rejection home(const command::Home& what);
  void seek();
  void find_home();
  [[nodiscard]] Homing::Seen seen() const;

  // axis_starts.cpp: armed movements and their starts
  Rejection arm(const command::Arm& what);
  Rejection start(const command::Start& what);
  Rejection couple(const command::Couple& what);
  void disarm();
  void begin_due();
  [[nodiscard]] std::optional<Moment> begins_at();
  [[nodiscard]] Rejection against_active_switch() const;
  void begin_pending(const Moment& at);
  void enter(const ArmedMotion& begun);
  [[nodiscard]] std::optional<MotionState> state_at(const Moment& at, Cause& no);
  [[nodiscard]] State playing_state() const;

  // axis_path.cpp: motion along a path, and the change to another path
  Cause advance_path(Setpoint& next);
  Rejection start_at_end();
  Cause swap_at_boundary();
  void swap_at_master(double s);
  void swap(double boundary, MotionState end);

  // axis_moves.cpp: moves that the axis plans
  Rejection move_or_buffer(const BufferedMove& what);
  Rejection move(const BufferedMove& what);
  Rejection move_on(const command::MoveAdditive& what);
  Rejection superimpose(const command::MoveSuperimposed& what);
  Rejection repeat(const command::MoveRepetitive& what);
  Rejection take_over(const Goal& goal);
  Rejection decouple();
  [[nodiscard]] MoveRules move_rules() const;
  bool go(const Goal& goal);
  bool adopt(const Goal& goal, double factor);
  void brake(double deceleration);
  void leave(Goal::Kind kind);

  // axis_buffer.cpp: commands that wait for a tick, and moves that wait for the present motion
  Rejection postpone(const Command& command);
  void obey_due();
  Rejection take_back_next();
  void begin_next();
  void note(const std::optional<Refusal>& why);

  // axis_ends.cpp: the end of a motion
  void conclude();
  void rest();
  void freeze();
  void cut_off();
  void fail(Cause cause, double value = std::numeric_limits<double>::quiet_NaN());
  void drop_movement();

  AxisConfig config_;
  State state_ = State::disabled;
  std::int64_t last_tick_ = -1;
  Inputs inputs_;
  RegisteredMaster master_;
  AxisCoordinate coordinate_;
  Supervision windows_;

  StartSlot slot_;
  PlayedMotion motion_;
  LaterCommand later_;  // the command that waits for its tick

  HomeSearch home_;  // runs until the axis is at rest
  TouchProbes probes_;
  AxisOutputs outputs_;
  Tick now_;  // the outputs, kept from tick to tick
};

}  // namespace jounce
