// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/executor/command_queue.hpp"
#include "jounce/executor/cycle.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/executor/group_dynamics.hpp"
#include "jounce/executor/group_queue.hpp"
#include "jounce/executor/group_report.hpp"
#include "jounce/executor/last_start.hpp"
#include "jounce/executor/log.hpp"
#include "jounce/executor/made_movement.hpp"
#include "jounce/executor/movement_builder.hpp"
#include "jounce/executor/passed_m_words.hpp"
#include "jounce/executor/queues.hpp"
#include "jounce/executor/worker.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

/// The part of the communication thread that serves one axis. It passes the requests of streamers
/// to the axis and returns the answers, owns the movements of the axis, writes its tick log and
/// reports its status. If the log cannot be written, the log ends and the motion continues.
///
/// If a streamer arms a motion in a later session than the session of the fault, the fault is
/// reset. In the same session, the streamer must reset the fault by a command.
class AxisServer {
 public:
  /// All references must outlive the server. `axis`: index of the axis in the machine.
  /// `position_of`: present position of another axis of the machine, for a group. Throws InputError
  /// for invalid options, and std::system_error if the log cannot be created.
  AxisServer(ExecutorOptions options, Receiver& receiver, MachineExchange& exchange,
             std::size_t axis, Worker& worker,
             std::function<double(std::size_t axis)> position_of = {});

  /// Executes one iteration: processes the requests from the receiver, the answers of the axis, and
  /// its ticks.
  void turn();

  /// Stops the axis, as a stop by an operator does, and rejects every later arm.
  void retire();

  /// Processes all remaining items, and closes the log.
  void close();

  /// The newest tick of the axis.
  [[nodiscard]] const Tick& last() const { return last_; }
  /// True if the axis moves, or will move later without a further command (in_motion()).
  [[nodiscard]] bool moving() const { return in_motion(last_); }
  /// True if the axis is at rest and no command is in transit.
  [[nodiscard]] bool settled() const { return !moving() && !busy(); }
  /// True if a command is in transit: its answer arrives after one of the next cycles.
  [[nodiscard]] bool busy() const { return !commands_.idle(); }
  /// True if a streamer owns the axis in a session.
  [[nodiscard]] bool owned() const { return receiver_.session() != 0; }
  /// True if the log ended before the end of the run, because it could not be written.
  [[nodiscard]] bool log_truncated() const { return log_truncated_; }
  /// Number of motions that the axis ended as an axis of a group, which reports them.
  [[nodiscard]] std::uint64_t ended_with_group() const { return ended_with_group_; }
  /// The options of the axis.
  [[nodiscard]] const ExecutorOptions& options() const { return options_; }
  /// The status message of the axis.
  [[nodiscard]] wire::Status status() const;
  /// The place of a group on its path; nullopt for a single axis.
  [[nodiscard]] std::optional<wire::GroupStatus> group_status();
  /// Returns the output changes since the last call.
  [[nodiscard]] std::vector<wire::Event> take_events() { return std::exchange(events_, {}); }

 private:
  using Request = CommandQueue::Request;
  struct Kept {
    MadeMovement made;
    Sha256 hash{};
    double origin = 0;  // position of a group at the start of its program
    double shift = 0;   // path time of the program before at which this one begins, s
  };

