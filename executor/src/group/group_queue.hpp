// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/axis/detail/path_commands.hpp"
#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/executor/detail/worker.hpp"
#include "jounce/executor/executor_options.hpp"

#include "executor/src/group/group_dynamics.hpp"
#include "executor/src/group/group_stages.hpp"
#include "executor/src/group/group_step.hpp"
#include "executor/src/group/planned_motion.hpp"
#include "executor/src/group/sent_motion.hpp"

namespace jounce {

/// The single commands of a group: lines, arcs, waits, jogs. The queue belongs to the communication
/// thread. It appends each new command to the commands that the group plays, and plans all of them
/// together, from a command that the group has already passed. The group changes to this longer
/// plan while it equals the present plan, so the present motion does not change. Every plan ends at
/// rest, so the group can always stop on its path. One command at a time is planned; the others
/// wait.
///
/// If the group already brakes for the end of its path when a command arrives, the command begins
/// at rest. Commands that arrive while the group plays a path that was sent as a whole, or a fast
/// move, are planned from the end of this motion, and begin there at rest. So do commands after an M
/// word, when it is acknowledged, and in single step.
///
/// A program that was sent as a whole also waits at its M words and in single step: begins() adds
/// what follows its first motion.
///
///     queue.take(command, request);
///     while (const auto step = queue.next(tick)) ...    // often; the server executes the GroupStep
///     queue.answered(true, movement);                   // the group has accepted a Play or Extend
class GroupQueue {
 public:
  using Request = group_step::Request;
  /// Returns the program of a movement of the group; null: none.
  using ProgramOf = std::function<std::shared_ptr<const GroupProgram>(std::uint64_t movement)>;
  /// Greatest number of commands that have not ended (the default of HIMC).
  static constexpr std::size_t most_commands = 512;

  /// `worker` must outlive the queue. `most_at_once`: the greatest number of commands that the
  /// calling thread plans itself; the worker plans longer programs. `places`: returns the present
  /// positions of the axes of the group.
  GroupQueue(const ExecutorGroup& group, Worker& worker, std::size_t most_at_once,
             std::function<Point()> places, ProgramOf program_of = {});
  /// Cancels the planning in progress.
  ~GroupQueue();
  GroupQueue(const GroupQueue&) = delete;
  GroupQueue& operator=(const GroupQueue&) = delete;

  /// Adds a command of the group.
  void take(const ClientCommand& command, const Request& request);
  /// Returns the next step that the server must execute; nullopt: none now. `group`: the newest
  /// tick of the group.
  [[nodiscard]] std::optional<GroupStep> next(const Tick& group);
  /// Reports whether the group has accepted the last Play or Extend. `movement`: id of the movement
  /// that the group then plays.
  void answered(bool accepted, std::uint64_t movement);
  /// Reports that the group has begun the first motion of a program that was sent as a whole.
  /// `movement`: id of this motion. `last`: number of the command after it. `group`: the first tick of
  /// the motion.
  void begins(std::uint64_t movement, std::shared_ptr<const GroupProgram> motion,
              std::shared_ptr<const SentProgram> sent, std::size_t last, const Tick& group);
  /// True if commands wait for the end of the present motion, or for an acknowledgment.
  [[nodiscard]] bool has_stages() const { return !stages_.empty(); }
  /// Drops the commands that are not yet planned, because their session has ended.
  void cancel();
  /// Drops all commands that the group does not play, including waits before the first motion.
  void clear();

  /// Reports that a hold-to-run jog was released: the next command then waits until the group
  /// rests.
  void release() { releasing_ = true; }

  /// Sets the limits of the commands that follow. If `from_rest` is true, the next command begins at
  /// rest.
  void limit(GroupDynamics::Next next, bool from_rest);
  /// The highest rate at which the group may play until the next step: a longer plan that is faster
  /// must take over at a lower rate.
  [[nodiscard]] double highest_rate() const;
  /// The reason why the group rests: a jog ended at the last place that it can reach, or an M word
  /// waits for its acknowledgment, or was not acknowledged in time; or none.
  [[nodiscard]] Cause rests_because(const Tick& group) const;

  /// Acknowledges the M word at which the group waits, or begins the next command in single step.
  /// `number`: its number; 0: any. Returns none, or no_handshake if the group does not wait for it.
  [[nodiscard]] Cause acknowledge(std::int32_t number) { return stages_.acknowledge(number); }
  /// Number of the M word at which the group waits; nullopt: none.
  [[nodiscard]] std::optional<std::int32_t> m_word() const { return stages_.m_word(); }
  /// True: each of the commands that follow begins at rest, after an acknowledgment.
  /// A program that was sent as a whole comes to rest at the end of a command, as soon as it can.
  void single_step(bool on) { stages_.single_step(on); }
  [[nodiscard]] bool single_step() const { return stages_.single_step(); }

  /// Present positions of the axes of the group.
  [[nodiscard]] Point places() const { return places_(); }
  /// Frame of the commands (command::SetCoordinateTransform).
  [[nodiscard]] const Frame& frame() const { return frame_; }

