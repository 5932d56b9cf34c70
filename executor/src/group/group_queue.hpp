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
#include <variant>
#include <vector>

#include "jounce/axis/detail/path_commands.hpp"
#include "jounce/axis/detail/plan_agreement.hpp"
#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/executor/detail/worker.hpp"
#include "jounce/executor/executor_options.hpp"

#include "executor/src/group/group_dynamics.hpp"
#include "executor/src/server/command_queue.hpp"

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
///     while (const auto step = queue.next(tick)) ...    // often; the server executes the step
///     queue.answered(true, movement);                   // the group has accepted a Play or Extend
class GroupQueue {
 public:
  using Request = CommandQueue::Request;
  /// Returns the program of a movement of the group; null: none.
  using ProgramOf = std::function<std::shared_ptr<const GroupProgram>(std::uint64_t movement)>;
  /// Greatest number of commands that have not ended (the default of HIMC).
  static constexpr std::size_t most_commands = 512;

  /// The group must come to rest on its path and end its motion.
  struct Halt {};
  /// The group must play this program from its beginning. The queue waits for answered().
  struct Play {
    std::shared_ptr<const GroupProgram> program;
    Request request;
    std::string notice = {};  ///< text for the operator; empty: none
    /// true: its commands contain limits that are not those of limit()
    bool own_limits = false;
  };
  /// The group must continue its present path with this program. The queue waits for answered().
  struct Extend {
    std::shared_ptr<const GroupProgram> program;
    double position = 0;  ///< length along the path at which the program begins, u
    double shift = 0;     ///< time of the present program at which this one begins, s
    double until = 0;     ///< time of the present program up to which both are equal, s
    Request request;
  };
  /// The server must set these limits, call limit(), and answer the sender.
  struct SetLimits {
    command::GroupSetLimits limits;
    Request request;
    bool continues = false;  ///< true: the commands after it may continue the present motion
  };
  /// The group rests at an M word, or continues after it. The server must send an event.
  struct Announce {
    std::int32_t m_word = 0;
    bool waits = false;       ///< true: the group waits for the acknowledgment
    double timeout = 0;       ///< > 0: no acknowledgment arrived within this time, s
    std::size_t dropped = 0;  ///< commands that were dropped for this reason
  };
  /// The server must answer the sender: the command is accepted (Cause::none) or rejected.
  struct Reply {
    Request request;
    Cause cause = Cause::none;
    std::string reason = {};  ///< empty: the cause suffices
  };
  /// The server must show this text to the operator.
  struct Note {
    std::string text;
  };
  using Step = std::variant<Halt, Play, Extend, SetLimits, Announce, Note, Reply>;

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
  [[nodiscard]] std::optional<Step> next(const Tick& group);
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
  [[nodiscard]] Cause acknowledge(std::int32_t number);
  /// Number of the M word at which the group waits; nullopt: none.
  [[nodiscard]] std::optional<std::int32_t> m_word() const;
  /// True: each of the commands that follow begins at rest, after an acknowledgment.
  /// A program that was sent as a whole comes to rest at the end of a command, as soon as it can.
  void single_step(bool on) { single_step_ = on; }
  [[nodiscard]] bool single_step() const { return single_step_; }

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
  [[nodiscard]] WindowRest beyond(const Tick& group) const;

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
  struct Planned {
    std::shared_ptr<const GroupProgram> program = {};
    std::optional<Agreement> agreement = {};
    std::string reason = {};
    double from = 0;  // length along the present path at which the program may take over, u