  void handle(const TableReady& ready);
  void handle(const ArmRequested& arm);
  void handle(const StartRequested& start);
  void handle(const StopRequested& stop);
  void handle(const SessionEnded& ended);
  void handle(const CommandRequested& requested);
  void handle(const QueueArmRequested& arm);
  void handle(const QueueOpened& opened);
  void handle(const RowsArrived& arrived);
  template <class What>
  void obey(const What& what, const CommandRequested& requested, const Request& request);
  void obey(const command::GearIn& gear, const CommandRequested& requested, const Request& request);
  void obey(const command::GearInPos& gear, const CommandRequested& requested,
            const Request& request);
  void obey(const command::CombineAxes& gear, const CommandRequested& requested,
            const Request& request);
  void obey(const command::QueueSwitch& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::QueueClear& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::QueueEnd& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::StartTable& it, const CommandRequested& requested,
            const Request& request);
  void play_program(const CommandRequested& requested, const Request& request);
  void play(MadeMovement path, const Request& request, std::int64_t at);
  void follow_program(const Tick& tick);
  void pass_m_words(const Tick& tick);
  void turn_group();
  void take_step(const GroupQueue::Halt& halt);
  void take_step(const GroupQueue::Play& step);
  void take_step(const GroupQueue::Extend& step);
  void take_step(const GroupQueue::SetLimits& step);
  void take_step(const GroupQueue::Announce& step);
  void take_step(const GroupQueue::Note& step);
  void take_step(const GroupQueue::Reply& reply);
  void obey(const command::GroupAcknowledge& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::GroupSingleStep& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::Override& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::GroupSetOverride& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::GroupSetLimits& what, const CommandRequested& requested,
            const Request& request);
  void set_limits(const command::GroupSetLimits& what, const Request& request);
  void limit_group(bool from_rest);
  [[nodiscard]] double present_rate() const;
  [[nodiscard]] Cause reason() const;
  [[nodiscard]] double group_rate(const Kept& kept, double position) const;
  void set_rate(double rate, const std::optional<Request>& request = {}, std::int64_t at = -1);
  void couple(const CommandRequested& requested, const Request& request);
  void couple(MadeMovement made, std::int64_t at, const Request& request);
  void start_cuts(const CommandRequested& requested, const Request& request);
  [[nodiscard]] bool reject_at_tick(const CommandRequested& requested);
  void answer_queue(const Request& request, bool done);
  void decline(const CommandRequested& requested, Cause cause, const std::string& reason);
  bool reject_if_full(std::int64_t session, std::int32_t command);
  void refuse_crowd(std::int64_t session, std::int32_t command);
  [[nodiscard]] std::optional<Refusal> unfit(const ArmRequested& arm) const;
  void refuse_units(const ArmRequested& arm);
  [[nodiscard]] double next_rest() const;
  [[nodiscard]] ArmRequested on_axis(ArmRequested arm) const;
  void build(const ArmRequested& arm);
  void take_built();
  void arm(MovementBuilder::Built built);
  void arm(const Request& request, MadeMovement made, const Sha256& hash, std::int64_t group);
  void record(const MadeMovement& made);
  [[nodiscard]] Queues::Record recorded_rows() const;
  void clear_commands();
  void take_answers();
  bool answers_group(const CommandQueue::Reply& reply);
  void answer(const Request& request, const std::optional<Refusal>& refused);
  void take_ticks();
  void write(const Tick& tick);
  [[nodiscard]] std::uint8_t unwritten() const;
  [[nodiscard]] wire::GearState gear() const;
  void notify(const std::string& notice) const;

  ExecutorOptions options_;
  std::size_t axis_;
  Receiver& receiver_;
  AxisExchange& exchange_;
  CycleStatus& cycle_;
  std::optional<TickLog> log_;
  CommandQueue commands_;
  std::map<std::uint64_t, Kept> movements_;  // by the movement's id
  Queues queues_;
  std::vector<wire::Event> events_;
  std::int64_t event_count_ = 0;
  MovementBuilder builder_;
  std::optional<GroupQueue> group_queue_;  // single commands of a group
  std::optional<GroupDynamics> dynamics_;  // its override and further limits
  double rate_ = 1;                        // override factor that it has
  std::uint64_t group_movement_ = 0;       // id of its last movement
  GroupReport group_report_;
  PassedMWords m_words_;                        // M words of the program that the group plays
  std::shared_ptr<const GroupProgram> traced_;  // the last program whose path is in the trace
  std::uint64_t numbers_ = 0;                   // numbers of movements
  bool retired_ = false;
  bool log_truncated_ = false;
  std::uint64_t ended_with_group_ = 0;
  std::int64_t fault_session_ = 0;
  std::uint64_t armed_ = 0;  // id of the last armed movement
  LastStart start_;
  std::int64_t motion_session_ = 0;  // session of the last start
  std::int64_t held_session_ = 0;    // session of the last hold-to-run jog
  Tick last_;
};

}  // namespace jounce