  /// True if so many commands wait to be planned that the caller must reject further ones.
  [[nodiscard]] bool full() const { return waiting_.size() >= most_waiting; }
  /// Number of commands that have not ended, with the present one. The commands of a program that was
  /// sent as a whole count only if they do not belong to the present motion.
  [[nodiscard]] std::size_t size(const Tick& group) const;
  /// The same number, in which the commands up to the next M word of such a program count as one.
  [[nodiscard]] std::size_t taken(const Tick& group) const;
  /// Number of the command that the group plays, from 1; nullopt: it plays no single command.
  [[nodiscard]] std::optional<std::int32_t> command(const Tick& group) const;
  /// The rest of a long program after the plan that the group plays.
  [[nodiscard]] WindowRest beyond(const Tick& group) const { return sent_.beyond(group); }

 private:
  static constexpr std::size_t most_waiting = 16;
  static constexpr std::int32_t first_passed = 64;

  /// The commands that the group plays.
  struct Playing {
    std::uint64_t movement = 0;
    PathCommands commands;
    std::shared_ptr<const GroupProgram> program;
    std::shared_ptr<const ExecutorGroup> group;  // group with the limits of the motion
    double origin = 0;  // position of the group at the start of the program
    bool fast = false;
    std::uint64_t finished = 0;  // motions of the group before this one ends
  };
  /// Ways to plan a new command together with the present ones, in the order in which they are
  /// tried: the next way is tried if a way fails.
  enum class Way : std::uint8_t {
    shorter,   // the program begins at a later command
    longer,    // the program begins where it began
    slower,    // and the present commands get no faster than they are planned
    stopping,  // the command begins at rest
    rest,      // the command begins a new motion
    after,     // the command follows the end of the present motion
  };
  struct Attempt {
    Way way = Way::rest;
    PathCommands commands;
    std::future<PlannedMotion> planned;
    std::shared_ptr<std::atomic<bool>> canceled;
    std::shared_ptr<const ExecutorGroup> group = {};
    std::optional<PlannedMotion> made = {};            // set: the planning has ended
    std::shared_ptr<const GroupProgram> program = {};  // set: the group has the step
    double origin = 0;
    bool fast = false;
    bool adds_stage = false;  // the commands are a new stage, not more of the last one
  };
  struct Waiting {
    ClientCommand command = {};
    Request request = {};
  };

  void drop_attempt();
  [[nodiscard]] std::optional<GroupStep> begin(const Tick& group);
  [[nodiscard]] std::optional<GroupStep> proceed(const Tick& group);
  [[nodiscard]] std::optional<GroupStep> set_frame(const ClientCommand& command, const Tick& group);
  [[nodiscard]] bool continues(const Tick& group) const;
  [[nodiscard]] bool takes_over(const Tick& group) const;
  [[nodiscard]] std::optional<GroupStep> joined(const Tick& group);
  [[nodiscard]] std::pair<Cause, std::string> invalid_target() const;
  [[nodiscard]] std::optional<GroupStep> fresh(const Tick& group);
  [[nodiscard]] std::optional<GroupStep> begin_stage(const Tick& group);
  [[nodiscard]] std::optional<GroupStep> play_stage(const Tick& group);
  void add_stage(const Tick& group, std::optional<Gate> gate);
  void stage_answered(bool accepted, std::uint64_t movement);
  [[nodiscard]] std::optional<GroupStep> follow(const Tick& group);
  [[nodiscard]] Point end_of(const Tick& group) const;
  void append(PathCommands& commands, const ExecutorGroup& group);
  void plan(Way way, PlanTask task, std::shared_ptr<const ExecutorGroup> group);
  void fail();
  group_step::Reply finish(Cause cause, const std::string& reason = {});
  [[nodiscard]] std::size_t unfinished(const Tick& group) const;
  [[nodiscard]] bool plays(const Tick& group) const;
  [[nodiscard]] std::int32_t current(const Tick& group) const;

  // Group with the limits of its next motion from rest; within the further limits of its axes, too.
  std::shared_ptr<const ExecutorGroup> group_, limited_;
  std::function<Point()> places_;
  ProgramOf program_of_;
  MotionPlanner planner_;
  GroupStages stages_;  // motions after the present one, which begin at rest
  SentMotion sent_;
  std::deque<Waiting> waiting_;  // the first one is being planned
  std::optional<Attempt> attempt_;
  Way next_way_ = Way::shorter;
  /// A program begins at a later command when the group has passed this many of its commands. It
  /// then keeps half of them: the group must reach its present velocity again from rest.
  std::int32_t passed_ = first_passed;
  bool halting_ = false;
  bool releasing_ = false;
  std::optional<Playing> playing_;
  std::vector<command::GroupWait> idle_;  // waits before the first motion
  Frame frame_;                           // frame of the commands that follow
  PathLimits path_limits_;                // further limits of the commands that follow
  std::vector<AxisRates> axis_limits_;    // the same for the axes
  bool from_rest_ = false;                // the next command begins at rest
  double rate_ = 0;                       // rate in the tick before the newest one
  double rate_seen_ = 0;                  // value in the newest tick
  std::int64_t seen_ = -1;                // the newest tick
  std::uint64_t finished_ = 0;            // value in the newest tick
};

}  // namespace jounce