    /// Extends the path of the group at `position`. Requires program and agreement.
    [[nodiscard]] Extend extension(double position, const Request& request) const {
      return {program, position, agreement->shift, agreement->until, request};
    }
  };
  /// A condition for the commands after it: an M word, or a single step.
  struct Gate {
    std::int32_t m_word = 0;
    double timeout = 0;  // s; 0: none
    bool is_step = false;
  };
  /// Commands of a program that was sent as a whole.
  struct SentPart {
    std::shared_ptr<const SentProgram> of;
    std::size_t stage = 0;  // index of the stage to which they belong
    std::size_t first = 0;  // the first one
    std::size_t last = 0;   // the command after the last one
  };
  /// The part of such a program that the group plays.
  struct PlayingSent {
    std::uint64_t movement = 0;
    std::shared_ptr<const GroupProgram> program;
    SentPart part;
    bool is_step =
        false;           // it cannot come to rest earlier, or it is the last command before a rest
    double origin = 0;   // position of the group at the start of the program
    bool rests = false;  // it cannot continue in the next window, and rests at its end
  };
  /// The next window of this part, which takes over where the group has passed half of the commands
  /// that both windows contain.
  struct Window {
    std::size_t first = 0;  // its first command
    std::size_t last = 0;   // the command after its last one
    std::future<Planned> planned;
    std::optional<Planned> made = {};
    std::shared_ptr<const GroupProgram> program = {};  // set: the group has the step
    double position = 0;  // place of the group at the start of its program
  };
  /// A shorter plan of this part, which ends earlier: for single step.
  struct Cut {
    std::size_t last = 0;  // the command after its last one
    std::future<Planned> planned;
    std::shared_ptr<const GroupProgram> program = {};  // set: the group has the step
    double position = 0;  // place of the group at the start of its program
  };
  /// Commands that begin at rest when the motion before them has ended, and their gate is open.
  struct Stage {
    PathCommands commands;
    std::shared_ptr<const GroupProgram> program;  // null: no command moves yet
    std::shared_ptr<const ExecutorGroup> group;
    /// Motions of the group before the motion before this stage ends; nullopt: it rests already.
    std::optional<std::uint64_t> finished = {};
    std::optional<Gate> gate = {};
    std::optional<SentPart> sent = {};  // set: `commands` has only the end of the stage
    std::size_t planned = 0;            // the command of `sent` after the last one of `program`
    [[nodiscard]] std::size_t size() const {
      return (sent ? sent->last - sent->first : commands.size()) + (gate ? 1 : 0);
    }
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
    std::future<Planned> planned;
    std::shared_ptr<std::atomic<bool>> canceled;
    std::shared_ptr<const ExecutorGroup> group = {};
    std::optional<Planned> made = {};                  // set: the planning has ended
    std::shared_ptr<const GroupProgram> program = {};  // set: the group has the step
    double origin = 0;
    bool fast = false;
    bool adds_stage = false;  // the commands are a new stage, not more of the last one
  };
  struct Waiting {
    ClientCommand command = {};
    Request request = {};
  };

  /// The input of planned(). `before` and `q`: the present program, and the place of the group on it.
  /// `fast`: the axes move from these positions, each in its shortest time.
  struct Task {
    PathCommands commands;
    std::shared_ptr<const GroupProgram> before = {};
    double q = 0;
    std::optional<Point> fast = {};
  };

  static Planned planned(const Task& task, const ExecutorGroup& group,
                         const std::atomic<bool>& canceled);
  void drop_attempt();
  [[nodiscard]] std::optional<Step> begin(const Tick& group);
  [[nodiscard]] std::optional<Step> proceed(const Tick& group);
  [[nodiscard]] std::optional<Step> set_frame(const ClientCommand& command, const Tick& group);
  [[nodiscard]] bool continues(const Tick& group) const;
  [[nodiscard]] bool takes_over(const Tick& group) const;
  [[nodiscard]] std::optional<Step> joined(const Tick& group);
  [[nodiscard]] std::pair<Cause, std::string> invalid_target() const;
  [[nodiscard]] std::optional<Step> fresh(const Tick& group);
  [[nodiscard]] std::optional<Step> begin_stage(const Tick& group);
  [[nodiscard]] std::optional<Step> pass_gate(const Tick& group);
  std::size_t drop_stages();
  void end_stage(std::optional<std::uint64_t> finished);
  void add_stage(const Tick& group, std::optional<Gate> gate);
  [[nodiscard]] Stage stage_of(SentPart part, std::optional<Gate> gate) const;
  [[nodiscard]] bool prepare();
  [[nodiscard]] bool divide(const SentPart& part);
  [[nodiscard]] std::optional<Step> cut(const Tick& group);
  [[nodiscard]] bool begin_cut(const Tick& group);
  void cut_answered(bool accepted, std::uint64_t movement);
  [[nodiscard]] bool has_rest() const;
  [[nodiscard]] std::optional<Step> next_window(const Tick& group);
  void begin_window();
  void window_answered(bool accepted, std::uint64_t movement);
  [[nodiscard]] static Planned planned_window(const SentPart& part, const GroupProgram& before,
                                              std::size_t known, const ExecutorGroup& group);
  [[nodiscard]] std::future<Planned> part_planned(const SentPart& part,
                                                  std::shared_ptr<const GroupProgram> before);
  [[nodiscard]] std::optional<Step> follow(const Tick& group);
  [[nodiscard]] Point end_of(const Tick& group) const;
  [[nodiscard]] PathCommands commands_from(const Point& place) const;
  void append(PathCommands& commands, const ExecutorGroup& group);
  [[nodiscard]] std::string text_of(const JogEnd& end) const;
  [[nodiscard]] std::future<Planned> begun(std::size_t commands, std::function<Planned()> work);
  void plan(Way way, Task task, std::shared_ptr<const ExecutorGroup> group);
  void fail();
  Reply finish(Cause cause, const std::string& reason = {});
  [[nodiscard]] bool plays(const Tick& group) const;
  [[nodiscard]] std::int32_t current(const Tick& group) const;

  std::shared_ptr<const ExecutorGroup>
      group_;                                  // group with the limits of its next motion from rest
  std::shared_ptr<const ExecutorGroup> base_;  // the group with its own limits only
  Worker& worker_;
  std::size_t most_at_once_;
  std::function<Point()> places_;
  ProgramOf program_of_;
  std::deque<Waiting> waiting_;  // the first one is being planned
  std::optional<Attempt> attempt_;
  Way next_way_ = Way::shorter;
  /// A program begins at a later command when the group has passed this many of its commands. It
  /// then keeps half of them: the group must reach its present velocity again from rest.
  std::int32_t passed_ = first_passed;
  bool halting_ = false;
  bool releasing_ = false;
  std::optional<Playing> playing_;
  std::deque<Stage> stages_;
  bool starts_stage_ = false;     // the group has the step that begins the first stage
  std::int64_t gate_since_ = -1;  // tick in which the group came to the gate; -1: it did not
  bool acknowledged_ = false;     // the gate is open
  bool unacknowledged_ = false;   // the last gate was not acknowledged in time
  bool single_step_ = false;
  std::optional<PlayingSent> sent_;
  std::optional<Cut> cut_;
  std::optional<Window> window_;
  std::size_t cut_skips_ =
      0;  // ends of commands that the next cut leaves out: it comes too late there
  std::future<Planned> preparing_;        // valid: the next part of a program is being planned
  std::size_t prepared_last_ = 0;         // the command after this part
  std::string dropped_because_;           // text for the operator; empty: none
  std::vector<command::GroupWait> idle_;  // waits before the first motion
  Frame frame_;                           // frame of the commands that follow
  /// `group_`, also within the further limits of its axes
  std::shared_ptr<const ExecutorGroup> limited_;
  PathLimits path_limits_;              // further limits of the commands that follow
  std::vector<AxisRates> axis_limits_;  // the same for the axes
  bool from_rest_ = false;              // the next command begins at rest
  double rate_ = 0;                     // rate in the tick before the newest one
  double rate_seen_ = 0;                // value in the newest tick
  std::int64_t seen_ = -1;              // the newest tick
  std::uint64_t finished_ = 0;          // value in the newest tick
};

}  // namespace jounce
